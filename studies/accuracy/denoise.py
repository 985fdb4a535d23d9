"""Denoised pictures against pictures of many samples: RMSE and FLIP of the examples on the drape, by zoom.

Each example at zoom 1, 8 and 30 is rendered with 4, 9 and 16 samples, and denoised with 4 and 9. RMSE is of
8-bit sRGB, in steps. The bars: 4 denoised samples beat 16 at zoom 1 and 8, and never lose to 4 as they are.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import flip_evaluator
import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import linear_to_srgb
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Cell, Table
from loomlight.mitsuba import build_scene, material_bsdf, render
from loomlight.mitsuba.variants import choose_variant
from studies.harness.study import EXAMPLES, Figures, Found, Run, Study, example, listed, listed_numbers, names

# Samples and whether the picture is denoised, by name.
PICTURES = {
    "4": (4, "off"),
    "9": (9, "off"),
    "16": (16, "off"),
    "4 denoised": (4, "auto"),
    "9 denoised": (9, "auto"),
}
Picture = NDArray[np.float32]


def errors(picture: Picture, reference: Picture) -> dict[str, float]:
    """RMSE in steps of 8-bit sRGB, and mean FLIP, of linear pictures [height, width, 3]."""
    shown, truth = (linear_to_srgb(each).astype(np.float32) for each in (picture, reference))
    rmse = 255 * float(np.sqrt(np.square(shown - truth).mean()))
    return {"rmse": rmse, "flip": float(flip_evaluator.evaluate(truth, shown, "LDR")[1])}


@dataclass(frozen=True)
class Denoise(Settings):
    examples: str = names(",".join(sorted(path.stem for path in EXAMPLES.glob("*.toml"))), "Fabrics.")
    zooms: str = setting("1,8,30", "Of the camera.", metavar="ZOOM,…")
    side: int = setting(160, "Pixels of the longer side.", low=8)
    reference: int = setting(1024, "Samples of the reference.", low=1)


def measure(settings: Denoise, run: Run) -> Found:
    """Errors by example, zoom and picture, and which bars are missed."""
    choose_variant(None)
    rows: dict[str, Any] = {}
    missed = []
    for name in listed(settings.examples):
        for zoom in listed_numbers("zooms", settings.zooms):
            bsdf = material_bsdf(str(example(name)))
            shown = build_scene("drape", bsdf, size=(settings.side, settings.side * 3 // 4), zoom=zoom)

            def shot(spp: int, denoise: str, seed: int, shown: Any = shown) -> Picture:
                return render(shown.scene, integrator=shown.integrator, spp=spp, seed=seed, denoise=denoise)

            reference = shot(settings.reference, "off", 99)
            found = {key: errors(shot(*how, 1), reference) for key, how in PICTURES.items()}
            case = f"{name}, zoom {zoom:g}"
            rows[case] = found
            rival = "4" if zoom > 8 else "16"
            missed += [
                f"{case}: {kind}"
                for kind in ("rmse", "flip")
                if found["4 denoised"][kind] > found[rival][kind]
            ]
    return Found({"side": settings.side, "reference": settings.reference, "errors": rows, "missed": missed})


def tables(figures: Figures) -> list[Table]:
    """RMSE and FLIP by case and picture."""
    rows: dict[str, list[Cell]] = {
        case: [f"{found[key]['rmse']:.1f}, {found[key]['flip']:.3f}" for key in PICTURES]
        for case, found in figures["errors"].items()
    }
    return [Table("RMSE and FLIP of pictures of so many samples", list(PICTURES), rows)]


STUDY = Study(
    "accuracy/denoise",
    "denoised pictures against pictures of many samples: RMSE and FLIP by example and zoom",
    Denoise(),
    measure,
    tables,
    stands_on=("picture",),
    small={"examples": "denim", "zooms": "1", "side": 32, "reference": 16},
)
