"""Training of `neumip` from queries of its source; the only part of the model that needs torch."""
