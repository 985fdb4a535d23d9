"""Kuznetsov et al. 2021, "NeuMIP: Multi-Resolution Neural Materials"."""
