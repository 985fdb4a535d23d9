"""Closed forms over a group of fibres against sums over the fibres."""

from __future__ import annotations

from typing import Any

import drjit as dr
import numpy as np
import pytest
from drjit.llvm.ad import Array3f, Bool, Float
from numpy.typing import NDArray

from loomlight.models.lobes.prefiltered import (
    GROUP_NARROWEST,
    GroupLobe,
    layer_value,
    mean_area,
    mean_density,
)
from loomlight.scattering.fibre import density, projected_area, reflection, transmission
from loomlight.yarn.geometry import YarnGeometry
from tests.helpers.arrays import floats, vectors
from tests.helpers.directions import directions

from .cloths import geometry_of

COUNT = 2000
OPTICAL_DEPTH = 2.0
# Float32: far from a narrow highlight the two terms of the closed form cancel to 1/(k x²) of their size.
RELATIVE = 5e-4


def lobe_of(normals: NDArray[Any], tangents: NDArray[Any], roughness: float) -> GroupLobe:
    """Moments of many groups of many fibres each: both [groups, fibres, 3]."""
    covariance = np.einsum("gfi,gfj->gij", tangents, tangents) / tangents.shape[1]
    mean = tangents.mean(axis=1)
    covariance -= mean[:, :, None] * mean[:, None, :]
    places = (0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)
    return GroupLobe(
        vectors(normals.mean(axis=1)),
        vectors(mean),
        *(floats(covariance[:, i, j]) for i, j in places),
        opaque(roughness),
    )


def opaque(number: float) -> Float:
    """A number that is no literal: kernels are compiled once for all of them."""
    return dr.opaque(Float, number)


def units(vectors: NDArray[np.float64]) -> NDArray[np.float64]:
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def fibres(rng: np.random.Generator, groups: int, spread: float) -> tuple[NDArray[np.float64], ...]:
    """Normals near z and fibre directions across them, both [groups, 256, 3], spread evenly."""
    lean = rng.uniform(-1, 1, (groups, 1, 3)) * [0.3, 0.3, 0] + [0, 0, 1]
    normals = units(lean + spread * rng.uniform(-1, 1, (groups, 256, 3)) * [1, 1, 0])
    turn = rng.uniform(0, np.pi, (groups, 1)) + spread * rng.uniform(-1, 1, (groups, 256))
    along = np.stack([np.cos(turn), np.sin(turn), np.zeros_like(turn)], axis=2)
    return normals, units(along - (along * normals).sum(axis=2, keepdims=True) * normals)


def one_fibre(tangents: NDArray[np.float64], roughness: float) -> GroupLobe:
    return lobe_of(tangents[:, None], tangents[:, None], roughness)


def boxed(along: NDArray[np.float64], width: NDArray[np.float64], roughness: float) -> NDArray[np.float64]:
    """Mean of D(x) over along ± width by a Gauss rule of 400 points."""
    nodes, weights = np.polynomial.legendre.leggauss(400)
    x = along[:, None] + width[:, None] * nodes
    values = 1 / (np.pi * roughness * (1 + (1 / roughness**2 - 1) * x**2) ** 2)
    return values @ weights / 2


@pytest.mark.quick("0.3-0.6", "1.0-0.95")
@pytest.mark.parametrize("roughness", [0.05, 0.2, 0.6, 0.95])
@pytest.mark.parametrize("spread", [0.05, 0.3, 1.0])
def test_density_is_the_mean_over_an_interval(roughness: float, spread: float) -> None:
    rng = np.random.default_rng(1)
    normals, tangents = fibres(rng, COUNT, spread)
    lobe = lobe_of(normals, tangents, roughness)
    half = directions(rng, COUNT, lowest=0.02)
    along, variance = (
        part.numpy() for part in (dr.dot(vectors(half), lobe.tangent), lobe.variance(vectors(half)))
    )
    width = np.maximum(np.sqrt(3 * variance), GROUP_NARROWEST * roughness + 1e-4)
    actual = mean_density(vectors(half), lobe).numpy()
    expected = boxed(along.astype(np.float64), width.astype(np.float64), roughness)
    np.testing.assert_allclose(actual, expected, rtol=RELATIVE)
    assert (actual > 0).all()


@pytest.mark.parametrize("roughness", [0.05, 0.3, 0.8])
def test_interval_moves_density_and_loses_none(roughness: float) -> None:
    """∫ D̄ over all means is ∫ D, whatever the width: 1/(2α√k)."""
    middle = np.linspace(-40, 40, 1 << 20)
    none = Float(0)
    for variance in (1e-4, 0.01, 0.3):
        lobe = GroupLobe(
            Array3f(0, 0, 1),
            vectors(np.outer(middle, [1, 0, 0])),
            Float(variance),
            *[none] * 5,
            opaque(roughness),
        )
        actual = mean_density(Array3f(1, 0, 0), lobe).numpy().astype(np.float64)
        total = np.trapezoid(actual, middle)
        steepness = np.sqrt(1 / roughness**2 - 1)
        # The rest of the line holds 1/(3 k^{3/2} 40³) of it.
        assert total == pytest.approx(1 / (2 * roughness * steepness), rel=2e-3)


def test_round_fibres_are_alike_everywhere() -> None:
    rng = np.random.default_rng(2)
    for spread in (0.0, 0.5):
        lobe = lobe_of(*fibres(rng, COUNT, spread), 1.0)
        np.testing.assert_allclose(
            mean_density(vectors(directions(rng, COUNT, lowest=0.02)), lobe).numpy(), 1 / np.pi, rtol=1e-5
        )


@pytest.mark.parametrize("roughness", [0.1, 0.4, 0.9])
def test_without_spread_it_is_one_fibre(roughness: float) -> None:
    """Density and area; the width that is left flattens the peak by less than k w²·2/3 = 3e-4."""
    rng = np.random.default_rng(3)
    tangents, half = directions(rng, COUNT, lowest=0.02), directions(rng, COUNT, lowest=0.02)
    lobe = one_fibre(tangents, roughness)
    expected = density(vectors(half), vectors(tangents), Float(roughness)).numpy()
    np.testing.assert_allclose(mean_density(vectors(half), lobe).numpy(), expected, rtol=2e-3, atol=1e-5)
    area = projected_area(vectors(half), vectors(tangents), Float(roughness)).numpy()
    np.testing.assert_allclose(mean_area(vectors(half), lobe).numpy(), area, rtol=1e-4)


def test_wide_spread_is_flat() -> None:
    """An interval much wider than the lobe holds all of it: ∫ D/(2w) wherever its middle lies."""
    roughness, variance = 0.02, 0.25
    lobe = GroupLobe(
        Array3f(0, 0, 1), Array3f(0, 0, 0), *[Float(variance)] * 3, *[Float(0)] * 3, Float(roughness)
    )
    half = directions(np.random.default_rng(4), COUNT, lowest=0.02)
    steepness = np.sqrt(1 / roughness**2 - 1)
    expected = 1 / (2 * roughness * steepness) / (2 * np.sqrt(3 * variance))
    # The tails that lie outside are 2/(3π (k w²)^{3/2}) of it.
    np.testing.assert_allclose(mean_density(vectors(half), lobe).numpy(), expected, rtol=1e-3)


@pytest.mark.parametrize("roughness", [0.15, 0.5])
def test_projected_area_of_the_density_is_that_of_the_fibres(roughness: float) -> None:
    """∫ D̄(h)⟨h·ω⟩ dh is the mean σ(ω), which `mean_area` stands for."""
    rng = np.random.default_rng(5)
    rows, columns = 256, 512
    z = -1 + 2 * (np.arange(rows) + 0.5) / rows
    azimuth = 2 * np.pi * (np.arange(columns) + 0.5) / columns
    z, azimuth = (grid.ravel() for grid in np.meshgrid(z, azimuth, indexing="ij"))
    radius = np.sqrt(1 - z**2)
    half = np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), z], axis=1)
    for spread in (0.0, 0.15):
        normals, tangents = fibres(rng, 1, spread)
        lobe = lobe_of(normals, tangents, roughness)
        actual = mean_density(vectors(half), lobe).numpy()
        for towards in directions(rng, 5, lowest=0.02):
            area = (actual * np.maximum(half @ towards, 0)).mean() * 4 * np.pi
            exact = np.sqrt(1 - (1 - roughness**2) * (tangents[0] @ towards) ** 2).mean()
            # Directions are not spread quite as a box is, and a root mean square is no mean.
            assert area == pytest.approx(exact, rel=5e-3 if spread == 0 else 0.04)
            assert mean_area(vectors(towards[None]), lobe).numpy()[0] == pytest.approx(exact, rel=0.04)


def pairs_above(rng: np.random.Generator, beyond: bool) -> tuple[NDArray[np.float64], ...]:
    """Lights and views within 60° of ±z."""
    lights, views = (np.abs(directions(rng, COUNT, 0.5)) for _ in range(2))
    for part in (lights, views):
        part[:, :2] *= rng.choice([-1.0, 1.0], (COUNT, 2))
    lights[:, 2] *= -1 if beyond else 1
    return lights, views


@pytest.mark.parametrize("beyond", [False, True])
@pytest.mark.parametrize("roughness", [0.1, 0.4, 1.0])
def test_layer_of_like_fibres_is_the_layer_of_one(roughness: float, beyond: bool) -> None:
    rng = np.random.default_rng(6)
    normals, tangents = fibres(rng, COUNT, 0.0)
    lights, views = pairs_above(rng, beyond)
    half = units(lights + views)
    lobe = lobe_of(normals, tangents, roughness)
    actual = layer_value(
        vectors(half), vectors(lights), vectors(views), Bool(beyond), lobe, Float(OPTICAL_DEPTH)
    )
    formula = transmission if beyond else reflection
    expected = formula(
        vectors(lights),
        vectors(views),
        vectors(normals[:, 0]),
        vectors(tangents[:, 0]),
        Float(roughness),
        OPTICAL_DEPTH,
    ).numpy()
    assert (expected > 0).mean() > 0.95
    lit = expected > 0
    # What is left of width, and the quotient of light and view that nearly oppose each other.
    np.testing.assert_allclose(actual.numpy()[lit], expected[lit], rtol=5e-3, atol=1e-5)


@pytest.mark.parametrize("beyond", [False, True])
def test_layer_of_a_group_is_the_mean_over_its_points(beyond: bool) -> None:
    """Points of a real yarn that lie close together, as many groups make them."""
    rng = np.random.default_rng(7)
    geometry: YarnGeometry = geometry_of("smooth satin")
    patches, each = 300, 256
    corner = rng.random((patches, 1, 2)) * geometry.size
    places = (corner + 0.03 * min(geometry.finest) * rng.random((patches, each, 2))).reshape(-1, 2)
    point = geometry.surface(floats(places[:, 0]), floats(places[:, 1]), Bool(False))
    normals, tangents = (
        part.numpy().T.reshape(patches, each, 3).astype(np.float64) for part in (point.normal, point.tangent)
    )
    smooth = ~point.hole.numpy().reshape(patches, each).any(axis=1)
    smooth &= np.ptp(normals, axis=1).max(axis=1) < 0.15
    smooth &= np.ptp(tangents, axis=1).max(axis=1) < 0.1
    assert smooth.mean() > 0.3
    normals, tangents = normals[smooth], tangents[smooth]
    count = len(normals)
    lights, views = (part[:count] for part in pairs_above(rng, beyond))
    facing = (normals @ views[:, :, None]).min(axis=(1, 2)) > 0.3
    facing &= ((normals @ lights[:, :, None]) * (-1 if beyond else 1)).min(axis=(1, 2)) > 0.3
    half = units(lights + views)
    roughness = 0.3
    actual = layer_value(
        vectors(half),
        vectors(lights),
        vectors(views),
        Bool(beyond),
        lobe_of(normals, tangents, roughness),
        Float(2),
    ).numpy()
    formula = transmission if beyond else reflection
    every = formula(
        vectors(np.repeat(lights, each, axis=0)),
        vectors(np.repeat(views, each, axis=0)),
        vectors(normals.reshape(-1, 3)),
        vectors(tangents.reshape(-1, 3)),
        Float(roughness),
        Float(2),
    ).numpy()
    expected = every.reshape(count, each).mean(axis=1)
    assert facing.sum() > 20
    error = np.abs(actual - expected)[facing]
    assert error.mean() < 0.01 * expected[facing].mean()
    assert (error < 0.1 * expected[facing] + 1e-4).all()
