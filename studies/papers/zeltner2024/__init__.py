"""Zeltner et al. 2024, "Real-Time Neural Appearance Models"."""
