"""The encoder through ONNX Runtime: maps and parameters of a fabric in, latents of both faces out.

torch exported its graph when the network was trained (`training/export.py`); it lies beside the weights.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import array_types
from loomlight.core.errors import InputError
from loomlight.core.extras import import_extra
from loomlight.fabric.fabric import Fabric
from loomlight.models.neural.architecture import FIELD_MAP, VECTOR_MAP
from loomlight.models.neural.encoded_fabric import EncodedFabric
from loomlight.models.neural.fibres import Fibres
from loomlight.models.neural.footprint_coding import mean_pitch
from loomlight.models.neural.weights import Weights
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout, FamilyLayout


def run_encoder(
    fabric: Fabric, weights: Weights, float_type: type, repeats: tuple[int, int] = (1, 1)
) -> EncodedFabric:
    """Latents of both faces, each of one run of the encoder.

    Args:
        float_type: the Dr.Jit Float type that the maps are computed with.
        repeats: repetitions of the repeat along picks and along ends.
    """
    layout = shortest_repeat(fabric.layout())
    picks, ends = layout.warp_on_top.shape
    geometry = YarnGeometry(layout)
    field = weights.table.latent == "field"
    rows, columns = (FIELD_MAP * picks, FIELD_MAP * ends) if field else (VECTOR_MAP, VECTOR_MAP)
    parameters = fabric_parameters(fabric)
    faces = []
    for back in (False, True):
        maps = face_maps(geometry, back, rows, columns, float_type)
        if field:
            maps = np.tile(maps, (1, *repeats))
        (latents,) = encoder_session(weights).run(None, {"maps": maps[None], "parameters": parameters})
        faces.append(latents.astype(np.float16))
    shape = picks * repeats[0], ends * repeats[1]
    return EncodedFabric.of(shape, (faces[0], faces[1]), Fibres.of(fabric))


@cache
def encoder_session(weights: Weights) -> Any:
    """ONNX Runtime's session of the encoder.

    Inputs are `maps` [1, 7, rows, columns] of one face and `parameters` [4], the output is `latents`
    [texels, latent_size] in the order of `levels_of` ("field"), or [1, latent_size] ("vector").
    """
    # Slow to import, and not needed if latents are cached.
    onnxruntime = import_extra("onnxruntime", "neural", "Encoding a fabric for the network")
    options = onnxruntime.SessionOptions()
    options.log_severity_level = 3
    try:
        return onnxruntime.InferenceSession(weights.encoder, options, providers=["CPUExecutionProvider"])
    # The exceptions of ONNX Runtime on unreadable models have no public base.
    except Exception as error:
        raise InputError(f"{weights.source}: ONNX Runtime cannot read the encoder beside it.") from error


CHANNELS = 7


def face_maps(
    geometry: YarnGeometry, back: bool, rows: int, columns: int, float_type: type
) -> NDArray[np.float32]:
    """Normal, fibre direction and height of one face [7, rows, columns], row 0 at the repeat's lower edge.

    All are of yarns scaled by β; heights are in pitches (the geometric mean of both families' spacings).
    Holes are 0 in every channel.

    Args:
        back: the face behind, in its own mirrored frame.
        float_type: the Dr.Jit Float type to compute with.
    """
    types = array_types(float_type)
    width, height = geometry.size
    texel = np.arange(rows * columns, dtype=np.int64)
    x = (texel % columns + 0.5) * (width / columns)
    y = (texel // columns + 0.5) * (height / rows)
    point = geometry.surface(types.Float(x), types.Float(y), types.Bool(back))
    pitch = mean_pitch(geometry.layout)
    channels = [*point.normal, *point.tangent, point.height / pitch]
    planes = [dr.select(point.hole, 0, plane) + dr.zeros(types.Float, rows * columns) for plane in channels]
    dr.eval(planes)
    return np.stack([plane.numpy() for plane in planes]).astype(np.float32).reshape(CHANNELS, rows, columns)


def fabric_parameters(fabric: Fabric) -> NDArray[np.float32]:
    """α of warp and weft, β of warp and weft [4]."""
    layout, appearance = fabric.layout(), fabric.appearance()
    return np.array(
        [
            appearance.warp.roughness,
            appearance.weft.roughness,
            layout.warp.height_scale,
            layout.weft.height_scale,
        ],
        np.float32,
    )


def shortest_repeat(layout: ClothLayout) -> ClothLayout:
    """The layout of one repeat of the weave, which stripes of colours may have made longer."""
    drawdown = layout.warp_on_top
    picks = _period(layout.weft, lambda step: bool((np.roll(drawdown, step, 0) == drawdown).all()))
    ends = _period(layout.warp, lambda step: bool((np.roll(drawdown, step, 1) == drawdown).all()))
    return ClothLayout(drawdown[:picks, :ends], _first(layout.warp, ends), _first(layout.weft, picks))


def _period(family: FamilyLayout, repeats: Callable[[int], bool]) -> int:
    count = len(family.spacing)
    for step in range(1, count):
        if (
            count % step == 0
            and repeats(step)
            and _alike(family.spacing, step)
            and _alike(family.width, step)
        ):
            return step
    return count


def _alike(values: NDArray[np.float64], step: int) -> bool:
    return bool(np.allclose(np.roll(values, step), values, rtol=1e-9, atol=0))


def _first(family: FamilyLayout, count: int) -> FamilyLayout:
    return replace(family, spacing=family.spacing[:count], width=family.width[:count])


def repeat_threads(fabric: Fabric) -> tuple[int, int]:
    """Picks and ends of a fabric's shortest repeat."""
    picks, ends = shortest_repeat(fabric.layout()).warp_on_top.shape
    return picks, ends
