"""Makes `examples/cushion.obj` and `examples/room.exr`, which the documentation clothes and lights by.

python -m examples.makers.cushion_and_room
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from loomlight.core.files import replacing
from loomlight.core.images import write_image

EXAMPLES = Path(__file__).resolve().parents[1]
# Metres: the sides of the cushion and half its greatest thickness. Quads along a side.
SIDE, BULGE, QUADS = 0.4, 0.09, 20
# Pixels of the room.
SIZE = (256, 128)


def cushion_obj() -> str:
    """A cushion of two square cloths, metres; one unit of u and of v is one side of 400 mm."""
    steps = np.linspace(-1, 1, QUADS + 1)
    x, y = (grid.ravel() for grid in np.meshgrid(steps, steps))
    # Between the corners the rim is drawn in where the filling lifts the middle.
    fullness = (1 - x**2) * (1 - y**2)
    inward = 1 - 0.08 * ((1 - x**2) * y**2 + (1 - y**2) * x**2)
    lines = [
        "# A cushion of 0.4 m, by examples/makers/cushion_and_room.py; one unit of u and of v is 400 mm."
    ]
    quad = np.array([0, 1, QUADS + 2, QUADS + 1])
    corners = (np.arange(QUADS)[:, None] * (QUADS + 1) + np.arange(QUADS)).ravel()
    for number, side in enumerate((1.0, -1.0)):
        z = side * BULGE * np.sqrt(fullness)
        place = np.stack([SIDE / 2 * x * inward, SIDE / 2 * y * inward, z], axis=1)
        u = (x if side > 0 else -x) / 2 + 0.5
        lines += [f"v {a:.5f} {b:.5f} {c:.5f}" for a, b, c in place]
        lines += [f"vt {a:.5f} {b:.5f}" for a, b in zip(u, y / 2 + 0.5, strict=True)]
        faces = corners[:, None] + (quad if side > 0 else quad[::-1]) + 1 + number * (QUADS + 1) ** 2
        lines += ["f " + " ".join(f"{index}/{index}" for index in face) for face in faces]
    return "\n".join(lines) + "\n"


def room() -> NDArray[np.float32]:
    """Radiance of a room [height, width, 3], latitude by longitude: walls, a floor, two windows."""
    width, height = SIZE
    azimuth = (np.arange(width) + 0.5) / width * 360
    elevation = (90 - (np.arange(height) + 0.5) / height * 180)[:, None]
    picture = np.empty((height, width, 3), np.float32)
    picture[:] = (0.32, 0.31, 0.3)
    picture[np.broadcast_to(elevation > 50, (height, width))] = (0.55, 0.55, 0.54)
    picture[np.broadcast_to(elevation < -35, (height, width))] = (0.16, 0.11, 0.07)
    for middle, radiance in ((60, (9.0, 9.6, 10.5)), (210, (4.5, 4.8, 5.2))):
        picture[(np.abs(azimuth - middle) < 18) & (elevation > 0) & (elevation < 38)] = radiance
    return picture


def main() -> None:
    """Writes both files."""
    with replacing(EXAMPLES / "cushion.obj") as temporary:
        temporary.write_text(cushion_obj())
    write_image(EXAMPLES / "room.exr", room())


if __name__ == "__main__":
    main()
