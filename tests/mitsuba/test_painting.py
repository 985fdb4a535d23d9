"""Maps of a fabric on surfaces of Mitsuba: where pictures lie; what is seen is the mean of the variants."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest
from PIL import Image

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.fabric import Fabric, fabric_from_text
from loomlight.fabric.surface_maps import with_maps
from loomlight.mesh.cloth_mesh import ClothMesh
from loomlight.mesh.picture_places import FILE_UV, PicturePlace, picture_uv
from loomlight.mitsuba import build_scene, material_bsdf
from tests.marks import slow

CLOTH = 'weave = "plain"\nends_per_cm = 20\ninterreflection = false\nwarp.specular = 0\nweft.specular = 0\n'
GREY = CLOTH + 'warp.albedo = "#808080"\nweft.albedo = "#808080"'


def picture(path: Path, rows: Any) -> str:
    Image.fromarray(np.array(rows, np.uint8)).save(path)
    return str(path)


def seen(bsdf: Any, uv: np.ndarray, side: float = 0.0) -> np.ndarray:
    """Values [n, 3] of a BSDF from above under light from above, at uv, over footprints of a side in uv."""
    si = dr.zeros(mi.SurfaceInteraction3f, len(uv))
    si.uv = mi.Point2f(uv[:, 0].astype(np.float32), uv[:, 1].astype(np.float32))
    si.wi, si.t = mi.Vector3f(0, 0, 1), mi.Float(1)
    si.dp_du, si.dp_dv = mi.Vector3f(1, 0, 0), mi.Vector3f(0, 1, 0)
    si.sh_frame = mi.Frame3f(mi.Normal3f(0, 0, 1))
    si.duv_dx, si.duv_dy = mi.Vector2f(side, 0), mi.Vector2f(0, side)
    return np.array(bsdf.eval(mi.BSDFContext(), si, mi.Vector3f(0, 0, 1))).T


def of(fabric: Fabric, maps: dict[str, Any], model: str = "lobes") -> Any:
    return material_bsdf(with_maps(fabric, maps), model)((100.0, 100.0))


def test_colours_that_multiply_do_so_on_either_family(tmp_path: Path) -> None:
    """Far away, where both families show alike: a map of the warp takes half of what both would."""
    fabric, red = fabric_from_text(GREY), picture(tmp_path / "red.png", [[[255, 0, 0]]])
    place = np.full((1, 2), 0.3)
    plain = seen(of(fabric, {"weft.color": picture(tmp_path / "w.png", [[[255] * 3]])}), place, 0.5)
    both, warp, weft = (
        seen(of(fabric, {name: red}), place, 0.5) for name in ("color", "warp.color", "weft.color")
    )
    np.testing.assert_allclose(both / plain, [[1, 0, 0]], atol=1e-5)
    np.testing.assert_allclose(warp + weft, plain + both, rtol=1e-4)
    assert 0.3 < (warp / plain)[0, 1] < 0.7


def test_pictures_lie_on_uv_row_by_row_from_the_top(tmp_path: Path) -> None:
    rows = [[[255, 0, 0], [0, 255, 0]], [[0, 0, 255], [255, 255, 255]]]
    bsdf = of(fabric_from_text(GREY), {"color": picture(tmp_path / "p.png", rows)})
    found = seen(bsdf, np.array([[0.25, 0.25], [0.75, 0.25], [0.25, 0.75], [1.25, 1.25]]), 0.01)
    np.testing.assert_array_equal(found > 0.02, [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 0]])


@pytest.mark.parametrize("model", [slow("lobes"), "point"])
def test_a_mixture_is_the_mean_of_its_variants(model: str, tmp_path: Path) -> None:
    """z-test of a grey three tenths of the way between two fabrics against the mean of both, on a thread."""
    (tmp_path / "dark.toml").write_text(CLOTH + 'warp.albedo = "#202020"\nweft.albedo = "#202020"')
    grey = {"picture": picture(tmp_path / "g.png", [[77, 77]]), "fabrics": [str(tmp_path / "dark.toml")]}
    fabric, dark = fabric_from_text(GREY), fabric_from_text((tmp_path / "dark.toml").read_text())
    rng = np.random.default_rng(7)
    uv = 0.4 + 0.01 * rng.random((20_000, 2))
    mixed = seen(of(fabric, {"fabric": grey}, model), uv, 0.002)[:, 1]
    ends = [seen(material_bsdf(each, model)((100.0, 100.0)), uv, 0.002)[:, 1] for each in (fabric, dark)]
    share = 77 / 255
    expected = (1 - share) * ends[0] + share * ends[1]
    error = (mixed - expected).std() / np.sqrt(len(uv))
    assert abs((mixed - expected).mean()) < 4 * error
    # And each sample is one of both.
    np.testing.assert_allclose(np.minimum(abs(mixed - ends[0]), abs(mixed - ends[1])), 0, atol=1e-5)


def test_far_away_shares_are_those_of_the_footprint(tmp_path: Path) -> None:
    """Stripes of two fabrics, far below the footprint: half of the samples show either."""
    (tmp_path / "dark.toml").write_text(CLOTH + 'warp.albedo = "#000000"\nweft.albedo = "#000000"')
    stripes = picture(tmp_path / "s.png", [[0, 255] * 64] * 128)
    bsdf = of(
        fabric_from_text(GREY), {"fabric": {"picture": stripes, "fabrics": [str(tmp_path / "dark.toml")]}}
    )
    uv = np.random.default_rng(3).random((4000, 2))
    lit = seen(bsdf, uv, 0.2)[:, 1] > 0.01
    assert abs(lit.mean() - 0.5) < 4 * 0.5 / np.sqrt(len(uv))


@pytest.mark.parametrize("model", [slow("lobes"), "point"])
def test_values_match_densities_of_samples(model: str, tmp_path: Path) -> None:
    """weight·pdf = value of the variant that the very same place shows."""
    grey = {"picture": picture(tmp_path / "g.png", [[128]]), "low": 0.2, "high": 0.6, "mode": "replace"}
    maps = {"roughness": grey, "wear": picture(tmp_path / "w.png", [[0, 90, 255]])}
    bsdf = of(fabric_from_text(GREY), maps, model)
    rng = mi.load_dict({"type": "independent"})
    rng.seed(1, 2000)
    si = dr.zeros(mi.SurfaceInteraction3f, 2000)
    si.uv, si.t, si.wi = rng.next_2d(), rng.next_1d(), dr.normalize(mi.Vector3f(0.3, 0.2, 1))
    si.dp_du, si.dp_dv = mi.Vector3f(1, 0, 0), mi.Vector3f(0, 1, 0)
    si.sh_frame, si.duv_dx, si.duv_dy = (
        mi.Frame3f(mi.Normal3f(0, 0, 1)),
        mi.Vector2f(0.003, 0),
        mi.Vector2f(0, 0.003),
    )
    ctx = mi.BSDFContext()
    drawn, weight = bsdf.sample(ctx, si, rng.next_1d(), rng.next_2d())
    value, pdf = bsdf.eval_pdf(ctx, si, drawn.wo)
    kept = np.array(~mi.has_flag(drawn.sampled_type, mi.BSDFFlags.Null) & (drawn.pdf > 0))
    assert kept.sum() > 1000
    np.testing.assert_allclose(np.array(pdf)[kept], np.array(drawn.pdf)[kept], rtol=1e-3)
    np.testing.assert_allclose(
        (np.array(weight) * np.array(pdf))[:, kept], np.array(value)[:, kept], rtol=2e-3, atol=1e-5
    )


# ----------------------------------------------------------------------------------------------------- places


def card(turned: bool = False) -> ClothMesh:
    """40 by 20 cm in the plane z = 0, seen from +z, or from -z where it is turned."""
    corners = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
    positions = np.c_[corners * [0.4, 0.2], np.zeros(4)]
    triangles = np.array([[0, 1, 2], [0, 2, 3]])
    normals = np.tile([0.0, 0, -1 if turned else 1], (4, 1))
    return ClothMesh(
        positions, normals, corners, triangles[:, ::-1] if turned else triangles, "card", {FILE_UV: corners}
    )


def test_a_thrown_picture_is_as_wide_as_told_where_it_is_told() -> None:
    place = PicturePlace(side="front", width_mm=200, at_mm=(100, 50), repeat=False, aspect=0.5)
    found = picture_uv(card(), place, [card()])
    # Its middle is at (300, 150) mm; it is 200 mm wide and 100 high, v down.
    np.testing.assert_allclose(found[:, :2], [[-1, 2], [1, 2], [1, 0], [-1, 0]])
    # 400 × 200 mm of cloth are 2 × 2 pictures, and one unit of uv.
    np.testing.assert_allclose(found[:, 2], 2)
    assert (picture_uv(card(turned=True), place, [card()])[:, 2] < 0).all()
    assert (picture_uv(card(turned=True), PicturePlace(side="back"), [card()])[:, 2] > 0).all()


def test_what_lies_behind_is_not_printed() -> None:
    """A card 10 cm behind another that covers its left half; one a centimetre behind is the same cloth."""
    front = replace(card(), positions=card().positions * [0.5, 1, 1] + [0, 0, 0.1])
    grid = np.linspace(0, 1, 9)
    x, y = (axis.ravel() for axis in np.meshgrid(0.4 * grid, 0.2 * grid))
    row = (np.arange(8)[:, None] * 9 + np.arange(8)).ravel()
    triangles = np.concatenate([np.c_[row, row + 1, row + 10], np.c_[row, row + 10, row + 9]])
    positions = np.c_[x, y, 0 * x]
    behind = ClothMesh(positions, np.tile([0.0, 0, 1], (81, 1)), np.c_[x, y], triangles, "behind")
    place = PicturePlace(side="front")
    np.testing.assert_array_equal(picture_uv(behind, place, [front, behind])[:, 2] > 0, x > 0.2)
    near = replace(front, positions=front.positions - [0, 0, 0.09])
    assert (picture_uv(behind, place, [near, behind])[:, 2] > 0).all()


def test_seen_from_behind_right_is_the_other_way() -> None:
    front, back = (picture_uv(card(), PicturePlace(side=side), [card()]) for side in ("front", "back"))
    np.testing.assert_allclose(front[:, 0], 1 - back[:, 0])
    np.testing.assert_allclose(front[:, 1], back[:, 1])


def test_a_picture_without_a_width_covers_what_is_seen() -> None:
    for aspect in (0.25, 1.0, 3.0):
        found = picture_uv(card(), PicturePlace(side="front", aspect=aspect), [card()])[:, :2]
        assert found.min() >= -1e-12
        assert found.max() <= 1 + 1e-12
        assert np.isclose(np.ptp(found, axis=0), 1).any()


def test_printed_cloth_has_its_picture_upright_on_the_warp(tmp_path: Path) -> None:
    """Of pictures 50 mm wide and 100 high the upper half is red, from the origin of the weave up by 50 mm."""
    rows = [[[255, 0, 0]], [[0, 0, 255]]]
    bsdf = of(
        fabric_from_text(GREY), {"color": {"picture": picture(tmp_path / "p.png", rows), "width_mm": 50}}
    )
    # A unit of uv is 100 mm, so 25 and 75 mm lie above the middle of a picture.
    found = seen(bsdf, np.array([[0.1, 0.25], [0.6, 0.75], [0.1, 1.25]]), 0.01)
    np.testing.assert_array_equal(found > 0.02, [[1, 0, 0], [0, 0, 1], [1, 0, 0]])


def test_sets_of_uv_that_are_not_there_are_named() -> None:
    with pytest.raises(InputError, match='no set of uv "uv1" for a map'):
        picture_uv(card(), PicturePlace(uv="uv1"), [card()])


def test_pictures_keep_their_place_where_the_weave_is_turned(tmp_path: Path) -> None:
    """--turn and --shift move threads, and no print."""
    from loomlight.core.picture_settings import Placement

    rows = [[[255, 0, 0], [0, 255, 0]], [[0, 0, 255], [255, 255, 255]]]
    bsdf = material_bsdf(with_maps(fabric_from_text(GREY), {"color": picture(tmp_path / "p.png", rows)}))
    kept = []
    for placement in (Placement(), Placement(turn=30, shift=(7, 3))):
        scene = build_scene("flat", bsdf, placement=placement).scene
        shape = next(shape for shape in scene.shapes() if shape.id() == "cloth")
        kept.append(np.array(mi.traverse(shape)["vertex_picture0"]).reshape(-1, 3))
    np.testing.assert_allclose(kept[0][:, :2], kept[1][:, :2], atol=1e-6)
    assert kept[0][:, 1].max() == pytest.approx(1)


def test_models_that_are_trained_refuse_maps(tmp_path: Path) -> None:
    fabric = with_maps(fabric_from_text(GREY), {"wear": picture(tmp_path / "g.png", [[9]])})
    with pytest.raises(InputError, match="has maps, and latent is trained"):
        material_bsdf(fabric, "latent")


def test_baked_models_say_that_they_leave_maps_out(tmp_path: Path) -> None:
    from loomlight.models.bake import bake

    fabric = with_maps(fabric_from_text(GREY), {"wear": picture(tmp_path / "g.png", [[9]])})
    with pytest.warns(LoomlightWarning, match="without its maps of wear"):
        model = bake(fabric, "point")
    assert not model.source.fields.maps


def test_plugins_read_the_maps_of_a_fabric_file(tmp_path: Path) -> None:
    picture(tmp_path / "red.png", [[[255, 0, 0]]])
    (tmp_path / "cloth.toml").write_text(GREY + '\n[maps]\ncolor = "red.png"')
    bsdf = mi.load_dict({"type": "woven_lobes", "fabric": str(tmp_path / "cloth.toml")})
    found = seen(bsdf, np.full((1, 2), 0.3), 0.05)
    assert found[0, 0] > 0.02
    np.testing.assert_allclose(found[0, 1:], 0, atol=1e-6)
    assert "warp.color" not in str(mi.traverse(bsdf))
