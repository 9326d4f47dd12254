"""The ontology, out and in: how files are sent, how imports are started and told of."""
