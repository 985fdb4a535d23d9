"""Models that sample points: the point model itself, its mean, and both faces.

Covers: models/point.py
"""

from __future__ import annotations

from dataclasses import fields

import drjit as dr
import numpy as np
import pytest

from loomlight.core.llvm import require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.models.interface import Model
from loomlight.models.point import PointModel, SampledModel, SamplesOptions
from loomlight.models.separable import Components, SeparableBsdf
from studies.instruments.reference import reference
from tests.helpers.fabrics import fabric
from tests.helpers.queries import Queries, queries

require_llvm()


def parts_of(model: Model, queried: Queries) -> dict[str, np.ndarray]:
    """Components and the hole by name [n]."""
    at = model.at(queried.view, queried.footprint)
    assert isinstance(at, SeparableBsdf)
    components, hole = at.components(queried.light), at.hole
    dr.eval(components, hole)
    parts = {part.name: getattr(components, part.name).numpy() for part in fields(Components)}
    return parts | {"hole": hole.numpy()}


def test_one_point_is_the_point_model_with_its_variation() -> None:
    varied = fabric_from_text('weave = "twill 2/1"\n[variation]\nfibre_noise = 0.8\ncolour_noise = 0.3')
    queried = queries(varied, 3000, seed=1)
    model = PointModel.for_source(varied)
    actual = model.at(queried.view, queried.footprint).value(queried.light)
    centre = queried.footprint.centre
    point = model.point_model.locate(centre.x, centre.y, queried.view)
    exact = model.point_model.evaluate(point, queried.light, queried.view)
    dr.eval(actual, exact)
    # The same searches in two kernels: in 1 lane of 1000 rounding may decide about a shadow's edge.
    near = np.isclose(actual.numpy(), exact.numpy(), rtol=1e-3, atol=1e-6).all(axis=0)
    assert near.mean() > 0.999
    assert (exact.numpy().max(axis=0) > 0).mean() > 0.4


@pytest.mark.slow
def test_many_points_are_the_reference() -> None:
    cloth = fabric("coloured twill")
    queried = queries(cloth, 40, seed=2)
    model = SampledModel(cloth, SamplesOptions(points=1024))
    at = model.at(queried.view, queried.footprint)
    actual = np.concatenate([at.value(queried.light).numpy(), at.hole.numpy()[None]]).T
    exact = reference(model.point_model, queried.footprint, queried.lights, queried.views, 4096, seed=3)
    # 160 means; even points scatter less than random ones, of which a quarter as many would scatter twice.
    order = [5, 6, 7, 4]
    spread = 5 * np.sqrt(exact.variance[:, order] * 5) + 1e-4
    assert (np.abs(actual - exact.mean[:, order]) < spread).all()


def test_points_of_nearly_equal_footprints_differ() -> None:
    # 12 threads of a weave of 8, all about one place: with the same points in each, the mean is far off.
    cloth = fabric_from_text('weave = "satin 8/3"')
    many = 16384
    at, thread = np.random.default_rng(6), float(cloth.layout().warp.spacing[0])
    view = np.array([-0.2, 0.4, 1]) + 1e-4 * at.standard_normal((many, 3))
    view /= np.linalg.norm(view, axis=-1, keepdims=True)
    light = np.tile(np.array([0.3, 0.2, 1]) / np.sqrt(1.13), (many, 1))
    edges = np.tile(12 * thread * np.eye(2), (many, 1, 1))
    together = Queries(light, view, np.zeros((many, 2)), edges)
    apart = Queries(light, view, 12 * thread * (at.random((many, 2)) - 0.5), edges * 1e-4)
    values = [
        model.at(asked.view, asked.footprint).value(asked.light).numpy().mean(axis=0)
        for model, asked in (
            (SampledModel(cloth, SamplesOptions(points=8)), together),
            (PointModel.for_source(cloth), apart),
        )
    ]
    spread = np.sqrt(sum(np.var(value) / many for value in values))
    assert abs(np.mean(values[0]) - np.mean(values[1])) < 4 * spread
    assert 4 * spread < 0.05 * np.mean(values[1])


def test_plain_weave_from_behind_is_plain_weave_shifted_by_a_thread() -> None:
    plain = fabric_from_text('weave = "plain"\ngap = 0.25\n[warp]\ntwist_deg = 0.0\n[weft]\ntwist_deg = 0.0')
    model = PointModel.for_source(plain)
    front = queries(plain, 3000, seed=4)
    mirror = np.array([1, 1, -1])
    shift = np.array([float(plain.layout().warp.spacing[0]), 0])
    behind = Queries(front.lights * mirror, front.views * mirror, front.centres + shift, front.edges)
    parts = [parts_of(model, one) for one in (front, behind)]
    for name in parts[0]:
        here, there = (part[name] for part in parts)
        assert np.isclose(here, there, rtol=1e-2, atol=1e-5).mean() > 0.997, name
        assert (here > 0).any()
