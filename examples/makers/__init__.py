"""Makers of the examples' files, each run as `python -m examples.makers.NAME` in a checkout."""
