"""Encoding of fabrics, refusals, and common repeats.

Covers: models/neural/encoded_fabric.py
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from drjit.llvm.ad import Float

from loomlight.core.errors import InputError
from loomlight.core.llvm import require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.models.neural.encoding import encode, encode_pair
from tests.helpers.neural_networks import network, weights_of

require_llvm()


def test_large_repeats_are_refused(tmp_path: Path) -> None:
    weights = weights_of(network("field"), tmp_path)
    large = fabric_from_text('weave = "satin 67"')
    with pytest.raises(InputError, match=r'67 ends × 67 picks .* up to 64 a side: use the model "point"'):
        encode(large, weights, Float)


def test_latents_are_mixed_on_a_common_repeat(runs: list[str], tmp_path: Path) -> None:
    weights = weights_of(network("field"), tmp_path)
    plain, twill = fabric_from_text("plain"), fabric_from_text("twill 2/1")
    one, other = encode_pair(plain, twill, weights, Float)
    assert (one.picks, one.ends) == (other.picks, other.ends) == (6, 6)
    # Laid side by side, a repeat's finest latents are its own.
    own = encode(plain, weights, Float).faces[0][: 16 * 16].reshape(16, 16, 64)
    laid = one.faces[0][: 48 * 48].reshape(48, 48, 64)
    np.testing.assert_allclose(laid, np.tile(own, (3, 3, 1)), atol=2e-3)  # half precision
    np.testing.assert_array_equal(one.mixed(other, 0.0).faces[0], one.faces[0])
    beyond = one.mixed(other, 1.5).faces[0].astype(np.float64)
    expected = 1.5 * other.faces[0].astype(np.float64) - 0.5 * one.faces[0].astype(np.float64)
    np.testing.assert_allclose(beyond, expected, atol=2e-3 * np.abs(expected).max())
    with pytest.raises(InputError, match="common repeat of 77 ends × 77 picks"):
        encode_pair(fabric_from_text("satin 7"), fabric_from_text("satin 11"), weights, Float)
