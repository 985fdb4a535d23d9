"""uv in millimetres of the draft, on islands that are mirrored and on those that are not; tangents."""

from __future__ import annotations

import numpy as np
import pytest

from loomlight.mesh.cloth_mesh import ClothMesh, metric
from loomlight.mesh.draft_uv import tangents, with_draft_uv

# Two squares of 100 mm side by side, seen from +z, whose uv are those of one, mirrored at their common edge.
POSITIONS = 0.1 * np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0], [1, 1, 0], [2, 1, 0]], float)
UV = np.array([[0, 1], [1, 1], [0, 1], [0, 0], [1, 0], [0, 0]], float)
TRIANGLES = np.array([[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4]])


def folded(uv: np.ndarray = UV) -> ClothMesh:
    return ClothMesh(POSITIONS, np.tile([0.0, 0, 1], (6, 1)), uv, TRIANGLES, "folded")


def test_the_weave_leans_alike_on_both_sides_of_a_mirror() -> None:
    made = with_draft_uv(folded(), (100, 100))
    area, dp_dx, dp_dy = metric(made)
    assert np.isfinite(area).all()
    assert np.cross(dp_dx, dp_dy)[:, 2] == pytest.approx([1e-6] * 4)
    # Upright on the left; on the right x runs to the left, and so y down, a half turn.
    assert dp_dx == pytest.approx(np.array([[1e-3, 0, 0]] * 2 + [[-1e-3, 0, 0]] * 2))
    assert dp_dy == pytest.approx(np.array([[0, 1e-3, 0]] * 2 + [[0, -1e-3, 0]] * 2))


def test_vertices_on_the_mirror_are_doubled_and_no_others() -> None:
    made = with_draft_uv(folded(), (100, 100))
    assert len(made.positions) == 8
    assert made.positions[made.triangles] == pytest.approx(POSITIONS[TRIANGLES])
    upright = np.where(np.arange(6)[:, None] % 3 == 2, [2, 0], [0, 0]) + UV * [1, 1]
    assert len(with_draft_uv(folded(upright), (100, 100)).positions) == 6


def test_millimetres_are_those_of_each_axis() -> None:
    made = with_draft_uv(folded(), (100, 30))
    assert np.ptp(made.uv, axis=0) == pytest.approx([100, 30])


def test_tangents_run_along_x_across_the_normal() -> None:
    made = with_draft_uv(folded(), (100, 100))
    tilted = np.array([0.6, 0, 0.8])
    along = tangents(ClothMesh(made.positions, np.tile(tilted, (8, 1)), made.uv, made.triangles, ""))
    assert np.linalg.norm(along, axis=1) == pytest.approx(np.ones(8))
    assert along @ tilted == pytest.approx(np.zeros(8), abs=1e-12)
    assert along[0] == pytest.approx([0.8, 0, -0.6])
    assert along[2] == pytest.approx([-0.8, 0, 0.6])


def test_where_uv_collapse_some_tangent_is_there() -> None:
    made = folded(np.zeros((6, 2)))
    along = tangents(with_draft_uv(made, (100, 100)))
    assert np.linalg.norm(along, axis=1) == pytest.approx(np.ones(6))
    assert along[:, 2] == pytest.approx(np.zeros(6))
