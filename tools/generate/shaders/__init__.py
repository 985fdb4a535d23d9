"""Shaders and constants that git keeps: what writes them."""
