"""The material of six layers: that it has them, each with textures of its own, and how its speed is told.

Covers: studies/papers/zeltner2024/six_layers.py
"""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from loomlight.mitsuba import choose_variant
from loomlight.mitsuba.material_btf import MaterialBtf
from studies.papers.zeltner2024 import six_layers, speed, stage
from studies.papers.zeltner2024.six_layers import LAYERS, SIX_LAYERS

# What holds other BSDFs: a blend of two layers, and a map of the normals of one.
_BLEND, _TILTED = "blendbsdf", "normalmap"


def layers_of(bsdf: ElementTree.Element) -> list[ElementTree.Element]:
    """Parts of nested blends that are none themselves."""
    if bsdf.get("type") != _BLEND:
        return [bsdf]
    return [layer for part in bsdf.findall("bsdf") for layer in layers_of(part)]


def test_six_layers_have_textures_of_their_own() -> None:
    source = stage.stage_material(SIX_LAYERS, 128)
    root = ElementTree.fromstring(source.xml)
    layers = layers_of(root)
    assert len(layers) == len(LAYERS) == 6
    read = [
        {str(found.get("value")) for found in layer.iter("string") if found.get("name") == "filename"}
        for layer in layers
    ]
    assert all(read)
    assert max(Counter(file for files in read for file in files).values()) == 1
    # Three of them lean by normal maps of their own, and all but the lowest lie over others by a texture.
    assert [layer.get("type") for layer in layers].count(_TILTED) == 3
    assert len([blend for blend in root.iter("bsdf") if blend.get("type") == _BLEND]) == 5


def test_every_layer_is_seen() -> None:
    textures = six_layers._textures(64)
    above = np.ones((64, 64))
    for layer in reversed(LAYERS[1:]):
        assert (above * textures[layer]).mean() > 0.02
        above = above * (1 - textures[layer])
    assert above.mean() > 0.02


def test_it_is_a_material_to_learn() -> None:
    """All textures are inputs that vary, and the tree reflects some of its light and no more than it gets."""
    choose_variant()
    btf = MaterialBtf(stage.six_layer_material(64))
    texels = btf.texels(64)
    assert texels.slopes.shape == (1, 4, 64, 64, 2)
    assert (texels.encoder_inputs(0).std(axis=(0, 1)) > 0).all()
    rng = np.random.default_rng(1)
    count = 1 << 14
    up = np.tile(np.array([[0, 0, 1]], np.float32), (count, 1))
    height, turn = np.sqrt(rng.random(count)), 2 * np.pi * rng.random(count)
    across = np.sqrt(1 - height**2)
    lights = np.stack([across * np.cos(turn), across * np.sin(turn), height], 1).astype(np.float32)
    values = btf.values(rng.random((count, 2)).astype(np.float32), lights, up, (0,))
    # f·cos over the density of cosines is the albedo.
    albedo = (values / (height[:, None] / np.pi)).mean(axis=0)
    assert (albedo > 0.05).all()
    assert (albedo < 0.6).all()


def test_speedups_are_over_the_reference() -> None:
    actual = speed._speedups({"reference": 4.0, "2x32": 2.0})
    assert actual == {"reference": 4.0, "2x32": 2.0, "speedup 2x32": 2.0}


def compiled(*given: object) -> int:
    """How many of a process's first kernels are compiled, found neither in memory nor on disk."""
    import drjit as dr
    from drjit.llvm import Float

    dr.set_flag(dr.JitFlag.KernelHistory, True)
    dr.eval(dr.sqrt(dr.arange(Float, 8)))
    return sum(not (kernel["cache_hit"] or kernel["cache_disk"]) for kernel in dr.kernel_history())


@pytest.mark.slow
def test_first_pictures_find_no_kernels(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A process of its own compiles them again, even those of the process before it."""
    monkeypatch.setattr(speed, "_timed", compiled)
    settings = stage.StageSettings(size=(16, 9), spp=1)
    given = "rough-plastic", "reference", settings, tmp_path
    assert [speed._in_a_new_process(*given, turns=2) for _ in range(2)] == [1, 1]
