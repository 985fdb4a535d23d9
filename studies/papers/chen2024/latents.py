"""Figure 8: latents interpolated and extrapolated between two fabrics, against those of the encoder.

Two latents at 0.2 and 0.8 of a parameter are mixed for 0.3 and 0.6 and extrapolated for 0.9, by the parameter
as the weight; above stands what the encoder makes of the same parameter.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from loomlight.evaluation.metrics import picture_error
from loomlight.evaluation.table import Table
from loomlight.fabric.fabric import Fabric
from studies.harness.study import Found, Run, Study, on_display
from studies.instruments.renders import one_picture
from studies.instruments.scene_edits import SceneEdits
from studies.instruments.sheet import PictureTable, Tile
from studies.papers.chen2024.fabrics import Look, paper_fabric
from studies.papers.chen2024.shots import BALL
from studies.papers.chen2024.stage import NetworkSettings, Stage, neural_bsdf

_PATTERN = "satin 5×5"
_FIRST, _SECOND = 0.2, 0.8
_VALUES = (0.2, 0.3, 0.6, 0.8, 0.9)
_COMPARED = ("encoded against reference", "mixed against reference", "mixed against encoded")
_BASE = Look(("#7a3c48", "#5c2c38"), (0.3, 0.3), (0.6, 0.6), specular=0.8)


@dataclass(frozen=True)
class _Parameter:
    """A parameter that is interpolated.

    Attributes:
        look: the look with a value of it in both families.
    """

    name: str
    symbol: str
    look: Callable[[float], Look]

    def fabric(self, value: float) -> Fabric:
        """The pattern with this value."""
        return paper_fabric(_PATTERN, self.look(value))


_PARAMETERS = (
    _Parameter("roughness", "α", lambda value: replace(_BASE, roughness=(value, value))),
    _Parameter("height", "β", lambda value: replace(_BASE, height_scale=(value, value))),
)


def interpolated(settings: NetworkSettings, run: Run) -> Found:
    """Figure 8: roughness and height field scaling by mixed latents."""
    columns = [f"{value:g}" for value in _VALUES]
    pictures = PictureTable("chen2024 figure 8: latents interpolated and extrapolated", columns)
    tables = {kind: Table(f"FLIP of {kind}", columns) for kind in _COMPARED}
    apart = Table("FLIP between 0.2 and 0.8", ["reference", "encoded"])
    for number, parameter in enumerate(_PARAMETERS):
        stages = [settings.stage(BALL, parameter.fabric(value)) for value in _VALUES]
        linear = {
            "reference": [stage.reference() for stage in stages],
            "encoded": [one_picture(stage.neural_scene(), 1) for stage in stages],
            "mixed": _mixed(stages[0], parameter),
        }
        counted = stages[0].counted
        for kind, table in tables.items():
            one, other = kind.split(" against ")
            table.rows[parameter.name] = [
                picture_error(p, q, counted).flip for p, q in zip(linear[one], linear[other], strict=True)
            ]
        apart.rows[parameter.name] = [
            picture_error(shown[_VALUES.index(_SECOND)], shown[_VALUES.index(_FIRST)], counted).flip
            for shown in (linear["reference"], linear["encoded"])
        ]
        for kind, shown in linear.items():
            captions = _captions(kind, tables, parameter.name)
            tiles = [Tile(on_display(each), caption) for each, caption in zip(shown, captions, strict=True)]
            pictures.add(f"{parameter.name} {parameter.symbol}, {kind}", tiles)
        run.report(number + 1, len(_PARAMETERS))
    differ = ", ".join(
        f"{name}: {reference:.3f} in the reference, {encoded:.3f} as encoded"
        for name, (reference, encoded) in apart.rows.items()
    )
    note = (
        f"{_PATTERN}, both families alike. Mixed latents are those of {_FIRST:g} and {_SECOND:g}, weighted "
        f"by the parameter; 0.9 is extrapolated. FLIP between {_FIRST:g} and {_SECOND:g}: {differ}."
    )
    return pictures.found(settings.figures(*tables.values(), apart), note)


def _captions(kind: str, tables: dict[str, Table], name: str) -> list[str]:
    """The caption of the pictures of a kind: FLIP against the others."""
    lines = [
        [f"FLIP {cell:.4f} to {title.partition(' against ')[2]}" for cell in table.rows[name]]
        for title, table in tables.items()
        if title.startswith(kind)
    ]
    return ["; ".join(parts) for parts in zip(*lines, strict=True)] or [""] * len(_VALUES)


def _mixed(stage: Stage, parameter: _Parameter) -> list[NDArray[np.float32]]:
    """Pictures of one scene over values of its parameter `blend`."""
    (first,), second = stage.fabrics, parameter.fabric(_SECOND)
    scene = stage.neural_scene(neural_bsdf(first, stage.weights, other=second, blend=0.0))
    edits = SceneEdits(scene.scene)
    pictures = []
    for value in _VALUES:
        edits.apply({"blend": (value - _FIRST) / (_SECOND - _FIRST)})
        pictures.append(one_picture(scene, 1))
    return pictures


STUDY = Study(
    "papers/chen2024/fig8",
    "latents interpolated and extrapolated against encoded ones",
    NetworkSettings(),
    interpolated,
    stands_on=("point", "neural", "picture"),
    small={"size": (24, 16), "spp": 4},
)
