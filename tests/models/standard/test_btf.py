"""U3M materials as sources of `latent`: values, and texels that say the same of both faces."""

from __future__ import annotations

import math

import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.core.llvm import require_llvm
from loomlight.models.registry import btf_of
from loomlight.models.standard.btf import U3mBtf
from tests.helpers.u3m import image, material, png, visual

require_llvm()
WHITE = {"r": 1, "g": 1, "b": 1}
# The left third is red.
PIXELS = np.zeros((4, 6, 3), np.uint8)
PIXELS[:, :2] = [255, 0, 0]
TEXTURE = {"mode": "multiply", "factor": WHITE, "image": image("a.png")}
FACE = visual(basecolor={"constant": WHITE, "texture": TEXTURE}, specular_value=0, roughness=1)
UP = np.array([[0, 0, 1]], np.float32)


def test_values_are_those_of_the_material() -> None:
    btf = btf_of(material(FACE, a=png(PIXELS)), "latent")
    points = np.array([[0.1, 0.5], [0.6, 0.5], [1.1, -0.5]], np.float32)
    found = btf.values(points, UP.repeat(3, 0), UP.repeat(3, 0), (0,))
    assert found * math.pi == pytest.approx(np.array([[1, 0, 0], [0, 0, 0], [1, 0, 0]]), abs=1e-3)


def test_texels_of_the_back_lie_where_its_values_are() -> None:
    btf = U3mBtf(material(visual(basecolor=(0, 0, 1)), FACE, a=png(PIXELS)))
    assert btf.faces == 2
    texels = btf.texels(64)
    columns, rows = texels.resolution
    assert (columns, rows) == (8, 4)
    red = 0.5 + 0.5 * texels.encoder_inputs(0, 1)[..., 0]
    x, y = np.meshgrid((np.arange(columns) + 0.5) / columns, (np.arange(rows) + 0.5) / rows)
    points = np.stack([x.ravel(), y.ravel()], axis=-1).astype(np.float32)
    down = -UP.repeat(len(points), 0)
    found = math.pi * btf.values(points, down, down, (0,))[:, 0].reshape(rows, columns)
    # The last third from the front; a texel at the edge has parts of both.
    assert (red > 0.9).any(axis=0).tolist() == [False] * 6 + [True] * 2
    assert np.corrcoef(red.ravel(), found.ravel())[0, 1] > 0.9


def test_coarser_levels_are_means() -> None:
    texels = U3mBtf(material(FACE, a=png(PIXELS))).texels(4)
    assert texels.resolution == (4, 4)
    fine, coarse = texels.encoder_inputs(0), texels.encoder_inputs(2)
    assert coarse.shape == (1, 1, len(texels.inputs))
    assert coarse[0, 0] == pytest.approx(fine.mean((0, 1)), abs=1e-6)
    assert texels.slopes.shape == (1, 2, 4, 4, 2)


def test_faces_of_two_sizes_are_refused() -> None:
    wide = {"mode": "multiply", "factor": WHITE, "image": image("a.png", width=20.0)}
    other = visual(basecolor={"constant": WHITE, "texture": wide})
    with pytest.raises(InputError, match="repeats after 12 × 8 mm in front and 20 × 8 mm behind"):
        U3mBtf(material(FACE, other, a=png(PIXELS)))
