"""Albedos: the bound that keeps cloth from creating light, the map into it, the refusals.

Covers: scattering/albedo.py
"""

from __future__ import annotations

import drjit as dr
import drjit.llvm.ad as jit
import numpy as np
import pytest

from loomlight.core.colour import parse_colour
from loomlight.core.errors import InputError
from loomlight.scattering import fibre
from loomlight.scattering.albedo import Albedos, albedos_from_colour, check_albedos, layer_albedo_bound
from loomlight.scattering.diffuse import diffuse_reflection, diffuse_transmission, sample_diffuse
from loomlight.scattering.fibre import bound_in_use, cloth_layer_bound
from loomlight.scattering.sheen import sheen_lobe
from tests.helpers.references import microflakes as flakes

WHITE = np.ones((1, 3))


def vector(values: np.ndarray) -> jit.Array3f:
    return jit.Array3f(np.atleast_2d(values).T.astype(np.float32))


def numbers(rng: np.random.Generator, count: int) -> jit.Array2f:
    return jit.Array2f(rng.random((2, count)).astype(np.float32))


def layer_albedos(view: np.ndarray, roughness: float, depth: float, side: int = 96) -> np.ndarray:
    """Fraction of light that a layer of albedo 1 returns above and below [2, views]; normal z, fibres on x.

    Quadrature in float64 over visible points of the stretched sphere, where the density cancels.
    """
    r = np.sqrt((np.arange(side) + 0.5) / side)[:, None]
    azimuth = (np.arange(side) + 0.5) / side * 2 * np.pi
    disc = np.stack(np.broadcast_arrays(r * np.cos(azimuth), r * np.sin(azimuth), np.sqrt(1 - r**2)), -1)
    squeeze = np.array([roughness, 1, 1])
    shares = []
    for v in view:
        half = flakes.unit(disc.reshape(-1, 3) @ flakes.frame_about(flakes.unit(v * squeeze)) * squeeze)
        light = 2 * (half @ v)[:, None] * half - v
        slopes = [
            np.linalg.norm(w * squeeze, axis=-1) / np.maximum(np.abs(w[..., 2]), 1e-9) for w in (light, v)
        ]
        total, apart = slopes[0] + slopes[1], np.abs(slopes[0] - slopes[1]) + 1e-9
        turned = slopes[1] * -np.expm1(-depth * total) / total
        through = slopes[1] * np.exp(-depth * np.minimum(*slopes)) * -np.expm1(-depth * apart) / apart
        above = light[:, 2] > 0
        shares.append((np.mean(turned * above), np.mean(through * ~above)))
    return np.array(shares).T


def test_bound_holds_over_a_dense_scan() -> None:
    rng = np.random.default_rng(11)
    worst_above, worst_use = 0.0, 0.0
    for roughness in np.geomspace(0.01, 1, 9):
        # Half of the views graze, where the layer returns most; azimuths from along the fibre to across.
        cos = np.concatenate([10 ** rng.uniform(-4, -1, 8), rng.uniform(0, 1, 8)])
        azimuth = np.concatenate([[0, np.pi / 2], rng.uniform(0, np.pi / 2, 14)])
        sin = np.sqrt(1 - cos**2)
        view = np.stack([sin * np.cos(azimuth), sin * np.sin(azimuth), cos], -1)
        for depth in (0.01, 0.1, 0.5, 1, 2, 5, 50):
            above, below = layer_albedos(view, roughness, depth)
            worst_above = max(worst_above, above.max())
            worst_use = max(worst_use, (above + below).max() / layer_albedo_bound(depth))
    # The quadrature's midpoints lie within 2e-3 of the exact half at grazing angles.
    assert worst_above < 0.502
    assert worst_use < 1.003


def test_bound_needs_perpendicular_tangents() -> None:
    """Why geometry must keep them so: the same view of fibres that lie flat, and that stand 0.2 rad out."""
    count = 1 << 16
    view, normal = vector(flakes.unit([-1, 0, 0.005])), jit.Array3f(0, 0, 1)
    alpha, u = jit.Float(0.02), numbers(np.random.default_rng(1), count)

    def returned(tilt: float) -> float:
        tangent = vector(np.array([np.cos(tilt), 0, np.sin(tilt)]))
        light = fibre.sample_specular(view, tangent, alpha, u)
        value = fibre.reflection(light, view, normal, tangent, alpha, 2.0)
        return dr.mean(value / fibre.pdf_specular(light, view, tangent, alpha))[0]

    assert returned(0.2) > 0.9
    assert returned(0.0) < 0.51


@pytest.mark.slow
def test_cloth_never_returns_more_than_it_gets() -> None:
    """White furnace over all parameter ranges: specular and diffuse, both sides, sheen on top."""
    rng = np.random.default_rng(12)
    count, excess = 1 << 15, []
    for number in range(96):
        roughness = float(np.exp(rng.uniform(np.log(0.01), 0)))
        depth = float(np.exp(rng.uniform(np.log(0.05), np.log(20))))
        # A third of the sets are the worst there is: white, all of the bound used, seen at grazing angles.
        hard = number % 3 == 0
        colour = 1.0 if hard else rng.uniform(0, 1)
        albedos = albedos_from_colour(
            np.full(3, colour), rng.uniform(0, 1), 1.0 if hard else rng.uniform(0, 1), depth
        )
        check_albedos(albedos, "warp", depth)
        k = [float(values[0, 0]) for values in albedos]
        view, normal, tangent = flakes.random_frames(rng, 1)
        if hard:
            view = flakes.unit(view - 0.999 * np.sum(view * normal) * normal)
        blend, strength = jit.Float(rng.uniform(0, 1)), rng.uniform(0, 1)
        # The macro normal is z; turning everything so that the view lies above it.
        flip = np.array([1, 1, np.sign(view[0, 2])])
        v, n, t = (vector(rows * flip) for rows in (view, normal, tangent))
        light = fibre.sample_specular(v, t, jit.Float(roughness), numbers(rng, count))
        frame = (n, t, jit.Float(roughness), depth)
        near = dr.select(light.z > 0, k[2] * fibre.reflection(light, v, *frame), 0)
        far = dr.select(light.z < 0, k[3] * fibre.transmission(light, v, *frame), 0)
        specular = ((near + far) / fibre.pdf_specular(light, v, t, jit.Float(roughness))).numpy()
        light = sample_diffuse(n, blend, numbers(rng, count))
        density = diffuse_reflection(light, n, blend) + diffuse_transmission(-light, n, blend)
        value = k[0] * diffuse_reflection(light, n, blend) + k[1] * diffuse_transmission(-light, n, blend)
        diffuse = dr.select(density > 0, 2 * value / density, 0).numpy()
        reflectance = strength * float(sheen_lobe(v.z, rng.uniform(0, 1))[2].numpy()[0])
        total = reflectance + (1 - reflectance) * (specular.mean() + diffuse.mean())
        error = np.sqrt((specular.var() + diffuse.var()) / count)
        excess.append((total - 1) / max(error, 1e-5))
    # The largest of 96 normal variables exceeds 4 in 3 of 1000 cases, if every set were at its bound.
    assert max(excess) < 4


def test_white_looks_white_and_dark_stays_dark() -> None:
    """Directional albedo seen from straight above, where half of the highlight is lost to below."""
    view = np.array([[0.0, 0, 1]])
    shine = layer_albedos(view, 0.3, 2.0)[0, 0]

    def seen(colour: object, specular: float) -> np.ndarray:
        albedos = albedos_from_colour(parse_colour(colour, "colour"), specular, 0.0)
        return (albedos.diffuse_reflect + shine * albedos.specular_reflect)[0]

    assert seen("#ffffff", 0.3).min() > 0.85
    assert seen("#ffffff", 0.0).min() == 1
    denim = parse_colour("#1c2a4a", "colour")
    # The highlight adds no more than cotton's own surface reflection of a few percent.
    assert np.all(seen("#1c2a4a", 0.3) - denim < 0.05)
    assert np.all(seen("#1c2a4a", 0.3) >= denim * 0.9)


def test_map_splits_by_translucency() -> None:
    opaque = albedos_from_colour([0.2, 0.5, 0.9], 0.4, 0.0)
    half = albedos_from_colour([0.2, 0.5, 0.9], 0.4, 0.5)
    assert not opaque.diffuse_transmit.any()
    assert not opaque.specular_transmit.any()
    np.testing.assert_allclose(half.diffuse_reflect + half.diffuse_transmit, opaque.diffuse_reflect)
    np.testing.assert_allclose(half.specular_transmit, 0.5 * half.specular_reflect)


def test_map_stays_inside_the_bound_and_takes_rows() -> None:
    rng = np.random.default_rng(13)
    colour, specular, translucency = rng.random((500, 3)), rng.random(500), rng.random(500)
    for depth in (0.1, 2.0, 10.0):
        albedos = albedos_from_colour(colour, specular, translucency, depth)
        assert all(values.shape == (500, 3) for values in albedos)
        check_albedos(albedos, "weft", depth)
    one = albedos_from_colour(colour[3], specular[3], translucency[3], 10.0)
    np.testing.assert_array_equal(one.diffuse_reflect[0], albedos.diffuse_reflect[3])


def test_albedos_grow_with_the_colour_and_the_highlight_with_specular() -> None:
    """Also in thin layers, where the bound leaves a white thread of specular 1 no diffuse albedo at all."""
    greys = np.linspace(0, 1, 101)[:, None] * np.ones(3)
    before: Albedos | None = None
    # Around 1.74 the scale of the highlight leaves 1; steps of optical depth change no albedo by much.
    for depth in np.geomspace(0.01, 100, 400):
        for specular in (0.0, 0.5, 1.0):
            albedos = albedos_from_colour(greys, specular, 0.3, float(depth))
            check_albedos(albedos, "warp", float(depth))
            for values in albedos:
                assert (np.diff(values, axis=0) >= -1e-12).all(), (depth, specular)
        if before is not None:
            assert max(np.abs(a - b).max() for a, b in zip(albedos, before, strict=True)) < 0.02
        before = albedos
    thin = [albedos_from_colour(greys, specular, 0.0, 0.05).specular_reflect for specular in (0.2, 0.9)]
    assert (thin[0] < thin[1]).all()
    # Files that say nothing of the optical depth have 2, where nothing is scaled.
    np.testing.assert_allclose(albedos_from_colour(np.ones(3), 1.0, 0.0).specular_reflect, 1)


def test_explicit_albedos_outside_the_bound_are_refused() -> None:
    good = Albedos(0.4 * WHITE, 0.1 * WHITE, 0.8 * WHITE, 0.2 * WHITE)
    check_albedos(good, "warp")
    with pytest.raises(
        InputError, match=r"warp: .*thread 1 is 0\.7 \+ 0\.568 × 0\.8 = 1\.154.*in R"
    ) as error:
        check_albedos(good._replace(diffuse_reflect=0.6 * WHITE), "warp")
    assert str(error.value).count(". ") == 0
    rows = np.array([[0.1, 0.1, 0.1], [0.1, 1.5, 0.1]])
    with pytest.raises(InputError, match=r"weft\.specular_reflect of thread 2 is 1\.5 in G"):
        check_albedos(Albedos(0 * rows, 0 * rows, rows, 0 * rows), "weft")
    with pytest.raises(InputError, match="nan in B"):
        check_albedos(good._replace(diffuse_transmit=np.array([[0, 0, np.nan]])), "warp")


@pytest.mark.parametrize("translucency", [0.0, 0.3, 1.0])
def test_in_cloth_both_sides_of_the_layer_have_their_own_bound(translucency: float) -> None:
    """White threads use it up, whatever goes through; it leaves more than the bound of a yarn alone."""
    bound = cloth_layer_bound(0.3, 2.0)
    white = albedos_from_colour(np.ones(3), 0.8, translucency, 2.0, bound)
    check_albedos(white, "warp", 2.0, bound)
    diffuse = white.diffuse_reflect + white.diffuse_transmit
    alone = albedos_from_colour(np.ones(3), 0.8, translucency)
    assert (diffuse > alone.diffuse_reflect + alone.diffuse_transmit + 0.1).all()
    in_use = bound_in_use(cloth_layer_bound(0.3, 2.0), white.specular_reflect, white.specular_transmit)
    np.testing.assert_allclose(diffuse + in_use * white.specular_reflect, 1)
    with pytest.raises(InputError, match=r"the smaller of thread 1 is .*in R, and more than 1"):
        check_albedos(white._replace(diffuse_reflect=white.diffuse_reflect + 0.01), "warp", 2.0, bound)
