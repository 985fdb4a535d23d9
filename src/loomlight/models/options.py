"""Options of models: what is chosen beside the source when a model is baked.

Each model declares its own as one dataclass, `Model.options_class`; from that follow the keywords of
`loomlight.bake`, `loomlight bake --set`, properties of plugins, the record in a `.loom`, and the tables of
the documentation.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, ClassVar, Self

from loomlight.core.settings import Setting, Settings, declared, setting
from loomlight.sources.kinds import Source
from loomlight.sources.loom_file import LoomFile

DEVICES = ("cpu", "cuda")
# Texels a side of textures that are trained.
MIN_RESOLUTION, MAX_RESOLUTION = 8, 1024


@dataclass(frozen=True, kw_only=True)
class Options(Settings):
    """The options of a model; this class has none."""

    title: ClassVar[str] = "option of this model"

    @classmethod
    def of_loom(cls, loom: LoomFile, **others: Any) -> Self:
        """The options that a `.loom` tells, with others that follow from its tensors.

        Raises:
            InputError: one that is missing, or that cannot be.
        """
        stored = {name: loom.setting(name, each.kind) for name, each in declared(cls).items() if each.stored}
        return cls(**stored, **others)


@dataclass(frozen=True, kw_only=True)
class TrainingOptions(Options):
    """Options of models of textures that are trained for one source."""

    resolution: int | None = setting(
        None,
        "Texels along the longer side of the repeat, a power of two.",
        low=MIN_RESOLUTION,
        high=MAX_RESOLUTION,
        fits=lambda count: count & (count - 1) == 0,
        expected=f"a power of two from {MIN_RESOLUTION} to {MAX_RESOLUTION}",
        otherwise="by quality",
    )
    seed: int = setting(0, "Of queries, weights and batches.", low=0, high=2**32 - 1)
    steps: int | None = setting(
        None,
        "Updates of the weights.",
        low=1,
        high=10**7,
        otherwise="by quality",
        expected="a whole number from 1",
    )
    folder: str | os.PathLike[str] | None = setting(
        None,
        "Folder where queries and checkpoints stay.",
        otherwise="one that is removed at the end",
        metavar="DIR",
    )
    device: str = setting("cpu", "Device of PyTorch.", choices=DEVICES)


def is_source(option: Setting) -> bool:
    """Whether the value of an option is a source of its own, which texts name by its path."""
    return option.kind is Source
