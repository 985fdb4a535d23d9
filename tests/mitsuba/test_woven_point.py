"""The BSDF plugin: what it samples, what it is told, and that cloth looks the same on every mesh.

Covers: mitsuba/plugins.py, mitsuba/bsdf.py, yarn/geometry.py, models/point.py
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.fabric import load_fabric
from loomlight.mesh.cloth_mesh import ClothMesh
from loomlight.mitsuba import build_scene, material_bsdf, render, to_shape

GREY = {"type": "woven_point", "weave": "twill 3/1", "warp_color": "#888888", "weft_color": "#888888"}


def woven(**parameters: Any) -> Any:
    return mi.load_dict(GREY | parameters)


def interactions(count: int, view: tuple[float, float, float], seed: int = 0) -> Any:
    """Points spread over the cloth, seen from `view`, with the identity frame."""
    random = np.random.default_rng(seed)
    si = dr.zeros(mi.SurfaceInteraction3f, count)
    si.uv = mi.Point2f(random.random((2, count)))
    si.n = mi.Normal3f(0, 0, 1)
    si.sh_frame = mi.Frame3f(mi.Vector3f(1, 0, 0), mi.Vector3f(0, 1, 0), mi.Vector3f(0, 0, 1))
    si.dp_du, si.dp_dv = mi.Vector3f(1, 0, 0), mi.Vector3f(0, 1, 0)
    si.wi = dr.normalize(mi.Vector3f(*view))
    si.t = mi.Float(1)
    return si


def uniform(count: int, seed: int) -> np.ndarray:
    return np.random.default_rng(seed).random((3, count)).astype(np.float32)


def drawn(bsdf: Any, si: Any, seed: int = 1) -> tuple[Any, Any]:
    u = uniform(dr.width(si.uv), seed)
    return bsdf.sample(mi.BSDFContext(), si, mi.Float(u[0]), mi.Point2f(u[1:]))


def test_holes_let_light_pass_and_nothing_else() -> None:
    bsdf = woven(gap=0.5)
    si = interactions(20000, (0, 0, 1))
    through = np.array(bsdf.eval_null_transmission(si))[0]
    assert set(np.unique(through)) == {0.0, 1.0}
    # From straight above, what neither family covers: gap², n = 20000.
    np.testing.assert_allclose(through.mean(), 0.25, atol=4 * np.sqrt(0.25 * 0.75 / 20000))
    value = np.array(bsdf.eval(mi.BSDFContext(), si, dr.normalize(mi.Vector3f(0.2, 0.1, 1))))
    assert value[:, through == 1].max() == 0
    bs, weight = drawn(bsdf, si)
    passes = np.array(mi.has_flag(bs.sampled_type, mi.BSDFFlags.Null))
    np.testing.assert_array_equal(passes, through == 1)
    np.testing.assert_allclose(np.array(weight)[:, passes], 1, rtol=1e-5)
    np.testing.assert_allclose(np.array(bs.wo + si.wi)[:, passes], 0, atol=1e-6)


def quad(uv: list[list[float]], flip_winding: bool = False) -> ClothMesh:
    """A square of 8 mm with the given uv at (0,0), (1,0), (1,1), (0,1)."""
    corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]) * 8e-3
    triangles = np.array([[0, 1, 2], [0, 2, 3]])
    return ClothMesh(corners, np.array([[0, 0, 1.0]] * 4), np.array(uv, dtype=float), triangles, "quad")


def picture_of(mesh: ClothMesh, spp: int = 8) -> np.ndarray:
    scene = mi.load_dict(
        {
            "type": "scene",
            "cloth": to_shape(mesh, GREY | {"uv_size": "8,8", "warp_twist_deg": 40.0, "warp_specular": 1.0}),
            "light": {"type": "directional", "direction": [0.5, -0.3, -1], "irradiance": 1.0},
            "sensor": {
                "type": "perspective",
                "fov": 6,
                "near_clip": 1e-3,
                "to_world": mi.ScalarTransform4f().look_at(
                    [0.004, 0.004, 0.07], [0.004, 0.004, 0], [0, 1, 0]
                ),
                "film": {"type": "hdrfilm", "width": 48, "height": 48, "rfilter": {"type": "box"}},
            },
        }
    )
    return render(scene, spp=spp).mean(axis=2)


def slant(picture: np.ndarray) -> float:
    """Correlation with itself moved along the rising diagonal, less that along the falling one."""
    centred = picture - picture.mean()
    shift = 3  # pixels: about a thread
    rising = np.mean(centred * np.roll(centred, (-shift, shift), axis=(0, 1)))
    falling = np.mean(centred * np.roll(centred, (shift, shift), axis=(0, 1)))
    return float((rising - falling) / centred.var())


def test_v_running_down_shows_the_same_cloth() -> None:
    up = picture_of(quad([[0, 0], [1, 0], [1, 1], [0, 1]]))
    down = picture_of(quad([[0, 1], [1, 1], [1, 0], [0, 0]]))
    # Where a ray grazes the flank of a yarn, rounding decides which of its samples it meets.
    assert np.isclose(up, down, rtol=1e-2, atol=2e-3).mean() > 0.998
    np.testing.assert_allclose(up, down, rtol=0.1, atol=1e-2)


def test_twill_keeps_its_hand_on_mirrored_islands() -> None:
    upright = slant(picture_of(quad([[0, 0], [1, 0], [1, 1], [0, 1]])))
    mirrored = slant(picture_of(quad([[1, 0], [0, 0], [0, 1], [1, 1]])))
    turned = slant(picture_of(quad([[0, 1], [0, 0], [1, 0], [1, 1]])))  # a quarter turn
    assert abs(upright) > 0.05
    assert np.sign(mirrored) == np.sign(upright)
    np.testing.assert_allclose(mirrored, upright, rtol=0.5)
    # Turned by 90° a diagonal that rises falls: the measure does see hands.
    assert np.sign(turned) == -np.sign(upright)


def test_inline_parameters_are_those_of_a_file(tmp_path: Path) -> None:
    file = tmp_path / "denim.toml"
    file.write_text('weave = "twill 3/1"\nends_per_cm = 28\n[warp]\ncolor = "#20305c"\nroughness = 0.3\n')
    inline = mi.load_dict(
        {
            "type": "woven_point",
            "weave": "twill 3/1",
            "ends_per_cm": 28.0,
            "warp_color": "#20305c",
            "warp_roughness": 0.3,
        }
    )
    xml = mi.load_string(
        f"""<bsdf version="3.0.0" type="woven_point"><string name="fabric" value="{file}"/></bsdf>"""
    )
    factory = material_bsdf(load_fabric(file), "point")((100.0, 100.0))
    si, wo = interactions(500, (0.2, 0.1, 1)), dr.normalize(mi.Vector3f(-0.3, 0.4, 0.8))
    expected = np.array(inline.eval(mi.BSDFContext(), si, wo))
    assert expected.max() > 0
    for other in (xml, factory):
        np.testing.assert_allclose(other.eval(mi.BSDFContext(), si, wo), expected, rtol=1e-4)


def test_inline_parameters_replace_those_of_a_file(tmp_path: Path) -> None:
    file = tmp_path / "cloth.toml"
    file.write_text('weave = "satin 5"\nepi = 70\n[warp]\ncolor = "#ff0000"\n')
    bsdf = mi.load_dict(
        {"type": "woven_point", "fabric": str(file), "weave": "plain", "ends_per_cm": 10.0, "weft_gap": 0.4}
    )
    assert bsdf.model.fabric.layout().warp_on_top.shape == (2, 2)
    np.testing.assert_allclose(bsdf.model.fabric.layout().warp.spacing, 1.0)
    np.testing.assert_allclose(bsdf.model.fabric.appearance().warp.diffuse_reflect[0][1:], 0, atol=1e-6)


def test_colours_as_rgb_values_in_xml() -> None:
    bsdf = mi.load_string(
        """<bsdf version="3.0.0" type="woven_point"><string name="weave" value="plain"/>
             <rgb name="warp_color" value="0.5,0.2,0.1"/>
             <rgb name="warp_specular_tint" value="1,0,0"/></bsdf>"""
    )
    albedo = bsdf.model.fabric.appearance().warp
    assert albedo.diffuse_reflect[0][0] > albedo.diffuse_reflect[0][1] > albedo.diffuse_reflect[0][2] > 0
    np.testing.assert_allclose(albedo.specular_reflect[0][1:], 0, atol=1e-9)


def test_uv_size_and_uv_scale_agree() -> None:
    width, height = woven().model.fabric.repeat_mm
    sized = woven(uv_size=f"{3 * width},{5 * height}")
    scaled = woven(uv_scale=mi.ScalarPoint2f(3, 5))
    np.testing.assert_allclose(sized.uv_size, scaled.uv_size, rtol=1e-6)
    np.testing.assert_allclose(np.array(woven().uv_size).ravel(), 100)


@pytest.mark.parametrize(
    ("parameters", "says"),
    [
        ({"fabric": "nowhere.toml"}, "nowhere.toml"),
        ({"weave": "no such weave"}, "no such weave"),
        ({"warp_roughness": 7.0}, "roughness"),
        ({"uv_size": "1,2,3"}, "uv_size"),
        ({"uv_size": "0"}, "uv_size"),
        ({"uv_size": "1", "uv_scale": "1"}, "uv_scale"),
        ({"wrap_color": "#fff"}, "wrap_color"),
    ],
)
def test_wrong_parameters_are_named(parameters: dict[str, Any], says: str) -> None:
    with pytest.raises((RuntimeError, InputError), match=says):
        mi.load_dict({"type": "woven_point"} | parameters)


def test_albedo_texture_multiplies_the_dye() -> None:
    si, wo = interactions(500, (0.2, 0.1, 1)), dr.normalize(mi.Vector3f(-0.3, 0.4, 0.8))
    # Light between yarns meets the dye more than once.
    matt = {"warp_specular": 0.0, "weft_specular": 0.0, "interreflection": False}
    plain = np.array(woven(**matt).eval(mi.BSDFContext(), si, wo))
    tinted = woven(**matt, albedo={"type": "rgb", "value": [0.5, 1.0, 0.25]})
    value = np.array(tinted.eval(mi.BSDFContext(), si, wo))
    np.testing.assert_allclose(value, plain * np.array([[0.5], [1.0], [0.25]]), rtol=1e-5)


def test_a_bsdf_says_what_it_is() -> None:
    text = str(woven(sheen_strength=0.5))
    assert "twill 3/1" in text
    assert "4 ends × 4 picks" in text


@pytest.mark.slow
def test_cloth_renders_with_stock_integrators_too() -> None:
    scene = build_scene("flat", material_bsdf("plain", "point"), size=(16, 16), light="directional").scene
    ours = render(scene, spp=64)
    theirs = render(scene, spp=64, integrator=mi.load_dict({"type": "path", "max_depth": 8}), seed=1)
    # One directional light and nothing behind the cloth: holes show black either way.
    np.testing.assert_allclose(ours.mean(), theirs.mean(), rtol=0.05)


def test_diffuse_reflectance_is_the_dye() -> None:
    bsdf = woven(warp_specular=0.0, weft_specular=0.0, gap=0.0)
    albedo = np.array(bsdf.eval_diffuse_reflectance(interactions(200, (0, 0, 1))))
    families = bsdf.model.fabric.appearance()
    dyes = np.array([family.diffuse_reflect[0][0] for family in (families.warp, families.weft)])
    away = np.abs(albedo[0][:, None] - dyes).min(axis=1)
    assert (np.minimum(away, albedo[0]) < 1e-5).all()
    assert albedo.max() > 0
