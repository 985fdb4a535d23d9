"""The sampler network of all fabrics: what it sees of a footprint and a view, and its weights.

It sees what a view fixes: the decoder's first angular layer without the light's part, the view, the fibres of
both families and the albedos' shares; `models/networks.py` says what it describes.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from importlib.resources import files

import drjit as dr
import numpy as np
from safetensors import SafetensorError
from safetensors.numpy import load

from loomlight.core.arrays import Float, FloatType, Vec3
from loomlight.core.backend import channel_mean
from loomlight.core.errors import InputError
from loomlight.models.networks import Layers, LearnedProposal, ReluNetwork
from loomlight.models.neural.codings import Fibre
from loomlight.models.neural.weights import Weights
from loomlight.models.separable import FamilyAlbedos
from loomlight.scattering.appearance import Sheen
from loomlight.scattering.lobe_mixture import TwoSidedLobes
from loomlight.scattering.sheen import sheen_transmittance

# Beside the decoder's activations: view, fibres of two families (x, y, α), shares of eight albedos.
FURTHER_INPUTS = 3 + 6 + 8
# Largest probability of the sheen's lobe: weights of what is below stay bounded.
_MAX_SHEEN = 0.8
# Order of the terms of an albedo, of warp and then of weft.
_TERMS = ("diffuse_reflect", "diffuse_transmit", "specular_reflect", "specular_transmit")
_FILE = "neural_sampler.safetensors"
_TINY = 1e-6


def neural_proposal(
    network: ReluNetwork,
    angular: Sequence[Float],
    albedos: FamilyAlbedos,
    null: Float,
    sheen: Sheen,
    view: Vec3,
    fibres: tuple[Fibre, Fibre],
) -> LearnedProposal:
    """The proposal of a footprint and a view.

    Args:
        angular: the decoder's first angular layer without the light's part.
        albedos: means over the footprint.
        null: null transmission, 0 to 1, which is also the probability of drawing it.
        sheen: of the fabric; strength 0 is none.
        view: unit vector [3] in the frame of the face that is seen.
        fibres: on the crowns of both families, in that frame.
    """
    terms = [
        channel_mean(getattr(family, term)) for family in (albedos.warp, albedos.weft) for term in _TERMS
    ]
    further = further_inputs([*view], [(fibre.x, fibre.y, fibre.roughness) for fibre in fibres], terms)
    lobes = TwoSidedLobes.of(network([*angular, *further]))
    if sheen.strength <= 0:
        return LearnedProposal(null, lobes, view)
    reflected = 1 - sheen_transmittance(view, sheen.strength, sheen.roughness)
    # A place shows one family, so its albedos are half of the sum.
    share = reflected * dr.rcp(reflected + 0.5 * sum(terms) + _TINY)
    return LearnedProposal(null, lobes, view, (_MAX_SHEEN * share, sheen.roughness))


def further_inputs(
    view: Sequence[Float], fibres: Sequence[tuple[Float, Float, Float]], albedos: Sequence[Float]
) -> list[Float]:
    """The inputs after the decoder's activations: `FURTHER_INPUTS` numbers.

    Args:
        fibres: direction (x, y) and α of both families.
        albedos: means over colours, in the order of `FamilyAlbedos`' terms, of warp and then of weft.
    """
    inverse = 1 / (sum(albedos) + _TINY)
    return [*view, *(number for fibre in fibres for number in fibre), *(term * inverse for term in albedos)]


@cache
def sampler_layers(weights: Weights) -> Layers | None:
    """The sampler of the package; None for a decoder that it was not trained for.

    Raises:
        InputError: its file is damaged.
    """
    content = files("loomlight.models.neural").joinpath("weights", _FILE).read_bytes()
    try:
        tensors = load(content)
    except SafetensorError as error:
        raise InputError(f"{_FILE} is damaged ({error}): install the package again.") from error
    if bytes(tensors["network"]).hex() != weights.sha256:
        return None
    return [
        (tensors[f"{number}.weight"].astype(np.float32), tensors[f"{number}.bias"].astype(np.float32))
        for number in range((len(tensors) - 1) // 2)
    ]


@cache
def sampler_of(weights: Weights, float_type: FloatType) -> ReluNetwork | None:
    """`sampler_layers` on one backend; all fabrics share it."""
    layers = sampler_layers(weights)
    return None if layers is None else ReluNetwork(layers, float_type)
