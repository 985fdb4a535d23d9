"""What every reader is asked: it reads its file wherever that lies, and refuses others in one sentence."""

from __future__ import annotations

import contextlib
import io
import json
import os
import re
import struct
import tempfile
import zipfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, fields, is_dataclass
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
import OpenEXR
import pytest
from PIL import Image

from loomlight.core.environment_map import read_environment_map
from loomlight.core.errors import InputError
from loomlight.core.images import read_linear, read_map, read_picture
from loomlight.core.spectra import read_spectrum
from loomlight.fabric import fabric_from_text, load_fabric
from loomlight.mesh.reading import read_parts
from loomlight.models.neural.weights import read_weights_alone
from loomlight.sources.btf import read_btf
from loomlight.sources.heightfield import load_heightfield
from loomlight.sources.loom_file import LoomFile, read_loom, write_loom
from loomlight.sources.material import load_material
from loomlight.sources.merl import read_merl
from loomlight.sources.tile import load_tile
from loomlight.weave import load_draft, named_weave
from loomlight.weave.wif_writer import wif_text_of
from tests.fuzz import btf, merl, meshes
from tests.helpers.pictures import png_head
from tests.helpers.users import as_nobody
from tests.work import allocates_at_most

CASES = Path(__file__).parents[1] / "cases" / "drafts"
MAX_SENTENCE = 600


@dataclass(frozen=True, eq=False)
class Reader:
    """A reader of one kind of file.

    Attributes:
        suffix: of its file, with the dot.
        content: a file that it reads, or what makes one.
        read: reads it.
        beside: names and contents of what the file names.
        is_lines: of text, of which the first lines alone may be whole.
    """

    suffix: str
    content: bytes | Callable[[], bytes]
    read: Callable[[Any], object]
    beside: Mapping[str, bytes] = field(default_factory=dict)
    is_lines: bool = False


def picture(kind: str, pixels: np.ndarray) -> bytes:
    held = io.BytesIO()
    Image.fromarray(pixels).save(held, kind)
    return held.getvalue()


def exr() -> bytes:
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "a.exr"
        pixels = np.random.default_rng(1).random((8, 16, 3)).astype(np.float32)
        header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
        OpenEXR.File(header, {"RGB": pixels}).write(str(file))
        return file.read_bytes()


def hdr() -> bytes:
    """Radiance's RGBE, flat: rows of 8 pixels are not run-length coded."""
    pixels = np.random.default_rng(1).integers(100, 140, (4, 7, 4), np.uint8)
    return b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 7\n" + pixels.tobytes()


def loom() -> bytes:
    with tempfile.TemporaryDirectory() as folder:
        write_loom(Path(folder) / "a.loom", LoomFile("point", fabric_from_text("twill 2/1")))
        return (Path(folder) / "a.loom").read_bytes()


def tempoweave() -> bytes:
    held = io.BytesIO()
    with zipfile.ZipFile(held, "w") as archive:
        archive.writestr("twamain.waf", wif_text_of(named_weave("twill 3/1")))
    return held.getvalue()


@cache
def _mesh_originals() -> dict[str, bytes]:
    return {target.name: target.originals[0] for target in meshes.targets()}


def mesh(suffix: str, name: str) -> Reader:
    return Reader(suffix, lambda: _mesh_originals()[name], read_parts, is_lines=name == "obj")


def measured(name: str) -> Callable[[], bytes]:
    return lambda: next(target.originals[0] for target in btf.targets() if target.name == name)


NOISE = np.random.default_rng(3).integers(0, 2, (32, 32), np.uint8) * 255
GREYS = np.random.default_rng(4).integers(0, 256, (16, 32), np.uint8)
PNG = picture("PNG", NOISE)
BSDF = '<bsdf version="3.0.0" type="diffuse"><rgb name="reflectance" value="0.2, 0.4, 0.3"/></bsdf>'
SCENE = f'<scene version="3.0.0"><shape type="rectangle">{BSDF}</shape></scene>'
HEIGHTS = b'height_map = "h.png"\nsize_mm = [4, 2.0]\nheight_mm = 0.5\n'
SPECTRUM = b"nm,R\n" + b"".join(b"%d,0.%d\n" % (nm, nm) for nm in range(400, 710, 10))
WEIGHTS = files("loomlight.models.neural") / "weights" / "neural.safetensors"

READERS = {
    "wif": Reader(".wif", (CASES / "overshot-treadled.wif").read_bytes(), load_draft, is_lines=True),
    "dtx": Reader(".dtx", (CASES / "point-twill.dtx").read_bytes(), load_draft, is_lines=True),
    "twa": Reader(".twa", tempoweave, load_draft),
    "drawdown": Reader(".png", PNG, load_draft),
    "fabric": Reader(".toml", b'weave = "twill 2/1"\n[warp]\ncolor = "#204080"\n', load_fabric),
    "fabric of a draft": Reader(
        ".toml", b'draft = "d.wif"\n', load_fabric,
        {"d.wif": (CASES / "overshot-treadled.wif").read_bytes()},
    ),
    "fabric of a WIF alone": Reader(
        ".wif", (CASES / "overshot-treadled.wif").read_bytes(), load_fabric, is_lines=True
    ),
    "fabric of a picture alone": Reader(".png", PNG, load_fabric),
    "loom": Reader(".loom", loom, read_loom),
    "height field": Reader(".toml", HEIGHTS, load_heightfield, {"h.png": PNG}),
    "tile": Reader(
        ".toml", b'tile = "t.xml"\nsize_mm = [1.0, 1.0]\n', load_tile, {"t.xml": SCENE.encode()}
    ),
    "material": Reader(".xml", BSDF.encode(), load_material),
    "material by name": Reader(
        ".toml", b'material = "m.xml"\n', load_material, {"m.xml": BSDF.encode()}
    ),
    "rgl": Reader(".bsdf", merl.rgl_file, load_material),
    "merl": Reader(".binary", merl.merl_file, read_merl),
    "ubo 2003": Reader(".zip", measured("ubo2003"), read_btf),
    "ubo 2014": Reader(".btf", measured("ubo2014"), read_btf),
    "obj": mesh(".obj", "obj"),
    "ply": mesh(".ply", "ply-ascii"),
    "binary ply": mesh(".ply", "ply-binary"),
    "gltf": mesh(".gltf", "gltf"),
    "glb": mesh(".glb", "glb"),
    "usda": mesh(".usda", "usda"),
    "usdc": mesh(".usdc", "usdc"),
    "usdz": mesh(".usdz", "usdz"),
    "environment": Reader(".exr", exr, read_environment_map),
    "environment in RGBE": Reader(".hdr", hdr, read_environment_map),
    "environment of 8 bits": Reader(".png", picture("PNG", GREYS), read_environment_map),
    "picture": Reader(".png", PNG, read_picture),
    "linear picture": Reader(".exr", exr, read_linear),
    "map": Reader(".tif", picture("TIFF", NOISE.astype(np.uint16)), lambda path: read_map(path, 1)),
    "spectrum": Reader(".csv", SPECTRUM, lambda path: read_spectrum(os.fspath(path), ".", "warp.color")),
    "weights": Reader(".safetensors", WEIGHTS.read_bytes, read_weights_alone),
}  # fmt: skip

_TOML, _PICTURE = "no valid TOML|not UTF-8 text", "is no picture that can be read"
# What refuses an empty file, other bytes, and the first half of a right one.
SAYS = {
    "wif": r"is no weaving information file|the section \[THREADING\] is missing",
    "dtx": r"is no \.dtx draft that can be read",
    "twa": r"is no \.twa draft that can be read",
    "drawdown": _PICTURE,
    "fabric": f"it is empty|{_TOML}",
    "fabric of a draft": f"it is empty|{_TOML}",
    "fabric of a WIF alone": r"is no weaving information file|the section \[THREADING\] is missing",
    "fabric of a picture alone": _PICTURE,
    "loom": r"it is no \.loom file, or damaged",
    "height field": f"height_map is missing|{_TOML}",
    "tile": f"tile is missing|{_TOML}",
    "material": "no valid XML|not UTF-8 text",
    "material by name": f"material is missing|{_TOML}",
    "rgl": "is no measured BSDF of RGL|is truncated or damaged",
    "merl": "it is no MERL file|it is truncated: a MERL file has 34992012 bytes",
    "ubo 2003": "it is neither a ZIP of UBO 2003 nor a .btf of UBO 2014|is damaged: File is not a zip file",
    "ubo 2014": "it is neither a ZIP of UBO 2003 nor a .btf of UBO 2014|is truncated: it ends after",
    "obj": "is empty: it holds no mesh|holds no triangles: it has no faces",
    "ply": "is empty: it holds no mesh|is no PLY file|is cut off or damaged",
    "binary ply": "is empty: it holds no mesh|is no PLY file|is cut off or damaged",
    "gltf": "is empty: it holds no mesh|is damaged: its JSON cannot be read",
    "glb": "is empty: it holds no mesh|is no GLB file|is cut off: it holds",
    "usda": "is empty: it holds no mesh|is damaged or no USD file",
    "usdc": "is empty: it holds no mesh|is damaged or no USD file",
    "usdz": "is empty: it holds no mesh|is damaged or no USD file",
    "environment": "is no EXR file that can be read",
    "environment in RGBE": r"is no Radiance picture \(\.hdr\)|is damaged: its data end early",
    "environment of 8 bits": _PICTURE,
    "picture": _PICTURE,
    "linear picture": "is no EXR file that can be read",
    "map": _PICTURE,
    "spectrum": "holds no spectrum|measures 400 to|is no text of comma-separated values",
    "weights": "it is no weights file, or damaged",
}


@cache
def content_of(name: str) -> bytes:
    content = READERS[name].content
    return content if isinstance(content, bytes) else content()


def put(name: str, folder: Path, stem: str = "cloth") -> Path:
    """A file that the reader takes, with what it names."""
    reader = READERS[name]
    for other, content in reader.beside.items():
        (folder / other).write_bytes(content)
    file = folder / f"{stem}{reader.suffix}"
    file.write_bytes(content_of(name))
    return file


def told(value: object, folder: str) -> object:
    """All that a reader answers, to be compared: paths within the folder without it."""
    if isinstance(value, np.ndarray):
        return value.dtype.str, value.shape, value.tobytes()
    if is_dataclass(value):
        return {each.name: told(getattr(value, each.name), folder) for each in fields(value)}
    if isinstance(value, Mapping):
        return {key: told(each, folder) for key, each in value.items()}
    if isinstance(value, str | os.PathLike):
        return os.fspath(value).replace(folder, "").strip("/.")
    if isinstance(value, Sequence):
        return [told(each, folder) for each in value]
    return repr(value) if isinstance(value, int | float | bool | None | bytes) else type(value).__name__


def refusal(read: Callable[[Any], object], path: object, names: str) -> str:
    """The sentence of a refusal, which names the file."""
    with pytest.raises(InputError) as caught:
        read(path)
    sentence = str(caught.value)
    assert names in sentence
    assert sentence.isprintable(), sentence
    assert sentence.endswith((".", "?")), sentence
    assert len(sentence) <= MAX_SENTENCE + len(str(path))
    return sentence


every_reader = pytest.mark.parametrize("name", READERS)
# Of what a small mesh or a draft leaves out; the tests of each reader have those sentences.
pytestmark = pytest.mark.filterwarnings("ignore::loomlight.core.errors.LoomlightWarning")


@every_reader
def test_the_answer_is_the_same_by_any_path(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Absolute and relative, as a string, through a link and from a folder whose name is no ASCII."""
    read = READERS[name].read
    file = put(name, tmp_path)
    expected = told(read(file), str(tmp_path))
    before = file.read_bytes(), file.stat().st_mtime_ns
    monkeypatch.chdir(tmp_path)
    assert told(read(file.name), str(tmp_path)) == expected
    assert told(read(str(file)), str(tmp_path)) == expected
    assert (file.read_bytes(), file.stat().st_mtime_ns) == before
    elsewhere = tmp_path / "Größe 1 % & 織物"
    elsewhere.mkdir()
    there = put(name, elsewhere)
    assert told(read(there), str(elsewhere)) == expected
    assert {path.name for path in elsewhere.iterdir()} == {there.name, *READERS[name].beside}


# Contents by what the file that is read has.
OTHERS: dict[str, Callable[[bytes], bytes]] = {
    "empty": lambda content: b"",
    "zeros": lambda content: bytes(64),
    "bytes": lambda content: bytes(range(256)) * 8,
    "beginning": lambda content: content[:5],
    "beginning and zeros": lambda content: content[:16] + bytes(200),
    "half": lambda content: content[: len(content) // 2],
}


@every_reader
@pytest.mark.parametrize("other", OTHERS)
def test_other_content_is_refused(
    name: str, other: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    """In a sentence of its reader; the libraries behind it say nothing."""
    file = put(name, tmp_path)
    content = OTHERS[other](content_of(name))
    file.write_bytes(content)
    sentence = refusal(READERS[name].read, file, file.name)
    assert re.search(SAYS[name], sentence), sentence
    assert file.read_bytes() == content
    assert capfd.readouterr() == ("", "")


@every_reader
def test_a_file_that_lacks_its_end_is_refused(name: str, tmp_path: Path) -> None:
    file = put(name, tmp_path)
    file.write_bytes(content_of(name)[: int(0.9 * len(content_of(name)))])
    if READERS[name].is_lines:
        with contextlib.suppress(InputError):
            READERS[name].read(file)
        return
    refusal(READERS[name].read, file, file.name)


@every_reader
def test_what_is_no_file_is_refused(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    read, suffix = READERS[name].read, READERS[name].suffix
    assert "does not exist" in refusal(read, tmp_path / f"none{suffix}", f"none{suffix}")
    (tmp_path / f"folder{suffix}").mkdir()
    assert "is a folder" in refusal(read, tmp_path / f"folder{suffix}", f"folder{suffix}")
    os.mkfifo(tmp_path / f"pipe{suffix}")
    assert "is no ordinary file" in refusal(read, tmp_path / f"pipe{suffix}", f"pipe{suffix}")
    (tmp_path / f"link{suffix}").symlink_to("nowhere")
    refusal(read, tmp_path / f"link{suffix}", f"link{suffix}")
    refusal(read, tmp_path / f"a\0b{suffix}", f"b{suffix}")
    refusal(read, tmp_path / f"{'x' * 400}{suffix}", f"{'x' * 40}{suffix}")


@every_reader
def test_a_file_that_may_not_be_read_is_refused(name: str) -> None:
    """Closed itself, and in a closed folder."""
    with tempfile.TemporaryDirectory() as place:
        Path(place).chmod(0o755)
        closed = put(name, Path(place), "closed")
        closed.chmod(0)
        (Path(place) / "in").mkdir()
        within = put(name, Path(place) / "in")
        READERS[name].read(within)  # modules that it imports may lie where nobody else reads
        within.parent.chmod(0)
        with as_nobody():
            sentences = [refusal(READERS[name].read, file, file.name) for file in (closed, within)]
        within.parent.chmod(0o700)
        assert all("cannot be read: Permission denied." in sentence for sentence in sentences)


@pytest.mark.parametrize(
    "name", [name for name, reader in READERS.items() if reader.suffix in (".toml", ".xml")]
)
def test_texts_are_bounded(name: str, tmp_path: Path) -> None:
    file = put(name, tmp_path)
    file.write_bytes(b"#" * (4 * 2**20 + 1))
    assert "is larger than 4 MiB" in refusal(READERS[name].read, file, file.name)


def _exr_of(side: int) -> bytes:
    content = exr()
    at = content.index(b"dataWindow\0box2i\0") + len(b"dataWindow\0box2i\0") + 4
    return content[:at] + struct.pack("<4i", 0, 0, side - 1, side - 1) + content[at + 16 :]


def png_of(side: int) -> bytes:
    with tempfile.TemporaryDirectory() as folder:
        return png_head(Path(folder) / "a.png", side, side).read_bytes()


def _gltf_of(count: int) -> bytes:
    tree = json.loads(content_of("gltf"))
    tree["accessors"][0]["count"] = count
    return json.dumps(tree).encode()


# A billion of whatever it is and nothing of it, and what refuses that.
DECLARED: dict[str, tuple[Callable[[], bytes], str]] = {
    "drawdown": (lambda: png_of(60_000), "has 60000 x 60000 pixels; .* at most 16384 ends and picks"),
    "environment of 8 bits": (lambda: png_of(60_000), "has 60000 x 60000 pixels; at most 16384 a side"),
    "picture": (lambda: png_of(60_000), "has 60000 x 60000 pixels; at most 16384 a side"),
    "loom": (lambda: struct.pack("<Q", 2**62) + b"{", r"it is no \.loom file"),
    "weights": (lambda: struct.pack("<Q", 2**62) + b"{", "it is no weights file"),
    "merl": (lambda: struct.pack("<3i", 90, 90, 180), "has 34992012 bytes, it has 12"),
    "rgl": (lambda: b"tensor_file\0" + struct.pack("<BBI", 1, 0, 2**32 - 1), "its header cannot be read"),
    "ply": (
        lambda: content_of("ply").replace(b"element vertex ", b"element vertex 99999999"),
        'fewer than 9999999925 rows of "vertex"',
    ),
    "binary ply": (
        lambda: content_of("binary ply").replace(b"element face ", b"element face 99999999"),
        'fewer than 9999999916 rows of "face"',
    ),
    "gltf": (lambda: _gltf_of(10**9), "1000000000 elements of 12 bytes do not fit"),
    "environment in RGBE": (
        lambda: b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 60000 +X 60000\n",
        "has 60000 x 60000 pixels, which its data do not hold"
    ),
    "environment": (lambda: _exr_of(60_000), "has 60000 x 60000 pixels; at most 16384 a side"),
    "linear picture": (lambda: _exr_of(60_000), "has 60000 x 60000 pixels; at most 16384 a side"),
}  # fmt: skip


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("name", DECLARED)
def test_what_a_file_declares_without_holding_it_takes_no_memory(name: str, tmp_path: Path) -> None:
    content, says = DECLARED[name]
    file = put(name, tmp_path)
    file.write_bytes(content())
    with allocates_at_most(1 << 22):
        sentence = refusal(READERS[name].read, file, file.name)
    assert re.search(says, sentence), sentence
