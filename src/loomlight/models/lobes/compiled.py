"""The estimate and close-ups compiled for this processor, and what they read of a fabric."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import numpy as np
from numpy.typing import NDArray

from loomlight.core.lane_code import Vectors
from loomlight.core.lane_values import SharedNumbers
from loomlight.core.machine_code import MachineCode, vectors
from loomlight.models.lobes.estimate_code import estimate_code, shared_numbers
from loomlight.models.lobes.near_code import cloth_of, near_code
from loomlight.models.lobes.tables import LobeTables
from loomlight.scattering.appearance import Appearance
from loomlight.yarn.layout import ClothLayout

Floats = NDArray[np.float32]
# Of vectors that processors have instructions for.
_LANES_PUT_TOGETHER = 16


class CompiledEstimate:
    """The estimate of one fabric."""

    def __init__(
        self,
        tables: LobeTables,
        pyramid: Sequence[NDArray[np.uint32]],
        repeat: tuple[float, float],
        roughness: tuple[float, float],
        optical_depth: float,
        wide: Vectors | None = None,
    ) -> None:
        """
        Args:
            pyramid: words of groups and of holes by node, as Dr.Jit has them: they are read where they lie.
                Behind the groups there are as many bytes as a vector has lanes, or more.
            repeat: width and height, millimetres.
            roughness: of warp and weft.
            wide: vectors to use; by default this processor's.
        """
        self._words, self._wide = tables.words, wide or vectors()
        bytes_of_pyramid = [part.view(np.float32) for part in pyramid]
        numbers = shared_numbers(tables, repeat, roughness, optical_depth, self._wide)
        self._shared = [*bytes_of_pyramid, *numbers]

    def run(self, queries: Sequence[Floats], answers: Sequence[Floats]) -> None:
        """Answers queries; see `estimate_code` for what both are."""
        _compiled(self._words, self._wide).run(len(answers[0]), queries, answers, self._shared)


def close_ups_are_compiled() -> bool:
    """Whether close-ups of batches go by machine code: it pays where lanes can be put together in memory.

    Without AVX-512 that is done lane by lane, and code for AVX2 took 3.3 times as long on one processor.
    """
    return vectors().lanes >= _LANES_PUT_TOGETHER


class CompiledCloseUps:
    """Close-ups of one fabric, mixed with what groups answer."""

    def __init__(self, layout: ClothLayout, appearance: Appearance, wide: Vectors | None = None) -> None:
        """
        Args:
            wide: vectors to use; by default twice this processor's, as each sample waits for the one before.
        """
        own = vectors()
        wide = wide or Vectors(2 * own.lanes, own.registers)
        shared = SharedNumbers()
        cloth = cloth_of(layout, appearance, shared.types)
        self._shared = shared.arrays()
        # Code knows how tables of threads are read, and nothing else of a fabric.
        warp, weft = cloth.surface.families
        kind = warp.uniform, weft.uniform, wide
        if kind not in _close_ups:
            _close_ups[kind] = MachineCode(near_code(layout, appearance, wide))
        self._code = _close_ups[kind]

    def run(self, queries: Sequence[Floats], answers: Sequence[Floats]) -> None:
        """Answers queries; see `near_code` for what both are."""
        self._code.run(len(answers[0]), queries, answers, self._shared)


_close_ups: dict[tuple[bool, bool, Vectors], MachineCode] = {}


@cache
def _compiled(words: int, wide: Vectors) -> MachineCode:
    return MachineCode(estimate_code(words, wide))
