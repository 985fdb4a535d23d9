"""Tables of `lobes` baked by compute kernels, into the buffers that shaders read: nothing is read back.

The sequence of kernels is data, `DISPATCHES`, and so are the sizes of buffers: a page without Python follows
the same lists from `shaders/bake.json`. A size is a sum of products of whole numbers and names of sizes.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from functools import cache
from itertools import groupby
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from loomlight.core.llvm import llvm_float
from loomlight.models.interface import ShaderTables
from loomlight.models.lobes import coverage, groups, rays
from loomlight.models.lobes.groups import FEATURES
from loomlight.models.lobes.hemisphere import NODES, pack_count
from loomlight.models.lobes.model import DEFAULT_GROUPS
from loomlight.models.lobes.tables import MOMENTS, LobeTables, bake_joint, given_numbers
from loomlight.realtime.device import Adapter
from loomlight.realtime.records import numpy_type, offset_of
from loomlight.realtime.slangc import SHADERS
from loomlight.realtime.words import pack_fabrics
from loomlight.scattering.appearance import Appearance
from loomlight.yarn.layout import ClothLayout
from loomlight.yarn.stack import cloth_geometry

# A sum of products.
Size: TypeAlias = tuple[tuple[int | str, ...], ...]

_FUNCTION = re.compile(r"^fn (\w+)", re.MULTILINE)
_WORD = re.compile(r"\w+")
_DECLARATION = re.compile(r"@binding\((\d+)\) @group\(0\) var<[\w, ]+> (\w+) : [^;]*;")
# Workgroups along x; see `bake.slang`.
_ROW_OF_GROUPS = 32768
# Slices of a storage buffer begin at multiples of so many bytes on every adapter.
_STEP_BYTES = 256
# Where weights begin among the words of a step, and their number along an axis; see `bake_coverage.slang`.
FIRST_WEIGHT = 16
_VIEW_SUMS, _LIGHT_SUMS = 13, 5
_TOP_DOWN = rays.TOP_DOWN_SAMPLES
_LIST = max(_TOP_DOWN, NODES * rays.SAMPLED_VIEWS)


@dataclass(frozen=True)
class Dispatch:
    """A kernel of the sequence.

    Attributes:
        entry: its entry point; buffers are bound by the names that the globals it uses have.
        module: the file of `shaders/wgsl` that it is in.
        threads: that it needs.
        each: "" for once; "face" and "level" repeat: consecutive ones of these run for each face, and those
            of "level" then for each level of the pyramid but the first; their uniform `steps` is that step's.
        group: threads of a workgroup.
        clears: a buffer that is set to 0 before, or "".
    """

    entry: str
    module: str
    threads: Size
    each: str = ""
    group: int = 64
    clears: str = ""


_RAYS: Size = ((2, NODES, "rays"),)
_BLOCKS_AND_GROUPS: Size = ((2, NODES, "groups"),)
DISPATCHES: tuple[Dispatch, ...] = (
    Dispatch("bake_top_down", "bake_rays", ((2, _TOP_DOWN),)),
    Dispatch("bake_views", "bake_rays", _RAYS),
    Dispatch("bake_gap_starts", "bake_rays", _RAYS),
    Dispatch("bake_gaps", "bake_points", ((256,),), group=256),
    Dispatch("bake_nulls", "bake_rays", (*_RAYS, (NODES, rays.MAX_GAP_RAYS))),
    Dispatch("bake_shadows", "bake_rays", _RAYS),
    Dispatch("bake_points", "bake_points", ((4, 256),), group=256),
    Dispatch("bake_bisect", "bake_groups", ((4, 256),), group=256),
    Dispatch("bake_refine", "bake_groups", ((4, 256),), group=256),
    Dispatch("bake_assign", "bake_groups", _RAYS),
    Dispatch("bake_view_sums", "bake_tables", _BLOCKS_AND_GROUPS),
    Dispatch("bake_light_sums", "bake_tables", _BLOCKS_AND_GROUPS),
    Dispatch("bake_zenith", "bake_tables", ((2, "groups", _VIEW_SUMS + _LIGHT_SUMS),)),
    Dispatch("bake_moments", "bake_tables", ((2, "groups"),)),
    Dispatch("bake_areas", "bake_tables", ((2, NODES),)),
    Dispatch("bake_area_scales", "bake_tables", ((2, "groups"), (2,))),
    Dispatch("bake_pack_areas", "bake_tables", ((2, NODES, "width"),)),
    Dispatch("bake_pack_light", "bake_tables", ((4, NODES, "packs"),)),
    Dispatch(
        "bake_texels",
        "bake_rays",
        ((2, "columns", "rows", "texels_across", "texels_along"),),
        clears="texel_counts",
    ),
    # Twice: what rows sum up to first says which groups are hidden from above.
    Dispatch("bake_row_totals", "bake_coverage", (("rows", "width"),), each="face"),
    Dispatch("bake_stand_ins", "bake_coverage", ((4, "width"),), each="face"),
    Dispatch("bake_cover_hidden", "bake_rays", (("columns", "rows"),), each="face"),
    Dispatch("bake_first_level", "bake_coverage", (("columns", "rows", "width"),), each="face"),
    Dispatch("bake_row_totals", "bake_coverage", (("rows", "width"),), each="face"),
    Dispatch("bake_coverage_scales", "bake_coverage", ((4, "width"),), each="face"),
    Dispatch("bake_downsample", "bake_coverage", (("level_columns", "level_rows", "width"),), each="level"),
    Dispatch("bake_pack_coverage", "bake_coverage", (("face_nodes", "width"),), each="face"),
    Dispatch("bake_pack_holes", "bake_coverage", (("face_nodes",),)),
    Dispatch("bake_pack_moments", "bake_tables", ((8, "packs"), (2,))),
)
# Words of the parts of `scratch`, whose beginnings are fields of the record `Bake`.
SCRATCH: dict[str, Size] = {
    "facts": ((64,),),
    "gaps": ((2, rays.MAX_GAP_RAYS),),
    "gap_nulls": ((NODES, rays.MAX_GAP_RAYS),),
    "lit": _RAYS,
    "lists": ((5, _LIST),),
    "points": ((4, groups.CLUSTERED_SAMPLES, FEATURES),),
    "clusters": ((4, "max_clusters", 1 + FEATURES + FEATURES * (FEATURES + 1) // 2),),
    "cluster_means": ((4, "max_clusters", "max_clusters", FEATURES),),
    "cluster_errors": ((4, "max_clusters"),),
    "centroids": ((2, "groups", FEATURES),),
    "view_sums": ((2, NODES, "groups", _VIEW_SUMS),),
    "light_sums": ((2, NODES, "groups", _LIGHT_SUMS),),
    "group_moments": ((2, "groups", MOMENTS),),
    "areas": ((2, NODES, "groups"), (2, NODES)),
    "area_scales": ((2, "groups"), (2,)),
    "stand_ins": ((8, "width"),),
    "row_totals": ((4, "rows", "width"),),
    "row_largest": ((4, "rows", "width"),),
    "coverage_means": ((8, "width"),),
    "coverage_scales": ((8, "width"),),
    "hole_bytes": ((2, "face_nodes"),),
}
# Bytes of the other buffers that only baking uses.
BUFFER_BYTES: dict[str, Size] = {
    "hits": ((44, 2, NODES, "rays"), (44, 2, _TOP_DOWN)),
    "texel_counts": ((4, 2, "columns", "rows", "width"),),
    "coverage_pyramid": ((16, "face_nodes", "width"),),
}
# The kernel of the openness of yarns, which runs on its own, and the file that it is in.
OPENNESS_KERNEL = "bake_openness"
# Words that it writes for each ray; `bake_openness.slang` has their order.
RAY_RESULTS = 10
# Names that kernels have for buffers which they write and others read.
ALIASES = {"texel_counters": "texel_counts", "tables": "words", "record_words": "fabrics"}


@dataclass(frozen=True, eq=False)
class BakePlan:
    """Sizes of the bake of one fabric: all follow from the draft's size and the number of groups.

    Attributes:
        values: fields of the record `Bake` that depend on neither buffers nor other fabrics.
        sizes: names in sizes, and their values.
        levels: first node, columns and rows of each level of the coverage pyramid [levels, 3].
        base_size: side of the squares of its first level, millimetres.
        blur: weights of the taps across and along that make tents of cells, the middle one first.
        given: numbers that `LobeTables` declares as given.
        joint: `LobeTables.joint`, which no kernel bakes; None leaves ratios at 1.
    """

    values: Mapping[str, float]
    sizes: Mapping[str, int]
    levels: NDArray[np.int64]
    base_size: float
    blur: tuple[list[float], list[float]]
    given: Mapping[str, float]
    joint: NDArray[np.int16] | None = None

    def shader_tables(self) -> ShaderTables:
        """Room for the tables, and what of them is known; what kernels find out stays 0.

        Joint visibility that is not known stays 0 too, which makes ratios of 1.
        """
        known: dict[str, Any] = {"levels": self.levels, "base_size": self.base_size}
        if self.joint is not None:
            known["joint"] = self.joint
        return ShaderTables(LobeTables.zeros(self.sizes, **known), self.given)

    def value_of(self, size: Size, more: Mapping[str, int] | None = None) -> int:
        """A size as a number; `more` are names that depend on the level."""
        names = {**self.sizes, **(more or {})}
        return sum(
            math.prod(names[part] if isinstance(part, str) else part for part in parts) for parts in size
        )


def plan_bake(layout: ClothLayout, per_family: int) -> BakePlan:
    """The plan of a fabric's bake with so many groups of each family, 1 to 64, on average."""
    geometry = cloth_geometry(layout)
    spacing = coverage.spacing_of(geometry, per_family)
    picks, ends = layout.warp_on_top.shape
    columns, rows = (coverage.nodes_along(side, spacing) for side in geometry.size)
    across, along = (
        coverage.texels_along(threads, count) for threads, count in ((ends, columns), (picks, rows))
    )
    levels = _levels(columns, rows)
    face_nodes = int(levels[-1, 0]) + 1
    sizes = {
        "per_family": per_family,
        "groups": 2 * per_family,
        "packs": pack_count(per_family),
        "width": pack_count(per_family) + 1,
        "max_clusters": max(per_family, 2 * per_family - groups.GROUPS_PER_PACK),
        "rays": rays.ray_count(per_family),
        "columns": columns,
        "rows": rows,
        "face_nodes": face_nodes,
        "texels_across": across,
        "texels_along": along,
    }
    width, height = geometry.size
    values: dict[str, float] = {
        name: value for name, value in sizes.items() if name not in ("groups", "width")
    }
    values |= {
        "ends": ends,
        "picks": picks,
        "spacing_x": width / ends,
        "spacing_y": height / picks,
        "texel_x": width / (columns * across),
        "texel_y": height / (rows * along),
        "far_weight": spacing.far_weight,
    }
    blur = tuple(
        _tap_weights([float(w) for w in coverage.blur_steps(spacing.base_size * count / side)])
        for count, side in zip((columns, rows), geometry.size, strict=True)
    )
    given = given_numbers(layout, spacing.base_size)
    return BakePlan(values, sizes, levels, spacing.base_size, (blur[0], blur[1]), given)


def _levels(columns: int, rows: int) -> NDArray[np.int64]:
    """First node, columns and rows of all levels down to one node."""
    levels, first = [], 0
    while True:
        levels.append((first, columns, rows))
        if columns * rows == 1:
            return np.array(levels, np.int64)
        first += columns * rows
        columns, rows = -(-columns // 2), -(-rows // 2)


def _tap_weights(steps: Sequence[float]) -> list[float]:
    """Weights of the cell itself and of those 1, 2, … cells away after all blur steps."""
    weights = np.ones(1)
    for share in steps:
        weights = np.convolve(weights, [share, 1 - 2 * share, share])
    return [float(weight) for weight in weights[len(steps) :]]


class LobesBaker:
    """Bakes tables of `lobes` on an adapter.

    Attributes:
        dispatches: kernels that were launched so far.
    """

    def __init__(self, adapter: Adapter) -> None:
        self._adapter = adapter
        self._own: dict[str, Any] = {}
        self.dispatches = 0

    def bake(
        self, buffers: Mapping[str, Any], records: NDArray[np.void], number: int, plan: BakePlan
    ) -> None:
        """Bakes the tables of a fabric into the buffers that hold it; returns before the device is done.

        Args:
            buffers: fabrics, families and words, where its geometry is already.
            records: of all fabrics, as they were written.
            number: of the fabric.

        Raises:
            MissingDependencyError: a table is beyond the adapter's limits.
        """
        resources = {
            **buffers,
            **self._buffers_of(plan),
            "bakes": self._own_storage("bakes", _bake_record(plan, records, number)),
        }
        resources |= {alias: resources[name] for alias, name in ALIASES.items()}
        steps = self._own_storage("steps", _steps(plan))
        is_layered = bool(records[number]["planes"] > 0)
        encoder = self._adapter.device.create_command_encoder()
        for is_repeated, of_sequence in groupby(DISPATCHES, lambda one: bool(one.each)):
            sequence = list(of_sequence)
            for face in range(2 if is_repeated else 1):
                for dispatch in sequence:
                    of_level = dispatch.each == "level"
                    for level in range(1, len(plan.levels)) if of_level else (0,):
                        step = face * len(plan.levels) + level
                        resources["steps"] = {
                            "buffer": steps,
                            "offset": step * _STEP_BYTES,
                            "size": _STEP_BYTES,
                        }
                        _, columns, rows = (int(part) for part in plan.levels[level])
                        threads = plan.value_of(
                            dispatch.threads, {"level_columns": columns, "level_rows": rows}
                        )
                        if dispatch.clears:
                            encoder.clear_buffer(resources[dispatch.clears])
                        self._encode(encoder, dispatch, threads, resources, is_layered)
        self._adapter.device.queue.submit([encoder.finish()])

    def _encode(
        self, encoder: Any, dispatch: Dispatch, threads: int, resources: Mapping[str, Any], is_layered: bool
    ) -> None:
        pipeline = self._adapter.pipeline(module_text(dispatch.module), dispatch.entry, is_layered)
        used = "\n".join(declarations_of(dispatch.module, dispatch.entry))
        count = -(-threads // dispatch.group)
        compute = encoder.begin_compute_pass()
        compute.set_pipeline(pipeline)
        compute.set_bind_group(0, self._adapter.bindings(pipeline, used, resources))
        compute.dispatch_workgroups(min(count, _ROW_OF_GROUPS), -(-count // _ROW_OF_GROUPS))
        compute.end()
        self.dispatches += 1

    def _buffers_of(self, plan: BakePlan) -> dict[str, Any]:
        """Buffers for what lies between the kernels, kept from bake to bake where they are large enough."""
        sizes = {name: plan.value_of(size) for name, size in BUFFER_BYTES.items()}
        sizes["scratch"] = 4 * sum(plan.value_of(size) for size in SCRATCH.values())
        for name, size in sizes.items():
            if name not in self._own or self._own[name].size < size:
                self._own[name] = self._adapter.empty_storage(size)
        return {name: self._own[name] for name in sizes}

    def _own_storage(self, name: str, values: NDArray[Any]) -> Any:
        """A small buffer that is rewritten for every bake."""
        if name in self._own and self._own[name].size >= values.nbytes:
            self._adapter.write(self._own[name], values)
        else:
            self._own[name] = self._adapter.storage(values)
        return self._own[name]


def _bake_record(plan: BakePlan, records: NDArray[np.void], number: int) -> NDArray[np.void]:
    record = np.zeros(1, numpy_type("Bake"))
    for name, value in plan.values.items():
        record[name] = value
    first = 0
    for name, size in SCRATCH.items():
        record[name] = first
        first += plan.value_of(size)
    begin = number * records.dtype.itemsize + offset_of("Fabric", "lobes")
    record["fabric"] = number
    record["moments_table"] = records[number]["lobes"]["moments"]
    record["record_warp_packs"] = (begin + offset_of("Lobes", "front_warp_packs")) // 4
    record["record_hole_weights"] = (begin + offset_of("Lobes", "front_hole_weight")) // 4
    return record


def _steps(plan: BakePlan) -> NDArray[np.uint32]:
    """The uniform of each face and level."""
    steps = np.zeros((2, len(plan.levels), _STEP_BYTES // 4), np.uint32)
    steps[1, :, 0] = 1
    steps[:, :, 1:4] = plan.levels
    steps[:, 1:, 4:7] = plan.levels[:-1]
    for axis, weights in enumerate(plan.blur):
        begin = FIRST_WEIGHT * (axis + 1)
        steps[:, :, 7 + axis] = len(weights) - 1
        steps[:, :, begin : begin + len(weights)] = np.array(weights, np.float32).view(np.uint32)
    return steps


@cache
def module_text(module: str) -> str:
    """The WGSL of a module's kernels."""
    return (SHADERS / "wgsl" / f"{module}.wgsl").read_text(encoding="utf-8")


@cache
def declarations_of(module: str, entry: str) -> tuple[str, ...]:
    """Declarations of the buffers that an entry point uses: a bind group must have these and no others."""
    text = module_text(module)
    # Without declarations: they stand between functions.
    parts = _FUNCTION.split(_DECLARATION.sub("", text))
    words = {name: set(_WORD.findall(body)) for name, body in zip(parts[1::2], parts[2::2], strict=True)}
    called, waiting = set(), [entry]
    while waiting:
        name = waiting.pop()
        if name not in called:
            called.add(name)
            waiting += [other for other in words[name] if other in words]
    used = set().union(*(words[name] for name in called))
    return tuple(match[0] for match in _DECLARATION.finditer(text) if match[2] in used)


def manifest() -> str:
    """`shaders/bake.json`: the sequence of kernels and the sizes of buffers, for hosts without Python."""
    content = {
        "about": "Tables of lobes baked by compute kernels; written by loomlight/realtime/bake.py. "
        "Sizes are sums of products; workgroups = ceil(threads / group), at most row_of_groups along x.",
        "row_of_groups": _ROW_OF_GROUPS,
        "step_bytes": _STEP_BYTES,
        "dispatches": [
            {**asdict(dispatch), "bindings": _bindings_of(dispatch.module, dispatch.entry)}
            for dispatch in DISPATCHES
        ],
        "scratch_words": SCRATCH,
        "buffer_bytes": BUFFER_BYTES,
        "aliases": ALIASES,
        "openness": {"group": 64, "bindings": _bindings_of(OPENNESS_KERNEL, OPENNESS_KERNEL)},
    }
    return json.dumps(content, indent=1) + "\n"


def _bindings_of(module: str, entry: str) -> dict[str, int]:
    """Bindings by the name of the buffer; WGSL's names end in a number of the compiler's."""
    found = (_DECLARATION.fullmatch(text) for text in declarations_of(module, entry))
    return {match[2].rsplit("_", 1)[0]: int(match[1]) for match in found if match is not None}


# --------------------------------------------------------------------------------------------- fabric buffers
# Fabrics in an adapter's buffers, with tables of `lobes` baked there; nothing is read back.
#
# Joint visibility alone is baked on the CPU.


class FabricBuffers:
    """Buffers of fabrics, families and words for shaders, whose tables of `lobes` kernels bake.

    Attributes:
        buffers: by name, as shaders name them.
        plans: of each fabric's bake.
        packed: what the host wrote.
        dispatches: kernels that were launched.
    """

    def __init__(
        self,
        adapter: Adapter,
        looks: Sequence[tuple[ClothLayout, Appearance]],
        uv_size_mm: Sequence[tuple[float, float]] | None = None,
        groups: int = DEFAULT_GROUPS,
        describe: Callable[[NDArray[np.void]], None] | None = None,
    ) -> None:
        """Uploads fabrics and bakes their tables; returns before the device is done.

        Args:
            uv_size_mm: millimetres per unit of u and of v of each fabric; 100 by default.
            groups: of each family, 1 to 64, on average.
            describe: writes into the records of fabrics what a scene adds to them.

        Raises:
            MissingDependencyError: a table is beyond the adapter's limits.
        """
        self.plans = [
            replace(
                plan_bake(layout, groups),
                joint=bake_joint(cloth_geometry(layout), look.diffuse_blend, groups, llvm_float()),
            )
            for layout, look in looks
        ]
        self.packed = pack_fabrics(list(looks), uv_size_mm, [plan.shader_tables() for plan in self.plans])
        if describe is not None:
            describe(self.packed.fabrics)
        self.buffers: dict[str, Any] = {
            name: adapter.storage(values) for name, values in self.packed.buffers().items()
        }
        baker = LobesBaker(adapter)
        for number, plan in enumerate(self.plans):
            baker.bake(self.buffers, self.packed.fabrics, number, plan)
        self.dispatches = baker.dispatches

    @property
    def is_open(self) -> bool:
        """True if light passes through holes of any of the fabrics."""
        return bool(self.packed.fabrics["is_open"].any())
