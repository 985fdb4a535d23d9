"""Settings of a training: what `quality` names, and what may be chosen beside it."""

from __future__ import annotations

from dataclasses import asdict, dataclass, replace
from typing import ClassVar

from loomlight.assets.sources import Source
from loomlight.core.settings import setting
from loomlight.models.options import TrainingOptions
from loomlight.models.textured_model import training_identity

DEFAULT_QUALITY = "preview"
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
# How levels of textures are chosen.
MIPS = ("stochastic", "trilinear")
# Of the numbers in a file; they are computed with in float32.
PRECISIONS = ("float32", "float16")
# Part of every identity: to be raised when the same settings give other weights.
_VERSION = 7


def loss_of_kind(kind: str) -> str:
    """The loss that "auto" is for a kind of source.

    Differences of cube roots weigh values as the eye does, but learn medians of noisy values. Values of
    fabrics are noisy, as means over a few points; relative squares learn their means.
    """
    return "relative" if kind == "fabric" else "cube-root"


@dataclass(frozen=True)
class LatentSettings:
    """Settings of the training of a material.

    Attributes:
        resolution: texels along the longer side of the repeat, a power of two.
        decoder: a name of `DECODERS`.
        rung: how much of the model is used, of `RUNGS`.
        features: of `FEATURES`.
        loss: of `LOSSES`.
        optimiser: of encoder, textures and decoder, "soap" or the paper's "adam".
        queries: of the source.
        samples: estimates of which the value of a query is the mean.
        steps: updates of encoder, textures and decoder.
        encoder_share: share of the steps that train the encoder; the others train its textures.
        batch: queries of a step.
        rate: largest learning rate of the networks; the smallest is a tenth of it.
        texture_rate: largest learning rate of the textures.
        sampler_steps, sampler_batch: of the importance sampler and the albedo network.
        seed: of queries, weights and batches.
    """

    resolution: int = 128
    decoder: str = DEFAULT_DECODER
    rung: str = "frames"
    features: str = FEATURES[0]
    loss: str = AUTO
    optimiser: str = "soap"
    queries: int = 1 << 20
    samples: int = 8
    steps: int = 2500
    encoder_share: float = 0.3
    batch: int = 1 << 12
    rate: float = 1e-2
    texture_rate: float = 2e-2
    sampler_steps: int = 300
    sampler_batch: int = 1 << 10
    seed: int = 0

    def identity(self, source: Source) -> str:
        """A hash of all that the weights depend on, for checkpoints and folders."""
        return training_identity(source, _VERSION, asdict(self))


# The paper's schedule is 300 000 steps of 2 · 65 536 queries, of which it stores none: "published" reads its
# queries several times.
QUALITIES: dict[str, LatentSettings] = {
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
        optimiser="adam",
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

    quality: str = setting(DEFAULT_QUALITY, "How long it is trained.", choices=tuple(QUALITIES))
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
        "What is minimised: auto is relative for fabrics, else cube-root; the paper's is log.",
        choices=LOSSES,
    )

    def settings(self) -> LatentSettings:
        """The settings of the quality with those that are chosen; of steps the sampler has a third."""
        chosen = replace(
            QUALITIES[self.quality], decoder=self.decoder, rung=self.rung, loss=self.loss, seed=self.seed
        )
        if self.features is not None:
            chosen = replace(chosen, features=self.features)
        if self.resolution is not None:
            chosen = replace(chosen, resolution=self.resolution)
        if self.steps is not None:
            chosen = replace(chosen, steps=self.steps, sampler_steps=max(1, self.steps // 3))
        return chosen
