"""The universal network of chen2024: one small network for all woven fabrics at any footprint."""
