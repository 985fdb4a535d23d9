"""A fabric as a BSDF for `build_scene`."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any

from loomlight.assets.fabrics import fabric_of_path
from loomlight.core.errors import InputError
from loomlight.fabric import Fabric
from loomlight.models.woven.encoding import require_encodable

MODELS = {"lobes": "woven_lobes", "point": "woven_point", "woven": "woven_neural"}
DEFAULT_MODEL = "lobes"


def fabric_bsdf(
    fabric: Fabric | str | os.PathLike[str], model: str = DEFAULT_MODEL
) -> Callable[[tuple[float, float]], dict[str, Any]]:
    """A function from (mm per unit of u, mm per unit of v) to the dictionary of the fabric's BSDF.

    Args:
        fabric: a fabric, or the path of a fabric file, a draft or a `.loom`, or a weave's name.
        model: one of `MODELS`.

    Raises:
        InputError: an unknown model, or a fabric that cannot be read, or is too large for the model.
    """
    if model not in MODELS:
        raise InputError(f'model = "{model}" is unknown: use {", ".join(MODELS)}.')
    cloth = fabric if isinstance(fabric, Fabric) else fabric_of_path(fabric)
    if model == "woven":
        require_encodable(cloth)
    text = cloth.to_toml()

    def to_scale(uv_size_mm: tuple[float, float]) -> dict[str, Any]:
        return {
            "type": MODELS[model],
            "toml": text,
            "folder": os.path.abspath(cloth.folder),
            "uv_size": f"{uv_size_mm[0]!r},{uv_size_mm[1]!r}",
        }

    return to_scale
