"""Queries of materials: Mitsuba's values, filtered inputs, and BSDFs that cannot be learned.

Covers: studies/papers/zeltner2024/layered_materials.py, studies/papers/zeltner2024/layered_textures.py
"""

from __future__ import annotations

import mitsuba as mi
import numpy as np
import pytest

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.mitsuba.material_btf import MaterialBtf, material_bsdf_of
from loomlight.models.texture.queries import footprint_values
from loomlight.sources.material import Material, material_from_xml
from studies.papers.zeltner2024.layered_materials import LAYERED, layered_material
from tests.helpers.directions import upper_directions


def material(body: str) -> Material:
    return material_from_xml(f'<scene version="3.0.0">{body}</scene>', ".", "test", (100, 100))


CHECKERS = """<bsdf type="diffuse"><texture type="checkerboard" name="reflectance">
<rgb name="color0" value="0.8 0.4 0.2"/><rgb name="color1" value="0 0 0"/></texture></bsdf>"""


def test_values_are_filtered_over_the_footprint() -> None:
    btf = MaterialBtf(material(CHECKERS))
    texels = btf.texels(8)
    assert (btf.faces, texels.resolution) == (1, (8, 8))
    count = 20000
    light, view = (upper_directions(np.random.default_rng(seed), count, raised=0.1) for seed in (0, 1))
    positions = np.full((count, 2), 0.25, np.float32)
    levels = np.zeros(count, np.float32)
    point = footprint_values(btf, texels, positions, levels, light, view, (1,))
    colour = np.array([0.8, 0.4, 0.2])
    np.testing.assert_allclose(point, light[:, 2:] * colour / np.pi, rtol=1e-5)
    # The Gaussian of a footprint of twice the repeat sees both colours alike.
    coarse = levels + np.float32(np.log2(2 * texels.resolution[0]))
    whole = footprint_values(btf, texels, positions, coarse, light, view, (2,))
    # 4 · 20 000 points of which half are black: a standard error of 0.4 %.
    np.testing.assert_allclose(whole.sum(0) / point.sum(0), 0.5, atol=0.015)
    again = footprint_values(btf, texels, positions, levels, light, view, (1,))
    np.testing.assert_array_equal(point, again)


def test_inputs_are_textures_and_filtered_moments_of_slopes() -> None:
    source = layered_material("patinated-metal", 32)
    texels = MaterialBtf(source).texels(64)
    assert texels.resolution == (32, 32)
    assert {"normalmap.x", "normalmap.xy", "blendbsdf0.weight"} <= set(texels.inputs)
    fine, coarse = texels.encoder_inputs(0), texels.encoder_inputs(5)
    assert fine.shape == (32, 32, len(texels.inputs))
    assert coarse.shape == (1, 1, len(texels.inputs))
    np.testing.assert_allclose(coarse[0, 0], fine.mean(axis=(0, 1)), atol=1e-5)
    names = [name.rsplit(".", 1)[-1] for name in texels.inputs]
    x, xx = names.index("x"), names.index("xx")
    np.testing.assert_allclose(fine[..., xx], fine[..., x] ** 2, atol=1e-3)
    # What slopes vary within a texel is roughness of a coarse one.
    assert coarse[0, 0, xx] > coarse[0, 0, x] ** 2 + 1e-4
    assert np.abs(fine).max() <= 4


@pytest.mark.parametrize("name", LAYERED)
def test_layered_materials_reflect_no_more_than_arrives(name: str) -> None:
    btf = MaterialBtf(layered_material(name, 32))
    rng = np.random.default_rng(5)
    count = 20000
    u, azimuth = rng.random(count), 2 * np.pi * rng.random(count)
    light = np.stack([np.sqrt(u) * np.cos(azimuth), np.sqrt(u) * np.sin(azimuth), np.sqrt(1 - u)], 1)
    view = np.tile(np.array([[0.3, 0.2, np.sqrt(0.87)]], np.float32), (count, 1))
    positions = rng.random((count, 2), np.float32)
    values = btf.values(positions, light.astype(np.float32), view, (0,))
    albedo = np.pi * (values / np.maximum(light[:, 2:], 1e-4)).mean(0)
    assert albedo.min() > 0.02
    assert albedo.max() < 1


def test_what_cannot_be_learned_is_said() -> None:
    mi.set_variant("llvm_ad_rgb")
    with pytest.raises(InputError, match="test has delta lobes only"):
        material_bsdf_of(material('<bsdf type="conductor"/>'))
    with pytest.raises(InputError, match='no-such-plugin"> cannot be used in it: '):
        material_bsdf_of(material('<bsdf type="no-such-plugin"/>'))
    checkers = '<texture type="checkerboard" name="normalmap"/><bsdf type="diffuse"/>'
    with pytest.raises(InputError, match=r"test, normalmap: .* checkerboard holds no normal map"):
        MaterialBtf(material(f'<bsdf type="normalmap">{checkers}</bsdf>')).texels(8)
    with pytest.warns(LoomlightWarning, match="its mirror reflection is left out"):
        texels = MaterialBtf(material('<bsdf type="plastic"/>')).texels(8)
    assert texels.inputs == ("constant",)
    assert texels.resolution == (1, 1)
