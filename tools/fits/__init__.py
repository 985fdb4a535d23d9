"""Fits of constants in the source, each with the data it is fitted to: `python -m tools.fits.sheen`."""
