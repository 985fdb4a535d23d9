"""Figures and tables of papers, made again: a folder a paper, `python -m papers` lists them."""
