"""Fabrics outside what the network was trained for warn, naming the fields."""

from __future__ import annotations

import warnings
from pathlib import Path

import pytest
from drjit.llvm.ad import Float

from loomlight.core.errors import LoomlightWarning
from loomlight.core.llvm import require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.models.neural.encoding import encode
from loomlight.models.neural.weights import read_weights
from tests.helpers.neural_networks import network, weights_of, written

require_llvm()


def test_fabrics_outside_the_box_warn(runs: list[str], tmp_path: Path) -> None:
    weights = weights_of(network("field"), tmp_path)
    odd = fabric_from_text('weave = "plain"\ngap = 0.4\noptical_depth = 3.0\n[weft]\ntwist_deg = 60')
    with pytest.warns(
        LoomlightWarning, match=r"optical_depth = 3 \(2\), .*weft.twist_deg = 60 \(-45 to 45\)"
    ):
        encode(odd, weights, Float)


@pytest.mark.quick("varied-False")
@pytest.mark.parametrize(("layouts", "warned"), [("paper", True), ("varied", False)])
def test_layouts_warn_where_training_had_none(
    runs: list[str], tmp_path: Path, layouts: str, warned: bool
) -> None:
    recipe = {"data": {"layouts": layouts}}
    weights = read_weights(written(network("field"), tmp_path / "a.safetensors", recipe=recipe))
    cloth = fabric_from_text(
        'weave = "plain"\nends_per_cm = 30\npicks_per_cm = 18\n[warp]\ngap = 0.03\n[weft]\ngap = 0.5'
    )
    with warnings.catch_warnings(record=True) as actual:
        warnings.simplefilter("always")
        encode(cloth, weights, Float)
    said = " ".join(str(warning.message) for warning in actual)
    assert ("warp.gap = 0.03 (0.2)" in said) == warned
    assert ("ends per pick = 1.667 (1)" in said) == warned
