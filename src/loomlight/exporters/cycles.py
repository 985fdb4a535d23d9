"""How Cycles shades a fitted material, and the numbers by which it then comes nearest to a model.

Two diffuse layers share the light as the model has it, one about the normals of yarns, one about the mesh's
own. Blender's may be rough: they scatter back towards the light, as cloth does whose yarns shade each other.
And Cycles darkens diffuse light from directions that the surface beneath a map of normals hides. With all of
it in the formula, the fit's diffuse and glossy layers are weighed anew.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import drjit as dr
import numpy as np
from drjit.llvm import Array2f as Vector2
from drjit.llvm import Array3f, Float
from numpy.typing import NDArray

from loomlight.core.backend import upload_vector
from loomlight.core.footprint import Footprint
from loomlight.exporters.fit import TEXEL_FIELDS, FittedMaterial
from loomlight.exporters.standards import StandardMaterial, evaluate_gltf
from loomlight.exporters.texels import MIN_COVER, TexelGrid
from loomlight.models.interface import Model

Numbers = NDArray[np.float64]
_QUERIES = 6000
# Flatter views and lights are left out.
_MIN_COSINE = 0.12
# Most of a picture is seen, and lit, from nearer to the normal: there the mean is kept.
_FACING = 0.5
# Lights by which the texels' own factors are found.
_MIN_LIGHTS, _MAX_LIGHTS, _PRIOR = 4, 16, 0.05
# Queries in all, unless lights were too few, and texels whose factors are found at once: 300 MB.
_MAX_QUERIES, _MAX_BAND = 1 << 22, 1 << 18
# f·cos of a white sheet under a light from straight above, 1/sr.
_WHITE = 1 / np.pi
# Diffuse roughnesses that are tried, and bounds of the factors of layers.
_ROUGHNESSES = np.linspace(0.0, 1.0, 6)
_MIN_FACTOR, _MAX_FACTOR = 0.25, 4.0


@dataclass(frozen=True)
class CyclesLayers:
    """The layers of a material in Cycles.

    Attributes:
        diffuse, glossy: what their colours are multiplied by.
        diffuse_roughness: of the diffuse layer, 0 to 1.
        error: root mean square of differences from the model, relative to that of its values; both divided by
            the values' roots.
    """

    diffuse: float
    glossy: float
    diffuse_roughness: float
    error: float


def cycles_layers(material: FittedMaterial, grid: TexelGrid, model: Model, blend: float) -> CyclesLayers:
    """The layers by which Cycles shows the material nearest to a model, over views that pictures have.

    Args:
        blend: w, the share of diffuse light that follows the yarns' normals, 0 to 1.
    """
    rng = np.random.default_rng(11)
    rows, columns = material.cover.shape
    row, column = rng.integers(0, rows, _QUERIES), rng.integers(0, columns, _QUERIES)
    # Views as pictures have them: facing ones are as many as flat ones. Lights as under a white sky.
    view = _directions(rng, rng.uniform(_MIN_COSINE, 1, _QUERIES))
    light = _directions(rng, np.sqrt(rng.uniform(_MIN_COSINE**2, 1, _QUERIES)))
    middles = grid.places(np.asarray(row + 0.5, float), np.asarray(column + 0.5, float))
    truth = _values(model, material, middles.T, view, light)
    seen = material.cover[row, column] > MIN_COVER
    row, column = row[seen], column[seen]
    view, light, truth = view[seen], light[seen], truth[seen]
    cover = material.cover[row, column, None]
    place = _at(material, row, column)
    glossy = cover * evaluate_gltf(replace(place, base=0 * place.base), light, view)
    expected = cover * diffuse_of(place, light, view, blend, 0.0) + glossy
    weight = _weight(expected, truth)
    facing = (light[:, 2] > _FACING) & (view[:, 2] > _FACING)
    found = []
    for roughness in _ROUGHNESSES:
        diffuse = cover * diffuse_of(place, light, view, blend, float(roughness))
        found.append(_weighed(diffuse, glossy, truth, weight, facing, float(roughness)))
    return min(found, key=lambda layers: layers.error)


def diffuse_of(
    place: StandardMaterial, light: Numbers, view: Numbers, blend: float, roughness: float
) -> Numbers:
    """What both diffuse layers reflect of lights above, f·cos [n, 3], 1/sr.

    Args:
        blend: share of the layer about the yarns' normals, 0 to 1.
        roughness: of both layers, 0 to 1.
    """
    below = 1 - place.weight * place.specular.max(-1)
    albedo = place.base * ((1 - place.transmission) * below)[:, None]
    face = np.broadcast_to([0.0, 0.0, 1.0], place.normal.shape)
    total: Numbers | float = 0.0
    for normal, share in ((place.normal, blend), (face, 1 - blend)):
        lit = np.maximum((normal * light).sum(-1), 0) * _unhidden(normal, light) * share / np.pi
        total = total + lit[:, None] * rough_over_lambert(normal, light, view, albedo, roughness)
    return albedo * total


def with_light_of_texels(
    material: FittedMaterial, grid: TexelGrid, model: Model, blend: float
) -> FittedMaterial:
    """The material, each of whose texels reflects as much more or less as the model has it there.

    Yarns shade each other, and a texel deep between them sees less of any light than one on top. A factor of
    each texel's base colour, by channel, is fitted over lights as from a white sky, seen from above, as other
    lines of sight end at other texels. Gloss is shaded alike.
    """
    row, column = np.nonzero(material.cover > MIN_COVER)
    lights = sky_lights(int(np.clip(_MAX_QUERIES // max(len(row), 1), _MIN_LIGHTS, _MAX_LIGHTS)))
    base, specular = material.base.copy(), material.specular.copy()
    for first in range(0, len(row), _MAX_BAND):
        of_band = row[first : first + _MAX_BAND], column[first : first + _MAX_BAND]
        factor = _light_of_band(material, grid, model, blend, *of_band, lights)
        base[of_band] *= factor
        specular[of_band] *= np.minimum(factor.mean(-1, keepdims=True), 1)
    return replace(material, base=np.minimum(base, 1), specular=specular)


def _light_of_band(
    material: FittedMaterial,
    grid: TexelGrid,
    model: Model,
    blend: float,
    row: NDArray[np.int64],
    column: NDArray[np.int64],
    lights: Numbers,
) -> Numbers:
    """The factors of texels [n, 3]."""
    middles = grid.places(np.asarray(row + 0.5, float), np.asarray(column + 0.5, float)).T
    place, cover = _at(material, row, column), material.cover[row, column, None]
    view = np.broadcast_to([0.0, 0.0, 1.0], (len(row), 3))
    product, square = np.zeros((len(row), 3)), np.zeros((len(row), 3))
    for each in lights:
        light = np.broadcast_to(each, view.shape)
        truth = _values(model, material, middles, view, light)
        diffuse = cover * diffuse_of(place, light, view, blend, 0.0)
        glossy = cover * evaluate_gltf(replace(place, base=0 * place.base), light, view)
        weight = _weight(diffuse + glossy, truth)
        product += weight * (truth - glossy) * diffuse
        square += weight * diffuse**2
    # Texels that hardly reflect keep what they have.
    prior = _PRIOR * square.mean(0)
    return np.clip((product + prior) / (square + prior), _MIN_FACTOR / 2, _MAX_FACTOR)


def sky_lights(count: int) -> Numbers:
    """Unit vectors [count, 3] spread evenly over a hemisphere, in proportion to their cosine."""
    number = np.arange(count)
    square = (number + 0.5) / count
    azimuth = number * np.pi * (3 - np.sqrt(5))
    radius = np.sqrt(square)
    return np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), np.sqrt(1 - square)], axis=-1)


def _weighed(
    diffuse: Numbers,
    glossy: Numbers,
    truth: Numbers,
    weight: Numbers,
    facing: NDArray[np.bool_],
    roughness: float,
) -> CyclesLayers:
    """The best factors of both layers, by which queries that are `facing` are as bright as the truth."""
    layers = np.stack([diffuse.ravel(), glossy.ravel()], axis=-1)
    weights = np.broadcast_to(weight, truth.shape).ravel()
    normal = layers.T @ (weights[:, None] * layers)
    # A layer that is hardly there keeps its factor.
    prior = 1e-3 * np.trace(normal) * np.eye(2)
    factors = np.linalg.solve(normal + prior, layers.T @ (weights * truth.ravel()) + prior @ np.ones(2))
    factors = np.clip(factors, _MIN_FACTOR, _MAX_FACTOR)
    factors *= _shown_alike((layers @ factors).reshape(truth.shape)[facing], truth[facing])
    difference = layers @ factors - truth.ravel()
    error = np.sqrt(np.sum(weights * difference**2) / np.sum(weights * truth.ravel() ** 2))
    return CyclesLayers(float(factors[0]), float(factors[1]), roughness, float(error))


def _weight(expected: Numbers, truth: Numbers) -> Numbers:
    """Weights [n, 1] of squared differences: a display shows those of square roots, roughly.

    They are of what the material makes of a query. Of the truth, they would weigh shadows most, which the
    material has not.
    """
    return np.asarray(1 / (expected.mean(-1, keepdims=True) + 0.05 * float(truth.mean())))


def _shown_alike(found: Numbers, truth: Numbers) -> float:
    """The factor of values that makes their mean that of the truth, where displays clip both at white.

    Highlights beyond would make cloth too bright wherever they are not.
    """
    low, high = _MIN_FACTOR, _MAX_FACTOR
    wanted = np.minimum(truth, _WHITE).mean()
    for _ in range(24):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if np.minimum(middle * found, _WHITE).mean() < wanted else (low, middle)
    return 0.5 * (low + high)


def _directions(rng: np.random.Generator, cosine: Numbers) -> Numbers:
    azimuth = rng.uniform(0, 2 * np.pi, len(cosine))
    sine = np.sqrt(1 - cosine**2)
    return np.stack([sine * np.cos(azimuth), sine * np.sin(azimuth), cosine], axis=-1)


def _at(material: FittedMaterial, row: NDArray[np.int64], column: NDArray[np.int64]) -> StandardMaterial:
    """Some texels of the material, without its sheen."""
    chosen = {name: getattr(material, name)[row, column] for name in TEXEL_FIELDS}
    return StandardMaterial(**chosen, weight=material.weight, sheen=np.zeros(3), sheen_roughness=1.0)


def _values(model: Model, material: FittedMaterial, place: Numbers, view: Numbers, light: Numbers) -> Numbers:
    """Values of a model over texels [n, 3] whose middles are at `place` [n, 2], millimetres."""
    rows, columns = material.cover.shape
    zero = dr.zeros(Float, len(place))
    across, up = (zero + side / count for side, count in zip(material.size, (columns, rows), strict=True))
    centre = upload_vector(Vector2, place.T)
    to_view, to_light = (upload_vector(Array3f, vectors.T) for vectors in (view, light))
    value = model.at(to_view, Footprint(centre, Vector2(across, zero), Vector2(zero, up))).value(to_light)
    return np.stack([np.asarray(part.numpy(), np.float64) for part in value], axis=-1)


def _unhidden(normal: Numbers, light: Numbers) -> Numbers:
    """What Cycles leaves of diffuse light where a map turns the normal: 1, less where the surface hides it.

    Conty Estevez, Lecocq and Stein 2019, in the smooth form that Cycles has: x + x² − x³ for x in 0 to 1, the
    cosine of the light at the surface divided by that at the map's normal and by that between the normals.
    """
    ratio = light[:, 2] / np.maximum((normal * light).sum(-1) * normal[:, 2], 1e-6)
    ratio = np.clip(ratio, 0, 1)
    return np.asarray(ratio + ratio**2 - ratio**3)


# ------------------------------------------------------------------------------ rough diffuse reflection
# Energy-preserving Oren and Nayar (Portsmouth, Kutz and Hill 2025), which Blender has since version 4.4.


def rough_over_lambert(
    normal: Numbers, light: Numbers, view: Numbers, albedo: Numbers, roughness: float
) -> Numbers:
    """Rough diffuse reflection divided by that of a smooth surface [n, 3]."""
    if roughness == 0:
        return np.ones_like(albedo)
    n_l, n_v = (np.clip((normal * vectors).sum(-1), 1e-4, 1) for vectors in (light, view))
    share = 1 / (1 + (0.5 - 2 / (3 * np.pi)) * roughness)
    s = (light * view).sum(-1) - n_l * n_v
    single = share * (1 + roughness * np.where(s > 0, s / np.maximum(n_l, n_v), s))
    of_light, of_view = (_single_albedo(cosine, roughness, share) for cosine in (n_l, n_v))
    mean = share * (1 + (2 / 3 - 28 / (15 * np.pi)) * roughness)
    again = albedo * mean / (1 - albedo * (1 - mean))
    multiple = again * ((1 - of_light) * (1 - of_view) / max(1 - mean, 1e-9))[:, None]
    return np.asarray(single[:, None] + multiple)


def _single_albedo(cosine: Numbers, roughness: float, share: float) -> Numbers:
    """Directional albedo of what is scattered once, of a white surface."""
    sine = np.sqrt(1 - cosine**2)
    angle = np.arccos(cosine)
    scattered = sine * (angle - sine * cosine) + 2 / 3 * ((sine / cosine) * (1 - sine**3) - sine)
    return np.asarray(share * (1 + roughness / np.pi * scattered))
