"""How faithful and how fast models are: metrics, side-by-side comparisons, the papers' evidence."""
