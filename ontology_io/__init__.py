"""Knowledge in and out: files and ontologies."""
