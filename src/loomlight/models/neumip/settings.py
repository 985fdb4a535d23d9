"""Settings of a training: what `quality` names, and what may be chosen beside it."""

from __future__ import annotations

from dataclasses import asdict, dataclass, replace

from loomlight.assets.sources import Source
from loomlight.core.errors import InputError
from loomlight.fabric.sentences import closest, shown
from loomlight.models.textured_model import require_training, training_identity

DEFAULT_QUALITY = "preview"
_MAX_SAMPLER_STEPS = 2000
# Part of every identity: to be raised when the same settings give other weights.
_VERSION = 3


@dataclass(frozen=True)
class NeumipSettings:
    """Settings of the training of a material.

    Attributes:
        resolution: texels along the longer side of the repeat, a power of two.
        offset: with the neural offset module; without it, the baseline of the paper's section 3.2.
        queries: of the source, for each texel of the finest level and each face.
        samples: rays of a query.
        steps: updates of the weights.
        batch: queries of a step.
        rate: largest learning rate of the networks.
        texture_rate: largest learning rate of the textures.
        offset_share: share of the training after which the offset texture stays as it is; a third in the
            released code, whose trainings are longer.
        seed: of queries, weights and batches.
    """

    resolution: int = 64
    offset: bool = True
    queries: int = 200
    samples: int = 8
    steps: int = 2000
    batch: int = 1 << 14
    rate: float = 3e-3
    texture_rate: float = 1e-2
    offset_share: float = 2 / 3
    seed: int = 0

    @property
    def sampler_steps(self) -> int:
        """Updates of the sampler network."""
        return min(max(1, self.steps // 5), _MAX_SAMPLER_STEPS)

    def identity(self, source: Source) -> str:
        """A hash of all that the weights depend on, for checkpoints and folders."""
        return training_identity(source, _VERSION, asdict(self))

    def query_identity(self, source: Source) -> str:
        """A hash of all that the queries depend on: trainings that differ in the rest share them."""
        return training_identity(source, _VERSION, {name: getattr(self, name) for name in _OF_QUERIES})


# Settings that queries depend on.
_OF_QUERIES = ("resolution", "queries", "samples", "seed")


# The paper's schedule is 30 000 steps of 2^20 queries on a GPU: "published".
QUALITIES: dict[str, NeumipSettings] = {
    "preview": NeumipSettings(),
    "full": NeumipSettings(resolution=256, queries=300, samples=16, steps=6000, batch=1 << 16),
    "published": NeumipSettings(
        resolution=512,
        queries=400,
        samples=64,
        steps=30_000,
        batch=1 << 20,
        rate=1e-3,
        texture_rate=1e-3,
        offset_share=1 / 3,
    ),
}


def settings_of(
    quality: str,
    resolution: int | None = None,
    offset: bool = True,
    seed: int = 0,
    steps: int | None = None,
) -> NeumipSettings:
    """The settings of a quality with some of them chosen.

    Raises:
        InputError: an unknown quality, or a resolution that is no power of two.
    """
    if quality not in QUALITIES:
        raise InputError(f"quality = {shown(quality)} does not exist: {closest(quality, QUALITIES)}")
    chosen = replace(QUALITIES[quality], offset=offset, seed=seed)
    require_training(resolution, steps)
    if resolution is not None:
        chosen = replace(chosen, resolution=resolution)
    if steps is not None:
        chosen = replace(chosen, steps=steps)
    return chosen
