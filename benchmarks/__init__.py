"""Measurements of speed against targets: each module is a script, `python -m benchmarks.point`."""
