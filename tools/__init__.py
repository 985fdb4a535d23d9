"""Maintenance scripts: fuzzers and generators of shipped files."""
