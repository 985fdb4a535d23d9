"""Colours as authored: what flat cloth of one yarn shows, traced by paths, against the colour in its file.

    python -m studies.accuracy.authored_colour [--paths N] [--output FILE.json]

The 24 patches of a colour chart (McCamy, Marcus and Davidson 1976; sRGB as its maker publishes it) on three
weaves, d/8°: a white sky over the cloth, a view 8° from the normal, nothing behind. CIEDE2000 for D65 and the
2° observer; the bar is 2 where the colour is within reach of the cloth.
"""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

import numpy as np

from loomlight.core.colour import delta_e_2000, lab_of_linear, parse_colour
from loomlight.core.llvm import require_llvm
from loomlight.fabric import fabric_from_text
from loomlight.fabric.colour import shown_colour
from loomlight.fabric.resolve import ROUGHNESS, SPECULAR, TRANSLUCENCY
from studies.accuracy.interreflection import direction
from studies.instruments.cloth_paths import radiance
from studies.instruments.harness import Figures, run

WEAVES = ("plain", "twill 2/2", "satin 5")
CHART = (
    *("#735244", "#c29682", "#627a9d", "#576c43", "#8580b1", "#67bdaa", "#d67e2c", "#505ba6"),
    *("#c15a63", "#5e3c6c", "#9dbc40", "#e0a32e", "#383d96", "#469449", "#af363c", "#e7c71f"),
    *("#bb5695", "#0885a1", "#f3f3f2", "#c8c8c8", "#a0a0a0", "#7a7a79", "#555555", "#343434"),
)
BAR = 2.0


def measure(options: Namespace) -> Figures:
    """CIEDE2000 of each colour on each weave, and whether the cloth can show the colour."""
    require_llvm()
    view = direction(8, 0)
    rows = []
    for weave in WEAVES:
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
            shown = radiance(fabric.layout(), appearance, view, options.paths, 31 + number).reflected
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
    return {
        "bar": BAR,
        "within_reach": len(within),
        "of": len(rows),
        "mean": float(np.mean(within)),
        "largest": float(np.max(within)),
        "rows": rows,
    }


def add_options(parser: ArgumentParser) -> None:
    """Options of this script."""
    parser.add_argument("--paths", type=int, default=1 << 13, help="paths a colour")


if __name__ == "__main__":
    run(measure, add_options)
