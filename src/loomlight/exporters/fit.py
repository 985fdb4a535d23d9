"""A standard material fitted to a model: textures of whole repeats and the numbers that all texels share.

Geometry comes from the texels themselves (`texels.py`). What is fitted by least squares, over places, lights,
views and distances, is how strongly each family reflects and transmits, how rough its fibres are along and
across, and the sheen. From farther away, where a pixel shows several texels, the material has the means of
its textures, as mipmaps have them.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import drjit as dr
import numpy as np
from drjit.llvm import Array2f as Vector2
from drjit.llvm import Array3f, Float
from numpy.typing import NDArray

from loomlight.core.backend import upload, upload_vector
from loomlight.core.footprint import Footprint
from loomlight.exporters.standards import STANDARDS, Numbers, StandardMaterial
from loomlight.exporters.texels import MIN_COVER, TexelGrid, Texels, TextureSize, frames, nearest_covered
from loomlight.fabric.fabric import Fabric
from loomlight.models.interface import Model

_REFLECTED, _TRANSMITTED = 6000, 1500
# Sides of footprints in texels: from the distance that textures are made for, and farther away. Of larger
# ones so many texels a side are averaged.
SIDES = (1, 4, 16)
_TAPS = 2
# Shares of queries by side, the first of all that are fitted.
_FIRST_SHARE = 0.6
# Directions flatter than this are left out: a few degrees about the horizon.
_MIN = 0.12
_MIN_ALPHA = 0.02


@dataclass(frozen=True, eq=False)
class FittedMaterial(StandardMaterial):
    """Textures [rows, columns, ...], linear, row 0 at the lower edge; and numbers for all texels.

    Attributes:
        size: of what the textures hold, millimetres.
        cover: opacity.
        height: of the yarns towards the eye, millimetres; 0 in holes.
        direction: unit vectors [..., 2] of `axis_x`, along which highlights are wide, in the texel's tangent
            plane.
        error: root mean square of the difference of values, relative to the root mean square of the model's.
        brightness: mean of the material's values divided by the mean of the model's.
    """

    size: tuple[float, float]
    cover: Numbers
    height: Numbers
    direction: Numbers
    error: float
    brightness: float


@dataclass(frozen=True, eq=False)
class _Queries:
    """Queries, each of a square of texels [n]; directions are in the frame of the face.

    Attributes:
        row, column: of its lowest texel at the left; side: in texels.
        light, view: unit vectors [n, 3].
    """

    row: NDArray[np.int64]
    column: NDArray[np.int64]
    side: NDArray[np.int64]
    light: Numbers
    view: Numbers

    def where(self, chosen: NDArray[np.bool_]) -> _Queries:
        """Some of the queries."""
        return _Queries(*(values[chosen] for values in vars(self).values()))

    def taps(self) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]:
        """Number of the query, row and column of each texel that is averaged; those of a query together."""
        count = np.where(self.side > 1, _TAPS**2, 1)
        owner = np.repeat(np.arange(len(count)), count)
        tap = np.arange(len(owner)) - np.repeat(np.cumsum(count) - count, count)
        # In the middles of the quarters of a square.
        step = np.maximum(self.side[owner] // _TAPS, 1)
        return (
            owner,
            self.row[owner] + tap // _TAPS * step + step // 2,
            self.column[owner] + tap % _TAPS * step + step // 2,
        )


# Fields of a `StandardMaterial` with an element a texel, and those of a `FittedMaterial`.
TEXEL_FIELDS = (
    "base",
    "transmission",
    "transmit",
    "specular",
    "alpha_x",
    "alpha_y",
    "normal",
    "axis_x",
    "axis_y",
)
_MAPS = (*TEXEL_FIELDS, "direction", "cover", "height")


def fit_material(fabric: Fabric, model: Model, size: TextureSize) -> FittedMaterial:
    """The material of glTF nearest to a model, in textures of a size."""
    return fit_texels(fabric, model, TexelGrid(fabric, *size), "gltf")


def fit_texels(
    fabric: Fabric, model: Model, grid: TexelGrid, standard: str, sides: Sequence[int] = SIDES
) -> FittedMaterial:
    """The material nearest to what a model shows of a face of the cloth, in texels.

    Args:
        standard: a name of `STANDARDS`, by whose formulas the material is judged.
        sides: of the footprints from which it is judged, texels.
    """
    # Ask the model.
    queries = _queries(grid.columns, grid.rows, sides)
    owner, row, column = queries.taps()
    # Coarse grids have fewer texels than there are queries, and the more points each.
    asked, of_tap = np.unique(row % grid.rows * grid.columns + column % grid.columns, return_inverse=True)
    texels = grid.at(*np.divmod(asked, grid.columns)).where(of_tap)
    first = np.flatnonzero(np.diff(owner, prepend=-1))
    is_covered = np.add.reduceat(texels.cover, first) > MIN_COVER
    queries, texels = queries.where(is_covered), texels.where(is_covered[owner])
    first = np.flatnonzero(np.diff(owner[is_covered[owner]], prepend=-1))
    truth = _answers(model, grid, queries)
    # Fit.
    kind, has_sheen = STANDARDS[standard], fabric.appearance().sheen.strength > 0
    count = np.diff(first, append=len(texels.cover))
    cover = np.add.reduceat(texels.cover, first) / count
    # A display shows differences of square roots, roughly; the offset keeps noise in the dark from counting.
    offset = 0.05 * float(truth.mean())

    def material_of(texels: Texels, numbers: Numbers) -> StandardMaterial:
        return kind.restricted(_material(texels, numbers, has_sheen))

    def values(numbers: Numbers) -> Numbers:
        material = _means(material_of(texels, numbers), first, count)
        return kind.evaluate(material, queries.light, queries.view) * cover[:, None]

    def residuals(numbers: Numbers) -> Numbers:
        return (np.sqrt(values(numbers) + offset) - np.sqrt(truth + offset)).ravel()

    # There are several minima: fibres as rough as the model's, and smoother ones.
    shared = [0, 0, -3, 0, 0, -1]
    starts = [np.array([0, 0, -1, -1, 0, 0, rough, rough, *shared], float) for rough in (0, -1.5)]
    fits = [_least_squares(residuals, start, has_sheen) for start in starts]
    numbers = min(fits, key=lambda numbers: float(np.square(residuals(numbers)).sum()))
    numbers = _with_mean_kept(values, numbers, truth, queries.light[:, 2] > 0)
    found = values(numbers)
    error = np.sqrt(np.mean((found - truth) ** 2) / np.mean(truth**2))
    return FittedMaterial(
        **_maps(grid, lambda texels: material_of(texels, numbers)),
        size=grid.size,
        error=float(error),
        brightness=float(found.mean() / truth.mean()),
    )


def _means(
    material: StandardMaterial, first: NDArray[np.int64], count: NDArray[np.int64]
) -> StandardMaterial:
    """What filters between texels make of runs of them, which begin at `first` and have `count` texels.

    Roughness is filtered, not α; of directions that have no sign the doubled angles are.
    """
    if count.max() == 1:
        return material

    def mean(values: Numbers) -> Numbers:
        total = np.add.reduceat(values, first, axis=0)
        return total / count.reshape(-1, *(1 for _ in values.shape[1:]))

    normal = mean(material.normal)
    normal /= np.maximum(np.linalg.norm(normal, axis=-1, keepdims=True), 1e-6)
    across, along = ((material.axis_x * axis).sum(-1) for axis in frames(material.normal))
    angle = 0.5 * np.arctan2(mean(2 * across * along), mean(across**2 - along**2))
    x, y = frames(normal)
    axis_x = np.cos(angle)[:, None] * x + np.sin(angle)[:, None] * y
    return replace(
        material,
        base=mean(material.base),
        transmission=mean(material.transmission),
        transmit=mean(material.transmit),
        specular=mean(material.specular),
        alpha_x=mean(np.sqrt(material.alpha_x)) ** 2,
        alpha_y=mean(np.sqrt(material.alpha_y)) ** 2,
        normal=normal,
        axis_x=axis_x,
        axis_y=np.cross(normal, axis_x),
    )


def _maps(grid: TexelGrid, material_of: Callable[[Texels], StandardMaterial]) -> dict[str, Any]:
    """The fields of a `FittedMaterial` whose parameters are a function of texels."""
    parts: list[dict[str, Any]] = []
    for texels in grid.bands():
        material = material_of(texels)
        found = vars(material) | {
            "direction": _in_plane(material),
            "cover": texels.cover,
            "height": texels.height,
        }
        parts.append(
            {name: value.astype(np.float32) if name in _MAPS else value for name, value in found.items()}
        )
    shape = grid.rows, grid.columns
    maps = {name: np.concatenate([part.pop(name) for part in parts]) for name in _MAPS}
    nearest = nearest_covered(maps["cover"].reshape(shape))
    filled = {name: values[nearest] for name, values in maps.items() if name not in ("cover", "height")}
    return parts[0] | filled | {name: maps[name].reshape(shape) for name in ("cover", "height")}


def _in_plane(material: StandardMaterial) -> Numbers:
    """`axis_x` in the texel's tangent plane; of the two opposite vectors, that with the larger part above 0.

    Filters between texels would cancel opposite vectors.
    """
    x, y = frames(material.normal)
    direction = np.stack([(material.axis_x * axis).sum(-1) for axis in (x, y)], axis=-1)
    larger = np.take_along_axis(direction, np.abs(direction).argmax(-1)[..., None], axis=-1)
    return direction * np.where(larger < 0, -1.0, 1.0)


def _queries(columns: int, rows: int, sides: Sequence[int]) -> _Queries:
    rng = np.random.default_rng(7)
    count = _REFLECTED + _TRANSMITTED
    farther = len(sides) - 1
    shares = [_FIRST_SHARE, *[(1 - _FIRST_SHARE) / farther] * farther] if farther else [1.0]

    def hemisphere() -> Numbers:
        cosine = np.sqrt(rng.uniform(_MIN**2, 1, count))
        azimuth = rng.uniform(0, 2 * np.pi, count)
        sine = np.sqrt(1 - cosine**2)
        return np.stack([sine * np.cos(azimuth), sine * np.sin(azimuth), cosine], axis=-1)

    light, view = hemisphere(), hemisphere()
    # A third of the pairs lie about the mirror direction, where highlights are.
    near = rng.uniform(size=count) < 1 / 3
    mirrored = view * [-1, -1, 1] + 0.25 * rng.normal(size=(count, 3))
    mirrored /= np.linalg.norm(mirrored, axis=-1, keepdims=True)
    light = np.where((near & (mirrored[:, 2] > _MIN))[:, None], mirrored, light)
    light[_REFLECTED:, 2] *= -1
    row, column = rng.integers(0, rows, count), rng.integers(0, columns, count)
    return _Queries(row, column, rng.choice(sides, count, p=shares), light, view)


def _answers(model: Model, grid: TexelGrid, queries: _Queries) -> Numbers:
    """Values of the model over the squares of queries [n, 3]."""
    step_x, step_y = grid.step
    side = queries.side.astype(np.float64)
    place = grid.places(queries.row + side / 2, queries.column + side / 2)
    centre = upload_vector(Vector2, place)
    width, height = upload(Float, side * step_x), upload(Float, side * step_y)
    zero = dr.zeros(Float, len(side))
    footprint = Footprint(centre, Vector2(width, zero), Vector2(zero, height))
    to_front = [1, 1, -1] if grid.back else [1, 1, 1]
    view, light = (
        upload_vector(Array3f, (vectors * to_front).T) for vectors in (queries.view, queries.light)
    )
    value = model.at(view, footprint).value(light)
    return np.stack([np.asarray(part.numpy(), np.float64) for part in value], axis=-1)


def _material(texels: Texels, numbers: Numbers, has_sheen: bool) -> StandardMaterial:
    """The material of texels for the numbers that are fitted.

    They are logarithms of factors of the families' diffuse albedos [2], specular albedos [2], transmission
    [2], of α along the fibres [2] and across them as a multiple [2]; of the strength of sheen; and the
    logits of its roughness and of specularFactor; and the logarithm of the share of the slopes' covariance
    that widens highlights, at most 1.
    """
    diffuse, specular, transmit, along = (np.exp(numbers[k : k + 2]) for k in (0, 2, 4, 6))
    share = texels.share

    def mixed(colours: Numbers, factors: Numbers) -> Numbers:
        return (colours * (share * factors)[..., None]).sum(-2)

    reflected = np.minimum(mixed(texels.diffuse, diffuse), 1)
    passed = np.minimum(mixed(texels.transmit, transmit), 1)
    most = reflected.max(-1) + passed.max(-1)
    transmission = passed.max(-1) / np.maximum(most, 1e-6)
    axis_x, axis_y, alpha_x, alpha_y = _roughness(
        texels, along, 1 + np.exp(numbers[8:10]), float(np.exp(min(numbers[13], 0.0)))
    )
    # Fly-away fibres reflect white light; of three numbers, the fit made the edges of wool red.
    sheen = np.full(3, np.exp(min(numbers[10], 0.0)) if has_sheen else 0.0)
    return StandardMaterial(
        base=np.minimum(reflected / np.maximum(1 - transmission, 1e-3)[..., None], 1),
        transmission=transmission,
        transmit=np.minimum(passed / np.maximum(transmission, 1e-6)[..., None], 1),
        specular=np.minimum(mixed(texels.specular, specular), 1),
        weight=float(1 / (1 + np.exp(-numbers[12]))),
        alpha_x=alpha_x,
        alpha_y=alpha_y,
        normal=texels.normal,
        axis_x=axis_x,
        axis_y=axis_y,
        sheen=sheen,
        sheen_roughness=float(1 / (1 + np.exp(-numbers[11]))),
    )


def _roughness(
    texels: Texels, along: Numbers, across: Numbers, widening: float
) -> tuple[Numbers, Numbers, Numbers, Numbers]:
    """Axes of GGX and α along them: the families' fibres, widened by the slopes within the texel.

    A highlight of fibres is narrow along them and wide across. α² is twice a variance of slopes.
    """
    total = texels.covariance * widening
    for family in range(2):
        fibre = texels.direction[..., family, :]
        side = np.stack([-fibre[..., 1], fibre[..., 0]], axis=-1)
        alpha = np.minimum(texels.alpha[family] * along[family], 1)
        wide = np.minimum(alpha * across[family], 1)
        for vector, width in ((fibre, alpha), (side, wide)):
            weight = texels.share[..., family, None, None] * (0.5 * width**2)
            total += weight * vector[..., :, None] * vector[..., None, :]
    # The axes of the ellipse, written out for speed.
    mean, half = (total[..., 0, 0] + total[..., 1, 1]) / 2, (total[..., 0, 0] - total[..., 1, 1]) / 2
    off = total[..., 0, 1]
    radius, angle = np.hypot(half, off), 0.5 * np.arctan2(off, half)
    alpha_x, alpha_y = (
        np.clip(np.sqrt(2 * np.maximum(variance, 0)), _MIN_ALPHA, 1)
        for variance in (mean + radius, mean - radius)
    )
    x, y = frames(texels.normal)
    axis_x = np.cos(angle)[..., None] * x + np.sin(angle)[..., None] * y
    return axis_x, np.cross(texels.normal, axis_x), alpha_x, alpha_y


def _with_mean_kept(
    values: Callable[[Numbers], Numbers], numbers: Numbers, truth: Numbers, is_reflection: NDArray[np.bool_]
) -> Numbers:
    """Factors scaled so that reflection and transmission keep their means; roots favour the dark."""
    scaled = numbers.copy()
    for _ in range(4):
        found = values(scaled)
        for side, factors in ((is_reflection, [0, 1, 12]), (~is_reflection, [4, 5])):
            ratio = truth[side].mean() / max(float(found[side].mean()), 1e-9)
            scaled[factors] = np.clip(scaled[factors] + np.log(np.clip(ratio, 0.25, 4)), -7, 7)
    return scaled


def _least_squares(
    residuals: Callable[[Numbers], Numbers], start: Numbers, has_sheen: bool, rounds: int = 25
) -> Numbers:
    """Levenberg and Marquardt's method with differences for derivatives."""
    free = [k for k in range(len(start)) if has_sheen or k not in (10, 11)]
    numbers, damping = start.copy(), 1e-2
    current = residuals(numbers)
    for _ in range(rounds):
        jacobian = np.empty((current.size, len(free)))
        for column, k in enumerate(free):
            moved = numbers.copy()
            moved[k] += 1e-4
            jacobian[:, column] = (residuals(moved) - current) / 1e-4
        normal, gradient = jacobian.T @ jacobian, jacobian.T @ current
        scale = np.diag(normal) + 1e-9 * np.trace(normal) + 1e-12
        for _ in range(8):
            step = np.linalg.solve(normal + damping * np.diag(scale), gradient)
            tried = numbers.copy()
            tried[free] = np.clip(numbers[free] - step, -7, 7)
            found = residuals(tried)
            if found @ found < current @ current:
                break
            damping *= 4
        else:
            return numbers
        gain = 1 - (found @ found) / (current @ current)
        numbers, current, damping = tried, found, damping / 4
        if gain < 1e-4:
            break
    return numbers
