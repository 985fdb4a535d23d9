"""kuznetsov2021: Table 2 at equal steps, by the length of the training, and at equal weights.

What does the offset gain, and what do Rainer et al. 2019 lose, when all learn from as many rays by as many
steps? `neumip` is trained with and without the offset, several times for each material, each time with its
whole schedule; 2019 with the paper's decoder of 35 725 weights and with one of 3273, about as many as ours.
Errors are of pictures, as in Table 2, and of random queries, whose values are clamped to white: a few
grazing highlights outweigh all others otherwise (`bright_queries`). A line fitted to the logarithms of gain
and queries is carried on to the paper's 31 457 million: an extrapolation of one seed and no measurement. The
same line without the longest training says how far such a line can be trusted.

A run that is stopped goes on; trainings stay in the folder of runs.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np
from numpy.typing import NDArray

from loomlight.core.settings import same_setting, setting
from loomlight.evaluation.table import Cell, Table
from loomlight.models.options import TrainingOptions
from loomlight.models.texture.settings import LatentOptions
from loomlight.sources.heightfield import Heightfield
from studies.harness.study import (
    Figures,
    Found,
    Pixels,
    Run,
    Study,
    listed_counts,
    on_display,
    stored_tables,
    with_tables,
)
from studies.instruments.halved_truth import HalvedTruth
from studies.instruments.plot import Curve, curves_plot
from studies.instruments.sheet import PictureTable, Tile
from studies.papers.kuznetsov2021.designs import ALL_DESIGNS, OURS, RAINER19, RAINER19_SMALL, WITHOUT
from studies.papers.kuznetsov2021.equal_cost import PROBE_RAYS, Budget, EqualCost, probe_shot
from studies.papers.kuznetsov2021.stage import (
    HeightfieldsSettings,
    Predict,
    Shot,
    clamped,
    model_picture,
    plane_shot,
    stage_error,
    traced,
)
from studies.papers.setting import TrainedSettings

# Queries that the paper's trainings see: 30 000 steps of 2^20.
PAPER_QUERIES = 30_000 * 2**20
# Sizes of footprints of random queries, from a texel.
_LEVELS = 4
_MAX_STEPS = 1_000_000
_BASELINES = (RAINER19, RAINER19_SMALL)
_PICTURES = "MSE × 1000 of pictures by millions of queries seen"
_PROBES = "MSE × 1000 of random queries, clamped, by millions of queries seen"
_FLIP = "FLIP by millions of queries seen"
# A line is fitted to so many trainings at least, and the last one is left out once.
_MIN_POINTS = 3


@dataclass(frozen=True)
class StepsSettings(HeightfieldsSettings):
    """Of the table at equal steps."""

    resolution: int = same_setting(TrainedSettings, "resolution", default=64, otherwise="")
    lengths: str = setting(
        "32,64,128,256,512,1024,2048", "Steps of trainings with the offset and without.", metavar="N,…"
    )
    further: str = setting(
        "4096,8192", "Steps of further ones of the first material, or none.", metavar="N,…"
    )
    baselines: str = setting("256,1024", "Steps of trainings of Rainer et al. 2019.", metavar="N,…")
    queries: int = setting(256, "Rays a texel that each training learns from.", low=128, high=1 << 14)
    probes: int = setting(2000, "Random queries of each size of footprints.", low=1, high=10**6)
    batch: int | None = same_setting(
        LatentOptions, "batch", help="Queries of a step of each training.", otherwise="that of the recipe"
    )
    device: str = same_setting(TrainingOptions, "device")


@dataclass(frozen=True)
class Case:
    """A training.

    Attributes:
        design: a name of `ALL_DESIGNS`.
        steps: its length.
    """

    source: Heightfield
    design: str
    steps: int


class Trials:
    """Trainings of any length of any material, and the errors of each."""

    def __init__(self, settings: StepsSettings, run: Run) -> None:
        self._settings, self._runs = settings, run.runs
        self._sources = settings.sources()
        self._views: dict[str, Views] = {}

    def cases(self) -> list[Case]:
        """All trainings, short ones first."""
        settings = self._settings
        lengths, baselines, further = (
            listed_counts(f"--{name}", text, 1, _MAX_STEPS) if text else []
            for name, text in (
                ("lengths", settings.lengths),
                ("baselines", settings.baselines),
                ("further", settings.further),
            )
        )
        found = [
            *(Case(each, name, n) for n in lengths for each in self._sources for name in (WITHOUT, OURS)),
            *(Case(each, name, n) for n in baselines for each in self._sources for name in _BASELINES),
        ]
        found.sort(key=lambda case: case.steps)
        rest = [Case(self._sources[0], name, n) for n in further for name in (WITHOUT, OURS)]
        return [*found, *(case for case in rest if case not in found)]

    def batch(self) -> int:
        """Queries of a step."""
        return self._trainings(1).settings.batch

    def predict(self, case: Case) -> Predict:
        """The values of a training, which is made if it is not there."""
        return self._trainings(case.steps).trained(case.design, case.source).predict

    def errors(self, case: Case) -> dict[str, list[float]]:
        """Of a picture, "mse" × 1000 and "flip"; "probes", MSE × 1000 of each size of random queries."""
        predict, views = self.predict(case), self.views(case.source)
        error = stage_error(model_picture(predict, views.shot), views.picture)
        probes = [
            1e3 * clamped(truth).squared_error(np.minimum(model_picture(predict, shot), 1))
            for shot, truth in views.probes
        ]
        return {"mse": [1e3 * error.mse], "flip": [error.flip], "probes": probes}

    def views(self, source: Heightfield) -> Views:
        """What a material is judged by."""
        if source.name not in self._views:
            texel_mm = self._trainings(1).settings.shape(source, faces=1).texel_mm
            self._views[source.name] = Views(source, texel_mm, self._settings)
        return self._views[source.name]

    def _trainings(self, steps: int) -> EqualCost:
        settings = self._settings
        side = settings.resolution
        # Seconds are not asked for where there are steps.
        budget = Budget(side, settings.queries * side**2, seconds=0, steps=steps)
        return EqualCost(self._sources, budget, self._runs, settings.batch, settings.device)


class Views:
    """Queries of a material and their truth, traced when they are first asked for.

    Attributes:
        shot: the picture's.
    """

    def __init__(self, source: Heightfield, texel_mm: float, settings: StepsSettings) -> None:
        self._source, self._texel_mm, self._settings = source, texel_mm, settings
        self.shot = plane_shot(source, texel_mm, 0, settings.size)

    @cached_property
    def picture(self) -> HalvedTruth:
        """The truth of the picture."""
        return traced(self._source, self.shot, self._settings.spp)

    @cached_property
    def probes(self) -> list[tuple[Shot, HalvedTruth]]:
        """Random queries and their truth, of footprints of 1, 2, 4 … texels."""
        shots = [
            probe_shot(self._source, self._texel_mm * 2**level, level, self._settings.probes)
            for level in range(_LEVELS)
        ]
        return [(shot, traced(self._source, shot, PROBE_RAYS)) for shot in shots]


def comparison(settings: StepsSettings, run: Run) -> Found:
    """Table 2 at equal steps, for several lengths."""
    trials = Trials(settings, run)
    cases = {f"{case.source.name}, {case.design}, {case.steps}": case for case in trials.cases()}
    found = run.each({name: partial(trials.errors, case) for name, case in cases.items()})
    batch, steps = trials.batch(), sorted({case.steps for case in cases.values()})
    columns = [f"{n * batch / 1e6:.3g}" for n in steps]
    note = (
        f"{settings.queries} rays a texel of {settings.resolution}², {steps[0]} to {steps[-1]} steps of "
        f"{batch} queries (the paper: {PAPER_QUERIES / 1e6:.0f} million); footprints of a texel, "
        f"references of {settings.spp} paths a pixel."
    )

    def table(title: str, measure: str, place: int = 0) -> Table:
        made = Table(title, columns)
        for name, case in cases.items():
            row = made.rows.setdefault(f"{case.source.name}, {case.design}", [None] * len(steps))
            row[steps.index(case.steps)] = found[name][measure][place]
        # Materials together, in the order of the designs.
        made.rows = {label: made.rows[label] for label in sorted(made.rows, key=_order(settings))}
        return made

    tables = [
        table(_PICTURES, "mse"),
        table(_FLIP, "flip"),
        *(table(_of_size(level), "probes", level) for level in range(_LEVELS)),
    ]
    tables[0].note = note
    shown = _pictures(trials, list(cases.values()))
    result = shown.found(with_tables(*tables), note)
    pictures = {"learning curves": gains_plot(tables[0]), **result.pictures}
    return Found(result.figures, result.sheet, pictures)


def _of_size(level: int) -> str:
    return f"{_PROBES}, footprints of {2**level} texels" if level else f"{_PROBES}, footprints of a texel"


def _order(settings: StepsSettings) -> Callable[[str], tuple[int, int]]:
    materials, designs = [source.name for source in settings.sources()], list(ALL_DESIGNS)

    def place(label: str) -> tuple[int, int]:
        material, design = label.split(", ", 1)
        return materials.index(material), designs.index(design)

    return place


def _pictures(trials: Trials, cases: Sequence[Case]) -> PictureTable:
    """Pictures of the longest training of each design that all materials have, and the reference."""
    columns = list(dict.fromkeys(case.design for case in cases))
    shown = PictureTable("kuznetsov2021 table 2 at equal steps", [*columns, "reference"])
    for source in {case.source.name: case.source for case in cases}.values():
        tiles, views = [], trials.views(source)
        for design in columns:
            steps = [
                {case.steps for case in cases if case.design == design and case.source.name == other}
                for other in {case.source.name for case in cases}
            ]
            case = Case(source, design, max(set.intersection(*steps)))
            picture = model_picture(trials.predict(case), views.shot)
            error = stage_error(picture, views.picture)
            caption = f"{case.steps} steps, MSE {error.mse:.1e}, FLIP {error.flip:.2f}"
            tiles.append(Tile(on_display(picture), caption))
        shown.add(source.name, [*tiles, Tile(on_display(views.picture.picture))])
    return shown


# ----------------------------------------------------------------------------------------- what follows of it


def tables(figures: Figures) -> list[Table]:
    """Gains by queries seen, carried on to the paper's; ratios of Rainer et al.; and the errors."""
    stored = stored_tables(figures)
    pictures = stored[0]
    gains = [_gains("Gain of the offset, pictures, by millions of queries seen", pictures)]
    sizes = [next(table for table in stored if table.title == _of_size(k)) for k in range(_LEVELS)]
    gains += [
        _gains("Gain of the offset, random queries, by millions of queries seen", each) for each in sizes
    ]
    gains[0].note = pictures.note
    return [
        *gains[:2],
        _extrapolated("Gain of the offset at the paper's queries, pictures", gains[0]),
        _extrapolated("Gain of the offset at the paper's queries, random queries", gains[1]),
        _by_size(gains[1:]),
        _ratios("MSE of Rainer et al. 2019 over ours, pictures", pictures),
        _ratios("MSE of Rainer et al. 2019 over ours, random queries", sizes[0]),
        *stored,
    ]


def _row(table: Table, label: str) -> list[float]:
    """A row with NaN where there is no number."""
    return [float(cell) if isinstance(cell, float | int) else math.nan for cell in table.rows[label]]


def _materials(table: Table) -> list[str]:
    return list(dict.fromkeys(label.split(", ", 1)[0] for label in table.rows))


def _gains(title: str, errors: Table) -> Table:
    """MSE without the offset over that with it, by material and length, and geometric means of all."""
    rows = {
        name: np.array(_row(errors, f"{name}, {WITHOUT}")) / _row(errors, f"{name}, {OURS}")
        for name in _materials(errors)
    }
    return _with_means(Table(title, errors.columns), rows)


def _ratios(title: str, errors: Table) -> Table:
    """MSE of the baselines over that of ours by as many steps, with the offset and without."""
    columns: list[str] = []
    rows: dict[str, list[float]] = {}
    for design in _BASELINES:
        for number, queries in enumerate(errors.columns):
            found = {name: _row(errors, f"{name}, {design}")[number] for name in _materials(errors)}
            if not any(math.isnan(value) for value in found.values()):
                for name, value in found.items():
                    for other in (OURS, WITHOUT):
                        ratio = value / _row(errors, f"{name}, {other}")[number]
                        rows.setdefault(f"{name}, over {other}", []).append(ratio)
                columns.append(f"{design}, {queries} million")
    table = Table(title, columns)
    for other in (OURS, WITHOUT):
        chosen = {name: np.array(row) for name, row in rows.items() if name.endswith(f"over {other}")}
        _with_means(table, chosen, f"geometric mean, over {other}")
    return table


def _with_means(table: Table, rows: dict[str, NDArray[np.float64]], name: str = "geometric mean") -> Table:
    """Adds rows and their geometric means, of columns that all have."""
    table.rows |= {label: [*map(float, row)] for label, row in rows.items()}
    table.rows[name] = [*map(float, np.exp(np.mean([np.log(row) for row in rows.values()], axis=0)))]
    return table


def _by_size(gains: Sequence[Table]) -> Table:
    """The gain of the longest training that all materials have, by the side of footprints."""
    table = Table(
        "Gain of the offset by texels of a footprint's side", [f"{2**k}" for k in range(len(gains))]
    )
    last = max(k for k, value in enumerate(gains[0].rows["geometric mean"]) if value == value)
    for name in gains[0].rows:
        table.rows[name] = [_row(each, name)[last] for each in gains]
    table.note = f"Trainings of {gains[0].columns[last]} million queries."
    return table


@dataclass(frozen=True)
class Line:
    """A power of the queries that a gain grows as.

    Attributes:
        exponent: of the queries.
        start: logarithm of the gain at one query.
    """

    exponent: float
    start: float

    @classmethod
    def through(cls, queries: Sequence[float], gains: Sequence[float]) -> Line:
        """The line of least squares through the logarithms."""
        exponent, start = np.polyfit(np.log(queries), np.log(gains), 1)
        return cls(float(exponent), float(start))

    def at(self, queries: float) -> float:
        """The gain."""
        return math.exp(self.start + self.exponent * math.log(queries))


def _extrapolated(title: str, gains: Table) -> Table:
    """Lines through the gains of a material from where it first gains, carried on to the paper's queries."""
    columns = [
        "longest, million queries",
        "its gain",
        "line without it says",
        "exponent",
        "at the paper's queries",
        "by the last four alone",
    ]
    table = Table(title, columns)
    queries = [1e6 * float(column) for column in gains.columns]
    for name in gains.rows:
        seen = [(x, y) for x, y in zip(queries, _row(gains, name), strict=True) if y == y]
        if len(seen) <= _MIN_POINTS:
            table.rows[name] = [seen[-1][0] / 1e6, seen[-1][1], None, None, None, None]
            continue
        x, y = [each[0] for each in seen], [each[1] for each in seen]
        whole, before, last = Line.through(x, y), Line.through(x[:-1], y[:-1]), Line.through(x[-4:], y[-4:])
        row: list[Cell] = [x[-1] / 1e6, y[-1], before.at(x[-1]), whole.exponent]
        table.rows[name] = [*row, whole.at(PAPER_QUERIES), last.at(PAPER_QUERIES)]
    return table


def gains_plot(errors: Table) -> Pixels:
    """Gains of all materials by queries seen, in millions."""
    gains = _gains("", errors)
    queries = [float(column) for column in gains.columns]
    curves = {}
    for name in gains.rows:
        seen = [(x, y) for x, y in zip(queries, _row(gains, name), strict=True) if y == y]
        curves[name] = Curve([x for x, _ in seen], [y for _, y in seen])
    return curves_plot(
        "kuznetsov2021: what the offset gains", "millions of queries seen", "MSE without / with", curves
    )


STUDY = Study(
    "papers/kuznetsov2021/equal_steps",
    "five height fields at equal steps of several lengths, with offset and without, and Rainer et al. 2019",
    StepsSettings(),
    comparison,
    tables,
    stands_on=("neumip",),
    small={
        "size": (16, 9),
        "spp": 4,
        "side": 16,
        "resolution": 8,
        "lengths": "2,4",
        "further": "6",
        "baselines": "2",
        "batch": 64,
        "queries": 128,
        "probes": 32,
        "materials": "turtle shell,straight wool",
    },
)
