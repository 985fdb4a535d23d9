"""Figures 1, 4, 5 and 6: the network against the point model at 1 and 3 samples and at equal time.

The paper's columns, with 3 samples everywhere. Equal time is of processor seconds on one thread, kernels
compiled. The reference has 256 samples a pixel as the paper's has; its own noise is part of every error. In
figure 4 NeuMIP stands beside them, trained for each fabric by its default recipe, a minute or two each.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from loomlight.core.settings import setting
from loomlight.evaluation.metrics import PictureError, picture_error
from loomlight.evaluation.table import Cell, Table
from loomlight.fabric.fabric import Fabric
from loomlight.mitsuba import material_bsdf
from loomlight.mitsuba.measured_scenes import MeasuredShot
from loomlight.mitsuba.scenes import BsdfFactory
from loomlight.models.interface import Model
from loomlight.models.registry import make_model, model_from_loom, options_of
from loomlight.models.texture.neumip import NeumipOptions
from loomlight.sources.loom_file import write_loom
from studies.harness.record import make_folder
from studies.harness.study import Found, Run, Study, listed, names, on_display
from studies.instruments.renders import Rendered
from studies.instruments.sheet import PictureTable, Tile, error_caption
from studies.papers.chen2024.fabrics import (
    SEEN,
    UNSEEN,
    Look,
    paper_fabric,
    pattern_fabric,
    seen_fabrics,
    unseen_fabrics,
)
from studies.papers.chen2024.shots import BACKLIT, DRAPE, NINE
from studies.papers.chen2024.stage import NetworkSettings

_FEW = (1, 3)
_EQUAL, _NEURAL, _NEUMIP = "point, equal time", "neural, 1 spp", "neumip, 1 spp"
_POINTS = tuple(f"point, {count} spp" for count in _FEW)
_COLUMNS = (*_POINTS, _EQUAL, _NEURAL)
# For each fabric, BSDFs beside the network's.
Others = dict[str, Callable[[Fabric], BsdfFactory]]
_TRANSLUCENT = Look(("#f0d9a8", "#f6efe0"), (0.35, 0.35), (0.6, 0.6), translucency=0.6)


@dataclass(frozen=True)
class PatternSettings(NetworkSettings):
    """Of figures of one pattern after another."""

    patterns: str = names(",".join(SEEN), "Patterns that are shown.", (*SEEN, *UNSEEN))


@dataclass(frozen=True)
class SeenSettings(PatternSettings):
    """Of figure 4."""

    neumip: str = setting(
        "preview",
        "Quality of NeuMIP, which is trained for each fabric and kept in the folder of runs.",
        choices=("off", "preview", "full"),
    )


def many(settings: NetworkSettings, run: Run) -> Found:
    """Figure 1: many fabrics in one picture."""
    fabrics = [*seen_fabrics(), *unseen_fabrics()]
    return compared(
        "chen2024 figure 1: nine fabrics, one network",
        settings,
        run,
        NINE,
        [("nine fabrics", fabrics)],
    )


def training_patterns(settings: SeenSettings, run: Run) -> Found:
    """Figure 4: the seven patterns of the training set, and NeuMIP beside.

    Raises:
        InputError: the folder of runs cannot be written to.
        MissingDependencyError: PyTorch is missing, where NeuMIP is to be trained.
    """
    title = "chen2024 figure 4: patterns of the training set"
    if settings.neumip == "off":
        return _one_by_one(title, settings, run)
    return _one_by_one(
        title,
        settings,
        run,
        {_NEUMIP: lambda fabric: material_bsdf(trained_neumip(fabric, settings.neumip, run.runs))},
    )


def unseen_patterns(settings: PatternSettings, run: Run) -> Found:
    """Figure 5: a twill that is in no training set."""
    return _one_by_one("chen2024 figure 5: a pattern that no training has seen", settings, run)


def _one_by_one(title: str, settings: PatternSettings, run: Run, others: Others | None = None) -> Found:
    """Each fabric draped, one picture each."""
    fabrics = [pattern_fabric(name) for name in listed(settings.patterns)]
    return compared(title, settings, run, DRAPE, [(fabric.name, [fabric]) for fabric in fabrics], others)


def trained_neumip(fabric: Fabric, quality: str, runs: Path) -> Model:
    """NeuMIP of a fabric, from the folder of runs, or trained and kept there."""
    options = options_of("neumip", {"quality": quality})
    assert isinstance(options, NeumipOptions)
    file = runs / "neumip" / options.settings(is_fabric=True).identity(fabric)[:16] / "model.loom"
    if file.is_file():
        return model_from_loom(file)
    make_folder(file.parent)
    model = make_model("neumip", fabric, options)
    write_loom(file, model.to_loom())
    return model


def backlit(settings: NetworkSettings, run: Run) -> Found:
    """Figure 6: plain cloth against the light, with the BTDF, and without it."""
    opaque = replace(_TRANSLUCENT, translucency=0.0)
    return compared(
        "chen2024 figure 6: transmission, the light behind the cloth",
        settings,
        run,
        BACKLIT,
        [
            ("plain, BRDF and BTDF", [paper_fabric("plain", _TRANSLUCENT)]),
            ("plain, BRDF alone", [paper_fabric("plain", opaque)]),
        ],
    )


@dataclass(frozen=True, eq=False)
class _Measured:
    picture: Rendered
    error: PictureError


def compared(
    title: str,
    settings: NetworkSettings,
    run: Run,
    shot: MeasuredShot,
    cloths: Sequence[tuple[str, Sequence[Fabric]]],
    others: Others | None = None,
) -> Found:
    """Two rows for each picture, by its label and its fabrics: the picture and its FLIP map.

    Args:
        others: further columns, by their headings.
    """
    others = others or {}
    columns = (*_COLUMNS, *others)
    shown = PictureTable(title, (*columns, "reference"))
    found: dict[str, dict[str, _Measured]] = {}
    for number, (label, fabrics) in enumerate(cloths):
        stage = settings.stage(shot, *fabrics)
        reference = stage.reference()
        pictures = stage.pictures(_FEW, *([make(fabric) for fabric in fabrics] for make in others.values()))
        measured = [
            _Measured(picture, picture_error(picture.linear, reference, stage.counted))
            for picture in pictures
        ]
        tiles = [Tile(on_display(each.picture.linear), _caption(each)) for each in measured]
        tiles.append(Tile(on_display(reference), f"{settings.spp} spp"))
        shown.add(label, tiles, [each.error for each in measured])
        found[label] = dict(zip(columns, measured, strict=True))
        run.report(number + 1, len(cloths))
    note = (
        f"{shot.yarns:g} yarns a pixel, one directional light, direct light only, box filter; reference: the "
        f"point model with {settings.spp} samples a pixel. MSE of linear RGB and mean LDR-FLIP over the "
        "cloth; processor seconds of a picture on one thread, kernels compiled, the least of three. Below "
        "each picture its FLIP map: dark is alike."
    )
    return shown.found(settings.figures(*_tables(found, columns)), note)


def _caption(measured: _Measured) -> str:
    picture = measured.picture
    return f"{error_caption(measured.error)}, {picture.samples} spp, {picture.cpu_seconds:.2f} s"


# ----------------------------------------------------------------------------------------------------- tables


def _tables(found: dict[str, dict[str, _Measured]], columns: Sequence[str]) -> list[Table]:
    def by_column(title: str, cell: Callable[[_Measured], Cell]) -> Table:
        rows = {label: [cell(row[column]) for column in columns] for label, row in found.items()}
        return Table(title, list(columns), rows)

    mse, flip = by_column("MSE", lambda each: each.error.mse), by_column("FLIP", lambda each: each.error.flip)
    seconds = by_column("Processor seconds", lambda each: each.picture.cpu_seconds)
    against = Table("Equal processor time", list(_AGAINST), note=_AGAINST_NOTE)
    for label, row in found.items():
        point, neural = row[_EQUAL], row[_NEURAL]
        ratios = point.error.mse / neural.error.mse, point.error.flip / neural.error.flip
        against.rows[label] = [
            point.picture.samples,
            point.picture.cpu_seconds,
            neural.picture.cpu_seconds,
            *ratios,
            _nearer_by(*ratios),
        ]
    return [_claim(found, columns), against, mse, flip, seconds]


_AGAINST = (
    "samples",
    "seconds, `point`",
    "seconds, `neural`",
    "MSE, `point` / `neural`",
    "FLIP, `point` / `neural`",
    "`neural` is nearer by",
)
_AGAINST_NOTE = (
    "`point` with as many samples a pixel as take the processor time of `neural` with one. Above 1 `neural` "
    "is nearer to the reference."
)


def _nearer_by(mse_ratio: float, flip_ratio: float) -> str:
    """The metrics by which the network is nearer, from ratios of errors."""
    names = [name for name, ratio in (("MSE", mse_ratio), ("FLIP", flip_ratio)) if ratio > 1]
    return " and ".join(names) or "neither"


def _claim(found: dict[str, dict[str, _Measured]], columns: Sequence[str]) -> Table:
    """The figure in a sentence, and what it says by the paper's terms: MSE against few samples."""

    def ratios(column: str, metric: Callable[[PictureError], float]) -> list[float]:
        return [metric(row[column].error) / metric(row[_NEURAL].error) for row in found.values()]

    def mse(error: PictureError) -> float:
        return error.mse

    def flip(error: PictureError) -> float:
        return error.flip

    samples = [row[_EQUAL].picture.samples for row in found.values()]
    ours = (
        f"against `point` at equal processor time ({_samples(_span(samples, '{:d}'))}) "
        f"nearer by MSE {_of(ratios(_EQUAL, mse))}, by FLIP {_of(ratios(_EQUAL, flip))}; "
        f"`point` / `neural`: MSE {_span(ratios(_EQUAL, mse))}, FLIP {_span(ratios(_EQUAL, flip))}"
    )
    if _NEUMIP in columns:
        ours += (
            f"; against `neumip` nearer by MSE {_of(ratios(_NEUMIP, mse))}, "
            f"by FLIP {_of(ratios(_NEUMIP, flip))}"
        )
    terms = ", ".join(
        f"than {_samples(str(count))} {_of(ratios(column, mse))}"
        for count, column in zip(_FEW, _POINTS, strict=True)
    )
    return Table("Claim", ["found"], {"ours": [ours], "by the paper's terms": [f"MSE lower {terms}"]})


def _of(ratios: Sequence[float]) -> str:
    """How many ratios of errors are above 1."""
    return f"in {sum(ratio > 1 for ratio in ratios)} of {len(ratios)}"


def _samples(count: str) -> str:
    return "1 sample" if count == "1" else f"{count} samples"


def _span(values: Sequence[float], form: str = "{:.2g}") -> str:
    """The least and the greatest, or one number where they read alike."""
    least, greatest = form.format(min(values)), form.format(max(values))
    return least if least == greatest else f"{least} to {greatest}"


_STANDS_ON = ("point", "neural", "picture")
_SMALL = {"size": (24, 16), "spp": 4}
STUDIES = (
    Study(
        "papers/chen2024/fig1",
        "nine fabrics in one picture, one network",
        NetworkSettings(),
        many,
        stands_on=_STANDS_ON,
        small=_SMALL,
    ),
    Study(
        "papers/chen2024/fig4",
        "seven seen patterns: 1 and 3 samples, equal time, the network, NeuMIP",
        SeenSettings(),
        training_patterns,
        stands_on=_STANDS_ON,
        small={**_SMALL, "patterns": "plain", "neumip": "off"},
    ),
    Study(
        "papers/chen2024/fig5",
        "twills that no training has seen, the same columns",
        PatternSettings(patterns=",".join(UNSEEN)),
        unseen_patterns,
        stands_on=_STANDS_ON,
        small={**_SMALL, "patterns": "twill 4×4"},
    ),
    Study(
        "papers/chen2024/fig6",
        "plain cloth against the light, with and without the BTDF",
        NetworkSettings(),
        backlit,
        stands_on=_STANDS_ON,
        small=_SMALL,
    ),
)
