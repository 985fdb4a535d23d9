"""Feeds mutilated JSON of fabrics and drafts to the functions under the editor's endpoints.

    python -m tests.fuzz.fabric_messages [--seconds 60] [--seed 0] [--faults FOLDER]

See `tests.fuzz.fuzzing`. Neither baking nor the network takes part.
"""

from __future__ import annotations

import json
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from loomlight.core.errors import InputError
from loomlight.core.images import write_pixels
from loomlight.fabric import fabric_from_text, load_fabric
from loomlight.viewer.messages import draft_of_json, fabric_json, fabric_of_json
from loomlight.viewer.session import gallery_files
from tests.fuzz.fuzzing import BYTES, TEXT, Target, change_json, main

_ARTWORK = """
image = "art.png"
[weaves]
"#000000" = ["plain", "back"]
"#ffffff" = ["plain", "twill 2/2"]
[artwork]
order = "1 1 2"
regulator = 2
"""


def read_fabric(content: bytes) -> None:
    """A fabric and its fabric file, as /api/save makes it."""
    fabric_of_json(_values(content)).to_toml()


def read_draft(content: bytes) -> None:
    """A draft alone."""
    draft_of_json(_values(content))


def _values(content: bytes) -> dict[str, object]:
    try:
        values = json.loads(content)
    except (ValueError, RecursionError) as error:  # the server answers these with a sentence of its own
        raise InputError("no JSON") from error
    if not isinstance(values, dict):
        raise InputError("no object")
    return values


def targets() -> Sequence[Target]:
    """Fabrics of the gallery, one of a name, one of an artwork, and their drafts."""
    fabrics = [fabric_json(load_fabric(gallery_files()[name])) for name in ("gingham", "chambray", "sateen")]
    fabrics.append(fabric_json(fabric_from_text('weave = "houndstooth 4"\nwarp.color = "#203040"')))
    with tempfile.TemporaryDirectory() as name:
        write_pixels(Path(name) / "art.png", np.tile(np.uint8([[0, 0, 0, 0, 255, 255, 255, 255]]), (8, 1)))
        fabrics.append(fabric_json(fabric_from_text(_ARTWORK, name)))
    mutations = (*[change_json] * 20, *BYTES, *TEXT)
    drafts = [json.dumps(fabric["draft"]).encode() for fabric in fabrics]
    return (
        Target("fabric", [json.dumps(fabric).encode() for fabric in fabrics], mutations, read_fabric),
        Target("draft", drafts, mutations, read_draft),
    )


if __name__ == "__main__":
    sys.exit(main("fabric_messages", targets))
