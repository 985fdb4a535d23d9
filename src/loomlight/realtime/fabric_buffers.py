"""Fabrics in an adapter's buffers, with tables of `lobes` baked there; an edit rewrites what it changes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.models.lobes.hemisphere import NODES
from loomlight.models.lobes.model import DEFAULT_GROUPS
from loomlight.models.lobes.tables import MOMENTS, LobeTables
from loomlight.realtime.bake import BakePlan, LobesBaker, plan_bake
from loomlight.realtime.device import Adapter
from loomlight.realtime.layout import numpy_type, offset_of
from loomlight.realtime.tables import Packed, pack_fabrics
from loomlight.scattering.appearance import Appearance
from loomlight.yarn.layout import ClothLayout, FamilyLayout

Look = tuple[ClothLayout, Appearance]
# Changes of words that lie closer than this go in one write. Tables that kernels wrote are longer than that,
# and so never in between.
_NEAR = 64


class FabricBuffers:
    """Buffers of fabrics, families and words for shaders, whose tables of `lobes` kernels bake.

    An edit of colours, roughness or sheen writes the numbers that change. An edit of the yarns' heights,
    twist or widths writes the geometry and bakes that fabric again, and so does a new weave. Where tables
    change size, all are written anew, and what is baked already is copied on the adapter. Nothing is read
    back.

    Attributes:
        buffers: by name, as shaders name them; other objects after an edit that needs larger ones.
        writes: that the host made so far.
        dispatches: kernels that were launched so far.
    """

    def __init__(
        self,
        adapter: Adapter,
        looks: Sequence[Look],
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
        self._adapter = adapter
        self._looks = list(looks)
        self._uv_size_mm = None if uv_size_mm is None else list(uv_size_mm)
        self._groups = groups
        self._describe = describe
        self._baker = LobesBaker(adapter)
        self._own_writes = 0
        self.buffers: dict[str, Any] = {}
        self._plans: list[BakePlan] = []
        self._packed = self._pack()
        self._upload()
        for number in range(len(looks)):
            self._bake(number)

    @property
    def writes(self) -> int:
        """Buffers, or parts of them, that the host wrote so far."""
        return self._own_writes + self._baker.writes

    @property
    def dispatches(self) -> int:
        """Kernels that were launched so far."""
        return self._baker.dispatches

    @property
    def is_open(self) -> bool:
        """True if light passes through holes of any of the fabrics."""
        return bool(self._packed.fabrics["is_open"].any())

    def set_fabric(self, number: int, look: Look) -> None:
        """Another fabric, or an edit of it, in place of fabric `number`.

        Raises:
            MissingDependencyError: a table is beyond the adapter's limits.
        """
        before, old = self._looks[number], self._packed
        self._looks[number] = look
        self._packed = self._pack()
        is_baked = not _changes_tables(before, look)
        if not _same_tables(old, self._packed):
            kept = [other for other in range(len(self._looks)) if other != number or is_baked]
            old_buffers, self.buffers = self.buffers, {}
            self._upload()
            self._copy_tables(old_buffers, old, kept)
            for other in set(range(len(self._looks))) - set(kept):
                self._bake(other)
            return
        for name, values in self._packed.buffers().items():
            # Records: no word that a kernel wrote may be overwritten.
            gap = _NEAR if name == "words" else 1
            new_words, old_words = (part.view(np.uint32) for part in (values, old.buffers()[name]))
            for start, stop in _changed_ranges(new_words, old_words, gap):
                self._adapter.write(self.buffers[name], new_words[start:stop], 4 * start)
                self._own_writes += 1
        if not is_baked:
            self._bake(number)

    def read_tables(self, number: int) -> LobeTables:
        """The tables of a fabric, for models on the CPU and for files; waits for the device."""
        plan, packed = self._plans[number], self._packed
        record = self._adapter.read(self.buffers["fabrics"], np.uint8, packed.fabrics.nbytes)
        lobes = record.view(packed.fabrics.dtype)[number]["lobes"]
        words = self._adapter.read(self.buffers["words"], np.uint32, packed.words.size)
        parts = {
            name: words[int(lobes[name]) :][:size].view(np.uint8) for name, size in plan.table_sizes.items()
        }
        packs, nodes = plan.sizes["packs"], plan.sizes["face_nodes"]
        coverage = np.zeros((2, nodes, 4 * (packs + 1)), np.uint8)
        coverage[..., : 4 * packs] = parts["coverage"].reshape(2, nodes, 4 * packs)
        coverage[..., 4 * packs] = parts["coverage_holes"][: 2 * nodes].reshape(2, nodes)
        return LobeTables(
            base_size=plan.base_size,
            levels=plan.levels,
            coverage=coverage,
            projected_area=parts["projected_area"].reshape(2, NODES, 4 * (packs + 1)),
            light_visibility=parts["light_visibility"].reshape(2, 2, NODES, 4 * packs),
            irradiance=parts["irradiance"].reshape(2, 2, NODES, 4 * packs),
            moments=parts["moments"].view(np.float32).reshape(2, 4 * packs, MOMENTS),
            hole_weight=np.array([lobes["front_hole_weight"], lobes["back_hole_weight"]], np.float32),
            warp_packs=np.array([lobes["front_warp_packs"], lobes["back_warp_packs"]], np.int64),
        )

    def _pack(self) -> Packed:
        self._plans = [plan_bake(layout, self._groups) for layout, _ in self._looks]
        packed = pack_fabrics(self._looks, self._uv_size_mm, self._plans)
        if self._describe is not None:
            self._describe(packed.fabrics)
        return packed

    def _upload(self) -> None:
        """Makes the buffers anew."""
        for name, values in self._packed.buffers().items():
            self.buffers[name] = self._adapter.storage(values)
            self._own_writes += 1

    def _copy_tables(self, old_buffers: Mapping[str, Any], old: Packed, numbers: Sequence[int]) -> None:
        """Copies what kernels have baked for some fabrics out of the buffers before."""
        encoder = self._adapter.device.create_command_encoder()
        for number in numbers:
            places = [packed.fabrics[number]["lobes"]["coverage"] for packed in (old, self._packed)]
            begin, end = (int(4 * place) for place in places)
            size = 4 * self._plans[number].table_words
            encoder.copy_buffer_to_buffer(old_buffers["words"], begin, self.buffers["words"], end, size)
            for name in ("front_warp_packs", "front_hole_weight"):
                # The back's follows the front's.
                at = (
                    number * numpy_type("Fabric").itemsize
                    + offset_of("Fabric", "lobes")
                    + offset_of("Lobes", name)
                )
                encoder.copy_buffer_to_buffer(old_buffers["fabrics"], at, self.buffers["fabrics"], at, 8)
        self._adapter.device.queue.submit([encoder.finish()])

    def _bake(self, number: int) -> None:
        self._baker.bake(self.buffers, self._packed.fabrics, number, self._plans[number])


def _same_tables(one: Packed, other: Packed) -> bool:
    """True if all tables are at the same places: the fields that say so are whole numbers."""

    def places(records: NDArray[np.void]) -> list[NDArray[np.uint32]]:
        names = records.dtype.names or ()
        own = [records[name] for name in names if records[name].dtype == np.uint32 and name != "seed"]
        return own + (places(records["lobes"]) if "lobes" in names else [])

    pairs = ((one.fabrics, other.fabrics), (one.families, other.families))
    return one.words.size == other.words.size and all(
        np.array_equal(first, second)
        for records in pairs
        for first, second in zip(*map(places, records), strict=True)
    )


def _changes_tables(before: Look, after: Look) -> bool:
    """True if tables of lobes differ: by the yarns' geometry, or by how the diffuse term blends normals."""
    (old, old_look), (new, new_look) = before, after
    return not (
        np.array_equal(old.warp_on_top, new.warp_on_top)
        and _same_threads(old.warp, new.warp)
        and _same_threads(old.weft, new.weft)
        and old_look.diffuse_blend == new_look.diffuse_blend
    )


def _same_threads(one: FamilyLayout, other: FamilyLayout) -> bool:
    return (
        np.array_equal(one.spacing, other.spacing)
        and np.array_equal(one.width, other.width)
        and (one.inclination, one.twist, one.height_scale)
        == (other.inclination, other.twist, other.height_scale)
    )


def _changed_ranges(new: NDArray[np.uint32], old: NDArray[np.uint32], gap: int) -> Iterator[tuple[int, int]]:
    """Ranges that hold all words that differ; such words at most `gap` apart share a range."""
    changed = np.flatnonzero(new != old)
    if changed.size:
        breaks = np.flatnonzero(np.diff(changed) > gap)
        starts, stops = changed[np.r_[0, breaks + 1]], changed[np.r_[breaks, changed.size - 1]] + 1
        yield from zip(starts.tolist(), stops.tolist(), strict=True)
