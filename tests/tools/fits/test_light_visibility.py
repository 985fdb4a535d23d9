"""Light visibility from the diffuse component, against slices of cloth.

Covers: models/neural/codings.py
"""

from __future__ import annotations

import numpy as np
import pytest
from drjit.llvm.ad import Array3f, Float

from loomlight.core.llvm import require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.models.neural.codings import FACING, light_visibility_of
from tools.fits.light_visibility import errors, measured, predicted

require_llvm()

CLOTHS = {
    "plain": 'weave = "plain"\n[warp]\ntranslucency = 0.0\n[weft]\ntranslucency = 0.0',
    "satin": 'weave = "satin 5/2"\n[warp]\ntranslucency = 0.0\n[weft]\ntranslucency = 0.0',
}


@pytest.mark.parametrize("name", CLOTHS)
def test_it_is_that_of_slices(name: str) -> None:
    nmae, bias = errors(measured(fabric_from_text(CLOTHS[name]), 1))
    # All footprints lit alike would be 0.25 and more off; ten held-out fabrics are within 0.095.
    assert nmae < 0.11
    assert abs(bias) < 0.06


def test_the_tool_fits_what_the_model_computes() -> None:
    rng = np.random.default_rng(1)
    light, view = (v / np.linalg.norm(v, axis=0) for v in rng.normal(size=(2, 3, 500)))
    diffuse = rng.uniform(0, 0.3, 500)
    actual = light_visibility_of(
        Float(diffuse.astype(np.float32)), *(Array3f(v.astype(np.float32)) for v in (light, view)), 0.5
    )
    np.testing.assert_allclose(actual.numpy(), predicted(FACING, diffuse, light.T, view.T, 0.5), rtol=2e-3)


def test_shadow_is_dark_and_a_flat_surface_is_lit() -> None:
    light = Array3f([0.6, 0.0], [0.0, 0.0], [0.8, 1.0])
    view = Array3f(0.0, 0.0, 1.0)
    assert (light_visibility_of(Float(0.0, 0.0), light, view, 0.5).numpy() == 0).all()
    # With w = 0 the diffuse term of lit points is cos θ_l/π whatever their normal.
    flat = light_visibility_of(Float(0.8, 1.0) / np.pi, light, view, 0.0)
    np.testing.assert_allclose(flat.numpy(), 1, rtol=1e-5)
