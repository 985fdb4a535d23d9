"""Cloth that is cut for meshes without uv: true scale, straight grain, few pieces, nothing lost.

Covers: mesh/unwrap.py, mesh/cutting.py, mesh/flattening.py, mesh/surface.py, mesh/coarse.py
"""

from __future__ import annotations

import os
import warnings
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.mesh.cloth_mesh import ClothMesh, MeshPart, cross_products, metric
from loomlight.mesh.reading import read_parts
from loomlight.mesh.unwrap import CutPieces, cut_pieces, with_uv
from studies.instruments.garment_shapes import SHAPES, as_part, ball, cushion, refined, scan, skirt

DATA = os.environ.get("LOOMLIGHT_DATA")
needs_data = pytest.mark.skipif(DATA is None, reason="LOOMLIGHT_DATA does not name the folder of meshes")


def shirt() -> MeshPart:
    pytest.importorskip("pxr")
    return read_parts(Path(DATA or "") / "meshes" / "unisex_shirt.usd")[0]


def surface_area(mesh: ClothMesh) -> float:
    return float(np.linalg.norm(cross_products(mesh), axis=1).sum() / 2)


def flat_area(mesh: ClothMesh) -> float:
    """The area of a mesh's uv, of which what is folded over counts against the rest."""
    a, b, c = (mesh.uv[mesh.triangles[:, corner]] for corner in range(3))
    (u1, v1), (u2, v2) = (b - a).T, (c - a).T
    # v runs down.
    return float(np.sum(v1 * u2 - u1 * v2) / 2)


@pytest.mark.parametrize("name", SHAPES)
def test_pieces_are_at_true_scale_and_hold_the_whole_surface(name: str) -> None:
    part = SHAPES[name](1500)
    found = cut_pieces([part])
    pieces = with_uv([part], found)
    # Triangles on the way of a seam are split.
    whole = sum(surface_area(piece.mesh) for piece in pieces)
    assert whole == pytest.approx(surface_area(part.mesh), rel=1e-9)
    for piece in pieces:
        # Each piece is scaled to its own area: what is left is rounding, and what is folded over.
        assert flat_area(piece.mesh) == pytest.approx(surface_area(piece.mesh), rel=0.01)


@pytest.mark.parametrize(
    ("name", "pieces", "median", "worst", "angle"),
    [
        ("skirt", 2, 1.02, 1.10, 14),
        ("trousers", 2, 1.03, 1.40, 6),
        ("hood", 4, 1.06, 1.35, 8),
        ("cushion", 2, 1.04, 1.15, 4),
        ("scan", 3, 1.06, 1.40, 5),
    ],
)
def test_few_pieces_are_hardly_stretched_and_lie_on_the_grain(
    name: str, pieces: int, median: float, worst: float, angle: float
) -> None:
    # Limits are some half above what each shape comes to; a seam less or a turn of 10 degrees exceeds them.
    found = cut_pieces([SHAPES[name](2000)])
    assert found.count <= pieces
    assert found.stretch < median
    assert found.worst < worst
    assert found.angle < angle


def test_the_grain_is_measured_on_the_mesh() -> None:
    """The warp runs up a skirt: derivatives of v, from the mesh alone."""
    part = skirt(2000)
    for piece in with_uv([part], cut_pieces([part])):
        area, _, dp_dv = metric(piece.mesh)
        upward = -dp_dv / np.linalg.norm(dp_dv, axis=1, keepdims=True)
        assert np.average(upward[:, 1], weights=np.nan_to_num(area)) > 0.85
        assert np.average(np.linalg.norm(dp_dv, axis=1), weights=area) == pytest.approx(1, abs=0.03)


def test_the_same_mesh_is_cut_the_same() -> None:
    one, other = cut_pieces([scan(1500)]), cut_pieces([scan(1500)])
    np.testing.assert_array_equal(one.uv, other.uv)
    np.testing.assert_array_equal(one.corners, other.corners)


def test_a_ball_is_cut_until_it_lies_flat() -> None:
    found = cut_pieces([ball(1500)])
    assert 3 <= found.count <= 16
    assert found.worst < 1.4
    assert np.isfinite(found.worst)


def test_attributes_go_with_doubled_vertices() -> None:
    part = cushion(1000)
    row = np.arange(len(part.mesh.positions), dtype=float)[:, None]
    part = replace(part, mesh=replace(part.mesh, attributes={"row": row}))
    pieces = with_uv([part], cut_pieces([part]))
    rows = np.concatenate([piece.mesh.attributes["row"][:, 0] for piece in pieces]).astype(int)
    positions = np.concatenate([piece.mesh.positions for piece in pieces])
    assert len(rows) > len(row)
    np.testing.assert_array_equal(positions, part.mesh.positions[rows])
    assert set(rows) == set(range(len(row)))


def test_turned_and_refined_meshes_are_cut_alike() -> None:
    part = skirt(1000)
    finer = replace(part, mesh=refined(refined(part.mesh)))
    assert len(finer.mesh.triangles) == 16 * len(part.mesh.triangles)
    one, other = cut_pieces([part]), cut_pieces([finer])
    assert one.count == other.count
    assert one.names == other.names
    assert other.worst < 1.15


def test_a_garment_that_lies_on_its_back_is_cut_as_one_that_stands() -> None:
    part = skirt(1000)
    down = part.mesh.positions[:, [0, 2, 1]] * [1, -1, 1]
    one, other = (cut_pieces([as_part(p, part.mesh.triangles, "")]) for p in (part.mesh.positions, down))
    assert other.names == one.names
    np.testing.assert_allclose(other.uv, one.uv, atol=1e-6)


def test_panels_that_share_no_vertices_stay_pieces() -> None:
    """A strip that would lie flat as one, of two panels that meet; a soup of it is one piece."""
    panel = sheet(0.0).mesh
    places = np.concatenate([panel.positions, panel.positions + np.array([0.2, 0, 0])])
    faces = np.concatenate([panel.triangles, panel.triangles + len(panel.positions)])
    assert cut_pieces([as_part(places, faces, "panels")]).count == 2
    soup = as_part(places[faces].reshape(-1, 3), np.arange(3 * len(faces)).reshape(-1, 3), "soup")
    assert cut_pieces([soup]).count == 1


@needs_data
@pytest.mark.parametrize(
    "times", [0, pytest.param(1, marks=pytest.mark.slow), pytest.param(2, marks=pytest.mark.slow)]
)
def test_a_shirt_is_cut_as_shirts_are(times: int) -> None:
    part = shirt()
    for _ in range(times):
        part = replace(part, mesh=refined(part.mesh))
    found = cut_pieces([part])
    assert sorted(found.names) == ["back", "front", "left sleeve", "right sleeve"]
    assert found.stretch < 1.02
    assert found.worst < 1.15
    assert found.angle < 4
    for piece in with_uv([part], found):
        area, _, dp_dv = metric(piece.mesh)
        along = np.average(-dp_dv, axis=0, weights=np.nan_to_num(area))
        # Sleeves hang, and their warp goes up to the shoulder: away from the middle below, towards it above.
        if "sleeve" in piece.piece:
            side = np.sign(piece.mesh.positions[:, 0].mean())
            assert 20 < np.degrees(np.arctan2(-side * along[0], along[1])) < 60
        else:
            assert abs(along[0]) < 0.05
        assert flat_area(piece.mesh) == pytest.approx(surface_area(piece.mesh), rel=0.01)


def sheet(at: float, side: float = 0.2) -> MeshPart:
    """A square of 200 triangles at a height."""
    x, y = np.meshgrid(np.linspace(0, side, 11), np.linspace(0, side, 11), indexing="xy")
    places = np.stack([x, y, np.full_like(x, at)], axis=2).reshape(-1, 3)
    ids = np.arange(121).reshape(11, 11)
    a, b, c, d = ids[:-1, :-1], ids[:-1, 1:], ids[1:, :-1], ids[1:, 1:]
    faces = [np.stack(face, axis=2).reshape(-1, 3) for face in ((a, b, d), (a, d, c))]
    return as_part(places, np.concatenate(faces), "sheet")


def test_what_lies_flat_is_not_stretched() -> None:
    part = sheet(0.0)
    (piece,) = with_uv([part], cut_pieces([part]))
    mesh = piece.mesh
    # Distances between all vertices are kept, to the tolerance of the solver.
    at = np.arange(0, len(mesh.uv), 7)
    flat, round_ = (np.linalg.norm(v[at, None] - v[None, at], axis=2) for v in (mesh.uv, mesh.positions))
    np.testing.assert_allclose(flat, round_, atol=2e-4)


def test_patterns_meet_at_seams_along_the_warp() -> None:
    part = skirt(1500)
    found = cut_pieces([part])
    front, back = with_uv([part], found)
    places = {tuple(place): uv[1] for place, uv in zip(front.mesh.positions, front.mesh.uv, strict=True)}
    gaps = [
        places[tuple(place)] - uv[1]
        for place, uv in zip(back.mesh.positions, back.mesh.uv, strict=True)
        if tuple(place) in places
    ]
    assert len(gaps) > 10
    # The seam runs up both sides; without matching, pieces begin at heights of their own.
    assert abs(np.mean(gaps)) < 5e-3
    assert np.std(gaps) < 0.015


def broken(kind: str) -> MeshPart:
    part = sheet(0.0)
    mesh = part.mesh
    if kind == "one triangle":
        return as_part(np.array([[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0.0]]), np.array([[0, 1, 2]]), kind)
    if kind == "isolated triangles":
        random = np.random.default_rng(3)
        places = (random.uniform(0, 1, (5_000, 1, 3)) + random.normal(0, 1e-3, (5_000, 3, 3))).reshape(-1, 3)
        return as_part(places, np.arange(15_000).reshape(-1, 3), kind)
    if kind == "three sheets along an edge":
        places = np.array([[0, 0, 0], [0, 1, 0], [1, 0, 0], [-1, 0, 0.5], [-1, 0, -0.5]], float)
        return as_part(places, np.array([[0, 1, 2], [0, 1, 3], [0, 1, 4]]), kind)
    if kind == "a Möbius strip":
        t = np.linspace(0, 2 * np.pi, 80, endpoint=False)
        across = np.array([-0.1, 0.1])
        angle = t[:, None]
        radius = 0.5 + across * np.cos(angle / 2)
        places = np.stack(
            [radius * np.cos(angle), radius * np.sin(angle), across * np.sin(angle / 2)], axis=2
        )
        ids = np.arange(160).reshape(80, 2)
        after = np.concatenate([ids[1:], ids[:1, ::-1]])
        faces = np.concatenate(
            [
                np.stack([ids[:, 0], ids[:, 1], after[:, 0]], 1),
                np.stack([ids[:, 1], after[:, 1], after[:, 0]], 1),
            ]
        )
        return as_part(places.reshape(-1, 3), faces, kind)
    assert kind == "twice the same"
    return as_part(mesh.positions, np.concatenate([mesh.triangles, mesh.triangles]), kind)


@pytest.mark.parametrize(
    "kind",
    ["one triangle", "isolated triangles", "three sheets along an edge", "a Möbius strip", "twice the same"],
)
def test_odd_meshes_are_cut_too(kind: str) -> None:
    part = broken(kind)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = cut_pieces([part])
        pieces = with_uv([part], found)
    # Triangles on the way of a seam are split.
    whole = sum(surface_area(piece.mesh) for piece in pieces)
    assert whole == pytest.approx(surface_area(part.mesh), rel=1e-9)
    assert all(np.isfinite(piece.mesh.uv).all() for piece in pieces)
    assert flat_area(pieces[0].mesh) == pytest.approx(surface_area(pieces[0].mesh), rel=0.02)
    assert np.ptp(found.uv, axis=0).max() < 100


def test_nothing_to_cut_is_said() -> None:
    empty = MeshPart(
        "", "", ClothMesh(*(np.zeros((0, k)) for k in (3, 3, 2)), np.zeros((0, 3), int), "none.obj")
    )
    with pytest.raises(InputError, match=r"none.obj holds no triangles that have an area\."):
        cut_pieces([empty])


def test_sentences_say_what_was_cut() -> None:
    found = CutPieces(
        np.zeros((0, 3), int), np.zeros((0, 2)), np.zeros(0, int), ["front", "back"], 2, 1.004, 1.12, 2.2
    )
    assert found.sentence("shirt.usd") == (
        "shirt.usd has no uv and is cut into 2 pieces (front, back): its cloth is stretched by 0.4 % "
        "(median) and 12 % at worst, and lies 2° off the grain (median)."
    )
    assert "far more than cloth is" in replace(found, worst=2.0).sentence("shirt.usd")


@pytest.mark.parametrize("seed", range(8))
def test_whatever_is_cut_keeps_its_area(seed: int) -> None:
    """Garments of which triangles are missing, turned over, or named at random."""
    random = np.random.default_rng(seed)
    mesh = list(SHAPES.values())[seed % len(SHAPES)](200).mesh
    triangles = mesh.triangles[random.random(len(mesh.triangles)) > 0.2].copy()
    turned = random.random(len(triangles)) < 0.2
    triangles[turned] = triangles[turned, ::-1]
    stray = random.random(len(triangles)) < 0.1
    triangles[stray] = random.integers(0, len(mesh.positions), (int(stray.sum()), 3))
    part = as_part(mesh.positions, triangles, "broken")
    pieces = with_uv([part], cut_pieces([part]))
    assert all(np.isfinite(piece.mesh.uv).all() for piece in pieces)
    assert sum(surface_area(piece.mesh) for piece in pieces) == pytest.approx(surface_area(part.mesh))
