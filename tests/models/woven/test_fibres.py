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
from loomlight.models.woven.architecture import DENSITY_GAIN, DENSITY_SCALE, OPPOSITE
from loomlight.models.woven.fibres import Fibres
from loomlight.models.woven.model import WovenModel
from loomlight.models.woven.network import fibre_features
from loomlight.scattering.fibre import density
from loomlight.yarn.geometry import YarnGeometry

from .networks import unit_vectors

require_llvm()
_FIBRES = Fibres(twist=(-0.5, 0.3), roughness=(0.2, 0.7))


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
    wanted = np.where(point.is_warp.numpy()[:, None], along[0], along[1])
    np.testing.assert_allclose(point.tangent.numpy().T[:, :2], wanted, atol=1e-5)


def test_the_density_is_that_of_the_fibres_normals() -> None:
    rng = np.random.default_rng(3)
    light, view = unit_vectors(rng, 500), unit_vectors(rng, 500)
    half = light + view
    # Nearly opposite directions are kept finite by OPPOSITE, which moves them.
    kept = np.linalg.norm(half, axis=1) > 10 * np.sqrt(OPPOSITE)
    light, view, half = light[kept], view[kept], half[kept]
    half /= np.linalg.norm(half, axis=1, keepdims=True)
    face = np.broadcast_to(_FIBRES.face(False), (len(light), 2, 3))
    found = fibre_features(*map(torch.tensor, (light, view, face.copy())))[:, -2:].numpy()
    for family in (0, 1):
        x, y, roughness = face[0, family]
        tangent = Array3f(float(x), float(y), 0.0)
        exact = density(Array3f(half.T.copy()), tangent, Float(float(roughness))).numpy()
        # OPPOSITE takes up to 1 % of the squared cosine here, so 2 % of the density: a quarter of that.
        np.testing.assert_allclose(
            found[:, family], DENSITY_SCALE * np.log1p(DENSITY_GAIN * exact), atol=5e-3
        )


def test_mixed_fibres_lie_between() -> None:
    other = Fibres(twist=(0.5, 0.1), roughness=(0.8, 0.7))
    assert _FIBRES.mixed(other, 0).array() == pytest.approx(_FIBRES.array())
    assert _FIBRES.mixed(other, 1).array() == pytest.approx(other.array())
    middle = _FIBRES.mixed(other, 0.5)
    assert middle.twist == pytest.approx((0, 0.2), abs=1e-6)
    assert middle.roughness == pytest.approx((0.4, 0.7))
    # Beyond the others roughness stays one.
    assert _FIBRES.mixed(other, 3).roughness[0] == 1
    assert Fibres.from_array(_FIBRES.array()).array() == pytest.approx(_FIBRES.array())


def test_a_material_with_an_impossible_roughness_is_one_sentence() -> None:
    loom = WovenModel.for_fabric(fabric_from_text("plain")).to_loom()
    assert WovenModel.from_loom(loom).encoded.fibres == WovenModel.for_fabric(loom.fabric).encoded.fibres
    for roughness in (0.0, -0.5, 1.5):
        wrong = np.array([[0, 0], [0.3, roughness]], np.float32)
        with pytest.raises(InputError, match=r"model\.fibres has a roughness of"):
            WovenModel.from_loom(replace(loom, tensors={**loom.tensors, "fibres": wrong}))
