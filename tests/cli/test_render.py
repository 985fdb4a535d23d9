"""Pictures from the command line: whole, reproducible, of the size asked for.

Covers: cli/bake.py, cli/pictures.py
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import OpenEXR
import pytest
from PIL import Image

from loomlight.cli.main import run
from loomlight.core.errors import InputError
from loomlight.fabric import Fabric
from loomlight.models.bake import bake, save
from loomlight.models.interface import Model
from loomlight.models.material_spec import resolve
from loomlight.models.texture.neumip import NeumipModel
from tests.helpers.untrained import random_neumip
from tests.marks import slow

SMALL = ["--size", "24x16", "--spp", "2"]
# A rectangle to clothe, and behind the camera one with a cloth of the scene's own.
SCENE = """<scene version="3.0.0">
    <sensor type="perspective"><transform name="to_world">
        <lookat origin="0, 0, 4" target="0, 0, 0" up="0, 1, 0"/>
    </transform></sensor>
    <emitter type="constant"/>
    <shape type="rectangle"><bsdf type="diffuse" id="fabric"/></shape>
    <shape type="rectangle">
        <transform name="to_world"><translate z="9"/></transform>
        <bsdf type="woven_lobes">{parameters}</bsdf>
    </shape>
</scene>"""


def pixels(path: Path) -> np.ndarray:
    return np.asarray(OpenEXR.File(str(path)).channels()["RGB"].pixels)


def test_a_picture_of_a_weaves_name(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "a.png"
    # Close enough for its yarns to be seen, which is no warning.
    assert run(["render", "twill 3/1", "-o", str(path), "--scene", "flat", "--zoom", "30", *SMALL]) == 0
    captured = capsys.readouterr()
    assert captured.out.strip() == str(path)
    assert captured.err == ""
    with Image.open(path) as picture:
        assert picture.size == (24, 16)
        assert np.asarray(picture).std() > 0


@pytest.mark.slow
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
        (["--zoom", "nan"], "--zoom nan is out of range"),
        (["--variant", "scalar_rgb"], "scalar_rgb"),
    ],
    ids=" ".join,
)
def test_what_cannot_be_rendered(options: list[str], expected: str, refused: Callable[..., str]) -> None:
    assert expected in refused(["render", "plain", "-o", "a.png", "--model", "point", *SMALL, *options])


@pytest.mark.slow
def test_a_rectangle_of_a_scene_file_is_a_mesh(tmp_path: Path) -> None:
    (tmp_path / "scene.xml").write_text(SCENE.format(parameters=""))
    for name, weft in (("dark", "#000000"), ("light", "#ffffff")):
        (tmp_path / f"{name}.toml").write_text(f'weave = "plain"\n[weft]\ncolor = "{weft}"')
        options = ["--scene", str(tmp_path / "scene.xml"), *SMALL]
        fabric, picture = tmp_path / f"{name}.toml", tmp_path / f"{name}.exr"
        assert run(["render", str(fabric), "-o", str(picture), *options]) == 0
    # Pixels in the middle, of two samples each: one of them alone may be half as bright as it should be.
    middle = slice(4, 12), slice(8, 16), slice(3)
    dark, light = (pixels(tmp_path / f"{name}.exr")[middle].mean() for name in ("dark", "light"))
    assert light > 1.5 * dark


@pytest.mark.parametrize(
    ("parameters", "expected"),
    [
        ('<string name="groups" value="a"/>', 'groups = "a" is wrong: give a whole number from 1 to 64.'),
        slow('<float name="groups" value="2.5"/>', "groups = 2.5 is wrong: give a whole number"),
        slow('<boolean name="groups" value="true"/>', "groups = true is wrong: give a whole number"),
        ('<integer name="groups" value="0"/>', "cannot be loaded: groups = 0 is wrong: give a whole number"),
        ('<integer name="gruops" value="8"/>', 'unreferenced property in bsdf plugin of type "woven_lobes"'),
        slow('<integer name="gruops" value="8"/>', 'integer "gruops": 8'),
        slow(
            '<string name="pixel_angle" value="x"/>', 'pixel_angle = "x" is wrong: give an angle in radians'
        ),
        slow('<float name="pixel_angle" value="-1"/>', "pixel_angle = -1.0 is wrong"),
        ('<string name="fabric" value="none.toml"/>', "cannot be loaded: none.toml does not exist."),
        ('<texture type="bitmap" name="albedo"><string name="filename" value="no.png"/></texture>', "no.png"),
    ],
)
def test_what_a_scene_file_says_of_its_own_cloth(
    parameters: str, expected: str, refused: Callable[..., str]
) -> None:
    Path("scene.xml").write_text(SCENE.format(parameters=parameters))
    assert expected in refused(["render", "plain", "-o", "a.png", "--scene", "scene.xml", *SMALL])


def test_a_render_interrupted_early_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("loomlight.mitsuba.pictures.render", interrupted)
    assert run(["render", "plain", "-o", str(tmp_path / "a.png"), *SMALL]) == 130
    assert capsys.readouterr() == ("", "loomlight: interrupted. Nothing was written.\n")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("before", [None, b"another picture"])
@pytest.mark.parametrize(
    ("error", "code"), [(InputError("it cannot be finished."), 2), (KeyboardInterrupt(), 130)]
)
def test_a_render_that_cannot_be_finished_leaves_what_was_there(
    error: BaseException,
    code: int,
    before: bytes | None,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """But an interruption keeps the picture as far as it came."""
    path = tmp_path / "a.png"
    if before is not None:
        path.write_bytes(before)

    def fails(*_: object, partial: Callable[[np.ndarray], None], **__: object) -> None:
        partial(np.zeros((4, 4, 3), dtype=np.float32))
        with Image.open(path) as picture:
            assert picture.size == (4, 4)
        raise error

    monkeypatch.setattr("loomlight.mitsuba.pictures.render", fails)
    assert run(["render", "plain", "-o", str(path), *SMALL]) == code
    text = capsys.readouterr().err
    if code == 130:
        assert text == f"loomlight: interrupted. {path} holds the picture as far as it came.\n"
        assert path.read_bytes()[1:4] == b"PNG"
    else:
        assert text == "loomlight: it cannot be finished.\n"
        assert (path.read_bytes() if path.exists() else None) == before


def test_maps(tmp_path: Path) -> None:
    path = tmp_path / "maps.exr"
    assert run(["bake-maps", "plain", "-o", str(path), "--resolution", "32x16"]) == 0
    channels = OpenEXR.File(str(path), separate_channels=True).channels()
    height = channels["height"].pixels
    assert height.shape == (16, 32)
    assert height.max() > 0 > height.min()
    assert {"color.R", "color.G", "color.B", "opacity", "roughness"} <= set(channels)


def test_several_fabrics_in_other_colours(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "own.toml").write_text('weave = "satin 8"')
    fabrics = ["twill 2/2", str(tmp_path / "own.toml")]
    output = str(tmp_path / "{name}.exr")
    for colors in ("warp=#ff0000,weft=#ff0000", "warp=#0000ff,weft=#0000ff"):
        options = ["--scene", "flat", "--model", "point", *SMALL, "--color", colors]
        assert run(["render", *fabrics, "-o", output, *options]) == 0
        for name in ("twill 2-2", "own"):
            red, _, blue = pixels(tmp_path / f"{name}.exr")[4:12, 8:16].mean(axis=(0, 1))
            assert (red > 3 * blue) if "ff0000" in colors else (blue > 3 * red)
    assert len(capsys.readouterr().out.splitlines()) == 4


def test_a_loom_in_other_colours_keeps_its_model(tmp_path: Path) -> None:
    loom = tmp_path / "a.loom"
    save(bake("plain", "samples"), loom)
    model = resolve(loom).recoloured({"warp": "#ff0000"}).model()
    assert isinstance(model, Model)
    assert model.name == "samples"
    assert isinstance(model.source, Fabric)
    # Twenty halvings find the dye that shows it.
    assert model.source.appearance().warp.diffuse_reflect[0, 2] < 1e-6


@pytest.mark.slow
def test_two_cloths_of_one_scene_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    second = '<shape type="rectangle"><transform name="to_world"><translate x="2"/></transform>'
    second += '<bsdf type="diffuse" id="lining"/></shape><shape type="rectangle">'
    scene = tmp_path / "scene.xml"
    scene.write_text(SCENE.format(parameters="").replace('<shape type="rectangle">', second, 1))
    for name, colour in (("red", "#ff0000"), ("blue", "#0000ff")):
        text = f'weave = "plain"\n[warp]\ncolor = "{colour}"\n[weft]\ncolor = "{colour}"'
        (tmp_path / f"{name}.toml").write_text(text)
    arguments = [
        "render",
        str(tmp_path / "red.toml"),
        "-o",
        str(tmp_path / "a.exr"),
        "--scene",
        str(scene),
        *SMALL,
    ]
    assert run([*arguments, "--model", "point", "--cloth", f"lining={tmp_path / 'blue.toml'}"]) == 0
    picture = pixels(tmp_path / "a.exr")
    means = [
        picture[5:11, columns].mean(axis=(0, 1)) for columns in (slice(9, 13), slice(0, 4), slice(20, 24))
    ]
    assert means[0][0] > 3 * means[0][2]
    assert max(mean[2] / mean[0] for mean in means[1:]) > 3
    assert run([*arguments, "--cloth", "collar=plain"]) == 2
    assert 'no shape whose BSDF has the id "collar"' in capsys.readouterr().err


@pytest.mark.parametrize(
    ("fabrics", "options", "expected"),
    [
        (["plain", "satin"], ["-o", "a.png"], "write {name} where the fabric's name goes"),
        (["plain", "plain"], ["-o", "{name}.png"], "rename one"),
        (["plain"], ["-o", "a.png", "--color", "red"], "write NAME=VALUE"),
        (["plain"], ["-o", "a.png", "--color", "hem=#ff0000"], 'no yarns "hem"'),
        (["plain"], ["-o", "a.png", "--color", "warp=reddish"], "warp.color"),
        (["plain"], ["-o", "a.png", "--shift", "4"], "--shift"),
        (["plain"], ["-o", "a.png", "--scale", "0"], "--scale 0"),
        (["plain"], ["-o", "a.png", "--cloth", "hem=satin"], "needs a mesh with parts, or a scene file"),
    ],
)
def test_what_cannot_be_rendered_of_several(
    fabrics: list[str], options: list[str], expected: str, refused: Callable[..., str]
) -> None:
    assert expected in refused(["render", *fabrics, *SMALL, *options])


@pytest.mark.parametrize("how", ["a weave", "a .loom of another", "other colours"])
def test_no_picture_trains_a_model(
    how: str, refused: Callable[..., str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A picture of a model that is trained is of a `.loom`: nobody waits for minutes unasked."""
    monkeypatch.setattr(NeumipModel, "for_source", lambda *_, **__: pytest.fail("it is trained"))
    save(bake("plain", "point"), "point.loom")
    save(random_neumip(), "own.loom")
    words = {
        "a weave": ["plain", "--model", "neumip"],
        "a .loom of another": ["point.loom", "--model", "neumip"],
        "other colours": ["own.loom", "--color", "warp=#ff0000"],
    }
    said = refused(["render", *words[how], "-o", "a.png"])
    assert "`loomlight bake SOURCE --model neumip -o x.loom`" in said
