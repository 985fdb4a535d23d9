"""What every reader is asked: it reads its file wherever that lies, and refuses others in one sentence."""

from __future__ import annotations

import contextlib
import io
import os
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
    "weights": Reader(".safetensors", WEIGHTS.read_bytes, read_weights_alone),
}  # fmt: skip


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


@every_reader
@pytest.mark.parametrize(
    "content", [b"", b"\x00" * 64, bytes(range(256)) * 8], ids=["empty", "zeros", "bytes"]
)
def test_other_content_is_refused(name: str, content: bytes, tmp_path: Path) -> None:
    file = put(name, tmp_path)
    file.write_bytes(content)
    refusal(READERS[name].read, file, file.name)
    assert file.read_bytes() == content


@every_reader
@pytest.mark.parametrize("share", [0.1, 0.5, 0.9])
def test_a_file_that_ends_early_is_refused(name: str, share: float, tmp_path: Path) -> None:
    file = put(name, tmp_path)
    file.write_bytes(content_of(name)[: int(share * len(content_of(name)))])
    if READERS[name].is_lines and share > 0.5:
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
