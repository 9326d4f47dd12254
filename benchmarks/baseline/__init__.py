"""The paper's design, written again from its text: what our figures are measured against."""
