"""The weights file: what is written comes back, what is wrong is one sentence, and what ships is small.

Covers: studies/papers/chen2024/training/weights_file.py
"""

from __future__ import annotations

import json
import shutil
from importlib.resources import files
from pathlib import Path

import numpy as np
import pytest
from safetensors.numpy import load_file, save_file
from safetensors.torch import load_file as load_torch

from loomlight.core.errors import InputError
from loomlight.models.neural.weights import (
    SCHEMA,
    decoder_shapes,
    encoder_path,
    read_weights,
    shipped_weights,
)
from studies.papers.chen2024.training.weights_file import write_weights
from tests.helpers.neural_networks import TABLES, network, written


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return written(network("field"), tmp_path_factory.mktemp("weights") / "a.safetensors", half=True)


def header_of(path: Path) -> dict:
    data = path.read_bytes()
    size = int.from_bytes(data[:8], "little")
    return json.loads(json.loads(data[8 : 8 + size])["__metadata__"]["neural"])


def test_what_is_written_comes_back(file: Path, tmp_path: Path) -> None:
    actual = read_weights(file)
    state = network("field").state_dict()
    assert set(actual.tensors) == set(state)
    assert actual.table == network("field").table
    for name, values in actual.tensors.items():
        assert values.dtype == np.float32
        # Half precision: 11 bits.
        np.testing.assert_allclose(values, state[name].numpy(), rtol=2**-11, atol=1e-7)
    assert len(actual.sha256) == 64
    again = written(network("field"), tmp_path / "b.safetensors", half=True)
    assert again.read_bytes() == file.read_bytes()


def test_the_checksum_names_the_content(file: Path, tmp_path: Path) -> None:
    other = written(network("field"), tmp_path / "b.safetensors", half=True, recipe={"steps": 1})
    assert read_weights(other).sha256 != read_weights(file).sha256


def test_torch_reads_the_same_file(file: Path) -> None:
    made = network("field")
    made.load_state_dict({name: values.float() for name, values in load_torch(file).items()})


@pytest.mark.parametrize("name", TABLES)
def test_shapes_are_those_of_torch(name: str) -> None:
    made = network(name)
    actual = {key: tuple(values.shape) for key, values in made.decoder.state_dict(prefix="decoder.").items()}
    assert decoder_shapes(made.table) == actual


def rewritten(file: Path, path: Path, change: dict) -> Path:
    """The file with another header."""
    header = header_of(file)
    header["network"] |= change
    save_file(load_file(file), path, {"neural": json.dumps(header)})
    return path


def test_unusable_files_are_one_sentence(file: Path, tmp_path: Path) -> None:
    data = bytearray(file.read_bytes())
    (tmp_path / "cut").write_bytes(data[: len(data) // 2])
    data[-3] ^= 0x40
    (tmp_path / "flipped").write_bytes(data)
    save_file({"a": np.zeros(3, np.float32)}, tmp_path / "foreign")
    (tmp_path / "text").write_text("no weights")
    save_file(load_file(file), tmp_path / "no header", {"neural": "{"})
    rewritten(file, tmp_path / "older", {"schema": 0})
    rewritten(file, tmp_path / "newer", {"schema": SCHEMA + 1})
    rewritten(file, tmp_path / "other shape", {"shape": {"hidden": 7}})
    other = network("plain, not fused")
    state = {name: values.numpy() for name, values in other.state_dict().items()}
    given = {"linear_diffuse": False, "recipe": {}, "provenance": {}}
    write_weights(tmp_path / "other tensors", network("field").table, state, **given)
    expected = {
        "cut": "damaged",
        "flipped": "checksum",
        "foreign": "without the entry neural",
        "text": "no weights file",
        "no header": "header is damaged",
        "older": "schema is 0",
        "newer": "install a newer loomlight",
        "other shape": "checksum",
        "other tensors": "not those of the network in its header",
        "absent": "does not exist",
    }
    for name, part in expected.items():
        with pytest.raises(InputError, match=part) as caught:
            read_weights(tmp_path / name)
        assert str(caught.value).startswith(str(tmp_path / name))
        assert "\n" not in str(caught.value)


def test_weights_need_their_encoder_beside_them(file: Path, tmp_path: Path) -> None:
    path = Path(shutil.copy(file, tmp_path / "a.safetensors"))
    good = encoder_path(file).read_bytes()
    other = encoder_path(written(network("vector, published"), tmp_path / "other.safetensors")).read_bytes()
    flipped = bytearray(good)
    flipped[len(good) // 2] ^= 0x40
    unsealed = bytearray(good)
    unsealed[-5] ^= 0x40
    expected = {
        "is not beside it": None,
        "exported from other weights": other,
        "no exported encoder, or damaged": bytes(flipped),
        "or damaged: ": good[: len(good) // 2],
        "encoder, or damaged": bytes(unsealed),
        "it is no exported": b"",
    }
    for part, data in expected.items():
        if data is not None:
            encoder_path(path).write_bytes(data)
        with pytest.raises(InputError, match=part) as caught:
            read_weights(path)
        said = str(caught.value)
        assert said.startswith(str(tmp_path))
        assert f"`python -m studies.papers.chen2024.training.export {path}` writes it" in said
        assert "\n" not in said
    encoder_path(path).write_bytes(good)
    assert read_weights(path).encoder == good


def test_weights_beyond_half_precision_are_refused(tmp_path: Path) -> None:
    made = network("field")
    made.decoder.hole[1].bias.data.fill_(1e6)
    with pytest.raises(ValueError, match=r"decoder\.hole\.1\.bias"):
        written(made, tmp_path / "large.safetensors", half=True)
    assert not list(tmp_path.iterdir())


def test_the_package_ships_a_network_of_at_most_six_megabytes() -> None:
    folder = files("loomlight.models.neural") / "weights"
    assert 1e5 < sum(len(path.read_bytes()) for path in folder.iterdir()) <= 6e6
    assert shipped_weights().table.latent in ("field", "vector")
