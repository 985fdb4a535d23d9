"""Derivatives of scene parameters: against finite differences, and refused where a model has none.

Covers: models/live_albedos.py, core/backend.py
"""

from __future__ import annotations

from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest

from loomlight.core.errors import InputError
from tests.helpers.interactions import interactions, random_interactions
from tests.marks import slow

CLOTH = {
    "weave": "twill 2/1",
    "uv_size": "4,4",
    "gap": 0.2,
    "warp_color": "#c08040",
    "weft_color": "#4060c0",
    "warp_translucency": 0.3,
    "weft_translucency": 0.3,
}
# Light that yarns send to each other scatters more than once.
ONCE = {"interreflection": False}
# Unvaried, one thread an albedo.
GREY = {
    "weave": "twill 3/1",
    "warp_color": "#888888",
    "weft_color": "#888888",
    "sheen_strength": 0.5,
    "sheen_roughness": 0.3,
}
SHEEN = {"weave": "twill 2/1", "uv_size": "4,4", "sheen_strength": 0.3, "id": "mine"}
VARIED = {"variation_fibre_noise": 0.5, "variation_colour_noise": 0.2, "sheen_strength": 0.3}
ALBEDOS = [
    f"{family}.{term}_{side}"
    for family in ("warp", "weft")
    for term in ("diffuse", "specular")
    for side in ("reflect", "transmit")
]
pytestmark = pytest.mark.usefixtures("variant", "narrow_network")


@pytest.mark.quick("plain-woven_neural")
@pytest.mark.parametrize("plugin", ["woven_point", "woven_lobes", "woven_neural"])
@pytest.mark.parametrize("extra", [pytest.param({}, id="plain"), slow(VARIED, id="varied")])
def test_albedos_have_the_derivatives_of_finite_differences(plugin: str, extra: dict[str, Any]) -> None:
    bsdf = mi.load_dict({"type": plugin, **CLOTH, **extra})
    params = mi.traverse(bsdf)
    si, *_ = random_interactions(500, seed=4)
    # From both sides.
    z = dr.select(dr.arange(mi.UInt32, 500) % 2 == 0, mi.Float(0.97), -0.97)
    light = dr.normalize(mi.Vector3f(0.1, 0.2, z))
    # One of each kind, of either family; the sums of pictures below take all.
    keys = ("warp.diffuse_reflect", "weft.specular_reflect", "weft.diffuse_transmit")
    start, step = {key: mi.Color3f(params[key]) for key in keys}, 0.012

    def mean() -> Any:
        return dr.mean(bsdf.eval_pdf(mi.BSDFContext(), si, light)[0], axis=None)

    dr.enable_grad([params[key] for key in keys])
    params.update()
    value = mean()
    dr.backward(value)
    gradients = {key: float(np.array(dr.grad(params[key])).sum()) for key in keys}
    for key in keys:
        sides = []
        for sign in (1, -1):
            for each in keys:
                params[each] = type(params[each])(start[each] + sign * step * (each == key))
            params.update()
            sides.append(float(np.array(mean()).item()))
        assert gradients[key] > 0
        # Both sides: light between yarns is not linear in albedos. Variation is clipped, and means over
        # 1500 values are float32.
        difference = (sides[0] - sides[1]) / (2 * step)
        np.testing.assert_allclose(gradients[key], difference, rtol=0.01, err_msg=key)


def picture_scene(plugin: str, integrator: str, depth: int) -> Any:
    return mi.load_dict(
        {
            "type": "scene",
            "integrator": {"type": integrator, "max_depth": depth},
            "light": {"type": "directional", "direction": [0.3, 0.2, -1]},
            "sensor": {
                "type": "perspective",
                "fov": 25,
                "to_world": mi.ScalarTransform4f().look_at([0, 0, 4], [0, 0, 0], [0, 1, 0]),
                "film": {"type": "hdrfilm", "width": 8, "height": 8, "rfilter": {"type": "box"}},
            },
            "cloth": {"type": "rectangle", "bsdf": {"type": plugin, **CLOTH, "gap": 0.0, **ONCE}},
        }
    )


@pytest.mark.slow
@pytest.mark.parametrize(
    "integrator",
    ["footprint_path", slow("prb"), slow("path")],
)
@pytest.mark.parametrize("plugin", ["woven_lobes", "woven_neural"])
def test_derivatives_of_pictures_add_up_to_the_picture(
    plugin: str, integrator: str, capfd: pytest.CaptureFixture[str]
) -> None:
    """Light that scatters once is linear in albedos: Σ a ∂L/∂a is L (Euler)."""
    scene = picture_scene(plugin, integrator, 2)
    params = mi.traverse(scene)
    keys = [key for key in params.keys() if key.endswith(tuple(ALBEDOS))]  # noqa: SIM118 (no mapping)
    assert len(keys) == len(ALBEDOS)
    dr.enable_grad([params[key] for key in keys])
    params.update()
    capfd.readouterr()
    mean = dr.mean(mi.render(scene, params, spp=64, seed=1, seed_grad=2), axis=None)
    dr.backward(mean)
    total = sum(
        float((np.array(dr.grad(params[key])) * np.array(dr.detach(params[key]))).sum()) for key in keys
    )
    # Two sets of 4096 samples of a flat piece of cloth, whose value scatters by less than half.
    np.testing.assert_allclose(total, float(np.array(dr.detach(mean)).item()), rtol=4 * 0.5 / 64)
    printed = capfd.readouterr()
    assert "forcing" not in printed.out + printed.err, "Dr.Jit warns of every loop within symbolic calls"


@pytest.mark.slow
def test_point_through_path_prints_nothing(capfd: pytest.CaptureFixture[str]) -> None:
    scene = picture_scene("woven_point", "path", 3)
    params = mi.traverse(scene)
    (key,) = (key for key in params.keys() if key.endswith("warp.roughness"))  # noqa: SIM118 (no mapping)
    dr.enable_grad(params[key])
    params.update()
    capfd.readouterr()
    dr.backward(dr.mean(mi.render(scene, params, spp=2), axis=None))
    assert np.isfinite(np.array(dr.grad(params[key]))).all()
    printed = capfd.readouterr()
    assert printed.out + printed.err == ""


@pytest.mark.slow
def test_every_number_of_point_has_derivatives() -> None:
    bsdf = mi.load_dict({"type": "woven_point", **GREY})
    params = mi.traverse(bsdf)
    view = np.array([[0.2, 0.1, 1]]) / np.sqrt(1.05)
    si = interactions(np.random.default_rng(0).random((2000, 2)), np.tile(view, (2000, 1)), np.zeros(2000))
    wo = dr.normalize(mi.Vector3f(-0.3, 0.4, 0.8))

    def mean(key: str, value: float) -> float:
        before = type(params[key])(params[key])
        params[key] = before * 0 + value
        params.update()
        result = float(np.array(bsdf.eval(mi.BSDFContext(), si, wo)).mean())
        params[key] = before
        params.update()
        return result

    for key in (
        "warp.roughness",
        "warp.twist",
        "weft.specular_reflect",
        "warp.diffuse_reflect",
        "sheen.strength",
        "sheen.roughness",
    ):
        start, step = 0.4, 2e-3
        difference = (mean(key, start + step) - mean(key, start - step)) / (2 * step)
        before = type(params[key])(params[key])
        value = before * 0 + start
        dr.enable_grad(value)
        params[key] = value
        params.update()
        dr.backward(dr.mean(bsdf.eval(mi.BSDFContext(), si, wo), axis=None))
        gradient = float(np.array(dr.grad(params[key])).sum())
        params[key] = before
        params.update()
        # float32 differences of means over 2000 points.
        np.testing.assert_allclose(gradient, difference, rtol=0.02, atol=2e-4, err_msg=key)


@pytest.mark.slow
@pytest.mark.parametrize("plugin", ["woven_lobes", "woven_neural"])
def test_derivatives_that_there_are_none_of_are_refused(plugin: str) -> None:
    params = mi.traverse(mi.load_dict({"type": plugin, **SHEEN, "warp_color": "#c08040,#4060c0"}))
    for name in ("warp.roughness", "warp.albedos", "sheen.strength", "uv_size"):
        key = next(key for key in params.keys() if key.endswith(name))  # noqa: SIM118 (no mapping)
        dr.enable_grad(params[key])
        with pytest.raises(InputError, match=r"has no derivatives: .*diffuse_reflect.* woven_point"):
            params.update()
        assert not dr.grad_enabled(params[key])
        params.update()


def test_textures_of_models_that_filter_have_no_derivatives() -> None:
    texture = {"type": "bitmap", "bitmap": mi.Bitmap(np.full((4, 4, 3), 0.5, np.float32)), "raw": True}
    params = mi.traverse(mi.load_dict({"type": "woven_lobes", **SHEEN, "albedo": texture}))
    dr.enable_grad(params["albedo.data"])
    with pytest.raises(InputError, match=r"mine\.albedo has no derivatives"):
        params.update()
