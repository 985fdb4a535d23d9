"""Baking, and the files of what is baked: the verbs of the Python interface that need no renderer."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Unpack

import numpy as np

from loomlight.core.errors import InputError
from loomlight.core.files import WRITTEN_SUFFIXES, replacing
from loomlight.core.images import write_image
from loomlight.core.llvm import llvm_float, require_llvm
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.maps import (
    ClothMaps,
    require_window,
    resolution_of,
    sample_maps,
    warn_of_oblong_texels,
    write_maps,
)
from loomlight.fabric.read import FABRIC_SUFFIX
from loomlight.models.interface import Model, Report
from loomlight.models.material_spec import Material, resolve
from loomlight.models.options import Options
from loomlight.models.registry import DEFAULT_MODEL, model_class, model_from_loom, options_of
from loomlight.picture_settings import MapKeywords, MapSettings
from loomlight.sources.kinds import Source, kind_of_file
from loomlight.sources.load import load_source
from loomlight.sources.loom_file import LOOM_SUFFIX, is_loom, write_loom
from loomlight.weave.draft import Draft
from loomlight.weave.wif_writer import write_wif

_WIF = ".wif"
# Along the longer side of maps.
_MAP_TEXELS = 1024


def bake(
    material: Material,
    model: str = DEFAULT_MODEL,
    *,
    options: Options | None = None,
    report: Report | None = None,
    **values: Any,
) -> Model:
    """The model of a fabric or another source; `save` writes it into a `.loom` file.

    Args:
        material: a fabric or another source; or the path of one, a `.loom` whose source it is, or a weave's
            name.
        model: "lobes", "point", "neural", …: see `loomlight.models.registry.model_names`.
        options: of the model, `Model.options_class`; by default its own defaults.
        report: called with (steps done, steps in all) by models that are trained.
        values: options by name, in their place, such as `groups=8`.

    Raises:
        InputError: no such model or option, or a source that cannot be read or that the model does not take.
        MissingDependencyError: LLVM is missing.
    """
    spec = resolve(material, model, options_of(model, options or values))
    require_llvm()
    return model_class(model).for_source(spec.source, spec.options, report)


def bake_maps(
    material: Material, settings: MapSettings | None = None, **changes: Unpack[MapKeywords]
) -> ClothMaps:
    """The cloth of a fabric as textures, of whole repeats or a window; `save` writes them into .exr or .png.

    Args:
        material: a fabric; or the path of one or of a `.loom`, or a weave's name.
        settings: by default those of `MapSettings`: square texels of one repeat, 1024 along its longer side.
        changes: settings by name, such as `pixels_per_mm=40`.

    Raises:
        InputError: no fabric, an unknown setting, or a value that cannot be.
        MissingDependencyError: LLVM is missing.
    """
    chosen, source = (settings or MapSettings()).changed(**changes), resolve(material).source
    if not isinstance(source, Fabric):
        raise InputError(f"Maps are of fabrics, and {source.name} is none.")
    window = chosen.window
    if chosen.tile is not None:
        across, up = (max(round(chosen.tile / side), 1) * side for side in source.repeat_mm)
        window = (0.0, 0.0, across, up)
    if window is not None:
        require_window(window)
    extent = source.repeat_mm if window is None else window[2:]
    if chosen.pixels_per_mm is not None:
        texels = resolution_of(extent, chosen.pixels_per_mm)
    elif isinstance(chosen.resolution, tuple):
        texels = chosen.resolution
        warn_of_oblong_texels(extent, texels)
    else:
        texels = resolution_of(extent, (chosen.resolution or _MAP_TEXELS) / max(extent))
    return sample_maps(source, texels, llvm_float(), window, chosen.back)


def load(path: str | os.PathLike[str]) -> Model | Source:
    """What a path or a name denotes: the model in a `.loom`, else a fabric or another source.

    Args:
        path: a `.loom`, a fabric file, a draft (WIF or picture), another source's file, or a weave's name.

    Raises:
        InputError: no such file, or one that this installation cannot read.
    """
    return model_from_loom(path) if is_loom(path) else load_source(path, kind_of_file(path, "fabric"))


def save(
    what: Model | Fabric | Draft | ClothMaps | np.ndarray[Any, Any], path: str | os.PathLike[str]
) -> None:
    """Writes a model as .loom, a fabric as .toml, a draft as .wif, or a picture as .png, .jpg or .exr.

    Maps are written as one .exr, or beside a .png as a picture each. Files are written whole or not at all.

    Raises:
        InputError: none of these, a suffix that does not go with it, or a place that cannot be written to.
    """
    suffix = Path(path).suffix.lower()
    kind, suffixes = next(
        ((name, right) for holds, name, right in _FILES if isinstance(what, holds)), ("", ())
    )
    if not kind:
        raise InputError(f"{path}: a {type(what).__name__} is no model, fabric, draft, map or picture.")
    if suffix not in suffixes:
        raise InputError(f"{path}: a {kind} is written as {' or '.join(suffixes)}.")
    if isinstance(what, Model):
        write_loom(path, what.to_loom())
    elif isinstance(what, Fabric):
        _write_fabric(what, Path(path))
    elif isinstance(what, Draft):
        write_wif(what, path)
    elif isinstance(what, ClothMaps):
        write_maps(what, path)
    elif what.ndim == 3 and what.shape[2] in (1, 3, 4) and what.size:
        write_image(path, what)
    else:
        raise InputError(f"{path}: a picture is [height, width, 1, 3 or 4], not {list(what.shape)}.")


def _write_fabric(fabric: Fabric, path: Path) -> None:
    """Writes a fabric file whose paths are relative to its own folder."""
    named = fabric.fields.draft or fabric.fields.image
    if named is not None and not (Path(fabric.folder) / named).is_file():
        raise InputError(
            f"{path}: the draft of {fabric.name} is not in a file of its own: save fabric.draft as .wif, "
            "and write a fabric file that names it."
        )
    with replacing(path) as temporary:
        temporary.write_text(fabric.to_toml(path.parent), encoding="utf-8")


_FILES: tuple[tuple[type, str, tuple[str, ...]], ...] = (
    (Model, "model", (LOOM_SUFFIX,)),
    (Fabric, "fabric", (FABRIC_SUFFIX,)),
    (Draft, "draft", (_WIF,)),
    (ClothMaps, "set of maps", (".exr", ".png")),
    (np.ndarray, "picture", WRITTEN_SUFFIXES),
)
