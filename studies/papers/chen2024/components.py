"""Figure 2: the components of the BSDF of a patch over all pairs of directions.

The paper shows matrices, incoming directions across and outgoing ones down, of plain white cloth over a patch
of 205 × 205 texels of a texture whose size it does not give; here the patch is 0.4 of the repeat, about the
repeat's middle. Directions are cells of a grid over the disc of their x and y, row by row.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from loomlight.aggregate.queries import QuerySet
from loomlight.evaluation.metrics import error_sums
from loomlight.evaluation.query_benchmark import Prediction, monte_carlo_predictor
from loomlight.evaluation.table import Table
from loomlight.fabric.fabric import Fabric
from studies.harness.study import Found, Run, Study, on_display
from studies.instruments.sheet import PictureTable, Tile
from studies.papers.chen2024.fabrics import Look, paper_fabric
from studies.papers.chen2024.stage import NetworkSettings, neural_predictor

_WHITE = Look(roughness=(0.3, 0.3), height_scale=(0.6, 0.6), translucency=0.5)
_PATCH = 0.4
_MAX_RADIUS = 0.98
# Heights of the cells of a direction as fractions of the picture's: about 200 directions.
_SIDE_OF_HEIGHT = 1 / 13
_SIDES = {"reflection": 1.0, "transmission": -1.0}
_COLUMNS = ("BSDF", "diffuse, warp", "diffuse, weft", "specular, warp", "specular, weft")


def separated(settings: NetworkSettings, run: Run) -> Found:
    """Figure 2: the BSDF of plain white cloth and its four components, reflection and transmission."""
    fabric = paper_fabric("plain", _WHITE)
    truth = monte_carlo_predictor(settings.spp)
    neural = neural_predictor(settings.network())
    grid = max(4, round(settings.size[1] * _SIDE_OF_HEIGHT))
    pictures = PictureTable("chen2024 figure 2: components of plain white cloth", _COLUMNS)
    table = Table("nMAE of the network by component", list(_COLUMNS))
    for number, (side, sign) in enumerate(_SIDES.items()):
        queries = direction_grid(fabric, grid, sign)
        count = len(queries.views)
        right, guess = (_matrices(predict(fabric, queries), count) for predict in (truth, neural))
        whites = np.quantile(right, 0.99, axis=(1, 2))
        for name, prediction in (("sampled", right), ("neural", guess)):
            shown = [_picture(values, white) for values, white in zip(prediction, whites, strict=True)]
            pictures.add(f"{side}, {name}", [Tile(pixels) for pixels in shown])
        table.rows[side] = [error_sums(p, t).nmae for p, t in zip(guess, right, strict=True)]
        run.report(number + 1, len(_SIDES))
    note = (
        "Light directions across, view directions down, row by row over the disc of their x and y; each "
        f"column of a side is white at its 99th percentile, sampled. A patch of {_PATCH:g} of the repeat, "
        f"{settings.spp} samples."
    )
    return pictures.found(settings.figures(table), note)


def direction_grid(fabric: Fabric, grid: int, side: float) -> QuerySet:
    """All pairs of views and lights of a grid over the disc; `side` is the sign of the lights' z."""
    line = (np.arange(grid) + 0.5) / grid * 2 - 1
    y, x = (part.ravel() for part in np.meshgrid(line, line, indexing="ij"))
    inside = np.hypot(x, y) < _MAX_RADIUS
    x, y = x[inside], y[inside]
    views = np.stack([x, y, np.sqrt(1 - x**2 - y**2)], axis=1)
    count = len(views)
    view, light = (part.ravel() for part in np.indices((count, count)))
    width, height = fabric.repeat_mm
    centres = np.tile(np.array([width, height]) / 2, (count * count, 1, 1))
    sizes = np.full((count * count, 1), _PATCH * np.sqrt(width * height))
    return QuerySet(views * [1, 1, side], views, np.stack([light, view], axis=1), centres, sizes)


def _matrices(prediction: Prediction, count: int) -> NDArray[np.float64]:
    """Values by pair of directions [5 columns, views, lights], 1/sr."""
    assert prediction.means is not None
    # White threads: any channel is the BSDF.
    values = np.concatenate([prediction.colours[:, 0, :1], prediction.means[:, 0, :4]], axis=1)
    return values.T.reshape(len(_COLUMNS), count, count)


def _picture(values: NDArray[np.float64], white: float) -> NDArray[np.uint8]:
    return on_display(np.repeat((values / white)[..., None], 3, axis=2).astype(np.float32))


STUDY = Study(
    "papers/chen2024/fig2",
    "the BSDF of a patch taken apart: R and T, diffuse and specular",
    NetworkSettings(),
    separated,
    stands_on=("point", "neural"),
    small={"size": (32, 40), "spp": 4},
)
