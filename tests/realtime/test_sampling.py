"""Sampling and densities in Slang against Dr.Jit, on one set of random numbers, and one chi-square test.

A few choices in ten thousand fall on the other side of a lobe's bound, which rounding decides.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Float
from numpy.typing import NDArray

from loomlight.core.footprint import Footprint
from loomlight.fabric import fabric_from_text, load_fabric
from loomlight.models.lobes.model import LobesModel
from loomlight.models.neural.model import NeuralModel, NeuralOptions
from loomlight.models.registry import make_model
from loomlight.scattering.point import DirectionSample, YarnScattering
from loomlight.yarn.geometry import YarnGeometry
from tests.helpers.arrays import pairs, vectors
from tests.helpers.chi_square import COLUMNS, ROWS, cell_counts, cell_shares, p_value
from tests.helpers.directions import clear_of_the_plane
from tests.helpers.layouts import TWILL, even_layout
from tests.helpers.parity import appearance, places, share_beyond
from tests.helpers.slang import mapped

EXAMPLES = Path(__file__).parents[2] / "examples"
COUNT = 10_000
# Share of draws in which rounding decides between two lobes, of which there are sixteen a footprint.
MAX_FLIPS = 2e-3
RESULTS = (
    "s.light.x; s.light.y; s.light.z; s.pdf; s.is_null; s.weight.x; s.weight.y; s.weight.z; d; f.x; f.y; f.z"
)
FOOTPRINT = "Footprint p; p.centre = float2(x, y); p.dx = float2(side, 0); p.dy = float2(0, side);"
OPEN = 'weave = "plain"\n[warp]\ngap = 0.3\n[weft]\ngap = 0.2\n[sheen]\nstrength = 0.4\nroughness = 0.3\n'


def random_numbers(rng: np.random.Generator, count: int) -> dict[str, NDArray[np.float32]]:
    most = np.nextafter(np.float32(1), np.float32(0))
    return {
        "choice": np.minimum(np.float32(rng.random(count)), most),
        "u": np.minimum(np.float32(rng.random((count, 2))), most),
    }


def require_same(found: NDArray[np.float32], sample: DirectionSample) -> None:
    """Directions, densities and null transmission of `RESULTS` are those of a sample."""
    null = np.array(sample.is_null)
    assert 0 < null.mean() < 0.5
    assert np.mean((found[:, 4] > 0) != null) <= MAX_FLIPS
    assert share_beyond(found[:, :3].T, np.array(sample.light)) <= MAX_FLIPS
    assert share_beyond(found[:, 3], np.array(sample.pdf)) <= MAX_FLIPS


@pytest.mark.slow
def test_sampling_of_the_point_model() -> None:
    rng = np.random.default_rng(4)
    layout = even_layout(TWILL, gap=0.3)
    looks = appearance(rng, layout, sheen=True, varies=False)
    at, light, view = (
        places(rng, layout, COUNT),
        clear_of_the_plane(rng, COUNT),
        clear_of_the_plane(rng, COUNT),
    )
    numbers = random_numbers(rng, COUNT)
    body = (
        "let q = default_quality(); let back = view.z < 0.0; let at = surface_at(fabric, x, y, back);"
        "let p = yarn_point_of(fabric, at, view, back, at.hole, NO_DETAIL);"
        "let s = sample_point(fabric, q, p, view, choice, u); let d = point_pdf(fabric, p, light, view);"
        "let f = s.weight * s.pdf;"
    )
    arguments = {"x": at.x, "y": at.y, "light": light, "view": view} | numbers
    found = mapped(
        "point_sampling lobe_sampling point detail search geometry", body, RESULTS, arguments, (layout, looks)
    )
    model = YarnScattering(YarnGeometry(layout), looks)
    # Without parallax: rays have tests of their own.
    back = vectors(view).z < 0
    hole = model.surface.surface(Float(at.x), Float(at.y), back).hole
    point = model.at(Float(at.x), Float(at.y), back, hole)
    sample = model.sample(point, vectors(view), Float(numbers["choice"]), pairs(numbers["u"]))
    require_same(found, sample)
    assert share_beyond(found[:, 5:8].T, np.array(sample.weight)) <= MAX_FLIPS
    assert share_beyond(found[:, 8], np.array(model.pdf(point, vectors(light), vectors(view)))) <= MAX_FLIPS
    # Where the direction is not null, weight times density is the value.
    value = np.array(model.evaluate(point, vectors(np.ascontiguousarray(found[:, :3])), vectors(view)))
    drawn = found[:, 4] == 0
    assert share_beyond(found[drawn, 9:12].T, value[:, drawn]) <= MAX_FLIPS


LOBES_BODY = (
    "let back = view.z < 0.0; let a = albedos_over(fabric, p, back);"
    "let g = seen_groups(fabric, p, to_face_frame(view, back), back);"
    "let hole = prefiltered_hole(fabric, g.taps, g.nodes, back);"
    "let s = sample_lobes(fabric, p, a, hole, view, choice, u);"
    "let d = lobes_pdf(fabric, p, a, hole, light, view);"
    "let l = to_face_frame(s.light, back);"
    "let c = prefiltered_components(fabric, p, l, to_face_frame(view, back), back);"
    "let f = composed(fabric, c, no_close_up(), a, float3(1.0), s.light, view);"
)
LOBES_MODULES = "lobes_sampling lobe_sampling prefiltered separable albedos point footprint"


def lobes_rows(model: LobesModel, arguments: dict[str, NDArray[np.float32]]) -> NDArray[np.float32]:
    looks = (model.fabric.layout(), model.fabric.appearance(), model.tables)
    return mapped(LOBES_MODULES, FOOTPRINT + LOBES_BODY, RESULTS, arguments, looks)


@pytest.mark.slow
def test_sampling_of_lobes() -> None:
    """Footprints that groups alone answer."""
    model = make_model("lobes", fabric_from_text(OPEN))
    assert isinstance(model, LobesModel)
    rng = np.random.default_rng(4)
    at = places(rng, model.fabric.layout(), COUNT)
    light, view = clear_of_the_plane(rng, COUNT), clear_of_the_plane(rng, COUNT)
    side = np.float32(rng.uniform(5, 20, COUNT))
    numbers = random_numbers(rng, COUNT)
    found = lobes_rows(model, {"x": at.x, "y": at.y, "side": side, "light": light, "view": view} | numbers)
    zero = np.zeros(COUNT, np.float32)
    footprint = Footprint(Array2f(at.x, at.y), Array2f(side, zero), Array2f(zero, side))
    bsdf = model.at(vectors(view), footprint)
    sample = bsdf.sample(Float(numbers["choice"]), pairs(numbers["u"]))
    require_same(found, sample)
    assert share_beyond(found[:, 8], np.array(bsdf.pdf(vectors(light)))) <= MAX_FLIPS
    # The weight is the value over the density.
    weight, drawn = np.array(sample.weight), found[:, 4] == 0
    assert share_beyond((found[:, 9:12] / found[:, 3:4])[drawn].T, weight[:, drawn]) <= MAX_FLIPS


@pytest.mark.slow
def test_lobes_are_drawn_with_their_density() -> None:
    """Chi-square of directions and density, both of Slang, for one footprint and a slanted view."""
    model = make_model("lobes", load_fabric(EXAMPLES / "silk-satin.toml"))
    assert isinstance(model, LobesModel)
    view = np.float32([0.5, -0.3, np.sqrt(1 - 0.34)])
    rng = np.random.default_rng(8)
    passing = []

    def rows(light: NDArray[np.float64]) -> NDArray[np.float32]:
        count = len(light)
        constant = {
            name: np.full(count, value, np.float32) for name, value in (("x", 1), ("y", 2), ("side", 8))
        }
        arguments = constant | {"light": np.float32(light), "view": np.tile(view, (count, 1))}
        found = lobes_rows(model, arguments | random_numbers(rng, count))
        passing.append(found)
        return found

    expected = cell_shares(lambda light: rows(light)[:, 8].astype(np.float64))
    (found,) = passing
    drawn = found[found[:, 4] == 0, :3].astype(np.float64)
    assert expected.size == ROWS * COLUMNS
    assert p_value(cell_counts(drawn), expected * len(found)) > 1e-3


@pytest.mark.slow
def test_sampling_of_neural() -> None:
    """Hole and albedos are given: parity of the network has tests of its own."""
    model = NeuralModel.for_source(fabric_from_text(OPEN), NeuralOptions(refined=False, sampler="lobes"))
    rng = np.random.default_rng(4)
    at = places(rng, model.fabric.layout(), COUNT)
    light, view = clear_of_the_plane(rng, COUNT), clear_of_the_plane(rng, COUNT)
    side = np.full(COUNT, 3, np.float32)
    numbers = random_numbers(rng, COUNT)
    zero = np.zeros(COUNT, np.float32)
    footprint = Footprint(Array2f(at.x, at.y), Array2f(side, zero), Array2f(zero, side))
    bsdf = model.at(vectors(view), footprint)
    sample = bsdf.sample(Float(numbers["choice"]), pairs(numbers["u"]))
    hole = np.array(bsdf.hole)
    body = FOOTPRINT + (
        "let a = albedos_over(fabric, p, view.z < 0.0);"
        "let s = sample_neural(fabric, a, hole, view, choice, u);"
        "let d = neural_pdf(fabric, a, hole, light, view); let f = float3(0.0);"
    )
    arguments = {"x": at.x, "y": at.y, "side": side, "light": light, "view": view, "hole": hole} | numbers
    looks = (model.fabric.layout(), model.fabric.appearance())
    found = mapped("neural_sampling lobe_sampling albedos footprint", body, RESULTS, arguments, looks, model)
    require_same(found, sample)
    assert share_beyond(found[:, 8], np.array(bsdf.pdf(vectors(light)))) <= MAX_FLIPS
