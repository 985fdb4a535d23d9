"""Queries of a source for training: a place, a footprint, a light and a view, and what the source answers.

M(u, σ, light, view) is the mean of f·cos over a Gaussian of standard deviation σ (kuznetsov2021 eq. 1, times
the cosine of the light as everywhere in this package). A source answers for points of it, as a `Btf`. A
`QueryStream` draws queries in parts, each of which depends on the seed and its number alone, and takes means
of points over their footprints. `stored_queries` keeps the parts on disk, so that a training that was stopped
goes on with the same ones.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields
from pathlib import Path
from typing import ClassVar, final

import numpy as np
from numpy.typing import NDArray
from safetensors import SafetensorError
from safetensors.numpy import load_file, save_file

from loomlight.core.files import replacing
from loomlight.models.texture.pyramid import SIZE_OF_SIGMA, PyramidShape

_Floats = NDArray[np.float32]
# Queries of a part; a part is drawn, stored and counted as a whole.
PART = 1 << 16
# More grazing directions see crests alone.
MIN_COSINE = 0.02
# Bounds of the roughnesses of the Trowbridge–Reitz distributions that half vectors of lights are drawn by,
# uniform in the logarithm; and the lower one for networks that resolve as much.
ALPHAS, RESOLVED_ALPHA = (0.02, 0.7), 0.003
# Estimates of a footprint that is larger than a texel, of cheap points. With fewer most of a rough mirror's
# footprints show no highlight at all, and losses that learn medians learn that there is none.
_MAX_SAMPLES = 64
# Keys that separate the random numbers of queries from those of batches, and those of cones from estimates'.
_STREAM, _CONES = 3, 8
# Points of queries that are answered at once: they take 200 MB.
_POINTS = 1 << 22
# Turns of an offset in a footprint at which an estimate takes points: itself alone, or two opposite pairs at
# right angles to one another, which leave no linear error.
ONE_POINT = ((1, 0),)
FOUR_POINTS = ((1, 0), (-1, 0), (0, 1), (0, -1))

# Called with (done, in all) of a whole training, in thousandths.
Progress = Callable[[int, int], None]


# -------------------------------------------------------------------------------------- what a source answers


class Btf(ABC):
    """The finest BTF B of a source; its means over Gaussians are the truth of a training.

    Which class answers for which kind of source is listed in `models/registry.py:BTFS`.

    Attributes:
        faces: 2 where front and back differ, else 1.
        transmits: whether light from the other side is seen.
        has_holes: whether rays pass straight through.
        measured: lights [n, 3] and views [m, 3], unit vectors, of a source that has no others; else None.
    """

    faces: int = 1
    transmits: bool = False
    has_holes: bool = False
    measured: tuple[_Floats, _Floats] | None = None

    @property
    @abstractmethod
    def extent(self) -> tuple[float, float]:
        """Width and height of a repeat in the unit of points: millimetres, or 1 for points in repeats."""

    @abstractmethod
    def values(self, points: _Floats, lights: _Floats, views: _Floats, seed: tuple[int, ...]) -> _Floats:
        """f·cos of single rays, linear RGB [n, 3], 1/sr; or unbiased estimates of it.

        Args:
            points: on the reference plane [n, 2].
            lights, views: unit vectors [n, 3]; z < 0 is the back. On the same side, unless light is
                transmitted.
            seed: of the random numbers of estimates.
        """

    def holes(self, points: _Floats, views: _Floats) -> _Floats:
        """Share of light that passes straight through towards views [n], 0 to 1; asked if `has_holes`."""
        del views
        return np.zeros(len(points), np.float32)


class Texels(ABC):
    """The texels of a source: inputs of an encoder, and the slopes about which highlights lie.

    Attributes:
        inputs: names of the K inputs of the encoder: texture parameters, normals, LEAN moments. Of measured
            materials they are one per material (one-hot).
        resolution: texels of the finest level: width and height, powers of two.
        is_apart: whether each texel is a material of its own, and values are exact; see `PyramidShape`.
        sigma: standard deviation of footprints of level 0 along both axes [2], in the unit of the BTF's
            points.
        turns: of an offset at which an estimate takes points: `ONE_POINT`, or `FOUR_POINTS` of cheap ones.
    """

    inputs: tuple[str, ...]
    resolution: tuple[int, int]
    is_apart: bool = False
    sigma: _Floats
    turns: tuple[tuple[int, int], ...] = ONE_POINT

    @property
    @abstractmethod
    def slopes(self) -> _Floats:
        """Slopes of normals (-slopes, 1) of the finest level's texels [faces, maps, height, width, 2].

        maps: flat surfaces and normal maps of a material.
        """

    @abstractmethod
    def encoder_inputs(self, level: int, face: int = 0) -> _Floats:
        """The inputs [height, width, K] of the texels of a level, filtered, roughly in [-1, 1].

        Row 0 is at v = 0. Level l is `resolution` halved l times, at least 1 texel a side.
        """


class EncodedBtf(Btf):
    """A BTF of which texels are known, as the encoder of `latent` needs them."""

    @abstractmethod
    def texels(self, resolution: int) -> Texels:
        """The texels of the source.

        Args:
            resolution: along the longer side of the repeat, a power of two; sources whose textures have a
                resolution of their own may have fewer.
        """


def footprint_values(
    btf: Btf,
    texels: Texels,
    positions: _Floats,
    levels: _Floats,
    lights: _Floats,
    views: _Floats,
    seed: tuple[int, ...],
) -> _Floats:
    """Unbiased estimates of f·cos [n, 3] over footprints, one each.

    Args:
        positions: centres of footprints [n, 2], in repeats.
        levels: log2 of the footprint's size in texels of the finest level [n], from 0.
        lights, views: as of `Btf.values`.
    """
    offsets = np.random.default_rng(seed).standard_normal(positions.shape, np.float32)
    centres, sigmas = positions * np.array(btf.extent, np.float32), texels.sigma * np.exp2(levels)[:, None]
    return _estimates(btf, centres, sigmas * offsets, lights, views, seed, texels.turns)


def _estimates(
    btf: Btf,
    centres: _Floats,
    offsets: _Floats,
    lights: _Floats,
    views: _Floats,
    seed: tuple[int, ...],
    turns: Sequence[tuple[int, int]],
) -> _Floats:
    """f·cos [n, 3] at centres and offsets [n, 2]: a mean over the turns of the offset."""
    if turns == ONE_POINT:
        return btf.values(centres + offsets, lights, views, seed)
    total = np.zeros((len(centres), 3), np.float32)
    for x, y in turns:
        turned = np.stack([x * offsets[:, 0] - y * offsets[:, 1], y * offsets[:, 0] + x * offsets[:, 1]], 1)
        total += btf.values(centres + turned, lights, views, seed)
    return (total / len(turns)).astype(np.float32)


# ---------------------------------------------------------------------------------------------------- queries


@dataclass(frozen=True, eq=False)
class QueryInputs:
    """Queries before they are answered.

    Attributes:
        positions: in repeats [n, 2], 0 to 1.
        levels: log2 of the footprint's size over `PyramidShape.footprint_mm` [n].
        lights, views: unit vectors [n, 3] in the frame of the face that is seen, z > 0; lights on the other
            side are mirrored.
        faces: 0 for the front, 1 for the back [n].
        is_transmission: 1 for lights on the other side, else 0 [n].
    """

    positions: _Floats
    levels: _Floats
    lights: _Floats
    views: _Floats
    faces: NDArray[np.uint8]
    is_transmission: NDArray[np.uint8]


@dataclass(frozen=True, eq=False)
class Queries(QueryInputs):
    """Queries and their answers.

    Attributes:
        values: f·cos, linear RGB [n, 3], 1/sr.
        holes: share of light that passes straight through towards the view [n], 0 to 1.
    """

    values: _Floats
    holes: _Floats

    def __len__(self) -> int:
        return len(self.levels)

    def __getitem__(self, chosen: NDArray[np.intp] | slice) -> Queries:
        return Queries(*(getattr(self, part.name)[chosen] for part in fields(self)))


@dataclass(frozen=True, eq=False)
class Points:
    """Points of which values of queries are means.

    Attributes:
        counts: points of each query [n].
        offsets: of all points from the centres of footprints [m, 2], in the unit of the BTF's points; those
            of a query follow one another, and further ones may follow them all.
        cones: half-angles of the cones that lights of the points of each query are spread over, radians [n];
            None where all points have the query's own light.
    """

    counts: NDArray[np.intp]
    offsets: _Floats
    cones: _Floats | None = None


class QueryStream(ABC):
    """Queries of a source in parts, each of which depends on the seed and its number alone.

    Attributes:
        turns: see `Texels`.
        asks_holes: whether a model learns what passes straight through.
    """

    turns: tuple[tuple[int, int], ...] = ONE_POINT
    asks_holes: bool = True

    def __init__(self, btf: Btf, seed: int) -> None:
        self._btf, self._seed = btf, seed

    @abstractmethod
    def _drawn(self, key: tuple[int, ...], count: int) -> tuple[QueryInputs, Points]:
        """Queries by the random numbers of a key."""

    @final
    def part(self, number: int, count: int = PART) -> Queries:
        """The queries of one part."""
        key, btf = (self._seed, _STREAM, number), self._btf
        inputs, points = self._drawn(key, count)
        # Directions as the source knows them: of its front.
        is_back = inputs.faces == 1
        is_below = is_back ^ (inputs.is_transmission == 1)
        # Means over the points of each query.
        query = _queries_of_points(points.counts)
        extent = np.array(btf.extent, np.float32)
        asks_holes = self.asks_holes and btf.has_holes
        found = np.empty((len(query), 3), np.float32)
        passing = np.zeros(len(query) if asks_holes else 0, np.float32)
        for number, first in enumerate(range(0, len(query), _POINTS)):
            part = slice(first, first + _POINTS)
            chosen, offsets = query[part], points.offsets[part]
            seed = key if number == 0 else (*key, number)
            centres = np.take(inputs.positions * extent, chosen, axis=0)
            lights = np.take(inputs.lights, chosen, axis=0)
            if points.cones is not None:
                rng = np.random.default_rng((*seed, _CONES))
                lights = spread_over_cones(rng, lights, np.take(points.cones, chosen))
            lights = _mirrored(lights, np.take(is_below, chosen))
            views = _mirrored(np.take(inputs.views, chosen, axis=0), np.take(is_back, chosen))
            found[part] = _estimates(btf, centres, offsets, lights, views, seed, self.turns)
            if asks_holes:
                passing[part] = btf.holes(centres + offsets, views)
        holes = _means(passing, points.counts) if asks_holes else np.zeros(count, np.float32)
        return Queries(**vars(inputs), values=_means(found, points.counts), holes=holes)


def _mirrored(directions: _Floats, chosen: NDArray[np.bool_]) -> _Floats:
    """Directions [n, 3] with those that are chosen on the other side."""
    mirror = np.array([1, 1, -1], np.float32)
    return np.where(chosen[:, None], mirror * directions, directions)


def _queries_of_points(counts: NDArray[np.intp]) -> NDArray[np.intp]:
    """The query of each point, as many as `counts` says of each.

    There are further points of query 0 up to a number that few parts differ in: Dr.Jit compiles anew for
    another one.
    """
    query = np.repeat(np.arange(len(counts)), counts)
    return np.pad(query, (0, -len(query) % max(1, len(counts) // 4)))


def _means(found: _Floats, counts: NDArray[np.intp]) -> _Floats:
    """Means [n, …] of the points of each query."""
    first = int(counts[0])
    if (counts == first).all():  # a plain mean
        whole = found[: first * len(counts)].reshape(len(counts), first, *found.shape[1:])
        return np.asarray(whole.mean(axis=1, dtype=np.float32), np.float32)
    ends = np.cumsum(counts)
    sums = np.add.reduceat(found[: ends[-1]], ends - counts)
    return np.asarray(sums / counts.astype(np.float32).reshape(-1, *[1] * (found.ndim - 1)), np.float32)


class NeumipStream(QueryStream):
    """Queries of `neumip`: any level, lights on both sides, and more points for larger footprints.

    Positions are uniform over the repeat; directions are half uniform in solid angle, half uniform on the
    projected disk; sizes favour fine levels, which have more texels.
    """

    def __init__(self, btf: Btf, shape: PyramidShape, samples: tuple[int, int], seed: int) -> None:
        """
        Args:
            samples: points of a query of a texel, and at most; between them as many as its side is long.
        """
        super().__init__(btf, seed)
        self._shape, self._samples = shape, samples

    def _drawn(self, key: tuple[int, ...], count: int) -> tuple[QueryInputs, Points]:
        rng = np.random.default_rng(key)
        positions = rng.random((count, 2), np.float32)
        finer = math.log2(self._shape.footprint_texels)
        levels = draw_levels(rng, count, self._shape.levels - 1 + finer)
        lights, views = draw_directions(rng, count), draw_directions(rng, count)
        if self._btf.measured is not None:
            lights, views = (known[rng.integers(len(known), size=count)] for known in self._btf.measured)
        faces = rng.integers(self._btf.faces, size=count, dtype=np.uint8)
        texels = np.exp2(levels)
        counts = np.minimum(np.ceil(self._samples[0] * texels).astype(np.intp), self._samples[1])
        query = _queries_of_points(counts)
        sigmas = np.asarray(self._shape.texel_mm / SIZE_OF_SIGMA * texels, np.float32)
        offsets = np.take(sigmas, query)[:, None] * rng.standard_normal((len(query), 2), np.float32)
        is_transmission = np.zeros(count, np.uint8)
        if self._btf.transmits:
            is_transmission = (rng.random(count) < TRANSMISSION_SHARE).astype(np.uint8)
        levels -= np.float32(finer)
        inputs = QueryInputs(positions, levels, lights, views, faces, is_transmission)
        return inputs, Points(counts, offsets)


class LatentStream(QueryStream):
    """Queries of `latent`: whole levels, lights on the view's side, half of them where highlights lie.

    Positions are uniform over the repeat; fine levels are more frequent, as they have more texels. Views are
    half uniform in solid angle, half uniform on the projected disk. Half of the lights are drawn alike; the
    others by half vectors close to a normal of the footprint.
    """

    asks_holes = False

    def __init__(
        self,
        btf: Btf,
        texels: Texels,
        levels: int,
        samples: int,
        seed: int,
        mollified: int = 0,
        finest_alpha: float = ALPHAS[0],
    ) -> None:
        """
        Args:
            levels: of the pyramid.
            samples: estimates of which a value is the mean: of a footprint of a texel, and of larger ones as
                many more as their area, up to 64, where points are cheap.
            mollified: queries whose lights are cones, the first ones; see `cone_angles`.
            finest_alpha: least roughness of the half vectors by which lights are drawn.
        """
        super().__init__(btf, seed)
        self._texels, self._levels, self._mollified = texels, levels, mollified
        self.turns, self._finest_alpha = texels.turns, finest_alpha
        # Of exact values one estimate is enough.
        samples = 1 if texels.is_apart else samples
        most = samples if texels.turns == ONE_POINT else max(samples, _MAX_SAMPLES)
        self._samples = np.minimum(samples * 4 ** np.arange(levels), most)

    def _drawn(self, key: tuple[int, ...], count: int) -> tuple[QueryInputs, Points]:
        rng = np.random.default_rng(key)
        positions = rng.random((count, 2), np.float32)
        levels = draw_whole_levels(rng, count, self._levels).astype(np.float32)
        views = draw_directions(rng, count)
        faces = rng.integers(self._btf.faces, size=count, dtype=np.uint8)
        slopes = self._slopes(rng, positions, levels, faces)
        lights = draw_lights(rng, views, slopes, self._finest_alpha)
        cones = cone_angles(key[-1] * PART + np.arange(count), self._mollified)
        counts = self._samples[levels.astype(np.intp)]
        counts = np.where(cones > 0, np.maximum(counts, CONE_LIGHTS), counts)
        query = _queries_of_points(counts)
        # By a generator of their own, as in `footprint_values`.
        spread = np.random.default_rng(key).standard_normal((len(query), 2), np.float32)
        offsets = np.take(self._texels.sigma * np.exp2(levels)[:, None], query, axis=0) * spread
        is_transmission = np.zeros(count, np.uint8)
        inputs = QueryInputs(positions, levels, lights, views, faces, is_transmission)
        return inputs, Points(counts, offsets, cones if cones.any() else None)

    def _slopes(
        self, rng: np.random.Generator, positions: _Floats, levels: _Floats, faces: NDArray[np.uint8]
    ) -> _Floats:
        """Slopes [n, 2] of one normal of each footprint."""
        count, slopes = len(positions), self._texels.slopes
        spread = rng.standard_normal((count, 2), np.float32) * np.exp2(levels)[:, None] / SIZE_OF_SIGMA
        rows, columns = slopes.shape[2:4]
        texel = np.floor(positions * np.array([columns, rows]) + spread).astype(np.intp)
        maps = rng.integers(slopes.shape[1], size=count)
        drawn: _Floats = slopes[faces, maps, texel[:, 1] % rows, texel[:, 0] % columns]
        return drawn


# -------------------------------------------------------------------------------------- levels and directions

# Shares of queries whose level is uniform: of any level, where the others' density halves with each level,
# and of whole levels, where it quarters, as texels do.
_UNIFORM_LEVELS, _UNIFORM_WHOLE_LEVELS = 0.4, 0.5
# Footprints of twice the repeat are means of the whole.
_LEVELS_BEYOND = 1.0
# Share of queries whose light is on the other side, where light passes.
TRANSMISSION_SHARE = 0.4
# Share of lights drawn by half vectors.
_BY_HALF_VECTOR = 0.5


def draw_levels(rng: np.random.Generator, count: int, coarsest: float) -> _Floats:
    """Levels [count] from 0 to one beyond the coarsest, fine ones more often."""
    top = coarsest + _LEVELS_BEYOND
    u = rng.random(count)
    uniform = u * top
    falling = -np.log2(1 - u * (1 - 2.0**-top))
    return np.where(rng.random(count) < _UNIFORM_LEVELS, uniform, falling).astype(np.float32)


def draw_whole_levels(rng: np.random.Generator, count: int, levels: int) -> NDArray[np.uint8]:
    """Whole numbers [count] below `levels`: half uniform, half in proportion to texels."""
    texels = 0.25 ** np.arange(levels)
    shares = _UNIFORM_WHOLE_LEVELS / levels + (1 - _UNIFORM_WHOLE_LEVELS) * texels / texels.sum()
    return rng.choice(levels, count, p=shares).astype(np.uint8)


def draw_directions(rng: np.random.Generator, count: int) -> _Floats:
    """Unit vectors [count, 3] with z > 0, half uniform in solid angle, half on the projected disk."""
    u, azimuth = rng.random(count), 2 * math.pi * rng.random(count)
    cosine = np.where(rng.random(count) < 0.5, u, np.sqrt(u))
    cosine = MIN_COSINE + (1 - MIN_COSINE) * cosine
    sine = np.sqrt(np.maximum(1 - cosine**2, 0))
    return np.stack([sine * np.cos(azimuth), sine * np.sin(azimuth), cosine], axis=1).astype(np.float32)


def light_density(queries: Queries, measured: bool) -> _Floats:
    """Density of lights of `draw_directions` on their side [n], 1/sr.

    Args:
        measured: of a BTF's own lights, which are taken as spread evenly.
    """
    if measured:
        return np.full(len(queries), 1 / (2 * math.pi), np.float32)
    cosines = np.sqrt(np.maximum(1 - np.square(queries.lights[:, :2]).sum(axis=1), 1e-4))
    # Half of them 1/2π, half cosine/π; the lowest cosine changes both by a fiftieth.
    return np.asarray(0.5 * (1 / (2 * np.pi) + cosines / np.pi), np.float32)


def draw_lights(
    rng: np.random.Generator,
    views: _Floats,
    slopes: _Floats | float = 0.0,
    finest_alpha: float = ALPHAS[0],
) -> _Floats:
    """Lights [n, 3] with z > 0, half of them mirrored about normals close to (-slopes, 1) [n, 2].

    Args:
        finest_alpha: least roughness of the distributions of these normals, instead of that of `ALPHAS`.
    """
    count = len(views)
    lights = draw_directions(rng, count)
    low, high = np.log((finest_alpha, ALPHAS[1]))
    alpha = np.exp(rng.uniform(low, high, count))
    u, azimuth = rng.random(count), 2 * math.pi * rng.random(count)
    # Slopes of a Trowbridge–Reitz distribution: tan² = α² u / (1 − u).
    tangent = alpha * np.sqrt(u / (1 - u))
    about = slopes + tangent[:, None] * np.stack([np.cos(azimuth), np.sin(azimuth)], axis=1)
    halves = np.concatenate([-about, np.ones((count, 1))], axis=1)
    halves /= np.linalg.norm(halves, axis=1, keepdims=True)
    mirrored = 2 * (views * halves).sum(axis=1, keepdims=True) * halves - views
    chosen = (rng.random(count) < _BY_HALF_VECTOR) & (mirrored[:, 2] > MIN_COSINE)
    return np.where(chosen[:, None], mirrored, lights).astype(np.float32)


# Half-angle of the first cone that lights are mollified over (zeltner2024, eq. 2 of the supplemental), and
# directions in a cone of which a value is the mean.
FIRST_CONE, CONE_LIGHTS = math.radians(10), 256


def cone_angles(numbers: NDArray[np.intp], mollified: int) -> _Floats:
    """Half-angles of the cones of lights of queries [n], radians: from `FIRST_CONE` to 0 by a half cosine.

    Args:
        numbers: of the queries in the whole training, from 0.
        mollified: queries that have cones.
    """
    done = (numbers + 0.5) / max(1, mollified)
    angles = 0.5 * FIRST_CONE * (1 + np.cos(np.pi * done))
    return np.where(numbers < mollified, angles, 0).astype(np.float32)


def spread_over_cones(rng: np.random.Generator, directions: _Floats, angles: _Floats) -> _Floats:
    """Directions [n, 3] drawn uniformly from cones about others, of which none gets below the surface.

    Args:
        directions: unit vectors with z > 0; one that would get below stays as it is.
        angles: half-angles of the cones, radians [n].
    """
    count = len(directions)
    # 1 − cos θ of the angle from the axis: exact for narrow cones too.
    below = rng.random(count) * 2 * np.square(np.sin(0.5 * angles.astype(np.float64)))
    sine, azimuth = np.sqrt(below * (2 - below)), 2 * math.pi * rng.random(count)
    # A frame about each direction (Duff et al. 2017), whose z is above 0.
    x, y, z = directions.T.astype(np.float64)
    scale = 1 / (1 + z)
    tangent = np.stack([1 - x * x * scale, -x * y * scale, -x])
    bitangent = np.stack([-x * y * scale, 1 - y * y * scale, -y])
    along = sine * np.cos(azimuth) * tangent + sine * np.sin(azimuth) * bitangent
    spread = along.T + (1 - below)[:, None] * directions
    return np.where(spread[:, 2:] > MIN_COSINE, spread, directions).astype(np.float32)


# ---------------------------------------------------------------------------------------------- parts on disk


class QueryFiles:
    """Parts of queries in a folder, a safetensors file each, which is renamed into place."""

    _NAMES: ClassVar[tuple[str, ...]] = tuple(part.name for part in fields(Queries))

    def __init__(self, folder: Path, identity: str) -> None:
        """
        Args:
            identity: of what queries depend on.
        """
        self._folder, self._name = folder, f"queries-{identity[:12]}"

    def _file(self, number: int) -> Path:
        return self._folder / f"{self._name}-{number:05d}.safetensors"

    def read(self, number: int, size: int) -> Queries | None:
        """The part of a number and so many queries; None if it is not there or damaged."""
        try:
            part = Queries(**load_file(self._file(number)))
        except (OSError, SafetensorError, TypeError):
            return None
        return part if len(part) == size else None

    def write(self, number: int, part: Queries) -> None:
        """Keeps a part.

        Raises:
            InputError: it cannot be written.
        """
        with replacing(self._file(number)) as temporary:
            save_file({name: getattr(part, name) for name in self._NAMES}, temporary)


def stored_queries(
    stream: QueryStream, files: QueryFiles, total: int, report: Callable[[int, int], None]
) -> Queries:
    """All queries of a training; parts that there are files of are read.

    Args:
        report: called with (parts done, parts in all).
    """
    sizes = [min(PART, total - first) for first in range(0, total, PART)]
    parts: list[Queries] = []
    for number, size in enumerate(sizes):
        part = files.read(number, size)
        if part is None:
            part = stream.part(number, size)
            files.write(number, part)
        parts.append(part)
        report(number + 1, len(sizes))
    columns = ([getattr(part, field.name) for part in parts] for field in fields(Queries))
    return Queries(*map(np.concatenate, columns))
