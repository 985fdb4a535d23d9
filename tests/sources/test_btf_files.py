"""Measured BTFs: synthetic files of both formats, written here, come back; damaged ones are refused.

Covers: sources/btf.py, models/texture/btfs.py
"""

from __future__ import annotations

import struct
import zipfile
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Array3f
from numpy.typing import NDArray
from PIL import Image

from loomlight.cli.main import run
from loomlight.core.colour import linear_to_srgb
from loomlight.core.errors import InputError
from loomlight.core.footprint import Box, box_footprint
from loomlight.models.registry import model_from_loom
from loomlight.models.texture.btfs import PictureBtf
from loomlight.sources.btf import MeasuredBtf, read_btf
from loomlight.sources.load import load_source
from loomlight.sources.loom_file import LoomFile, read_loom, write_loom
from tests.marks import slow

WIDTH, HEIGHT = 8, 6
# Polar angles and azimuths in degrees.
LIGHTS = [(0, 0), (45, 0), (45, 120), (45, 240)]
VIEWS = [(0, 0), (30, 90), (60, 270)]
TOML = 'btf = "{}"\nsize_mm = [4.0, 3.0]\n'


def colours() -> NDArray[np.float64]:
    """π f·cos [views, lights, rows, columns, 3]: a wave whose brightness falls with the light's angle."""
    row, column = np.meshgrid(np.arange(HEIGHT), np.arange(WIDTH), indexing="ij")
    wave = 0.5 + 0.3 * np.sin(2 * np.pi * column / WIDTH) + 0.1 * np.cos(2 * np.pi * row / HEIGHT)
    light = np.cos(np.radians([polar for polar, _ in LIGHTS]))
    view = 1 - np.array([polar for polar, _ in VIEWS]) / 180
    tint = np.array([1.0, 0.7, 0.4])
    return np.einsum("v,l,yx,c->vlyxc", view, light, wave, tint)


def write_2003(path: Path, count: int | None = None, deflated: bool = False) -> None:
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED if deflated else zipfile.ZIP_STORED) as archive:
        pairs = [(v, k) for v in range(len(VIEWS)) for k in range(len(LIGHTS))]
        for v, k in pairs[:count]:
            (tl, pl), (tv, pv) = LIGHTS[k], VIEWS[v]
            held = BytesIO()
            pixels = np.rint(255 * linear_to_srgb(colours()[v, k])).astype(np.uint8)
            Image.fromarray(pixels).save(held, "JPEG", quality=100, subsampling=0)
            archive.writestr(f"sample/tl{tl:03} pl{pl:03} tv{tv:03} pv{pv:03}.jpg", held.getvalue())


def write_2014(path: Path, yuv: bool = False, scalar: str = "<f4", version: int = 3) -> None:
    values = colours()[:, :, ::-1].reshape(len(VIEWS) * len(LIGHTS), WIDTH * HEIGHT, 3)
    if yuv:
        # Grey has no chroma: its luminance is that of the first channel.
        channels = [np.log(values[..., 0] + 1e-5), *(np.zeros_like(values[..., 0]) for _ in range(2))]
    else:
        channels = [values[..., k] for k in range(3)]
    extra = b""
    if version > 1:
        extra += struct.pack("<I", 0)
    if version > 2:
        extra += struct.pack("<I", 4) + b"<x/>"
    common = struct.pack(
        "<II80s80s80sf3f", 264 + len(extra), version, b"dome", b"sensor", b"lamp", 2.0, 1.0, 1.0, 1.0
    )
    held = b"!DFMF08FCR" + common + extra + struct.pack("<I", len(VIEWS))
    lights = b"".join(struct.pack("<2f", *np.radians(pair)) for pair in LIGHTS)
    for view in VIEWS:
        held += struct.pack("<2f", *np.radians(view)) + struct.pack("<I", len(LIGHTS)) + lights
    held += struct.pack("<II", WIDTH, HEIGHT) + struct.pack("<I", 1) + bytes(36)
    held += struct.pack("<II", 2, 11 if yuv else 0) + bytes(48)
    for channel in channels:
        left, singular, right = np.linalg.svd(channel, full_matrices=False)
        left, right = left[:, :2], (singular[:2, None] * right[:2]).T
        held += struct.pack("<BIII", np.dtype(scalar).itemsize, 2, len(left), len(right))
        held += b"".join(
            np.ascontiguousarray(part).astype(scalar).tobytes() for part in (singular[:2], left, right)
        )
    path.write_bytes(held)


def changed(held: bytes, old: tuple[int, int], new: tuple[int, int]) -> bytes:
    """A file with other numbers in the place of two."""
    return held.replace(struct.pack("<II", *old), struct.pack("<II", *new))


def queries() -> tuple[NDArray[np.intp], ...]:
    """Numbers of lights, views, columns and rows."""
    rng = np.random.default_rng(0)
    return tuple(rng.integers(n, size=500) for n in (len(LIGHTS), len(VIEWS), WIDTH, HEIGHT))


def order(found: NDArray[np.float32], wanted: list[tuple[int, int]]) -> list[int]:
    """Which of the found directions each of some angles is."""
    polar, azimuth = np.radians(np.array(wanted, np.float64)).T
    vectors = np.stack([np.sin(polar) * np.cos(azimuth), np.sin(polar) * np.sin(azimuth), np.cos(polar)], 1)
    cosines = vectors @ found.T
    assert (cosines.max(axis=1) > 1 - 1e-5).all()
    return [int(k) for k in cosines.argmax(axis=1)]


@pytest.mark.parametrize(
    ("name", "options", "error"),
    [
        ("a.zip", {}, 0.02),  # 8 bits, and JPEG
        ("a.btf", {}, 1e-5),
        ("a.btf", {"scalar": "<f2"}, 2e-3),  # halves
        ("a.btf", {"scalar": "<f8", "version": 1}, 1e-5),
        ("a.btf", {"yuv": True}, 1e-4),
    ],
)
def test_a_file_comes_back(name: str, options: dict[str, object], error: float, tmp_path: Path) -> None:
    write_2003(tmp_path / name) if name.endswith("zip") else write_2014(tmp_path / name, **options)  # type: ignore[arg-type]
    pictures = read_btf(tmp_path / name)
    assert (pictures.width, pictures.height) == (WIDTH, HEIGHT)
    lights, views, columns, rows = queries()
    places = order(pictures.lights, LIGHTS), order(pictures.views, VIEWS)
    found = pictures.pixels(np.array(places[0])[lights], np.array(places[1])[views], columns, rows)
    wanted = colours()[views, lights, rows, columns]
    if "yuv" in options:
        # Luminance without chroma, and the small number that chroma is given beside it.
        wanted = np.repeat(wanted[:, :1], 3, axis=1)
    np.testing.assert_allclose(found, wanted, atol=error)


def test_queries_are_of_measured_directions_and_pixels_lie_upright(tmp_path: Path) -> None:
    write_2014(tmp_path / "a.btf")
    (tmp_path / "a.toml").write_text(TOML.format("a.btf") + "gain = 2.0\n")
    source = load_source(tmp_path / "a.toml")
    assert isinstance(source, MeasuredBtf)
    btf = PictureBtf(source)
    assert btf.measured[0].shape == (4, 3)
    # The middle of the pixel in column 3 of the top row, and of one repeat on.
    x, y = (3 + 0.5) * 0.5, 3.0 - 0.25
    positions = np.array([[x, y], [x + 4, y - 3]], np.float32)
    light, view = (np.tile(part[1], (2, 1)) for part in (btf.measured[0], btf.measured[1]))
    found = btf.values(positions, light, view, (0,))
    np.testing.assert_allclose(found, np.tile(2 * colours()[1, 1, 0, 3] / np.pi, (2, 1)), rtol=1e-4)


@pytest.mark.slow
@pytest.mark.parametrize("name", [slow("a.zip"), "a.btf"])
def test_it_is_fitted_and_rendered_without_the_measurement(name: str, tmp_path: Path) -> None:
    """The mean of what is learned is that of the pictures; only baking again needs the file."""
    (write_2003 if name.endswith("zip") else write_2014)(tmp_path / name)
    (tmp_path / "a.toml").write_text(TOML.format(name))
    loom = tmp_path / "a.loom"
    arguments = ["bake", str(tmp_path / "a.toml"), "--model", "neumip", "-o", str(loom)]
    assert run([*arguments, "--set", "resolution=8", "--set", "steps=300"]) == 0
    (tmp_path / name).unlink()
    model = model_from_loom(loom)
    light, view = Array3f(0, 0, 1), Array3f(0, -0.5, 0.866)
    footprint = box_footprint(Box(Array2f(0, 0), Array2f(4, 3)))
    found = np.pi * model.at(view, footprint).value(light).numpy()[:, 0]
    np.testing.assert_allclose(found, colours()[1, 0].mean(axis=(0, 1)), rtol=0.2)
    with pytest.raises(InputError, match="does not exist"):
        PictureBtf(model.source)  # type: ignore[arg-type]


def test_the_record_names_the_file_alone(tmp_path: Path) -> None:
    write_2014(tmp_path / "a.btf")
    (tmp_path / "a.toml").write_text(TOML.format("a.btf"))
    source = load_source(tmp_path / "a.toml")
    write_loom(tmp_path / "a.loom", LoomFile("neumip", source))
    assert str(tmp_path).encode() not in (tmp_path / "a.loom").read_bytes()
    again = read_loom(tmp_path / "a.loom").source
    assert isinstance(again, MeasuredBtf)
    assert again.pictures().width == WIDTH
    write_2014(tmp_path / "a.btf", scalar="<f2")
    with pytest.raises(InputError, match="is another file than the one that a was made from"):
        again.pictures()


@pytest.mark.parametrize(
    ("damage", "says"),
    [
        (lambda held: held[:100], "is truncated: it ends after 100 bytes"),
        (lambda held: held[:-1], "is truncated"),
        (lambda held: b"!DFMF09" + held[7:], "it is neither a ZIP of UBO 2003 nor a .btf of UBO 2014"),
        (lambda held: held[:10] + struct.pack("<I", 9) + held[14:], "the length of its header is wrong"),
        (lambda held: changed(held, (2, 0), (2, 5)), "its colour model is 5"),
        (lambda held: changed(held, (8, 6), (6, 6)), "other sizes"),
        (lambda held: changed(held, (8, 6), (2**31, 6)), "the number 2147483648"),
        (lambda held: b"PK" + held[2:], "is damaged: File is not a zip file"),
    ],
)
def test_a_damaged_btf_is_one_sentence(
    damage: object, says: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write_2014(tmp_path / "a.btf")
    held = damage((tmp_path / "a.btf").read_bytes())  # type: ignore[operator]
    (tmp_path / "a.btf").write_bytes(held)
    refused(tmp_path, "a.btf", says, capsys)


@pytest.mark.parametrize(
    ("count", "cut", "says"),
    [
        (11, None, "4 lights and 3 views make 12 pictures, and it has 11"),
        (None, 2000, "is damaged"),
        (0, None, "no picture named"),
    ],
)
def test_a_damaged_zip_is_one_sentence(
    count: int | None, cut: int | None, says: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write_2003(tmp_path / "a.zip", count)
    (tmp_path / "a.zip").write_bytes((tmp_path / "a.zip").read_bytes()[:cut])
    refused(tmp_path, "a.zip", says, capsys)


def test_a_wrong_field_is_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    refused(tmp_path, "none.btf", "none.btf does not exist", capsys)
    (tmp_path / "b.toml").write_text(TOML.format("none.btf") + "gian = 2")
    with pytest.raises(InputError, match="did you mean gain"):
        load_source(tmp_path / "b.toml")


def refused(folder: Path, name: str, says: str, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "a.toml").write_text(TOML.format(name))
    assert run(["bake", str(folder / "a.toml"), "--model", "neumip", "-o", str(folder / "a.loom")]) == 2
    error = capsys.readouterr().err
    assert says in error
    assert len(error.splitlines()) == 1
    assert not (folder / "a.loom").exists()


def test_a_damaged_stream_in_a_zip_is_one_sentence(tmp_path: Path) -> None:
    write_2003(tmp_path / "a.zip", deflated=True)
    held = bytearray((tmp_path / "a.zip").read_bytes())
    start = held.index(b".jpg") + 4
    held[start : start + 40] = bytes(range(216, 256))
    (tmp_path / "a.zip").write_bytes(held)
    with pytest.raises(InputError, match=r"a\.zip is damaged: "):
        read_btf(tmp_path / "a.zip")


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize(("yuv", "value"), [(True, 1e30), (False, np.nan), (False, np.inf)])
def test_pixels_that_are_not_finite_are_refused(yuv: bool, value: float, tmp_path: Path) -> None:
    write_2014(tmp_path / "a.btf", yuv=yuv)
    held = (tmp_path / "a.btf").read_bytes()
    (tmp_path / "a.btf").write_bytes(held[: len(held) // 2] + struct.pack("<f", value) * (len(held) // 8))
    pictures = read_btf(tmp_path / "a.btf") if len(held) % 8 == 0 else None
    if pictures is not None:
        with pytest.raises(InputError, match="it has pixels that are no finite numbers"):
            pictures.pixels(*queries())
