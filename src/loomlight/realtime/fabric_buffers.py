"""Fabrics in an adapter's buffers, with tables of `lobes` baked there; nothing is read back.

Joint visibility alone is baked on the CPU.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.llvm import llvm_float
from loomlight.models.lobes.model import DEFAULT_GROUPS
from loomlight.models.lobes.tables import bake_joint
from loomlight.realtime.bake import LobesBaker, plan_bake
from loomlight.realtime.device import Adapter
from loomlight.realtime.tables import pack_fabrics
from loomlight.scattering.appearance import Appearance
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout


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
                joint=bake_joint(YarnGeometry(layout), look.diffuse_blend, groups, llvm_float()),
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
