"""Directions along the fibres: those of the yarns, from either face, and the density of their normals."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import torch
from drjit.llvm.ad import Array3f, Bool, Float

from loomlight import fabric_from_text
from loomlight.core.errors import InputError
from loomlight.core.llvm import require_llvm
from loomlight.models.neural.architecture import (
    BUNDLE_POSITIONS,
    BUNDLES,
    DENSITY_GAIN,
    DENSITY_SCALE,
    OPPOSITE,
)
from loomlight.models.neural.codings import _mirrored
from loomlight.models.neural.encoded_fabric import Fibres
from loomlight.models.neural.model import NeuralModel
from loomlight.scattering.fibre import density
from loomlight.yarn.geometry import YarnGeometry
from studies.papers.chen2024.training.network import fibre_features
from tests.helpers.directions import unit_vectors

require_llvm()
_FIBRES = Fibres(twist=(-0.5, 0.3), roughness=(0.2, 0.7), inclination=(0.3, 0.6), height_scale=(1.0, 0.5))


@pytest.mark.parametrize("back", [False, True])
def test_fibres_on_a_crown_are_the_yarns(back: bool) -> None:
    fabric = fabric_from_text(
        'weave = "plain"\n[warp]\ntwist_deg = 25\n[weft]\ntwist_deg = -40\n', folder="."
    )
    geometry = YarnGeometry(fabric.layout())
    width, height = fabric.layout().size
    # Middles of the crossings of a plain weave: two show the warp, two the weft.
    x, y = (
        part.ravel() for part in np.meshgrid([0.25 * width, 0.75 * width], [0.25 * height, 0.75 * height])
    )
    point = geometry.surface(Float(x), Float(y), Bool([back] * 4))
    along = Fibres.of(fabric).face(back)[:, :2]
    expected = np.where(point.is_warp.numpy()[:, None], along[0], along[1])
    np.testing.assert_allclose(point.tangent.numpy().T[:, :2], expected, atol=1e-5)


def test_the_density_is_that_of_the_fibres_normals() -> None:
    rng = np.random.default_rng(3)
    light, view = unit_vectors(rng, 500), unit_vectors(rng, 500)
    half = light + view
    # Nearly opposite directions are kept finite by OPPOSITE, which moves them.
    kept = np.linalg.norm(half, axis=1) > 10 * np.sqrt(OPPOSITE)
    light, view, half = light[kept], view[kept], half[kept]
    half /= np.linalg.norm(half, axis=1, keepdims=True)
    face = np.broadcast_to(_FIBRES.face(False), (len(light), 2, 3))
    actual = fibre_features(*map(torch.tensor, (light, view, face.copy())))[:, -2:].numpy()
    for family in (0, 1):
        x, y, roughness = face[0, family]
        tangent = Array3f(float(x), float(y), 0.0)
        exact = density(Array3f(half.T.copy()), tangent, Float(float(roughness))).numpy()
        # OPPOSITE takes up to 1 % of the squared cosine here, so 2 % of the density: a quarter of that.
        np.testing.assert_allclose(
            actual[:, family], DENSITY_SCALE * np.log1p(DENSITY_GAIN * exact), atol=5e-3
        )


def test_bundles_are_as_the_fibres_of_a_yarn() -> None:
    fabric = fabric_from_text(
        'weave = "satin 5/2"\ngap = 0.02\n'
        "[warp]\ninclination_deg = 25\ntwist_deg = 20\nheight_scale = 0.7\n"
        "[weft]\ninclination_deg = 40\ntwist_deg = -10\n",
        folder=".",
    )
    x, y = (
        part.ravel() for part in np.meshgrid(*(np.linspace(0, side, 101) for side in fabric.layout().size))
    )
    for back in (False, True):
        point = YarnGeometry(fabric.layout()).surface(Float(x), Float(y), Bool([back] * len(x)))
        solid = ~point.hole.numpy()
        tangents, is_warp = point.tangent.numpy().T[solid], point.is_warp.numpy()[solid]
        for family, shown in ((0, is_warp), (1, ~is_warp)):
            axes = Fibres.of(fabric).bundles(back)[family, :-1, :3].copy()
            axes /= np.linalg.norm(axes, axis=1, keepdims=True)
            sines = np.linalg.norm(np.cross(tangents[shown][:, None], axes), axis=2)
            # All but what dives between floats: half of what lies between places, 0.22 for the warp, beside
            # edges, and half of what lies between slopes, 0.1.
            assert np.percentile(sines.min(axis=1), 85) < 0.25, (family, back)
            assert np.median(sines.min(axis=1)) < 0.1
            # Each is the nearest of some fibres.
            assert len(np.unique(sines.argmin(axis=1))) == len(axes)


def test_bundles_of_the_back_are_those_of_the_front_mirrored() -> None:
    front, back = _FIBRES.bundles(False), _FIBRES.bundles(True)
    mirrored = [_mirrored(number) for number in range(BUNDLES)]
    for family, across in ((0, [-1, 1, 1, 1]), (1, [1, -1, 1, 1])):
        np.testing.assert_allclose(back[family][mirrored], front[family] * across, atol=1e-6)


def test_bundles_of_straight_fibres_have_their_density() -> None:
    rng = np.random.default_rng(4)
    half = unit_vectors(rng, 500)
    straight = Fibres(twist=(0.3, 0.0), roughness=(0.1, 1.0), inclination=(0, 0), height_scale=(0.01, 1))
    actual = 1 / np.square(
        straight.bundles(False)[..., None, 3]
        + np.square(np.einsum("fbc,nc->fbn", straight.bundles(False)[..., :3], half))
    )
    x, y, roughness = straight.face(False)[0]
    exact = density(Array3f(half.T.copy()), Array3f(float(x), float(y), 0.0), Float(float(roughness)))
    # The middle place of every slope: those are at most 3 % steep here, and heights a hundredth of that.
    for number in range(BUNDLE_POSITIONS // 2, BUNDLES - 1, BUNDLE_POSITIONS):
        np.testing.assert_allclose(actual[0, number], exact.numpy(), rtol=0.02)
    # Entirely rough fibres scatter alike in all directions; the last of each family always does.
    np.testing.assert_allclose(actual[1, :-1], 1 / np.pi, rtol=1e-5)
    np.testing.assert_allclose(actual[:, -1], 1, rtol=1e-6)


def test_mixed_fibres_lie_between() -> None:
    other = Fibres((0.5, 0.1), (0.8, 0.7), (0.1, 0.6), (0.4, 0.5))
    assert _FIBRES.mixed(other, 0).array() == pytest.approx(_FIBRES.array())
    assert _FIBRES.mixed(other, 1).array() == pytest.approx(other.array())
    middle = _FIBRES.mixed(other, 0.5)
    assert middle.twist == pytest.approx((0, 0.2), abs=1e-6)
    assert middle.roughness == pytest.approx((0.4, 0.7))
    assert middle.inclination == pytest.approx((0.2, 0.6))
    assert middle.height_scale == pytest.approx((0.7, 0.5))
    # Beyond the others they stay what fibres can be.
    beyond = _FIBRES.mixed(other, 3)
    assert (beyond.roughness[0], beyond.inclination[0]) == (1, 0)
    assert beyond.height_scale[0] == pytest.approx(0.01)
    assert beyond.validation_error() is None
    assert Fibres.from_array(_FIBRES.array()).array() == pytest.approx(_FIBRES.array())


def test_a_material_with_impossible_fibres_is_one_sentence() -> None:
    loom = NeuralModel.for_source(fabric_from_text("plain")).to_loom()
    assert NeuralModel.from_loom(loom).encoded.fibres == NeuralModel.for_source(loom.source).encoded.fibres
    for row, name, wrong in (
        (1, "roughness", 0.0),
        (1, "roughness", 1.5),
        (2, "inclination", 1.5),
        (3, "height_scale", -0.2),
    ):
        numbers = loom.tensors["fibres"].copy()
        numbers[row, 1] = wrong
        with pytest.raises(
            InputError, match=rf"model\.fibres is out of range, as {name} is .* and {wrong:g}: both should be"
        ):
            NeuralModel.from_loom(replace(loom, tensors={**loom.tensors, "fibres": numbers}))


def test_one_lobe_covers_the_basis() -> None:
    """Straight flat fibres keep their roughness; slopes and twist widen it, never beyond 1."""
    flat = Fibres((0.0, 0.0), (0.2, 0.3), (0.0, 0.0), (0.01, 0.01))
    np.testing.assert_allclose(flat.lobe_roughness(), (0.2, 0.3), atol=0.01)
    steep = Fibres((0.0, 0.4), (0.2, 0.3), (0.5, 0.5), (1.0, 1.0))
    warp, weft = steep.lobe_roughness()
    assert 0.3 < warp < weft <= 1
