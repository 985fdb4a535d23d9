"""Queries of `neumip` a second, fetches and networks included, against torch and ONNX Runtime.

    python -m benchmarks.neumip [--output FILE.json]

A picture of 1920 × 1080 pixels, a query each, of a material with random textures of 512² texels and random
networks: the time does not depend on the numbers. "whole" is the offset, the pyramid and the decoder; "second
light" the decoder alone, as section 6 caches the rest for a view. torch evaluates the module that training
updates, in chunks that fit the caches; ONNX Runtime the same graph. All use all cores. Floating-point
operations are those of the layers and of twelve weighted texels (a multiply-add is two). Each share is of the
FMA peak measured right before and after, so that shares hold on busy machines.
"""

from __future__ import annotations

import io
from argparse import Namespace
from collections.abc import Callable
from itertools import pairwise
from typing import Any

import drjit as dr
import numpy as np
import onnxruntime
import torch
from drjit.llvm.ad import Array2f, Array3f, Float
from torch import Tensor, nn

from benchmarks.harness import Figures, run
from benchmarks.machine import fma_peak, median_seconds
from loomlight.core.footprint import Box, box_footprint
from loomlight.core.llvm import require_llvm
from loomlight.models.mip_pyramid import PyramidShape
from loomlight.models.neumip.model import NeumipModel
from loomlight.models.neumip.networks import CHANNELS
from loomlight.models.neumip.training import network as reference
from loomlight.models.neumip.training.network import NeumipNetwork
from papers.kuznetsov2021.materials import paper_heightfield

PIXELS = 1920 * 1080
RESOLUTION = 512
# Queries of a call of torch and ONNX Runtime: larger calls leave the caches and were slower.
CHUNK = 1 << 14


class _Query(nn.Module):
    """A whole query of positions, levels, lights and views, for export: one face, no blur."""

    def __init__(self, network: NeumipNetwork) -> None:
        super().__init__()
        self.network = network

    def forward(self, positions: Tensor, levels: Tensor, lights: Tensor, views: Tensor) -> Tensor:
        """π f·cos [n, 3]."""
        faces = torch.zeros_like(levels, dtype=torch.int64)
        value: Tensor = self.network(positions, levels, lights, views, faces)[0]
        return value


def queries(count: int) -> tuple[np.ndarray[Any, Any], ...]:
    """Positions in repeats, levels, and unit vectors of lights and views."""
    rng = np.random.default_rng(0)

    def directions() -> np.ndarray[Any, Any]:
        vectors = rng.normal(size=(count, 3))
        vectors[:, 2] = np.abs(vectors[:, 2]) + 0.05
        return (vectors / np.linalg.norm(vectors, axis=1, keepdims=True)).astype(np.float32)

    positions, levels = rng.random((count, 2), np.float32), rng.uniform(0, 4, count).astype(np.float32)
    return positions, levels, directions(), directions()


def in_batch(model: NeumipModel, shown: tuple[np.ndarray[Any, Any], ...]) -> tuple[float, float]:
    """Seconds of whole queries, and of one more light of each, by the SIMD kernels."""
    positions, levels, lights, views = shown
    shape = model.weights.shape
    centres = np.ascontiguousarray((positions * shape.width_mm).T)
    side = Float(shape.texel_mm * np.exp2(levels))
    light, view = (Array3f(np.ascontiguousarray(part.T)) for part in (lights, views))
    footprint = box_footprint(Box(Array2f(centres), Array2f(side, side)))
    dr.eval(light, view, footprint)
    whole = median_seconds(lambda: dr.eval(model.at(view, footprint).value(light)))
    at = model.at(view, footprint)
    dr.eval(at.value(light), at._latent)
    return whole, median_seconds(lambda: dr.eval(at.value(light)))


def in_chunks(evaluate: Callable[..., object], shown: tuple[Any, ...]) -> float:
    """Seconds of all queries, `CHUNK` a call."""
    parts = [tuple(part[k : k + CHUNK] for part in shown) for k in range(0, PIXELS, CHUNK)]

    def every() -> None:
        for part in parts:
            evaluate(*part)

    return median_seconds(every)


def onnx_session(query: _Query) -> Any:
    """A session of ONNX Runtime of the module, for `CHUNK` queries or fewer."""
    example = (torch.rand(64, 2), torch.rand(64), torch.rand(64, 2) / 2, torch.rand(64, 2) / 2)
    names = ["positions", "levels", "lights", "views"]
    file = io.BytesIO()
    fetched = reference._fetched
    # The exporter knows no embedding bag: the same sum of gathered rows.
    reference._fetched = lambda table, texels, weights: sum(
        weight[:, None] * table[texel] for texel, weight in zip(texels, weights, strict=True)
    )
    try:
        torch.onnx.export(
            query,
            example,
            file,
            input_names=names,
            output_names=["value"],
            dynamic_axes={name: {0: "n"} for name in names},
            dynamo=False,
        )
    finally:
        reference._fetched = fetched
    return onnxruntime.InferenceSession(file.getvalue(), providers=["CPUExecutionProvider"])


def measure(_: Namespace) -> Figures:
    """Every way of evaluating queries, each against the peak beside it."""
    require_llvm()
    torch.manual_seed(0)
    source = paper_heightfield("twisted wool", 16)
    network = NeumipNetwork(PyramidShape.of(source.repeat_mm, RESOLUTION, 1), True)
    nn.init.normal_(network.offset_texture)
    network.eval()
    model = NeumipModel(source, network.weights(np.full((1, 3), 0.5, np.float32)))
    query, shown = _Query(network), queries(PIXELS)
    of_network = (*shown[:2], *(np.ascontiguousarray(part[:, :2]) for part in shown[2:]))
    tensors = tuple(map(torch.from_numpy, of_network))
    session = onnx_session(query)
    few = tuple(part[:256] for part in of_network)
    with torch.no_grad():
        expected = query(*map(torch.from_numpy, few)).numpy()
        found = session.run(None, dict(zip(_INPUTS, few, strict=True)))[0]
        np.testing.assert_allclose(found, expected, atol=1e-4)
        peaks = [fma_peak()]
        whole, second = in_batch(model, shown)
        peaks.append(fma_peak())
        by_torch = in_chunks(query, tensors)
        peaks.append(fma_peak())
        by_onnx = in_chunks(
            lambda *part: session.run(None, dict(zip(_INPUTS, part, strict=True))), of_network
        )
        peaks.append(fma_peak())
    decoder = sum(w.size for w, _ in model.weights.layers["decoder"])
    beside = [0.5 * (a + b) for a, b in pairwise(peaks)]
    return {
        "queries": PIXELS,
        "texels_a_side": RESOLUTION,
        "channels": CHANNELS,
        "fma_peak_gflops": round(peaks[0] / 1e9, 1),
        "operations": 2 * model.multiply_adds,
        "operations_second_light": 2 * decoder,
        "whole": entry(whole, 2 * model.multiply_adds, beside[0]),
        "second_light": entry(second, 2 * decoder, beside[0]),
        "torch": entry(by_torch, 2 * model.multiply_adds, beside[1]),
        "onnxruntime": entry(by_onnx, 2 * model.multiply_adds, beside[2]),
        "versions": {"torch": torch.__version__, "onnxruntime": onnxruntime.__version__},
    }


_INPUTS = ("positions", "levels", "lights", "views")


def entry(seconds: float, operations: int, peak: float) -> dict[str, float]:
    """Time of a picture and queries a second, and operations as a share of the peak."""
    return {
        "milliseconds": round(1e3 * seconds, 1),
        "millions_per_second": round(PIXELS / seconds / 1e6, 3),
        "share_of_fma_peak": round(PIXELS * operations / seconds / peak, 3),
    }


if __name__ == "__main__":
    run(measure)
