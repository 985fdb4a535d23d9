"""Makes a frame of the real-time renderer: two fabrics on two meshes, lit by the example room.

python -m tools.generate.frame_picture OUTPUT
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from loomlight.core.images import write_pixels
from loomlight.fabric import load_fabric
from loomlight.mitsuba import shapes
from loomlight.realtime import Camera, Cloth, DirectionalLight, Environment, Mesh, Renderer

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
SIZE, PASSES = (768, 384), 4
# Metres: where the second piece lies, to the right of the first.
_BESIDE = np.array([0.52, 0.0, 0.0])


def main(output: str) -> None:
    """Renders and writes the frame."""
    drape = shapes.drape()
    pieces = []
    for name, shift in (("wool-houndstooth", 0 * _BESIDE), ("silk-satin", _BESIDE)):
        mesh = Mesh(drape.positions + shift, drape.normals, drape.uv, drape.triangles.astype(np.uint32))
        pieces.append(Cloth(mesh, load_fabric(EXAMPLES / f"{name}.toml"), uv_size_mm=(500.0, 500.0)))
    points = np.concatenate([piece.mesh.positions for piece in pieces])
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    camera = Camera(origin=(middle[0], middle[1] + 0.3, middle[2] + 1.15), target=tuple(middle))
    sky = Environment.read(EXAMPLES / "room.exr")
    sun = DirectionalLight(towards=(-0.6, 0.8, 0.5), irradiance=(1.5, 1.45, 1.35))
    picture = Renderer(pieces, size=SIZE).render(camera, [sun], environment=sky, passes=PASSES)
    write_pixels(output, picture.srgb[..., :3])


if __name__ == "__main__":
    main(sys.argv[1])
