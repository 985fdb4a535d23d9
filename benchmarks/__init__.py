"""How fast, and against which bars: each module is a script, `python -m benchmarks.point`."""
