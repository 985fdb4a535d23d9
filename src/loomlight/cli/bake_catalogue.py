"""Baking many sources, on as many processes and machines as there are."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import partial
from pathlib import Path

from loomlight.core.errors import InputError
from loomlight.core.files import remove_leftovers
from loomlight.core.fleet import Executor, Outcome, Report, Shard, ShardFolder, require_results, work_map
from loomlight.models.bake import bake, save
from loomlight.models.options import Options
from loomlight.models.registry import model_class
from loomlight.sources.load import load_source, source_identity

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
