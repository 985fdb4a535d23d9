"""Points of cloth with footprints, as an integrator hands them to a BSDF, and what BSDFs make of them."""

from __future__ import annotations

from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np

from loomlight.mitsuba import render
from loomlight.mitsuba.scene_traits import is_symbolic


def unit(rng: np.random.Generator, count: int) -> np.ndarray:
    """Directions over the whole sphere [count, 3]."""
    vectors = rng.normal(size=(count, 3))
    return (vectors / np.linalg.norm(vectors, axis=1, keepdims=True)).astype(np.float32)


def vectors(values: np.ndarray) -> Any:
    """Rows [n, 3] as Mitsuba's vectors."""
    return mi.Vector3f(np.ascontiguousarray(values.T, np.float32))


def interactions(uv: np.ndarray, views: np.ndarray, sides: np.ndarray) -> Any:
    """Points of cloth in the identity frame; footprints are squares of these sides in uv."""
    count = len(uv)
    si = dr.zeros(mi.SurfaceInteraction3f, count)
    si.uv = mi.Point2f(np.ascontiguousarray(uv.T, np.float32))
    si.n = mi.Normal3f(0, 0, 1)
    si.sh_frame = mi.Frame3f(mi.Vector3f(1, 0, 0), mi.Vector3f(0, 1, 0), mi.Vector3f(0, 0, 1))
    si.dp_du, si.dp_dv = mi.Vector3f(1, 0, 0), mi.Vector3f(0, 1, 0)
    si.wi = vectors(views)
    si.t = mi.Float(1)
    side = mi.Float(sides.astype(np.float32))
    si.duv_dx, si.duv_dy = mi.Vector2f(side, 0), mi.Vector2f(0, side)
    return si


def random_interactions(count: int, seed: int = 0) -> tuple[Any, np.ndarray, np.ndarray, np.ndarray]:
    """Points, and what they are of: uv, views, and sides of 0.01 to 0.5."""
    rng = np.random.default_rng(seed)
    uv, views = rng.random((count, 2)), unit(rng, count)
    sides = np.exp(rng.uniform(np.log(0.01), np.log(0.5), count))
    return interactions(uv, views, sides), uv, views, sides


def side_by_side(*cloths: dict[str, Any]) -> Any:
    """A scene of squares of cloth beside each other, 16 by 16 pixels each, under one light."""
    width = len(cloths)
    pieces = {
        f"cloth {number}": {
            "type": "rectangle",
            "to_world": mi.ScalarTransform4f().translate([2.0 * number + 1 - width, 0, 0]),
            "bsdf": cloth,
        }
        for number, cloth in enumerate(cloths)
    }
    rest = {
        "type": "scene",
        "light": {"type": "directional", "direction": [0.3, -0.2, -1]},
        "sensor": {
            "type": "orthographic",
            "to_world": mi.ScalarTransform4f().look_at([0, 0, 5], [0, 0, 0], [0, 1, 0])
            @ mi.ScalarTransform4f().scale([width, 1, 1]),
            "film": {"type": "hdrfilm", "width": 16 * width, "height": 16, "rfilter": {"type": "box"}},
        },
    }
    return mi.load_dict(rest | pieces)


def mean_value(bsdf: Any) -> np.ndarray:
    """What 500 points give back of one light, in the mean [3]."""
    si, *_ = random_interactions(500, seed=4)
    return np.array(bsdf.eval(mi.BSDFContext(), si, mi.Vector3f(0.1, 0.2, 0.97))).mean(axis=1)


def halve_colours(bsdf: Any) -> None:
    """Edits a cloth with sheen: yarns give back and let through half, and a thousandth of sheen is left."""
    params = mi.traverse(bsdf)
    for family in ("warp", "weft"):
        for term in ("diffuse", "specular"):
            params[f"{family}.{term}_reflect"] *= 0.5
            params[f"{family}.{term}_transmit"] *= 0.5
    params["sheen.strength"] = 1e-3
    params.update()


def assert_threads_have_colours_to_edit(bsdf: Any) -> None:
    """For a cloth of three warp ends, each of another colour. Leaves them black."""
    params = mi.traverse(bsdf)
    albedos = np.array(params["warp.albedos"]).reshape(3, 4, 3)
    np.testing.assert_allclose(albedos[:, 0], bsdf.model.fabric.appearance().warp.diffuse_reflect, atol=1e-6)
    before = mean_value(bsdf)
    params["warp.albedos"] = mi.Float(np.zeros(36, np.float32))
    params.update()
    after = mean_value(bsdf)
    assert (after < before).all(), (before, after)


def assert_weight_is_value_over_density(
    bsdf: Any, side: float, *, density: float, value: float, through: float
) -> np.ndarray:
    """Of what is sampled at 4000 footprints of this side in uv.

    Args:
        density: relative tolerance of the density, against `pdf`.
        value: of the weight times it, against `eval`.
        through: of the chance of light that passes through, against `eval_null_transmission`.

    Returns:
        which samples pass through [4000].
    """
    rng, count = np.random.default_rng(2), 4000
    si = interactions(rng.random((count, 2)), unit(rng, count), np.full(count, side))
    bs, weight = bsdf.sample(
        mi.BSDFContext(), si, mi.Float(rng.random(count, np.float32)), mi.Point2f(rng.random((2, count)))
    )
    dr.eval(bs, weight)
    found, pdf = bsdf.eval_pdf(mi.BSDFContext(), si, bs.wo)
    dr.eval(found, pdf)
    passes = np.array(mi.has_flag(bs.sampled_type, mi.BSDFFlags.Null))
    np.testing.assert_allclose(np.array(pdf)[~passes], np.array(bs.pdf)[~passes], rtol=density)
    product = np.array(weight * bs.pdf)[:, ~passes]
    np.testing.assert_allclose(product, np.array(found)[:, ~passes], rtol=value, atol=1e-5)
    chance = np.array(bsdf.eval_null_transmission(si))[0]
    np.testing.assert_allclose(np.array(bs.pdf)[passes], chance[passes], rtol=through)
    np.testing.assert_allclose(np.array(bs.wo + si.wi)[:, passes], 0, atol=1e-6)
    return passes


def assert_all_at_once_is_each_alone(bsdf: Any, rtol: float) -> None:
    """`eval_pdf_sample` against `eval`, `pdf` and `sample`; `eval_and_null_transmission` against both.

    Args:
        rtol: relative tolerance of values and densities.
    """
    rng, count = np.random.default_rng(3), 1000
    si, *_ = random_interactions(count)
    wo, lobe = vectors(unit(rng, count)), mi.Float(rng.random(count, np.float32))
    square = mi.Point2f(rng.random((2, count)))
    context = mi.BSDFContext()
    value, pdf, bs, weight = bsdf.eval_pdf_sample(context, si, wo, lobe, square)
    alone, alone_weight = bsdf.sample(context, si, lobe, square)
    value_alone, pdf_alone = bsdf.eval(context, si, wo), bsdf.pdf(context, si, wo)
    dr.eval(value, pdf, bs, weight, alone, alone_weight, value_alone, pdf_alone)
    np.testing.assert_allclose(value, value_alone, rtol=rtol, atol=1e-3 * rtol)
    np.testing.assert_allclose(pdf, pdf_alone, rtol=rtol)
    np.testing.assert_allclose(bs.wo, alone.wo, atol=1e-5)
    np.testing.assert_allclose(weight, alone_weight, rtol=1e-3, atol=1e-5)
    active, entering = (mi.Bool(rng.random(count) < 0.7) for _ in range(2))
    value, through = bsdf.eval_and_null_transmission(context, si, wo, active, entering)
    value_alone, through_alone = bsdf.eval(context, si, wo, active), bsdf.eval_null_transmission(si, entering)
    dr.eval(value, through, value_alone, through_alone)
    np.testing.assert_allclose(value, value_alone, rtol=rtol, atol=1e-3 * rtol)
    # Close up holes alone are searched for in another way: of 1000 rays 3 at outlines end otherwise.
    alike = np.isclose(through, through_alone, rtol=rtol, atol=1e-6)
    assert alike.mean() > 0.99
    assert np.array(through).max() > 0


def assert_each_shows_its_own(first: dict[str, Any], second: dict[str, Any], *, symbolic: bool) -> None:
    """Two cloths side by side, which differ, show what each shows alone.

    Args:
        symbolic: whether calls are symbolic in these scenes.
    """

    def picture(*shown: dict[str, Any]) -> np.ndarray:
        scene = side_by_side(*shown)
        assert is_symbolic(scene) == symbolic
        return render(scene, spp=1, seed=7)

    both, alone = picture(first, second), [picture(cloth, cloth) for cloth in (first, second)]
    assert both[..., 0].max() > 0
    # Or each could show the other's picture.
    assert not np.allclose(*alone, rtol=0.05), "they look alike"
    for half, own in zip((np.s_[:, :16], np.s_[:, 16:]), alone, strict=True):
        np.testing.assert_allclose(both[half], own[half], rtol=1e-3, atol=1e-4)
