"""Cloth meshes: what their files hold, checked, in parts, and how large they are in their own metric."""
