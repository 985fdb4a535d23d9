"""Scale of threads: measured whatever some bad triangles say, and said where a mesh has no one scale."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

from loomlight.core.errors import LoomlightWarning
from loomlight.mesh.cloth_mesh import ClothMesh, at_one_scale, joined, uv_size, warn_of_extent, warn_of_scale


def panel(side: float, uv_side: tuple[float, float], at: float = 0.0, turned: bool = False) -> ClothMesh:
    """A flat square of 8 x 8 cells in metres, at x = `at`, over a rectangle of uv that starts at (at, 0)."""
    line = np.linspace(0, 1, 9)
    x, y = (values.ravel() for values in np.meshgrid(line, line))
    corner = (np.arange(8)[:, None] * 9 + np.arange(8)).ravel()
    lower, upper = [corner, corner + 1, corner + 10], [corner, corner + 10, corner + 9]
    uv = np.stack([y, -x] if turned else [x, y], axis=1) * uv_side + [at, 0]
    return ClothMesh(
        positions=np.stack([x * side + at, y * side, 0 * x], axis=1),
        normals=np.tile([0.0, 0.0, 1.0], (81, 1)),
        uv=uv,
        triangles=np.concatenate([np.stack(lower, axis=1), np.stack(upper, axis=1)]),
        name="panel.obj",
    )


def sliver(height: float) -> ClothMesh:
    """A triangle of 10 mm by 5 mm that is next to nothing in uv."""
    return ClothMesh(
        positions=np.array([[0, 0, 0], [0.01, 0, 0], [0, 0.005, 0]]),
        normals=np.tile([0.0, 0.0, 1.0], (3, 1)),
        uv=np.array([[0, 0], [1e-5, 0], [0, height]]),
        triangles=np.array([[0, 1, 2]]),
        name="sliver",
    )


@pytest.mark.parametrize("height", [0.0, 1e-9, 1e-5, 100.0])
def test_a_sliver_changes_nothing(height: float) -> None:
    mesh = joined([panel(0.2, (1, 0.5)), *[sliver(height)] * 3])
    np.testing.assert_allclose(uv_size(mesh), (200, 400), rtol=1e-9)


def test_the_larger_part_decides_where_triangles_are_few() -> None:
    """Two panels of 2 : 1 of the area."""
    mesh = joined([panel(0.2, (1, 1)), panel(0.2 / 2**0.5, (0.1, 0.1), at=2.0)])
    np.testing.assert_allclose(uv_size(mesh), (200, 200), rtol=1e-9)


def test_islands_of_one_scale_pass_in_silence() -> None:
    """Turned and mirrored islands as well, and a small one of any scale."""
    pieces = [
        panel(0.2, (1, 1)),
        panel(0.1, (0.45, 0.55), at=2.0, turned=True),
        panel(0.1, (-0.5, 0.5), at=4.0),
        panel(0.005, (1, 1), at=6.0),
    ]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warn_of_scale(joined(pieces))


def test_islands_that_disagree_are_said_with_the_factor() -> None:
    mesh = joined([panel(0.2, (1, 1)), panel(0.1, (2, 2), at=2.0)])
    with pytest.warns(LoomlightWarning, match="panel.obj: .*up to 4 times .* on 20 % of the cloth"):
        warn_of_scale(mesh)


def test_parts_of_other_scale_are_stretched_to_that_of_the_largest() -> None:
    parts = [panel(0.2, (1, 1)), panel(0.2, (4, 4), at=2.0), panel(0.21, (1, 1), at=4.0)]
    mesh = at_one_scale(parts)
    assert len(mesh.triangles) == 384
    first, second, third = np.split(mesh.uv, 3)
    # A part of nearly the same scale is left as it is, and the pattern runs on.
    np.testing.assert_array_equal(first, parts[0].uv)
    np.testing.assert_array_equal(third, parts[2].uv)
    np.testing.assert_allclose(np.ptp(second, axis=0), 0.2 / 0.21, rtol=1e-9)


@pytest.mark.parametrize(
    ("side", "unit", "says"),
    [
        (1000.0, 1.0, "is 1000 m by 1000 m, .*if it should be 1 m, give --metres-per-unit 0.001"),
        (60.0, 1.0, "if it should be 0.6 m, give --metres-per-unit 0.01"),
        (0.001, 0.001, "is 0.001 m by 0.001 m, .*if it should be 1 m, give --metres-per-unit 1"),
    ],
)
def test_a_cloth_of_no_size_of_cloth_is_said(side: float, unit: float, says: str) -> None:
    with pytest.warns(LoomlightWarning, match=says):
        warn_of_extent(panel(side, (1, 1)), unit)
