"""A simulated towel that falls, held by two of its corners: a numbered OBJ file for each frame."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from studies.instruments.position_dynamics import Cloth, Grid, hold_together

# Metres, and vertices a metre.
WIDTH, LENGTH, DENSITY = 0.5, 0.8, 100
FRAMES_PER_SECOND, SUBSTEPS = 24, 60
# How far apart the two hands that hold it come, shares of its width, and in which time, seconds.
HANDS, HANDS_SECONDS = 0.62, 1.1
# Of the towel at first, degrees above the vertical.
LIFTED = 50.0
SEED = 7


def towel() -> Grid:
    """The towel lifted towards the viewer, its held edge the first row; y up, z towards the viewer."""
    rows, columns = round(LENGTH * DENSITY) + 1, round(WIDTH * DENSITY) + 1
    x, down = np.meshgrid(np.linspace(-WIDTH / 2, WIDTH / 2, columns), np.linspace(0, LENGTH, rows))
    angle = np.radians(LIFTED)
    # Of a millimetre or two, so that folds have somewhere to begin.
    waves = np.random.default_rng(SEED).uniform(-1, 1, (3, 2))
    ripple = sum(a * np.sin((number + 2) * np.pi * (x / WIDTH + b)) for number, (a, b) in enumerate(waves))
    y = 1.0 - down * np.cos(angle) + 1e-3 * ripple * np.sin(angle)
    return np.stack([x, y, down * np.sin(angle) + 1e-3 * ripple * np.cos(angle)], axis=2)


def frames(count: int) -> Iterator[Grid]:
    """Positions of `count` frames, the first one as the towel begins."""
    position = towel()
    velocity = np.zeros_like(position)
    held = position[0, [0, -1]].copy()
    cloth = Cloth(shear=2e-5, bend=6e-5, drag=1.0)
    step = 1 / (FRAMES_PER_SECOND * SUBSTEPS)
    for number in range(count):
        yield position.copy()
        for substep in range(SUBSTEPS):
            seconds = (number + (substep + 1) / SUBSTEPS) / FRAMES_PER_SECOND
            share = min(seconds / HANDS_SECONDS, 1.0)
            closer = 1 - (1 - HANDS) * share * share * (3 - 2 * share)
            velocity[..., 1] -= 9.81 * step
            velocity *= 1 - cloth.drag * step
            previous = position.copy()
            position += velocity * step
            position[0, [0, -1]] = held * [closer, 1, 1]
            hold_together(position, 1 / DENSITY, step, cloth)
            position[0, [0, -1]] = held * [closer, 1, 1]
            velocity = (position - previous) / step


def obj_text(position: Grid) -> str:
    """A frame as an OBJ file: quadrilaterals with uv in metres."""
    rows, columns, _ = position.shape
    lines = ["# A towel, by examples/makers/towel.py"]
    lines += [f"v {x:.5f} {y:.5f} {z:.5f}" for x, y, z in position.reshape(-1, 3)]
    lines += [
        f"vt {column / DENSITY:.3f} {LENGTH - row / DENSITY:.3f}"
        for row in range(rows)
        for column in range(columns)
    ]
    for row in range(rows - 1):
        for column in range(columns - 1):
            a = row * columns + column + 1
            lines.append("f " + " ".join(f"{n}/{n}" for n in (a, a + columns, a + columns + 1, a + 1)))
    return "\n".join(lines) + "\n"


def write(folder: Path, count: int) -> None:
    """Writes `count` frames as towel-0001.obj and so on."""
    folder.mkdir(exist_ok=True)
    for number, position in enumerate(frames(count), 1):
        (folder / f"towel-{number:04}.obj").write_text(obj_text(position))
