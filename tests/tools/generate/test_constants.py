"""Constants of shaders say where the tables lie that words hold.

Covers: tools/generate/shaders/constants.py, realtime/words.py
"""

from __future__ import annotations

import numpy as np

from loomlight.fabric import fabric_from_text
from loomlight.realtime.words import WordTable, add_block
from tools.generate.shaders.constants import first_words


def test_parts_of_openness_follow_each_other() -> None:
    offsets = first_words()
    openness = fabric_from_text('weave = "satin 5"\ninterreflection = true').appearance().openness
    assert openness is not None
    table = WordTable()
    assert add_block(openness, table) == 0
    numbers = table.words().view(np.float32)
    for name, first in offsets.items():
        array = getattr(openness, name.removeprefix("OPENNESS_").lower()).ravel()
        np.testing.assert_array_equal(numbers[first:][: array.size], array.astype(np.float32))
