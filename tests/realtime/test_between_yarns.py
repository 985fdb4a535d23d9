"""Light between yarns in Slang against its Python twin, for `point` and `lobes`, with tints and sheen.

The bar is that of `parity.py`; a footprint or ray that meets the edge of a yarn may take the other side,
which rounding decides, so a few of the queries may differ.
"""

from __future__ import annotations

import numpy as np
import pytest
from drjit.llvm.ad import Float

from loomlight.core.backend import array_types
from loomlight.fabric import fabric_from_text
from loomlight.models.registry import make_model
from loomlight.scattering.point import Tint
from tests.helpers.arrays import vectors
from tests.helpers.parity import share_beyond
from tests.helpers.shader_cases import footprint_of, footprint_rows, packed
from tests.realtime.whole_queries import lobes_values, point_values

# Of queries.
MAX_FLIPS = 3e-3
TINT = (0.9, 0.5, 0.2)
FABRIC = """
weave = "satin 5"
interreflection = true
[warp]
color = ["#c03020", "#e0d0a0", "#203060"]
translucency = 0.3
[weft]
color = "#f0f0f0"
roughness = 0.5
[sheen]
strength = 0.4
"""


def tint() -> Tint:
    return Tint.of(array_types(Float).Color3(*TINT))


@pytest.mark.slow
@pytest.mark.parametrize("name", ["lobes", "point"])
def test_values_with_light_between_yarns(name: str) -> None:
    model = make_model(name, fabric_from_text(FABRIC))
    rows = footprint_rows(20_000, 5, seed=23)
    view, light, footprint = vectors(rows["view"]), vectors(rows["light"]), footprint_of(rows)
    rows |= {"x": rows["centre"][:, 0], "y": rows["centre"][:, 1]}
    found = (lobes_values if name == "lobes" else point_values)(rows, packed(model), TINT)
    value = np.array(model.at(view, footprint, tint=tint()).value(light))
    assert share_beyond(found[:, :3].T, value) <= MAX_FLIPS
    # It is there to be seen: the same without it is darker by far more than the bar.
    dark = make_model(name, fabric_from_text(FABRIC.replace("= true", "= false")))
    assert value.mean() > 1.02 * np.array(dark.at(view, footprint, tint=tint()).value(light)).mean()
