"""A baked model with another number of texels: tests of each share the tables."""

from __future__ import annotations

from copy import copy

from loomlight.models.clustered.model import ClusteredModel


def with_samples(model: ClusteredModel, samples: int) -> ClusteredModel:
    """The model with another number of texels of the residual."""
    made = copy(model)
    made.samples = samples
    return made
