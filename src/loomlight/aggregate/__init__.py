"""The truth over a footprint, on the plane z = 0: what every multi-scale model learns and is judged by."""
