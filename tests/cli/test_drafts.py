"""The draft that an argument stands for: a file of any kind, or a weave's name."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from loomlight.cli.main import run
from loomlight.cli.weave import draft_from
from loomlight.core.errors import InputError
from loomlight.core.images import read_picture, write_pixels
from loomlight.weave.named import named_weave
from loomlight.weave.wif_reader import read_wif
from loomlight.weave.wif_writer import write_wif

TWILL = named_weave("twill 3/1")


def test_names_and_files_give_the_same_draft(tmp_path: Path) -> None:
    write_wif(TWILL, tmp_path / "a.wif")
    # Warp is dark, and the first pick lies at the bottom of a picture.
    write_pixels(tmp_path / "a.png", np.where(TWILL.drawdown[::-1], 0, 255).astype(np.uint8))
    (tmp_path / "a.toml").write_text('weave = "twill 3/1"')
    for argument in ("twill 3/1", *(str(tmp_path / f"a.{kind}") for kind in ("wif", "png", "toml"))):
        np.testing.assert_array_equal(draft_from(argument).drawdown, TWILL.drawdown, argument)


@pytest.mark.parametrize(
    ("argument", "says"),
    [
        ("twil 3/1", "twill"),
        ("a.fbx", "is no draft"),
        ("/nowhere", "is no draft"),
        ("a.wif", "does not exist"),
    ],
)
def test_what_is_no_draft_is_refused(argument: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        draft_from(argument)


LAYERED = Path(__file__).parents[2] / "examples" / "layered"


@pytest.mark.parametrize("draft", ["matelasse", "pattern-double-weave"])
@pytest.mark.parametrize("layer", ["front", "back", "2"])
def test_a_layer_is_shown(draft: str, layer: str, tmp_path: Path) -> None:
    output = tmp_path / "a.png"
    assert run(["weave", "show", str(LAYERED / f"{draft}.wif"), "--layer", layer, "-o", str(output)]) == 0
    assert read_picture(output).shape[2] == 3


def test_a_layer_that_is_not_there_writes_nothing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    output = tmp_path / "a.png"
    assert run(["weave", "show", "plain", "--layer", "2", "-o", str(output)]) != 0
    assert "the draft has a single layer" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


def test_a_layer_is_written_as_a_draft(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    source, output = str(LAYERED / "stitched-double-cloth.wif"), tmp_path / "a.wif"
    assert run(["weave", "convert", source, "--layer", "back", "-o", str(output)]) == 0
    back = read_wif(output)
    np.testing.assert_array_equal(back.drawdown, np.tile(named_weave("twill 2/2").drawdown, (2, 2)))
    assert back.warp.spacing_mm is not None
    # Half the ends take up the room of all.
    np.testing.assert_allclose(back.warp.spacing_mm, 0.8)
    changing = str(LAYERED / "pattern-double-weave.wif")
    assert run(["weave", "convert", changing, "--layer", "front", "-o", str(tmp_path / "b.wif")]) != 0
    assert "as cloths change places in it" in capsys.readouterr().err
    assert [file.name for file in tmp_path.iterdir()] == ["a.wif"]


def test_information_names_layers(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    fabric = tmp_path / "a.toml"
    fabric.write_text(f'draft = "{LAYERED / "pique.wif"}"')
    for argument in (str(LAYERED / "pique.wif"), str(fabric)):
        assert run(["weave", "info", argument]) == 0
        assert "layers: 3, A upon C upon B\n" in capsys.readouterr().out
    assert run(["weave", "info", "denim"]) == 0
    assert "layers" not in capsys.readouterr().out
