"""Denoised pictures against pictures of many samples: RMSE and FLIP of the examples on the drape, by zoom.

    python -m studies.accuracy.denoise [--output FILE.json]

Each example at zoom 1, 8 and 30 is rendered with 4, 9 and 16 samples, and denoised with 4 and 9. RMSE is of
8-bit sRGB, in steps. The bars: 4 denoised samples beat 16 at zoom 1 and 8, and never lose to 4 as they are.
"""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import Any

import flip_evaluator
import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import linear_to_srgb
from loomlight.mitsuba import build_scene, material_bsdf, render
from loomlight.mitsuba.variants import choose_variant
from studies.instruments.harness import Figures, run

ZOOMS = 1, 8, 30
EXAMPLES = Path(__file__).parents[2] / "examples"
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


def add_options(parser: ArgumentParser) -> None:
    """Which examples, and how large and how exact pictures are."""
    parser.add_argument(
        "--examples", nargs="*", default=sorted(path.stem for path in EXAMPLES.glob("*.toml"))
    )
    parser.add_argument("--zooms", nargs="*", type=float, default=ZOOMS)
    parser.add_argument("--side", type=int, default=160, help="pixels of the longer side")
    parser.add_argument("--reference", type=int, default=1024, help="samples of the reference")


def measure(options: Namespace) -> Figures:
    """Errors by example, zoom and picture, and which bars are missed."""
    choose_variant(None)
    rows: dict[str, Any] = {}
    missed = []
    for name in options.examples:
        for zoom in options.zooms:
            bsdf = material_bsdf(str(EXAMPLES / f"{name}.toml"))
            shown = build_scene("drape", bsdf, size=(options.side, options.side * 3 // 4), zoom=zoom)

            def shot(spp: int, denoise: str, seed: int, shown: Any = shown) -> Picture:
                return render(shown.scene, integrator=shown.integrator, spp=spp, seed=seed, denoise=denoise)

            reference = shot(options.reference, "off", 99)
            found = {key: errors(shot(*how, 1), reference) for key, how in PICTURES.items()}
            case = f"{name}, zoom {zoom:g}"
            rows[case] = found
            rival = "4" if zoom > 8 else "16"
            missed += [
                f"{case}: {kind}"
                for kind in ("rmse", "flip")
                if found["4 denoised"][kind] > found[rival][kind]
            ]
            print(
                case,
                {key: f"{each['rmse']:.1f} {each['flip']:.3f}" for key, each in found.items()},
                flush=True,
            )
    return {"side": options.side, "reference": options.reference, "errors": rows, "missed": missed}


if __name__ == "__main__":
    run(measure, add_options, digits=3)
