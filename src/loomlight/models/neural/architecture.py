"""The network's shape, as in its weights file, and constants that are not in the file.

Shared by training and by inference, which needs no torch.
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field

LEAKY_SLOPE = 0.01  # of leaky ReLU
BINS = 8  # of one-blob coding
# Radius of a bin's kernel, in bins: neighbours overlap as Gaussians of σ = 1 bin do.
BLOB_RADIUS = 2.5
# Features of directions along the fibres of either family; see `network.fibre_features`.
# Bins of the half vector's inclination, over −1 to 1, and the radius of their kernels in bins.
INCLINATION_BINS = 16
INCLINATION_RADIUS = 2.0
# How inclinations spread over the bins: three times as many to a degree at 0 as evenly.
INCLINATION_CROWDING = 0.5
# The density of a fibre's normals, as ln(30 D + 1)/4.
DENSITY_GAIN, DENSITY_SCALE = 30.0, 0.25
# Numbers of fibre features that depend on the light, and that depend on the view alone.
LIGHT_FEATURES, VIEW_FEATURES = 2 + 2 * INCLINATION_BINS + 2, 2
# Added to squared lengths: keeps the half vector of opposite directions finite.
OPPOSITE = 1e-4
# The lobe basis of each family: bundles of parallel fibres, by slopes along the yarn times positions across
# it, and one lobe that is the same in all directions.
BUNDLE_SLOPES, BUNDLE_POSITIONS = 8, 3
BUNDLES = BUNDLE_SLOPES * BUNDLE_POSITIONS + 1
# Weight of a lobe, 1/sr, for a network output of 1.
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
MAX_OUTPUT = 8.0
# Ends or picks of the largest repeat that the encoder takes.
MAX_THREADS = 64

Count = Annotated[int, Field(ge=1)]


class ConfigTable(BaseModel):
    """A table of a configuration: unknown fields, other types and numbers that are not finite are errors."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, allow_inf_nan=False)


class NetworkTable(ConfigTable):
    """[network]: its shape.

    Attributes:
        latent: "vector" is one vector a fabric, as published; "field" is one vector a position and size.
        width: channels of the encoder's first stage; ResNet-18 has 64.
        heights: the encoder reads heights too; the published one reads normals and fibre directions alone.
        latent_size: channels of the latent.
        position: "one_blob", as published, or "plain" numbers (the ablation).
        fusion: latent and footprint are fused before directions are added, as published; without it the
            directions enter the first layer and the angular decoder has two layers more (the ablation).
        fibres: directions along the fibres are inputs too; the published decoder has none.
        bundles: specular components are mixtures of a lobe basis, whose weights the decoder outputs; the
            published decoder outputs the components themselves.
        parallax: small footprints are read where their view ray meets yarn; the published decoder reads
            them where it crosses the plane of the cloth.
        hidden: width of the decoder's layers.
    """

    latent: Literal["vector", "field"] = "field"
    width: Count = 32
    heights: bool = True
    latent_size: Count = 64
    position: Literal["one_blob", "plain"] = "one_blob"
    fusion: bool = True
    fibres: bool = True
    bundles: bool = False
    parallax: bool = False
    hidden: Count = 64

    @property
    def outputs(self) -> int:
        """Outputs of the angular layers: components, or diffuse components and the weights of lobes."""
        return 2 + 2 * BUNDLES if self.bundles else 4

    @property
    def fetched_channels(self) -> int:
        """Numbers that are fetched of one texel: with fusion, the first layer's outputs."""
        return self.hidden if self.fusion else self.latent_size

    @property
    def corrected_shape(self) -> tuple[int, int]:
        """Shape of the correction of the last layer; see `EncodedFabric`."""
        return 2 * BUNDLES, self.hidden + 1
