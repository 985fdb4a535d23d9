"""Training of latent textures, networks and sampler; needs torch."""
