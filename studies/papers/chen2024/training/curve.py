"""The learning curve of a training: `curve.csv` beside its checkpoint, rows at steps a tenth apart.

    step,loss,nmae
    1042,0.31415,0.48213

The loss is the running mean that the checkpoint keeps; nMAE is that of reflection at grey albedos (as of the
query benchmark) over a few queries of materials that no training has. Both depend on the step and the weights
alone. So a resumed training goes on with the rows before its checkpoint, and ends with the same file.
"""

from __future__ import annotations

import csv
import math
from collections.abc import Callable
from dataclasses import astuple, dataclass, fields
from pathlib import Path

from loomlight.core.errors import InputError
from loomlight.core.files import replacing

NAME = "curve.csv"
_FIRST, _RATIO = 10, 1.1


@dataclass(frozen=True)
class CurvePoint:
    """A row.

    Attributes:
        step: steps done.
        loss: running mean.
        nmae: of held-out queries.
    """

    step: int
    loss: float
    nmae: float


class LearningCurve:
    """Writes the curve of a training that reports its steps to it."""

    def __init__(self, path: Path, nmae: Callable[[], float]) -> None:
        """
        Args:
            nmae: of the network as it is.
        """
        self._path, self._nmae = path, nmae
        self._points: list[CurvePoint] | None = None

    def __call__(self, done: int, total: int, loss: float) -> None:
        """Adds a row if one is due after step `done` of `total`.

        Raises:
            InputError: the file of an earlier run is damaged.
        """
        if self._points is None:
            before = read_curve(self._path) if self._path.exists() else []
            # What a killed run wrote after its last checkpoint is found again.
            self._points = [point for point in before if point.step < done]
        if not (_is_due(done) or done == total):
            return
        self._points.append(CurvePoint(done, loss, self._nmae()))
        with replacing(self._path) as temporary, temporary.open("w", newline="", encoding="utf-8") as file:
            rows = csv.writer(file, lineterminator="\n")
            rows.writerow(field.name for field in fields(CurvePoint))
            rows.writerows(map(astuple, self._points))


def _is_due(step: int) -> bool:
    """Whether a power of the ratio lies between the step before and this one."""
    return step >= _FIRST and math.floor(math.log(step, _RATIO)) != math.floor(math.log(step - 1, _RATIO))


def read_curve(path: Path) -> list[CurvePoint]:
    """The rows of a curve.

    Raises:
        InputError: no such file, or none of this form.
    """
    try:
        with path.open(newline="", encoding="utf-8") as file:
            return [
                CurvePoint(int(row["step"]), float(row["loss"]), float(row["nmae"]))
                for row in csv.DictReader(file)
            ]
    except (OSError, UnicodeDecodeError, KeyError, TypeError, ValueError) as error:
        raise InputError(f"{path} is no learning curve of a training ({error}); remove it.") from error
