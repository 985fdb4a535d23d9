"""Real time: a frame on the graphics adapter, without a window. Needs loomlight[realtime]."""

from pathlib import Path

import loomlight
from loomlight.realtime import Camera, Cloth, DirectionalLight, Renderer, rectangle

fabric = loomlight.load(Path(__file__).parent / "denim.toml")
cloth = Cloth(rectangle(0.1, 0.1), fabric)  # 10 cm square
renderer = Renderer([cloth], size=(128, 128), model="point")
camera, sun = Camera(origin=(0, -0.02, 0.03)), DirectionalLight(towards=(0.5, 0.3, 0.8))
loomlight.save(renderer.render(camera, [sun]).srgb[..., :3], "frame.png")

# Tables are written anew; no shader is compiled again.
renderer.set_fabric(0, loomlight.load("twill 2/2"))
loomlight.save(renderer.render(camera, [sun]).srgb[..., :3], "frame-twill.png")
