"""The network's shape as its weights file states it, and constants that weights do not show.

Shared by training and by inference, which does without torch.
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field

SLOPE = 0.01  # of leaky ReLU
BINS = 8  # of one-blob coding
# The reach of a bin, in bins: neighbours overlap as Gaussians of one bin's deviation do.
BLOB_REACH = 2.5
# What the decoder is told of directions along the fibres of either family; see `network.fibre_features`.
# Bins of the half vector's inclination, over −1 to 1, and their reach in bins.
INCLINATION_BINS = 16
INCLINATION_REACH = 2.0
# How inclinations spread over the bins: three times as many to a degree at 0 as evenly.
INCLINATION_CROWDING = 0.5
# The density of a fibre's normals, as ln(30 D + 1)/4.
DENSITY_GAIN, DENSITY_SCALE = 30.0, 0.25
# Numbers of fibre features that lights bring, and that views do.
LIGHT_FEATURES, VIEW_FEATURES = 2 + 2 * INCLINATION_BINS + 2, 2
# Added to squared lengths: keeps the half vector of opposite directions finite.
OPPOSITE = 1e-4
# Bundles of fibres that lie alike, of each family: slopes along the yarn, times places across it, and one
# that is the same in all directions.
BUNDLE_SLOPES, BUNDLE_PLACES = 8, 3
BUNDLES = BUNDLE_SLOPES * BUNDLE_PLACES + 1
# What the network puts out for a bundle is of the order of 1 where its share of the light, 1/sr, is this.
BUNDLE_UNIT = 0.02
# Half the span of ln α over the ranges of parameters.
LOG_ROUGHNESS = 1.15
# Side of the maps of a repeat for "vector", and maps a thread for "field".
VECTOR_MAP = 128
FIELD_MAP = 16
# ln(k x + 1) of the terms in reflection and in transmission (chen2024 eq. 9).
REFLECTION_GAIN = 100.0
TRANSMISSION_GAIN = 1000.0
# e^8 / 100 is brighter than any component.
LARGEST_OUTPUT = 8.0
# Ends or picks of the largest repeat that the encoder takes.
MOST_THREADS = 64

Count = Annotated[int, Field(ge=1)]


class ConfigTable(BaseModel):
    """A table of a configuration: unknown fields, other types and numbers that are not finite are errors."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, allow_inf_nan=False)


class NetworkTable(ConfigTable):
    """[network]: its shape.

    Attributes:
        latent: "vector" is one vector a fabric, as published; "field" is one vector a place and a size.
        width: channels of the encoder's first stage; ResNet-18 has 64.
        latent_size: channels of the latent.
        position: "one_blob", as published, or "plain" numbers (the ablation).
        fusion: whether latent and footprint are fused before directions join, as published; without it the
            directions join at once and the angular decoder has two layers more (the ablation).
        fibres: whether directions are given along the fibres too; the published decoder has to find these.
        bundles: whether specular components are mixed of the densities of bundles of fibres, whose shares the
            decoder puts out; the published decoder puts out the components themselves.
        hidden: width of the decoder's layers.
    """

    latent: Literal["vector", "field"] = "field"
    width: Count = 32
    latent_size: Count = 64
    position: Literal["one_blob", "plain"] = "one_blob"
    fusion: bool = True
    fibres: bool = True
    bundles: bool = False
    hidden: Count = 64

    @property
    def outputs(self) -> int:
        """Numbers that the angular layers put out: components, or diffuse ones and one for each bundle."""
        return 2 + 2 * BUNDLES if self.bundles else 4

    @property
    def fetched_channels(self) -> int:
        """Numbers that are fetched of one texel: the first layer's outputs where there is fusion."""
        return self.hidden if self.fusion else self.latent_size

    @property
    def corrected_shape(self) -> tuple[int, int]:
        """Of what is added to the last layer of a network that mixes bundles; see `EncodedFabric`."""
        return 2 * BUNDLES, self.hidden + 1
