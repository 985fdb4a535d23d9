"""Samplers of models in Slang against Python's, on one set of random numbers; a chi-square of Slang alone.

A few choices in a thousand fall on the other side of a lobe's bound, which rounding decides.

Covers: realtime/words.py, scattering/point.py
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from drjit.llvm.ad import Float
from numpy.typing import NDArray

from loomlight.core.llvm import require_llvm
from loomlight.fabric import fabric_from_text, load_fabric
from loomlight.models.interface import Model
from loomlight.models.registry import REALTIME_MODELS, make_model
from tests.helpers.arrays import pairs, vectors
from tests.helpers.chi_square import cell_counts, cell_shares, p_value
from tests.helpers.parity import share_beyond
from tests.helpers.shader_cases import EXAMPLES, Rows, footprint_of, footprint_rows, model_of, packed
from tests.helpers.slang import mapped

require_llvm()
pytestmark = pytest.mark.usefixtures("graphics")

COUNT = 10_000
# Of draws in which rounding decides between two lobes, of which there are sixteen a footprint.
MAX_FLIPS = 2e-3
OPEN = 'weave = "plain"\n[warp]\ngap = 0.3\n[weft]\ngap = 0.2\n[sheen]\nstrength = 0.4\nroughness = 0.3\n'
FOOTPRINT = "Footprint p; p.centre = centre; p.dx = dx; p.dy = dy; let back = view.z < 0.0;"


@dataclass(frozen=True)
class Drawn:
    """What Python draws and answers.

    Attributes:
        light: directions [n, 3].
        pdf: of them [n].
        is_null: whether they pass straight on [n].
        density: of the light of each row [n].
        value: f·cos of the light that was drawn [n, 3], None where the shader does not say it.
    """

    light: NDArray[Any]
    pdf: NDArray[Any]
    is_null: NDArray[Any]
    density: NDArray[Any]
    value: NDArray[Any] | None = None


@dataclass(frozen=True)
class Sampler:
    """How a sampler is asked in Slang: `body` defines `s`, a sample, and `d`, the density of the row's light.

    Attributes:
        modules, body: of Slang.
        make: the model.
        python: of the model and the rows.
        sizes: of footprints, millimetres; None for those of `footprint_rows`.
        further: rows that the shader takes beside.
        value: expression of f·cos of the light that was drawn.
        passes: whether some light passes straight on.
        pdf: expression of the density of what was drawn.
        flips: share of draws that may be others, as rounding chooses another lobe.
    """

    modules: str
    body: str
    make: Callable[[], Model]
    python: Callable[[Any, Rows], Drawn]
    sizes: tuple[float, float] | None = None
    further: Callable[[Any, Rows], Rows] = lambda model, rows: {}
    value: str = "float3(0.0)"
    passes: bool = True
    pdf: str = "s.pdf"
    flips: float = MAX_FLIPS


def numbers_of(rows: Rows) -> tuple[Float, Any]:
    return Float(rows["choice"]), pairs(rows["u"])


def at_of(model: Any, rows: Rows) -> Any:
    """What Python answers of footprints on the draft, where these lines of Slang take them."""
    return model.at(vectors(rows["view"]), footprint_of(rows))


def of_footprints(model: Any, rows: Rows) -> Drawn:
    """What the model draws of footprints."""
    at = at_of(model, rows)
    sample = at.sample(*numbers_of(rows))
    null = np.broadcast_to(np.array(sample.is_null), COUNT)
    value = np.array(sample.weight * sample.pdf).T
    density = np.array(at.pdf(vectors(rows["light"])))
    return Drawn(np.array(sample.light).T, np.array(sample.pdf), null, density, value)


def of_points(model: Any, rows: Rows) -> Drawn:
    """What the point model draws without parallax: rays have tests of their own."""
    scattering, x, y = model.point_model, Float(rows["centre"][:, 0]), Float(rows["centre"][:, 1])
    view, light = vectors(rows["view"]), vectors(rows["light"])
    back = view.z < 0
    point = scattering.at(x, y, back, scattering.surface.surface(x, y, back).hole)
    sample = scattering.sample(point, view, *numbers_of(rows))
    density = np.array(scattering.pdf(point, light, view))
    value = np.array(scattering.evaluate(point, sample.light, view)).T
    return Drawn(np.array(sample.light).T, np.array(sample.pdf), np.array(sample.is_null), density, value)


def of_latents(model: Any, rows: Rows) -> Drawn:
    """What `latent` draws in the frame of the face that is seen; it says no density of what it draws."""
    at = at_of(model, rows)
    light = np.array(at.sample(*numbers_of(rows)).light).T
    light[:, 2] *= np.sign(rows["view"][:, 2])
    density = np.array(at.pdf(vectors(rows["light"])))
    return Drawn(light, np.zeros(COUNT), np.zeros(COUNT, bool), density)


def open_cloth(name: str, before: str = "", **options: Any) -> Callable[[], Model]:
    return lambda: make_model(name, fabric_from_text(before + OPEN), **options)


SAMPLERS: dict[str, Sampler] = {
    "point": Sampler(
        "point_sampling lobe_sampling point detail search geometry",
        "let q = default_quality(); let back = view.z < 0.0;"
        "let at = surface_at(fabric, centre.x, centre.y, back);"
        "let p = yarn_point_of(fabric, at, view, back, at.hole, NO_DETAIL);"
        "let s = sample_point(fabric, q, p, view, choice, u); let d = point_pdf(fabric, p, light, view);",
        # Light between yarns is drawn by a lobe of its own in Python alone; shaders add its value.
        open_cloth("point", "interreflection = false\n"),
        of_points,
        value="s.weight * s.pdf",
    ),
    # Footprints that groups alone answer.
    "lobes": Sampler(
        "lobes_sampling lobe_sampling prefiltered separable albedos point",
        FOOTPRINT + "let a = albedos_over(fabric, p, back);"
        "let g = seen_groups(fabric, p, to_face_frame(view, back), back);"
        "let hole = prefiltered_hole(fabric, g.taps, g.nodes, back);"
        "let s = sample_lobes(fabric, p, a, hole, view, choice, u);"
        "let d = lobes_pdf(fabric, p, a, hole, light, view);"
        "let l = to_face_frame(s.light, back);"
        "let c = prefiltered_components(fabric, p, l, to_face_frame(view, back), back);",
        open_cloth("lobes"),
        of_footprints,
        sizes=(7.0, 20.0),
        # Each of 24 groups rescales the number that chooses and takes some ten of its 24 bits: .009 differ.
        flips=0.02,
        value="composed(fabric, c, no_close_up(), a, float3(1.0), s.light, view)",
    ),
    # Hole and albedos are given: test_shaders.py asks of the network.
    "neural": Sampler(
        "neural_sampling lobe_sampling albedos",
        FOOTPRINT + "let a = albedos_over(fabric, p, back);"
        "let s = sample_neural(fabric, a, hole, view, choice, u);"
        "let d = neural_pdf(fabric, a, hole, light, view);",
        open_cloth("neural", refined=False, sampler="lobes"),
        of_footprints,
        sizes=(3.0, 3.0),
        further=lambda model, rows: {"hole": np.array(at_of(model, rows).hole)},
    ),
    "latent": Sampler(
        "latent latent_sampling point random_numbers",
        FOOTPRINT + "let size = float2(fabric.latent.width, fabric.latent.height);"
        "LatentView seen; latent_view(fabric, p, view, uniform_of(hashed(p, view, size), 0), seen);"
        "let mixture = latent_mixture(fabric, seen);"
        "let d = latent_pdf(mixture, to_face_frame(light, seen.back), seen.view);"
        "let drawn = latent_sample(mixture, seen.view, choice, u);",
        lambda: model_of("latent, no features"),
        of_latents,
        passes=False,
        pdf="0.0",
    ),
}
# What pages and engines draw of them with one light a pixel needs no sampler.
WITHOUT = {"clustered", "neumip"}


def test_every_shader_has_a_sampler_or_needs_none() -> None:
    assert {*SAMPLERS} | WITHOUT == {*REALTIME_MODELS}


def rows_of(sampler: Sampler, model: Any) -> Rows:
    rng = np.random.default_rng(4)
    rows = footprint_rows(COUNT, 5, seed=3)
    if sampler.sizes is not None:
        side = np.float32(rng.uniform(*sampler.sizes, COUNT))
        zero = np.zeros(COUNT, np.float32)
        rows |= {"dx": np.stack([side, zero], axis=1), "dy": np.stack([zero, side], axis=1)}
    most = np.nextafter(np.float32(1), np.float32(0))
    rows |= {
        "choice": np.minimum(np.float32(rng.random(COUNT)), most),
        "u": np.minimum(np.float32(rng.random((COUNT, 2))), most),
    }
    return rows | sampler.further(model, rows)


def asked(sampler: Sampler, model: Any, rows: Rows) -> NDArray[np.float32]:
    """Directions, their densities, whether they pass straight on, densities of lights, values [n, 9]."""
    light = "s.light" if sampler.passes else "drawn"
    null = "s.is_null" if sampler.passes else "false"
    results = f"{light}.x; {light}.y; {light}.z; {sampler.pdf}; {null}; d; f.x; f.y; f.z"
    body = f"{sampler.body} let f = {sampler.value};"
    return mapped(f"{sampler.modules} footprint", body, results, rows, packed(model))


@pytest.mark.slow
@pytest.mark.parametrize("name", SAMPLERS)
def test_draws_are_those_of_python(name: str) -> None:
    sampler = SAMPLERS[name]
    model = sampler.make()
    rows = rows_of(sampler, model)
    found, expected = asked(sampler, model, rows), sampler.python(model, rows)
    assert (0 < expected.is_null.mean() < 0.5) == sampler.passes
    assert np.mean((found[:, 4] > 0) != expected.is_null) <= MAX_FLIPS
    assert share_beyond(found[:, :3], expected.light) <= sampler.flips
    assert share_beyond(found[:, 3], expected.pdf) <= sampler.flips
    assert share_beyond(found[:, 5], expected.density) <= MAX_FLIPS
    if sampler.value != Sampler.value:
        # Where the direction is not null, weight times density is the value.
        assert expected.value is not None
        drawn = ~expected.is_null & (found[:, 4] == 0)
        assert expected.value[drawn].max() > 0.1
        assert share_beyond(found[drawn, 6:9], expected.value[drawn]) <= 2 * sampler.flips


@pytest.mark.slow
def test_lobes_are_drawn_with_their_density() -> None:
    """Chi-square of directions and density, both of Slang, for one footprint and a slanted view."""
    model = make_model("lobes", load_fabric(EXAMPLES / "silk-satin.toml"))
    view = np.float32([0.5, -0.3, np.sqrt(1 - 0.34)])
    one = {"centre": [1, 2], "dx": [8, 0], "dy": [0, 8], "view": view}
    rng, passing = np.random.default_rng(8), []

    def density(light: NDArray[np.float64]) -> NDArray[np.float64]:
        count = len(light)
        rows: Rows = {name: np.tile(np.float32(values), (count, 1)) for name, values in one.items()}
        rows |= {"choice": rng.random(count, np.float32), "u": rng.random((count, 2), np.float32)}
        passing.append(asked(SAMPLERS["lobes"], model, rows | {"light": np.float32(light)}))
        return passing[-1][:, 5].astype(np.float64)

    expected = cell_shares(density)
    (found,) = passing
    drawn = found[found[:, 4] == 0, :3].astype(np.float64)
    assert p_value(cell_counts(drawn), expected * len(found)) > 1e-3
