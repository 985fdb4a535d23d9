"""Settings of trainings: what all of them have, what `neumip` and `latent` add, and what `quality` names."""

from __future__ import annotations

import hashlib
import math
from dataclasses import asdict, dataclass, replace
from typing import ClassVar, TypeVar

import numpy as np

from loomlight.core.settings import same_setting, setting
from loomlight.fabric.fabric import Fabric
from loomlight.models.options import TrainingOptions
from loomlight.models.texture.pyramid import PyramidShape
from loomlight.sources.kinds import SOURCE_KINDS, Source, kind_of_source

DEFAULT_QUALITY = "preview"


@dataclass(frozen=True)
class TrainingSettings:
    """What every training of textures and networks depends on beside its source.

    Attributes:
        version: part of every identity: to be raised when the same settings give other weights.
        resolution: texels along the longer side of the repeat, a power of two; None where it is chosen by the
            source.
        queries: of the source, in all.
        samples: rays of a query, or estimates of which its value is the mean, at most.
        steps: updates of textures and networks.
        batch: queries of a step.
        rate: largest learning rate of the networks.
        texture_rate: largest learning rate of the textures.
        seed: of queries, weights and batches.
    """

    version: ClassVar[int]
    resolution: int | None
    queries: int
    samples: int
    steps: int
    batch: int
    rate: float
    texture_rate: float
    seed: int

    def identity(self, source: Source) -> str:
        """A hash of all that the weights depend on, for checkpoints and folders."""
        record, tensors = SOURCE_KINDS[kind_of_source(source)].record(source)
        settings = sorted(asdict(self).items())
        digest = hashlib.sha256(repr((self.version, settings, sorted(record.items()))).encode())
        for name in sorted(tensors):
            digest.update(name.encode() + np.ascontiguousarray(tensors[name]).tobytes())
        return digest.hexdigest()


SettingsT = TypeVar("SettingsT", bound=TrainingSettings)


def _chosen(quality: SettingsT, options: TrainingOptions) -> SettingsT:
    """The settings of a quality, with what is chosen of those that all models have."""
    chosen = replace(quality, seed=options.seed)
    if options.resolution is not None:
        chosen = replace(chosen, resolution=options.resolution)
    return chosen if options.steps is None else replace(chosen, steps=options.steps)


# ----------------------------------------------------------------------------------------------------- neumip

# Texels of the width of a yarn, about, and the fewest of a repeat.
_YARN_TEXELS, _MIN_TEXELS = 10, 32
_MAX_SAMPLER_STEPS = 2000


@dataclass(frozen=True)
class NeumipSettings(TrainingSettings):
    """Settings of the training of `neumip`.

    Attributes:
        resolution: None for about ten texels a yarn of fabrics, and for `max_resolution` of other sources.
        max_resolution: of what None chooses.
        offset: with the neural offset module; without it, the baseline of the paper's section 3.2.
        fine_samples: rays of a query of a texel; larger footprints have more by their sides, up to `samples`.
        offset_share: share of the training after which the offset texture stays as it is; a third in the
            released code, whose trainings are longer.
        footprint_texels: side of the footprints that level 0 is for. A texel's own, as published, has a
            deviation of 0.29 texel, which bilinear interpolation blurs.
    """

    version: ClassVar[int] = 6
    resolution: int | None = None
    queries: int = 1 << 22
    samples: int = 4
    steps: int = 1000
    batch: int = 1 << 13
    rate: float = 1e-2
    texture_rate: float = 3e-2
    seed: int = 0
    max_resolution: int = 256
    offset: bool = True
    fine_samples: int = 1
    offset_share: float = 2 / 3
    footprint_texels: int = 2

    def shape(self, source: Source, faces: int) -> PyramidShape:
        """The shape of the textures of a source.

        Args:
            faces: of the source's BTF.
        """
        resolution = self.resolution or self.max_resolution
        if self.resolution is None and isinstance(source, Fabric):
            layout = source.layout()
            yarns = max(layout.size) / min(layout.warp.spacing.mean(), layout.weft.spacing.mean())
            finest = 2 ** round(math.log2(_YARN_TEXELS * yarns))
            resolution = min(max(finest, _MIN_TEXELS), resolution)
        shape = PyramidShape.of(source.repeat_mm, resolution, faces)
        return replace(shape, footprint_texels=self.footprint_texels)

    @property
    def sampler_steps(self) -> int:
        """Updates of the sampler network."""
        return min(max(1, self.steps // 5), _MAX_SAMPLER_STEPS)

    def query_identity(self, source: Source) -> str:
        """A hash of all that the queries depend on: trainings that differ in the rest share them."""
        return replace(self, offset=True, steps=1, batch=1, rate=1, texture_rate=1, offset_share=1).identity(
            source
        )


NEUMIP_QUALITIES: dict[str, NeumipSettings] = {
    "preview": NeumipSettings(),
    "full": NeumipSettings(queries=1 << 24, samples=8, steps=4000, batch=1 << 14),
}
# Texels of sources whose rays are paths, which cost more than the steps that learn from them.
_TRACED = {"preview": 128, "full": 256}


@dataclass(frozen=True, kw_only=True)
class NeumipOptions(TrainingOptions):
    """Options of `neumip`."""

    title: ClassVar[str] = "option of neumip"

    quality: str = setting(DEFAULT_QUALITY, "How long it is trained.", choices=tuple(NEUMIP_QUALITIES))
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
        chosen = replace(_chosen(NEUMIP_QUALITIES[self.quality], self), offset=self.offset)
        if is_fabric:
            return chosen
        return replace(chosen, max_resolution=_TRACED[self.quality], samples=1, batch=chosen.batch // 2)


# ----------------------------------------------------------------------------------------------------- latent

# Hidden layers of the decoder, by name.
DECODERS = {"2x16": (16, 16), "2x32": (32, 32), "3x64": (64, 64, 64)}
DEFAULT_DECODER = "2x32"
# The rungs of the paper's ablation (Tables 1 to 4), each with what the ones before have.
RUNGS = ("mlp", "encoder", "frames")
# What the decoder is given beside directions and latent; the paper has nothing there.
FEATURES = ("half-vector", "none")
# "auto" is `loss_of_kind`.
AUTO = "auto"
LOSSES = (AUTO, "log", "cube-root", "relative")
# Share of the steps whose lights are cones, where they are: 20 000 of 300 000.
_MOLLIFIED = 1 / 15
# How levels of textures are chosen.
MIPS = ("stochastic", "trilinear")
# Of the numbers in a file; they are computed with in float32.
PRECISIONS = ("float32", "float16")


def loss_of_kind(kind: str) -> str:
    """The loss that "auto" is for a kind of source.

    Differences of cube roots weigh values as the eye does, but learn medians of noisy values. Values of
    fabrics are noisy, as means over a few points; relative squares learn their means.
    """
    return "relative" if kind == "fabric" else "cube-root"


@dataclass(frozen=True)
class LatentSettings(TrainingSettings):
    """Settings of the training of `latent`.

    Attributes:
        decoder: a name of `DECODERS`.
        rung: how much of the model is used, of `RUNGS`.
        features: of `FEATURES`.
        loss: of `LOSSES`.
        optimiser: of encoder, textures and decoder, "soap" or the paper's "adam".
        steps: updates of encoder, textures and decoder.
        encoder_share: share of the steps that train the encoder; the others train its textures.
        mollified: share of the steps, from the first one, and of the queries whose lights are cones; see
            `queries.cone_angles`.
        rate: its smallest is a tenth of it.
        sampler_steps, sampler_batch: of the importance sampler and the albedo network.
    """

    version: ClassVar[int] = 9
    resolution: int = 128
    queries: int = 1 << 20
    samples: int = 8
    steps: int = 2500
    batch: int = 1 << 12
    rate: float = 1e-2
    texture_rate: float = 2e-2
    seed: int = 0
    decoder: str = DEFAULT_DECODER
    rung: str = "frames"
    features: str = FEATURES[0]
    loss: str = AUTO
    optimiser: str = "soap"
    encoder_share: float = 0.3
    mollified: float = 0.0
    sampler_steps: int = 300
    sampler_batch: int = 1 << 10

    def query_identity(self, source: Source) -> str:
        """A hash of all that the queries depend on: trainings that differ in the rest share them."""
        names = ("resolution", "queries", "samples", "seed", "mollified", "features")
        taken = {name: getattr(self, name) for name in names}
        return LatentSettings(**taken).identity(source)

    @property
    def mollified_queries(self) -> int:
        """Queries whose lights are cones, the first ones."""
        return round(self.mollified * self.queries)

    @property
    def mollified_steps(self) -> int:
        """Steps that learn from them, the first ones."""
        return round(self.mollified * self.steps)


# The paper's schedule is 300 000 steps of 2 · 65 536 queries, of which it stores none: "published" reads its
# queries several times.
LATENT_QUALITIES: dict[str, LatentSettings] = {
    "preview": LatentSettings(),
    "full": LatentSettings(
        resolution=256, queries=1 << 24, samples=16, steps=20_000, batch=1 << 16, sampler_steps=4000
    ),
    "published": LatentSettings(
        resolution=512,
        queries=1 << 27,
        samples=64,
        steps=300_000,
        batch=1 << 17,
        features="none",
        loss="log",
        optimiser="adam",
        mollified=_MOLLIFIED,
        rate=1e-3,
        texture_rate=1e-3,
        sampler_steps=20_000,
        sampler_batch=1 << 13,
    ),
}


@dataclass(frozen=True, kw_only=True)
class LatentOptions(TrainingOptions):
    """Options of `latent`."""

    title: ClassVar[str] = "option of latent"

    quality: str = setting(DEFAULT_QUALITY, "How long it is trained.", choices=tuple(LATENT_QUALITIES))
    decoder: str = setting(DEFAULT_DECODER, "Hidden layers of the decoder.", choices=tuple(DECODERS))
    mips: str = setting(
        MIPS[0],
        "Levels of textures are chosen at random, stochastic, or interpolated; it changes no weight.",
        choices=MIPS,
    )
    precision: str = setting(
        PRECISIONS[0], "Of the numbers in a file: float16 is half as large.", choices=PRECISIONS
    )
    rung: str = setting("frames", "Rung of the paper's ablation.", choices=RUNGS)
    features: str | None = setting(
        None,
        "What the decoder is given beside directions and frames; the paper has none.",
        choices=FEATURES,
        otherwise="by quality",
    )
    loss: str = setting(
        AUTO,
        "What is minimised: auto is log of published, else relative of fabrics and cube-root of others.",
        choices=LOSSES,
    )
    mollified: bool | None = setting(
        None,
        "Whether lights of the first fifteenth of the steps are cones that narrow from 10°, as in the paper.",
        otherwise="by quality",
    )
    queries: int | None = setting(None, "Of the source, in all.", low=1, high=1 << 30, otherwise="by quality")
    batch: int | None = setting(None, "Queries of a step.", low=1, high=1 << 22, otherwise="by quality")

    def settings(self) -> LatentSettings:
        """The settings of the quality with those that are chosen; the sampler has a third of the steps.

        Its batch changes as that of the others does.
        """
        chosen = _chosen(LATENT_QUALITIES[self.quality], self)
        chosen = replace(chosen, decoder=self.decoder, rung=self.rung)
        if self.loss != AUTO:
            chosen = replace(chosen, loss=self.loss)
        if self.mollified is not None:
            chosen = replace(chosen, mollified=_MOLLIFIED if self.mollified else 0.0)
        given = {name: getattr(self, name) for name in ("features", "queries", "batch")}
        chosen = replace(chosen, **{name: value for name, value in given.items() if value is not None})
        if self.batch is not None:
            share = self.batch / LATENT_QUALITIES[self.quality].batch
            chosen = replace(chosen, sampler_batch=max(1, round(share * chosen.sampler_batch)))
        return chosen if self.steps is None else replace(chosen, sampler_steps=max(1, self.steps // 3))
