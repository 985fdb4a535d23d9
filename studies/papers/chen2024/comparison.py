"""Figures 1, 4, 5 and 6: the network against the point model at 1 and 3 samples and at equal time.

The paper's columns without NeuMIP's, and with 3 samples everywhere. The
reference has 256 samples a pixel as the paper's has; its own noise is part of every error.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from loomlight.evaluation.metrics import PictureError, picture_error
from loomlight.evaluation.table import Table
from loomlight.fabric.fabric import Fabric
from loomlight.mitsuba.measured_scenes import MeasuredShot
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
from studies.papers.chen2024.stage import NetworkSettings, Stage

_COLUMNS = ("point, 1 spp", "point, 3 spp", "point, equal time", "neural, 1 spp", "reference")
_METRICS = ("MSE", "FLIP", "seconds", "samples")
_TRANSLUCENT = Look(("#f0d9a8", "#f6efe0"), (0.35, 0.35), (0.6, 0.6), translucency=0.6)


@dataclass(frozen=True)
class PatternSettings(NetworkSettings):
    """Of figures of one pattern after another."""

    patterns: str = names(",".join(SEEN), "Patterns that are shown.", (*SEEN, *UNSEEN))


def many(settings: NetworkSettings, run: Run) -> Found:
    """Figure 1: many fabrics in one picture."""
    fabrics = [*seen_fabrics(), *unseen_fabrics()]
    return compared(
        "chen2024 figure 1: nine fabrics, one network",
        settings,
        run,
        NINE,
        [(", ".join(fabric.name for fabric in fabrics), fabrics)],
    )


def training_patterns(settings: PatternSettings, run: Run) -> Found:
    """Figure 4: the seven patterns of the training set."""
    return _one_by_one("chen2024 figure 4: patterns of the training set", settings, run)


def unseen_patterns(settings: PatternSettings, run: Run) -> Found:
    """Figure 5: a twill that is in no training set."""
    return _one_by_one("chen2024 figure 5: a pattern that no training has seen", settings, run)


def _one_by_one(title: str, settings: PatternSettings, run: Run) -> Found:
    """Each fabric draped, one picture each."""
    fabrics = [pattern_fabric(name) for name in listed(settings.patterns)]
    return compared(title, settings, run, DRAPE, [(fabric.name, [fabric]) for fabric in fabrics])


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
) -> Found:
    """Two rows for each picture, by its label and its fabrics: the picture and its FLIP map."""
    shown = PictureTable(title, _COLUMNS)
    tables = {metric: Table(metric, list(_COLUMNS[:-1])) for metric in _METRICS}
    for number, (label, fabrics) in enumerate(cloths):
        reference, measured = _measure(settings.stage(shot, *fabrics))
        pictures = [*(each.picture for each in measured), reference]
        captions = [*(_caption(each) for each in measured), _cost(reference)]
        tiles = [
            Tile(on_display(each.linear), caption) for each, caption in zip(pictures, captions, strict=True)
        ]
        shown.add(label, tiles, [each.error for each in measured])
        tables["MSE"].rows[label] = [each.error.mse for each in measured]
        tables["FLIP"].rows[label] = [each.error.flip for each in measured]
        tables["seconds"].rows[label] = [each.picture.seconds for each in measured]
        tables["samples"].rows[label] = [each.picture.samples for each in measured]
        run.report(number + 1, len(cloths))
    note = (
        f"{shot.yarns:g} yarns a pixel, one directional light, direct light only, box filter; reference: the "
        f"point model with {settings.spp} samples a pixel. MSE of linear RGB and mean LDR-FLIP over the "
        "cloth; seconds of a second picture. Below each picture its FLIP map: dark is alike."
    )
    return shown.found(settings.figures(*tables.values()), note)


def _measure(stage: Stage) -> tuple[Rendered, list[_Measured]]:
    """The reference, and the pictures of the other columns."""
    reference = stage.reference()
    neural, as_long = stage.equal_time()
    pictures = (stage.point(1), stage.point(3), as_long, neural)
    return reference, [
        _Measured(picture, picture_error(picture.linear, reference.linear, stage.counted))
        for picture in pictures
    ]


def _cost(picture: Rendered) -> str:
    return f"{picture.samples} spp, {picture.seconds:.2f} s"


def _caption(measured: _Measured) -> str:
    return f"{error_caption(measured.error)}, {_cost(measured.picture)}"


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
        "seven seen patterns: 1 and 3 samples, equal time, the network",
        PatternSettings(),
        training_patterns,
        stands_on=_STANDS_ON,
        small={**_SMALL, "patterns": "plain"},
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
