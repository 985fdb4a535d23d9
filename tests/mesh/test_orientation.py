"""Parts that are inside out are named, and others are not."""

from __future__ import annotations

import warnings
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from loomlight.core.errors import LoomlightWarning
from loomlight.mesh.cloth_mesh import ClothMesh, MeshPart, vertex_normals, warn_of_inside_out


def part(name: str, positions: np.ndarray, triangles: np.ndarray, turned: bool = False) -> MeshPart:
    triangles = triangles[:, ::-1] if turned else triangles
    normals = vertex_normals(positions, triangles)
    mesh = ClothMesh(positions, normals, positions[:, :2], triangles, "coat.obj")
    return MeshPart(name, "", mesh)


def tube(
    name: str, turned: bool = False, radius: float = 0.2, low: float = 0.0, high: float = 1.0, x: float = 0.0
) -> MeshPart:
    """An open tube about the vertical, whose front is outside unless it is turned."""
    count, rows = 24, 9
    angle, height = np.meshgrid(np.arange(count) / count * 2 * np.pi, np.linspace(low, high, rows))
    positions = np.stack([x + radius * np.cos(angle), height, -radius * np.sin(angle)], axis=-1)
    row, column = (each.ravel() for each in np.meshgrid(np.arange(rows - 1), np.arange(count), indexing="ij"))
    a, b = row * count + column, row * count + (column + 1) % count
    triangles = np.concatenate([np.stack([a, b, b + count], 1), np.stack([a, b + count, a + count], 1)])
    return part(name, positions.reshape(-1, 3), triangles, turned)


def panel(name: str, turned: bool = False, x: float = 0.0) -> MeshPart:
    """A square of 1 m that faces +z, at x."""
    corners = np.array([[x, 0, 0], [x + 1, 0, 0], [x + 1, 1, 0], [x, 1, 0]], float)
    return part(name, corners, np.array([[0, 1, 2], [0, 2, 3]]), turned)


def ball(turned: bool) -> MeshPart:
    """A closed octahedron."""
    corners = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], float)
    faces = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]
    return part("", corners, np.array(faces), turned)


@pytest.mark.parametrize(
    ("parts", "named"),
    [
        # Apart from one another: by whether they face outward.
        ([tube("body"), tube("sleeve", True, 0.05, 0.6, 0.9, 0.4)], 'the part "sleeve" is inside out'),
        # Sewn together, flat: by the seams, whichever comes first.
        (
            [panel("left"), panel("middle", x=1.0), panel("right", True, 2.0)],
            'the part "right" is inside out',
        ),
        ([panel("left", True), panel("middle", x=1.0), panel("right", x=2.0)], 'the part "left" is inside'),
        ([tube("a"), tube("b", low=1, high=2), tube("c", True, low=2, high=2.5)], 'the part "c" is inside'),
        ([ball(True)], "the mesh is inside out"),
    ],
)
def test_parts_inside_out_are_named(parts: list[MeshPart], named: str) -> None:
    with pytest.warns(LoomlightWarning, match=named) as told:
        warn_of_inside_out(parts, Path("coat.obj"))
    assert len(told) == 1
    assert str(told[0].message).startswith("coat.obj: the ")


def test_triangles_against_their_normals_are_named() -> None:
    whole = tube("body")
    against = replace(whole, name="cuff", mesh=replace(whole.mesh, normals=-whole.mesh.normals))
    with pytest.warns(LoomlightWarning, match=r'the part "cuff" is inside out: .* wound against its normals'):
        warn_of_inside_out([tube("body", radius=0.5), against], "coat.obj")


@pytest.mark.parametrize(
    "parts",
    [
        [tube("body"), tube("sleeve", radius=0.05, low=0.6, high=0.9, x=0.4)],
        [tube("shell", radius=0.21, low=-0.01, high=1.01), tube("lining", True)],  # it faces the wearer
        [panel("left"), panel("right", x=1.0)],
        [panel("left"), panel("apart", True, 3.0)],  # flat, and sewn to nothing
        [tube("all", True)],  # a tent may be seen from within
        [ball(False)],
    ],
)
def test_parts_that_are_right_pass_in_silence(parts: list[MeshPart]) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warn_of_inside_out(parts, "coat.obj")
