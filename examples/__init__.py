"""Examples, with what made their files: `python -m examples.makers.corduroy`."""
