"""Records of fabrics: those of former schemas state what was a default then; more in `test_loom_file.py`."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from loomlight.fabric import Fabric, fabric_from_text
from loomlight.sources.fabric import fabric_from_record, fabric_record, of_former_defaults


def former(text: str, schema: int) -> Fabric:
    """The fabric of a record of `schema`, written and read once more."""
    record, tensors = fabric_record(fabric_from_text(text))
    source: dict[str, Any] = of_former_defaults({"kind": "fabric", **record}, schema)
    assert source.pop("kind") == "fabric"
    record, tensors = fabric_record(fabric_from_record(source, tensors, ""))
    return fabric_from_record(record, tensors, "")


@pytest.mark.parametrize(
    ("text", "warp_mm", "weft_mm"),
    [
        ('yarn = "wool"', 0.4, 0.4),
        ('yarn = "wool"\n[warp]\ncount = "Nm 8"', 0.5196, 0.4),
        ('yarn = "wool"\ngap = 0.1\n[weft]\ncount = "Nm 8"', 0.45, 0.5196),
        ("gap = 0", 0.49, 0.49),
        ("gap = 0.1\n[weft]\ngap = 0.01", 0.45, 0.49),
        ('[warp]\nyarn = "wool"\ngap = 0.3\ncount = "Nm 8"', 0.35, 0.4),
    ],
)
def test_yarns_of_the_third_schema_keep_their_width(text: str, warp_mm: float, weft_mm: float) -> None:
    """A gap of 0.2, and beside a count the diameter of a round yarn: what models were baked with."""
    fabric = former(f'weave = "twill 2/2"\n{text}', 3)
    np.testing.assert_allclose(fabric.layout().warp.width, warp_mm, atol=5e-5)
    np.testing.assert_allclose(fabric.layout().weft.width, weft_mm, atol=5e-5)
    assert fabric.fields.interreflection is None


def test_what_names_no_kind_of_yarn_states_nothing_new() -> None:
    text = 'weave = "plain"\n[warp]\ncount = "Ne 20"'
    assert former(text, 3).fields == fabric_from_text(text).fields
    assert former(text, 2).fields.interreflection is False


@pytest.mark.parametrize("record", [{}, {"kind": "fabric", "toml": 3}, {"kind": "fabric", "toml": "weave ="}])
def test_what_is_no_fabric_stays(record: dict[str, Any]) -> None:
    assert of_former_defaults(record, 2) == record
