"""Mean albedos over footprints that carry derivatives of a scene's albedos."""

from __future__ import annotations

from typing import final

from loomlight.aggregate.footprint_albedos import FootprintAlbedos
from loomlight.scattering.appearance import Appearance
from loomlight.scattering.point import Albedos
from loomlight.yarn.stack import ClothGeometry


@final
class LiveAlbedos(FootprintAlbedos):
    """Mean albedos of warp and weft; those of a family whose threads are alike are a scene's own arrays.

    Means over threads that differ come from tables of their principal colours, which numpy computes: they
    carry no derivatives.
    """

    def __init__(
        self,
        geometry: ClothGeometry,
        appearance: Appearance,
        warp: Albedos | None,
        weft: Albedos | None,
    ) -> None:
        """
        Args:
            warp, weft: the scene's albedos of families whose threads are alike; None where they differ.
        """
        super().__init__(geometry, appearance)
        self._shared = warp, weft

    def shown(self, warp: Albedos, weft: Albedos) -> tuple[Albedos, Albedos]:
        """Means over threads of one plane, or the scene's; see `FootprintAlbedos.shown`."""
        own_warp, own_weft = self._shared
        if own_warp is not None and type(own_warp.diffuse_reflect) is type(warp.diffuse_reflect):
            warp = own_warp
        if own_weft is not None and type(own_weft.diffuse_reflect) is type(weft.diffuse_reflect):
            weft = own_weft
        return warp, weft
