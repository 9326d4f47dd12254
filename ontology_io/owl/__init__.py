"""The ontology as OWL 2: the vocabulary, a streaming writer, a reader that trusts nothing."""
