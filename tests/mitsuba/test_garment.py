"""Garments: cloths by parts and materials, each at its own scale; what has no uv stays uncovered.

Covers: mitsuba/meshes.py, mesh/clothing.py
"""

from __future__ import annotations

import os
import warnings
from pathlib import Path

import mitsuba as mi
import numpy as np
import pytest

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.mesh.cloth_mesh import metric, uv_size
from loomlight.mesh.clothing import read_garment
from loomlight.mesh.edges import Edges
from loomlight.mesh.writing import write_mesh
from loomlight.mitsuba import build_scene
from loomlight.mitsuba.pictures import Turntable
from studies.instruments.garment_shapes import skirt
from tests.helpers.meshes import coat

DATA = os.environ.get("LOOMLIGHT_DATA")


@pytest.mark.filterwarnings("ignore:.*stay uncovered")
def test_parts_are_clothed_by_their_names_and_materials(tmp_path: Path) -> None:
    file = coat(tmp_path)
    garment = read_garment(file, 1.0, "twill", {"lining": "satin"})
    assert [cloth for _, cloth in garment.pieces] == ["twill", "satin"]
    assert len(garment.uncovered.triangles) == 2
    assert [len(mesh.triangles) for mesh in garment.meshes] == [2, 2, 2]
    by_part = read_garment(file, 1.0, "twill", {"lining": "satin", "back": "plain", "front": "satin"})
    assert [cloth for _, cloth in by_part.pieces] == ["satin", "plain"]


@pytest.mark.filterwarnings("ignore:.*stay uncovered")
@pytest.mark.parametrize(
    ("name", "sentence"),
    [
        ("linin", 'no part and no material "linin": did you mean lining'),
        ("sleeve left", "known are front, shell, back, lining"),
    ],
)
def test_wrong_names_are_told(tmp_path: Path, name: str, sentence: str) -> None:
    with pytest.raises(InputError, match=sentence):
        read_garment(coat(tmp_path), 1.0, "twill", {name: "satin"})


@pytest.mark.filterwarnings("ignore:.*stay uncovered")
@pytest.mark.parametrize("name", ["button", "horn"])
def test_a_part_without_uv_that_is_named_is_cut(tmp_path: Path, name: str) -> None:
    with pytest.warns(LoomlightWarning, match="is cut into a piece"):
        garment = read_garment(coat(tmp_path), 1.0, "twill", {name: "satin"}, turns={name: 30.0})
    assert [cloth for _, cloth in garment.pieces] == ["twill", "satin"]
    assert garment.uncovered is None
    assert list(garment.turns) == [0.0, 30.0]
    assert uv_size(garment.pieces[1][0]) == pytest.approx((1000, 1000))


def test_a_mesh_without_uv_is_cut_unless_it_must_not_be(tmp_path: Path) -> None:
    write_mesh(tmp_path / "skirt.obj", [skirt(300)])
    with pytest.raises(InputError, match=r"skirt\.obj has no uv coordinates"):
        read_garment(tmp_path / "skirt.obj", 1.0, "twill", {}, unwrap=False)
    with pytest.warns(LoomlightWarning, match=r"cut into 2 pieces \((front, back|back, front)\)"):
        garment = read_garment(tmp_path / "skirt.obj", 0.5, "twill", {"back": "satin"})
    assert [cloth for _, cloth in garment.pieces] == ["twill", "satin"]
    # uv are metres, of a mesh in other units too.
    assert uv_size(garment.pieces[0][0]) == pytest.approx((1000, 1000), rel=0.03)


def test_edges_of_cut_cloth_have_hems_and_its_seams_none(tmp_path: Path) -> None:
    write_mesh(tmp_path / "skirt.obj", [skirt(600)])
    with pytest.warns(LoomlightWarning, match="is cut"):
        garment = read_garment(tmp_path / "skirt.obj", 1.0, "twill", {"back": "satin"})
    pieces = [mesh for mesh, _ in garment.pieces]
    hems = Edges.of(pieces, "hem", [5e-4, 5e-4], 1.0).on(pieces)
    added = np.concatenate(
        [hem.positions[len(mesh.positions) :] for hem, mesh in zip(hems, pieces, strict=True)]
    )
    # Waist and hem of the skirt are level, at 0.65 m and at 0; its seams run up between them.
    assert len(added) > 0
    assert (np.minimum(np.abs(added[:, 1]), np.abs(added[:, 1] - 0.65)) < 0.012).all()


def test_uv_of_a_file_are_cut_anew_where_that_is_asked_for(tmp_path: Path) -> None:
    with pytest.warns(LoomlightWarning, match="is cut into 3 pieces"):
        garment = read_garment(coat(tmp_path), 1.0, "twill", {}, unwrap=True)
    assert garment.uncovered is None
    ((mesh, _),) = garment.pieces
    assert uv_size(mesh) == pytest.approx((1000, 1000))


def test_what_is_uncovered_is_said(tmp_path: Path) -> None:
    with pytest.warns(LoomlightWarning, match="2 of 6 triangles, of button, have no usable uv"):
        read_garment(coat(tmp_path), 1.0, "twill", {})


@pytest.mark.filterwarnings("ignore:.*stay uncovered")
def test_threads_of_one_fabric_are_alike_on_parts_of_other_density(tmp_path: Path) -> None:
    sizes = []

    def cloth(millimetres: tuple[float, float]) -> mi.BSDF:
        sizes.append(millimetres)
        return mi.load_dict({"type": "diffuse"})

    shown = build_scene("flat", cloth, mesh=coat(tmp_path), size=(16, 12))
    # One BSDF: the denser uv are stretched to the scale of the others.
    assert sizes == [pytest.approx((400, 400))]
    assert {"cloth", "uncovered"} <= {shape.id() for shape in shown.scene.shapes()}
    (mesh, _), *_ = read_garment(coat(tmp_path), 1.0, "twill", {}).pieces
    assert np.ptp(mesh.uv[4:], axis=0) == pytest.approx((1, 1))


def test_a_part_inside_out_is_named(tmp_path: Path) -> None:
    """Two squares that share an edge and run along it in the same sense."""
    mesh = tmp_path / "coat.obj"
    places = ((0, 0), (1, 0), (1, 1), (0, 1), (3, 0), (3, 1))
    corners = "".join(f"v {x} {y} 0\nvt {x} {y}\n" for x, y in places)
    mesh.write_text(f"{corners}o sleeve\nf 1/1 4/4 3/3 2/2\no body\nf 2/2 5/5 6/6 3/3\n")
    with pytest.warns(LoomlightWarning, match=r'coat\.obj: the part "sleeve" is inside out'):
        read_garment(mesh, 1.0, "twill", {})


@pytest.mark.filterwarnings("ignore:.*stay uncovered")
def test_all_pieces_turn_together(tmp_path: Path) -> None:
    further = {"lining": lambda _: mi.load_dict({"type": "diffuse"})}
    shown = build_scene("flat", {"type": "diffuse"}, mesh=coat(tmp_path), size=(16, 12), others=further)
    before = {shape.id(): shape.bbox() for shape in shown.scene.shapes()}
    list(Turntable(shown, about_middle=True).pictures(2, spp=1))
    after = {shape.id(): shape.bbox() for shape in shown.scene.shapes()}
    moved = {name for name, box in after.items() if abs(box.min.x - before[name].min.x) > 0.1}
    # The second of the three stands in the middle, and takes its own place.
    assert len(moved) == 2
    assert "uncovered" in moved


@pytest.mark.skipif(DATA is None, reason="LOOMLIGHT_DATA does not name the folder of outside meshes")
def test_outside_meshes_of_parts_and_other_units() -> None:
    cases = Path(DATA or "") / "cases"
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        garment = read_garment(cases / "m11_two_primitives_other_uv_density.gltf", 1.0, "twill", {})
    ((mesh, _),) = garment.pieces
    area, dp_du, _ = metric(mesh)
    stretch = np.linalg.norm(dp_du, axis=1)[np.isfinite(area)]
    # Both panels, equal halves of the triangles, show the same threads.
    first, second = np.split(stretch, 2)
    assert np.median(first) == pytest.approx(np.median(second), rel=1e-3)
    with pytest.warns(LoomlightWarning, match="1 of 2|stay uncovered|uncovered"):
        assert read_garment(cases / "m09_part_without_uv.gltf", 1.0, "twill", {}).uncovered is not None
    with pytest.warns(LoomlightWarning, match=r"--metres-per-unit 0\.001"):
        read_garment(cases / "o11_mm_units.obj", 1.0, "twill", {})
