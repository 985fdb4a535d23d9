"""Queries of materials with their truth, on disk: a Zarr v3 group with a group for each material.

    queries.zarr/
      zarr.json            format, version, seed, queries a material, parameter ranges, provenance
      material_0042/
        zarr.json          the weave and the yarns' parameters
        lights, views      unit vectors [l, 3] and [v, 3], float32
        pairs              index of light and view [n, 2], uint16
        centres, sizes     footprints [m, 2] and [m], millimetres, float32
        components         C_warp, C_weft, S_warp, S_weft of each pair over each footprint [n, m, 4], 1/sr
        holes              hole of each view over each footprint [v, m]

Values are float16, which rounds them by 0.02 % on average and by 0.05 % at most, less than the error of their
grid. The components of a material are one shard of compressed chunks with checksums. A material appears by
one rename, so every material in a store is complete.
"""

from __future__ import annotations

import errno
import json
import os
import re
import shutil
import warnings
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from functools import cache, partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.aggregate.components import CHANNELS, COMPONENTS
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.extras import import_extra
from loomlight.core.files import discarding_empty
from loomlight.core.fleet import Executor, Shard, ShardFolder, require_results, work_map
from loomlight.core.provenance import provenance
from loomlight.models.neural.learned_truth import ENTRY, moved_since, truth_numbers
from loomlight.models.neural.weights import PARAMETER_RANGES
from studies.papers.chen2024.materials import MATERIALS, paper_material
from studies.papers.chen2024.queries import (
    FULL_QUERIES,
    MIN_QUERIES,
    MaterialQueries,
    material_queries,
    slice_means,
)

FORMAT = "loomlight neural queries"
VERSION = 1
# Bytes of one query, compressed (measured: 5.6 in full sets, 6.5 in small ones).
BYTES_A_QUERY = 6.5
_CHUNK_PAIRS = 64
_NAME = re.compile(r"material_(\d{4})")


@dataclass(frozen=True)
class StoreSettings:
    """Settings of all materials of a store.

    Attributes:
        seed: of parameters and queries.
        queries: about so many a material.
    """

    seed: int = 0
    queries: int = FULL_QUERIES

    def attributes(self) -> dict[str, Any]:
        """Attributes of the store's group, without provenance."""
        return {
            "format": FORMAT,
            "version": VERSION,
            "seed": self.seed,
            "queries_a_material": self.queries,
            "materials": len(MATERIALS),
            "channels": list(CHANNELS),
            "units": {"components": "1/sr", "centres": "mm", "sizes": "mm"},
            # As JSON gives them back: lists for tuples.
            "ranges": {
                k: list(v) if isinstance(v, tuple) else v for k, v in asdict(PARAMETER_RANGES).items()
            },
        }


@dataclass(frozen=True, eq=False)
class StoredMaterial:
    """One material of a store.

    Attributes:
        number: 0 to 464.
        queries: directions and footprints.
        components: of each pair over each footprint [n, m, 4], 1/sr.
        holes: of each view over each footprint [v, m].
    """

    number: int
    queries: MaterialQueries
    components: NDArray[np.float16]
    holes: NDArray[np.float16]

    def truth(self) -> NDArray[np.float32]:
        """All five channels of each query [n, m, 5], as in `queries.slice_means`."""
        holes = self.holes[self.queries.pairs[:, 1]][..., None]
        return np.concatenate([self.components, holes], axis=-1).astype(np.float32)


class QueryStore:
    """Reads a store; every array is validated when it is read.

    Attributes:
        path: its folder.
        settings: of all its materials.
        numbers: of the finished materials.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        """Opens the store at `path`.

        Raises:
            InputError: there is none, it is not of this format, of another version, or damaged.
            MissingDependencyError: zarr is not installed.
        """
        self.path = Path(path)
        attributes = _read_attributes(self.path)
        self.settings = StoreSettings(attributes["seed"], attributes["queries_a_material"])
        self.attributes = attributes

    @property
    def numbers(self) -> tuple[int, ...]:
        """The materials that are finished, ascending."""
        return finished(self.path)

    def material(self, number: int) -> StoredMaterial:
        """The arrays of material `number`.

        Raises:
            InputError: it is not there, or damaged.
        """
        folder = _folder(self.path, number)
        if not folder.is_dir():
            raise InputError(
                f"{self.path} has no material {number}; it has {_listed(self.numbers)}: "
                f"`python -m studies.papers.chen2024.data --materials {number}` adds it."
            )
        try:
            group = _zarr().open_group(str(folder), mode="r")
            arrays = {name: np.asarray(_member(group, name)[:]) for name in _LAYOUT}
            _check(arrays)
        # The exceptions of Zarr and its codecs on damaged files have no common base.
        except Exception as error:
            raise InputError(
                f"{folder} is damaged ({_reason(error)}); delete that folder and run again what made it."
            ) from error
        queries = MaterialQueries(**{name: arrays[name] for name in _QUERY_ARRAYS})
        return StoredMaterial(number, queries, arrays["components"], arrays["holes"])


def make_store(
    path: str | os.PathLike[str],
    numbers: Sequence[int],
    settings: StoreSettings,
    float_type: type,
    command: str,
    report: Callable[[int, int], None] = lambda done, total: None,
    executor: Executor | None = None,
) -> tuple[int, ...]:
    """Writes materials into a new store or one with the same settings; returns all finished ones.

    Finished materials are kept, so an interrupted run resumes. Several programs may write different materials
    into one store.

    Args:
        float_type: the Dr.Jit Float type to compute with.
        command: recorded in the provenance.
        report: called with (materials done, materials in all).
        executor: who works; this process by default.

    Raises:
        InputError: `path` is something else or has other settings, a number does not exist, or the disk is
            full; finished materials stay.
        MissingDependencyError: zarr is not installed.
    """
    store = Path(path)
    _zarr()
    require_valid_settings(settings)
    for number in numbers:
        if not 0 <= number < len(MATERIALS):
            raise InputError(f"material {number} does not exist: numbers go from 0 to {len(MATERIALS) - 1}.")
    try:
        with discarding_empty(store):
            _prepare(store, settings, command, float_type)
        done = set(finished(store))
        missing = [number for number in numbers if number not in done]
        if missing:
            _require_same_truth(store, float_type)
        _warn_of_space(store, len(missing), settings)
        if executor is None or executor == Executor():
            for index, number in enumerate(missing):
                report(len(numbers) - len(missing) + index, len(numbers))
                _write_material(store, number, settings, float_type)
        elif missing:
            _write_shards(store, missing, settings, float_type, executor, report)
        report(len(numbers), len(numbers))
    except OSError as error:
        raise InputError(_cut_off(store, error)) from error
    return finished(store)


def _write_shards(
    store: Path,
    numbers: Sequence[int],
    settings: StoreSettings,
    float_type: type,
    executor: Executor,
    report: Callable[[int, int], None],
) -> None:
    """Materials by several processes; claims and markers lie beside the store until all are done."""
    folder = store.with_name(f".loomlight-{store.name}.parts")
    identity = json.dumps([str(store.resolve()), settings.attributes()], sort_keys=True)
    items = [(Shard(f"material_{number:04d}", identity), number) for number in numbers]
    shared = ShardFolder(folder, "")
    for shard, _ in items:
        shared.forget(shard)  # the material is not in the store
    function = partial(_write_shard, str(store), settings, float_type)
    outcomes = work_map(function, items, folder, executor, report)
    require_results({shard.key: outcome for (shard, _), outcome in zip(items, outcomes, strict=True)})
    shutil.rmtree(folder, ignore_errors=True)


def _write_shard(store: str, settings: StoreSettings, float_type: type, number: int) -> bytes:
    try:
        if number not in finished(Path(store)):
            _write_material(Path(store), number, settings, float_type)
    except OSError as error:
        raise InputError(_cut_off(Path(store), error)) from error
    return b""


def require_valid_settings(settings: StoreSettings) -> None:
    """Raises InputError unless the seed is at least 0 and the number of queries is in range."""
    if settings.seed < 0:
        raise InputError(f"seed {settings.seed} is negative: give 0 or more.")
    if not MIN_QUERIES <= settings.queries <= FULL_QUERIES:
        raise InputError(
            f"{settings.queries} queries a material are out of range: {MIN_QUERIES} to {FULL_QUERIES} fit."
        )


def finished(path: Path) -> tuple[int, ...]:
    """The numbers of the materials in a store, ascending."""
    found = (_NAME.fullmatch(entry.name) for entry in path.iterdir() if entry.is_dir())
    return tuple(sorted(int(match[1]) for match in found if match))


_QUERY_ARRAYS = ("lights", "views", "pairs", "centres", "sizes")
# Type and shape of each array, a letter an extent.
_LAYOUT = {
    "lights": (np.float32, ("l", 3)),
    "views": (np.float32, ("v", 3)),
    "pairs": (np.uint16, ("n", 2)),
    "centres": (np.float32, ("m", 2)),
    "sizes": (np.float32, ("m",)),
    "components": (np.float16, ("n", "m", len(COMPONENTS))),
    "holes": (np.float16, ("v", "m")),
}


def _folder(store: Path, number: int) -> Path:
    return store / f"material_{number:04d}"


def _prepare(store: Path, settings: StoreSettings, command: str, float_type: type) -> None:
    """Makes the store's folder and root, or checks that what is there has the same settings."""
    if store.exists() and not store.is_dir():
        raise InputError(f"{store} is a file; give the name of a folder that ends in .zarr.")
    store.mkdir(exist_ok=True)
    root = store / "zarr.json"
    if not root.exists():
        if any(not entry.name.startswith(".partial") for entry in store.iterdir()):
            raise InputError(f"{store} is a folder with other files in it; give the name of a new one.")
        partial = store / ".partial-root"
        made_with = {**provenance(command, Path(__file__).parent), ENTRY: _truth_now(float_type)}
        attributes = settings.attributes() | {"made_with": made_with}
        try:
            _zarr().open_group(str(partial), mode="w", zarr_format=3, attributes=attributes)
            (partial / "zarr.json").replace(root)
        finally:
            shutil.rmtree(partial, ignore_errors=True)
        return
    there = _read_attributes(store)
    for name, expected in settings.attributes().items():
        if there[name] != expected:
            raise InputError(
                f"{store} was made with {name} = {there[name]}, not {expected}: "
                "give the same settings, or the name of a new store."
            )


@cache
def _truth_now(float_type: type) -> list[float]:
    return truth_numbers(float_type)


def _require_same_truth(store: Path, float_type: type) -> None:
    """Raises InputError if the store has materials of yarns that this version computes otherwise."""
    made_with = _read_attributes(store)["made_with"]
    if moved_since(made_with, _truth_now(float_type)) is not None:
        raise InputError(
            f"{store} has materials of yarns that this version computes otherwise: "
            "give the name of a new store."
        )


def _read_attributes(store: Path) -> dict[str, Any]:
    if not store.is_dir():
        raise InputError(
            f"{store} is no folder; a store of queries is one, made by "
            "`python -m studies.papers.chen2024.data`."
        )
    zarr = _zarr()
    try:
        attributes = dict(zarr.open_group(str(store), mode="r", zarr_format=3).attrs)
    # What Zarr raises on foreign and damaged metadata has no common base.
    except Exception as error:
        raise InputError(f"{store} is no store of queries: its zarr.json is missing or damaged.") from error
    if attributes.get("format") != FORMAT:
        raise InputError(
            f"{store} is a Zarr group, but no store of queries made by "
            "`python -m studies.papers.chen2024.data`."
        )
    if attributes.get("version") != VERSION:
        raise InputError(
            f"{store} has version {attributes.get('version')} of its format, and this program reads "
            f"{VERSION}: make it again with `python -m studies.papers.chen2024.data`."
        )
    expected = StoreSettings().attributes() | {"made_with": {}}
    for name, value in expected.items():
        if not isinstance(attributes.get(name), type(value)):
            raise InputError(f'{store}: "{name}" in its zarr.json is missing or damaged.')
    return attributes


def _write_material(store: Path, number: int, settings: StoreSettings, float_type: type) -> None:
    fabric = paper_material(number, settings.seed)
    queries = material_queries(number, settings.seed, settings.queries)
    values = slice_means(fabric, queries, float_type)
    _, first_pair = np.unique(queries.pairs[:, 1], return_index=True)
    arrays = {name: getattr(queries, name) for name in _QUERY_ARRAYS}
    arrays["components"] = values[..., : len(COMPONENTS)].astype(np.float16)
    arrays["holes"] = values[first_pair, :, len(COMPONENTS)].astype(np.float16)
    _check(arrays)
    partial = store / f".partial-{number:04d}"
    try:
        # Left by a program that was killed.
        shutil.rmtree(partial, ignore_errors=True)
        yarns = {
            family: getattr(fabric.fields, family).model_dump(exclude_none=True)
            for family in ("warp", "weft")
        }
        attributes = {"weave": MATERIALS[number].weave, **yarns}
        group = _zarr().open_group(str(partial), mode="w", zarr_format=3, attributes=attributes)
        for name, array in arrays.items():
            _write_array(group, name, array)
        _flush(partial)
        partial.rename(_folder(store, number))
    except OSError as error:
        # Another program may have finished the same material just before.
        if error.errno not in (errno.ENOTEMPTY, errno.EEXIST) or not _folder(store, number).is_dir():
            raise
    finally:
        shutil.rmtree(partial, ignore_errors=True)


def _write_array(group: Any, name: str, array: NDArray[Any]) -> None:
    from zarr.codecs import BloscCodec, Crc32cCodec

    # Shuffled bytes compress to two thirds; checksums tell when a chunk is damaged.
    codecs = [
        BloscCodec(cname="zstd", clevel=3, shuffle="shuffle", typesize=array.dtype.itemsize),
        Crc32cCodec(),
    ]
    layout: dict[str, Any] = {"chunks": array.shape}
    if name == "components":
        whole = -(-len(array) // _CHUNK_PAIRS) * _CHUNK_PAIRS
        layout = {"chunks": (_CHUNK_PAIRS, *array.shape[1:]), "shards": (whole, *array.shape[1:])}
    group.create_array(name, data=array, compressors=codecs, **layout)


def _flush(folder: Path) -> None:
    """Waits until all files are on the disk: only then may the folder take its final name."""
    for file in folder.rglob("*"):
        if file.is_file():
            with file.open("rb") as handle:
                os.fsync(handle.fileno())


def _zarr() -> Any:
    """The package zarr, which only stored data sets need.

    Raises:
        MissingDependencyError: it is not installed.
    """
    return import_extra("zarr", "data", "A stored data set")


def _member(group: Any, name: str) -> Any:
    if name not in group:
        raise ValueError(f"{name} is missing")
    return group[name]


def _check(arrays: dict[str, NDArray[Any]]) -> None:
    """Raises ValueError if types, shapes or values are not those of a material."""
    extents: dict[str, int] = {}
    for name, (dtype, letters) in _LAYOUT.items():
        array = arrays[name]
        if array.dtype != dtype or array.ndim != len(letters):
            raise ValueError(f"{name} is {array.dtype} with {array.ndim} axes")
        for letter, extent in zip(letters, array.shape, strict=True):
            expected = letter if isinstance(letter, int) else extents.setdefault(letter, extent)
            if extent != expected or extent == 0:
                raise ValueError(f"{name} has the shape {array.shape}")
        if not np.isfinite(array).all():
            raise ValueError(f"{name} holds numbers that are not finite")
    pairs = arrays["pairs"]
    if pairs[:, 0].max() >= extents["l"] or pairs[:, 1].max() >= extents["v"]:
        raise ValueError("pairs name directions that are not there")


def _warn_of_space(store: Path, materials: int, settings: StoreSettings) -> None:
    needed = materials * settings.queries * BYTES_A_QUERY
    free = shutil.disk_usage(store).free
    if needed > free:
        message = (
            f"{materials} materials take about {_bytes(needed)}, and the disk of {store} has "
            f"{_bytes(free)} free; what fits will be usable."
        )
        warnings.warn(message, LoomlightWarning, stacklevel=3)


def _bytes(count: float) -> str:
    return f"{count / 1e9:.1f} GB" if count >= 1e9 else f"{count / 1e6:.1f} MB"


def _cut_off(store: Path, error: OSError) -> str:
    full = error.errno in (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)
    reason = "the disk is full" if full else str(error.strerror or error)
    there = finished(store) if store.is_dir() else ()
    return (
        f"{store} cannot be written: {reason}; {_listed(there)} finished and usable, "
        "and the same command goes on from there."
    )


def _listed(numbers: Sequence[int]) -> str:
    """Numbers as ranges: "materials 0–6, 9 (8 of 465)"."""
    if not numbers:
        return f"none of {len(MATERIALS)} materials"
    runs: list[list[int]] = []
    for number in numbers:
        if runs and runs[-1][-1] == number - 1:
            runs[-1].append(number)
        else:
            runs.append([number])
    shown = [f"{run[0]}–{run[-1]}" if len(run) > 1 else f"{run[0]}" for run in runs]
    if len(shown) > 8:
        shown = [*shown[:8], "…"]
    return f"materials {', '.join(shown)} ({len(numbers)} of {len(MATERIALS)})"


def _reason(error: Exception) -> str:
    return " ".join(str(error).split())[:120] or type(error).__name__
