"""Colours as authored: what flat cloth of one yarn shows, traced by paths, against the colour in its file.

The 24 patches of a colour chart (McCamy, Marcus and Davidson 1976; sRGB as its maker publishes it) on three
weaves, d/8°: a white sky over the cloth, a view 8° from the normal, nothing behind. CIEDE2000 for D65 and the
2° observer; the bar is 2 where the colour is within reach of the cloth.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from loomlight.core.colour import delta_e_2000, lab_of_linear, parse_colour
from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from loomlight.fabric import fabric_from_text
from loomlight.fabric.colour import shown_colour
from loomlight.fabric.resolve import ROUGHNESS, SPECULAR, TRANSLUCENCY
from studies.harness.study import Figures, Found, Run, Study, listed, names
from studies.instruments.cloth_paths import radiance
from studies.instruments.directions import direction

WEAVES = ("plain", "twill 2/2", "satin 5")
CHART = (
    *("#735244", "#c29682", "#627a9d", "#576c43", "#8580b1", "#67bdaa", "#d67e2c", "#505ba6"),
    *("#c15a63", "#5e3c6c", "#9dbc40", "#e0a32e", "#383d96", "#469449", "#af363c", "#e7c71f"),
    *("#bb5695", "#0885a1", "#f3f3f2", "#c8c8c8", "#a0a0a0", "#7a7a79", "#555555", "#343434"),
)
BAR = 2.0


@dataclass(frozen=True)
class AuthoredColour(Settings):
    paths: int = setting(1 << 12, "Paths a colour.", low=1)
    weaves: str = names(",".join(WEAVES), "Weaves.")


def measure(settings: AuthoredColour, run: Run) -> Found:
    """CIEDE2000 of each colour on each weave, and whether the cloth can show the colour."""
    require_llvm()
    view = direction(8, 0)
    rows = []
    for weave in listed(settings.weaves):
        for number, colour in enumerate(CHART):
            fabric = fabric_from_text(
                f'weave = "{weave}"\n[warp]\ncolor = "{colour}"\n[weft]\ncolor = "{colour}"\n'
            )
            appearance = fabric.appearance()
            authored = parse_colour(colour, "color")
            assert appearance.openness is not None
            least, most = (
                shown_colour(
                    np.full((1, 3), end),
                    SPECULAR,
                    TRANSLUCENCY,
                    appearance.openness,
                    0,
                    ROUGHNESS,
                    appearance.optical_depth,
                )
                for end in (0.0, 1.0)
            )
            shown = radiance(fabric.layout(), appearance, view, settings.paths, 31 + number).reflected
            rows.append(
                {
                    "weave": weave,
                    "colour": colour,
                    "shown": shown.tolist(),
                    "delta_e": float(delta_e_2000(lab_of_linear(authored), lab_of_linear(shown))),
                    "within_reach": bool(np.all((least <= authored) & (authored <= most))),
                }
            )
    within = [row["delta_e"] for row in rows if row["within_reach"]]
    return Found(
        {
            "bar": BAR,
            "within_reach": len(within),
            "of": len(rows),
            "mean": float(np.mean(within)),
            "largest": float(np.max(within)),
            "rows": rows,
        }
    )


def tables(figures: Figures) -> list[Table]:
    """Differences of the colours within reach, and of all."""
    largest = max(row["delta_e"] for row in figures["rows"])
    row = [figures[key] for key in ("within_reach", "of", "mean", "largest")]
    columns = ["within reach", "of", "mean of these", "largest of these", "largest of all", "bar"]
    return [Table("CIEDE2000 of what cloth shows", columns, {"a chart": [*row, largest, figures["bar"]]})]


STUDY = Study(
    "accuracy/authored_colour",
    "colours that flat cloth of one yarn shows against those of its file",
    AuthoredColour(),
    measure,
    tables,
    stands_on=("point",),
    small={"paths": 16, "weaves": "plain"},
)
