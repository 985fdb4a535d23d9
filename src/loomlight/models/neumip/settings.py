"""Settings of a training: what `quality` names, and what may be chosen beside it."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass, replace
from typing import ClassVar

from loomlight.assets.sources import Source
from loomlight.core.settings import same_setting, setting
from loomlight.fabric.fabric import Fabric
from loomlight.models.mip_pyramid import PyramidShape
from loomlight.models.neumip.btf import BTFS
from loomlight.models.options import TrainingOptions
from loomlight.models.textured_model import training_identity

DEFAULT_QUALITY = "preview"
_MAX_SAMPLER_STEPS = 2000
# Part of every identity: to be raised when the same settings give other weights.
_VERSION = 5
# Texels of the width of a yarn, about, and the fewest of a repeat.
_YARN_TEXELS, _MIN_TEXELS = 10, 32


@dataclass(frozen=True)
class NeumipSettings:
    """Settings of the training of a material.

    Attributes:
        resolution: texels along the longer side of the repeat, a power of two; None for about ten a yarn
            of fabrics, and for `max_resolution` of other sources.
        max_resolution: of what None chooses.
        offset: with the neural offset module; without it, the baseline of the paper's section 3.2.
        queries: of the source, in all.
        fine_samples: rays of a query of a texel; larger footprints have more by their sides.
        samples: rays of a query, at most.
        steps: updates of the weights.
        batch: queries of a step.
        rate: largest learning rate of the networks.
        texture_rate: largest learning rate of the textures.
        offset_share: share of the training after which the offset texture stays as it is; a third in the
            released code, whose trainings are longer.
        seed: of queries, weights and batches.
        footprint_texels: side of the footprints that level 0 is for. A texel's own, as published, has a
            deviation of 0.29 texel, which bilinear interpolation blurs.
    """

    resolution: int | None = None
    max_resolution: int = 256
    offset: bool = True
    queries: int = 1 << 22
    fine_samples: int = 1
    samples: int = 4
    steps: int = 1000
    batch: int = 1 << 13
    rate: float = 1e-2
    texture_rate: float = 3e-2
    offset_share: float = 2 / 3
    seed: int = 0
    footprint_texels: int = 2

    def shape(self, source: Source) -> PyramidShape:
        """The shape of the textures of a source."""
        resolution = self.resolution or self.max_resolution
        if self.resolution is None and isinstance(source, Fabric):
            layout = source.layout()
            yarns = max(layout.size) / min(layout.warp.spacing.mean(), layout.weft.spacing.mean())
            finest = 2 ** round(math.log2(_YARN_TEXELS * yarns))
            resolution = min(max(finest, _MIN_TEXELS), resolution)
        shape = PyramidShape.of(source.repeat_mm, resolution, BTFS.of(source).faces)
        return replace(shape, footprint_texels=self.footprint_texels)

    @property
    def sampler_steps(self) -> int:
        """Updates of the sampler network."""
        return min(max(1, self.steps // 5), _MAX_SAMPLER_STEPS)

    def identity(self, source: Source) -> str:
        """A hash of all that the weights depend on, for checkpoints and folders."""
        return training_identity(source, _VERSION, asdict(self))

    def query_identity(self, source: Source) -> str:
        """A hash of all that the queries depend on: trainings that differ in the rest share them."""
        return replace(self, offset=True, steps=1, batch=1, rate=1, texture_rate=1, offset_share=1).identity(
            source
        )


QUALITIES: dict[str, NeumipSettings] = {
    "preview": NeumipSettings(),
    "full": NeumipSettings(queries=1 << 24, samples=8, steps=4000, batch=1 << 14),
}

# Texels of sources whose rays are paths, which cost more than the steps that learn from them.
_TRACED = {"preview": 128, "full": 256}


@dataclass(frozen=True, kw_only=True)
class NeumipOptions(TrainingOptions):
    """Options of `neumip`."""

    title: ClassVar[str] = "option of neumip"

    quality: str = setting(DEFAULT_QUALITY, "How long it is trained.", choices=tuple(QUALITIES))
    resolution: int | None = same_setting(
        TrainingOptions,
        "resolution",
        otherwise="about ten a yarn; of other sources 128, full 256",
    )
    offset: bool = setting(True, "With the neural offset module; without it, the paper's baseline.")

    def settings(self, is_fabric: bool) -> NeumipSettings:
        """The settings of the quality with those that are chosen.

        Args:
            is_fabric: other sources have one ray a query, smaller batches, and fewer texels in `preview`.
        """
        chosen = replace(QUALITIES[self.quality], offset=self.offset, seed=self.seed)
        if not is_fabric:
            chosen = replace(chosen, max_resolution=_TRACED[self.quality], samples=1, batch=chosen.batch // 2)
        if self.resolution is not None:
            chosen = replace(chosen, resolution=self.resolution)
        if self.steps is not None:
            chosen = replace(chosen, steps=self.steps)
        return chosen
