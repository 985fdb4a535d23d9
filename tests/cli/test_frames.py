"""`render` of moving cloth: which frames, where they go, and what is made already."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from loomlight.cli.main import run
from loomlight.core.images import Picture
from loomlight.mesh.moving import Frame
from loomlight.mitsuba.moving import MovingCloth
from tests.mesh.test_gltf_motion import moving

pytestmark = pytest.mark.filterwarnings("ignore:.*too many to be seen")

MOVING = ["plain", "--mesh", "frames/*.obj"]
RENDER = ["render", *MOVING, "--size", "16x12", "--spp", "1", "--model", "point", "--denoise", "off"]


def write(path: Path, lift: float) -> None:
    places = ((0, 0), (0.1, 0), (0.1, 0.1), (0, 0.1))
    lines = [f"v {x} {y} {lift}" for x, y in places] + [f"vt {x} {y}" for x, y in places]
    path.write_text("\n".join([*lines, "f 1/1 2/2 3/3 4/4\n"]))


@pytest.fixture
def rendered(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Numbers of the frames that are rendered from now on, of four in frames/: grey pictures for a test."""
    monkeypatch.chdir(tmp_path)
    Path("frames").mkdir()
    for number in range(9, 13):
        write(Path(f"frames/{number}.obj"), 0.01 * number)
    found: list[int] = []

    def picture(cloth: MovingCloth, frame: Frame) -> Picture:
        found.append(frame.number)
        cloth.show(frame)
        return np.full((12, 16, 3), frame.number / 20, np.float32).view(Picture)

    monkeypatch.setattr(MovingCloth, "picture", picture)
    return found


def test_pictures_are_numbered_as_frames_are(rendered: list[int], capsys: pytest.CaptureFixture[str]) -> None:
    assert run([*RENDER, "-o", "a.png"]) == 0
    names = [f"a-{number:04}.png" for number in range(9, 13)]
    assert capsys.readouterr().out.split() == names
    assert sorted(path.name for path in Path().glob("*.png")) == names
    assert run([*RENDER, "-o", "b.exr", "--frames", "9:12:2"]) == 0
    assert sorted(path.name for path in Path().glob("*.exr")) == ["b-0009.exr", "b-0011.exr"]
    assert rendered == [9, 10, 11, 12, 9, 11]


def test_the_same_command_goes_on(rendered: list[int], capsys: pytest.CaptureFixture[str]) -> None:
    """What is whole stays; a picture that is gone, changed or of another frame's cloth is made again."""
    assert run([*RENDER, "-o", "a.png", "--frames", "9:10"]) == 0
    assert run([*RENDER, "-o", "a.png"]) == 0
    assert rendered == [9, 10, 11, 12]
    assert "2 of 4 frames of a.png are made already and stay" in capsys.readouterr().err
    rendered.clear()
    Path("a-0009.png").unlink()
    Path("a-0010.png").write_bytes(b"cut off")
    write(Path("frames/11.obj"), 0.105)
    assert run([*RENDER, "-o", "a.png"]) == 0
    assert rendered == [9, 10, 11]
    said = capsys.readouterr().err
    assert "a-0010.png is there, but was not made by this command of this cloth" in said
    assert "it is rendered anew, as are 1 others" in said
    rendered.clear()
    assert run([*RENDER, "-o", "a.png"]) == 0
    assert rendered == []


@pytest.mark.parametrize(
    "change", [["--spp", "2"], ["--frames", "9:12", "--seed", "1"], ["--env", "room.png"]], ids=" ".join
)
def test_other_settings_are_rendered_anew(
    change: list[str], rendered: list[int], capsys: pytest.CaptureFixture[str]
) -> None:
    Image.fromarray(np.full((4, 8, 3), 90, np.uint8)).save("room.png")
    command = [*RENDER, "-o", "a.png", *change]
    assert run(command) == 0
    assert run([*RENDER, "-o", "a.png"]) == 0
    assert rendered == 2 * [9, 10, 11, 12]
    assert "a-0009.png is there, but was not made by this command of this cloth" in capsys.readouterr().err


def test_files_that_a_command_names_count(rendered: list[int]) -> None:
    """An environment that was painted over is another one; a frame far away moves the camera of all."""
    Image.fromarray(np.full((4, 8, 3), 90, np.uint8)).save("room.png")
    command = [*RENDER, "-o", "a.png", "--env", "room.png"]
    assert run(command) == 0
    Image.fromarray(np.full((4, 8, 3), 120, np.uint8)).save("room.png")
    assert run(command) == 0
    write(Path("frames/12.obj"), 0.5)
    assert run(command) == 0
    assert rendered == 3 * [9, 10, 11, 12]


def test_pictures_of_others_are_not_taken(rendered: list[int], capsys: pytest.CaptureFixture[str]) -> None:
    for number in (9, 10):
        Image.fromarray(np.zeros((12, 16, 3), np.uint8)).save(f"a-{number:04}.png")
    Path(".loomlight-a.png.frames").write_text(json.dumps({"loomlight_pictures": 1, "pictures": [7]}))
    assert run([*RENDER, "-o", "a.png"]) == 0
    assert rendered == [9, 10, 11, 12]
    assert "a-0009.png is there, but was not made by this command" in capsys.readouterr().err


def test_an_interruption_keeps_whole_pictures(
    rendered: list[int], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    take = MovingCloth.picture

    def interrupted(cloth: MovingCloth, frame: Frame) -> Picture:
        if len(rendered) == 2:
            raise KeyboardInterrupt
        return take(cloth, frame)

    monkeypatch.setattr(MovingCloth, "picture", interrupted)
    assert run([*RENDER, "-o", "a.webp"]) == 130
    assert "2 of 4 frames of a.webp are whole: the same command goes on from there" in capsys.readouterr().err
    assert not Path("a.webp").exists()
    monkeypatch.setattr(MovingCloth, "picture", take)
    assert run([*RENDER, "-o", "a.webp"]) == 0
    assert rendered == [9, 10, 11, 12]
    with Image.open("a.webp") as animation:
        assert animation.n_frames == 4  # type: ignore[attr-defined]
    assert sorted(path.name for path in Path().iterdir()) == [".loomlight-a.webp.frames", "a.webp", "frames"]
    assert run([*RENDER, "-o", "a.webp"]) == 0
    assert run([*RENDER, "-o", "a.webp", "--fps", "12"]) == 0
    assert rendered == [9, 10, 11, 12, 9, 10, 11, 12]


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (["--mesh", "none/*.obj"], "none/*.obj matches no file"),
        (["--frames", "9:13"], "--frames 9:13 is out of range: frames/*.obj has frames 9 to 12"),
        (["--frames", "3"], "--frames 3: frames/*.obj has frames 9 to 12, and 3 is none of them"),
        (["--turntable", "4"], "turns a cloth that stands still, and that of frames/*.obj moves"),
        (["--fps", "0"], "--fps 0 is out of range"),
        (["--inset"], "inset = True does not go with frames of moving cloth"),
        (["frames/10.obj"], "put a pattern of meshes in quotes, as in --mesh 'frames/*.obj'"),
        (["--frames", "11"], "frames/11.obj has 3 vertices and 1 triangles, and the first frame"),
    ],
)
def test_one_sentence(
    words: list[str], expected: str, rendered: list[int], refused: Callable[..., str]
) -> None:
    if words[-1] == "11":
        Path("frames/11.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n")
    assert expected in refused(["render", *MOVING, *words, "-o", "a.png"])
    assert rendered == []


@pytest.fixture
def animated(tmp_path: Path) -> str:
    """A glTF file of a square that goes 0.2 m to the right within a fifth of a second, six frames at 25."""
    return moving(tmp_path, (0, "translation", "LINEAR", [0, 0.2], [(0, 0, 0), (0.2, 0, 0)])).name


def test_an_animation_in_one_file(
    animated: str, rendered: list[int], capsys: pytest.CaptureFixture[str]
) -> None:
    command = ["render", "plain", "--mesh", animated, *RENDER[4:]]
    assert run([*command, "-o", "still.png"]) == 0
    said = capsys.readouterr()
    assert f"{animated} is shown as it rests: --frames : renders its 6 frames." in said.err
    assert said.out.split() == ["still.png"]
    assert rendered == []
    assert run([*command, "-o", "a.png", "--frames", ":"]) == 0
    assert capsys.readouterr().out.split() == [f"a-{number:04}.png" for number in range(1, 7)]
    assert rendered == [1, 2, 3, 4, 5, 6]
    assert run([*command, "-o", "a.webp"]) == 0
    with Image.open("a.webp") as animation:
        assert animation.n_frames == 6  # type: ignore[attr-defined]
        animation.seek(1)
        animation.load()
        assert animation.info["duration"] == 40


def test_cloth_that_stands_still_has_no_frames(rendered: list[int], refused: Callable[..., str]) -> None:
    command = ["render", "plain", "--mesh", "frames/9.obj", "-o", "a.png", "--frames", ":"]
    assert "frames/9.obj does not move: give a file of several frames, or a pattern" in refused(command)
    expected = "play/*.obj stands for several meshes, frames of one that moves; one alone is shown here"
    assert expected in refused(["play", "plain", "--mesh", "play/*.obj", "-o", "a.png"])


def test_frames_are_of_a_mesh(refused: Callable[..., str]) -> None:
    expected = "--frames 9:10 needs a mesh that moves, such as --mesh 'frames/*.obj'"
    assert expected in refused(["render", "plain", "--frames", "9:10", "-o", "a.png"])
