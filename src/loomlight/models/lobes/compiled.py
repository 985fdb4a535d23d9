"""The estimate compiled for this processor, from `estimate_code`, and what it reads of a fabric."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import numpy as np
from numpy.typing import NDArray

from loomlight.core.lane_code import Vectors
from loomlight.core.machine_code import MachineCode, vectors
from loomlight.models.lobes.estimate_code import estimate_code, shared_numbers
from loomlight.models.lobes.tables import LobeTables

Floats = NDArray[np.float32]


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


@cache
def _compiled(words: int, wide: Vectors) -> MachineCode:
    return MachineCode(estimate_code(words, wide))
