"""Scene text inside a `.loom` reads nothing but the files that the `.loom` holds.

Covers: sources/scene_text.py
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.sources.load import load_source
from loomlight.sources.loom_file import LoomFile, read_loom, write_loom
from loomlight.sources.material import Material, load_material, material_from_record, material_record
from loomlight.sources.tile import TileScene, tile_from_record, tile_record

# Ways to read a file outside: what each puts into a scene, and a part of the sentence that refuses it. OUT is
# an absolute path of a file that exists.
BSDFS = [
    ('<spectrum name="reflectance" filename="OUT"/>', 'the attribute "filename"'),
    ('<spectrum name="reflectance" value="OUT"/>', "<spectrum> has value"),
    ('<string name="material" value="../../x"/>', "is no metal"),
    ('<string name="material" value="x"/>', "is no metal"),
    ('<string name="int_ior" value="../x"/>', '"int_ior" ='),
    ('<string name="fabric" value="OUT"/>', '"fabric" ='),
    ('<bsdf type="woven_lobes"/>', 'type="woven_lobes"'),
    ('<bsdf type="Diffuse"/>', 'type="Diffuse"'),
    ('<bsdf type=" diffuse"/>', 'type=" diffuse"'),
    ('<texture type="bitmap"><string name="filename" value="OUT"/></texture>', "filename|which it lacks"),
    (
        '<texture type="bitmap"><string name="filename" value="../x.png"/></texture>',
        "filename|which it lacks",
    ),
    ('<texture type="bitmap"><string name="Filename" value="OUT"/></texture>', '"Filename" ='),
    ('<texture type="bitmap"><string name="fileName" value="a.png"/></texture>', '"fileName" ='),
    ('<default name="p" value="OUT"/><string name="filename" value="$p"/>', "filename|which it lacks"),
    ('<default name="p" value="OUT"/><string name="x" value="$p"/>', '"x" ='),
    ('<string name="x" value="$q"/>', "no <default> defines"),
    ('<path value="/absolute"/>', "<path> cannot be used"),
    ('<include filename="OUT"/>', "it includes"),
    ('<texture type="volume"><include filename="OUT"/></texture>', "it includes"),
    ('<resource path="OUT"/>', "<resource> cannot be used"),
    ('<String name="filename" value="OUT"/>', "<String> cannot be used"),
    ('<x:include xmlns:x="u" filename="OUT"/>', "cannot be used"),
    ('<rgb name="reflectance" value="1" filename="OUT"/>', 'the attribute "filename"'),
    ('<float name="alpha" value="/x"/>', "<float> has value"),
]
BITMAP = '<texture type="bitmap" name="reflectance"><string name="filename" value="a.png"/></texture>'
SCENE = f"""<scene version="3.0.0"><default name="side" value="0.5"/>
<shape type="rectangle"><transform name="to_world"><scale value="$side"/></transform>
<bsdf type="diffuse">{BITMAP}</bsdf></shape></scene>"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A tile and a material with a texture, and a file outside of their folder."""
    from PIL import Image

    inside = tmp_path / "inside"
    inside.mkdir()
    Image.fromarray(np.zeros((4, 4, 3), np.uint8)).save(inside / "a.png")
    (tmp_path / "x.png").write_bytes((inside / "a.png").read_bytes())
    (inside / "m.xml").write_text(f'<bsdf version="3.0.0" type="diffuse">{BITMAP}</bsdf>')
    (inside / "t.xml").write_text(SCENE)
    (inside / "t.toml").write_text('tile = "t.xml"\nsize_mm = [1.0, 1.0]\n')
    return inside


def records(folder: Path) -> list[tuple[dict[str, Any], dict[str, NDArray[Any]], str]]:
    """Records of the material and of the tile, and their field of text."""
    material, tile = load_source(folder / "m.xml"), load_source(folder / "t.toml")
    assert isinstance(material, Material)
    assert isinstance(tile, TileScene)
    return [(*material_record(material), "xml"), (*tile_record(tile), "scene")]


def refused(folder: Path, text: str, field: str) -> str:
    """The sentence that refuses a record with this text."""
    for record, tensors, own in records(folder):
        if own == field:
            read: Any = material_from_record if field == "xml" else tile_from_record
            with pytest.raises(InputError) as caught:
                read({**record, field: text}, tensors, "")
            assert len(str(caught.value).splitlines()) == 1
            return str(caught.value)
    raise AssertionError(field)


def holds(message: str, says: str) -> bool:
    return any(part in message for part in says.split("|"))


@pytest.mark.parametrize(("part", "says"), BSDFS)
def test_no_text_of_a_record_names_a_file_outside(folder: Path, part: str, says: str) -> None:
    part = part.replace("OUT", str(folder.parent / "x.png"))
    bsdf = f'<bsdf version="3.0.0" type="twosided"><bsdf type="diffuse">{part}</bsdf></bsdf>'
    assert holds(refused(folder, bsdf, "xml"), says)
    shape = f'<scene version="3.0.0"><shape type="rectangle">{bsdf}</shape></scene>'
    assert holds(refused(folder, shape, "scene"), says)
    assert holds(refused(folder, f'<scene version="3.0.0">{part}</scene>', "scene"), says)


@pytest.mark.parametrize(("part", "says"), BSDFS)
def test_no_text_of_a_tile_names_a_file_outside(folder: Path, part: str, says: str) -> None:
    part = part.replace("OUT", str(folder.parent / "x.png"))
    (folder / "t.xml").write_text(f'<scene version="3.0.0"><bsdf type="diffuse">{part}</bsdf></scene>')
    with pytest.raises(InputError) as caught:
        load_source(folder / "t.toml")
    # A spectrum is read where it lies in the folder.
    assert holds(str(caught.value), f"{says}|files lie in the scene's folder")


@pytest.mark.parametrize(
    "shape",
    [
        '<shape type="ply"><string name="filename" value="OUT"/></shape>',
        '<shape type="ply"><string name="filename" value="../x.png"/></shape>',
        '<default name="p" value="OUT"/><shape type="ply"><string name="filename" value="$p"/></shape>',
        '<default name="p" value="$q"/><default name="q" value="OUT"/>'
        '<shape type="ply"><string name="filename" value="$p"/></shape>',
        '<path value="OUT"/><shape type="ply"><string name="filename" value="x.ply"/></shape>',
        '<shape type="ply"><string name="filename" value="&#47;x"/></shape>',
        '<shape type="ply"><string name="filename" value="a.png "/></shape>',
        '<shape type="ply"><string name="filename" value="C:\\x"/></shape>',
        '<emitter type="envmap"><string name="filename" value="OUT"/></emitter>',
        '<texture type="ply"><string name="filename" value="a.png"/></texture>',
        '<!DOCTYPE s [<!ENTITY e SYSTEM "OUT">]><shape type="ply">&e;</shape>',
    ],
)
def test_no_shape_names_a_file_outside(folder: Path, shape: str) -> None:
    scene = f'<scene version="3.0.0">{shape.replace("OUT", str(folder.parent / "x.png"))}</scene>'
    refused(folder, scene, "scene")
    (folder / "t.xml").write_text(scene)
    with pytest.raises(InputError):
        load_source(folder / "t.toml")


@pytest.mark.parametrize(
    "name", ["/a", "../a", "a/../b", "a\\b", "C:a", "a\0", "a/", "", ".", "x" * 300, "\ud800"]
)
def test_no_record_holds_a_file_by_a_path(folder: Path, name: str) -> None:
    (material, _, _), (tile, _, _) = records(folder)
    content = np.zeros(3, np.uint8)
    with pytest.raises(InputError):
        material_from_record({**material, "files": [name]}, {"file.0": content}, "")
    with pytest.raises(InputError):
        tile_from_record(tile, {"file.a.png": content, f"file.{name}": content}, "")


def test_text_that_grows_or_is_deep_is_refused(folder: Path) -> None:
    deep = "<bsdf type='twosided'>" * 5000 + "</bsdf>" * 5000
    assert "deep" in refused(folder, deep, "xml")
    assert "deep" in refused(folder, f"<scene version='3.0.0'>{deep}</scene>", "scene")
    doubled = "".join(f'<default name="p{n:02}" value="$p{n + 1:02}$p{n + 1:02}"/>' for n in range(40))
    text = f"<bsdf type='diffuse'>{doubled}<string name='x' value='$p00'/></bsdf>"
    assert "too long" in refused(folder, text, "xml")


def test_a_loom_of_either_comes_back(folder: Path) -> None:
    for name, field in (("m.xml", "xml"), ("t.toml", "scene")):
        source = load_source(folder / name)
        write_loom(folder / "a.loom", LoomFile("neumip", source))
        again = read_loom(folder / "a.loom").source
        assert getattr(again, field) == getattr(source, field)
        assert list(getattr(again, "files")) == list(getattr(source, "files"))  # noqa: B009 (of two kinds of sources)
    assert isinstance(again, TileScene)
    assert '<scale value="0.5"' in again.scene


def test_scenes_of_all_kinds_are_read(folder: Path) -> None:
    """Sensors and what belongs to them are left out of a tile."""
    parts = """<integrator type="path"/><sensor type="perspective"><film type="hdrfilm"/></sensor>
<bsdf type="roughconductor" id="a/b"><string name="material" value="Au"/>
<string name="distribution" value="ggx"/>
<float name="alpha" value="1e-1"/></bsdf><alias id="a/b" as="c"/>
<shape type="cube"><ref id="a/b"/><boolean name="flip_normals" value="true"/>
<transform name="to_world"><rotate x="1" angle="90"/><lookat origin="0, 0, 0" target="0, 0, 1" up="1, 0, 0"/>
<matrix value="1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"/></transform></shape>
<shape type="sphere"><point name="center" x="0" y="0" z="0"/><bsdf type="roughdielectric">
<string name="int_ior" value="fused quartz"/><float name="ext_ior" value="1.1"/></bsdf></shape>
<bsdf type="diffuse"><spectrum name="reflectance" value="400:0.1, 700:0.2"/></bsdf>
<bsdf type="diffuse"><rgb name="reflectance" value="#aa00ff"/></bsdf>
<bsdf type="diffuse"><texture type="irregular" name="reflectance"><string name="wavelengths"
 value="400, 500, 600, 700, 710, 720, 730, 740, 750, 760, 770, 780, 790, 800"/></texture></bsdf>"""
    (folder / "t.xml").write_text(f'<scene version="3.0.0">{parts}</scene>')
    tile = load_source(folder / "t.toml")
    assert isinstance(tile, TileScene)
    assert "sensor" not in tile.scene
    assert "integrator" not in tile.scene


def test_materials_that_are_shipped_are_read() -> None:
    examples = Path(__file__).parents[2] / "examples" / "materials"
    for file in sorted(examples.glob("*/*.xml")):
        material = load_material(file)
        record, tensors = material_record(material)
        again = material_from_record(json.loads(json.dumps(record)), tensors, "")
        assert again.xml == material.xml


def test_spectra_in_files_are_written_into_the_text(folder: Path) -> None:
    """A user's own scene may name them; what is kept holds their values."""
    (folder / "s.spd").write_text("# measured\n400 0.1\n\n700 5e-1\n")
    text = '<bsdf version="3.0.0" type="diffuse"><spectrum name="reflectance" filename="s.spd"/></bsdf>'
    (folder / "m.xml").write_text(text)
    (folder / "t.xml").write_text(f'<scene version="3.0.0">{text}</scene>')
    for name, field in (("m.xml", "xml"), ("t.toml", "scene")):
        assert 'value="400.0:0.1, 700.0:0.5"' in getattr(load_source(folder / name), field)
    (folder / "s.spd").write_text("400 0.1 3\n")
    for name in ("m.xml", "t.toml"):
        with pytest.raises(InputError, match=r"s.spd. is no spectrum"):
            load_source(folder / name)
    (folder.parent / "s.spd").write_text("400 0.1\n")
    (folder / "t.xml").write_text(f"<scene>{text.replace('s.spd', '../s.spd')}</scene>")
    with pytest.raises(InputError, match="files lie in the scene's folder"):
        load_source(folder / "t.toml")
