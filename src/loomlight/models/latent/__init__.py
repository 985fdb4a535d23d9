"""Neural appearance with learned frames and an importance sampler (Zeltner et al. 2024)."""
