"""zeltner2024's supplemental: Tables 1 to 4 (ablation), 5 to 11 (quality), and figure 5 (8 channels).

The ablation is trained by the paper's recipe, at a tenth of its steps, with its inputs of the decoder; the
qualities have half-vector features too, as the model has them by default. A table of our own says what frames
gain with these features and without them.

A training that is stopped goes on from its last checkpoint when the same command runs again, and one that is
done lies in the folder of runs.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from loomlight.evaluation.table import Table
from loomlight.mitsuba import choose_variant
from loomlight.mitsuba.measured_scenes import MeasuredScene
from loomlight.mitsuba.scenes import BsdfFactory
from loomlight.models.texture.settings import DECODERS, FEATURES, RUNGS
from loomlight.sources.material import Material
from studies.harness.study import Figures, Found, Run, Study, on_display, stored_tables, with_tables
from studies.instruments.sheet import PictureTable, Tile
from studies.papers.zeltner2024.analytic_baseline import analytic_factory
from studies.papers.zeltner2024.stage import (
    METRICS,
    SHORT_RECIPE,
    ShownError,
    StageSettings,
    metric_table,
    model_factory,
    reference_factory,
    six_errors,
    stage_picture,
    stage_scene,
    trained,
)
from studies.papers.zeltner2024.two_normals import TWO_NORMALS

# As the supplemental heads its columns.
_RUNG_NAMES = {"mlp": "Vanilla MLP", "encoder": "with encoder", "frames": "with frame transform"}
# Mean FLIP of Tables 1, 2, 3 and 4, in the order of the rungs: the paper's materials and scenes.
_PAPER_RUNGS = {
    "inkwell body": (0.2589, 0.1921, 0.0703),
    "teapot ceramic": (0.3343, 0.2552, 0.1362),
    "slicer blade": (0.1381, 0.1268, 0.0774),
    "slicer handle": (0.2245, 0.2083, 0.0423),
}
# Means over Tables 5 to 11 of mean FLIP, in the order of the decoders.
_PAPER_FLIP = (0.1087, 0.0551, 0.0444)
_ANALYTIC = "8-channel BRDF"
# Materials of the ablation: those of two normal maps, which frames are for, and ceramic beside the paper's.
_OF_FRAMES = ",".join((*TWO_NORMALS, "glazed-ceramic"))


def ablation(settings: StageSettings, run: Run) -> Found:
    """Tables 1 to 4: a plain network, with the encoder, and with learned frames."""
    columns = [_RUNG_NAMES[rung] for rung in RUNGS]
    return _compared(
        settings,
        run,
        "zeltner2024 tables 1 to 4: ablation",
        ("whole",),
        columns,
        lambda source: {
            _RUNG_NAMES[rung]: model_factory(trained(source, settings, run.runs, rung=rung, features="none"))
            for rung in RUNGS
        },
        Table("Mean FLIP in the paper", columns, {name: [*row] for name, row in _PAPER_RUNGS.items()}),
    )


def frames(settings: StageSettings, run: Run) -> Found:
    """What learned frames gain of two materials of two normal maps each, with and without features."""
    columns = {
        f"{_RUNG_NAMES[rung]}, {'features' if features == FEATURES[0] else 'none'}": (rung, features)
        for features in reversed(FEATURES)
        for rung in RUNGS[1:]
    }
    return _compared(
        settings,
        run,
        "frames of materials of two normal maps",
        ("whole",),
        list(columns),
        lambda source: {
            column: model_factory(trained(source, settings, run.runs, rung=rung, features=features))
            for column, (rung, features) in columns.items()
        },
    )


def quality(settings: StageSettings, run: Run) -> Found:
    """Tables 5 to 11: three decoders in a close and a far view."""
    columns = [decoder.replace("x", "×") for decoder in DECODERS]
    return _compared(
        settings,
        run,
        "zeltner2024 tables 5 to 11: three decoders",
        ("close", "far"),
        columns,
        lambda source: {
            decoder.replace("x", "×"): model_factory(trained(source, settings, run.runs, decoder))
            for decoder in DECODERS
        },
        Table("Mean FLIP in the paper", columns, {"mean of its views": [*_PAPER_FLIP]}),
    )


def whole(settings: StageSettings, run: Run) -> Found:
    """The default network alone, as it is baked: whole spheres."""
    return _compared(
        settings,
        run,
        "whole spheres by the default network",
        ("whole",),
        ["2×32"],
        lambda source: {"2×32": model_factory(trained(source, settings, run.runs))},
    )


def eight_channels(settings: StageSettings, run: Run) -> Found:
    """Figure 5: the model beside a simple analytic BRDF with as many channels."""
    return _compared(
        settings,
        run,
        "zeltner2024 supplemental figure 5: an analytic BRDF of 8 channels",
        ("whole",),
        [_ANALYTIC, "2×32"],
        lambda source: {
            _ANALYTIC: analytic_factory(source, settings.resolution, settings.steps),
            "2×32": model_factory(trained(source, settings, run.runs)),
        },
    )


def _compared(
    settings: StageSettings,
    run: Run,
    title: str,
    views: tuple[str, ...],
    columns: list[str],
    factories: Callable[[Material], dict[str, BsdfFactory]],
    paper: Table | None = None,
) -> Found:
    """Pictures and tables of materials in some views.

    Args:
        factories: from a material to functions that make its BSDFs, by the heading of their column.
    """
    choose_variant()
    shown = PictureTable(title, [*columns, "reference"])
    tables: list[Table] = []
    means: dict[str, list[tuple[float, ...]]] = {column: [] for column in columns}
    sources = settings.sources()
    done, total = 0, len(sources) * len(views)
    for source in sources:
        made = factories(source)
        for view in views:
            label = f"{source.name}, {view}"
            reference_scene = stage_scene(reference_factory(source), view, settings)
            reference = stage_picture(reference_scene, settings, 2)
            pictures = {
                column: stage_picture(stage_scene(factory, view, settings), settings)
                for column, factory in made.items()
            }
            errors = {
                column: six_errors(picture, reference, reference_scene.counted)
                for column, picture in pictures.items()
            }
            tables.append(metric_table(label, errors))
            for column, error in errors.items():
                means[column].append(error.metrics)
            tiles = [Tile(on_display(each), _caption(errors[column])) for column, each in pictures.items()]
            maps = [error.picture for error in errors.values()]
            shown.add(label, [*tiles, Tile(on_display(reference))], maps)
            done += 1
            run.report(done, total)
    floor = _noise_floor(reference_scene, settings)
    summary = Table("Means over all", columns, digits=3)
    for number, metric in enumerate(tables[0].rows):
        summary.rows[metric] = [float(np.mean([row[number] for row in means[c]])) for c in columns]
    steps = "" if settings.steps is None else f", {settings.steps} steps"
    note = (
        f"{settings.spp} samples a pixel of model and reference, textures of {settings.resolution} texels, "
        f"quality {settings.quality}{steps}. Noise alone has a FLIP of {floor:.3f} (last material and view)."
    )
    summary.note = note
    return shown.found(with_tables(summary, *([] if paper is None else [paper]), *tables), note)


def tables_of_materials(figures: Figures) -> list[Table]:
    """FLIP by material and view, and means, before the tables that are stored."""
    stored = stored_tables(figures)
    means = stored[0]
    flip = Table(METRICS[0], means.columns, note=means.note)
    for table in stored[1:]:
        # The paper's has its own materials.
        if METRICS[0] in table.rows:
            flip.rows[table.title] = table.rows[METRICS[0]]
    flip.rows["mean"] = means.rows[METRICS[0]]
    flip.rows["mean absolute error"] = means.rows[METRICS[1]]
    return [flip, *stored]


def _noise_floor(scene: MeasuredScene, settings: StageSettings) -> float:
    """FLIP between two references."""
    one, other = (stage_picture(scene, settings, seed) for seed in (2, 3))
    return six_errors(one, other, scene.counted).metrics[0]


def _caption(error: ShownError) -> str:
    return f"FLIP {error.metrics[0]:.4f}, MAE {error.metrics[1]:.4f}"


_STANDS_ON = ("latent", "picture")
_SMALL = {
    "size": (24, 16),
    "spp": 4,
    "quality": "preview",
    "steps": 6,
    "batch": 256,
    "queries": 4096,
    "resolution": 16,
    "materials": "rough-plastic",
}
STUDIES = (
    Study(
        "papers/zeltner2024/tables1-4",
        "layered materials by the paper's recipe: a plain network, with encoder, with frames",
        StageSettings(**SHORT_RECIPE, materials=_OF_FRAMES),
        ablation,
        tables_of_materials,
        stands_on=_STANDS_ON,
        small=_SMALL,
    ),
    Study(
        "papers/zeltner2024/frames",
        "what frames gain of two normal maps, with half-vector features and without",
        StageSettings(**SHORT_RECIPE, materials=",".join(TWO_NORMALS)),
        frames,
        tables_of_materials,
        stands_on=_STANDS_ON,
        small={**_SMALL, "materials": TWO_NORMALS[0]},
    ),
    Study(
        "papers/zeltner2024/tables5-11",
        "2×16, 2×32 and 3×64, close and from far",
        StageSettings(),
        quality,
        tables_of_materials,
        stands_on=_STANDS_ON,
        small=_SMALL,
    ),
    Study(
        "papers/zeltner2024/whole",
        "whole spheres by the default network",
        StageSettings(),
        whole,
        tables_of_materials,
        stands_on=_STANDS_ON,
        small=_SMALL,
    ),
    Study(
        "papers/zeltner2024/fig5",
        "beside a simple analytic BRDF with 8 channels",
        StageSettings(),
        eight_channels,
        tables_of_materials,
        stands_on=_STANDS_ON,
        small=_SMALL,
    ),
)
