"""Pictures from the command line: whole, reproducible, of the size asked for."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import OpenEXR
import pytest
from PIL import Image

from loomlight import mitsuba
from loomlight.cli import render
from loomlight.cli.demo import INSET, SIZE, compose
from loomlight.cli.main import run

SMALL = ["--size", "24x16", "--spp", "2"]


def pixels(path: Path) -> np.ndarray:
    return np.asarray(OpenEXR.File(str(path)).channels()["RGB"].pixels)


def test_a_picture_of_a_weaves_name(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "a.png"
    assert run(["render", "twill 3/1", "-o", str(path), "--scene", "flat", *SMALL]) == 0
    captured = capsys.readouterr()
    assert captured.out.strip() == str(path)
    assert captured.err == ""
    with Image.open(path) as picture:
        assert picture.size == (24, 16)
        assert np.asarray(picture).std() > 0


def test_the_seed_and_the_exposure(tmp_path: Path) -> None:
    def rendered(name: str, *options: str) -> np.ndarray:
        path = tmp_path / f"{name}.exr"
        assert run(["render", "plain", "-o", str(path), "--scene", "sphere", *SMALL, *options]) == 0
        return pixels(path)

    first = rendered("first")
    # Threads add samples up in an order of their own, which shows in the last bits.
    np.testing.assert_allclose(rendered("again"), first, rtol=1e-5, atol=1e-7)
    assert not np.allclose(rendered("other", "--seed", "1"), first, rtol=1e-2)
    np.testing.assert_allclose(rendered("brighter", "--exposure", "1"), 2 * first, rtol=1e-5, atol=1e-7)


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        (["--scene", "moon"], "moon"),
        (["--scene", "none.xml"], "none.xml does not exist"),
        (["--mesh", "none.obj"], "none.obj does not exist"),
        (["--mesh", "none.stl"], "none.stl"),
        (["--env", "none.exr"], "none.exr does not exist"),
        (["--light", "candle"], "candle"),
        (["--light-from", "west"], "2 numbers"),
        (["--light-from", "0,91"], "elevation from -90 to 90"),
        (["--light-from", "0,-5"], "below the horizon"),
        (["--light-from", "0,5", "--env", "none.exr"], "light_from"),
        (["--zoom", "0"], "zoom = 0"),
        (["--zoom", "nan"], "zoom = nan"),
        (["--variant", "scalar_rgb"], "scalar_rgb"),
    ],
    ids=" ".join,
)
def test_what_cannot_be_rendered(
    options: list[str],
    expected: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    assert run(["render", "plain", "-o", "a.png", *SMALL, *options]) == 2
    error = capsys.readouterr().err
    assert len(error.splitlines()) == 1
    assert expected in error
    assert list(tmp_path.iterdir()) == []


def test_an_interrupted_render_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("loomlight.mitsuba.render_fabric", interrupted)
    assert run(["render", "plain", "-o", str(tmp_path / "a.png"), *SMALL]) == 130
    assert capsys.readouterr() == ("", "")
    assert list(tmp_path.iterdir()) == []


def test_maps(tmp_path: Path) -> None:
    path = tmp_path / "maps.exr"
    assert run(["bake-maps", "plain", "-o", str(path), "--resolution", "32x16"]) == 0
    channels = OpenEXR.File(str(path), separate_channels=True).channels()
    height = channels["height"].pixels
    assert height.shape == (16, 32)
    assert height.max() > 0 > height.min()


def test_the_demo_is_composed_of_a_frame_an_inset_and_a_mark() -> None:
    whole = np.full((SIZE[1], SIZE[0], 3), 0.25, dtype=np.float32)
    inset = np.full((INSET, INSET, 3), 0.5, dtype=np.float32)
    picture = compose(whole, inset)
    assert picture.shape[0] > SIZE[1]
    assert (picture[0] == 1).all()
    assert (picture[:, -1] == 1).all()
    assert (picture == 0.5).all(axis=2).sum() == INSET * INSET
    middle = picture[picture.shape[0] // 2]
    assert (middle == 1).all(axis=1).sum() >= 4  # frame and mark, left and right
    assert (whole == 0.25).all()


def test_the_models_of_the_help_are_those_that_exist() -> None:
    # The command line lists them without importing a renderer.
    assert tuple(render.MODELS) == tuple(mitsuba.MODELS)
