"""How right, and why so: each module is a script, `python -m experiments.query_test`; training recipes."""
