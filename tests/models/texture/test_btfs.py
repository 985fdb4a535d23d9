"""What answers queries is listed in the registry, and imported when it is asked for.

Covers: models/registry.py, models/texture/btfs.py
"""

from __future__ import annotations

import subprocess
import sys
from importlib import import_module

import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.models.registry import BTFS, MODELS, btf_of
from loomlight.models.texture.queries import Btf, EncodedBtf
from loomlight.sources.kinds import SOURCE_KINDS
from loomlight.sources.merl import library_of
from tests.limits import HANG

ANSWERS = """
import sys
import numpy as np
from loomlight.sources.heightfield import Heightfield
from loomlight.fabric import fabric_from_text
from loomlight.models.registry import btf_of
btf_of(fabric_from_text('weave = "plain"'), "neumip")
assert "mitsuba" not in sys.modules
flat, grey = np.zeros((2, 2), np.float32), np.full((2, 2), 0.5, np.float32)
relief = Heightfield("flat", (1.0, 1.0), 0.1, 0.5, flat, np.full((2, 2, 3), 0.5, np.float32), grey, flat)
assert btf_of(relief, "neumip").extent == (1.0, 1.0)
assert "mitsuba" in sys.modules
"""


def test_a_renderer_is_imported_for_the_sources_that_need_one() -> None:
    done = subprocess.run([sys.executable, "-c", ANSWERS], capture_output=True, text=True, timeout=HANG)
    assert done.returncode == 0, done.stderr


def test_what_the_registry_names_exists() -> None:
    assert BTFS.keys() <= SOURCE_KINDS.keys()
    for entry in BTFS.values():
        found = getattr(import_module(entry.module), entry.class_name)
        assert issubclass(found, EncodedBtf if "latent" in entry.models else Btf)
        assert set(entry.models) <= MODELS.keys()


def test_a_kind_without_answers_is_refused_by_name() -> None:
    library = library_of("brass", ["brass"], np.zeros((1, 90, 90, 180, 3), np.float16))
    says = "of which neumip can take no queries: it takes those of fabric, heightfield, tile, btf."
    with pytest.raises(InputError, match=f"brass is a merl, {says}"):
        btf_of(library, "neumip")
