"""A baked model with another number of texels: tests of each share the tables."""

from __future__ import annotations

from copy import copy
from dataclasses import replace

from loomlight.models.clustered.model import ClusteredModel


def with_samples(model: ClusteredModel, samples: int) -> ClusteredModel:
    """The model with another number of texels of the residual."""
    made = copy(model)
    made.options = replace(model.options, samples=samples)
    return made
