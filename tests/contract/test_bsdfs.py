"""The BSDFs of Mitsuba, of every model: they answer what the model does, one by one and all at once.

What models answer, test_models.py asks; edits of scene parameters are in test_bsdf_edits.py.

Covers: mitsuba/bsdf.py, mitsuba/props.py
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Float

from loomlight.core.backend import upload, upload_vector
from loomlight.core.footprint import Footprint
from loomlight.mitsuba import render
from loomlight.mitsuba.bsdf import SceneTraits
from loomlight.models.registry import MODELS
from tests.helpers import arrays
from tests.helpers.directions import unit_vectors
from tests.helpers.interactions import (
    TWILL,
    interactions,
    random_interactions,
    side_by_side,
    vectors,
    woven,
)
from tests.marks import slow

pytestmark = pytest.mark.usefixtures("variant", "narrow_network")
# Values and densities are the same arithmetic, in kernels put together differently.
RTOL = 2e-3
every_plugin = pytest.mark.parametrize("plugin", [entry.plugin for entry in MODELS.values()])
# Those that bake and compile quickly.
quick_plugins = pytest.mark.quick("woven_point", "woven_lobes", "woven_neural")


@pytest.mark.quick("woven_point", "woven_neural")
@every_plugin
def test_values_and_densities_are_those_of_the_model(plugin: str, tmp_path: Path) -> None:
    bsdf, count = woven(plugin, tmp_path), 2000
    si, uv, views, sides = random_interactions(count)
    lights = unit_vectors(np.random.default_rng(1), count)
    value, pdf = bsdf.eval_pdf(mi.BSDFContext(), si, vectors(lights))
    through = bsdf.eval_null_transmission(si)
    dr.eval(value, pdf, through)
    # 4 mm a unit of uv.
    side = arrays.floats(4 * sides)
    footprint = Footprint(arrays.pairs(4 * uv), Array2f(side, 0), Array2f(0, side))
    at = bsdf.model.at(arrays.vectors(views), bsdf.model.on_cloth(footprint))
    wanted, density = at.value_and_pdf(arrays.vectors(lights))
    hole = at.null_transmission + Float(0)
    dr.eval(hole, wanted, density)
    for found, expected in ((value, wanted), (pdf, density), (np.array(through)[0], hole)):
        # A ray of a few hundred meets another edge; single estimates differ with the points they take.
        near = np.isclose(np.array(found), np.array(expected), rtol=RTOL, atol=1e-5)
        assert near.mean() > 0.995, near.mean()
    assert np.array(wanted).max() > 0.01


@pytest.mark.quick("woven_neural-0.3")
@pytest.mark.parametrize("side", [0.02, 0.3])
@every_plugin
def test_weight_is_value_over_density(plugin: str, side: float, tmp_path: Path) -> None:
    bsdf, rng, count = woven(plugin, tmp_path, sheen_strength=0.4), np.random.default_rng(2), 4000
    si = interactions(rng.random((count, 2)), unit_vectors(rng, count), np.full(count, side))
    bs, weight = bsdf.sample(
        mi.BSDFContext(),
        si,
        upload(mi.Float, rng.random(count)),
        upload_vector(mi.Point2f, rng.random((2, count))),
    )
    dr.eval(bs, weight)
    found, pdf = bsdf.eval_pdf(mi.BSDFContext(), si, bs.wo)
    dr.eval(found, pdf)
    passes = np.array(mi.has_flag(bs.sampled_type, mi.BSDFFlags.Null))
    smooth = ~passes & (np.array(bs.pdf) > 0)
    # `latent` lets no light pass.
    assert (0 < passes.sum() < count / 2) == (plugin != "latent")
    np.testing.assert_allclose(np.array(pdf)[smooth], np.array(bs.pdf)[smooth], rtol=RTOL)
    product = np.array(weight * bs.pdf)[:, smooth]
    np.testing.assert_allclose(product, np.array(found)[:, smooth], rtol=5e-3, atol=1e-5)
    chance = np.array(bsdf.eval_null_transmission(si))[0]
    np.testing.assert_allclose(np.array(weight * bs.pdf)[0, passes], chance[passes], rtol=2e-3)
    np.testing.assert_allclose(np.array(bs.wo + si.wi)[:, passes], 0, atol=1e-6)


@pytest.mark.slow
@every_plugin
def test_all_at_once_is_each_alone(plugin: str, tmp_path: Path) -> None:
    """`eval_pdf_sample` against `eval`, `pdf` and `sample`; `eval_and_null_transmission` against both."""
    bsdf, rng, count, rtol = woven(plugin, tmp_path), np.random.default_rng(3), 1000, RTOL
    si, *_ = random_interactions(count)
    wo, lobe = vectors(unit_vectors(rng, count)), upload(mi.Float, rng.random(count))
    square = upload_vector(mi.Point2f, rng.random((2, count)))
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
    assert (np.array(through).max() > 0) == (plugin != "latent")


@pytest.mark.parametrize("view", [(0.9, 0.2, 0.4), slow((-0.6, 0.1, -0.5))], ids=str)
@pytest.mark.parametrize("plugin", ["woven_point", "woven_neural"])
def test_sampling_follows_its_density(plugin: str, view: tuple[float, float, float]) -> None:
    """Mitsuba's own test; for every model, without Mitsuba, it is in the contract."""
    bsdf = woven(plugin, weft_roughness=0.5, gap=0.0)
    direction = np.array(view) / np.linalg.norm(view)

    def prepared(count: int) -> Any:
        one = np.ones((count, 1))
        return interactions(0.37 * np.ones((count, 2)), one * direction, np.full(count, 0.05))

    def sample(u: Any) -> Any:
        bs, _ = bsdf.sample(mi.BSDFContext(), prepared(dr.width(u)), u.x, mi.Point2f(u.y, u.z))
        smooth = ~mi.has_flag(bs.sampled_type, mi.BSDFFlags.Null) & (bs.pdf > 0)
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


@pytest.mark.slow
@pytest.mark.parametrize("plugin", [slow("woven_lobes"), "woven_neural"])
def test_two_fabrics_in_one_picture_are_each_its_own(plugin: str) -> None:
    """Side by side both show what each shows alone, in symbolic calls where the model allows them."""
    first = {"type": plugin} | TWILL
    second = first | {"weave": "plain", "warp_color": "#ffffff", "weft_height_scale": 0.3}

    def picture(*shown: dict[str, Any]) -> np.ndarray:
        scene = side_by_side(*shown)
        assert SceneTraits.of(scene).symbolic == (plugin == "woven_lobes")
        return render(scene, spp=1, seed=7)

    both, alone = picture(first, second), [picture(cloth, cloth) for cloth in (first, second)]
    assert both[..., 0].max() > 0
    # Or each could show the other's picture.
    assert not np.allclose(*alone, rtol=0.05), "they look alike"
    for half, own in zip((np.s_[:, :16], np.s_[:, 16:]), alone, strict=True):
        np.testing.assert_allclose(both[half], own[half], rtol=1e-3, atol=1e-4)


@quick_plugins
@every_plugin
def test_a_view_that_is_no_direction_gives_nothing(plugin: str, tmp_path: Path) -> None:
    """Integrators ask for interactions with no surface too, whose `wi` is 0."""
    bsdf, count = woven(plugin, tmp_path), 64
    si = dr.zeros(mi.SurfaceInteraction3f, count)
    si.uv = mi.Point2f(np.random.default_rng(4).random((2, count), np.float32))
    two = mi.Point2f(np.random.default_rng(5).random((2, count), np.float32))
    value, pdf = bsdf.eval_pdf(mi.BSDFContext(), si, mi.Vector3f(0, 0, 1))
    bs, weight = bsdf.sample(mi.BSDFContext(), si, two.x, two)
    null = bsdf.eval_null_transmission(si)
    assert not np.any(np.concatenate([np.ravel(each) for each in (value, pdf, weight, null)]))
    assert np.isfinite(np.array(bs.wo)).all()


@pytest.mark.slow
def test_a_scene_asks_every_kind_of_bsdf_alike() -> None:
    """Ours, Mitsuba's own, ours within that, and one within an instance, which no list of shapes shows."""
    kinds = [TWILL | {"type": "woven_point"}, {"type": "twosided", "inner": {"type": "diffuse"}}]
    kinds.append({"type": "mask", "opacity": 0.6, "inner": kinds[0]})
    place = mi.ScalarTransform4f().translate
    spheres = {
        f"sphere{number}": {"type": "sphere", "center": [3 * number, 0, 0], "bsdf": bsdf}
        for number, bsdf in enumerate(kinds)
    }
    group = {"type": "shapegroup", "sphere": {"type": "sphere", "bsdf": kinds[0]}}
    copy = {"type": "instance", "to_world": place([9, 0, 0]), "group": {"type": "ref", "id": "group"}}
    scene = mi.load_dict({"type": "scene", **spheres, "group": group, "copy": copy})
    column, row = np.meshgrid(np.arange(4) * 3.0, np.linspace(-0.8, 0.8, 9))
    origin = mi.Point3f(column.ravel(), row.ravel(), 5)
    si = scene.ray_intersect(mi.Ray3f(origin, mi.Vector3f(0, 0, -1)))
    assert np.array(si.is_valid()).all()
    context, light, active = mi.BSDFContext(), dr.normalize(mi.Vector3f(0.3, -0.2, 0.9)), mi.Bool(True)
    traits = SceneTraits.of(scene)
    value, through = traits.eval_and_null_transmission(context, si, light, active, active)
    found = traits.eval_pdf_sample_and_null_transmission(
        context, si, light, mi.Float(0.4), mi.Point2f(0.3, 0.7), active, True
    )
    for actual, wanted in (
        (value, si.bsdf().eval(context, si, light)),
        (through, si.bsdf().eval_null_transmission(si)),
        (found[0], si.bsdf().eval(context, si, light)),
        (found[1], si.bsdf().pdf(context, si, light)),
    ):
        # The same arithmetic, in kernels put together differently.
        np.testing.assert_allclose(np.array(actual), np.array(wanted), rtol=2e-3, atol=1e-6)
    assert (np.array(value).reshape(3, 9, 4).max(axis=(0, 1)) > 0).all()
    assert (np.array(through)[0].reshape(9, 4).max(axis=0) > 0)[1:3].tolist() == [False, True]
    assert traits.holes
    assert SceneTraits.of(mi.load_dict({"type": "scene"})).holes is False
