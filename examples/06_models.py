"""Models: one fabric baked two ways, asked the same question, kept in a file."""

from pathlib import Path

from drjit.llvm import Array2f, Array3f

import loomlight
from loomlight.core.footprint import Box, box_footprint

fabric = loomlight.load(Path(__file__).parent / "denim.toml")
# Unit vectors that point away from the cloth, whose normal is z.
view, light = Array3f(0.3, 0.1, 0.95), Array3f(-0.4, 0.5, 0.77)
# A square of 2 mm, much larger than a yarn.
footprint = box_footprint(Box(Array2f(1, 1), Array2f(2, 2)))
# Prefiltered, and the mean of many points of the yarns.
for name, options in (("lobes", {}), ("samples", {"points": 4096})):
    model = loomlight.bake(fabric, name, **options)
    value = model.at(view, footprint).value(light)  # f·cos, linear RGB, 1/sr
    print(f"{name:8}", *(f"{channel[0]:.4f}" for channel in value))

loomlight.save(loomlight.bake(fabric, "lobes"), "denim.loom")
again = loomlight.load("denim.loom")  # the same numbers, bit for bit, without baking
