"""The paper's experiments, repeated with our service and with the paper's design on one machine."""
