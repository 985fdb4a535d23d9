"""What is baked, and what is not: edits of colours and roughness bake nothing.

Files, damaged and sound, tests/contract/test_model_files.py asks.
"""

from __future__ import annotations

import numpy as np

from loomlight.fabric import fabric_from_text
from loomlight.models.lobes.model import LobesModel
from tests.helpers.fabrics import STRESSING

from .cloths import prefiltered_parts, random_queries


def test_colours_and_roughness_are_not_baked() -> None:
    """So that edits of them bake nothing: the tables are the same, and the model's answers are not."""
    base = STRESSING["open plain"]
    plain = LobesModel.for_source(fabric_from_text(base))
    edited = LobesModel.for_source(
        fabric_from_text(base + '\n[warp]\nroughness = 0.9\ncolor = "#aa2211"\n[sheen]\nstrength = 0.5')
    )
    for key, values in plain.tables.arrays().items():
        assert np.array_equal(values, edited.tables.arrays()[key]), key
    queries = random_queries(plain.fabric, plain.tables.base_size, 100, seed=1)
    actual, other = (prefiltered_parts(model, queries)["specular_warp"] for model in (plain, edited))
    assert not np.allclose(actual, other, rtol=0.05)
