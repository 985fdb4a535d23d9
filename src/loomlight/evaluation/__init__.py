"""Accuracy of models: held-out fabrics, the query and image benchmarks, and the tables they fill."""
