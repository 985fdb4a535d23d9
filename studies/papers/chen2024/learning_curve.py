"""How far a training of chen2024 has come, and where the published number of steps would end.

The curve that `[training] curve = true` keeps beside the checkpoint is fitted by a power law of the steps: a
line of ln nMAE over ln steps, from a share of the steps on. Extrapolated to the end it has the 95 % interval
of a new point of the line. Rows are not independent, and the rate falls at 6/10 and 9/10 of the training,
which a law of its beginning does not know; so the line is fitted from several shares on, and how far these
fits differ says more than the interval of one.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from loomlight.core.errors import InputError
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from studies.harness.study import Figures, Found, Run, Study
from studies.papers.chen2024.training.curve import NAME, CurvePoint, read_curve

# Fits begin at these shares of the steps that were done.
SHARES = (0.03, 0.1, 0.3)
_MIN_POINTS = 5
_SHOWN = 12
# Of a normal distribution, two-sided.
_INTERVAL = 1.96


@dataclass(frozen=True)
class CurveSettings(Settings):
    """Which training, and how far it is extrapolated."""

    training: str = setting("chen2024", "Folder of the training, in the folder of --runs.", metavar="NAME")
    steps: int = setting(3_125_000, "Steps to extrapolate to; the paper's.", low=1, high=10**9)


def power_law(points: Sequence[CurvePoint], steps: int) -> dict[str, float]:
    """The line through ln nMAE over ln steps, and its value at `steps`.

    Returns:
        exponent, its standard error, nMAE at `steps`, and the 95 % interval of a new point there.
    """
    x = np.log([point.step for point in points])
    y = np.log([point.nmae for point in points])
    centre, spread = x.mean(), float(((x - x.mean()) ** 2).sum())
    slope = float(((x - centre) * y).sum() / spread)
    rest = y - y.mean() - slope * (x - centre)
    variance = float((rest**2).sum()) / max(len(points) - 2, 1)
    away = math.log(steps) - centre
    there = float(y.mean() + slope * away)
    error = math.sqrt(variance * (1 + 1 / len(points) + away**2 / spread))
    return {
        "from_step": points[0].step,
        "points": len(points),
        "exponent": -slope,
        "exponent_error": math.sqrt(variance / spread),
        "nmae": math.exp(there),
        "low": math.exp(there - _INTERVAL * error),
        "high": math.exp(there + _INTERVAL * error),
    }


def extrapolated(settings: CurveSettings, run: Run) -> Found:
    """Fits of the curve from several shares of the steps on.

    Raises:
        InputError: no training with a curve in the folder, or too short a one.
    """
    path = run.runs / settings.training / NAME
    if not path.is_file():
        raise InputError(
            f"{path} is missing: make the training with python -m studies.papers.chen2024.training "
            f"studies/papers/chen2024/chen2024.toml -o {path.parent}."
        )
    points = read_curve(path)
    fits = {}
    for share in SHARES:
        used = [point for point in points if point.step >= share * points[-1].step] if points else []
        if len(used) >= _MIN_POINTS:
            fits[f"{share:.0%}"] = power_law(used, settings.steps)
    if not fits:
        raise InputError(f"{path} has {len(points)} rows, too few for a law: train for longer.")
    shown = points[:: max(1, len(points) // _SHOWN)]
    if shown[-1] != points[-1]:
        shown = [*shown, points[-1]]
    run.report(1, 1)
    return Found(
        {
            "steps_done": points[-1].step,
            "steps": settings.steps,
            "curve": [[point.step, point.loss, point.nmae] for point in shown],
            "fits": fits,
        }
    )


def tables(figures: Figures) -> list[Table]:
    """The curve, and the fits."""
    curve = Table("Learning curve", ["loss", "nMAE"])
    curve.rows = {f"{step} steps": [loss, nmae] for step, loss, nmae in figures["curve"]}
    fits = Table(
        f"Power laws, extrapolated to {figures['steps']} steps",
        ["exponent", "± error", "nMAE", "95 %, from", "to"],
    )
    for share, fit in figures["fits"].items():
        columns = ("exponent", "exponent_error", "nmae", "low", "high")
        fits.rows[f"from {share} of {figures['steps_done']} steps on"] = [fit[name] for name in columns]
    return [curve, fits]


STUDY = Study(
    "papers/chen2024/learning_curve",
    "the learning curve of the published network, and its extrapolation",
    CurveSettings(),
    extrapolated,
    tables,
    stands_on=("point",),
)
