"""The model neumip in Slang against Dr.Jit: interpolated texels, whole queries, and frames.

The bar is that of `queries.py` for single precision. No query searches along rays, so no value may miss it.

Covers: models/texture/tables.py
"""

from __future__ import annotations

import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.core.footprint import Footprint
from loomlight.fabric import fabric_from_text
from loomlight.models.texture.neumip import CHANNELS, NeumipModel
from loomlight.realtime import Camera, Cloth, DirectionalLight, Renderer, rectangle
from loomlight.realtime.words import Packed, pack_fabrics
from tests.helpers.arrays import pairs, vectors
from tests.helpers.directions import clear_of_the_plane
from tests.helpers.parity import share_beyond
from tests.helpers.slang import mapped
from tests.helpers.untrained import random_neumip

COUNT = 4096


def packed(model: NeumipModel, half: bool = False) -> Packed:
    return pack_fabrics([None], None, [model.shader_tables(half)])


@pytest.mark.slow
@pytest.mark.parametrize(("faces", "offset"), [(2, True), (1, False)])
def test_queries_of_neumip(faces: int, offset: bool) -> None:
    """Footprints of 10 µm to 10 mm, elongated and turned, views and lights all over the sphere."""
    model = random_neumip(faces, offset)
    rng = np.random.default_rng(5)
    centre = np.float32(rng.uniform(-8, 8, (COUNT, 2)))
    light, view = clear_of_the_plane(rng, COUNT), clear_of_the_plane(rng, COUNT)
    side = np.exp(rng.uniform(np.log(0.01), np.log(10), COUNT))
    angle, ratio = rng.uniform(0, 2 * np.pi, COUNT), rng.uniform(0.1, 1, COUNT)
    cosine, sine = side * np.cos(angle), side * np.sin(angle)
    dx = np.float32(np.stack([cosine, sine], axis=1))
    dy = np.float32(np.stack([-ratio * sine, ratio * cosine], axis=1))
    body = (
        "Footprint p; p.centre = centre; p.dx = dx; p.dy = dy;"
        "NeumipView seen; neumip_view(fabric, p, view, seen); let f = neumip_value(fabric, seen, light);"
    )
    results = ";".join(("f.x; f.y; f.z; seen.hole", *(f"seen.latent[{k}]" for k in range(CHANNELS))))
    arguments = {"centre": centre, "light": light, "view": view, "dx": dx, "dy": dy}
    bsdf = model.at(vectors(view), Footprint(pairs(centre), pairs(dx), pairs(dy)))
    value = np.array(bsdf.value(vectors(light))).T
    assert value.max() > 0.2
    assert (value[light[:, 2] * view[:, 2] < 0] == 0).all() == (faces == 1)
    hole = np.array(bsdf.hole)[:, None]
    expected = np.concatenate([value, hole, np.array(bsdf._latent).T], axis=1)
    assert (np.ptp(expected, axis=0) > 0.2).sum() >= CHANNELS + 3
    found = mapped("neumip footprint", body, results, arguments, packed(model))
    assert share_beyond(found[:, :4], expected[:, :4]) == 0
    # Where interpolated channels cross 0, rounding of the position is more than a thousandth of them.
    assert share_beyond(found, expected) <= 1e-4
    halves = mapped("neumip footprint", body, results, arguments, packed(model, half=True))
    # Halves round each channel by up to 2⁻¹² of itself; such networks turn that into a few thousandths.
    np.testing.assert_allclose(halves, expected, atol=1e-2)
    assert np.sqrt(np.mean(np.square(halves - expected)[:, :3])) < 1e-3 * np.sqrt(np.mean(value**2))


@pytest.mark.slow
def test_frames_are_those_of_the_model() -> None:
    """A sheet from above: the middle pixel, in which light and view are those of the frame."""
    model = random_neumip()
    cloth = Cloth(rectangle(0.008, 0.004), model, (8.0, 4.0))
    renderer = Renderer([cloth], (9, 9))
    assert renderer.model == "neumip"
    towards = np.float32([0.3, 0.2, 0.9]) / np.linalg.norm([0.3, 0.2, 0.9])
    light = DirectionalLight(towards, (1.0, 1.0, 1.0))
    picture = renderer.render(Camera((0, 0, 0.02)), [light], passes=1, background=(0, 0, 0))
    pixel = 2e3 * 0.02 * np.tan(np.radians(13)) / 9
    edges = pairs(np.float32([[pixel, 0]])), pairs(np.float32([[0, pixel]]))
    at = model.at(vectors(np.float32([[0, 0, 1]])), Footprint(pairs(np.float32([[4, 2]])), *edges))
    expected = np.array(at.value(vectors(towards[None])))[:, 0]
    # Texels are halves here.
    np.testing.assert_allclose(picture.linear[4, 4, :3], expected, atol=3e-3)
    assert picture.linear[4, 4, 3] == pytest.approx(1 - float(np.array(at.hole)[0]), abs=3e-3)


def test_a_model_to_train_is_one_sentence() -> None:
    cloth = Cloth(rectangle(1, 1), fabric_from_text('weave = "plain"'))
    with pytest.raises(InputError, match=r"neumip is trained for .* which takes minutes: bake it"):
        Renderer([cloth], (4, 4), "neumip")
    alone = Cloth(rectangle(1, 1), random_neumip(faces=1, offset=False))
    with pytest.raises(InputError, match='"tile" is no fabric: lobes shows fabrics alone'):
        Renderer([alone], (4, 4), "lobes")
