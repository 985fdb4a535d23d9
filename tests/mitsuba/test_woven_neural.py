"""The network as a BSDF: the same numbers as torch, what it samples, and what editing costs.

Covers: mitsuba/bsdf.py, mitsuba/filtered_texture.py
"""

from __future__ import annotations

from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest

from loomlight.mitsuba.bsdf import SceneTraits, symbolic_mode
from loomlight.mitsuba.filtered_texture import FilteredTexture
from loomlight.models.neural import encoding
from loomlight.models.neural import model as neural_model
from tests.helpers.directions import unit_vectors
from tests.helpers.interactions import interactions, mean_value, random_interactions, vectors
from tests.helpers.neural_networks import network
from tests.helpers.references.neural_decoder import responses

TWILL = {
    "type": "woven_neural",
    "weave": "twill 2/1",
    "warp_color": "#c08040",
    "weft_color": "#4060c0",
    "warp_translucency": 0.3,
    "uv_size": "4,4",
}


@pytest.fixture(autouse=True)
def runs(monkeypatch: pytest.MonkeyPatch, narrow_network: None) -> list[str]:
    """Names of the fabrics that the encoder was run for."""
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
    # Nor has it light between yarns.
    bsdf, count, made = woven(interreflection=False), 2000, network("field", hidden=16)
    si, uv, views, sides = random_interactions(count)
    lights = unit_vectors(np.random.default_rng(1), count)
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


@pytest.mark.slow
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


def test_flags_are_left_as_they_were() -> None:
    networks = mi.load_dict({"type": "scene", "cloth": {"type": "rectangle", "bsdf": TWILL}})
    others = mi.load_dict({"type": "scene", "cloth": {"type": "rectangle"}})
    assert dr.flag(dr.JitFlag.SymbolicCalls)
    with symbolic_mode(SceneTraits.of(others)):
        assert dr.flag(dr.JitFlag.SymbolicCalls)
    with symbolic_mode(SceneTraits.of(networks)):
        assert not dr.flag(dr.JitFlag.SymbolicCalls)
        assert not dr.flag(dr.JitFlag.SymbolicLoops)
    assert dr.flag(dr.JitFlag.SymbolicCalls)
