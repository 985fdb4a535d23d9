"""Drafts in the formats of single programs."""

import zipfile
from pathlib import Path

import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.weave import load_draft, named_weave, write_wif


def test_fiberworks(fixtures: Path) -> None:
    draft = load_draft(fixtures / "point-twill.dtx")
    lifts = [{1, 2}, {2, 3}, {3, 4}, {1, 4}]
    threading = [1, 2, 3, 4, 3, 2]
    assert draft.drawdown.tolist() == [[shaft in lift for shaft in threading] for lift in lifts]
    assert draft.title == "Point twill on four shafts"
    assert draft.notes == ("By hand, for the tests",)
    assert draft.warp.spacing_mm is not None
    assert np.allclose(draft.warp.spacing_mm, [2.12, 2.12, 2.12, 1.06, 2.12, 2.12])
    assert draft.warp.color_index is not None
    assert draft.warp.color_index.tolist() == [0] * 6


def test_tempoweave(tmp_path: Path) -> None:
    twill = named_weave("twill 3/1")
    write_wif(twill, tmp_path / "twill.wif")
    with zipfile.ZipFile(tmp_path / "twill.twa", "w") as archive:
        archive.write(tmp_path / "twill.wif", "twamain.waf")
    assert np.array_equal(load_draft(tmp_path / "twill.twa").drawdown, twill.drawdown)
    with zipfile.ZipFile(tmp_path / "other.twa", "w") as archive:
        archive.writestr("readme.txt", "no draft")
    with pytest.raises(InputError, match=r"is no \.twa draft"):
        load_draft(tmp_path / "other.twa")


@pytest.mark.parametrize("suffix", [".dtx", ".wpo", ".twa"])
@pytest.mark.parametrize(
    "content", [b"", b"\x00" * 50, b"@@Threading\n1 2\n", bytes(range(256)) * 8, b"PK\x03\x04"]
)
def test_other_contents_are_refused_in_a_sentence(tmp_path: Path, suffix: str, content: bytes) -> None:
    path = tmp_path / f"draft{suffix}"
    path.write_bytes(content)
    with pytest.raises(InputError, match=rf"is no \{suffix} draft that can be read") as caught:
        load_draft(path)
    assert "\n" not in str(caught.value)
