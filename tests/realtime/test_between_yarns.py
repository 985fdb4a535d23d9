"""Light between yarns in Slang against its Python twin, for `point` and `lobes`, with tints and sheen.

The bar is that of `queries.py`; a footprint or ray that meets the edge of a yarn may take the other side,
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
from tests.helpers.whole_queries import lobes_values, point_values
from tests.realtime.test_lobes import MAX_FLIPS, Queries

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
    model = make_model("lobes", fabric_from_text(FABRIC))
    queries = Queries(model)
    if name == "lobes":
        found = lobes_values(queries.arguments, queries.looks, TINT)
    else:
        model = make_model("point", model.fabric)
        found = point_values(queries.arguments, queries.looks, TINT)[:, :3]
    at = model.at(vectors(queries.view), queries.footprint, tint=tint())
    value = np.array(at.value(vectors(queries.light)))
    assert share_beyond(found.T, value) <= 3 * MAX_FLIPS
    # It is there to be seen: the same without it is darker by far more than the bar.
    dark = make_model(name, fabric_from_text(FABRIC.replace("= true", "= false")))
    assert (
        value.mean()
        > 1.02
        * np.array(
            dark.at(vectors(queries.view), queries.footprint, tint=tint()).value(vectors(queries.light))
        ).mean()
    )
