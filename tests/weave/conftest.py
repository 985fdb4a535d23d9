"""Where the fixtures and the outside corpora are."""

import os
from collections.abc import Callable
from pathlib import Path

import pytest

FIXTURES = Path(__file__).parents[1] / "cases" / "drafts"


@pytest.fixture
def fixtures() -> Path:
    return FIXTURES


@pytest.fixture
def wif(tmp_path: Path) -> Callable[..., Path]:
    """Writes sections as a weaving information file; those given as None are left out."""

    def write(**sections: str | None) -> Path:
        whole: dict[str, str | None] = {
            "WIF": "Version=1.1",
            "WEAVING": "Shafts=2\nTreadles=2\nRising Shed=true",
            "WARP": "Threads=4\nColor=1",
            "WEFT": "Threads=2\nColor=2",
            "COLOR_PALETTE": "Entries=2\nRange=0,255",
            "COLOR_TABLE": "1=0,0,0\n2=255,255,255",
            "THREADING": "1=1\n2=2\n3=1\n4=2",
            "TIEUP": "1=1\n2=2",
            "TREADLING": "1=1\n2=2",
            **sections,
        }
        text = "\n".join(
            f"[{name.replace('_', ' ')}]\n{body}\n" for name, body in whole.items() if body is not None
        )
        path = tmp_path / "draft.wif"
        path.write_text(text)
        return path

    return write


def corpus(kind: str) -> list[pytest.param]:
    """The files below LOOMLIGHT_DATA/wif/`kind`, as parameters; one that is skipped without that variable."""
    folder = os.environ.get("LOOMLIGHT_DATA")
    if not folder:
        return [pytest.param(None, marks=pytest.mark.skip(reason="LOOMLIGHT_DATA names no folder of drafts"))]
    return [pytest.param(file, id=file.stem) for file in sorted((Path(folder) / "wif" / kind).glob("*.wif"))]


def cases(pattern: str) -> list[pytest.param]:
    """The files of LOOMLIGHT_DATA/cases that match, as parameters; a skipped one without that variable."""
    folder = os.environ.get("LOOMLIGHT_DATA")
    if not folder:
        return [pytest.param(None, marks=pytest.mark.skip(reason="LOOMLIGHT_DATA names no folder of cases"))]
    return [pytest.param(file, id=file.stem) for file in sorted((Path(folder) / "cases").glob(pattern))]
