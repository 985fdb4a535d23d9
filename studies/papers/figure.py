"""What a figure is once it is made: a sheet to look at, single pictures, and figures."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import linear_to_srgb
from loomlight.evaluation.metrics import PictureError
from loomlight.evaluation.table import Table
from studies.papers.setting import SAMPLES, Setting

Pixels = NDArray[np.uint8]


@dataclass(frozen=True, eq=False)
class Evidence:
    """A figure or a table of a paper, made here.

    Attributes:
        sheet: everything on one page, sRGB [height, width, 3].
        pictures: single ones by their file's stem, sRGB [height, width, 3].
        tables: all that was measured.
    """

    sheet: Pixels
    pictures: dict[str, Pixels]
    tables: list[Table]


@dataclass(frozen=True)
class Item:
    """What can be reproduced.

    Attributes:
        name: such as "chen2024/fig4".
        shows: one line for people.
        make: makes it.
        samples: a pixel, of its references.
        model: of figures that show any model: the paper's own; None where the network is shown.
    """

    name: str
    shows: str
    make: Callable[[Setting], Evidence]
    samples: int = SAMPLES
    model: str | None = None

    @property
    def stem(self) -> str:
        """The beginning of its files' names; figures of several papers may lie in one folder."""
        paper, _, figure = self.name.rpartition("/")
        return figure if paper == "chen2024" else f"{paper}-{figure}"


def on_display(linear: NDArray[np.float32]) -> Pixels:
    """Linear RGB [height, width, 3] as 8-bit sRGB, exposure 0."""
    return np.rint(255 * linear_to_srgb(np.clip(np.nan_to_num(linear), 0, 1))).astype(np.uint8)


def error_caption(error: PictureError) -> str:
    """What stands below a picture of its error."""
    return f"MSE {error.mse:.1e}, FLIP {error.flip:.3f}"
