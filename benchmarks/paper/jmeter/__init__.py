"""The same requests from Apache JMeter, the paper's tool, as a cross-check."""
