"""Baking one source or many, maps, and their files: verbs of the Python interface without a renderer."""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import Any, Unpack

import numpy as np

from loomlight.core.errors import InputError
from loomlight.core.files import WRITTEN_SUFFIXES, remove_leftovers, replacing
from loomlight.core.fleet import Executor, Outcome, Report, Shard, ShardFolder, require_results, work_map
from loomlight.core.images import write_image
from loomlight.core.llvm import llvm_float, require_llvm
from loomlight.core.picture_settings import MapKeywords, MapSettings
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
from loomlight.fabric.surface_maps import without_maps
from loomlight.models.interface import Model
from loomlight.models.material_spec import Material, resolve
from loomlight.models.options import Options
from loomlight.models.registry import DEFAULT_MODEL, model_class, model_from_loom, options_of
from loomlight.sources.kinds import Source, kind_of_file
from loomlight.sources.load import load_source, source_identity
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
        values: some of them by name, such as `groups=8`.

    Raises:
        InputError: no such model or option, or a source that cannot be read or that the model does not take.
        MissingDependencyError: LLVM is missing.
    """
    spec = resolve(material, model, options_of(model, options, **values))
    require_llvm()
    source = spec.source
    if isinstance(source, Fabric):
        source = without_maps(source, "A baked model")
    return model_class(model).for_source(source, spec.options, report)


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
    elif chosen.resolution is None or isinstance(chosen.resolution, int):
        texels = resolution_of(extent, (chosen.resolution or _MAP_TEXELS) / max(extent))
    else:
        columns, rows = chosen.resolution
        texels = columns, rows
        warn_of_oblong_texels(extent, texels)
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


# ------------------------------------------------------------------------------------------------- catalogues

# Claims and markers, in the folder of the results.
WORK_FOLDER = ".loomlight-bake"


def catalogue_paths(sources: Sequence[str], folder: Path) -> list[Path]:
    """The `.loom` of each source in a folder, by the names of the sources.

    Raises:
        InputError: two sources have one name, or a source would be overwritten.
    """
    paths = [folder / f"{_file_name(source)}.loom" for source in sources]
    by_path: dict[Path, str] = {}
    for source, path in zip(sources, paths, strict=True):
        if path in by_path:
            raise InputError(
                f"{by_path[path]} and {source} would both be {path}: bake them into two folders."
            )
        by_path[path] = source
    read = {Path(source).resolve() for source in sources}
    for path in paths:
        if path.resolve() in read:
            raise InputError(f"{path} is one of the sources: give another folder.")
    return paths


def bake_catalogue(
    sources: Sequence[str],
    model: str,
    folder: Path,
    options: Options | None = None,
    *,
    executor: Executor | None = None,
    report: Report = lambda done, total: None,
) -> list[Path]:
    """Writes a `.loom` of each source; returns their paths.

    What is finished is kept with its marker: a second call bakes what is missing, or what has changed.

    Args:
        sources: paths, or names of weaves.
        model, options: as in `bake`.
        folder: made if need be.
        executor: who works; this process by default.
        report: called with (sources done, sources in all).

    Raises:
        InputError: a source cannot be used; all others are baked.
        LoomlightError: processes ended before all was done; what is done stays.
    """
    paths = catalogue_paths(sources, folder)
    try:
        folder.mkdir(exist_ok=True)
    except OSError as error:
        raise InputError(f"{folder} cannot be made: {error.strerror}.") from error
    work_folder = folder / WORK_FOLDER
    shared = ShardFolder(work_folder, "")
    kind = model_class(model).source_kind
    chosen = {} if options is None else options.chosen()
    outcomes: dict[str, Outcome] = {}
    items: list[tuple[Shard, tuple[str, str]]] = []
    for source, path in zip(sources, paths, strict=True):
        try:
            identity = source_identity(load_source(source, kind), {"model": model, **chosen})
        except InputError as error:
            outcomes[source] = Outcome(fault=str(error))
            continue
        shard = Shard(path.stem, identity)
        if not path.exists():
            shared.forget(shard)
        items.append((shard, (source, str(path))))
    try:
        results = work_map(partial(_bake_one, model, options), items, work_folder, executor, report)
    finally:
        remove_leftovers(folder)
    outcomes |= {source: outcome for (_, (source, _)), outcome in zip(items, results, strict=True)}
    require_results(outcomes)
    return paths


def _bake_one(model: str, options: Options | None, item: tuple[str, str]) -> bytes:
    source, path = item
    save(bake(source, model, options=options), path)
    return b""


def _file_name(source: str) -> str:
    """The stem of a file's name; of a weave's name, letters and digits with "-" between."""
    path = Path(source)
    text = path.stem if path.suffix else source
    return re.sub(r"[^\w.+]+", "-", text).strip("-.") or "fabric"
