"""Zhu et al. 2024, "A Realistic Multi-scale Surface-based Cloth Appearance Model"."""
