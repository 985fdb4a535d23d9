"""Clustered control variates over summed-area tables (zhu2024): a base term in O(1), and its residual."""
