"""Hairs cover what they say, hang over the cloth, have a colour of their own and cast shadows."""

from __future__ import annotations

from functools import cache

import drjit as dr
import numpy as np
import pytest
from drjit.llvm import Array2f, Array3f, Bool, Float
from numpy.typing import NDArray

from loomlight.core.backend import array_types
from loomlight.fabric import fabric_from_text
from loomlight.scattering import hairs
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.geometry import YarnGeometry

TYPES = array_types(Float)
CLOSE = 1e-4  # millimetres: everything shows
COUNT = 100_000
UP = (0.0, 0.0, 1.0)


@cache
def model_of(warp: float, weft: float) -> YarnScattering:
    fabric = fabric_from_text(
        f'weave = "twill 2/2"\n[warp]\ncolor = "#ff0000"\nhairiness = {warp}\n'
        f'[weft]\ncolor = "#0000ff"\nhairiness = {weft}\n'
    )
    return YarnScattering(YarnGeometry(fabric.layout()), fabric.appearance())


def places(count: int = COUNT) -> Array2f:
    rng = np.random.default_rng(7)
    return Array2f(*((200 * rng.random(count) - 100).astype(np.float32) for _ in range(2)))


def over(model: YarnScattering, place: Array2f, below: float = 0.0, size: float = CLOSE) -> hairs.Hairs:
    return hairs.Hairs(model.detail(TYPES), place, Float(below), Bool(False), Float(size))


def cover(found: hairs.Hair) -> NDArray[np.float64]:
    return np.array(found.cover, np.float64)


def test_hairs_cover_what_they_say() -> None:
    shares = {}
    for hairiness in (0.25, 1.0):
        model = model_of(hairiness, hairiness)
        close, wide = (
            cover(over(model, places(), size=size).seen(Array3f(UP))).mean() for size in (CLOSE, 0.02)
        )
        # A hair that is thinner than the footprint covers part of it: the same in the mean, but for fading.
        assert wide == pytest.approx(close, rel=0.25)
        shares[hairiness] = close
    # Hairs taper: four fifths of their width.
    length = 0.8 * (hairs.HAIR_MIN + hairs.HAIR_MAX)
    area = 2 * hairs.HAIR_HALF_WIDTH * length * hairs.HAIR_LAYERS / hairs.HAIR_CELL**2
    # Curves are longer than their chords, and hairs cross.
    assert shares[1.0] == pytest.approx(area, rel=0.2)
    assert shares[0.25] == pytest.approx(shares[1.0] / 4, rel=0.2)


def test_hairs_hang_over_the_cloth() -> None:
    """A ray passes the same hairs from wherever it meets the cloth below, and slides over it as it leans."""
    model, place, view = model_of(1, 1), places(), dr.normalize(Array3f(0.3, -0.2, 0.8))
    deep = 0.2
    lower = place - deep * Array2f(view.x, view.y) / view.z
    above, below = (cover(over(model, *at).seen(view)) for at in ((place, 0.0), (lower, deep)))
    # Places are rounded to 1e-5 mm, a hundredth of a hair.
    assert np.mean(np.abs(above - below) > 0.05) < 0.01
    straight = cover(over(model, place, deep).seen(Array3f(UP)))
    assert np.corrcoef(straight, cover(over(model, place, deep).seen(view)))[0, 1] < 0.2


def test_hairs_have_the_colour_of_their_family() -> None:
    model, place = model_of(1, 0), places()
    point = model.at(place.x, place.y, Bool(False), Bool(False), Float(CLOSE))
    bare = model.at(place.x, place.y, Bool(False), Bool(False))
    found, is_warp = np.array(point.albedos.diffuse_reflect), np.array(bare.is_warp)
    covered = np.array(point.hairs[1]) > 0.5
    assert 0.02 < covered[~is_warp].mean() < 0.2
    # What warp hairs cover is red, over the weft too.
    over_weft = covered & ~is_warp
    assert (found[0] > 10 * found[2])[over_weft].mean() > 0.99
    assert (found[2] > 10 * found[0])[~covered & ~is_warp].mean() > 0.9


def test_hairs_stand_in_the_light_and_cast_shadows() -> None:
    model, place = model_of(1, 1), places()
    light = dr.normalize(Array3f(0.4, 0.3, 0.7))
    lit = np.array(over(model, place).lit(light))
    # The widest shadow is as dark as a blurred hair covers.
    darkest = hairs.HAIR_SHADOW * 2 * hairs.HAIR_HALF_WIDTH / hairs.HAIR_BLUR
    assert lit.min() == pytest.approx(1 - darkest, abs=0.02)
    assert lit.max() == pytest.approx(1, abs=1e-6)
    point = model.at(place.x, place.y, Bool(False), Bool(False), Float(CLOSE))
    covered = np.array(point.hairs[1]) > 0.999
    assert covered.sum() > 500
    assert (np.array(point.under_hairs(light))[covered] > 0.999).all()
    # No yarn hides the light from what lies above all of them.
    assert np.array(model.visibility(point, light))[covered].mean() > 0.99


def test_hairs_fade() -> None:
    model = model_of(1, 1)
    far = over(model, places(1000), size=hairs.HAIR_CELL * model.fibre_size)
    assert cover(far.seen(Array3f(UP))).max() < 1e-6
    assert np.array(far.lit(Array3f(UP))).min() > 1 - 1e-6
