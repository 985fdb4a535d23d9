"""NeuMIP: neural textures and two small networks, trained for one source (Kuznetsov et al. 2021)."""
