"""A baked model with other numbers of points: tests of each share the tables."""

from __future__ import annotations

from copy import copy

from loomlight.models.clustered.model import ClusteredModel


def with_samples(model: ClusteredModel, samples: int, texel_samples: int | None = None) -> ClusteredModel:
    """The model with other numbers of points; None leaves that of the texels."""
    made = copy(model)
    made.samples = samples
    if texel_samples is not None:
        made.texel_samples = texel_samples
    return made
