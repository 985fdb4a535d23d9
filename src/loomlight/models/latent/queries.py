"""Queries of a source for training: its reflectance over footprints, and the inputs of the encoder.

A source has a grid of texels; level l of its mip pyramid has 2^-l as many texels a side. A footprint of level
l is a Gaussian about a position, of deviation texel / `SIZE_OF_SIGMA` along either axis.
"""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from loomlight.models.latent.fabric_queries import FabricReflectance
from loomlight.models.latent.merl_queries import MerlReflectance
from loomlight.models.mip_pyramid import SIZE_OF_SIGMA as SIZE_OF_SIGMA
from loomlight.models.query_sources import QuerySources

_Floats = NDArray[np.float32]


class Reflectance(Protocol):
    """The reflectance of a source in batches; arrays are NumPy's float32.

    Attributes:
        inputs: names of the K inputs of the encoder: texture parameters, normals, LEAN moments. Of measured
            materials they are one per material (one-hot).
        resolution: texels of the finest level: width and height, powers of two.
        faces: 2 where front and back differ, else 1.
        slopes: of normals (-slopes, 1), about which highlights lie, of the finest level's texels
            [faces, maps, height, width, 2]; maps: flat surfaces and normal maps of a material.
        is_apart: whether each texel is a material of its own, and values are exact; see `PyramidShape`.
    """

    inputs: tuple[str, ...]
    resolution: tuple[int, int]
    faces: int
    is_apart: bool

    @property
    def slopes(self) -> _Floats: ...

    def values(
        self, positions: _Floats, levels: _Floats, lights: _Floats, views: _Floats, seed: tuple[int, ...]
    ) -> _Floats:
        """f·cos [n, 3], linear RGB, 1/sr, filtered over footprints; unbiased estimates of it are right too.

        Args:
            positions: centres of footprints [n, 2], in repeats of uv, 0 to 1.
            levels: log2 of the footprint's size in texels of the finest level [n], from 0.
            lights, views: unit vectors [n, 3], on one side of the surface; z < 0 is its back.
            seed: of the random numbers of estimates.
        """

    def encoder_inputs(self, level: int, face: int = 0) -> _Floats:
        """The inputs [height, width, K] of the texels of a level, filtered, roughly in [-1, 1].

        Row 0 is at v = 0. Level l is `resolution` halved l times, at least 1 texel a side.
        """


# Made of a source and the texels along the longer side of its repeat, a power of two; sources whose textures
# have a resolution of their own may answer with fewer. `loomlight.mitsuba` answers for materials.
REFLECTANCES = QuerySources[Reflectance]("latent", {"fabric": FabricReflectance, "merl": MerlReflectance})
