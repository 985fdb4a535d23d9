"""The model neural in Slang against Dr.Jit: components, holes and values of whole queries, and a frame.

The bar is that of `queries.py`. No query searches along rays, so none may miss it.

"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from drjit.llvm.ad import Array2f

from loomlight.core.errors import InputError
from loomlight.core.footprint import Footprint
from loomlight.fabric import fabric_from_text, load_fabric
from loomlight.models.neural.model import NeuralModel, NeuralOptions
from loomlight.models.neural.weights import shipped_weights
from loomlight.realtime import Camera, Cloth, DirectionalLight, Renderer, rectangle
from loomlight.realtime.words import pack_fabrics
from tests.helpers.arrays import pairs, vectors
from tests.helpers.directions import clear_of_the_plane
from tests.helpers.parity import places, share_beyond
from tests.helpers.slang import mapped

EXAMPLES = Path(__file__).parents[2] / "examples"
COUNT = 10_000
# Holes, sheen, coloured threads, twist, and a repeat that is no power of two.
OPEN = (
    'weave = "twill 2/1"\nends_per_cm = 30\npicks_per_cm = 20\n[warp]\ngap = 0.3\ntwist_deg = 20\n'
    "[weft]\ngap = 0.2\n[sheen]\nstrength = 0.4\nroughness = 0.3\n"
)


def neural_of(name: str) -> NeuralModel:
    """Denim, whose yarns vary, with its fitted last layer; open cloth of even yarns without."""
    if name == "open":
        return NeuralModel.for_source(fabric_from_text(OPEN), NeuralOptions(refined=False))
    return NeuralModel.for_source(load_fabric(EXAMPLES / f"{name}.toml"))


@pytest.mark.slow
@pytest.mark.parametrize("name", ["denim", "open"])
def test_queries_of_neural(name: str) -> None:
    """Footprints of 10 µm to 10 mm, elongated and turned, views and lights all over the sphere."""
    model = neural_of(name)
    rng = np.random.default_rng(23)
    at = places(rng, model.fabric.layout(), COUNT)
    light, view = clear_of_the_plane(rng, COUNT), clear_of_the_plane(rng, COUNT)
    side = np.exp(rng.uniform(np.log(0.01), np.log(10), COUNT))
    angle, ratio = rng.uniform(0, 2 * np.pi, COUNT), rng.uniform(0.1, 1, COUNT)
    cosine, sine = side * np.cos(angle), side * np.sin(angle)
    dx = np.float32(np.stack([cosine, sine], axis=1))
    dy = np.float32(np.stack([-ratio * sine, ratio * cosine], axis=1))
    body = (
        "Footprint p; p.centre = float2(x, y); p.dx = dx; p.dy = dy;"
        "NeuralView w; neural_view(fabric, p, view, w); let c = neural_components(fabric, w, light);"
        "let a = with_tones(fabric, albedos_over(fabric, p, view.z < 0.0), w.yarns);"
        "let f = composed(fabric, c, no_close_up(), a, float3(1.0), light, view);"
    )
    found = mapped(
        "neural footprint separable albedos",
        body,
        "c.diffuse_warp; c.diffuse_weft; c.specular_warp; c.specular_weft; c.light_visibility; c.hole;"
        "f.x; f.y; f.z",
        {"x": at.x, "y": at.y, "light": light, "view": view, "dx": dx, "dy": dy},
        (model.fabric.layout(), model.fabric.appearance()),
        model,
    )
    bsdf = model.at(vectors(view), Footprint(Array2f(at.x, at.y), pairs(dx), pairs(dy)))
    parts = bsdf.components(vectors(light))
    value = bsdf.value(vectors(light))
    expected = [parts.diffuse_warp, parts.diffuse_weft, parts.specular_warp, parts.specular_weft]
    expected += [parts.light_visibility, bsdf.hole, *value]
    assert np.max(found[:, 5]) > 0.05
    for column, values in enumerate(expected):
        assert np.ptp(found[:, column]) > 0.05, column
        assert share_beyond(found[:, column], np.array(values)) == 0, column


@pytest.mark.slow
def test_a_frame_shades_the_footprints_of_its_pixels() -> None:
    """Straight from above, footprints are squares of the pixels' size."""
    size, side, distance = 16, 0.1, 0.05
    model = neural_of("denim")
    camera = Camera((0, 0, distance), up=(0, 1, 0))
    towards = np.float32([0.5, 0.3, 0.8] / np.linalg.norm([0.5, 0.3, 0.8]))
    renderer = Renderer([Cloth(rectangle(side, side), model.fabric)], (size, size), "neural")
    frame = renderer.render(camera, [DirectionalLight(towards, (1, 1, 1))], passes=1).linear

    axes = camera.axes(size, size)
    row, column = (part.ravel() + 0.5 for part in np.mgrid[:size, :size].astype(float))
    reach = distance * np.array([axes["right"][0], axes["up"][1]])
    centre = np.stack([2 * column / size - 1, 1 - 2 * row / size], axis=1) * reach
    view = axes["origin"] - np.pad(centre, ((0, 0), (0, 1)))
    view /= np.linalg.norm(view, axis=1, keepdims=True)
    # uv is 100 mm a unit and spans the cloth.
    scale = 100 / side
    zero = np.zeros(len(row))
    dx = np.stack([zero + 2 * reach[0] / size, zero], axis=1) * scale
    dy = np.stack([zero, zero - 2 * reach[1] / size], axis=1) * scale
    footprint = Footprint(
        pairs(np.float32((centre + side / 2) * scale)), pairs(np.float32(dx)), pairs(np.float32(dy))
    )
    bsdf = model.at(vectors(np.float32(view)), model.on_cloth(footprint))
    expected = np.array(bsdf.value(vectors(np.broadcast_to(towards, view.shape)))).T
    # Positions agree to 1e-5 of the picture.
    np.testing.assert_allclose(frame[..., :3].reshape(-1, 3), expected, rtol=1e-2, atol=1e-4)
    np.testing.assert_allclose(1 - frame[..., 3].ravel(), np.array(bsdf.null_transmission), atol=1e-3)


def test_fabrics_share_a_network() -> None:
    model = neural_of("open")
    looks = (model.fabric.layout(), model.fabric.appearance())
    alone = pack_fabrics([looks], None, [model.shader_tables()])
    both = pack_fabrics([looks, looks], None, [model.shader_tables(), model.shader_tables()])
    first, second = both.fabrics["neural"]
    assert first["network"] == second["network"] == 0
    assert second["latents"] > first["latents"]
    latents = 2 * len(model.encoded.faces[0]) * model.weights.table.latent_size // 8
    assert len(both.packed_numbers) == len(alone.packed_numbers) + latents
    assert alone.fabrics["neural"]["is_corrected"] == 0


def test_a_network_of_another_shape_is_one_sentence() -> None:
    model = neural_of("open")
    table = shipped_weights().table.model_copy(update={"hidden": 32})
    model.weights = replace(model.weights, table=table, source="mine.safetensors")
    with pytest.raises(InputError, match=r"^mine.safetensors: real-time shaders are compiled for networks"):
        model.shader_tables()
