"""Settings of a training: what `quality` names, and what may be chosen beside it."""

from __future__ import annotations

from dataclasses import asdict, dataclass, replace

from loomlight.assets.sources import Source
from loomlight.core.errors import InputError
from loomlight.fabric.sentences import closest, shown
from loomlight.models.textured_model import require_training, training_identity

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


def settings_of(
    quality: str = DEFAULT_QUALITY,
    resolution: int | None = None,
    decoder: str = DEFAULT_DECODER,
    rung: str = "frames",
    loss: str = AUTO,
    seed: int = 0,
    steps: int | None = None,
    features: str | None = None,
) -> LatentSettings:
    """The settings of a quality with some of them chosen.

    Args:
        steps: of the model; the sampler is trained a third as many.
        features: by default those of the quality.

    Raises:
        InputError: an unknown quality or name of another choice, or a resolution that is no power of two.
    """
    named = (
        ("quality", quality, QUALITIES),
        ("decoder", decoder, DECODERS),
        ("rung", rung, RUNGS),
        ("loss", loss, LOSSES),
        ("features", features or FEATURES[0], FEATURES),
    )
    for name, value, known in named:
        if value not in known:
            raise InputError(f"{name} = {shown(value)} does not exist: {closest(value, known)}")
    chosen = replace(QUALITIES[quality], decoder=decoder, rung=rung, loss=loss, seed=seed)
    if features is not None:
        chosen = replace(chosen, features=features)
    require_training(resolution, steps)
    if resolution is not None:
        chosen = replace(chosen, resolution=resolution)
    if steps is not None:
        chosen = replace(chosen, steps=steps, sampler_steps=max(1, steps // 3))
    return chosen
