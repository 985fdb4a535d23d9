"""How right models are: held-out fabrics, the query test, the image test, and the tables they fill."""
