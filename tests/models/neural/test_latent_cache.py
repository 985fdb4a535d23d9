"""Latents are cached in memory and on disk, and computed again if a file is damaged."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from drjit.llvm.ad import Float

from loomlight.core.files import cache_folder
from loomlight.core.llvm import require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.models.neural.encoding import clear_encodings, encode
from tests.helpers.neural_networks import network, weights_of

require_llvm()


def test_a_fabric_is_encoded_once(runs: list[str], tmp_path: Path) -> None:
    weights, twill = weights_of(network("field"), tmp_path), fabric_from_text("twill 2/1")
    first = encode(twill, weights, Float)
    assert encode(twill, weights, Float) is first
    clear_encodings()
    kept = encode(twill, weights, Float)
    assert len(runs) == 1
    for mine, yours in zip(first.faces, kept.faces, strict=True):
        np.testing.assert_array_equal(mine, yours)
    # Front and back of a twill 2/1 are different cloth.
    assert np.abs(first.faces[0] - first.faces[1]).max() > 1e-2


@pytest.mark.slow
def test_what_the_encoder_sees_is_encoded_anew(runs: list[str], tmp_path: Path) -> None:
    weights = weights_of(network("field"), tmp_path)
    base = "[warp]\nroughness = {}\nheight_scale = {}\ntwist_deg = {}\ninclination_deg = {}\ncolor = '{}'"
    values = [0.3, 0.8, 0.0, 20.0, "#ff0000"]
    edits = [{}, {0: 0.4}, {1: 0.7}, {2: 10.0}, {3: 25.0}, {4: "#00ff00"}]
    for edit in edits:
        text = base.format(*(edit.get(k, value) for k, value in enumerate(values)))
        encode(fabric_from_text(f'weave = "plain"\n{text}'), weights, Float)
    # All but the colour.
    assert len(runs) == 5


def test_damaged_caches_are_made_again(runs: list[str], tmp_path: Path) -> None:
    weights, plain = weights_of(network("field"), tmp_path), fabric_from_text("plain")
    encode(plain, weights, Float)
    (file,) = cache_folder("neural").iterdir()
    file.write_bytes(file.read_bytes()[:100])
    clear_encodings()
    encode(plain, weights, Float)
    assert len(runs) == 2
