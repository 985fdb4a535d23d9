"""Small networks of models: dense layers on any backend, and directions that a network describes.

On CPUs a fused SIMD kernel evaluates dense layers; on GPUs, for derivatives, and in symbolic calls Dr.Jit's
cooperative vectors do.

A network that describes directions gives two mixtures of lobes (`scattering/lobe_mixture.py`), q towards the
view's side and q' towards the other side, mirrored, and the probability s of the first. The density of a
light l is

    (1 − d − e) [s q(l) + (1 − s) q'(l mirrored)] + d s/2π + e p(l)    on the view's side, and
    (1 − d − e) [s q(l) + (1 − s) q'(l mirrored)] + d (1 − s)/2π       on the other one.

The uniform part d bounds weights, and p is the lobe of a sheen. All of it is given that light does not pass
straight through.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi
from typing import Any, TypeAlias

import drjit as dr
import drjit.nn as nn
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, FloatType, Mask, Vec2, Vec3
from loomlight.core.backend import array_types, maximum
from loomlight.core.simd import DenseLayer, FusedMlp, can_use_kernel
from loomlight.scattering.directions import uniform_on_sphere
from loomlight.scattering.lobe_mixture import TwoSidedLobes
from loomlight.scattering.sheen import sample_sheen, sheen_pdf

# Weights [outputs, inputs] and biases [outputs] of each layer.
Layers: TypeAlias = list[tuple[NDArray[np.float32], NDArray[np.float32]]]


class ReluNetwork:
    """A network on one backend, without an activation after its last layer."""

    def __init__(self, layers: Layers, float_type: FloatType) -> None:
        self._types = array_types(float_type)
        last = len(layers) - 1
        self._mlp = FusedMlp(
            [DenseLayer(w, b, "relu" if number < last else "none") for number, (w, b) in enumerate(layers)]
        )
        tensor: Any = dr.tensor_t(float_type)
        numbers = [tensor(np.ascontiguousarray(part)) for layer in layers for part in layer]
        views: Any = nn.pack(numbers, layout="inference")
        self._layers = list(zip(views[::2], views[1::2], strict=True))

    def __call__(self, inputs: Sequence[Float]) -> list[Float]:
        """The outputs of a query in each lane."""
        if can_use_kernel(self._types.Float, list(inputs)):
            return self._mlp.call(self._types.Float, list(inputs))
        values: Any = nn.CoopVec(*inputs)
        for number, (weight, bias) in enumerate(self._layers):
            values = nn.matvec(weight, values, bias)
            if number + 1 < len(self._layers):
                values = maximum(values, 0)
        return [*values]


# ------------------------------------------------------------------------------------------------- directions

# Probability of uniform directions.
_UNIFORM = 0.1
_TINY = 1e-6


@dataclass
class LearnedProposal:
    """Density of directions of a footprint and a view, in the frame of the face that is seen.

    Attributes:
        null: probability of null transmission.
        lobes: given no null transmission and no uniform part.
        view: unit vector [3], z > 0.
        sheen: probability e of the sheen's lobe, given no null transmission, and its roughness; None draws
            none.
    """

    null: Float
    lobes: TwoSidedLobes
    view: Vec3
    sheen: tuple[Float, float] | None = None

    @property
    def _of_sheen(self) -> Float:
        return 0.0 if self.sheen is None else self.sheen[0]

    def density(self, light: Vec3) -> Float:
        """Density of `draw` per solid angle, without delta, 1/sr.

        Args:
            light: unit vector [3] in the frame of the face that is seen.
        """
        above, reflect = light.z > 0, self.lobes.reflect
        density = _UNIFORM * (0.5 / pi) * dr.select(above, reflect, 1 - reflect)
        density += (1 - _UNIFORM - self._of_sheen) * self.lobes.density([*light], [*self.view])
        if self.sheen is not None:
            share, roughness = self.sheen
            density += dr.select(above, share * sheen_pdf(light, self.view, roughness), 0)
        return (1 - self.null) * density

    def draw(self, choice: Float, u: Vec2) -> tuple[Vec3, Mask]:
        """A light direction [3] in the frame of the face that is seen, and whether it is null transmission.

        Args:
            choice: uniform number in [0, 1) that chooses the part.
            u: uniform numbers in [0, 1).
        """
        types = array_types(self.view.x)
        is_null = types.Bool(choice < self.null)
        rest = (choice - self.null) * dr.rcp(maximum(1 - self.null, _TINY))
        of_lobes = 1 - _UNIFORM - self._of_sheen
        # The rest chooses a side of the uniform part; what is beyond both is the sheen's.
        beyond = rest - of_lobes
        below = (beyond >= _UNIFORM * self.lobes.reflect) & (beyond < _UNIFORM)
        uniform = uniform_on_sphere(u)
        height = dr.abs(uniform.z)
        uniform = types.Vector3(uniform.x, uniform.y, dr.select(below, -height, height))
        drawn = self.lobes.sample([*self.view], rest / of_lobes, [*u])
        light = dr.select(beyond < 0, dr.normalize(types.Vector3(*drawn)), uniform)
        if self.sheen is not None:
            light = dr.select(beyond < _UNIFORM, light, sample_sheen(self.view, self.sheen[1], u))
        return dr.select(is_null, -self.view, light), is_null
