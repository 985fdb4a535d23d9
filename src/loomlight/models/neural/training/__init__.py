"""How the universal network is trained: its data, its definition in torch, the recipe, and its export."""
