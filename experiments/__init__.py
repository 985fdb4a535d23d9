"""Measurements of accuracy, each a script (`python -m experiments.query_benchmark`), and training recipes."""
