"""What the pages of topics and sentences show, worked out from few rows by the engine itself."""
