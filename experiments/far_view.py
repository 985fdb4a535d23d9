"""Cloth from afar: does it converge to a uniform tone, and is silk satin's highlight across its threads?

    python -m experiments.far_view [--output experiments/results/far_view.json]

A flat piece at 16 threads a pixel and 512 samples a pixel: what is left of differences between pixels is
compared with the noise that two pictures of different seeds show, and the strongest frequency of the
mean picture with that of white noise, so that neither tiles nor moire can hide. Then a sphere of silk satin
under a point light, whose highlight must be drawn out across the warp: the spread of its light along the
two directions of the cloth.
"""

from __future__ import annotations

from argparse import Namespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.harness import REPOSITORY, Figures, run
from loomlight.fabric import load_fabric
from loomlight.mitsuba import build_scene, choose_variant, material_bsdf, render

EXAMPLES = REPOSITORY / "examples"
THREADS_PER_PIXEL, SAMPLES, SEEDS = 16, 512, 4
FLAT_METRES = 0.1
DEGREE, SMOOTH_CYCLES = 5, 3


def pictures(fabric_file: str, scene: str, size: int) -> NDArray[np.float64]:
    """Luminance [seeds, rows, columns] of one fabric, the same view with different seeds."""
    cloth = material_bsdf(load_fabric(EXAMPLES / fabric_file), "point")
    shown = build_scene(scene, cloth, size=(size, size))
    frames = [render(shown.scene, integrator=shown.integrator, spp=SAMPLES, seed=s) for s in range(SEEDS)]
    return np.stack(frames).astype(np.float64) @ np.array([0.2126, 0.7152, 0.0722])


def evenness(fabric_file: str) -> dict[str, Any]:
    """How even the middle of a flat piece is, in units of its mean."""
    ends_per_cm = 10 / float(load_fabric(EXAMPLES / fabric_file).layout().warp.spacing.mean())
    size = round(FLAT_METRES * 100 * ends_per_cm / THREADS_PER_PIXEL)
    frames = pictures(fabric_file, "flat", size)
    margin = size // 6
    middle = frames[:, margin:-margin, margin:-margin]
    mean = middle.mean(axis=0)
    noise = float(middle.std(axis=0, ddof=1).mean() / np.sqrt(SEEDS))
    # The angles to the eye and to the light change slowly over the piece, and with them the highlight: a
    # smooth surface is taken off before pixels are compared.
    rows, columns = (2 * axis / axis.max() - 1 for axis in np.mgrid[: mean.shape[0], : mean.shape[1]])
    terms = [(rows**i * columns**j).ravel() for i in range(DEGREE + 1) for j in range(DEGREE + 1 - i)]
    smooth = np.stack(terms, axis=1)
    rest = mean.ravel() - smooth @ np.linalg.lstsq(smooth, mean.ravel(), rcond=None)[0]
    spectrum = np.abs(np.fft.rfft2(rest.reshape(mean.shape))) ** 2
    # The smooth surface is no polynomial: what little of it is left lies at the lowest frequencies.
    vertical, horizontal = (np.abs(np.fft.fftfreq(side, 1 / side)) for side in mean.shape)
    spectrum[np.maximum(vertical[:, None], horizontal[None, : spectrum.shape[1]]) <= SMOOTH_CYCLES] = 0
    white = noise**2 * mean.size
    return {
        "size": size,
        "single_picture_noise_share": round(noise * np.sqrt(SEEDS) / mean.mean(), 5),
        "difference_between_pixels_share": round(float(rest.std()) / mean.mean(), 5),
        "expected_from_noise_share": round(noise / mean.mean(), 5),
        "strongest_frequency_over_white_noise": round(float(spectrum.max() / white), 2),
        # The largest of that many exponential variables.
        "expected_strongest": round(float(np.log(spectrum.size)), 2),
    }


def highlight() -> dict[str, Any]:
    """Standard deviations of the sphere's brightest light along the picture's axes, in pixels."""
    size = 128
    mean = pictures("silk-satin.toml", "sphere", size).mean(axis=0)
    bright = np.maximum(mean - 0.5 * mean.max(), 0)
    rows, columns = np.mgrid[:size, :size]
    total = bright.sum()
    spread = []
    for axis in (columns, rows):
        middle = (axis * bright).sum() / total
        spread.append(float(np.sqrt(((axis - middle) ** 2 * bright).sum() / total)))
    return {
        "across_the_warp_px": round(spread[0], 2),
        "along_the_warp_px": round(spread[1], 2),
        "ratio": round(spread[0] / spread[1], 2),
    }


def measure(_: Namespace) -> Figures:
    """Both tones and the highlight."""
    choose_variant(None)
    return {
        "threads_per_pixel": THREADS_PER_PIXEL,
        "samples_per_pixel": SAMPLES,
        "even_tone": {name: evenness(f"{name}.toml") for name in ("silk-satin", "denim")},
        "highlight_on_satin": highlight(),
    }


if __name__ == "__main__":
    run(measure)
