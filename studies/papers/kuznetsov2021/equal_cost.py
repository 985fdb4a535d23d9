"""kuznetsov2021: Table 2 with Fig. 6 at equal rays of a material and equal processor seconds of training.

Ours takes all rays as queries; Rainer et al. 2019 as apparent BRDFs of its texels, and what is left as
queries. 2020's encoder and decoder are trained for the other materials of the table, and all rays of the
tested one are apparent BRDFs. The seconds become steps: a few are timed first.
"""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from hashlib import sha256
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from loomlight.core.errors import InputError
from loomlight.core.extras import import_extra
from loomlight.core.files import replacing
from loomlight.core.settings import same_setting, setting
from loomlight.evaluation.table import Cell, Table
from loomlight.models.options import TrainingOptions
from loomlight.models.registry import btf_of
from loomlight.models.texture.neumip import NeumipModel
from loomlight.models.texture.queries import draw_directions
from loomlight.models.texture.settings import LatentOptions, NeumipOptions, NeumipSettings
from loomlight.sources.heightfield import Heightfield
from studies.harness.study import Figures, Found, Run, Study, on_display, stored_tables, with_tables
from studies.instruments.sheet import PictureTable, Tile, error_caption
from studies.papers.kuznetsov2021.designs import ALL_DESIGNS, DESIGNS, OURS, RAINER19, RAINER20, WITHOUT
from studies.papers.kuznetsov2021.stage import (
    PREVIEW,
    MaterialsSettings,
    Predict,
    Shot,
    model_picture,
    model_predictor,
    network_predictor,
    plane_shot,
    stage_error,
    traced,
)
from studies.papers.setting import TrainedSettings

FORMER = "ours, published recipe"
COLUMNS = (WITHOUT, OURS, FORMER, RAINER19, RAINER20)
# Rays of a query of those that errors by level are of.
PROBE_RAYS = 64
_RATIOS_BY_LEVEL = "Ratios of MSE to ours by level"
# Steps that are timed; those before have what is done once.
_TIMED, _BEFORE = 24, 8
# Trainings of 2020 have so many times the seconds of the others, for all materials together.
_UNIVERSAL = 2
_SEED = 43

# MSE times 1000 of Table 2, in the order of `DESIGNS`: without the offset, ours, Rainer19, Rainer20.
PAPER = {
    "twisted wool": (11.31, 3.98, 12.79, 19.03),
    "straight wool": (1.04, 0.39, 2.30, 1.92),
    "turtle shell": (3.35, 1.31, 2.83, 4.84),
    "cliff rock": (6.00, 2.00, 7.89, 10.26),
    "insulation foam": (9.18, 3.90, 10.04, 21.75),
}


@dataclass(frozen=True)
class Budget:
    """The cost of a material.

    Attributes:
        resolution: texels a side of the textures.
        rays: in all, a multiple of the pairs of all texels.
        seconds: of the processor, of one training.
        former_resolution: texels a side of the published recipe, which more make worse in a short training.
        steps: of each training, instead of seconds.
    """

    resolution: int
    rays: int
    seconds: float
    former_resolution: int = 64
    steps: int | None = None


BUDGETS = {"preview": Budget(128, 1 << 22, 20), "full": Budget(256, 1 << 24, 100)}


@dataclass
class Trained:
    """A design that is trained, and what it cost.

    Attributes:
        predict: its values.
        cost: "rays", "steps" and "cpu_seconds" of the training.
    """

    predict: Predict
    cost: dict[str, float]


def budget_of(settings: MaterialsSettings) -> Budget:
    """The budget that a quality names, with the steps and the resolution of the settings."""
    budget = replace(BUDGETS[settings.quality], steps=settings.steps)
    if settings.resolution is None:
        return budget
    rays = budget.rays * settings.resolution**2 // budget.resolution**2
    former = min(budget.former_resolution, settings.resolution)
    return replace(budget, resolution=settings.resolution, rays=rays, former_resolution=former)


@dataclass(frozen=True)
class CostSettings(MaterialsSettings):
    """Of the table at equal cost."""

    quality: str = same_setting(TrainedSettings, "quality", choices=tuple(BUDGETS))
    levels: int = setting(6, "Sizes of footprints of random queries, from a texel.", low=1, high=8)
    probes: int = setting(2000, "Random queries of each size.", low=1, high=10**6)
    batch: int | None = same_setting(
        LatentOptions, "batch", help="Queries of a step of each training.", otherwise="those of the recipes"
    )
    device: str = same_setting(TrainingOptions, "device")


class EqualCost:
    """The trainings of some materials at one budget; a folder keeps them, and what they learn from."""

    def __init__(
        self,
        sources: Sequence[Heightfield],
        budget: Budget,
        runs: Path,
        batch: int | None = None,
        device: str = "cpu",
    ) -> None:
        """
        Args:
            batch: queries of a step; None for those of the recipes.
            device: of torch, "cpu" or "cuda".
        """
        self._sources, self._budget, self._batch, self._device = list(sources), budget, batch, device
        # The clock of what trainings cost: with a card a processor's time is not theirs.
        self._clock = time.process_time if device == "cpu" else time.perf_counter
        self._folder = Path(runs) / "kuznetsov2021"
        self._queries_folder = self._folder / "queries"
        self._queries_folder.mkdir(parents=True, exist_ok=True)
        # One ray a query: rays are then queries.
        recipe = NeumipOptions(resolution=budget.resolution).settings(is_fabric=False)
        self.settings = replace(recipe, queries=budget.rays, batch=batch or recipe.batch)

    def trained(self, name: str, source: Heightfield) -> Trained:
        """A design of `ALL_DESIGNS`, or `FORMER`, for a material.

        Raises:
            InputError: the folder cannot be written to, or holds a damaged training; no such device.
            MissingDependencyError: PyTorch is missing.
        """
        import_extra("torch", "train", "Training")
        from loomlight.training.loop import require_device

        require_device(self._device)
        if name == FORMER:
            return self._former(source)
        if name in (OURS, WITHOUT):
            return self._ours(name, source)
        return self._encoded(name, source)

    def _ours(self, name: str, source: Heightfield) -> Trained:
        from loomlight.models.texture.neumip_training import trained_network

        settings = replace(self.settings, offset=name == OURS)
        self._taken(source, settings)

        def run(steps: int, folder: Path, report: Callable[[int, int], None]) -> Any:
            used = replace(settings, steps=steps)
            for file in self._queries_folder.glob(f"queries-{settings.query_identity(source)[:12]}-*"):
                if not (folder / file.name).exists():
                    (folder / file.name).hardlink_to(file)
            # Reports up to 300 of 1000 are of queries. No directions are drawn here.
            network, _, _ = trained_network(
                source,
                used,
                folder,
                lambda done, total: report(done, total) if done > 300 else None,
                self._device,
            )
            return network.to("cpu").weights(np.zeros((1, 3), np.float32))

        weights, cost = self._run(name, settings.identity(source), run)
        return Trained(model_predictor(NeumipModel(source, weights)), cost | {"rays": self._budget.rays})

    def _former(self, source: Heightfield) -> Trained:
        from studies.papers.kuznetsov2021.neural_textures import trained_textures

        settings = replace(
            PREVIEW,
            resolution=self._budget.former_resolution,
            queries=self._budget.rays // PREVIEW.samples,
            batch=min(self._batch or 2 * PREVIEW.batch, self._budget.rays // PREVIEW.samples),
        )
        self._taken(source, settings)

        def run(steps: int, folder: Path, report: Callable[[int, int], None]) -> Any:
            used, design = replace(settings, steps=steps), DESIGNS[OURS]
            return trained_textures(design, source, used, folder, self._queries_folder, report, self._device)

        network, cost = self._run(FORMER, settings.identity(source), run)
        return Trained(network_predictor(network, source), cost | {"rays": self._budget.rays})

    def _encoded(self, name: str, source: Heightfield) -> Trained:
        from studies.papers.kuznetsov2021.encoded_textures import (
            PAIRS,
            EncodedTextures,
            apparent_brdfs,
            trained_encodings,
        )

        shape, design = self.settings.shape(source, faces=1), ALL_DESIGNS[name]
        of_pairs = shape.columns * shape.rows * PAIRS
        samples = self._budget.rays // of_pairs if design.together else 1
        learned = [source]
        if design.together:
            learned = [other for other in self._sources if other.name != source.name]
        # Of the tested material 2019 has the rays that its apparent BRDFs leave.
        count = self._budget.rays if design.together else self._budget.rays - samples * of_pairs
        queries = [self._taken(other, self.settings)[:count] for other in learned]

        def textures() -> list[EncodedTextures]:
            import torch

            from loomlight.models.texture.neumip_training import gains_of

            torch.manual_seed(self.settings.seed)
            made: list[EncodedTextures] = []
            for other, known in zip(learned, queries, strict=True):
                apparent = apparent_brdfs(other, self.settings, self._queries_folder, samples)
                networks = (made[0].encoder, made[0].decoder) if made else None
                made.append(EncodedTextures(design, shape, apparent, gains_of(known), networks))
            return made

        identity = " ".join(self.settings.identity(other) for other in learned)

        def run(steps: int, folder: Path, report: Callable[[int, int], None]) -> Any:
            made, used = textures(), replace(self.settings, steps=steps)
            trained_encodings(
                design, made, queries, used, folder, f"{steps} {identity}", report, self._device
            )
            return made

        made, cost = self._run(name, identity, run, _UNIVERSAL if design.together else 1)
        network = made[0]
        if design.together:
            apparent = apparent_brdfs(source, self.settings, self._queries_folder, samples)
            network = EncodedTextures(design, shape, apparent, networks=(network.encoder, network.decoder))
        rays = samples * of_pairs + (0 if design.together else count)
        return Trained(network_predictor(network, source), cost | {"rays": rays})

    def _taken(self, source: Heightfield, settings: NeumipSettings) -> Any:
        from loomlight.models.texture.neumip_training import taken_queries

        return taken_queries(source, btf_of(source, "neumip"), settings, self._queries_folder)

    def _run(
        self, name: str, identity: str, run: Callable[..., Any], times: int = 1
    ) -> tuple[Any, dict[str, float]]:
        """What a training gives, and its cost; one that was stopped goes on with as many steps.

        Args:
            run: called with (steps, folder, report of (done, in all)).
            times: so many times the seconds of the budget.
        """
        digest = sha256(f"{name} {self._budget} {identity}".encode()).hexdigest()[:12]
        folder = self._folder / f"equal-{digest}"
        folder.mkdir(exist_ok=True)
        file = folder / "cost.json"
        cost = json.loads(file.read_text()) if file.exists() else {}
        if "steps" not in cost:
            cost["steps"] = self._budget.steps or self._steps(run, times)
            _write(file, cost)
        marks: list[float] = []
        found = run(int(cost["steps"]), folder, lambda done, total: marks.append(self._clock()))
        if "cpu_seconds" not in cost:
            # Of all steps by those of this run, less what comes before and after them.
            cost["cpu_seconds"] = cost["steps"] * _mean_step(marks)
            _write(file, cost)
        return found, cost

    def _steps(self, run: Callable[..., Any], times: int) -> int:
        """Steps that take the seconds of the budget."""
        marks: list[float] = []
        with TemporaryDirectory() as folder:
            run(_BEFORE + _TIMED, Path(folder), lambda done, total: marks.append(self._clock()))
        return max(1, round(times * self._budget.seconds / _mean_step(marks[_BEFORE:])))


def probe_shot(source: Heightfield, side_mm: float, level: int, count: int) -> Shot:
    """So many random queries of footprints of one size, with lights and views as those of trainings."""
    rng = np.random.default_rng([_SEED, level])
    positions = (rng.random((count, 2)) * np.array(source.repeat_mm)).astype(np.float32)
    lights, views = draw_directions(rng, count), draw_directions(rng, count)
    return Shot((count, 1), positions, np.full(count, side_mm, np.float32), views, lights)


def comparison(settings: CostSettings, run: Run) -> Found:
    """Table 2 and Fig. 6 at equal cost.

    Raises:
        InputError: one material alone, as the networks of Rainer et al. 2020 are trained for others.
    """
    budget, columns = budget_of(settings), list(COLUMNS)
    sources = settings.sources()
    if len(sources) < 2:
        raise InputError(
            f"--materials {settings.materials} are too few: Rainer et al. 2020 need two or more."
        )
    trainings = EqualCost(sources, budget, run.runs, settings.batch, settings.device)
    squared, flip = Table("MSE × 1000, of π f·cos", columns), Table("FLIP", columns)
    by_level = Table("MSE × 1000 of random queries by level", columns)
    cost = Table("Steps; processor seconds of training", columns)
    texel_mm = trainings.settings.shape(sources[0], faces=1).texel_mm
    shown = PictureTable("kuznetsov2021 table 2 and figure 6", [*columns, "reference"])
    for number, source in enumerate(sources):
        name = source.name
        designs = {column: trainings.trained(column, source) for column in columns}
        cost.rows[name] = [int(one.cost["steps"]) for one in designs.values()]
        cost.rows[f"{name}, seconds"] = [one.cost["cpu_seconds"] for one in designs.values()]
        cost.rows[f"{name}, rays"] = [int(one.cost["rays"]) for one in designs.values()]
        shot = plane_shot(source, texel_mm, 0, settings.size)
        truth = traced(source, shot, settings.spp)
        pictures = [model_picture(one.predict, shot) for one in designs.values()]
        errors = [stage_error(picture, truth) for picture in pictures]
        squared.rows[name] = [1e3 * error.mse for error in errors]
        flip.rows[name] = [error.flip for error in errors]
        tiles = [
            Tile(on_display(each), error_caption(error)) for each, error in zip(pictures, errors, strict=True)
        ]
        shown.add(name, [*tiles, Tile(on_display(truth.picture))])
        for level in range(settings.levels):
            probes = probe_shot(source, texel_mm * 2**level, level, settings.probes)
            known = traced(source, probes, PROBE_RAYS)
            by_level.rows[f"{name}, {level}"] = [
                1e3 * known.squared_error(model_picture(one.predict, probes)) for one in designs.values()
            ]
        run.report(number + 1, len(sources))
    note = squared.note = _note(budget, settings)
    paper = Table("MSE × 1000 in the paper", list(DESIGNS), {name: [*row] for name, row in PAPER.items()})
    tables = [
        squared,
        flip,
        ratios("Ratios of MSE to ours", squared),
        by_level,
        ratios(_RATIOS_BY_LEVEL, by_level),
        cost,
        paper,
        ratios("Ratios in the paper", paper),
    ]
    return shown.found(with_tables(*tables), note)


def ratios(title: str, squared: Table) -> Table:
    """Errors of the others over those of ours, and their geometric means."""
    ours = squared.columns.index(OURS)
    others = [number for number in range(len(squared.columns)) if number != ours]
    values = {name: np.array(row, float) for name, row in squared.rows.items()}
    found = {name: row[others] / row[ours] for name, row in values.items()}
    found["geometric mean"] = np.exp(np.mean([np.log(row) for row in found.values()], axis=0))
    rows: dict[str, list[Cell]] = {name: [*map(float, row)] for name, row in found.items()}
    return Table(title, [squared.columns[k] for k in others], rows)


def tables_with_levels(figures: Figures) -> list[Table]:
    """The stored tables, and ratios by the size of the footprint: geometric means of all materials."""
    stored = stored_tables(figures)
    by_level = next(table for table in stored if table.title == _RATIOS_BY_LEVEL)
    rows = {name: np.array(row, float) for name, row in by_level.rows.items() if ", " in name}
    levels = sorted({int(name.rpartition(", ")[2]) for name in rows})
    means = [
        np.exp(np.mean([np.log(row) for name, row in rows.items() if name.endswith(f", {level}")], axis=0))
        for level in levels
    ]
    found = np.array([*means, np.exp(np.mean(np.log(list(rows.values())), axis=0))])
    table = Table("Ratios to ours by side of the footprint in texels", [*(f"{2**k}" for k in levels), "all"])
    for number, name in enumerate(by_level.columns):
        table.rows[name] = [*map(float, found[:, number])]
    return [*stored, table]


def _note(budget: Budget, settings: MaterialsSettings) -> str:
    length = f"{budget.seconds:g} processor seconds" if budget.steps is None else f"{budget.steps} steps"
    return (
        f"Each design has {budget.rays} rays of a material, and {length} of training; textures of "
        f"{budget.resolution} texels a side, of the published recipe {budget.former_resolution}. "
        f"References of {settings.spp} paths a pixel. Level 0 is a texel of {budget.resolution}."
    )


def _mean_step(marks: Sequence[float]) -> float:
    """Seconds between marks; 0 of fewer than two."""
    return (marks[-1] - marks[0]) / (len(marks) - 1) if len(marks) > 1 else 0.0


def _write(file: Path, cost: dict[str, float]) -> None:
    with replacing(file) as temporary:
        temporary.write_text(json.dumps(cost))


STUDY = Study(
    "papers/kuznetsov2021/table2",
    "five height fields at equal cost: ours, without offset, by the published recipe, and Rainer et al.",
    CostSettings(),
    comparison,
    tables_with_levels,
    stands_on=("neumip",),
    small={
        "size": (16, 9),
        "spp": 4,
        "steps": 3,
        "resolution": 8,
        "side": 16,
        "materials": "turtle shell,straight wool",
        "levels": 2,
        "probes": 32,
    },
)
