"""The network as a BSDF: the same numbers as torch, what it samples, and what editing costs.

Covers: mitsuba/cloth_uv.py, mitsuba/filtered_texture.py
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.mitsuba import build_scene, material_bsdf, render
from loomlight.mitsuba.filtered_texture import FilteredTexture
from loomlight.mitsuba.integrator import symbolic_mode
from loomlight.models.neural import encoding
from loomlight.models.neural import model as neural_model
from loomlight.models.neural.latent_cache import clear_encodings
from loomlight.models.neural.weights import Weights

from ..models.neural.networks import network, weights_of
from ..models.neural.reference import responses
from .footprints import (
    assert_all_at_once_is_each_alone,
    assert_each_shows_its_own,
    assert_threads_have_colours_to_edit,
    assert_weight_is_value_over_density,
    halve_colours,
    interactions,
    mean_value,
    random_interactions,
    unit,
    vectors,
)

TWILL = {
    "type": "woven_neural",
    "weave": "twill 2/1",
    "warp_color": "#c08040",
    "weft_color": "#4060c0",
    "warp_translucency": 0.3,
    "uv_size": "4,4",
}


@pytest.fixture(scope="module")
def weights(tmp_path_factory: pytest.TempPathFactory) -> Weights:
    """A narrow network with random weights, which compiles quickly."""
    return weights_of(network("field", hidden=16), tmp_path_factory.mktemp("weights"))


@pytest.fixture(autouse=True)
def runs(monkeypatch: pytest.MonkeyPatch, tmp_path: Path, weights: Weights) -> list[str]:
    """Names of the fabrics that the encoder was run for, with empty caches."""
    monkeypatch.setattr(neural_model, "shipped_weights", lambda: weights)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    clear_encodings()
    found: list[str] = []
    run = encoding.run_encoder

    def counted(fabric: Any, *arguments: Any) -> Any:
        found.append(fabric.name)
        return run(fabric, *arguments)

    monkeypatch.setattr(encoding, "run_encoder", counted)
    return found


def woven(**parameters: Any) -> Any:
    return mi.load_dict(TWILL | parameters)


def test_values_are_those_of_torch(monkeypatch: pytest.MonkeyPatch) -> None:
    # The reference takes one square.
    nothing = mi.Vector2f(0)
    monkeypatch.setattr(neural_model, "taps_of_footprint", lambda f, _: (f.spread_side, nothing, nothing))
    bsdf, count, made = woven(), 2000, network("field", hidden=16)
    si, uv, views, sides = random_interactions(count)
    lights = unit(np.random.default_rng(1), count)
    found = np.array(bsdf.eval(mi.BSDFContext(), si, vectors(lights)))
    parts = responses(made, bsdf.model.encoded, bsdf.model.fabric, lights, views, 4.0 * uv, 4.0 * sides)
    appearance = bsdf.model.fabric.appearance()
    side = np.where(lights[:, 2] * views[:, 2] < 0, "transmit", "reflect")
    wanted = np.zeros((3, count))
    for number, (term, family) in enumerate(
        (term, family) for term in ("diffuse", "specular") for family in ("warp", "weft")
    ):
        albedo = np.stack([getattr(getattr(appearance, family), f"{term}_{s}")[0] for s in side], 1)
        wanted += albedo * parts[:, number]
    # Float32 all the way; the highest values are e^3 times those whose error is theirs.
    np.testing.assert_allclose(found, wanted, atol=1e-4 * wanted.max())


@pytest.mark.parametrize("side", [0.02, 0.3])
def test_weight_is_value_over_density(side: float) -> None:
    cloth = woven(sheen_strength=0.4)
    assert_weight_is_value_over_density(cloth, side, density=1e-3, value=1e-3, through=1e-4)


def test_all_at_once_is_each_alone() -> None:
    assert_all_at_once_is_each_alone(woven(), rtol=1e-4)


@pytest.mark.parametrize("view", [(0.1, 0.2, 1.0), (-0.6, 0.1, -0.5)])
def test_sampling_follows_its_density(view: tuple[float, float, float]) -> None:
    bsdf = woven()
    direction = np.array(view) / np.linalg.norm(view)

    def prepared(count: int) -> Any:
        one = np.ones((count, 1))
        return interactions(0.37 * np.ones((count, 2)), one * direction, np.full(count, 0.05))

    def sample(u: Any) -> Any:
        si = prepared(dr.width(u))
        bs, _ = bsdf.sample(mi.BSDFContext(), si, u.x, mi.Point2f(u.y, u.z))
        smooth = ~mi.has_flag(bs.sampled_type, mi.BSDFFlags.Null)
        return bs.wo, dr.select(smooth, mi.Float(1), 0)

    test = mi.chi2.ChiSquareTest(
        domain=mi.chi2.SphericalDomain(),
        sample_func=sample,
        pdf_func=lambda wo: bsdf.pdf(mi.BSDFContext(), prepared(dr.width(wo)), wo),
        sample_dim=3,
        sample_count=100_000,
        res=51,
        ires=8,
    )
    assert test.run(significance_level=0.001), getattr(test, "messages", "")


def test_editing_a_colour_needs_no_encoder(runs: list[str]) -> None:
    bsdf = woven(sheen_strength=0.3)
    assert len(runs) == 1
    before = mean_value(bsdf)
    halve_colours(bsdf)
    halved = mean_value(bsdf)
    assert len(runs) == 1
    assert (halved < before).all()
    plain = mean_value(woven())
    # What is left of the sheen takes and adds a thousandth.
    np.testing.assert_allclose(halved, 0.5 * plain, rtol=5e-3)


def test_editing_threads_is_the_fabric_of_those_threads(runs: list[str]) -> None:
    bsdf = woven()
    params = mi.traverse(bsdf)
    params["warp.roughness"] = 0.7
    params["weft.twist"] = float(np.radians(20))
    params["weft.height_scale"] = 0.5
    params.update()
    assert len(runs) == 2
    made = woven(warp_roughness=0.7, weft_twist_deg=20.0, weft_height_scale=0.5)
    np.testing.assert_allclose(mean_value(bsdf), mean_value(made), rtol=1e-4)
    assert np.abs(mean_value(bsdf) / mean_value(woven()) - 1).max() > 5e-4
    params["warp.roughness"] = 7.0
    with pytest.raises(InputError, match=r"warp\.roughness"):
        params.update()


def test_colours_thread_by_thread() -> None:
    assert_threads_have_colours_to_edit(woven(warp_color="#ff0000,#00ff00,#0000ff"))


def test_two_fabrics_are_mixed_and_extrapolated(runs: list[str]) -> None:
    colours = {"warp_color": "#808080", "weft_color": "#808080", "warp_translucency": 0.0}
    bsdf = woven(other="plain", blend=0.0, **colours)
    params = mi.traverse(bsdf)
    np.testing.assert_allclose(mean_value(bsdf), mean_value(woven(**colours)), rtol=1e-2)
    encoded = len(runs)
    values = []
    for blend in (0.5, 1.0, 1.5):
        params["blend"] = blend
        params.update()
        values.append(mean_value(bsdf))
        assert np.isfinite(values[-1]).all()
    assert len(runs) == encoded
    assert np.ptp(values, axis=0).max() > 0


def test_a_print_is_averaged_over_the_footprint() -> None:
    checks = {"type": "checkerboard", "color0": 0.0, "color1": 1.0}
    checks["to_uv"] = mi.ScalarTransform4f().scale(40)
    matt = {"warp_specular": 0.0, "weft_specular": 0.0}
    bsdf, bare = woven(albedo=checks, **matt), woven(**matt)
    rng = np.random.default_rng(5)
    views = np.tile([0.0, 0.0, 1.0], (500, 1))
    light = mi.Vector3f(0.1, 0.2, 0.97)
    contrast = []
    for side in (1e-3, 0.2):
        si = interactions(rng.random((500, 2)), views, np.full(500, side))
        printed = np.array(bsdf.eval(mi.BSDFContext(), si, light))[0]
        plain = np.array(bare.eval(mi.BSDFContext(), si, light))[0]
        ratio = printed / plain
        contrast.append(ratio.std() / ratio.mean())
    # Near, half of it is black; from afar all of it is grey.
    assert contrast[0] > 0.8
    assert contrast[1] < 0.05


def test_texture_means_are_those_of_the_texture() -> None:
    texture = mi.load_dict({"type": "checkerboard", "color0": 0.2, "color1": 0.8})
    filtered = FilteredTexture(texture)
    si = interactions(np.array([[0.25, 0.25], [0.25, 0.75], [0.3, 0.3]]), np.zeros((3, 3)), np.ones(3))
    edge = mi.Float([0.05, 0.05, 8.0])
    found = np.array(filtered.over(si, mi.Vector2f(edge, 0), mi.Vector2f(0, edge), mi.Bool(True)))[0]
    direct = np.array(texture.eval(si))[0]
    # Inside a field, and over all of them.
    np.testing.assert_allclose(found, [direct[0], direct[1], 0.5], atol=1e-5)


@pytest.mark.parametrize("edge", [0.02, 0.035, 0.05])
def test_texture_means_have_the_variance_of_the_footprint(edge: float) -> None:
    fields = {"type": "checkerboard", "color0": 0.0, "color1": 1.0}
    fields["to_uv"] = mi.ScalarTransform4f().scale([3.37, 1, 1])
    filtered = FilteredTexture(mi.load_dict(fields))
    variances = []
    # Edges lie differently to the pyramid's squares, on which the variance of each depends.
    for number in range(1, 6):
        x = number / (2 * 3.37) + np.linspace(-0.07, 0.07, 1401)
        si = interactions(np.stack([x, np.full_like(x, 0.25)], 1), np.zeros((1401, 3)), np.ones(1401))
        side = mi.Float(edge)
        step = np.array(filtered.over(si, mi.Vector2f(side, 0), mi.Vector2f(0, side), mi.Bool(True)))[0]
        density = np.gradient(step, x) / (step[-1] - step[0])
        variances.append(np.trapezoid(density * (x - number / (2 * 3.37)) ** 2, x))
    np.testing.assert_allclose(np.mean(variances), edge**2 / 12, rtol=0.25)


def test_a_pixel_angle_stands_in_for_the_integrators_footprint() -> None:
    rng = np.random.default_rng(6)
    uv, views = rng.random((500, 2)), np.tile([0.0, 0.0, 1.0], (500, 1))
    told = interactions(uv, views, np.full(500, 0.2))
    untold = interactions(uv, views, np.zeros(500))
    light = mi.Vector3f(0.1, 0.2, 0.97)
    wanted = np.array(woven().eval(mi.BSDFContext(), told, light))
    angled = np.array(woven(pixel_angle=0.2).eval(mi.BSDFContext(), untold, light))
    np.testing.assert_allclose(angled, wanted, rtol=1e-3, atol=1e-5)
    assert np.abs(np.array(woven().eval(mi.BSDFContext(), untold, light)) - wanted).max() > 1e-3


def test_xml_and_inline_are_the_same() -> None:
    xml = mi.load_string(
        """<bsdf version="3.0.0" type="woven_neural">
             <string name="weave" value="twill 2/1"/><string name="warp_color" value="#c08040"/>
             <string name="weft_color" value="#4060c0"/><float name="warp_translucency" value="0.3"/>
             <string name="uv_size" value="4,4"/></bsdf>"""
    )
    np.testing.assert_allclose(mean_value(xml), mean_value(woven()), rtol=1e-5)
    assert "woven_neural" in str(xml)
    assert "twill 2/1" in str(xml)


def test_many_fabrics_in_one_picture_are_each_its_own() -> None:
    """Two fabrics side by side show what each shows alone, without symbolic calls."""
    other = TWILL | {"weave": "plain", "warp_color": "#ffffff"}
    assert_each_shows_its_own(TWILL, other, symbolic=False)


def test_flags_are_left_as_they_were() -> None:
    networks = mi.load_dict({"type": "scene", "cloth": {"type": "rectangle", "bsdf": TWILL}})
    others = mi.load_dict({"type": "scene", "cloth": {"type": "rectangle"}})
    assert dr.flag(dr.JitFlag.SymbolicCalls)
    with symbolic_mode(others):
        assert dr.flag(dr.JitFlag.SymbolicCalls)
    with symbolic_mode(networks):
        assert not dr.flag(dr.JitFlag.SymbolicCalls)
        assert not dr.flag(dr.JitFlag.SymbolicLoops)
    assert dr.flag(dr.JitFlag.SymbolicCalls)


def test_a_scene_of_loomlight_renders_with_it() -> None:
    scene = build_scene("flat", material_bsdf("twill 2/1", "neural"), size=(24, 24), max_depth=2)
    picture = render(scene.scene, spp=1, integrator=scene.integrator)
    assert np.isfinite(picture).all()
    assert picture.mean() > 0
