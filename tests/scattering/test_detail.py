"""Detail of yarns: frames stay frames, means and the energy bound stay, what no pixel resolves is not drawn.

Covers: scattering/detail.py
"""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Array3f, Bool, Float, UInt32
from numpy.typing import NDArray

from loomlight.core.backend import array_types
from loomlight.fabric import fabric_from_text
from loomlight.scattering import detail
from loomlight.scattering.albedo import albedos_from_colour, layer_albedo_bound
from loomlight.scattering.appearance import Variation
from loomlight.scattering.point import YarnPoint, YarnScattering
from loomlight.scattering.variation import Gain, vary_albedos
from loomlight.yarn.geometry import YarnGeometry
from tests.helpers.arrays import vectors

TYPES = array_types(Float)
CLOSE = 1e-4  # millimetres: everything shows


def text_of(yarn: str, colour: str = "#806040") -> str:
    colours = f'[warp]\ncolor = "{colour}"\n[weft]\ncolor = "{colour}"\n'
    return f'weave = "twill 2/2"\nyarn = "{yarn}"\n{colours}'


@cache
def model_of(text: str) -> YarnScattering:
    fabric = fabric_from_text(text)
    return YarnScattering(YarnGeometry(fabric.layout()), fabric.appearance())


def places(rng: np.random.Generator, count: int) -> tuple[Float, Float]:
    x, y = (Float((200 * rng.random(count) - 100).astype(np.float32)) for _ in range(2))
    return x, y


def cosine_directions(rng: np.random.Generator, count: int) -> NDArray[np.float64]:
    u, azimuth = rng.random(count), 2 * math.pi * rng.random(count)
    return np.stack([np.sqrt(u) * np.cos(azimuth), np.sqrt(u) * np.sin(azimuth), np.sqrt(1 - u)], axis=1)


def test_without_detail_nothing_is_computed() -> None:
    model, (x, y) = model_of("twill 2/2"), places(np.random.default_rng(0), 10)
    assert not model.has_detail
    point = model.at(x, y, Bool(False), Bool(False), Float(CLOSE))
    assert point.surface_normal is None
    assert point.diffuse_gain is None


@pytest.mark.parametrize("back", [False, True])
def test_turned_frames_are_frames(back: bool) -> None:
    x, y = places(np.random.default_rng(1), 4000)
    point = model_of(text_of("wool")).at(x, y, Bool(back), Bool(False), Float(CLOSE))
    normal, tangent = point.normal.numpy(), point.tangent.numpy()
    for rows in (normal, tangent):
        np.testing.assert_allclose((rows**2).sum(axis=0), 1, atol=2e-6)
    assert np.abs((normal * tangent).sum(axis=0)).max() < 1e-5
    turned = np.degrees(np.arccos(np.clip((normal * point.surface_normal.numpy()).sum(axis=0), -1, 1)))
    # Plies reach 38°, fibres stray by 12° rms.
    assert 10 < np.sqrt((turned**2).mean()) < 30


def test_fibres_stray_by_their_deviation() -> None:
    """Of normals across the fibre and of fibres in the plane of the surface."""
    text = 'weave = "twill 2/2"\n[warp]\nfibre_tilt_deg = 4\n[weft]\nfibre_tilt_deg = 4\n'
    x, y = places(np.random.default_rng(2), 100_000)
    model = model_of(text)
    smooth, turned = (model.at(x, y, Bool(False), Bool(False), size) for size in (None, Float(CLOSE)))
    normal, tangent = smooth.normal.numpy(), smooth.tangent.numpy()
    across = np.cross(tangent, normal, axis=0)
    tilt = np.degrees(np.arcsin((turned.normal.numpy() * across).sum(axis=0)))
    turn = np.degrees(np.arcsin((turned.tangent.numpy() * across).sum(axis=0)))
    # Means of some thousands of bundles: a deviation of 4° over their root.
    assert abs(tilt.mean()) < 0.2
    assert abs(turn.mean()) < 0.2
    assert tilt.std() == pytest.approx(4, rel=0.05)
    # The wave along the yarn adds to the turn: slopes of ±1 differences of uniform numbers.
    wave = detail.WAVE_SHARE * math.sqrt(6 / 5 * 2 / 3)
    assert turn.std() == pytest.approx(4 * math.hypot(1, wave), rel=0.05)


def test_plies_are_as_many_as_they_should_be() -> None:
    """Along a crown grooves follow at the circumference over plies and tangent of the ply twist."""
    text = 'weave = "plain"\ngap = 0.2\n[warp]\nplies = 3\nply_twist_deg = 30\ntwist_deg = 12\n'
    model, width = model_of(text), 0.4
    y = np.linspace(0, 400, 400_001)
    surface = model.surface.surface(Float(np.full_like(y, 0.25)), Float(y.astype(np.float32)), Bool(False))
    offset = detail.ply_offset(model.detail(TYPES), surface, Bool(False)).numpy()
    seen = surface.is_warp.numpy()
    jumps = np.flatnonzero((np.abs(np.diff(offset)) > 1) & seen[1:] & seen[:-1])
    circumference = math.pi * width / math.sin(math.radians(80))
    expected = seen.mean() * 400 * 3 * math.tan(math.radians(30)) / circumference
    assert len(jumps) == pytest.approx(expected, rel=0.02)


@pytest.mark.quick("wool")
@pytest.mark.parametrize("yarn", ["mercerised cotton", "wool"])
def test_means_stay(yarn: str) -> None:
    """The same points with and without detail: a dome's mean moves by less than 1 %, and three deviations."""
    rng, count = np.random.default_rng(3), 40_000
    model, (x, y) = model_of(text_of(yarn)), places(rng, count)
    view, light = vectors(np.tile([0.1, 0.05, 0.9937], (count, 1))), vectors(cosine_directions(rng, count))
    values = []
    for size in (None, Float(CLOSE)):
        point = model.locate(x, y, view, size=size)
        values.append((model.evaluate(point, light, view) / light.z).numpy().mean(axis=0))
    difference = (values[1] - values[0]) / values[0].mean()
    assert abs(difference.mean()) < 0.01 + 3 * difference.std() / math.sqrt(count)


def test_no_point_makes_light() -> None:
    """Points of the whitest cloth under a dome, without shadows, which only take light away."""

    class Unshadowed(YarnScattering):
        def visibility(self, point: YarnPoint, light: Array3f, active: Bool = True) -> Bool:
            return Bool(active) | True

    rng, points, lights = np.random.default_rng(4), 48, 2048
    white = text_of("wool", "#ffffff").replace("[weft]", "translucency = 0\nfibre_tilt_deg = 30\n[weft]")
    fabric = fabric_from_text(f"interreflection = false\n{white}")
    model = Unshadowed(YarnGeometry(fabric.layout()), fabric.appearance())
    x, y = (dr.repeat(value, lights) for value in places(rng, points))
    view = vectors(np.repeat(cosine_directions(rng, points), lights, axis=0))
    facing = cosine_directions(rng, points * lights)
    total = np.zeros((points, lights))
    point = model.locate(x, y, view, size=Float(CLOSE))
    for sign in (1, -1):
        light = vectors(facing * [1, 1, sign])
        value = model.evaluate(point, light, view) * dr.rcp(abs(light.z)) * math.pi
        total += value.numpy().max(axis=0).reshape(points, lights)
    returned, deviation = total.mean(axis=1), total.std(axis=1) / math.sqrt(lights)
    assert (returned < 1 + 4 * deviation).all()
    assert returned.max() > 0.85


def test_gains_have_mean_one_and_room() -> None:
    fabric = replace(fabric_from_text(text_of("linen")).appearance(), variation=Variation(seed=9))
    count = 200_000
    x, y = places(np.random.default_rng(5), count)
    model = YarnScattering(model_of(text_of("linen")).surface, fabric)
    surface = model.surface.surface(x, y, Bool(False))
    thread = model.thread_number(surface)
    gain = detail.detail_gain(model.detail(TYPES), surface, Bool(False), thread, Float(CLOSE))
    excess, largest = gain.excess.numpy(), gain.largest.numpy()
    assert abs(excess.mean()) < 0.01
    assert (excess <= largest + 1e-6).all()
    assert excess.min() > -1


def test_white_yarns_keep_their_mean() -> None:
    """Where a gain has no room it is flattened on both sides, not cut on one."""
    count, bound = 10_000, layer_albedo_bound(2.0)
    excess = np.linspace(-0.5, 0.5, count, dtype=np.float32)
    gain = Gain(Float(excess), Float(0.5))
    for colour in (0.3, 0.8, 1.0):
        rows = albedos_from_colour(np.full((1, 3), colour), 0.4, 0.2)
        albedos = tuple(Array3f(*map(float, row[0])) for row in rows)
        varied = vary_albedos(albedos, UInt32(3), UInt32(5), (Float(0), Float(0), UInt32(1), bound), gain)
        diffuse = (varied[0] + varied[1]).x.numpy()
        before = float(rows[0][0, 0] + rows[1][0, 0])
        assert diffuse.mean() == pytest.approx(before, rel=1e-4)
        assert diffuse.max() <= 1 - bound * rows[2][0, 0] + 1e-6


@pytest.mark.parametrize("yarn", ["mercerised cotton", "wool"])
def test_what_a_pixel_cannot_resolve_is_not_drawn(yarn: str) -> None:
    x, y = places(np.random.default_rng(6), 500)
    model = model_of(text_of(yarn))
    smooth = model.at(x, y, Bool(False), Bool(False))
    far = model.at(x, y, Bool(False), Bool(False), Float(20.0))
    np.testing.assert_allclose(far.normal.numpy(), smooth.normal.numpy(), atol=1e-6)
    np.testing.assert_allclose(far.tangent.numpy(), smooth.tangent.numpy(), atol=2e-6)
    np.testing.assert_allclose(far.diffuse_gain.numpy(), 1, atol=1e-6)
    np.testing.assert_allclose(
        far.albedos.diffuse_reflect.numpy(), smooth.albedos.diffuse_reflect.numpy(), rtol=1e-5
    )
