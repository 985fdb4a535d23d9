"""Slang functions against their Python twins on one set of arguments, then whole queries of the point model.

The bar is |a − b| ≤ 1e-5 + 1e-3·|b| (`parity.py`). Searches along rays decide by comparisons, so a few
queries in ten thousand fall on the other side of an edge; they are counted.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from drjit.llvm.ad import Float

from loomlight.scattering import diffuse, fibre, sheen
from loomlight.scattering.appearance import YarnDetail
from loomlight.scattering.irregularity import IrregularYarns
from loomlight.scattering.point import YarnScattering, to_face_frame
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout
from loomlight.yarn.stack import cloth_geometry
from loomlight.yarn.visibility import first_hit, unoccluded
from tests.helpers.arrays import vectors
from tests.helpers.directions import clear_of_the_plane
from tests.helpers.layouts import PLAIN, SATIN, TWILL, even_layout, layered_layout, random_layout
from tests.helpers.parity import appearance, irregular, places, share_beyond
from tests.helpers.slang import mapped
from tests.realtime.whole_queries import point_values

COUNT = 20_000
# Share of queries whose ray meets another edge, which rounding decides: most on a dense satin of 60°.
MAX_FLIPS = 1.5e-3

LAYOUTS = {
    "plain": even_layout(PLAIN),
    "twill": even_layout(TWILL),
    "satin": even_layout(SATIN, gap=0.1, inclination=60),
    "uneven": random_layout(np.random.default_rng(1), uneven=True),
    "closed": even_layout(TWILL, gap=0.0),
    # Two planes, two that change places, wefts that float on either face, and four planes.
    **{
        name: layered_layout(name)
        for name in ("double-plain", "pattern-double-weave", "extra-weft-figure", "four-layers")
    },
}
# Share of points of closed cloth whose slopes in the narrow gaps amplify rounding.
MAX_STEEP = 2e-4
layouts = pytest.mark.parametrize("layout", LAYOUTS.values(), ids=LAYOUTS)


def generator() -> np.random.Generator:
    return np.random.default_rng(22)


def test_exponential_and_logarithm() -> None:
    x = np.float32(np.linspace(-87, 88, COUNT))
    found = mapped("numbers", "", "exponential(x); natural_logarithm(exponential(abs(x)))", {"x": x})
    np.testing.assert_allclose(found[:, 0], np.exp(np.float64(x)), rtol=1e-6, atol=1e-37)
    # ln amplifies nothing: its error is that of the exponential, absolutely.
    np.testing.assert_allclose(found[:, 1], np.abs(x), rtol=1e-6, atol=1e-6)


def test_sines_and_powers() -> None:
    x = np.float32(np.linspace(-100, 100, COUNT))
    results = "sc.x; sc.y; arc_sine(x / 100.0); power(abs(x) + 0.01, 0.4)"
    found = mapped("numbers", "let sc = sine_cosine(x);", results, {"x": x})
    wide = np.float64(x)
    for column, expected in enumerate(
        (np.sin(wide), np.cos(wide), np.arcsin(wide / 100), (np.abs(wide) + 0.01) ** 0.4)
    ):
        # A few units in the last place of float32.
        np.testing.assert_allclose(found[:, column], expected, rtol=1e-6, atol=5e-7)


@pytest.mark.parametrize("side", [1, -1], ids=["reflection", "transmission"])
def test_fibre_layer(side: int) -> None:
    rng = generator()
    light, view, normal, tangent = (clear_of_the_plane(rng, COUNT) for _ in range(4))
    view *= np.sign(np.sum(view * normal, axis=1, keepdims=True))
    light *= side * np.sign(np.sum(light * normal, axis=1, keepdims=True))
    roughness = np.float32(rng.uniform(0.01, 1, COUNT))
    name = "reflection" if side > 0 else "transmission"
    arguments = {"light": light, "view": view, "normal": normal, "tangent": tangent, "roughness": roughness}
    found = mapped("fibre", "", f"{name}(light, view, normal, tangent, roughness, 2.0)", arguments)[:, 0]
    frame = (vectors(light), vectors(view), vectors(normal), vectors(tangent), Float(roughness), Float(2))
    expected = getattr(fibre, name)(*frame)
    assert found.min() >= 0
    assert share_beyond(found, expected) == 0


def test_diffuse_and_sheen() -> None:
    rng = generator()
    light, view, normal = (clear_of_the_plane(rng, COUNT) for _ in range(3))
    roughness = np.float32(rng.uniform(0, 1, COUNT))
    body = "let sheen = sheen_with_transmittance(light, view, 0.7, roughness);"
    results = "diffuse_reflection(light, normal, 0.3); sheen.x; sheen.y"
    arguments = {"light": light, "view": view, "normal": normal, "roughness": roughness}
    found = mapped("diffuse sheen", body, results, arguments)
    expected = diffuse.diffuse_reflection(vectors(light), vectors(normal), Float(0.3))
    assert share_beyond(found[:, 0], expected) == 0
    lobe = sheen.sheen_with_transmittance(vectors(light), vectors(view), Float(0.7), Float(roughness))
    assert share_beyond(found[:, 1], lobe[0]) == 0
    assert share_beyond(found[:, 2], lobe[1]) == 0


@layouts
def test_surface(layout: ClothLayout) -> None:
    rng = generator()
    at = places(rng, layout, COUNT)
    results = (
        "p.hole; p.is_warp; p.height; p.normal.x; p.normal.y; p.normal.z;"
        "p.tangent.x; p.tangent.y; p.tangent.z; p.across; p.fibre_across; p.fibre_along;"
        "p.warp_thread; p.weft_thread"
    )
    body = "let p = surface_at(fabric, x, y, back);"
    found = mapped("geometry", body, results, at.arguments(), (layout, appearance(rng, layout, False, False)))
    point = cloth_geometry(layout).surface(*at.arrays())
    hole = np.array(point.hole)
    np.testing.assert_array_equal(found[:, 0] > 0, hole)
    expected = [point.is_warp, point.height, *point.normal, *point.tangent, point.across]
    expected += [point.fibre_across, point.fibre_along, point.warp_thread, point.weft_thread]
    for column, values in enumerate(expected, start=1):
        share = share_beyond(found[~hole, column], np.array(values, np.float64)[~hole])
        # Threads of planes that change places lie side by side, as close.
        assert share <= (MAX_STEEP if layout is LAYOUTS["closed"] or layout.layers else 0), column


@pytest.mark.slow
@layouts
def test_view_and_shadow_rays(layout: ClothLayout) -> None:
    rng = generator()
    at = places(rng, layout, COUNT)
    view = clear_of_the_plane(rng, COUNT)
    view[:, 2] = np.abs(view[:, 2])
    body = (
        "let hit = first_hit(fabric, default_quality(), x, y, view, back);"
        "let point = surface_at(fabric, x, y, back);"
        "let free = unoccluded(fabric, default_quality(), x, y, point.height, view, back);"
    )
    arguments = at.arguments() | {"view": view}
    looks = (layout, appearance(rng, layout, False, False))
    results = "hit.x; hit.y; hit.height; hit.hole; free"
    found = mapped("visibility geometry search", body, results, arguments, looks)
    geometry = cloth_geometry(layout)
    x, y, back = at.arrays()
    hit = first_hit(geometry, x, y, vectors(view), back)
    surface = geometry.surface(x, y, back)
    free = unoccluded(geometry, x, y, surface.height, vectors(view), back)
    on_yarn = ~np.array(surface.hole)
    hole = np.array(hit.hole)
    assert np.mean((found[:, 3] > 0) != hole) <= MAX_FLIPS
    for column, values in enumerate((hit.x, hit.y, hit.height)):
        assert share_beyond(found[~hole, column], np.array(values)[~hole]) <= MAX_FLIPS
    assert np.mean(found[on_yarn, 4] != np.array(free)[on_yarn]) <= MAX_FLIPS


@pytest.mark.slow
def test_layers_behind_meet_what_a_yarn_lets_through() -> None:
    """Less comes through two layers than through all their yarns in one plane."""
    layout = LAYOUTS["double-plain"]
    rng = generator()
    looks = appearance(rng, layout, sheen=False, varies=False)
    at = places(rng, layout, COUNT)
    light, view = clear_of_the_plane(rng, COUNT), clear_of_the_plane(rng, COUNT)
    arguments = {"x": at.x, "y": at.y, "light": light, "view": view}
    through = light[:, 2] * view[:, 2] < 0
    stacked = point_values(arguments, (layout, looks))[through, :3].mean(axis=0)
    plane = replace(layout, layers=(), stacking=None)
    single = point_values(arguments, (plane, looks))[through, :3].mean(axis=0)
    assert (stacked < 0.7 * single).all()


@pytest.mark.quick("varied-twill")
@layouts
@pytest.mark.parametrize("varied", [False, True], ids=["alike", "varied"])
def test_queries_of_the_point_model(layout: ClothLayout, varied: bool) -> None:
    """f·cos and delta transmission of whole queries, reflection and transmission from both faces."""
    rng = generator()
    at = places(rng, layout, COUNT)
    light, view = clear_of_the_plane(rng, COUNT), clear_of_the_plane(rng, COUNT)
    looks = appearance(rng, layout, sheen=varied, varies=varied)
    arguments = {"x": at.x, "y": at.y, "light": light, "view": view}
    found = point_values(arguments, (layout, looks))
    model = YarnScattering(cloth_geometry(layout), looks)
    x, y, _ = at.arrays()
    point = model.locate(x, y, vectors(view))
    value = np.array(model.evaluate(point, vectors(light), vectors(view)))
    assert value.max() > 0.1
    assert share_beyond(found[:, :3].T, value) <= MAX_FLIPS
    assert share_beyond(found[:, 3], np.array(model.straight_through(point, vectors(view)))) <= MAX_FLIPS


@pytest.mark.slow
def test_queries_of_irregular_yarns() -> None:
    """Albedos of the thread that a point meets, which vary along it and have neps."""
    rng = generator()
    layout = LAYOUTS["uneven"]
    looks = irregular(appearance(rng, layout, sheen=True, varies=True))
    at = places(rng, layout, COUNT)
    light, view = clear_of_the_plane(rng, COUNT), clear_of_the_plane(rng, COUNT)
    arguments = {"x": at.x, "y": at.y, "light": light, "view": view}
    found = point_values(arguments, (layout, looks))
    geometry = YarnGeometry(layout)
    model = YarnScattering(geometry, looks, irregular=IrregularYarns(geometry, looks))
    x, y, _ = at.arrays()
    point = model.locate(x, y, vectors(view))
    value = np.array(model.evaluate(point, vectors(light), vectors(view)))
    even = YarnScattering(geometry, looks).locate(x, y, vectors(view))
    on_yarn = ~np.array(point.hole)
    red, even_red = (np.array(of.albedos.diffuse_reflect.x)[on_yarn] for of in (point, even))
    assert share_beyond(red, even_red) > 0.5
    assert share_beyond(found[on_yarn, 7], red) <= MAX_FLIPS
    assert share_beyond(found[:, :3].T, value) <= MAX_FLIPS


def test_view_from_behind_negates_z() -> None:
    view = clear_of_the_plane(generator(), 100)
    found = mapped("point", "let v = to_face_frame(view, true);", "v.x; v.y; v.z", {"view": view})
    np.testing.assert_array_equal(found.T, np.array(to_face_frame(vectors(view), True)))


@pytest.mark.slow
def test_queries_of_yarns_close_up() -> None:
    """Plies, fibres, slubs and hairs of both families, in footprints of a two-thousandth to two threads."""
    rng = generator()
    layout = LAYOUTS["uneven"]
    details = (
        YarnDetail(2, 0.4, 0.2, 0.7, 1, layout.warp.twist, float(layout.warp.width.mean())),
        YarnDetail(1, 0.0, 0.1, 0.0, 0.5, layout.weft.twist, float(layout.weft.width.mean())),
    )
    plain = appearance(rng, layout, False, True)
    looks = replace(
        plain, warp=replace(plain.warp, detail=details[0]), weft=replace(plain.weft, detail=details[1])
    )
    at = places(rng, layout, COUNT)
    light, view = clear_of_the_plane(rng, COUNT), clear_of_the_plane(rng, COUNT)
    side = np.float32(float(layout.warp.spacing.mean()) * np.exp(rng.uniform(np.log(5e-4), np.log(2), COUNT)))
    arguments = {"x": at.x, "y": at.y, "light": light, "view": view, "side": side}
    found = np.delete(point_values(arguments, (layout, looks)), 3, axis=1)
    model = YarnScattering(YarnGeometry(layout), looks)
    x, y, _ = at.arrays()
    point = model.locate(x, y, vectors(view), size=Float(side))
    value = np.array(model.evaluate(point, vectors(light), vectors(view)))
    expected = [*value, point.normal.x, point.normal.y, point.tangent.x, point.albedos.diffuse_reflect.x]
    on_yarn = ~np.array(point.hole)
    assert value.max() > 0.1
    for column, values in enumerate(expected[:3]):
        assert share_beyond(found[on_yarn, column], np.array(values)[on_yarn]) <= MAX_FLIPS, column
    # Positions are rounded to 1e-4 of a fibre, over which a frame turns by up to a thousandth.
    for column, values in enumerate(expected[3:], 3):
        assert np.mean(abs(found[on_yarn, column] - np.array(values)[on_yarn]) > 1e-3) <= MAX_FLIPS, column
