"""Training of the universal network: its data, its definition in torch, the recipe, and its export."""
