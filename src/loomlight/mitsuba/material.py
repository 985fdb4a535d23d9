"""A material as a BSDF for `build_scene`."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from loomlight.mitsuba.plugins import make_bsdf
from loomlight.models.material_spec import Material, resolve
from loomlight.models.options import Options


def material_bsdf(
    material: Material,
    model: str | None = None,
    *,
    albedo: dict[str, Any] | None = None,
    options: Options | None = None,
    **values: Any,
) -> Callable[[tuple[float, float]], Any]:
    """A function from (mm per unit of u, mm per unit of v) to a Mitsuba BSDF; a variant must be set.

    Each BSDF has a model of its own, which scene edits may change.

    Args:
        material: a fabric or another source; the path of one, or of a `.loom`; a weave's name; or a model,
            for a single BSDF.
        model: a name of `loomlight.models.registry.model_names`; by default the one that a `.loom` holds,
            else "lobes".
        albedo: the dictionary of a texture that diffuse albedos are multiplied with.
        options: of the model, `Model.options_class`.
        values: options by name, in their place, such as `groups=8`.

    Raises:
        InputError: an unknown model, or a material that cannot be read or that the model does not take.
    """
    spec = resolve(material, model, options or values)
    first = [spec.model()]

    def to_scale(uv_size_mm: tuple[float, float]) -> Any:
        return make_bsdf(first.pop() if first else spec.model(), uv_size_mm, albedo)

    return to_scale
