"""The model latent in Slang against Dr.Jit: whole queries, albedos, densities and samples, and a frame.

The bar is that of `queries.py` for single precision.

Covers: models/texture/tables.py
"""

from __future__ import annotations

import numpy as np
import pytest
from drjit.llvm.ad import Float
from numpy.typing import NDArray

from loomlight.core.footprint import Footprint
from loomlight.realtime import Camera, Cloth, DirectionalLight, Renderer, rectangle
from loomlight.realtime.words import pack_fabrics
from tests.helpers.arrays import pairs, vectors
from tests.helpers.directions import clear_of_the_plane
from tests.helpers.parity import share_beyond
from tests.helpers.slang import mapped
from tests.helpers.untrained import PLAIN, random_latent

COUNT = 4096


def queries(count: int = COUNT) -> dict[str, NDArray[np.float32]]:
    """Footprints of 10 µm to 10 mm, elongated and turned, views and lights all over the sphere."""
    rng = np.random.default_rng(5)
    side = np.exp(rng.uniform(np.log(0.01), np.log(10), count))
    angle, ratio = rng.uniform(0, 2 * np.pi, count), rng.uniform(0.1, 1, count)
    cosine, sine = side * np.cos(angle), side * np.sin(angle)
    return {
        "centre": np.float32(rng.uniform(-2, 2, (count, 2))),
        "dx": np.float32(np.stack([cosine, sine], axis=1)),
        "dy": np.float32(np.stack([-ratio * sine, ratio * cosine], axis=1)),
        "light": clear_of_the_plane(rng, count),
        "view": clear_of_the_plane(rng, count),
        "choice": np.float32(rng.random(count)),
        "u": np.float32(rng.random((count, 2))),
    }


SEEN = (
    "Footprint p; p.centre = centre; p.dx = dx; p.dy = dy;"
    "let size = float2(fabric.latent.width, fabric.latent.height);"
    "LatentView seen; latent_view(fabric, p, view, uniform_of(hashed(p, view, size), 0), seen);"
)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("decoder", "mips", "frames", "features", "is_apart"),
    [
        ("2x16", "trilinear", True, True, False),
        ("2x32", "stochastic", True, True, False),
        ("3x64", "trilinear", True, True, False),
        ("2x32", "trilinear", False, True, True),
        ("2x32", "trilinear", True, False, False),
        ("2x32", "stochastic", False, False, True),
    ],
)
def test_queries_of_latent(decoder: str, mips: str, frames: bool, features: bool, is_apart: bool) -> None:
    model = random_latent(decoder, mips, frames, features, is_apart)
    packed = pack_fabrics([None], None, [model.shader_tables(half=False)])
    rows = queries()
    footprint = Footprint(*(pairs(rows[name]) for name in ("centre", "dx", "dy")))
    bsdf = model.at(vectors(rows["view"]), footprint)
    value = np.array(bsdf.value(vectors(rows["light"]))).T
    assert value.max() > 0.2
    expected = np.concatenate([value, np.array(bsdf.directional_albedo).T], axis=1)
    body = SEEN + "let f = latent_value(fabric, seen, light); let a = latent_albedo(fabric, seen);"
    arguments = {name: rows[name] for name in ("centre", "dx", "dy", "light", "view")}
    found = mapped("latent footprint random_numbers", body, "f.x; f.y; f.z; a.x; a.y; a.z", arguments, packed)
    # Rounding of a position may move it across one of 4096 steps of a hash, which chooses the level.
    assert share_beyond(found, expected) <= (1e-3 if mips == "stochastic" else 0)


@pytest.mark.slow
def test_densities_and_samples_of_latent() -> None:
    model = random_latent()
    packed = pack_fabrics([None], None, [model.shader_tables(half=False)])
    rows = queries()
    footprint = Footprint(*(pairs(rows[name]) for name in ("centre", "dx", "dy")))
    bsdf = model.at(vectors(rows["view"]), footprint)
    body = SEEN + (
        "let mixture = latent_mixture(fabric, seen);"
        "let drawn = latent_sample(mixture, seen.view, choice, u);"
        "let density = latent_pdf(mixture, to_face_frame(light, seen.back), seen.view);"
    )
    modules = "latent latent_sampling footprint point random_numbers"
    found = mapped(modules, body, "density; drawn.x; drawn.y; drawn.z", rows, packed)
    assert share_beyond(found[:, 0], np.array(bsdf.pdf(vectors(rows["light"])))) <= 1e-3
    drawn = np.array(bsdf.sample(Float(rows["choice"]), pairs(rows["u"])).light).T
    drawn[:, 2] *= np.sign(rows["view"][:, 2])
    # A choice next to the bound of both lobes may fall on the other side.
    assert share_beyond(found[:, 1:], drawn) <= 1e-3


@pytest.mark.slow
def test_passes_of_a_frame_tend_to_the_mixture_of_levels() -> None:
    model = random_latent(mips="stochastic")
    size_mm = PLAIN.repeat_mm
    cloth = Cloth(rectangle(2e-3 * size_mm[0], 2e-3 * size_mm[1]), model, (2 * size_mm[0], 2 * size_mm[1]))
    renderer = Renderer([cloth], (5, 5))
    towards = np.float32([0.3, 0.2, 0.9]) / np.linalg.norm([0.3, 0.2, 0.9])
    # A pixel is 1.4 texels wide.
    texel, distance = model.weights.shape.texel_mm, 0.02
    field = 2 * np.degrees(np.arctan(1.4 * texel * 5 / 2 / (1e3 * distance)))
    camera = Camera((0, 0, distance), field_of_view=float(field))
    light = DirectionalLight(towards, (1.0, 1.0, 1.0))
    picture = renderer.render(camera, [light], passes=256, background=(0, 0, 0))
    edges = pairs(np.float32([[1.4 * texel, 0]])), pairs(np.float32([[0, 1.4 * texel]]))
    at = model.at(vectors(np.float32([[0, 0, 1]])), Footprint(pairs(np.float32([size_mm])), *edges))
    values = []
    for level in (0, 1):
        at.__dict__["_latent"] = at._device.latent_of_level(Float(1), Float(1), level, 0 * at.view.x)
        at.__dict__.pop("_frames", None)
        values.append(np.array(at.value(vectors(towards[None])))[:, 0])
    share = np.log2(1.4)
    expected = (1 - share) * values[0] + share * values[1]
    assert np.abs(values[0] - values[1]).max() > 0.01
    # 256 choices of an even sequence: the share of each level is exact to a hundredth.
    np.testing.assert_allclose(
        picture.linear[2, 2, :3], expected, atol=0.02 * np.abs(values[1] - values[0]).max() + 1e-3
    )
