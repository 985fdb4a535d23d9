"""Studies: what the package is measured by, and figures and tables of papers made again."""
