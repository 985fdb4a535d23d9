"""The plugin of all models: samples, answers given at once, bakings of edits, and pictures of two cloths.

Covers: mitsuba/bsdf.py, mitsuba/props.py
"""

from __future__ import annotations

from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.mitsuba import render
from loomlight.mitsuba.bsdf import SceneTraits
from loomlight.models.lobes import model as lobes_model
from loomlight.models.neural import encoding
from tests.helpers.directions import unit_vectors
from tests.helpers.interactions import interactions, mean_value, random_interactions, side_by_side, vectors
from tests.marks import slow

pytestmark = pytest.mark.usefixtures("narrow_network")
TWILL = {
    "weave": "twill 2/1",
    "warp_color": "#c08040",
    "weft_color": "#4060c0",
    "warp_translucency": 0.3,
    "gap": 0.2,
    "uv_size": "4,4",
}
# Relative tolerances of values and densities: the same arithmetic, in kernels put together differently.
TOLERANCES = {"woven_point": 2e-3, "woven_lobes": 2e-3, "woven_neural": 1e-3}
every_plugin = pytest.mark.parametrize("plugin", TOLERANCES)


def woven(plugin: str, **parameters: Any) -> Any:
    return mi.load_dict({"type": plugin} | TWILL | parameters)


@pytest.fixture
def bakings(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Names of what was baked or encoded, in order."""
    found: list[str] = []

    def count(module: Any, name: str) -> None:
        bake = getattr(module, name)
        monkeypatch.setattr(module, name, lambda *arguments: (found.append(name), bake(*arguments))[1])

    count(lobes_model, "bake_tables")
    count(encoding, "run_encoder")
    return found


@pytest.mark.quick("woven_neural-0.3")
@pytest.mark.parametrize("side", [0.02, 0.3])
@every_plugin
def test_weight_is_value_over_density(plugin: str, side: float) -> None:
    bsdf, rng, count = woven(plugin, sheen_strength=0.4), np.random.default_rng(2), 4000
    si = interactions(rng.random((count, 2)), unit_vectors(rng, count), np.full(count, side))
    bs, weight = bsdf.sample(
        mi.BSDFContext(), si, mi.Float(rng.random(count, np.float32)), mi.Point2f(rng.random((2, count)))
    )
    dr.eval(bs, weight)
    found, pdf = bsdf.eval_pdf(mi.BSDFContext(), si, bs.wo)
    dr.eval(found, pdf)
    passes = np.array(mi.has_flag(bs.sampled_type, mi.BSDFFlags.Null))
    smooth = ~passes & (np.array(bs.pdf) > 0)
    assert 0 < passes.sum() < count / 2
    np.testing.assert_allclose(np.array(pdf)[smooth], np.array(bs.pdf)[smooth], rtol=TOLERANCES[plugin])
    product = np.array(weight * bs.pdf)[:, smooth]
    np.testing.assert_allclose(product, np.array(found)[:, smooth], rtol=5e-3, atol=1e-5)
    chance = np.array(bsdf.eval_null_transmission(si))[0]
    np.testing.assert_allclose(np.array(bs.pdf)[passes], chance[passes], rtol=1e-3)
    np.testing.assert_allclose(np.array(bs.wo + si.wi)[:, passes], 0, atol=1e-6)


@pytest.mark.slow
@every_plugin
def test_all_at_once_is_each_alone(plugin: str) -> None:
    """`eval_pdf_sample` against `eval`, `pdf` and `sample`; `eval_and_null_transmission` against both."""
    bsdf, rng, count, rtol = woven(plugin), np.random.default_rng(3), 1000, TOLERANCES[plugin]
    si, *_ = random_interactions(count)
    wo, lobe = vectors(unit_vectors(rng, count)), mi.Float(rng.random(count, np.float32))
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


@pytest.mark.quick("woven_neural")
@every_plugin
def test_colours_and_sheen_bake_nothing(plugin: str, bakings: list[str]) -> None:
    # Light between yarns is no multiple of albedos, and is left out.
    bsdf = woven(plugin, sheen_strength=0.3, interreflection=False)
    before, made = mean_value(bsdf), len(bakings)
    params = mi.traverse(bsdf)
    for family in ("warp", "weft"):
        for term in ("diffuse", "specular"):
            params[f"{family}.{term}_reflect"] *= 0.5
            params[f"{family}.{term}_transmit"] *= 0.5
    params["sheen.strength"] = 1e-3
    params.update()
    halved = mean_value(bsdf)
    assert len(bakings) == made
    assert (halved < before).all()
    # What is left of the sheen takes and adds a thousandth.
    np.testing.assert_allclose(halved, 0.5 * mean_value(woven(plugin, interreflection=False)), rtol=5e-3)


@pytest.mark.slow
@every_plugin
def test_editing_yarns_is_the_fabric_of_those_yarns(plugin: str, bakings: list[str]) -> None:
    # With light between yarns the albedos of a colour depend on the yarns, and edits of yarns keep albedos.
    single = {"interreflection": False}
    bsdf = woven(plugin, **single)
    params, made = mi.traverse(bsdf), len(bakings)
    params["warp.roughness"] = 0.7
    params["weft.twist"] = float(np.radians(20))
    params["weft.height_scale"] = 0.5
    params.update()
    assert len(bakings) == 2 * made
    wanted = woven(plugin, warp_roughness=0.7, weft_twist_deg=20.0, weft_height_scale=0.5, **single)
    np.testing.assert_allclose(mean_value(bsdf), mean_value(wanted), rtol=1e-4)
    assert np.abs(mean_value(bsdf) / mean_value(woven(plugin, **single)) - 1).max() > 5e-4
    params["warp.roughness"] = 7.0
    with pytest.raises(InputError, match=r"warp\.roughness"):
        params.update()


@every_plugin
def test_colours_thread_by_thread(plugin: str, bakings: list[str]) -> None:
    bsdf = woven(plugin, warp_color="#ff0000,#00ff00,#0000ff")
    params, made = mi.traverse(bsdf), len(bakings)
    # Four albedos a thread, of three numbers or of four, the last of which fills an aligned load.
    table = np.array(params["warp.albedos"])
    albedos = table.reshape(3, 4, -1)[..., :3]
    np.testing.assert_allclose(albedos[:, 0], bsdf.model.fabric.appearance().warp.diffuse_reflect, atol=1e-6)
    before = mean_value(bsdf)
    params["warp.albedos"] = mi.Float(np.zeros(len(table), np.float32))
    params.update()
    assert (mean_value(bsdf) < before).all()
    assert len(bakings) == made


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


@every_plugin
def test_a_view_that_is_no_direction_gives_nothing(plugin: str) -> None:
    """Integrators ask for interactions with no surface too, whose `wi` is 0."""
    bsdf, count = woven(plugin), 64
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
