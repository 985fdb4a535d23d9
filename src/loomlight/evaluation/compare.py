"""`compare`: pictures, difference maps and tables of models against the reference, in a folder to look at."""

from __future__ import annotations

import math
import os
import re
import tempfile
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from loomlight.aggregate.queries import BANDS
from loomlight.core.errors import InputError
from loomlight.core.files import discarding_empty, replacing
from loomlight.core.images import write_image, write_pixels
from loomlight.core.provenance import provenance
from loomlight.evaluation.image_benchmark import SceneResult, image_tables, run_image_benchmark
from loomlight.evaluation.metrics import samples_for
from loomlight.evaluation.query_benchmark import (
    MONTE_CARLO,
    WEAVES,
    HeldOut,
    QueryBenchmark,
    model_predictor,
    run_query_benchmark,
    samples_name,
)
from loomlight.evaluation.report import Figure, Report, Section, report_html
from loomlight.evaluation.table import Cell, Table, write_json
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.read import fabric_from_text, load_fabric
from loomlight.mitsuba.measured_scenes import MEASURED_SCENES, require_scenes
from loomlight.models.interface import Model
from loomlight.models.registry import make_model, model_class, model_names, require_model_name
from loomlight.sources.loom_file import write_loom

# What larger pictures and fewer queries change: docs/research/evaluation.md.
SIZE, REFERENCE_SAMPLES = (320, 180), 49
_PAIRS, _FOOTPRINTS = 40, 40
# The background of the scene with two fabrics.
_PARTNER = 'weave = "plain"\n[warp]\ncolor = "#c9b58f"\n[weft]\ncolor = "#e6dcc4"\n'
_SCHEMA = 1

Progress = Callable[[str, int, int], None]


@dataclass
class Comparison:
    """The results of `compare`.

    Attributes:
        folder: of index.html, table.json and the pictures.
        tables: every table of index.html.
        refused: the reason, by the name of each model that does not take the fabric.
    """

    folder: Path
    tables: list[Table] = field(default_factory=list)
    refused: dict[str, str] = field(default_factory=dict)


def compare(
    fabric: Fabric | str | os.PathLike[str],
    models: Sequence[str],
    folder: str | os.PathLike[str],
    *,
    scenes: Sequence[str] = MEASURED_SCENES,
    size: tuple[int, int] = SIZE,
    reference_samples: int = REFERENCE_SAMPLES,
    command: str = "loomlight.compare",
    progress: Progress | None = None,
    row: Callable[[str], None] = lambda line: None,
) -> Comparison:
    """Renders a fabric in the eight scenes of the image benchmark with each model and measures the errors.

    Writes `folder`/index.html, table.json and pictures/*.png, again after every scene; the folder is created
    if it does not exist. The point model with 1 and 3 samples a pixel is always among the rows.

    Args:
        fabric: a fabric, or an argument of `load_fabric`.
        models: names, such as "point" and "neural".
        scenes: some of `loomlight.mitsuba.measured_scenes.MEASURED_SCENES`.
        size, reference_samples: of the pictures.
        command: recorded in table.json.
        progress: called with (name of the phase, steps done, steps in all).
        row: called with a line of figures of each scene when it is measured, then with one of the queries.

    Raises:
        InputError: an unknown model or scene, a fabric that cannot be read, a folder that cannot be written.
    """
    chosen = list(dict.fromkeys(models))
    require_models(chosen)
    require_scenes(scenes)
    cloth = fabric if isinstance(fabric, Fabric) else load_fabric(fabric)
    with discarding_empty(folder):
        target = prepared_folder(folder)

        def step(what: str) -> Callable[[int, int], None]:
            return lambda done, total: progress(what, done, total) if progress is not None else None

        baked, comparison = BakedModels(), Comparison(target)
        record = provenance(command, Path(__file__).parent)
        done: list[SceneResult] = []
        sections: list[Section] = []

        def keep(scene: SceneResult) -> None:
            done.append(scene)
            sections.append(_section(target, scene, reference_samples))
            comparison.tables = image_tables(done)
            comparison.refused.update(scene.refused)
            _write(comparison, sections, cloth, size, reference_samples, record)
            errors = (f"{name} {picture.error.flip:.4f}" for name, picture in scene.pictures.items())
            row(f"{scene.name}, FLIP: {'; '.join(errors)}")

        run_image_benchmark(
            chosen,
            [cloth, fabric_from_text(_PARTNER)],
            make=baked.make,
            scenes=scenes,
            size=size,
            reference_samples=reference_samples,
            progress=step("pictures"),
            finished=keep,
        )
        able = [name for name in chosen if name not in comparison.refused]
        queries = _query_tables(cloth, able, baked, step("queries"))
        comparison.tables = [*comparison.tables, *queries]
        _write(comparison, sections, cloth, size, reference_samples, record)
        row(_query_row(queries[0]))
        return comparison


def _query_row(table: Table) -> str:
    """The overall error of each model, or why there is none."""
    errors = (f"{name} {cells[0]:.4f}" for name, cells in table.rows.items() if isinstance(cells[0], float))
    return f"queries, nMAE: {'; '.join(errors)}" if table.rows else table.note


def require_models(models: Sequence[str]) -> None:
    """Raises InputError unless at least one model is named and all exist."""
    if not models:
        raise InputError(f"No model is given: name some of {', '.join(model_names())}.")
    for name in models:
        require_model_name(name)


def prepared_folder(folder: str | os.PathLike[str]) -> Path:
    """The folder, created if it does not exist.

    Raises:
        InputError: it is a file, or cannot be made or written.
    """
    target = Path(folder)
    try:
        target.mkdir(exist_ok=True)
        (target / "pictures").mkdir(exist_ok=True)
    except FileExistsError as error:
        raise InputError(f"{target} holds a file where a folder is needed; give another folder.") from error
    except FileNotFoundError as error:
        raise InputError(f"{target}: the folder {target.parent} does not exist; make it first.") from error
    except (OSError, ValueError) as error:
        raise InputError(f"{str(target)[:80]!r} cannot be made a folder: {error}.") from error
    if not os.access(target / "pictures", os.W_OK):
        raise InputError(f"{target}: this folder cannot be written to.")
    return target


def _query_tables(
    cloth: Fabric,
    models: Sequence[str],
    baked: BakedModels,
    progress: Callable[[int, int], None],
) -> list[Table]:
    """The query benchmark of this fabric."""
    predictors = {name: model_predictor(partial(baked.make, name)) for name in models}
    appearance = cloth.appearance()
    threads = [*appearance.warp.diffuse_reflect, *appearance.weft.diffuse_reflect]
    own = HeldOut(cloth.name, cloth, unseen_weave=True, coloured=len({tuple(row) for row in threads}) > 2)
    try:
        found = run_query_benchmark(
            predictors, [own], pairs=_PAIRS, footprints=_FOOTPRINTS, progress=progress
        )
    except InputError as error:
        # Long repeats are too large for slices; there are still pictures.
        return [Table("Query benchmark", [], note=f"There is none of this fabric. {error}")]
    tables = [_titled(table, f"{table.title}, {cloth.name}") for table in found.tables()[:3]]
    return [model_table(cloth, found, baked), *tables]


def _titled(table: Table, title: str) -> Table:
    """The table of one fabric: without empty columns and those of kinds of weaves."""
    cells = list(zip(*table.rows.values(), strict=True))
    is_shared = [name not in WEAVES for name in table.columns]
    shown_columns = [k for k, column in enumerate(cells) if is_shared[k] and not all(map(_missing, column))]
    rows = {name: [row[index] for index in shown_columns] for name, row in table.rows.items()}
    return Table(title, [table.columns[index] for index in shown_columns], rows, table.note, table.digits)


def _missing(cell: Cell) -> bool:
    return cell is None or (isinstance(cell, float) and math.isnan(cell))


def _write(
    comparison: Comparison,
    sections: list[Section],
    cloth: Fabric,
    size: tuple[int, int],
    samples: int,
    record: dict[str, str],
) -> None:
    """Writes the table, the page last; pictures are there: a page never links to missing files."""
    protocol = {
        "size": list(size),
        "reference_samples": samples,
        "light": "one directional light, direct light only",
        "filter": "box",
        "exposure": 0,
        "flip": "LDR, 67 pixels a degree, pixels wholly on one piece of cloth",
    }
    content = {
        "schema": _SCHEMA,
        "fabric": cloth.name,
        "fabric_file": cloth.to_toml(),
        **record,
        "protocol": protocol,
        "refused": comparison.refused,
        "tables": [table.to_dict() for table in comparison.tables],
    }
    write_json(comparison.folder / "table.json", content)
    picks, ends = cloth.draft.drawdown.shape
    facts = {
        "Draft": f"{ends} ends × {picks} picks",
        "Repeat": "{:.3g} × {:.3g} mm".format(*cloth.repeat_mm),
        "Pictures": f"{size[0]} × {size[1]} pixels, reference {samples} samples a pixel",
        "Light": "one directional light, direct light only, box filter, exposure 0",
        "Made with": f"{record['command']}, sources {record['sources']}, {record['machine']}",
    }
    report = Report(cloth.name, facts, comparison.refused, comparison.tables, sections)
    with replacing(comparison.folder / "index.html") as temporary:
        temporary.write_text(report_html(report), encoding="utf-8")


def _section(folder: Path, scene: SceneResult, samples: int) -> Section:
    stem = _file_name(scene.name)
    write_image(folder / "pictures" / f"{stem}.png", scene.reference)
    shown = Figure(f"reference, {samples} spp", f"pictures/{stem}.png", None, f"{scene.seconds:.3g} s")
    figures = [shown]
    for name, picture in scene.pictures.items():
        file = f"{stem}-{_file_name(name)}"
        write_image(folder / "pictures" / f"{file}.png", picture.linear)
        write_pixels(folder / "pictures" / f"{file}-flip.png", picture.error.flip_picture)
        figures.append(
            Figure(
                name,
                f"pictures/{file}.png",
                f"pictures/{file}-flip.png",
                f"FLIP {picture.error.flip:.4f} · MSE {picture.error.mse:.2e} · {picture.seconds:.3g} s",
            )
        )
    return Section(scene.name, f"{scene.yarns_per_pixel:g} yarns a pixel", figures)


def _file_name(text: str) -> str:
    return re.sub(r"[^a-z0-9]+", "-", text.lower()).strip("-")


# ------------------------------------------------------------------------------------ all models in one table
# All models of one fabric in one table: error by band, samples to equal error, cost, size, time to bake.


COLUMNS = (
    "nMAE",
    *BANDS,
    "point samples of equal error",
    "multiply-adds",
    "bytes fetched",
    "bytes of the .loom",
    "seconds to bake",
)


@dataclass(frozen=True)
class Baking:
    """What it took to make a model.

    Attributes:
        seconds: of processor time, all threads; of trained models the training.
        size: bytes of the model's `.loom`.
    """

    seconds: float
    size: int


@dataclass
class BakedModels:
    """Models by name and fabric; those that are trained are made once, however many scenes show them.

    Attributes:
        bakings: what each model took, by its name and the fabric's.
    """

    bakings: dict[tuple[str, str], Baking] = field(default_factory=dict)
    _trained: dict[tuple[str, int], tuple[Fabric, Model]] = field(default_factory=dict)

    def make(self, name: str, fabric: Fabric) -> Model:
        """The model of a fabric.

        Raises:
            InputError: no such model, or one that does not take the fabric.
            MissingDependencyError: a package that it needs is missing.
        """
        key = name, id(fabric)
        if key in self._trained:
            return self._trained[key][1]
        start = time.process_time()
        model = make_model(name, fabric)
        seconds = time.process_time() - start
        if (name, fabric.name) not in self.bakings:
            self.bakings[name, fabric.name] = Baking(seconds, _loom_size(model))
        if model_class(name).trains:
            # The fabric is kept too, so that no other one gets its id.
            self._trained[key] = fabric, model
        return model


def model_table(fabric: Fabric, benchmark: QueryBenchmark, baked: BakedModels) -> Table:
    """A row for each model that was baked, from a query benchmark of that fabric alone.

    Samples of equal error are those of the point model over the footprint whose nMAE is the model's, between
    and beyond 1, 3 and 16 on logarithmic scales.
    """
    note = (
        f"{fabric.name}, {benchmark.queries} queries of grey reflection; processor seconds, the first "
        "time in a process; kernels that a model compiles when it is first rendered are in no column."
    )
    table = Table("All models", list(COLUMNS), note=note)
    counts = [count for count in MONTE_CARLO if samples_name(count) in benchmark.rows]
    errors = [benchmark.rows[samples_name(count)].metric("reflection") for count in counts]
    for name, row in benchmark.rows.items():
        baking = baked.bakings.get((name, fabric.name))
        if baking is None:
            continue
        error = row.metric("reflection")
        equal: Cell = samples_for(error, counts, errors) if len(counts) > 1 and error > 0 else None
        cells: list[Cell] = [error, *(row.metric("reflection", band) for band in BANDS)]
        table.rows[name] = [*cells, equal, *(row.cost or (None, None)), baking.size, baking.seconds]
    return table


def _loom_size(model: Model) -> int:
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "model.loom"
        write_loom(file, model.to_loom())
        return file.stat().st_size
