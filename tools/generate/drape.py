"""Drapes a 0.6 m square of cloth over a ball and writes src/loomlight/mitsuba/data/drape.ply.

Dynamics of `instruments/position_dynamics.py`, with contact and friction with the ball, the ground and the
cloth itself. The settled grid is resampled by a bicubic spline, which gives its normals as well, so that
close-ups show no facets. Run: python -m tools.generate.drape
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import RectBivariateSpline
from scipy.ndimage import gaussian_filter
from scipy.spatial import cKDTree

from studies.instruments.position_dynamics import Cloth, Grid, hold_together

OUTPUT = Path(__file__).resolve().parents[2] / "src/loomlight/mitsuba/data/drape.ply"
SIDE = 0.6  # metres
BALL_RADIUS = 0.115
BALL_HEIGHT = 0.115  # it lies on the ground
THICKNESS = 0.006  # of the cloth, for contact with itself
CLEARANCE = 0.002  # between the cloth and what it lies on
SEED = 4


def settle(grid: int, seconds: float, substeps: int, cloth: Cloth) -> Grid:
    """Positions [grid, grid, 3] of the cloth at rest, metres, z up."""
    position = _laid_flat(grid)
    velocity = np.zeros_like(position)
    step = 1 / 60 / substeps
    spacing = SIDE / (grid - 1)
    apart = np.empty((0, 2), dtype=np.intp)
    for count in range(int(seconds * 60 * substeps)):
        if count % 5 == 0:
            apart = _close_pairs(position, spacing)
        velocity[..., 2] -= 9.81 * step
        velocity *= max(0.0, 1 - cloth.drag * step)
        previous = position.copy()
        position += velocity * step
        hold_together(position, spacing, step, cloth)
        _keep_apart(position, apart)
        _rest_on_things(position, previous, cloth.friction)
        velocity = (position - previous) / step
        # Without a bound, a contact that is resolved in one step throws the cloth.
        speed = np.linalg.norm(velocity, axis=-1, keepdims=True)
        velocity *= np.minimum(1, 3.0 / np.maximum(speed, 1e-9))
    return position


def _laid_flat(grid: int) -> Grid:
    """The cloth above the ball, off centre and not quite flat, so that no fold mirrors another."""
    random = np.random.default_rng(SEED)
    line = np.linspace(-SIDE / 2, SIDE / 2, grid)
    x, y = np.meshgrid(line, line)
    bumps = gaussian_filter(random.standard_normal((grid, grid)), grid / 14)
    z = BALL_HEIGHT + BALL_RADIUS + 0.01 + 0.004 * bumps / np.abs(bumps).max()
    return np.stack([x + 0.012, y - 0.008, z], axis=-1)


def _close_pairs(position: Grid, spacing: float) -> NDArray[np.intp]:
    """Index pairs of vertices nearer than the thickness that are no neighbours in the flat cloth."""
    grid = position.shape[0]
    pairs = cKDTree(position.reshape(-1, 3)).query_pairs(THICKNESS * 1.2, output_type="ndarray")
    rows, columns = np.abs(np.diff(np.stack(np.divmod(pairs, grid)), axis=-1))[..., 0]
    far = np.hypot(rows, columns) * spacing > 2.5 * THICKNESS
    return pairs[far]


def _keep_apart(position: Grid, pairs: NDArray[np.intp]) -> None:
    if len(pairs) == 0:
        return
    points = position.reshape(-1, 3)
    offset = points[pairs[:, 1]] - points[pairs[:, 0]]
    length = np.linalg.norm(offset, axis=1, keepdims=True)
    push = 0.5 * offset * np.minimum(0, length - THICKNESS) / np.maximum(length, 1e-9)
    shift = np.zeros_like(points)
    touched = np.zeros(len(points))
    for column, sign in ((0, 1), (1, -1)):
        np.add.at(shift, pairs[:, column], sign * push)
        np.add.at(touched, pairs[:, column], 1)
    points += shift / np.maximum(touched, 1)[:, None]


def _rest_on_things(position: Grid, previous: Grid, friction: float) -> None:
    centre = np.array([0, 0, BALL_HEIGHT])
    out = position - centre
    distance = np.linalg.norm(out, axis=-1)
    _resolve(position, previous, out / distance[..., None], BALL_RADIUS + CLEARANCE - distance, friction)
    up = np.broadcast_to(np.array([0.0, 0.0, 1.0]), position.shape)
    _resolve(position, previous, up, CLEARANCE - position[..., 2], friction)


def _resolve(position: Grid, previous: Grid, normal: Grid, depth: Grid, friction: float) -> None:
    inside = depth > 0
    if not inside.any():
        return
    normal, depth = normal[inside], depth[inside][:, None]
    position[inside] += normal * depth
    moved = position[inside] - previous[inside]
    slide = moved - normal * np.sum(moved * normal, axis=-1, keepdims=True)
    length = np.linalg.norm(slide, axis=-1, keepdims=True)
    # Coulomb: the slip that a contact takes away is at most friction times its depth.
    position[inside] -= slide * np.minimum(1, friction * depth / np.maximum(length, 1e-12))


def resample(position: Grid, grid: int) -> tuple[Grid, Grid, Grid]:
    """Positions, unit normals [grid·grid, 3] and uv [grid·grid, 2] of a smooth surface through the cloth."""
    smooth = np.stack(
        [gaussian_filter(position[..., axis], 0.8, mode="reflect") for axis in range(3)], axis=-1
    )
    smooth = _keep_border(smooth, position)
    line = np.linspace(0, 1, position.shape[0])
    fine = np.linspace(0, 1, grid)
    splines = [RectBivariateSpline(line, line, smooth[..., axis]) for axis in range(3)]
    points = np.stack([spline(fine, fine) for spline in splines], axis=-1)
    dp_dv = np.stack([spline(fine, fine, dx=1) for spline in splines], axis=-1)
    dp_du = np.stack([spline(fine, fine, dy=1) for spline in splines], axis=-1)
    normals = np.cross(dp_du, dp_dv)
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    u, v = np.meshgrid(fine, fine)
    return points.reshape(-1, 3), normals.reshape(-1, 3), np.stack([u, v], axis=-1).reshape(-1, 2)


def _keep_border(smooth: Grid, position: Grid) -> Grid:
    """A filter shortens the cloth at its border: blend to the unfiltered cloth there."""
    grid = position.shape[0]
    inner = np.minimum(np.arange(grid), np.arange(grid)[::-1])
    weight = np.clip(np.minimum.outer(inner, inner) / 3, 0, 1)[..., None]
    return weight * smooth + (1 - weight) * position


def write_ply(path: Path, points: Grid, normals: Grid, uv: Grid, grid: int) -> None:
    """A binary PLY with the properties that Mitsuba reads, y up."""
    points, normals = points[:, [0, 2, 1]] * [1, 1, -1], normals[:, [0, 2, 1]] * [1, 1, -1]
    corner = (np.arange(grid - 1)[:, None] * grid + np.arange(grid - 1)).ravel()
    lower = np.stack([corner, corner + 1, corner + grid + 1], axis=1)
    upper = np.stack([corner, corner + grid + 1, corner + grid], axis=1)
    triangles = np.concatenate([lower, upper], axis=1).reshape(-1, 3)
    faces = np.empty(len(triangles), dtype=[("count", "u1"), ("index", "<i4", 3)])
    faces["count"], faces["index"] = 3, triangles
    names = ("x", "y", "z", "nx", "ny", "nz", "u", "v")
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(points)}"]
    header += [f"property float {name}" for name in names]
    header += [f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header", ""]
    vertices = np.concatenate([points, normals, uv], axis=1).astype("<f4")
    path.parent.mkdir(exist_ok=True)
    path.write_bytes("\n".join(header).encode() + vertices.tobytes() + faces.tobytes())


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("-o", "--output", type=Path, default=OUTPUT)
    parser.add_argument("--grid", type=int, default=110, help="vertices a side in the simulation")
    parser.add_argument("--seconds", type=float, default=4.0, help="simulated time")
    parser.add_argument("--substeps", type=int, default=24, help="steps a sixtieth of a second")
    options = parser.parse_args()
    settled = settle(options.grid, options.seconds, options.substeps, Cloth())
    write_ply(options.output, *resample(settled, 200), grid=200)


if __name__ == "__main__":
    main()
