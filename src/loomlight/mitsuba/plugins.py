"""Plugins: registered by name for scenes, and made of materials that are at hand.

They exist in whichever supported variant is set, without choosing one for the user. In other variants their
names are known too, so that loading one says which variants have it.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import mitsuba as mi
import numpy as np

from loomlight.core.errors import InputError
from loomlight.core.images import PICTURE_SUFFIXES, is_turned, read_picture, require_picture_size
from loomlight.mitsuba.bsdf import GivenModel, model_bsdf_class
from loomlight.mitsuba.painting import Painted, painted_of
from loomlight.mitsuba.path import footprint_path_class
from loomlight.mitsuba.variants import SUPPORTED_VARIANTS, in_turn, require_backend
from loomlight.models.interface import Model
from loomlight.models.material_spec import Material, resolve
from loomlight.models.options import Options
from loomlight.models.registry import MODELS

_INTEGRATOR = "footprint_path"


def register_plugins() -> None:
    """Registers the plugins now if a supported variant is set, and again whenever the variant changes."""
    mi.detail.add_variant_callback(_on_variant)
    if mi.variant() is not None:
        _on_variant(None, mi.variant())


def make_bsdf(
    model: Model,
    uv_size_mm: tuple[float, float],
    albedo: dict[str, Any] | None = None,
    painted: Painted | None = None,
) -> Any:
    """The BSDF of a model that is at hand.

    Args:
        uv_size_mm: millimetres per unit of u and of v.
        albedo: the dictionary of a texture that diffuse albedos are multiplied with.
        painted: of a fabric with maps.

    Raises:
        InputError: the texture names no picture, or one of more than 16384 pixels a side.
    """
    props = mi.Properties()
    if albedo is not None:
        # Mitsuba would read a picture of any size, and end the process where memory does not suffice.
        file = Path(str(albedo.get("filename", "")))
        if albedo.get("type") == "bitmap" and file.suffix.lower() in PICTURE_SUFFIXES:
            require_picture_size(file)
            albedo = _upright(albedo, file)
        props["albedo"] = mi.load_dict(albedo)
    given = GivenModel(model, uv_size_mm, painted)
    return _constructor(partial(model_bsdf_class(), name=model.name, given=given))(props)


def _upright(albedo: dict[str, Any], file: Path) -> dict[str, Any]:
    """The texture of a picture as viewers show it: Mitsuba reads no EXIF."""
    if not is_turned(file):
        return albedo
    pixels = np.rint(255 * read_picture(file)).astype(np.uint8)
    return {**{key: albedo[key] for key in albedo if key != "filename"}, "bitmap": mi.Bitmap(pixels)}


def _on_variant(_previous: str | None, variant: str | None) -> None:
    if variant is None:
        return
    if variant not in SUPPORTED_VARIANTS:
        for plugin in (_INTEGRATOR, *(entry.plugin for entry in MODELS.values())):
            register = mi.register_integrator if plugin == _INTEGRATOR else mi.register_bsdf
            register(plugin, partial(_refuse, plugin=plugin, variant=variant))
        return
    require_backend(variant)
    mi.register_integrator(_INTEGRATOR, _constructor(footprint_path_class()))
    for name, entry in MODELS.items():
        mi.register_bsdf(entry.plugin, _constructor(partial(model_bsdf_class(), name=name)))


def _refuse(_props: mi.Properties, plugin: str, variant: str) -> Any:
    """Instead of a plugin in variants where there is none.

    Raises:
        InputError: always.
    """
    raise InputError(
        f"{plugin} does not exist in the variant {variant}: set {' or '.join(SUPPORTED_VARIANTS)} before the "
        "scene is loaded."
    )


def _constructor(plugin: Callable[[Any], Any]) -> Callable[[Any], Any]:
    @in_turn
    def make(props: mi.Properties) -> Any:
        return plugin(props)

    return make


# --------------------------------------------------------------------------------------------------- material
# A material as a BSDF for `build_scene`.


@in_turn  # it bakes, and Dr.Jit's recordings serve one thread at a time
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
        values: some of them by name, such as `groups=8`.

    Raises:
        InputError: an unknown model, or a material that cannot be read or that the model does not take.
    """
    spec = resolve(material, model, options.changed(**values) if options is not None else values)
    painted = painted_of(spec.source, spec.model_name, spec.options)
    # Painted cloth is not edited: its BSDFs share their models.
    first = [spec.model()] if painted is None else []

    @in_turn
    def to_scale(uv_size_mm: tuple[float, float]) -> Any:
        if painted is not None:
            return make_bsdf(painted.variants[0], uv_size_mm, albedo, painted)
        return make_bsdf(first.pop() if first else spec.model(), uv_size_mm, albedo)

    return to_scale
