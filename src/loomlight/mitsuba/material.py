"""A material as a BSDF for `build_scene`."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any

from loomlight.assets.sources import Source
from loomlight.mitsuba.plugins import make_bsdf
from loomlight.models.interface import Model
from loomlight.models.registry import model_of


def material_bsdf(
    material: Source | Model | str | os.PathLike[str],
    model: str | None = None,
    *,
    albedo: dict[str, Any] | None = None,
    **options: Any,
) -> Callable[[tuple[float, float]], Any]:
    """A function from (mm per unit of u, mm per unit of v) to a Mitsuba BSDF; a variant must be set.

    Each BSDF has a model of its own, which scene edits may change.

    Args:
        material: a fabric or another source; the path of one, or of a `.loom`; a weave's name; or a model,
            for a single BSDF.
        model: a name of `loomlight.models.registry.model_names`; by default the one that a `.loom` holds,
            else "lobes".
        albedo: the dictionary of a texture that diffuse albedos are multiplied with.
        options: of the model; see `Model.options`.

    Raises:
        InputError: an unknown model, or a material that cannot be read or that the model does not take.
    """
    first = [model_of(material, model, **options)]

    def to_scale(uv_size_mm: tuple[float, float]) -> Any:
        made = first.pop() if first else model_of(material, model, **options)
        return make_bsdf(made, uv_size_mm, albedo)

    return to_scale
