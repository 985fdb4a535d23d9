"""Edges of cloth: hems and pinked borders as geometry."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from loomlight.mesh.cloth_mesh import ClothMesh, cross_products, metric
from loomlight.mesh.edges import Edges
from loomlight.mitsuba import shapes

WIDTH, THICKNESS = 6e-3, 5e-4


def square(cells: int, bend: float = 0.0, side: float = 0.1) -> ClothMesh:
    """A square cloth, flat or bent about an axis along x with the radius 1/`bend`, metres."""

    def place(u: NDArray[np.float64], v: NDArray[np.float64]) -> tuple[NDArray[np.float64], ...]:
        if not bend:
            return side * u, side * v, 0 * u
        angle = side * (v - 0.5) * bend
        return side * u, np.sin(angle) / bend, np.cos(angle) / bend

    return shapes.grid_surface(cells + 1, place, "square")


def edged(pieces: list[ClothMesh], kind: str, thickness: list[float]) -> list[ClothMesh]:
    return Edges.of(pieces, kind, thickness, 1.0).on(pieces)


def strip_of(mesh: ClothMesh, kind: str = "hem", thickness: float = THICKNESS) -> ClothMesh:
    """The triangles that an edge adds."""
    (found,) = edged([mesh], kind, [thickness])
    assert np.array_equal(found.triangles[: len(mesh.triangles)], mesh.triangles)
    assert np.array_equal(found.positions[: len(mesh.positions)], mesh.positions)
    return ClothMesh(
        found.positions, found.normals, found.uv, found.triangles[len(mesh.triangles) :], found.name
    )


def open_lengths(mesh: ClothMesh) -> dict[float, float]:
    """Length of edges of one triangle alone, by the height z at which they lie, to 0.1 µm."""
    rows = np.round(mesh.positions * 1e7).astype(int)
    _, place = np.unique(rows, axis=0, return_inverse=True)
    ends = np.stack([mesh.triangles, np.roll(mesh.triangles, -1, axis=1)], axis=2).reshape(-1, 2)
    ends = ends[place[ends[:, 0]] != place[ends[:, 1]]]
    _, number, count = np.unique(
        np.sort(place[ends], axis=1), axis=0, return_inverse=True, return_counts=True
    )
    alone = ends[count[number] == 1]
    found: dict[float, float] = {}
    for start, end in mesh.positions[alone]:
        height = round(float(start[2]), 7)
        found[height] = found.get(height, 0.0) + float(np.linalg.norm(end - start))
    return found


def turned_share(mesh: ClothMesh) -> float:
    """Share of the area whose normal and front disagree."""
    cross, normals = cross_products(mesh), mesh.normals[mesh.triangles].mean(axis=1)
    areas = np.linalg.norm(cross, axis=1)
    return float(areas[np.sum(cross * normals, axis=1) < 0].sum() / areas.sum())


@pytest.mark.parametrize("cells", [1, 30])
def test_a_hem_is_one_closed_strip(cells: int) -> None:
    """It begins at the cloth's edge, all around, and ends where it is sewn to the cloth from below."""
    (edge, begun), (height, length) = sorted(open_lengths(strip_of(square(cells))).items(), reverse=True)
    assert (edge, begun) == (0, pytest.approx(0.4, rel=1e-9))
    # The rows end at 1.9 π, sin(0.1 π) of the radius beyond the middle of the inner fold.
    inner = 0.1 - 2 * (WIDTH - THICKNESS + np.sin(0.1 * np.pi) * THICKNESS)
    # Along the mitres of corners it goes to and fro, as far as columns of 3 mm stand apart.
    assert length == pytest.approx(4 * inner, rel=0.1)
    assert -0.1 * THICKNESS < height < 0


def test_a_hem_is_as_wide_and_as_thick_as_it_says() -> None:
    strip = strip_of(square(10))
    used = strip.positions[np.unique(strip.triangles)]
    np.testing.assert_allclose(used.min(axis=0), [-THICKNESS, -THICKNESS, -2 * THICKNESS], atol=1e-9)
    np.testing.assert_allclose(used.max(axis=0), [0.1 + THICKNESS, 0.1 + THICKNESS, 0], atol=1e-9)
    inside = np.minimum(used[:, :2], 0.1 - used[:, :2]).min(axis=1).max()
    assert inside == pytest.approx(WIDTH, rel=1e-6)
    # Two half circles, the second one to 0.9 of it, and what lies flat between, along four mitred sides.
    # Chords of eight parts of a half circle are 0.7 % short, and slivers stand upright on the mitres: 2 %.
    middles = 4 * 0.1, 4 * (0.1 - 2 * (WIDTH - THICKNESS))
    flat = (WIDTH - THICKNESS) * sum(middles) / 2
    area = flat + np.pi * THICKNESS * (middles[0] + 0.9 * middles[1]) + 8 * 2 * THICKNESS**2
    assert np.linalg.norm(cross_products(strip), axis=1).sum() / 2 == pytest.approx(area, rel=0.03)


@pytest.mark.parametrize("bend", [0.0, 20.0, -20.0])
@pytest.mark.parametrize("kind", ["hem", "pinked"])
def test_normals_point_out_and_threads_keep_their_length(kind: str, bend: float) -> None:
    mesh = square(40, bend)
    strip = strip_of(mesh, kind)
    # On the mitres of corners slivers stand upright, hidden between the two layers.
    middle = strip.uv[strip.triangles].mean(axis=1)
    near = (np.minimum(middle, 1 - middle) < 0.1).all(axis=1)
    strip = replace(strip, triangles=strip.triangles[~near])
    assert turned_share(strip) == 0
    np.testing.assert_allclose(np.linalg.norm(strip.normals, axis=1), 1, atol=1e-9)
    area, dp_du, dp_dv = metric(strip)
    for along in (dp_du, dp_dv):
        stretch = np.linalg.norm(along, axis=1) / 0.1
        # Inside and outside of a bend of 50 mm a hem 1 mm thick is 2 % shorter or longer.
        known = np.isfinite(area)
        assert np.average(np.abs(stretch[known] - 1), weights=area[known]) < 0.03


def test_uv_run_on() -> None:
    """Around the fold the weave goes on from where it was, and away from the middle."""
    mesh = square(10)
    strip = strip_of(mesh)
    used = np.unique(strip.triangles)
    positions, uv = strip.positions[used], strip.uv[used]
    begins = positions[:, 2] == 0
    np.testing.assert_allclose(uv[begins], positions[begins, :2] / 0.1, atol=1e-9)
    # At the middle of the right edge, away from corners: the first fold's length, then as far as it lies in.
    below = (np.abs(positions[:, 1] - 0.05) < 0.02) & (np.abs(positions[:, 2] + 2 * THICKNESS) < 1e-9)
    below &= positions[:, 0] > 0.05
    expected = 0.1 + np.pi * THICKNESS + (0.1 - positions[below, 0])
    np.testing.assert_allclose(0.1 * uv[below, 0], expected, rtol=1e-3)
    np.testing.assert_allclose(0.1 * uv[below, 1], positions[below, 1], atol=1e-9)


def test_a_hem_follows_a_bent_cloth_below_it() -> None:
    """Cloth bent across its edge by a radius of 12 mm: straight strips would stick out of it."""
    mesh = square(60, bend=80.0, side=0.06)
    strip = strip_of(mesh)
    used = strip.positions[np.unique(strip.triangles)]
    depth = 1 / 80.0 - np.hypot(used[:, 1], used[:, 2])
    # Chords of 1 mm lie 0.01 mm below the arc.
    assert depth.max() < 2 * THICKNESS + 2e-5
    beside = used[(used[:, 0] > 0) & (used[:, 0] < 0.06)]
    depth = 1 / 80.0 - np.hypot(beside[:, 1], beside[:, 2])
    assert depth.min() > -2e-5


def test_teeth_stand_on_the_edge() -> None:
    strip = strip_of(square(1), "pinked")
    used = strip.positions[np.unique(strip.triangles)]
    assert set(np.round(used[:, 2], 9)) == {0.0}
    out = np.maximum(-used[:, :2], used[:, :2] - 0.1).max(axis=1)
    tips = used[out > 1e-6]
    np.testing.assert_allclose(out[out > 1e-6], 1.6e-3, rtol=1e-6)
    # Teeth of 3 mm or a little less, of which each is one triangle: 34 on a side.
    assert len(np.unique(np.round(tips, 7), axis=0)) == 4 * 34
    area = np.linalg.norm(cross_products(strip), axis=1).sum() / 2
    assert area == pytest.approx(4 * 0.1 * 1.6e-3 / 2, rel=1e-6)
    np.testing.assert_allclose(strip.uv[np.unique(strip.triangles)], used[:, :2] / 0.1, atol=1e-9)


@pytest.mark.slow
def test_seams_have_no_edge() -> None:
    """Of two pieces side by side, and of one that closes upon itself."""
    left = square(10)
    shifted = left.positions + np.array([0.1, 0, 0])
    right = ClothMesh(shifted, left.normals, left.uv, left.triangles, "right")
    pieces = edged([left, right], "hem", [THICKNESS, 2 * THICKNESS])
    for piece, old, x in zip(pieces, (left, right), (0.1, 0.1), strict=True):
        used = piece.positions[np.unique(piece.triangles[len(old.triangles) :])]
        middle = (used[:, 1] > 0.02) & (used[:, 1] < 0.08)
        assert np.abs(used[middle, 0] - x).min() > 0.1 - WIDTH - 1e-6
    assert pieces[1].positions[:, 2].min() == pytest.approx(-4 * THICKNESS)
    tube = strip_of(shapes.cylinder())
    used = tube.positions[np.unique(tube.triangles)]
    assert np.abs(used[:, 0]).min() == pytest.approx(0.06 - WIDTH, rel=1e-6)


def test_what_has_no_edge_stays() -> None:
    mesh = square(4)
    assert edged([mesh], "raw", [THICKNESS])[0] is mesh
    # A patch of 2 mm is no wider than a hem.
    small = square(4, side=2e-3)
    assert edged([small], "hem", [THICKNESS])[0] is small
    closed = square(1)
    double = ClothMesh(
        closed.positions,
        closed.normals,
        closed.uv,
        np.concatenate([closed.triangles, closed.triangles[:, ::-1]]),
        "bag",
    )
    assert len(edged([double], "hem", [THICKNESS])[0].triangles) == len(double.triangles)


def test_triangles_without_uv_have_no_edge() -> None:
    mesh = square(4)
    bare = ClothMesh(mesh.positions, mesh.normals, 0 * mesh.uv, mesh.triangles, "bare")
    (found,) = edged([bare], "hem", [THICKNESS])
    assert len(found.triangles) == len(bare.triangles)


def test_the_draped_cloth_has_a_hem() -> None:
    mesh = shapes.drape()
    strip = strip_of(mesh, thickness=8e-4)
    for rows in (strip.positions, strip.normals, strip.uv):
        assert np.isfinite(rows).all()
    # In the sharpest folds, whose radius is less than the hem's thickness, some triangles turn over, and
    # slivers on the mitres of corners.
    assert turned_share(strip) < 5e-3


@pytest.mark.parametrize("kind", ["hem", "pinked"])
def test_edges_follow_cloth_that_moves(kind: str) -> None:
    """Turned and carried away, the cloth takes its edge along; bent, it has the edge of the bent cloth."""
    flat, bent = square(30), square(30, bend=20.0)
    edges = Edges.of([flat], kind, [THICKNESS], 1.0)
    (before,) = edges.on([flat])
    turn = np.array([[0, 0, 1], [0.6, 0.8, 0], [-0.8, 0.6, 0]])
    there = replace(flat, positions=flat.positions @ turn.T + 3, normals=flat.normals @ turn.T)
    (after,) = edges.on([there])
    np.testing.assert_allclose(after.positions, before.positions @ turn.T + 3, atol=1e-12)
    np.testing.assert_allclose(after.normals, before.normals @ turn.T, atol=1e-9)
    np.testing.assert_array_equal(after.uv, before.uv)
    np.testing.assert_array_equal(after.triangles, before.triangles)
    (followed,), (own,) = edges.on([bent]), Edges.of([bent], kind, [THICKNESS], 1.0).on([bent])
    # Columns stand as far apart, and where the hem lies below the cloth is found in its uv: 2 % of its width.
    np.testing.assert_allclose(followed.positions, own.positions, atol=0.02 * WIDTH)
