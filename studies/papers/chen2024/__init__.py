"""Chen, Wang and Wang 2024, "Real-time Neural Woven Fabric Rendering"."""
