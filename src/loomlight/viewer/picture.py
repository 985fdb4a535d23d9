"""The picture of a page's stage by Mitsuba, for pages whose own adapter takes minutes for it.

The page sends what it shows: the fabric, its mesh, camera, lights and background. So the picture is of the
same scene, from the same place; as little as the page's own does it have light between folds of the cloth.
"""

from __future__ import annotations

import io
import json
import struct
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.fabric.fabric import Fabric
from loomlight.viewer.messages import fabric_of_json

# Of a request, with a mesh of a million triangles; and sides of a picture, pixels.
MAX_BYTES = 96 << 20
MAX_SIDE = 4096

Tensors = Mapping[str, NDArray[Any]]


@dataclass(frozen=True)
class Stage:
    """What a page shows. Lengths are metres, radiance is linear RGB.

    Attributes:
        fabric: what is woven.
        mesh: "positions", "normals" [n, 3], "uv" [n, 2] and "triangles" [m, 3].
        uv_size_mm: millimetres per unit of u and of v.
        size: width and height of the picture, pixels.
        origin, target: of the camera.
        towards, irradiance: of the lamp; None for no lamp.
        environment: radiance [rows, columns, 3], the top row first; None for none.
        turn: of it about the vertical, degrees.
        background: radiance beside the cloth.
        ground: unit normal, offset, and the lamp's share in the light there.
        exposure: stops.
    """

    fabric: Fabric
    mesh: Tensors
    uv_size_mm: tuple[float, float]
    size: tuple[int, int]
    origin: NDArray[np.float64]
    target: NDArray[np.float64]
    towards: NDArray[np.float64] | None
    irradiance: NDArray[np.float64]
    environment: NDArray[np.float32] | None
    turn: float
    background: NDArray[np.float64]
    ground: tuple[NDArray[np.float64], float, float]
    exposure: float


def stage_of(content: bytes) -> Stage:
    """The stage that a page describes: a safetensors file, whose metadata holds the rest as JSON in "stage".

    Raises:
        InputError: content that is none, or a value that cannot be.
    """
    from safetensors.numpy import load

    try:
        (length,) = struct.unpack_from("<Q", content)
        said = json.loads(json.loads(content[8 : 8 + length])["__metadata__"]["stage"])
        tensors = load(content)
        width, height = (int(side) for side in said["size"])
        lamp, ground = said["lamp"], said["ground"]
        stage = Stage(
            fabric=fabric_of_json(said["fabric"]),
            mesh={name: tensors[name] for name in ("positions", "normals", "uv", "triangles")},
            uv_size_mm=(float(said["uvSizeMm"][0]), float(said["uvSizeMm"][1])),
            size=(width, height),
            origin=_vector(said["camera"]["origin"]),
            target=_vector(said["camera"]["target"]),
            towards=None if lamp is None else _vector(lamp["towards"]),
            irradiance=_vector([0, 0, 0] if lamp is None else lamp["irradiance"]),
            environment=tensors.get("environment"),
            turn=float(said["turn"]),
            background=_vector(said["background"]),
            ground=(_vector(ground["normal"]), float(ground["offset"]), float(ground["lampShare"])),
            exposure=float(said["exposure"]),
        )
    except InputError:
        raise
    except Exception as error:  # content of any kind
        raise InputError(f"The request describes no stage of a page ({type(error).__name__}).") from error
    if not (1 <= width <= MAX_SIDE and 1 <= height <= MAX_SIDE):
        raise InputError(f"size = {width} × {height} is out of range: 1 to {MAX_SIDE} pixels each way.")
    return stage


def stage_png(content: bytes) -> bytes:
    """The PNG of a stage; see `stage_of` and `mitsuba.stage_picture`."""
    from PIL import Image

    from loomlight.core.colour import linear_to_srgb
    from loomlight.mitsuba.stage_picture import stage_picture

    linear = stage_picture(**vars(stage_of(content)))
    pixels = np.round(255 * linear_to_srgb(np.clip(linear, 0, 1))).astype(np.uint8)
    Image.fromarray(pixels).save(stream := io.BytesIO(), "png", compress_level=1)
    return stream.getvalue()


def _vector(values: Any) -> NDArray[np.float64]:
    vector = np.array([float(value) for value in values])
    if vector.shape != (3,) or not np.isfinite(vector).all():
        raise InputError(f"{values!r} is no vector of three numbers.")
    return vector
