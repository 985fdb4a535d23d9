"""U3M of fabrics: valid by the schema, of the right sizes, both faces, an archive by the format's rules.

Covers: exporters/u3m.py, sources/u3m_file.py
"""

from __future__ import annotations

import io
import json
import os
import re
import struct
import time
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any
from unittest.mock import patch

import jsonschema
import numpy as np
import pytest
from PIL import Image

from loomlight.cli.main import run
from loomlight.core.errors import InputError
from loomlight.core.llvm import require_llvm
from loomlight.core.picture_settings import Worn
from loomlight.exporters import export, u3m
from loomlight.exporters.u3m import composition, construction, file_name, u3m_grid, u3m_of
from loomlight.fabric import fabric_from_text
from loomlight.fabric.facts import cloth_facts
from loomlight.sources.u3m_file import U3mFile, archive_bytes, is_relative_path, read_u3m, write_u3ma
from loomlight.weave.structures import plain, satin, twill
from tests.helpers.standard_materials import few_queries
from tests.marks import slow

require_llvm()
DATA = os.environ.get("LOOMLIGHT_DATA")
needs_data = pytest.mark.skipif(DATA is None, reason="set LOOMLIGHT_DATA to the folder with U3M's schema")
# Blue of the warp on the face, white of the weft behind; 0.6 mm of 0.71 leave holes.
TEXT = (
    'weave = "twill 3/1"\nends_per_cm = 14\npicks_per_cm = 11\n[warp]\nyarn = "cotton"\ncolor = "#2a4680"\n'
    'width_mm = 0.6\ncount = "Ne 10"\n[weft]\nyarn = "linen"\ncolor = "#d8d4c8"\ncount = "Ne 8"\n'
    "width_mm = 0.7\n"
    "[variation]\nirregularity = 0\n"
)
FABRIC = fabric_from_text(TEXT)


@pytest.fixture(scope="module")
def made() -> U3mFile:
    """A U3M of few texels."""
    with patch.object(u3m, "_MIN_SIDE", 16):
        return u3m_of(FABRIC, "lobes", 150.0)[0]


def pixels(made: U3mFile, face: str, field: str) -> np.ndarray:
    """Values of a picture, 0 to 1, row 0 at the upper edge."""
    path = made.document["material"][face][field]["texture"]["image"]["path"]
    return np.asarray(Image.open(io.BytesIO(made.files[path])), float) / 255


def schema() -> jsonschema.Draft7Validator:
    assert DATA is not None
    text = (Path(DATA) / "u3m" / "u3m_schema.json").read_text()
    return jsonschema.Draft7Validator(json.loads(text), format_checker=jsonschema.FormatChecker())


@needs_data
@pytest.mark.slow
def test_documents_are_valid_by_the_schema(made: U3mFile) -> None:
    assert [error.message for error in schema().iter_errors(made.document)] == []
    # The validator finds faults: a field that is missing, a path outside.
    broken = json.loads(json.dumps(made.document))
    del broken["material"]["front"]["sheen_tint"]
    broken["material"]["back"]["normal"]["texture"]["image"]["path"] = "../normal.png"
    assert len(list(schema().iter_errors(broken))) >= 2


@pytest.mark.slow
def test_pictures_have_the_size_that_the_document_says(made: U3mFile) -> None:
    """Whole repeats, and within half a texel the resolution that was asked for."""
    named = set()
    for face in ("front", "back"):
        for field, value in made.document["material"][face].items():
            texture = value.get("texture") if isinstance(value, dict) else None
            if not texture:
                continue
            image = texture["image"]
            named.add(image["path"])
            picture = Image.open(io.BytesIO(made.files[image["path"]]))
            assert picture.mode == "RGB", field
            for side, count, axis, repeat in zip(
                (image["width"], image["height"]), picture.size, "xy", FABRIC.repeat_mm, strict=True
            ):
                assert side / repeat == pytest.approx(round(side / repeat))
                assert image["dpi"][axis] == pytest.approx(count / side * 25.4)
                assert count == pytest.approx(side / 25.4 * 150, abs=0.5)
                # PNG holds whole texels a metre.
                assert picture.info["dpi"]["xy".index(axis)] == pytest.approx(image["dpi"][axis], rel=1e-3)
        named.add(made.document["material"][face]["preview"]["path"])
    assert named == set(made.files)


@pytest.mark.slow
def test_the_back_is_the_cloth_turned_over(made: U3mFile) -> None:
    """A 3/1 twill shows three quarters of its warp in front and a quarter behind."""
    front, back = (pixels(made, face, "basecolor") for face in ("front", "back"))
    blue = [(face[..., 2] > 1.3 * face[..., 0]).mean() for face in (front, back)]
    assert blue[0] > 0.6
    assert blue[1] < 0.4
    # What is thread-wide holes from one side is so from the other, mirrored.
    alpha = [pixels(made, face, "alpha")[..., 0] for face in ("front", "back")]
    assert alpha[0] == pytest.approx(alpha[1][:, ::-1], abs=0.02)
    assert alpha[0].min() < 0.5 < alpha[0].max()


@pytest.mark.slow
def test_normals_are_opengl_and_follow_the_displacement(made: U3mFile) -> None:
    """Green is up, red is right: along each axis the slope of heights is against the normal's."""
    for face in ("front", "back"):
        field = made.document["material"][face]["displacement"]["texture"]
        height = field["offset"] + field["factor"] * pixels(made, face, "displacement")[..., 0]
        # Millimetres: threads of 0.6 and 0.7 mm cross.
        assert 0.05 < np.ptp(height) < 1.5
        normal = 2 * pixels(made, face, "normal") - 1
        right = np.roll(height, -1, 1) - np.roll(height, 1, 1)
        up = np.roll(height, 1, 0) - np.roll(height, -1, 0)
        for slope, part in ((right, normal[..., 0]), (up, normal[..., 1])):
            assert np.corrcoef(slope.ravel(), part.ravel())[0, 1] < -0.3


@pytest.mark.slow
def test_constants_are_means_of_the_pictures(made: U3mFile) -> None:
    front = made.document["material"]["front"]
    alpha = front["alpha"]
    # Eight bits.
    assert alpha["constant"] == pytest.approx(pixels(made, "front", "alpha").mean(), abs=1 / 255)
    assert front["metalness"] == {"constant": 0, "texture": None}
    assert set(front["basecolor"]["constant"]) == {"r", "g", "b"}


@pytest.mark.slow
def test_physics_are_those_of_weave_info(made: U3mFile) -> None:
    physics, facts = made.document["material"]["physics"], cloth_facts(FABRIC)
    assert physics["weight"] == pytest.approx(facts.weight, rel=5e-3)
    assert physics["thickness"] == pytest.approx(facts.thickness_mm, rel=5e-3)
    assert physics["construction"]["type"].startswith("Twill")


def test_composition_is_by_mass() -> None:
    parts = {part["type"]: part["ratio"] for part in composition(FABRIC)}
    facts = cloth_facts(FABRIC)
    warp, weft = (each.per_cm * each.tex * (1 + each.crimp) for each in (facts.warp, facts.weft))
    assert parts == {
        "Cotton": pytest.approx(warp / (warp + weft), abs=1e-3),
        "Linen": pytest.approx(weft / (warp + weft), abs=1e-3),
    }
    unnamed = fabric_from_text('weave = "plain"\nends_per_cm = 10\npicks_per_cm = 10\n')
    assert composition(unnamed) == [{"ratio": 1.0, "type": "unknown", "name": None}]


def test_weaves_have_the_names_of_the_format() -> None:
    assert construction(plain()) == "Plain weave"
    assert construction(twill((2, 1))) == "Twill - right hand (Z)"
    assert construction(twill((2, 1))[:, ::-1]) == "Twill - left hand (S)"
    assert construction(satin(8, 3)) == "Satin"
    assert construction(np.eye(5, 6, dtype=bool)) == "unknown"


def test_repeats_are_whole_and_fill_a_picture() -> None:
    columns, rows, repeats = u3m_grid(FABRIC, 300.0)
    width, height = (side * count for side, count in zip(FABRIC.repeat_mm, repeats, strict=True))
    assert (columns, rows) == (round(width / 25.4 * 300), round(height / 25.4 * 300))
    assert min(columns, rows) >= 256
    with pytest.raises(InputError, match="30 to 2400"):
        u3m_grid(FABRIC, 10.0)
    long = fabric_from_text('weave = "damask 480"\nends_per_cm = 20\npicks_per_cm = 20\n')
    with pytest.raises(InputError, match=r"write --dpi \d+ or less") as refused:
        u3m_grid(long, 2400.0)
    advised = float(re.findall(r"--dpi (\d+)", str(refused.value))[0])
    assert max(u3m_grid(long, advised)[:2]) <= 8192


def test_names_of_files_are_safe() -> None:
    assert file_name("Köper 3/1: «blau».") == "K-per-3-1-blau"
    assert file_name("///") == "cloth"


# --------------------------------------------------------------------------------------------------- archives

CONTENTS = {"cloth.u3m": b'{"material": {}}', "textures/a.png": bytes(4000), "textures/ä.bin": b"\x07\x99"}


def test_an_archive_is_the_subset_of_zip_that_the_format_allows() -> None:
    """Field by field as u3m_additional_spec_u3ma.txt lists them."""
    content = archive_bytes(CONTENTS, time.struct_time((2026, 3, 4, 5, 6, 7, 0, 0, 0)))
    (entries,) = struct.unpack_from("<H", content, len(content) - 12)
    size, start = struct.unpack_from("<II", content, len(content) - 10)
    assert (entries, start + size) == (3, len(content) - 22)
    at = start
    for name, whole in CONTENTS.items():
        encoded = name.encode()
        fields = struct.unpack_from("<IHHHHHHIIIHHHHHII", content, at)
        signature, made_by, needs, flags, method, clock, date, crc, packed, plain_size, length = fields[:11]
        assert (signature, made_by, needs, flags) == (0x02014B50, 0x003F, 0x14, 1 << 11)
        assert method in (0, 8)
        assert (clock >> 11, clock >> 5 & 63, date >> 9, date >> 5 & 15, date & 31) == (5, 6, 46, 3, 4)
        assert (plain_size, length) == (len(whole), len(encoded))
        assert packed == plain_size or method == 8
        assert fields[11:16] == (0, 0, 0, 0, 0)
        local = struct.unpack_from("<IHHHHHIIIHH", content, fields[16])
        assert local == (0x04034B50, needs, flags, method, clock, date, crc, packed, plain_size, length, 0)
        at += 46 + length
    assert at == start + size
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        assert archive.testzip() is None
        assert {name: archive.read(name) for name in archive.namelist()} == CONTENTS


@needs_data
def test_paths_are_those_of_the_schema() -> None:
    assert DATA is not None
    definitions = json.loads((Path(DATA) / "u3m" / "u3m_schema.json").read_text())["definitions"]
    pattern = re.compile(definitions["relative_file_path"]["pattern"])
    names = (
        "a",
        "a.png",
        "..",
        ".",
        "~",
        "con",
        "CON.png",
        "com1",
        "com0",
        "a b",
        "a.",
        "a ",
        "a:b",
        "x\x01",
        "é",
    )
    paths = [
        *names,
        *(f"{folder}/f.png" for folder in names),
        *(f"t/{name}" for name in names),
        "/a",
        "a/",
        "a//b",
        "",
    ]
    assert {path for path in paths if is_relative_path(path)} == {
        path for path in paths if pattern.search(path)
    }


def written(folder: Path, contents: dict[str, bytes], **options: int) -> Path:
    """An archive by another writer."""
    path = folder / "other.u3ma"
    with zipfile.ZipFile(path, "w", **options) as archive:
        for name, content in contents.items():
            archive.writestr(name, content)
    return path


def test_what_is_read_is_written_again_unchanged(tmp_path: Path) -> None:
    """Sections of others, files that nothing names, and a folder in the archive."""
    document = {
        "schema": "1.1",
        "custom": {"Other": {"file": "other_custom/data.bin", "β": [1, None, 0.1]}},
        "material": {"name": "x", "front": None, "metadata": {"price": 3}},
    }
    contents = {"x.u3m": json.dumps(document).encode(), "other_custom/data.bin": b"\0\1", "notes.txt": b"n"}
    path = written(tmp_path, {f"inner/{name}": content for name, content in contents.items()})
    found = read_u3m(path)
    assert (found.name, found.document) == ("x", document)
    write_u3ma(tmp_path / "again.u3ma", found)
    again = read_u3m(tmp_path / "again.u3ma")
    assert (again.document, dict(again.files)) == (
        document,
        {k: v for k, v in contents.items() if k != "x.u3m"},
    )


GOOD = json.dumps({"material": {"front": {"preview": {"path": "p.png"}}}}).encode()


@pytest.mark.parametrize(
    ("contents", "says"),
    [
        ({"a.u3m": GOOD}, '"p.png", which it names, is missing'),
        ({"a.u3m": GOOD, "b.u3m": GOOD}, "it holds 2 files .u3m"),
        ({"p.png": b""}, "it holds 0 files .u3m"),
        ({"a.u3m": b"[]"}, "it is no U3M"),
        ({"a.u3m": b"[" * 5000}, "it is no U3M"),
        ({"a.u3m": b"\xff\xfe"}, "is not UTF-8"),
        ({"a.u3m": GOOD.replace(b"p.png", b"../p.png")}, "files lie beside a U3M or below it"),
        ({"a.u3m": GOOD, "../p.png": b""}, "whose name no U3M archive may have"),
        ({"a.u3m": GOOD, "/etc/p.png": b""}, "whose name no U3M archive may have"),
        ({"a.u3m": GOOD, "P.png": b"", "p.png": b""}, "twice"),
        ({"in/a.u3m": GOOD, "p.png": b""}, "lies outside the folder"),
    ],
)
def test_faults_of_archives_are_one_sentence(contents: dict[str, bytes], says: str, tmp_path: Path) -> None:
    path = written(tmp_path, contents)
    with pytest.raises(InputError, match=re.escape(says)) as refused:
        read_u3m(path)
    assert "\n" not in str(refused.value)
    assert str(path) in str(refused.value)


def test_bombs_are_refused(tmp_path: Path) -> None:
    """By what an entry declares, and where it declares too little, by what comes out of it."""
    path = written(tmp_path, {"a.u3m": GOOD, "p.png": bytes(1 << 20)}, compression=zipfile.ZIP_DEFLATED)
    with (
        patch("loomlight.sources.u3m_file.MAX_FILE", 1 << 16),
        pytest.raises(InputError, match="larger than"),
    ):
        read_u3m(path)
    content = path.read_bytes()
    path.write_bytes(content.replace(struct.pack("<I", 1 << 20), struct.pack("<I", 100)))
    with pytest.raises(InputError, match="can be read"):
        read_u3m(path)


def test_no_archive_and_a_truncated_one_are_refused(tmp_path: Path) -> None:
    path = written(tmp_path, {"a.u3m": GOOD, "p.png": bytes(100)})
    content = path.read_bytes()
    for broken in (b"", b"PK", content[:60], content[60:], content.replace(b"PK\3\4", b"PK\3\5")):
        path.write_bytes(broken)
        with pytest.raises(InputError, match="no U3M archive that can be read"):
            read_u3m(path)


# --------------------------------------------------------------------------------------------------- commands


def test_the_command_writes_an_archive_and_a_folder(tmp_path: Path) -> None:
    found = U3mFile("cloth", {"material": {"preview": {"path": "textures/a.png"}}}, {"textures/a.png": b"1"})
    with patch.object(u3m, "u3m_of", return_value=(found, {"front": 1})) as asked:
        for target, out in (("u3m", "cloth"), ("u3ma", "cloth.u3ma")):
            given = ["twill 2/1", "--to", target, "--dpi", "100", "-o", str(tmp_path / out)]
            assert run(["export", *given]) == 0
    assert [call.args[1:] for call in asked.call_args_list] == [("lobes", 100.0)] * 2
    for path in (tmp_path / "cloth" / "cloth.u3m", tmp_path / "cloth.u3ma"):
        again = read_u3m(path)
        assert (again.document, dict(again.files)) == (found.document, found.files)
    assert json.loads((tmp_path / "cloth" / "manifest.json").read_text())["front"] == 1


def test_the_command_packs_a_folder_and_keeps_what_others_wrote(tmp_path: Path) -> None:
    document = {"material": {"name": "x", "front": {"alpha": None}}, "custom": {"Other": "kept"}}
    (tmp_path / "x.u3m").write_text(json.dumps(document))
    assert run(["export", str(tmp_path / "x.u3m"), "--to", "u3ma", "-o", str(tmp_path / "y.u3ma")]) == 0
    assert read_u3m(tmp_path / "y.u3ma").document == document
    assert run(["export", str(tmp_path / "y.u3ma"), "--to", "u3m", "-o", str(tmp_path / "y")]) == 0
    assert read_u3m(tmp_path / "y" / "x.u3m").document == document


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["--to", "u3ma", "-o", "cloth"], "ends in .u3ma"),
        (["--to", "u3m", "--dpi", "3", "-o", "cloth"], "30 to 2400"),
        (["--to", "gltf", "--dpi", "300", "-o", "cloth"], "leave out --dpi"),
        (["--to", "u3m", "--distance", "1", "-o", "cloth"], "leave out --distance"),
        (["--to", "u3ma", "-o", "none/cloth.u3ma"], "does not exist; make it first"),
    ],
)
def test_faults_leave_nothing(arguments: list[str], says: str, refused: Callable[..., str]) -> None:
    assert says in refused(arguments, lambda given: run(["export", "twill 2/1", *given]))


@pytest.mark.parametrize("to", [slow("u3m"), "u3ma"])
def test_a_garment_is_a_material_for_each_of_its_fabrics(tmp_path: Path, to: str) -> None:
    with patch.object(u3m, "_MIN_SIDE", 16), few_queries():
        folder = export(
            FABRIC, to, tmp_path / "coat", dpi=60, cloths={"lining": "plain", "cuffs": Worn("twill 2/1")}
        )
    found = {"twill-3-1": FABRIC.name, "lining": "plain", "cuffs": "twill 2/1"}
    materials = json.loads((folder / "manifest.json").read_text())["materials"]
    assert {part: said["fabric"] for part, said in materials.items()} == found
    for part, name in found.items():
        place = folder / f"{part}.u3ma" if to == "u3ma" else next((folder / part).glob("*.u3m"))
        assert read_u3m(place).document["material"]["name"] == name


@pytest.mark.parametrize(
    ("cloths", "words"),
    [
        ({"lining": Worn("plain", turn=30)}, "--cloth lining: turn is of a mesh"),
        ({"twill-3-1": "plain"}, 'Two cloths would be written as "twill-3-1"'),
        ({"lining": "no such weave"}, "no such weave"),
    ],
)
def test_cloths_that_cannot_be_written_leave_nothing(
    tmp_path: Path, cloths: dict[str, Any], words: str
) -> None:
    with patch.object(u3m, "_MIN_SIDE", 16), few_queries(), pytest.raises(InputError, match=re.escape(words)):
        export(FABRIC, "u3m", tmp_path / "coat", dpi=60, cloths=cloths)
    assert list(tmp_path.iterdir()) == []
