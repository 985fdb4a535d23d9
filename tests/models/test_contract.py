"""The contract of `loomlight.models.interface`: every registered model passes, or does not ship.

Every model in the registry is tested here without further code. Its claims (`filters`, `conserves_energy`)
are tested where it makes them, everything else for all models.

Covers: models/interface.py, models/separable.py
"""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from functools import cache
from pathlib import Path
from typing import Any, get_type_hints

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Array3f, Float
from numpy.typing import NDArray

from loomlight.aggregate.slices import FabricSlices
from loomlight.core.llvm import require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.fabric.read import edited_fabric
from loomlight.models.interface import Model
from loomlight.models.registry import make_model, model_class, model_from_loom, model_names
from loomlight.models.separable import Components, FamilyAlbedos, SeparableBsdf
from loomlight.scattering.point import Albedos, DirectionSample, YarnScattering
from loomlight.scattering.sheen import sheen
from loomlight.sources.loom_file import write_loom
from loomlight.yarn.geometry import YarnGeometry
from studies.instruments.reference import reference
from tests.helpers.arrays import numbers, vectors
from tests.helpers.chi_square import cell_counts, cell_shares, p_value
from tests.helpers.directions import directions
from tests.helpers.fabrics import TEXTS, WHITE, fabric
from tests.helpers.queries import Queries, queries
from tests.marks import slow_among

require_llvm()

# The bound on the overall error of the network that ships; what 32 samples stay below.
MAX_ERROR = 0.2

# Of models that estimate a surface of their own: on that of `clustered` no yarn hides another, or a hole,
# from oblique views, and each footprint has one offset of parallax (zhu2024 5.2).
OWN_SURFACE = 2

# Options of the cheapest bake: the contract holds for any.
CHEAPEST = {"clustered": {"clusters": 4, "texels": 32}}

every_model = pytest.mark.parametrize("name", model_names())


def is_separable(name: str) -> bool:
    """Whether a model keeps components and albedos apart; others give colours alone."""
    return issubclass(get_type_hints(model_class(name).at)["return"], SeparableBsdf)


separable_models = pytest.mark.parametrize("name", [*filter(is_separable, model_names())])
# Of cloths that no other test bakes for.
SLOW_MODELS = ("clustered", "neumip", "latent")
every_model_once = pytest.mark.parametrize("name", slow_among(model_names(), SLOW_MODELS))
separable_models_once = pytest.mark.parametrize(
    "name", slow_among(filter(is_separable, model_names()), SLOW_MODELS)
)
# Plain cloth has holes and lets light through its yarns.
FABRICS = slow_among(TEXTS, set(TEXTS) - {"plain"})
every_fabric = pytest.mark.parametrize("cloth", FABRICS)
# Irregular yarns are alike in no two repeats.
EVEN = [name for name in TEXTS if not fabric(name).appearance().is_irregular]


@cache
def built(name: str, cloth: str, between_yarns: bool = True) -> Model:
    chosen = fabric_from_text(WHITE) if cloth == "white" else fabric(cloth)
    if not between_yarns:
        chosen = edited_fabric(chosen, {"interreflection": False})
    return make_model(name, chosen, **CHEAPEST.get(name, {}))


@dataclass
class Answers:
    """All outputs of a model for queries, computed at once: one kernel serves most of these tests."""

    components: Components | None
    hole: Any
    albedos: FamilyAlbedos | None
    value: Any
    pdf: Any
    through: Any

    @property
    def parts(self) -> dict[str, NDArray[np.float32]]:
        """Components, where there are any, and the hole by name."""
        parts = {}
        if self.components is not None:
            parts = {part.name: getattr(self.components, part.name).numpy() for part in fields(Components)}
        return parts | {"hole": self.hole.numpy()}


def answers(model: Model, queried: Queries, light: Any = None) -> Answers:
    """The outputs of `model` for the queries, or for another light."""
    light = queried.light if light is None else light
    at = model.at(queried.view, queried.footprint)
    separable = isinstance(at, SeparableBsdf)
    assert separable == is_separable(model.name)
    components, albedos = (at.components(light), at.albedos) if separable else (None, None)
    value, pdf = at.value_and_pdf(light)
    actual = Answers(components, at.hole, albedos, value, pdf, at.null_transmission)
    dr.eval(actual)
    return actual


def drawn(model: Model, queried: Queries, seed: int) -> DirectionSample:
    at = model.at(queried.view, queried.footprint)
    actual = at.sample(*numbers(np.random.default_rng(seed), len(queried)))
    dr.eval(actual)
    return actual


def close(
    actual: NDArray[np.float32], wanted: NDArray[np.float32], rtol: float = 2e-3, lanes: int | None = None
) -> None:
    """Two kernels round differently, and in a shadow's edge or a yarn's that decides: 1 lane in 200 may.

    Args:
        lanes: how many these were chosen from.
    """
    near = np.isclose(actual, wanted, rtol=rtol, atol=1e-5)
    alike = near if near.ndim == 1 else near.all(axis=0)
    apart = actual[..., ~alike][..., :3], wanted[..., ~alike][..., :3]
    assert (~alike).sum() < 0.005 * (lanes or alike.size), (alike.mean(), *apart)


@every_model
def test_a_model_says_what_it_is(name: str) -> None:
    kind = model_class(name)
    assert issubclass(kind, Model)
    assert kind.name == name
    assert isinstance(kind.filters, bool)
    assert isinstance(kind.conserves_energy, bool)
    assert built(name, "plain").source.name == "plain"


@every_fabric
@every_model
def test_answers_are_of_the_right_kind_and_range(name: str, cloth: str) -> None:
    queried = queries(fabric(cloth), 800, seed=1)
    actual = answers(built(name, cloth), queried)
    # Unbiased estimates have noise of either sign.
    estimates = model_class(name).estimates
    for part, values in actual.parts.items():
        assert values.shape == (len(queried),), part
        assert np.isfinite(values).all(), part
        assert (values >= 0).all() or estimates, part
    assert (actual.parts["hole"] <= 1).all()
    families = () if actual.albedos is None else (actual.albedos.warp, actual.albedos.weft)
    for albedos in families:
        for part in fields(Albedos):
            values = np.array(getattr(albedos, part.name))
            assert values.shape[0] == 3
            # Interpolation and rounding, no more.
            assert (values >= -1e-4).all(), part.name
            assert (values <= 1 + 1e-4).all(), part.name
    assert type(actual.value) is Array3f
    assert type(actual.pdf) is Float
    for result in (actual.value, actual.pdf, actual.through):
        assert not dr.grad_enabled(result)
        assert np.isfinite(result.numpy()).all()
    assert (actual.value.numpy() >= 0).all() or estimates
    assert (actual.pdf.numpy() >= 0).all()
    assert (actual.through.numpy() >= 0).all()
    assert (actual.through.numpy() <= actual.parts["hole"]).all()


@pytest.mark.quick("neural", "point")
@separable_models_once
def test_value_is_made_of_components_and_albedos(name: str) -> None:
    """Chen2024 eq. 8, written out again, for a fabric without sheen whose yarns do not light each other."""
    queried = queries(fabric("translucent satin"), 1000, seed=2)
    model = built(name, "translucent satin", between_yarns=False)
    actual = answers(model, queried)
    far = queried.lights[:, 2] * queried.views[:, 2] < 0
    expected = np.zeros((3, len(queried)))
    for term in ("diffuse", "specular"):
        for family in ("warp", "weft"):
            albedos = getattr(actual.albedos, family)
            near, beyond = (
                np.broadcast_to(np.array(getattr(albedos, f"{term}_{side}")), (3, len(queried)))
                for side in ("reflect", "transmit")
            )
            expected += np.where(far, beyond, near) * actual.parts[f"{term}_{family}"]
    assert 0.3 < far.mean() < 0.7
    value = model.at(queried.view, queried.footprint).value(queried.light)
    close(value.numpy(), expected)
    close(actual.value.numpy(), expected)


@pytest.mark.quick("neural", "point")
@every_model_once
def test_opaque_yarns_send_nothing_to_the_far_side(name: str) -> None:
    opaque = fabric_from_text('weave = "plain"\n[warp]\ntranslucency = 0.0\n[weft]\ntranslucency = 0.0')
    model = make_model(name, opaque, **CHEAPEST.get(name, {}))
    queried = queries(opaque, 1000, seed=3)
    value = answers(model, queried).value.numpy().max(axis=0)
    far = queried.lights[:, 2] * queried.views[:, 2] < 0
    assert (value[far] == 0).all()
    # Of the near side only what lies in shadow or in holes is black.
    assert (value[~far] > 0).mean() > 0.5


@pytest.mark.parametrize("cloth", slow_among(EVEN, set(EVEN) - {"plain"}))
@every_model
def test_the_cloth_repeats(name: str, cloth: str) -> None:
    model, queried = built(name, cloth), queries(fabric(cloth), 800, seed=4)
    width, height = fabric(cloth).repeat_mm
    here, there = (answers(model, part) for part in (queried, queried.moved((width, -2 * height))))
    # Each of the points that `samples` takes of a footprint may lie at an edge.
    lanes = 4 * 800 if name == "samples" else None
    for part, values in here.parts.items():
        # Float32 positions 3 repeats away differ by 1e-6 mm, which highlights magnify.
        close(there.parts[part], values, 1e-2, lanes)
    close(there.value.numpy(), here.value.numpy(), 1e-2, lanes)
    close(there.pdf.numpy(), here.pdf.numpy(), 1e-2, lanes)


@pytest.mark.quick("latent", "neumip", "neural", "point")
@every_model
def test_a_lane_does_not_know_its_neighbours(name: str) -> None:
    model, queried = built(name, "plain"), queries(fabric("plain"), 64, seed=5)
    together = answers(model, queried)
    for lane in (0, 17, 63):
        alone = answers(model, queried[lane : lane + 1])
        for part, values in alone.parts.items():
            assert values.shape == (1,)
            np.testing.assert_allclose(
                values[0], together.parts[part][lane], rtol=1e-4, atol=1e-6, err_msg=part
            )
        for what in ("value", "pdf"):
            actual, wanted = (getattr(one, what).numpy() for one in (alone, together))
            np.testing.assert_allclose(actual[..., 0], wanted[..., lane], rtol=1e-4, atol=1e-6)


@every_fabric
@separable_models
def test_both_faces_and_both_sides_are_the_cloths(name: str, cloth: str) -> None:
    """Averaged over positions, components and holes are those of the whole repeat, front and back."""
    model = built(name, cloth)
    point_model = YarnScattering(YarnGeometry(model.source.layout()), model.source.appearance())
    signs = [(1, 1), (1, -1), (-1, -1), (-1, 1)]
    lights = np.array([[0.4 * s, 0.3, 0.86 * s] for s, _ in signs])
    views = np.array([[-0.3, 0.5, 0.81 * s] for _, s in signs])
    lights, views = (v / np.linalg.norm(v, axis=1, keepdims=True) for v in (lights, views))
    extent = np.asarray(model.source.repeat_mm)
    size = 2.5 * extent
    slices = FabricSlices(point_model, Float, with_light_visibility=True)

    count = 1000
    rng = np.random.default_rng(6)
    centres = rng.random((count, 2)) * extent
    edges = np.tile(np.diag(size), (count, 1, 1))
    errors, truths, holes = [], [], []
    for light, view in zip(lights, views, strict=True):
        queried = Queries(np.tile(light, (count, 1)), np.tile(view, (count, 1)), centres, edges)
        actual = np.stack(list(answers(model, queried).parts.values()), axis=1)
        exact = slices.slice(light, view)
        truth = in_the_order_of_parts(exact.box_means(np.zeros((1, 2)), extent[None])[0])
        noise = 5 * actual.std(axis=0) / math.sqrt(count)
        error = np.maximum(np.abs(actual.mean(axis=0) - truth) - noise, 0)
        # The bound is on means over many directions; one pair alone may err twice as much.
        assert error[:4].sum() < 2 * MAX_ERROR * truth[:4].sum(), (actual.mean(0), truth)
        errors.append(error[:4])
        truths.append(truth[:4])
        holes.append(error[5])
        if light[2] * view[2] > 0:
            # Elsewhere there is no sheen, which alone needs it.
            assert error[4] < (OWN_SURFACE if model.estimates else 1) * MAX_ERROR * truth[4]
        if model.filters and not model.estimates:
            # Each large footprint by itself, against its own box. (One estimate alone is noise; its mean is
            # above, and studies/accuracy/unbiased.py tests single footprints.)
            boxes = exact.box_means(centres[:200], np.tile(size, (200, 1)))[:, :4]
            assert np.abs(actual[:200, :4] - boxes).sum() < 2 * MAX_ERROR * boxes.sum()
    assert np.sum(errors) < MAX_ERROR * np.sum(truths), (errors, truths)
    # Of all rays. The network that ships misses a third of the holes of plain cloth with gaps of 0.3.
    assert np.mean(holes) < (OWN_SURFACE if model.estimates else 1) * 0.04


def in_the_order_of_parts(means: NDArray[np.float64]) -> NDArray[np.float64]:
    """Channels of slices as `Answers.parts` has them: the hole last."""
    return np.concatenate([means[:4], means[5:], means[4:5]])


@pytest.mark.quick("neural", "point")
@separable_models_once
def test_sheen_is_scaled_by_what_light_reaches_and_by_holes(name: str) -> None:
    """A sheen over black cloth: f·cos is the lobe times (light visibility + hole)."""
    black = 'weave = "twill 2/2"\ngap = 0.3\n[warp]\ncolor = "#000000"\nspecular = 0\n'
    black += '[weft]\ncolor = "#000000"\nspecular = 0\n[sheen]\nstrength = 0.7\n'
    cloth = fabric_from_text(black)
    queried = queries(cloth, 1500, seed=21)
    actual = answers(make_model(name, cloth, **CHEAPEST.get(name, {})), queried)
    front = [np.c_[v[:, :2], v[:, 2] * np.sign(queried.views[:, 2])] for v in (queried.lights, queried.views)]
    lobe = sheen(*(vectors(v) for v in front), 0.7, cloth.appearance().sheen.roughness).numpy()
    scale = actual.parts["light_visibility"] + actual.parts["hole"]
    assert (scale < 1 + 1e-4).all() or model_class(name).estimates
    close(actual.value.numpy()[0], lobe * scale)
    # The means of both, on the side of the view: within a tenth of rays over the same footprints.
    near = queried.lights[:, 2] * queried.views[:, 2] > 0
    exact = reference(
        YarnScattering(YarnGeometry(cloth.layout()), cloth.appearance()),
        queried.footprint,
        queried.lights,
        queried.views,
        64,
        seed=1,
    )
    true_scale = exact.light_visibility + exact.hole
    bound = 0.1 * (OWN_SURFACE if model_class(name).estimates else 1)
    assert abs((lobe * (scale - true_scale))[near].sum()) < bound * (lobe * true_scale)[near].sum()


@pytest.mark.quick("latent-plain", "neumip-plain", "neural-plain", "point-plain", "lobes-plain")
@every_fabric
@every_model
def test_weight_is_value_over_density(name: str, cloth: str) -> None:
    model, queried = built(name, cloth), queries(fabric(cloth), 1500, seed=7)
    actual = drawn(model, queried, seed=8)
    passes, pdf, weight = actual.is_null.numpy(), actual.pdf.numpy(), actual.weight.numpy()
    np.testing.assert_allclose(np.linalg.norm(actual.light.numpy(), axis=0), 1, atol=1e-4)
    assert np.isfinite(weight).all()
    assert (weight >= 0).all() or model_class(name).estimates
    again = answers(model, queried, actual.light)
    density, value, through = (part.numpy() for part in (again.pdf, again.value, again.through))
    smooth = ~passes & (density > 0)
    assert smooth.mean() > 0.5
    close(pdf[smooth], density[smooth])
    close(weight[:, smooth], value[:, smooth] / density[smooth])
    # Straight on means straight on, and the weight is the light that passes over the chance to be drawn.
    np.testing.assert_allclose(actual.light.numpy()[:, passes], -queried.view.numpy()[:, passes], atol=1e-5)
    # Rays are chosen that one of both kernels lets through.
    close(weight[0, passes] * pdf[passes], through[passes], lanes=len(queried))


def spread_over(model: Model, view: NDArray[np.float64], size: float, count: int) -> Queries:
    """One footprint, looked at `count` times from one direction."""
    extent = np.asarray(model.source.repeat_mm)
    edges = size * np.array([[1.0, 0.2], [-0.1, 0.8]]) * extent.min()
    one = Queries(np.array([[0.0, 0.0, 1.0]]), view[None], 0.37 * extent[None], edges[None])
    return one[np.zeros(count, int)]


@pytest.mark.quick(
    "latent-plain-25.0-0.3", "neumip-plain-25.0-0.3", "neural-plain-25.0-0.3", "point-plain-25.0-0.3"
)
@pytest.mark.parametrize(("degrees", "size"), [(25.0, 0.3), (70.0, 1.5), (140.0, 0.8)])
@every_fabric
@every_model
def test_directions_are_distributed_by_their_density(
    name: str, cloth: str, degrees: float, size: float
) -> None:
    model, count = built(name, cloth), 20_000
    angle = math.radians(degrees)
    view = np.array([0.6 * math.sin(angle), 0.8 * math.sin(angle), math.cos(angle)])

    def density(lights: NDArray[np.float64]) -> NDArray[np.float64]:
        queried = spread_over(model, view, size, len(lights))
        return model.at(queried.view, queried.footprint).pdf(vectors(lights)).numpy().astype(np.float64)

    shares = cell_shares(density)
    actual = drawn(model, spread_over(model, view, size, count), seed=9)
    passes, chance = actual.is_null.numpy(), actual.pdf.numpy()
    through = float(chance[passes].mean()) if passes.any() else 0.0
    if abs(shares.sum() + through - 1) > 3e-3:
        # A narrow lobe needs a finer rule.
        shares = cell_shares(density, points=24)
    # The rule's error at the edge of a lobe is a few thousandths of a cell.
    assert abs(shares.sum() + through - 1) < 5e-3
    np.testing.assert_allclose(chance[passes], through, rtol=1e-3)
    assert abs(passes.mean() - through) < 4.5 * math.sqrt(max(through, 1e-4) / count)
    counts = cell_counts(actual.light.numpy().T[~passes].astype(np.float64))
    # 24 tests: a false alarm once in forty runs, were the seeds not fixed.
    assert p_value(counts, shares * count) > 1e-3


@pytest.mark.quick("lobes-False", "point-False", "point-True", "neural-False")
@pytest.mark.parametrize("between_yarns", [False, True])
@every_model_once
def test_no_light_is_made(name: str, between_yarns: bool) -> None:
    model = built(name, "white", between_yarns)
    if not model.conserves_energy:
        pytest.skip("does not claim it")
    rng = np.random.default_rng(10)
    places, each = 64, 512
    queried = queries(model.source, places, seed=11)[np.repeat(np.arange(places), each)]
    weight = drawn(model, queried, seed=12).weight.numpy()[0].reshape(places, each)
    mean, error = weight.mean(axis=1), weight.std(axis=1) / math.sqrt(each)
    # 64 means of 512 weights, none of which may pass 5 deviations. How open a point is, is fitted: single
    # points are off by 0.03 of their D with a deviation of 0.2 (`openness.py`), their mean is not.
    room = 0.1 if between_yarns and not model.filters else 1e-4
    assert (mean <= 1 + 5 * error + room).all()
    assert mean.mean() <= 1 + 1e-4
    # White cloth sends back most of what it gets, or the bound above says nothing.
    assert mean.mean() > 0.5
    # The same light by uniform directions: what is drawn is all there is.
    lights = rng.normal(size=(len(queried), 3))
    queried.lights = lights / np.linalg.norm(lights, axis=1, keepdims=True)
    actual = answers(model, queried)
    value, through = (
        part.reshape(places, each) for part in (actual.value.numpy()[0], actual.through.numpy())
    )
    uniform = 4 * math.pi * value + through
    spread = np.sqrt(error**2 + uniform.var(axis=1) / each)
    assert (np.abs(uniform.mean(axis=1) - mean) < 5 * spread + 1e-3).all()


@every_fabric
@every_model
def test_a_loom_file_gives_the_same_numbers(name: str, cloth: str, tmp_path: Path) -> None:
    model, queried = built(name, cloth), queries(fabric(cloth), 300, seed=13)
    path = tmp_path / "cloth.loom"
    write_loom(path, model.to_loom())
    again = model_from_loom(path)
    assert type(again) is type(model)
    first = path.read_bytes()
    write_loom(path, again.to_loom())
    assert path.read_bytes() == first
    actual, wanted = answers(again, queried), answers(model, queried)
    for what in ("value", "pdf", "through"):
        assert np.array_equal(getattr(actual, what).numpy(), getattr(wanted, what).numpy()), what


def test_views_in_these_tests_see_both_faces() -> None:
    sides = np.sign(directions(np.random.default_rng(0), 1000)[:, 2])
    assert abs(sides.mean()) < 0.1
