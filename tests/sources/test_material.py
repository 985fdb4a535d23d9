"""Materials of Mitsuba as sources: references, files, and what is wrong in one sentence."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from loomlight.cli.main import run
from loomlight.core.errors import InputError
from loomlight.core.images import write_channels
from loomlight.sources.load import load_source
from loomlight.sources.loom_file import LoomFile, read_loom, write_loom
from loomlight.sources.material import Material, is_material_file, load_material

XML = """<scene version="3.0.0">
<default name="gloss" value="0.2"/>
<texture type="bitmap" id="albedo"><string name="filename" value="a.png"/></texture>
<bsdf type="twosided" id="body"><bsdf type="principled">
  <ref id="albedo" name="base_color"/><float name="roughness" value="$gloss"/>
</bsdf></bsdf>
</scene>"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A material with a texture, and a TOML that names it."""
    Image.fromarray(np.arange(48, dtype=np.uint8).reshape(4, 4, 3)).save(tmp_path / "a.png")
    (tmp_path / "m.xml").write_text(XML)
    (tmp_path / "m.toml").write_text('material = "m.xml"\nsize_mm = [30, 20.0]\nname = "lacquer"\n')
    return tmp_path


def test_references_and_parameters_are_resolved(folder: Path) -> None:
    material = load_material(folder / "m.xml")
    assert "<ref" not in material.xml
    assert 'value="0.2"' in material.xml
    assert 'value="0-a.png"' in material.xml
    assert material.files["0-a.png"].tobytes() == (folder / "a.png").read_bytes()
    assert (material.name, material.repeat_mm) == ("m", (100.0, 100.0))


def test_a_toml_gives_name_and_size_and_a_loom_keeps_all(folder: Path) -> None:
    material = load_source(folder / "m.toml")
    assert isinstance(material, Material)
    assert (material.name, material.default_uv_size_mm) == ("lacquer", (30.0, 20.0))
    write_loom(folder / "m.loom", LoomFile("latent", material))
    for file in ("m.xml", "m.toml", "a.png"):
        (folder / file).unlink()
    again = read_loom(folder / "m.loom").source
    assert isinstance(again, Material)
    assert (again.xml, again.name, again.size_mm) == (material.xml, material.name, material.size_mm)
    assert np.array_equal(again.files["0-a.png"], material.files["0-a.png"])


def test_only_xml_and_toml_that_names_a_material_are_recognised(folder: Path) -> None:
    (folder / "fabric.toml").write_text('weave = "plain"')
    named = {name: is_material_file(folder / name) for name in ("m.xml", "m.toml", "fabric.toml", "a.png")}
    assert named == {"m.xml": True, "m.toml": True, "fabric.toml": False, "a.png": False}


def test_one_of_several_is_chosen_by_its_id(folder: Path) -> None:
    both = XML.replace("</scene>", '<bsdf type="diffuse" id="lid"/></scene>')
    (folder / "m.xml").write_text(both)
    with pytest.raises(InputError, match=r"several BSDFs \(body, lid\): name one"):
        load_material(folder / "m.xml")
    toml = folder / "m.toml"
    toml.write_text('material = "m.xml"\nbsdf = "lid"')
    assert 'type="diffuse"' in load_material(toml).xml
    toml.write_text('material = "m.xml"\nbsdf = "lip"')
    with pytest.raises(InputError, match="did you mean lid"):
        load_material(toml)


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("</scene>", "", "no valid XML"),
        ("<scene", "<!DOCTYPE s><scene", "holds a DOCTYPE"),
        ('value="a.png"', 'value="b.png"', "does not exist"),
        ('id="albedo" name', 'id="albino" name', 'refers to "albino"'),
        ("<default", '<include filename="c.xml"/><default', 'it includes "c.xml"'),
        ("<ref ", '<ref id="body"/><ref ', "form a circle"),
    ],
)
def test_faults_of_xml_are_one_sentence(folder: Path, old: str, new: str, says: str) -> None:
    (folder / "m.xml").write_text(XML.replace(old, new, 1))
    with pytest.raises(InputError, match=says):
        load_material(folder / "m.xml")


def test_faults_of_textures_are_one_sentence(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    def says(part: str) -> None:
        assert run(["bake", str(folder / "m.xml"), "--model", "latent", "-o", str(folder / "a.loom")]) == 2
        assert part in capsys.readouterr().err
        assert not (folder / "a.loom").exists()

    Image.fromarray(np.zeros((1, 5000), np.uint8)).save(folder / "a.png")
    says("has 5000 × 1 texels: 1 to 4096 a side")
    (folder / "a.png").write_bytes(b"no picture")
    says("is no picture that can be read")
    (folder / "m.xml").write_text(XML.replace("a.png", "a.exr"))
    write_channels(folder / "a.exr", {"RGB": np.full((4, 4, 3), np.nan, np.float32)})
    says("holds NaN or infinity")


def test_faults_of_toml_name_the_field(folder: Path) -> None:
    toml = folder / "m.toml"
    for text, says in (
        ('material = "m.xml"\nsize_mm = [0, 1]', "size_mm = 0 cannot be used: write two lengths"),
        ('material = "m.xml"\nsize = 3', '"size" is no field that a material has: did you mean size_mm'),
        ("material = 3", "material = 3 cannot be used: write the name of a Mitsuba file"),
    ):
        toml.write_text(text)
        with pytest.raises(InputError) as error:
            load_material(toml)
        assert says in str(error.value)


def test_records_name_no_file_elsewhere(folder: Path) -> None:
    from loomlight.sources.material import material_from_record, material_record

    record, tensors = material_record(load_material(folder / "m.xml"))
    with pytest.raises(InputError, match="must hold the bytes"):
        material_from_record(record, {}, "")
    with pytest.raises(InputError, match="no name of a file alone"):
        material_from_record({**record, "files": ["../a.png"]}, tensors, "")
    with pytest.raises(InputError, match="which it lacks"):
        material_from_record({**record, "files": ["b.png"]}, tensors, "")
