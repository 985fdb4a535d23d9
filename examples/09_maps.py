"""Maps: the yarns of one repeat as textures for a game engine."""

from pathlib import Path

import loomlight

maps = loomlight.bake_maps(Path(__file__).parent / "tweed.toml", pixels_per_mm=40)  # square texels
low, high = maps.height_range
print(f"heights run from {low:.3f} to {high:.3f} mm; normals are {maps.normal.shape}")
loomlight.save(maps, "tweed.png")  # a picture a map; or "tweed.exr", one file of all
