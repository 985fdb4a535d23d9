"""Evaluations of the universal network a second, fetches and codings included, against the machine.

Floating-point operations are those of the layers as they are computed (a multiply-add is two) and of eight
bilinear fetches; codings and activations are not counted. "in batch" is `NeuralModel.evaluate` of many
queries, fetch, coding and layers; "by cooperative vectors" is the same without SIMD kernels; "in numpy" is
`compiled.decode`, arrays in and out; "in the renderer" is the network's part of a picture, which decodes
each pixel for two lights. All use all cores. Each share is of the FMA peak measured right before and after,
with independent chains of multiply-adds, so that shares hold on busy machines.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeVar
from unittest.mock import patch

import drjit as dr
import numpy as np
from drjit.llvm.ad import Array2f, Array3f, Float

from loomlight.core.footprint import Footprint
from loomlight.core.llvm import require_llvm
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from loomlight.fabric import fabric_from_text
from loomlight.mitsuba import build_scene, choose_variant, material_bsdf, render
from loomlight.models.neural.decoder import Decoder, decode, decoder_cost
from loomlight.models.neural.encoded_fabric import footprints_in_threads
from loomlight.models.neural.encoding import (
    encoder_session,
    fabric_parameters,
    face_maps,
    fitted_correction,
    shortest_repeat,
)
from loomlight.models.neural.model import NeuralModel
from loomlight.yarn.geometry import YarnGeometry
from studies.harness.study import Figures, Found, Run, Study
from studies.instruments.machine import fma_peak, median_seconds
from studies.papers.chen2024.cost import network_time

FABRIC = "satin 8/3"


def queries(model: NeuralModel, count: int) -> tuple[Any, ...]:
    """Lights, views and footprints from a quarter thread to 10 threads."""
    rng = np.random.default_rng(0)

    def directions() -> np.ndarray:
        vectors = rng.normal(size=(3, count))
        vectors[2] = np.abs(vectors[2]) + 0.05
        return (vectors / np.linalg.norm(vectors, axis=0)).astype(np.float32)

    centres = (rng.random((2, count)) * np.array(model.fabric.repeat_mm)[:, None]).astype(np.float32)
    sides = (0.5 * np.exp(rng.uniform(np.log(0.25), np.log(10), count))).astype(np.float32)
    return directions(), directions(), centres, sides


def in_batch(model: NeuralModel, count: int) -> float:
    """Queries a second of many at once."""
    lights, views, centres, sides = queries(model, count)
    light, view, side = Array3f(lights), Array3f(views), Float(sides)
    footprint = Footprint(Array2f(centres), Array2f(side, 0), Array2f(0, side))
    dr.eval(light, view, footprint)
    return count / median_seconds(lambda: dr.eval(model.at(view, footprint).components(light)))


def by_cooperative_vectors(model: NeuralModel, count: int) -> float:
    """The same without SIMD kernels."""
    with patch.object(Decoder, "uses_kernel", lambda decoder, inputs: False):
        return in_batch(model, count)


def in_numpy(model: NeuralModel, count: int) -> float:
    """Queries a second of numpy arrays, turned and copied included."""
    lights, views, centres, sides = queries(model, count)
    footprints = footprints_in_threads(model.fabric.layout(), centres.T, sides)
    directions = np.ascontiguousarray(lights.T), np.ascontiguousarray(views.T)
    return count / median_seconds(lambda: decode(model.weights, model.encoded, *directions, footprints))


Measured = TypeVar("Measured")


def beside_peak(rate: Callable[[], Measured]) -> tuple[Measured, float]:
    """What is measured, and the peak at that time."""
    before = fma_peak()
    found = rate()
    return found, 0.5 * (before + fma_peak())


def in_renderer(operations_a_pixel: int, side: int) -> tuple[float, float, float]:
    """Seconds of a picture, share of them in the network, and operations a second in it."""
    choose_variant("llvm_ad_rgb")
    shown = build_scene("flat", material_bsdf(FABRIC, "neural"), size=(side, side), max_depth=2, zoom=2.4)

    def picture() -> None:
        render(shown.scene, spp=1, integrator=shown.integrator)

    picture()
    found = min((network_time(picture) for _ in range(3)), key=lambda found: found.picture.seconds)
    seconds, network = found.picture.seconds, found.network.seconds
    return seconds, network / seconds, side**2 * operations_a_pixel / network


def encoder_seconds(model: NeuralModel) -> float:
    """Seconds of one face through ONNX Runtime."""
    layout = model.fabric.layout()
    picks, ends = layout.warp_on_top.shape
    maps = face_maps(YarnGeometry(layout), False, 16 * picks, 16 * ends, Float)[None]
    session, parameters = encoder_session(model.weights), fabric_parameters(model.fabric)
    return median_seconds(lambda: session.run(None, {"maps": maps, "parameters": parameters}))


def correction_seconds(model: NeuralModel) -> float:
    """Seconds of the correction of the last layer for both faces."""
    layout = shortest_repeat(model.fabric.layout())
    return median_seconds(
        lambda: fitted_correction(model.fabric, layout, model.encoded, model.weights, Float)
    )


@dataclass(frozen=True)
class NeuralInference(Settings):
    count: int = setting(1 << 18, "Queries of a batch.", low=64)
    picture: int = setting(512, "Pixels a side of the picture.", low=8)


def measure(settings: NeuralInference, run: Run) -> Found:
    """Every way of running the network, each against the peak beside it."""
    require_llvm()
    model = NeuralModel.for_source(fabric_from_text(FABRIC))
    corrected = model.encoded.correction is not None
    cost = decoder_cost(model.weights, corrected)
    seen, light = 2 * cost.per_view, 2 * cost.per_light
    batch, batch_peak = beside_peak(lambda: in_batch(model, settings.count))
    vectors, vectors_peak = beside_peak(lambda: by_cooperative_vectors(model, settings.count))
    numpy, numpy_peak = beside_peak(lambda: in_numpy(model, settings.count))
    (seconds, fraction, rate), peak = beside_peak(lambda: in_renderer(seen + 2 * light, settings.picture))
    encoder = encoder_seconds(model)
    return Found(
        {
            "fabric": FABRIC,
            "fma_peak_gflops": round(peak / 1e9, 1),
            "operations_seen": seen,
            "operations_light": light,
            "in_batch": entry(batch, seen + light, batch_peak),
            "by_cooperative_vectors": entry(vectors, seen + light, vectors_peak),
            "in_numpy": entry(numpy, seen + light, numpy_peak),
            "in_renderer": {
                "picture": f"flat, {settings.picture}², 1 sample, direct light",
                "seconds": round(seconds, 3),
                "share_of_time_in_network": round(fraction, 2),
                "share_of_fma_peak": round(rate / peak, 3),
            },
            "encoder_milliseconds_a_face": round(1e3 * encoder, 1),
            "correction_seconds": round(correction_seconds(model), 2),
        }
    )


def entry(rate: float, count: int, peak: float) -> dict[str, float]:
    """A rate in queries a second, and as a share of the peak."""
    return {
        "millions_per_second": round(rate / 1e6, 3),
        "share_of_fma_peak": round(rate * count / peak, 3),
    }


def tables(figures: Figures) -> list[Table]:
    """Rates of batches, and what a picture takes."""
    ways = ("in_batch", "by_cooperative_vectors", "in_numpy", "in_onnx_runtime")
    keys = ("millions_per_second", "share_of_fma_peak")
    rows = {way.replace("_", " "): [figures[way][key] for key in keys] for way in ways if way in figures}
    drawn = figures["in_renderer"]
    picture = [drawn[key] for key in ("seconds", "share_of_time_in_network", "share_of_fma_peak")]
    note = f"{figures['fabric']}, FMA peak {figures['fma_peak_gflops']} GFLOP/s."
    return [
        Table("Queries of `neural`", ["million/s", "of the FMA peak"], rows, note),
        Table("In a picture", ["s", "of it in the network", "of the FMA peak"], {drawn["picture"]: picture}),
    ]


STUDY = Study(
    "speed/neural_inference",
    "evaluations of the universal network a second, fetches and codings included",
    NeuralInference(),
    measure,
    tables,
    stands_on=("neural", "network"),
    small={"count": 1 << 10, "picture": 16},
)
