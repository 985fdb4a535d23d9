"""Colours of fabric files that are measured: read once."""

from pathlib import Path

import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.fabric.read import edited_fabric, fabric_from_text, load_fabric


def test_measured_colours_are_read_once(tmp_path: Path) -> None:
    (tmp_path / "grey.csv").write_text("400,20\n700,20\n")
    path = tmp_path / "cloth.toml"
    path.write_text('weave = "plain"\n[warp]\ncolor = ["grey.csv", "#ff0000"]\n[weft]\ncolor = "grey.csv"\n')
    fabric = load_fabric(path)
    (tmp_path / "grey.csv").unlink()
    # The fields hold numbers, so edits and a .loom need the measurement no more.
    assert fabric.fields.weft.color == pytest.approx([0.2] * 3, abs=1e-6)
    again = edited_fabric(fabric, {"warp.roughness": 0.5})
    assert np.allclose(again.draft.warp.colors[0], 0.2, atol=1e-6)
    assert np.allclose(fabric_from_text(fabric.to_toml()).draft.warp.colors[1], [1, 0, 0])
    with pytest.raises(InputError, match=r"grey\.csv"):
        load_fabric(path)
