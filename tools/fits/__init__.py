"""Fits of numbers that the code holds, each with what it was fitted to: `python -m tools.fits.sheen`."""
