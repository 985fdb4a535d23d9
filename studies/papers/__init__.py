"""Figures and tables of papers, made again: a folder a paper, `python -m studies.papers` lists them."""
