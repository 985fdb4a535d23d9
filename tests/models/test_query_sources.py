"""Answers to queries are registered from above.

Covers: models/query_sources.py, mitsuba/query_sources.py
"""

from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest

from loomlight.assets.merl import library_of
from loomlight.core.errors import InputError
from loomlight.models.neumip.btf import BTFS
from tests.limits import HANG

KINDS = """
import sys
from loomlight.models.latent.queries import REFLECTANCES
from loomlight.models.neumip.btf import BTFS
assert sorted(BTFS.kinds) == ["btf", "fabric"], BTFS.kinds
assert "mitsuba" not in sys.modules
import loomlight.mitsuba
assert sorted(BTFS.kinds) == ["btf", "fabric", "heightfield", "tile"], BTFS.kinds
assert sorted(REFLECTANCES.kinds) == ["fabric", "material", "merl"], REFLECTANCES.kinds
"""


def test_the_renderer_answers_once_it_is_imported() -> None:
    done = subprocess.run([sys.executable, "-c", KINDS], capture_output=True, text=True, timeout=HANG)
    assert done.returncode == 0, done.stderr


def test_a_kind_without_answers_is_refused_by_name() -> None:
    library = library_of("brass", ["brass"], np.zeros((1, 90, 90, 180, 3), np.float16))
    with pytest.raises(InputError, match="brass is a merl, of which neumip can take no queries: it takes"):
        BTFS.of(library)
