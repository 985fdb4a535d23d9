"""kuznetsov2021: Fig. 9, where the time of a query goes.

Every pixel of a picture of 1920 × 1080 is a query of a plane at 45°, one texel of 512² large. Parts are
measured apart, each on what the one before gives: offset texture, offset network and pyramid are the first
stage, which no light changes; the decoder is the second. Multiply-adds are those of weights and of
interpolation; bytes are fetched from textures in single precision. Numbers of networks and textures are
random: they cost the same. Times are processor milliseconds on one thread, by the kernels that pictures on
CPUs use; the paper's 5 ms are an RTX 2080 Ti's.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from itertools import pairwise

import drjit as dr
import numpy as np
from drjit.llvm.ad import Array2f, Array3f, Float, UInt

from loomlight.core.backend import array_types, upload
from loomlight.core.footprint import Box, box_footprint
from loomlight.core.llvm import require_llvm
from loomlight.core.picture_settings import MAX_SIDE
from loomlight.core.settings import same_setting, setting
from loomlight.evaluation.table import Table
from loomlight.models.networks import ReluNetwork
from loomlight.models.texture.neumip import CHANNELS, DeviceWeights, NeumipModel, Weights
from loomlight.models.texture.pyramid import DrjitFunctions, PyramidShape, bilinear_taps, fetch_texels
from studies.harness.study import Found, Run, Study, with_tables
from studies.instruments.random_networks import random_layers, random_numbers
from studies.instruments.timing import least_times, one_thread
from studies.papers.kuznetsov2021.designs import DESIGNS, OURS, RAINER19
from studies.papers.kuznetsov2021.materials import paper_heightfield
from studies.papers.kuznetsov2021.stage import plane_shot
from studies.papers.setting import PictureSettings, TrainedSettings

_MATERIAL = "turtle shell"
# The stage of each part: no light changes the first.
_STAGES = {"offset texture": 1, "offset network": 1, "pyramid": 1, "decoder": 2}
_WHOLE, _RAINER = "whole query of the model", f"decoder of {RAINER19}"
_NETWORKS = {
    "offset": DESIGNS[OURS].offset_widths,
    "decoder": DESIGNS[OURS].decoder_widths,
    RAINER19: DESIGNS[RAINER19].decoder_widths,
}
# Texels that a texture answers with, and bytes of a number.
_BILINEAR, _TRILINEAR, _FLOAT = 4, 8, 4
# The paper's times of a picture, milliseconds on an RTX 2080 Ti.
_PAPER_MS = {OURS: 5, RAINER19: 92}


@dataclass(frozen=True)
class BreakdownSettings(PictureSettings):
    """Of Fig. 9."""

    size: tuple[int, int] = setting(
        (1920, 1080), "Pixels, each a query.", low=1, high=MAX_SIDE, metavar="WxH"
    )
    resolution: int = same_setting(TrainedSettings, "resolution", default=512, otherwise="")
    turns: int = setting(5, "Times are the least of so many.", low=1, high=1000)


def breakdown(settings: BreakdownSettings, run: Run) -> Found:
    """Fig. 9: operations, bytes and time of the parts of a query."""
    require_llvm()
    parts = _parts(settings)
    with one_thread():
        for part in parts.values():  # compiles
            part()
        taken = least_times(list(parts.values()), settings.turns)
    times = {name: 1e3 * spent.cpu_seconds for name, spent in zip(parts, taken, strict=True)}
    note = (
        f"{settings.size[0]} × {settings.size[1]} queries, textures of {settings.resolution} texels a side; "
        f"processor milliseconds on one thread, the least of {settings.turns}."
    )
    return Found(with_tables(_table_of_parts(times, note), _beside_rainer(times)))


def _parts(settings: BreakdownSettings) -> dict[str, Callable[[], None]]:
    """Functions that evaluate each part for all pixels, the whole query, and the decoder of Rainer et al."""
    rng, types = np.random.default_rng(9), array_types(Float)
    # A material of random numbers.
    source = paper_heightfield(_MATERIAL, 16)
    shape = PyramidShape.of(source.repeat_mm, settings.resolution, 1)
    layers = {name: random_layers(widths, rng) for name, widths in _NETWORKS.items()}
    features, offset_texels = (
        random_numbers(rng, 0.5, (count, CHANNELS)) for count in (shape.texels, shape.columns * shape.rows)
    )
    ours = {name: layers[name] for name in ("offset", "decoder")}
    weights = Weights(shape, features, offset_texels, ours, np.full((1, 3), 0.5, np.float32))
    device, model = DeviceWeights(weights, Float), NeumipModel(source, weights)
    networks = {name: ReluNetwork(each, Float) for name, each in layers.items()}
    # Texels are read as rows of eight numbers.
    offset_table = upload(Float, np.pad(offset_texels, ((0, 0), (0, 1))))
    functions = DrjitFunctions(types)

    # Queries.
    shot = plane_shot(source, shape.texel_mm, 0, settings.size)
    count = len(shot.sides)
    u, v = (Float(part) for part in (shot.positions / np.array(source.repeat_mm, np.float32)).T)
    view, light = ([Float(part) for part in each.T[:2]] for each in (shot.views, shot.lights))
    level, face = Float(np.log2(shot.sides / shape.footprint_mm)), dr.zeros(UInt, count)
    views, lights = (Array3f(np.ascontiguousarray(part.T)) for part in (shot.views, shot.lights))
    sides = Float(shot.sides)
    footprint = box_footprint(Box(Array2f(np.ascontiguousarray(shot.positions.T)), Array2f(sides, sides)))

    def offset_texture() -> list[Float]:
        taps = bilinear_taps(u, v, shape.columns, shape.rows, dr.zeros(types.Int32, count), functions)
        return fetch_texels(offset_table, taps, types)[:CHANNELS]

    # What each part gives to the next is there before that one is timed.
    texel, latent = offset_texture(), device.latent(u, v, level, face)
    inputs = random_numbers(rng, 1, (_NETWORKS[RAINER19][0], count))
    rainer_inputs = [Float(part) for part in inputs]
    dr.eval(u, v, view, light, level, face, views, lights, footprint, texel, latent, rainer_inputs)
    calls: dict[str, Callable[[], object]] = {
        "offset texture": offset_texture,
        "offset network": lambda: networks["offset"]([*texel, *view]),
        "pyramid": lambda: device.latent(u, v, level, face),
        "decoder": lambda: networks["decoder"]([*latent, *light, *view]),
        _WHOLE: lambda: model.at(views, footprint).value(lights),
        _RAINER: lambda: networks[RAINER19](rainer_inputs),
    }
    return {name: partial(_evaluate, call) for name, call in calls.items()}


def _evaluate(call: Callable[[], object]) -> None:
    dr.eval(call())
    dr.sync_thread()


def _table_of_parts(times: dict[str, float], note: str) -> Table:
    """Parts, stages, the whole query, and the decoder of Rainer et al.

    Args:
        times: of pictures, milliseconds by part.
    """
    columns = ["stage", "multiply-adds", "bytes of textures", "ms", "share of the time"]
    table = Table("Parts of a query", columns, note=note)
    sum_of_parts = sum(times[name] for name in _STAGES)
    stages = {f"stage {number}": [n for n in _STAGES if _STAGES[n] == number] for number in (1, 2)}
    for label, names in {**{name: [name] for name in _STAGES}, **stages}.items():
        taken = sum(times[name] for name in names)
        table.rows[label] = [_STAGES[names[0]], *_operations(names), taken, taken / sum_of_parts]
    table.rows[_WHOLE] = [None, *_operations([*_STAGES]), times[_WHOLE], None]
    table.rows[_RAINER] = [None, _multiply_adds(_NETWORKS[RAINER19]), None, times[_RAINER], None]
    return table


def _beside_rainer(times: dict[str, float]) -> Table:
    """How much more the decoder of Rainer et al. takes than both networks of ours."""
    adds = sum(_multiply_adds(_NETWORKS[name]) for name in ("offset", "decoder"))
    ratios = [
        _multiply_adds(_NETWORKS[RAINER19]) / adds,
        times[_RAINER] / (times["offset network"] + times["decoder"]),
        _PAPER_MS[RAINER19] / _PAPER_MS[OURS],
    ]
    columns = ["multiply-adds of networks", "processor time of networks", "the paper's time of a picture"]
    return Table("Rainer et al. 2019 over ours", columns, {RAINER19: [*ratios]})


def _operations(parts: list[str]) -> tuple[int, int]:
    """Multiply-adds of parts of a query, and bytes that they fetch from textures."""
    taps = {"offset texture": _BILINEAR, "pyramid": _TRILINEAR}
    read = sum(taps.get(part, 0) for part in parts) * CHANNELS
    layers = sum(_multiply_adds(_NETWORKS[part.split()[0]]) for part in parts if part not in taps)
    return read + layers, _FLOAT * read


def _multiply_adds(widths: tuple[int, ...]) -> int:
    return sum(a * b for a, b in pairwise(widths))


STUDY = Study(
    "papers/kuznetsov2021/fig9",
    "where the time of a query goes: textures and networks of two stages",
    BreakdownSettings(),
    breakdown,
    stands_on=("neumip",),
    small={"size": (32, 18), "resolution": 16, "turns": 1},
)
