"""MERL files: the public layout, angles, libraries; a truncated file is one sentence.

Covers: models/texture/btfs.py
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from loomlight.cli.main import run
from loomlight.core.errors import InputError
from loomlight.models.texture.btfs import MerlBtf
from loomlight.sources.load import load_source
from loomlight.sources.loom_file import LoomFile, read_loom, write_loom
from loomlight.sources.merl import (
    BINS,
    MerlLibrary,
    is_merl_file,
    library_of,
    merl_record,
    read_merl,
)
from studies.papers.zeltner2024.analytic_brdfs import (
    analytic_brdf,
    analytic_parameters,
    bin_directions,
    write_merl,
)


def directions(count: int, seed: int) -> NDArray[np.float32]:
    found = np.random.default_rng(seed).standard_normal((count, 3))
    found[:, 2] = np.abs(found[:, 2]) + 0.2
    return (found / np.linalg.norm(found, axis=1, keepdims=True)).astype(np.float32)


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An analytic BRDF of alpha 0.3, which bins resolve."""
    path = tmp_path_factory.mktemp("merl") / "satin-paint.binary"
    write_merl(path, analytic_brdf(PARAMETERS, *bin_directions()).reshape(*BINS, 3))
    return path


PARAMETERS = analytic_parameters(3)[1]


def test_the_layout_is_the_public_one(file: Path) -> None:
    data = file.read_bytes()
    assert np.frombuffer(data[:12], "<i4").tolist() == [90, 90, 180]
    assert len(data) == 12 + 3 * 8 * 90 * 90 * 180
    h, d, phi = 20, 30, 50
    index = phi + 180 * (d + 90 * h)
    planes = np.frombuffer(data[12:], "<f8").reshape(3, -1)
    expected = read_merl(file)[h, d, phi]
    scales = np.array([1, 1.15, 1.66]) / 1500
    np.testing.assert_allclose(planes[:, index] * scales, expected, rtol=1e-6)


def test_directions_are_found_in_their_bins(file: Path) -> None:
    source = load_source(file)
    assert isinstance(source, MerlLibrary)
    light, view = directions(4096, 0), directions(4096, 1)
    actual = source.evaluate(np.zeros(4096, np.intp), light, view)
    expected = analytic_brdf(PARAMETERS, light, view) * light[:, 2:]
    # Linear interpolation between bins and half precision.
    assert np.abs(actual - expected).mean() < 0.01 * expected.mean()
    swapped = source.evaluate(np.zeros(4096, np.intp), view, light)
    np.testing.assert_allclose(swapped * light[:, 2:], actual * view[:, 2:], rtol=1e-3, atol=1e-5)


def test_a_library_has_one_input_for_each(file: Path) -> None:
    names = ["a", "b", "c"]
    values = np.zeros((3, *BINS, 3), np.float16)
    values[:] = np.array([1, 2, 3], np.float16)[:, None, None, None, None]
    library = library_of("shelf", names, values)
    btf = MerlBtf(library)
    texels = btf.texels(64)
    assert (texels.inputs, texels.resolution) == (("a", "b", "c"), (2, 2))
    # The fourth cell shows the first again.
    np.testing.assert_array_equal(texels.encoder_inputs(0), np.eye(3)[[0, 1, 2, 0]].reshape(2, 2, 3))
    up = np.tile(np.array([[0, 0, 1]], np.float32), (4, 1))
    centres = np.array([[0.25, 0.25], [0.75, 0.25], [0.25, 0.75], [0.75, 0.75]], np.float32)
    actual = btf.values(centres, up, up, (1,))
    np.testing.assert_allclose(actual[:, 0], [1, 2, 3, 1])


def test_a_loom_keeps_few_and_names_many(file: Path, tmp_path: Path) -> None:
    source = load_source(file)
    assert isinstance(source, MerlLibrary)
    write_loom(tmp_path / "a.loom", LoomFile("latent", source))
    again = read_loom(tmp_path / "a.loom").source
    assert isinstance(again, MerlLibrary)
    assert again.values is not None
    assert source.values is not None
    assert np.array_equal(again.values, source.values)
    many = MerlLibrary("many", tuple("abcdefghi"), None, tuple("abcdefghi"))
    assert merl_record(many)[1] == {}
    write_loom(tmp_path / "b.loom", LoomFile("latent", many))
    named = read_loom(tmp_path / "b.loom").source
    assert isinstance(named, MerlLibrary)
    with pytest.raises(InputError, match="a library of 9 BRDFs, which a"):
        named.evaluate(np.zeros(1, np.intp), directions(1, 0), directions(1, 1))


def test_a_damaged_file_is_known_by_its_name_and_not_baked(
    file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    short = tmp_path / "short.binary"
    with file.open("rb") as stream:
        short.write_bytes(stream.read(1000))
    assert is_merl_file(short)
    assert is_merl_file(tmp_path)
    assert run(["bake", str(short), "--model", "latent", "-o", str(tmp_path / "a.loom")]) == 2
    assert "it is truncated: a MERL file has 34992012 bytes, it has 1000." in capsys.readouterr().err
    assert not (tmp_path / "a.loom").exists()


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("value", [1e300, -1e300, np.nan, np.inf])
def test_numbers_that_no_reflectance_has_are_refused(file: Path, tmp_path: Path, value: float) -> None:
    held = bytearray(file.read_bytes())
    held[8012:8020] = np.array(value, "<f8").tobytes()
    (tmp_path / "a.binary").write_bytes(held)
    with pytest.raises(InputError, match="numbers that no reflectance has"):
        read_merl(tmp_path / "a.binary")
