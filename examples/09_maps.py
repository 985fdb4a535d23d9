"""Maps: the yarns of one repeat as textures for a game engine."""

from pathlib import Path

from drjit.llvm import Float

import loomlight
from loomlight.fabric.maps import bake_maps, resolution_of, write_maps

fabric = loomlight.load(Path(__file__).parent / "tweed.toml")
# Square texels, 40 to the millimetre.
maps = bake_maps(fabric, resolution_of(fabric.repeat_mm, per_mm=40), Float)
low, high = maps.height_range
print(f"heights run from {low:.3f} to {high:.3f} mm")
for file in write_maps(maps, "tweed.png"):  # or "tweed.exr", one file of all
    print(file)
