"""Seams of cut cloth: smooth lines, of the same surface, with uv that go on beyond."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from loomlight.mesh.cloth_mesh import BETWEEN, INDEX, ClothMesh, cross_products, vertex_normals
from loomlight.mesh.moving import moved
from loomlight.mesh.seams import Sheet, with_smooth_seams
from loomlight.mesh.surface import twins_of

SIDE = 25


def sheet(border: np.ndarray, bend: float = 0.0, seed: int = 1) -> Sheet:
    """A square of one metre of uneven triangles, whose pieces meet where `border` of their middles is 0.

    Args:
        border: [a, b, c] of a·x + b·y + c, of each of several lines.
    """
    rng = np.random.default_rng(seed)
    lines = np.linspace(0, 1, SIDE)
    x, y = (axis.ravel() for axis in np.meshgrid(lines, lines))
    inner = (x > 0) & (x < 1) & (y > 0) & (y < 1)
    step = 0.3 / SIDE
    x, y = (
        np.where(inner, axis + step * rng.standard_normal(len(axis)).clip(-1, 1), axis) for axis in (x, y)
    )
    corner = (np.arange(SIDE - 1)[:, None] * SIDE + np.arange(SIDE - 1)).ravel()
    triangles = np.concatenate(
        [
            np.stack([corner, corner + 1, corner + SIDE + 1], axis=1),
            np.stack([corner, corner + SIDE + 1, corner + SIDE], axis=1),
        ]
    )
    # Bent about the line x = 1/2, as a box is about its edge.
    positions = np.stack([np.minimum(x, 0.5), y, bend * np.maximum(x - 0.5, 0)], axis=1)
    if bend == 0:
        positions[:, 0] = x
    middles = np.stack([x, y], axis=1)[triangles].mean(axis=1)
    piece = np.sum([(np.c_[middles, np.ones(len(middles))] @ row > 0) for row in border], axis=0)
    mesh = ClothMesh(
        positions,
        vertex_normals(positions, triangles),
        np.zeros((0, 2)),
        triangles,
        "square",
        {INDEX: np.arange(len(positions))[:, None].astype(float)},
    )
    # The pieces lie flat apart from each other, each turned in its own way.
    flat = np.stack([x, y], axis=1)
    corners = np.zeros_like(triangles)
    uv = []
    for number in range(int(piece.max()) + 1):
        corners[piece == number] = triangles[piece == number] + len(flat) * number
        turn = np.array([[np.cos(number), -np.sin(number)], [np.sin(number), np.cos(number)]])
        uv.append(flat @ turn.T + [3.0 * number, 0])
    return Sheet(mesh, triangles, piece.astype(np.int64), corners, np.concatenate(uv))


def area(found: Sheet) -> np.ndarray:
    return np.linalg.norm(cross_products(replace(found.mesh, triangles=found.triangles)), axis=1) / 2


def open_length(found: Sheet) -> float:
    ends = found.mesh.positions[np.stack([found.triangles, np.roll(found.triangles, -1, axis=1)], axis=2)]
    alone = (twins_of(found.triangles) < 0).reshape(-1, 3)
    return float(np.linalg.norm(np.diff(ends, axis=2)[:, :, 0], axis=2)[alone].sum())


def seam_points(found: Sheet) -> np.ndarray:
    """Ends of edges between two pieces."""
    twins = twins_of(found.triangles)
    mine = np.repeat(found.piece, 3)
    (edge,) = np.nonzero((twins >= 0) & (mine != mine[twins]))
    return found.mesh.positions[found.triangles.ravel()[edge]]


LINE = np.array([[0.6, 1.0, -0.83]])


def test_a_seam_is_a_line_where_triangles_would_make_steps() -> None:
    before = sheet(LINE)
    after = with_smooth_seams(before)
    length = np.hypot(*LINE[0, :2])
    off = [(seam_points(each)[:, :2] @ LINE[0, :2] + LINE[0, 2]) / length for each in (before, after)]
    # Steps are as high as triangles, four hundredths; what is left are waves of a sixth of that.
    assert off[1].std() < 0.45 * off[0].std()
    assert np.abs(off[1]).max() < 1 / SIDE


@pytest.mark.parametrize("lines", [LINE, np.array([[0.6, 1.0, -0.83], [-1.0, 0.7, 0.1]])])
def test_the_surface_stays_whole(lines: np.ndarray) -> None:
    """The same area and the same open edges: both sides of an edge are split alike."""
    before = sheet(lines)
    after = with_smooth_seams(before)
    assert len(after.piece) > len(before.piece)
    assert area(after).sum() == pytest.approx(area(before).sum(), rel=1e-12)
    assert area(after).min() > 0
    assert open_length(after) == pytest.approx(open_length(before), rel=1e-12)
    assert (cross_products(replace(after.mesh, triangles=after.triangles))[:, 2] > 0).all()
    np.testing.assert_allclose(np.linalg.norm(after.mesh.normals, axis=1), 1)


@pytest.mark.parametrize("lines", [LINE, np.array([[0.6, 1.0, -0.83], [-1.0, 0.7, 0.1]])])
def test_uv_go_on_in_what_a_piece_is_given(lines: np.ndarray) -> None:
    """Of a flat sheet they are those that its pieces would have there."""
    after = with_smooth_seams(sheet(lines))
    where = after.mesh.positions[after.triangles][..., :2]
    for number in np.unique(after.piece):
        mine = after.piece == number
        turn = np.array([[np.cos(number), -np.sin(number)], [np.sin(number), np.cos(number)]])
        expected = where[mine] @ turn.T + [3.0 * number, 0]
        np.testing.assert_allclose(after.uv[after.corners[mine]], expected, atol=1e-12)


def test_a_seam_along_a_sharp_edge_stays_there() -> None:
    """Of a sheet bent by a right angle along a row of its vertices."""
    before = sheet(np.array([[1.0, 0, -0.5]]), bend=1.0)
    row = np.isclose(before.mesh.positions[:, 0], 0.5) & (before.mesh.positions[:, 2] < 0.02)
    positions = before.mesh.positions.copy()
    positions[row, 2] = 0
    after = with_smooth_seams(replace(before, mesh=replace(before.mesh, positions=positions)))
    np.testing.assert_array_equal(seam_points(after)[:, 2], 0)


def test_small_pieces_are_left_alone() -> None:
    before = sheet(LINE)
    assert with_smooth_seams(replace(before, piece=np.full(len(before.piece), -1))).mesh is before.mesh


def test_vertices_of_seams_move_with_the_rows_of_their_file() -> None:
    after = with_smooth_seams(sheet(LINE)).mesh
    rows = np.random.default_rng(2).standard_normal((SIDE * SIDE, 3))
    np.testing.assert_array_equal(moved(after, rows).positions[: len(rows)], rows)
    # What moves by one affine motion does so at new vertices too.
    turned = after.positions[: len(rows)] @ np.array([[0, -2, 0], [1, 0, 0.5], [0, 0, 1]]) + [1, 2, 3]
    expected = after.positions @ np.array([[0, -2, 0], [1, 0, 0.5], [0, 0, 1]]) + [1, 2, 3]
    assert np.isfinite(after.attributes[BETWEEN]).all(axis=1).sum() == len(after.positions) - len(rows)
    np.testing.assert_allclose(moved(after, turned).positions, expected, atol=1e-12)
