"""What README and the doctor say of extras is what the package's metadata says.

Covers: core/extras.py
"""

from __future__ import annotations

import re
from importlib.metadata import metadata
from pathlib import Path

from loomlight.core.extras import EXTRAS, required_packages

README = Path(__file__).parents[2] / "README.md"
_ROW = re.compile(r"^\| `loomlight\[(\w+)\]` \| ([^|]+) \| (\d+) \| ([^|]+) \|$", re.MULTILINE)


def test_every_extra_has_a_purpose() -> None:
    provided = set(metadata("loomlight").get_all("Provides-Extra") or ()) - {"dev"}
    assert set(EXTRAS) == provided
    assert set(required_packages()) == {"", "dev", *provided}


def test_readme_lists_extras_with_their_packages_and_purposes() -> None:
    rows = {extra: (added, purpose) for extra, added, _, purpose in _ROW.findall(README.read_text("utf-8"))}
    assert list(rows) == list(EXTRAS)
    required = required_packages()
    for extra, (added, purpose) in rows.items():
        assert sorted(added.lower().split(", ")) == sorted(name.lower() for name in required[extra])
        assert purpose.replace("`", "").startswith(EXTRAS[extra])
