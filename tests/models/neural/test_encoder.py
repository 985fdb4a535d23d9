"""Inputs of the encoder; training/test_export.py compares its outputs."""

from __future__ import annotations

import numpy as np

from loomlight.core.llvm import require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.models.neural.encoding import shortest_repeat

require_llvm()


def test_colours_do_not_lengthen_the_repeat() -> None:
    striped = fabric_from_text(
        'weave = "twill 2/1"\n[warp]\ncolor = ["#ff0000", "#00ff00", "#0000ff", "#000000", "#ffffff"]'
    )
    assert striped.layout().warp_on_top.shape == (3, 15)
    short = shortest_repeat(striped.layout())
    np.testing.assert_array_equal(short.warp_on_top, fabric_from_text("twill 2/1").layout().warp_on_top)
    assert short.warp.spacing.shape == (3,)
