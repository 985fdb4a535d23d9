"""The parts of the clustered model against plain sums, and its estimates against all texels of a box.

Covers: models/clustered/bsdf.py, models/clustered/footprint_sums.py
Covers: models/clustered/tables.py, models/clustered/parallax.py
Covers: models/clustered/tables.py
Covers: models/clustered/square_map.py, models/random_numbers.py, models/clustered/bsdf.py
"""

from __future__ import annotations

from dataclasses import fields, replace
from functools import cache

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Bool, Float, UInt32

from loomlight.core.backend import array_types
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.models.clustered.model import ClusteredModel
from loomlight.models.clustered.square_map import BINS, bin_centres, bin_taps
from loomlight.models.clustered.tables import (
    NO_CLUSTER,
    NORMAL_UNIT,
    THREAD_BASE,
    bake_tables,
    densities,
    feature_maps,
    texel_counts,
)
from loomlight.models.random_numbers import hashed, uniform
from loomlight.models.separable import Components
from loomlight.scattering.point import to_face_frame
from loomlight.yarn.geometry import YarnGeometry
from tests.helpers.arrays import vectors
from tests.helpers.directions import directions
from tests.helpers.queries import Queries, queries
from tests.helpers.untrained import with_samples

require_llvm()

# References are of direct light.
TEXT = (
    'interreflection = false\nweave = "twill 2/1"\ngap = 0.3\n'
    '[warp]\ntranslucency = 0.4\n[weft]\ncolor = ["#c02020", "#20c040"]'
)
TYPES = array_types(Float)
PARTS = [part.name for part in fields(Components)]


@cache
def model(text: str = TEXT) -> ClusteredModel:
    """Few texels and clusters: every claim holds for any."""
    fabric = fabric_from_text(text)
    geometry = YarnGeometry(fabric.layout())
    tables = bake_tables(geometry, (0.3, 0.3), clusters=4, rank=2, float_type=Float, texels=32)
    return ClusteredModel(fabric, tables)


def test_bins_of_the_square_are_of_equal_area_and_interpolate_directions() -> None:
    centres = bin_centres()
    np.testing.assert_allclose(np.linalg.norm(centres, axis=1), 1, atol=1e-6)
    # The mean over bins of equal area is that over the hemisphere: z has 1/2, z² has 1/3.
    assert abs(centres[:, 2].mean() - 1 / 2) < 1e-3
    assert abs(np.square(centres[:, 2]).mean() - 1 / 3) < 1e-3
    table = Float(centres.astype(np.float32).ravel())
    wanted = directions(np.random.default_rng(0), 500)
    wanted[:, 2] = abs(wanted[:, 2])
    taps = bin_taps(vectors(wanted))
    actual = np.stack([taps.read(Float, table, UInt32(0), 3, UInt32(axis)).numpy() for axis in range(3)], 1)
    # Half a bin at the border of the square, where the tables end.
    assert np.abs(actual - wanted).max() < 2 / BINS
    assert np.abs(actual - wanted).mean() < 0.01


@pytest.mark.slow
def test_densities_are_those_of_the_fibre_layer() -> None:
    tables = model().tables
    maps = feature_maps(YarnGeometry(model().fabric.layout()), tables.counts, Float)
    labels = tables.labels[0].ravel()
    seen = np.flatnonzero(labels != NO_CLUSTER)
    exact = densities(maps.tangent[0].reshape(-1, 3)[seen], bin_centres().astype(np.float32), 0.3)
    parts = tables.basis[0].transpose(2, 1, 0)[labels[seen]]
    weights = np.c_[np.ones(len(seen)), tables.coefficients[0, ..., :2].reshape(-1, 2)[seen]]
    compressed = np.einsum("nr,nrh->nh", weights, parts)
    # Two components of four clusters explain most of the differences between fibres.
    assert np.square(compressed - exact).mean() < 0.2 * exact.var(axis=0).mean()


@pytest.mark.slow
def test_normals_are_those_of_the_yarns() -> None:
    tables = model().tables
    maps = feature_maps(YarnGeometry(model().fabric.layout()), tables.counts, Float)
    seen = tables.labels != NO_CLUSTER
    # Rounded to whole numbers of the unit.
    assert (
        np.abs(tables.coefficients[seen][:, -3:] * NORMAL_UNIT - maps.normal[seen]).max() < 0.51 * NORMAL_UNIT
    )


@pytest.mark.slow
def test_threads_beyond_those_of_half_precision_keep_their_numbers() -> None:
    made = model()
    columns, rows = made.tables.counts
    numbers = np.arange(columns * rows * 2).reshape(2, rows, columns) * 7
    texels = made.tables.texels.copy()
    above, below = np.divmod(numbers, THREAD_BASE)
    texels[..., 9], texels[..., 10] = below, above
    changed = ClusteredModel(made.fabric, replace(made.tables, texels=texels)).on_backend(TYPES)
    base = changed.seen_from(vectors(np.array([[0.0, 0.0, 1.0]])), Bool(True))
    taps = base.light_taps(vectors(np.array([[0.0, 0.6, 0.8]])))
    found = base.at_texel(UInt32(np.arange(columns * rows)), taps).thread.numpy()
    assert numbers.max() > 2048
    assert (found == numbers[1].ravel()).all()


@pytest.mark.parametrize("size", [0.01, 0.4, 3.3])
def test_sums_over_boxes_are_sums_over_texels(size: float) -> None:
    tables, device = model().tables, model().on_backend(TYPES)
    rng = np.random.default_rng(1)
    count = 20
    centre = rng.uniform(-3, 3, (2, count)).astype(np.float32)
    edges = (rng.uniform(0.5, 1, (2, count)) * size).astype(np.float32)
    zeros = dr.zeros(Float, count)
    footprint = Footprint(Array2f(centre), Array2f(Float(edges[0]), zeros), Array2f(zeros, Float(edges[1])))
    box = device.sums.box(footprint, Array2f(0, 0), Float(0))
    found = [part.numpy() for part in device.sums.means(box, Bool(False))]
    actual = np.concatenate([part.reshape(4, -1) for part in found])
    columns, rows = tables.counts
    for lane in range(count):
        place = [
            (int(first.numpy()[lane]) + np.arange(int(extent.numpy()[lane]))) % whole
            for first, extent, whole in zip(box.first, box.extent, (columns, rows), strict=True)
        ]
        labels = tables.labels[0][np.ix_(place[1], place[0])]
        coefficients = tables.coefficients[0][np.ix_(place[1], place[0])].astype(float)
        for cluster in range(4):
            inside = labels == cluster
            for number in range(6):
                wanted = (inside * (coefficients[..., number - 1] if number else 1)).mean()
                # Whole numbers below 2²⁴ are exact; of many repeats the last digit is rounded.
                assert abs(actual[4 * number + cluster, lane] - wanted) < 1e-5 * (127 if number else 1)


def test_the_base_over_a_box_is_the_mean_of_the_base_of_its_texels() -> None:
    device = model().on_backend(TYPES)
    rng = np.random.default_rng(2)
    light, view = directions(rng, 1), directions(rng, 1)
    view[:, 2] = abs(view[:, 2])
    base = device.seen_from(vectors(view), Bool(False))
    footprint = Footprint(Array2f(0.3, 0.2), Array2f(0.4, 0), Array2f(0, 0.6))
    box = device.box(footprint, vectors(view), Bool(False), Float(0))
    taps = base.light_taps(vectors(light))
    whole = base.over(device.sums.means(box, Bool(False)), taps)
    columns, rows = (int(extent.numpy()[0]) for extent in box.extent)
    s, t = (
        part.ravel()
        for part in np.meshgrid((np.arange(columns) + 0.5) / columns, (np.arange(rows) + 0.5) / rows)
    )
    texel = device.sums.texel(box, Float(s.astype(np.float32)), Float(t.astype(np.float32)))
    assert len(np.unique(texel.numpy())) == columns * rows
    each = base.at_texel(texel, taps).known
    for part in PARTS:
        np.testing.assert_allclose(
            getattr(whole, part).numpy()[0], getattr(each, part).numpy().mean(), rtol=1e-4, atol=1e-6
        )


@pytest.mark.quick("False")
@pytest.mark.parametrize("controlled", [True, False])
def test_estimates_are_unbiased(controlled: bool) -> None:
    """Against all texels of the same boxes; colours of threads differ, and light comes from either side."""
    made = with_samples(model(), 2)
    chosen = made if controlled else made.without_control()
    cases, each = 40, 2000
    asked = queries(made.fabric, cases, seed=3)
    # Edges along the axes: there is no segment that boxes are swept along.
    asked.edges = np.stack([np.diag(np.minimum(np.abs(edges).sum(axis=0), 2)) for edges in asked.edges])
    many = asked[np.repeat(np.arange(cases), each)]
    seed = UInt32(np.random.default_rng(5).integers(0, 2**32, len(many), dtype=np.uint32))
    at = chosen.at(many.view, many.footprint, seed=seed)
    value, components = at.value(many.light), at.components(many.light)
    dr.eval(value, components)
    actual = np.stack([getattr(components, part).numpy() for part in PARTS] + list(value.numpy()), axis=1)
    parts = actual.reshape(cases, each, -1)
    exact = np.stack([_mean_of_texels(made, asked[case : case + 1]) for case in range(cases)])
    error = np.sqrt(parts.var(axis=1) / each)
    # Of boxes of one texel nothing is left to estimate: rounding.
    z = (parts.mean(axis=1) - exact) / np.maximum(error, 1e-4 * np.abs(exact) + 1e-6)
    # 320 normal numbers of variance 1, which are no more than four deviations away.
    assert 0.7 < np.sqrt(np.square(z[np.abs(z) > 0]).mean()) < 1.4
    assert np.abs(z).max() < 4.5


def _mean_of_texels(made: ClusteredModel, asked: Queries) -> np.ndarray:
    """Components and colour of the surface over all texels of a box, with albedos of their own threads."""
    device, back = made.on_backend(TYPES), bool(asked.views[0, 2] < 0)
    seen = to_face_frame(asked.view, Bool(back))
    base = device.seen_from(seen, Bool(back))
    box = device.box(asked.footprint, seen, Bool(back), Float(0))
    columns, rows = (int(extent.numpy()[0]) for extent in box.extent)
    s, t = (
        part.ravel().astype(np.float32)
        for part in np.meshgrid((np.arange(columns) + 0.5) / columns, (np.arange(rows) + 0.5) / rows)
    )
    terms = base.at_texel(
        device.sums.texel(box, Float(s), Float(t)), base.light_taps(to_face_frame(asked.light, Bool(back)))
    )
    found = {part: getattr(terms.own, part).numpy() for part in PARTS}
    appearance = made.fabric.appearance()
    side = "transmit" if asked.lights[0, 2] * asked.views[0, 2] < 0 else "reflect"
    colour = np.zeros(3)
    for name in ("warp", "weft"):
        family = getattr(appearance, name)
        thread = np.minimum(terms.thread.numpy(), len(family.diffuse_reflect) - 1)
        for kind in ("diffuse", "specular"):
            albedos = np.asarray(getattr(family, f"{kind}_{side}"))[thread]
            colour += (albedos * found[f"{kind}_{name}"][:, None]).mean(axis=0)
    return np.concatenate([[part.mean() for part in found.values()], colour])


@pytest.mark.slow
def test_the_base_takes_most_of_the_noise() -> None:
    """With two clusters a family; models are baked with four."""
    made = with_samples(model(), 1)
    asked = queries(made.fabric, 30, seed=6)
    asked.lights[:, 2] = np.abs(asked.lights[:, 2]) * np.sign(asked.views[:, 2])
    asked.edges = np.tile(np.eye(2) * 5.0, (30, 1, 1))
    many = asked[np.repeat(np.arange(30), 400)]
    seed = UInt32(np.random.default_rng(7).integers(0, 2**32, len(many), dtype=np.uint32))

    def noise(chosen: ClusteredModel) -> float:
        value = chosen.at(many.view, many.footprint, seed=seed).value(many.light).numpy()
        return float(value.reshape(3, 30, 400).var(axis=2).sum())

    assert noise(made) < 0.65 * noise(made.without_control())


def test_holes_are_the_share_of_texels_without_yarn() -> None:
    made = model()
    asked = queries(made.fabric, 50, seed=8)
    width, height = made.fabric.repeat_mm
    asked.edges = np.tile(np.diag([width, height]), (50, 1, 1))
    hole = made.at(asked.view, asked.footprint).hole.numpy()
    np.testing.assert_allclose(hole, (made.tables.labels[0] == NO_CLUSTER).mean(), atol=1e-5)


def test_random_numbers_are_uniform_and_repeat_with_the_cloth() -> None:
    made = model()
    asked = queries(made.fabric, 20_000, seed=8)
    size = model().on_backend(TYPES).size
    seed = hashed(asked.view, asked.footprint, size)
    for dimension in range(3):
        counts, _ = np.histogram(uniform(seed, dimension).numpy(), bins=20, range=(0, 1))
        # 20 bins of 1000 with a deviation of 31.
        assert np.abs(counts - 1000).max() < 140
    moved = hashed(asked.view, asked.moved(made.fabric.repeat_mm).footprint, size)
    assert (moved.numpy() == seed.numpy()).mean() > 0.99


def test_a_large_repeat_has_fewer_texels_a_thread_and_says_what_it_takes() -> None:
    geometry = YarnGeometry(fabric_from_text('weave = "satin 201/80"').layout())
    with pytest.warns(LoomlightWarning, match=r"across the finest thread instead of 6, take 15 MB in a file"):
        columns, rows = texel_counts(geometry, 256)
    assert 2 <= columns * geometry.finest[0] / geometry.size[0] < 6
    assert 0.98 * 208_000 < columns * rows <= 208_000
    too_large = YarnGeometry(fabric_from_text('weave = "satin 401/150"').layout())
    with pytest.raises(InputError, match=r"texels, 46 MB in a file: clustered takes up to 15 MB; use lobes"):
        texel_counts(too_large, 256)
