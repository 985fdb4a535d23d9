"""zhu2024, figures 3 and 4: compressed summed-area tables of fibre densities, with and without normalisation.

The paper's tables: of a cluster of visibility, here of a family of threads, the summed areas of D over the
texels of the front, by half vector, compressed by clustered principal components (4.4). Normalised, the
summed area of the average D is taken out beforehand, and the rest is mapped to 0 to 1. Beside them stands
what `clustered` keeps: components of D itself, whose whole coefficients are summed exactly.

Errors are of means of D over boxes, which are differences of four entries: the mean squared difference over
the mean square, for boxes of one texel, of eight by eight, and of half the repeat each way. Coefficients are
floats, or whole numbers of 8 bits, whose unit is the component's. Figure 3 has the rank at which the error of
one texel is below 0.03, as the paper's aim is, and the bytes of coefficients (floats), components and labels
for 256² texels and eight clusters of visibility.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from drjit.llvm.ad import Float
from numpy.typing import NDArray
from scipy.cluster.vq import kmeans2

from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from loomlight.models.clustered.parallax import compressed, principal_axes
from loomlight.models.clustered.square_map import BINS, bin_centres
from loomlight.models.clustered.tables import densities, feature_maps, texel_counts
from loomlight.yarn.geometry import YarnGeometry
from studies.harness.study import Found, Pixels, Run, Study, listed, names, with_tables
from studies.instruments.sheet import PictureTable, Tile
from studies.papers.zhu2024.scenes import FABRICS, table_fabric

_CLUSTERS, _RANK, _OWN_RANK = 4, 10, 4
_COUNTS = (1, 2, 4, 8, 16)
_MAX_RANK, _AIM = 24, 0.03
# Components that rows are told apart by.
_SPACE = 8
_PAPER_TEXELS, _PAPER_CLUSTERS = 256**2, 8
_WAYS = (
    "summed areas",
    "normalised",
    "summed areas, 8 bits",
    "normalised, 8 bits",
    "summed coefficients, 8 bits",
)
_SEED = 0
_ENLARGED = 4

Array = NDArray[np.float32]


@dataclass(frozen=True)
class Compression(Settings):
    """What is compressed."""

    fabrics: str = names("drape satin,cylinder twill", "Fabrics of the scenes.", FABRICS)
    texels: int = setting(64, "Along the longer side of the repeat.", low=16, high=256)


@dataclass(frozen=True, eq=False)
class Components:
    """Clustered principal components of rows: row ≈ means[label] + coefficients @ axes[label], by rank."""

    labels: NDArray[np.intp]
    means: list[Array]
    axes: list[Array]
    coefficients: list[Array]

    def rows(self, rank: int, whole: bool = False) -> Array:
        """All rows with so many components; `whole`: coefficients of 8 bits."""
        found = np.empty((len(self.labels), self.means[0].size), np.float32)
        for label, (mean, axes, values) in enumerate(
            zip(self.means, self.axes, self.coefficients, strict=True)
        ):
            kept = values[:, :rank]
            if whole:
                unit = np.maximum(np.abs(kept).max(axis=0, initial=0) / 127, 1e-30)
                kept = np.rint(kept / unit) * unit
            found[self.labels == label] = mean + kept @ axes[:rank]
        return found


def clustered_components(rows: Array, count: int) -> Components:
    """Of `count` clusters of rows, told apart by k-means of their first components."""
    whole = _axes(rows - rows.mean(axis=0), _SPACE)
    if count > 1:
        space = (rows - rows.mean(axis=0)) @ whole.T
        _, labels = kmeans2(space.astype(np.float64), count, minit="++", seed=_SEED)
        labels = np.unique(labels, return_inverse=True)[1]
    else:
        labels = np.zeros(len(rows), np.intp)
    means, axes, coefficients = [], [], []
    for label in range(labels.max() + 1):
        chosen = rows[labels == label]
        mean = chosen.mean(axis=0)
        found = _axes(chosen - mean, _MAX_RANK)
        means.append(mean)
        axes.append(found)
        coefficients.append((chosen - mean) @ found.T)
    return Components(labels, means, axes, coefficients)


def _axes(rows: Array, rank: int) -> Array:
    return principal_axes(rows, min(rank, *rows.shape), np.random.default_rng(_SEED))


def family_densities(name: str, texels: int) -> list[Array]:
    """D of the warp and of the weft over the front [rows, columns, bins], 0 where the other one shows."""
    fabric = table_fabric(name)
    geometry, appearance = YarnGeometry(fabric.layout()), fabric.appearance()
    maps = feature_maps(geometry, texel_counts(geometry, texels), Float)
    halves = bin_centres().astype(np.float32)
    found = []
    for is_shown, family in ((maps.is_warp[0], appearance.warp), (~maps.is_warp[0], appearance.weft)):
        shape = maps.tangent[0].shape[:2]
        values = densities(maps.tangent[0].reshape(-1, 3), halves, family.roughness).reshape(*shape, -1)
        found.append(np.where((is_shown & ~maps.hole[0])[..., None], values, 0).astype(np.float32))
    return found


def summed(values: NDArray[np.floating]) -> NDArray[np.float64]:
    """Summed areas [rows + 1, columns + 1, bins]."""
    rows, columns, bins = values.shape
    table = np.zeros((rows + 1, columns + 1, bins))
    table[1:, 1:] = values.cumsum(axis=0, dtype=np.float64).cumsum(axis=1)
    return table


def box_means(table: NDArray[np.floating], rows: int, columns: int) -> NDArray[np.floating]:
    """Means over all boxes of so many texels within the repeat."""
    total = (
        table[rows:, columns:] - table[:-rows, columns:] - table[rows:, :-columns] + table[:-rows, :-columns]
    )
    return total / (rows * columns)


def boxes(shape: Sequence[int]) -> dict[str, tuple[int, int]]:
    """Rows and columns of the boxes that errors are told of, by name."""
    rows, columns = shape[:2]
    return {
        "1 texel": (1, 1),
        "8 × 8 texels": (min(8, rows), min(8, columns)),
        "half the repeat": (rows // 2, columns // 2),
    }


def relative_error(found: NDArray[np.floating], truth: NDArray[np.floating], box: tuple[int, int]) -> float:
    """Of means over boxes, from two summed-area tables."""
    exact = box_means(truth, *box)
    return float(np.square(box_means(found, *box) - exact).mean() / np.square(exact).mean())


@dataclass(frozen=True, eq=False)
class Compressed:
    """The compressed summed areas of one family: the table at a rank.

    Attributes:
        truth: uncompressed.
        plain, normalised: as rows of components, and what is added to them.
    """

    truth: NDArray[np.float64]
    plain: Components
    normalised: Components
    low: float
    span: float
    average: NDArray[np.float64]

    @classmethod
    def of(cls, values: Array, clusters: int) -> Compressed:
        """The densities of one family, in so many clusters."""
        truth = summed(values)
        bins = truth.shape[2]
        average = summed(np.broadcast_to(values.mean(axis=(0, 1), dtype=np.float64), values.shape))
        rest = truth - average
        low, span = float(rest.min()), max(float(np.ptp(rest)), 1e-30)
        return cls(
            truth,
            clustered_components(truth.reshape(-1, bins).astype(np.float32), clusters),
            clustered_components(((rest - low) / span).reshape(-1, bins).astype(np.float32), clusters),
            low,
            span,
            average,
        )

    def table(self, normalised: bool, rank: int, whole: bool = False) -> NDArray[np.float64]:
        """The table from its components; `whole`: coefficients of 8 bits."""
        if not normalised:
            return self.plain.rows(rank, whole).reshape(self.truth.shape).astype(np.float64)
        rows = self.normalised.rows(rank, whole).reshape(self.truth.shape)
        return rows.astype(np.float64) * self.span + self.low + self.average


def own_table(values: Array) -> NDArray[np.float64]:
    """What `clustered` keeps of a family: components of D, whose coefficients are summed exactly."""
    flat = values.reshape(-1, values.shape[2])
    chosen = np.flatnonzero(flat.any(axis=1))
    rng = np.random.default_rng(_SEED)
    found = compressed(lambda numbers: flat[chosen][numbers], len(chosen), _OWN_RANK, rng)
    rows = np.zeros_like(flat)
    rows[chosen] = found.basis[0] + found.coefficients.astype(np.float32) @ found.basis[1:]
    return summed(rows.reshape(values.shape))


def normalisation(settings: Compression, run: Run) -> Found:
    """Figure 4: errors with and without normalisation, and what the model keeps."""
    require_llvm()
    chosen = listed(settings.fabrics)
    pictures = PictureTable("zhu2024 figure 4: compressed summed areas", ("uncompressed", *_WAYS))
    table = Table(
        "Relative squared error of means over boxes",
        list(boxes((2, 2))),
        note=f"{_CLUSTERS} clusters of {_RANK} components of summed areas, with coefficients of floats or of "
        f"8 bits; {_OWN_RANK} components of D whose coefficients are summed. {settings.texels} texels.",
    )
    for number, name in enumerate(chosen):
        families = family_densities(name, settings.texels)
        errors = {way: dict.fromkeys(boxes((2, 2)), 0.0) for way in _WAYS}
        shown: list[list[Tile]] = []
        for values in families:
            pair = Compressed.of(values, _CLUSTERS)
            kinds = [(is_normalised, whole) for whole in (False, True) for is_normalised in (False, True)]
            tables = [pair.table(is_normalised, _RANK, whole) for is_normalised, whole in kinds]
            tables.append(own_table(values))
            for way, found in zip(_WAYS, tables, strict=True):
                for box, extent in boxes(values.shape).items():
                    errors[way][box] += relative_error(found, pair.truth, extent) / len(families)
            if not shown:
                shown = [_tiles([pair.truth, *tables], part) for part in (_area, _density)]
        for way, found_errors in errors.items():
            table.rows[f"{name}, {way}"] = list(found_errors.values())
        for label, tiles in zip(("summed areas", "density of each texel"), shown, strict=True):
            pictures.add(f"{name}, warp: {label}", tiles)
        run.report(number + 1, len(chosen))
    note = f"At the half vector of most light. {table.note}"
    return pictures.found(with_tables(table), note)


def _area(table: NDArray[np.floating], middle: int) -> NDArray[np.floating]:
    return table[1:, 1:, middle]


def _density(table: NDArray[np.floating], middle: int) -> NDArray[np.floating]:
    return box_means(table[:, :, middle : middle + 1], 1, 1)[:, :, 0]


def _tiles(
    tables: Sequence[NDArray[np.floating]],
    part: Callable[[NDArray[np.floating], int], NDArray[np.floating]],
) -> list[Tile]:
    """One half vector of each table, on the scale of the first."""
    middle = int(tables[0][-1, -1].argmax())
    top = max(float(part(tables[0], middle).max()), 1e-30)
    return [Tile(_grey(part(table, middle) / top)) for table in tables]


def _grey(values: NDArray[np.floating]) -> Pixels:
    """Values of 0 to 1 as greys, each texel some pixels wide, y upwards."""
    wide = np.repeat(np.repeat(values[::-1], _ENLARGED, axis=0), _ENLARGED, axis=1)
    pixels = np.rint(255 * np.clip(wide, 0, 1) ** (1 / 2.2)).astype(np.uint8)
    return np.repeat(pixels[..., None], 3, axis=2)


def ranks(settings: Compression, run: Run) -> Found:
    """Figure 3: ranks and bytes by clusters, at one quality."""
    require_llvm()
    chosen = listed(settings.fabrics)
    found = run.each({name: partial(_of_fabric, name, settings) for name in chosen})
    tables = []
    for name, rows in found.items():
        table = Table(
            f"{name}: rank for an error of {_AIM}",
            ["summed areas", "normalised", "MB, summed areas", "MB, normalised"],
            {f"{count} clusters": list(cells) for count, cells in rows.items()},
            note=f"A dash: no rank up to {_MAX_RANK} does.",
        )
        tables.append(table)
    return Found(with_tables(*tables))


def _of_fabric(name: str, settings: Compression) -> dict[str, list[float | int | None]]:
    families = family_densities(name, settings.texels)
    found = {}
    for count in _COUNTS:
        pairs = [Compressed.of(values, count) for values in families]
        least = [_least_rank(pairs, normalised) for normalised in (False, True)]
        found[str(count)] = [*least, *(None if rank is None else megabytes(count, rank) for rank in least)]
    return found


def _least_rank(pairs: Sequence[Compressed], normalised: bool) -> int | None:
    """The least rank at which the mean error of the families is below the aim."""
    for rank in range(_MAX_RANK + 1):
        error = np.mean(
            [
                relative_error(pair.table(normalised, rank), pair.truth, boxes(pair.truth.shape)["1 texel"])
                for pair in pairs
            ]
        )
        if error < _AIM:
            return rank
    return None


def megabytes(count: int, rank: int) -> float:
    """Of the paper's texels and clusters of visibility: coefficients, components, and labels of rows."""
    rows = _PAPER_TEXELS * (4 * rank + 1)
    return _PAPER_CLUSTERS * (rows + count * (1 + rank) * BINS**2 * 4) / 1e6


_SMALL = {"fabrics": "cylinder twill", "texels": 16}
STUDIES = (
    Study(
        "papers/zhu2024/fig3",
        "rank and bytes of summed-area tables by clusters, at one quality",
        Compression(texels=32),
        ranks,
        stands_on=("clustered",),
        small=_SMALL,
    ),
    Study(
        "papers/zhu2024/fig4",
        "normalisation of summed-area tables before they are compressed",
        Compression(),
        normalisation,
        stands_on=("clustered",),
        small=_SMALL,
    ),
)
