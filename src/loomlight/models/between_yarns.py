"""Light between yarns over footprints: `interreflection.py` for the mean albedos of a cloth and a place."""

from __future__ import annotations

from dataclasses import dataclass

import drjit as dr

from loomlight.aggregate.footprint_albedos import FootprintAlbedos
from loomlight.core.arrays import Color3, Float, Mask, Vec3
from loomlight.core.backend import array_types, maximum
from loomlight.scattering.interreflection import (
    Blocked,
    Interior,
    Interreflection,
    Scattered,
    bounced,
    scattered,
)
from loomlight.scattering.point import Albedos, Tint, colours_of, tinted

# Albedos of reflected and of transmitted light.
Bounced = tuple[Color3, Color3]


@dataclass
class BetweenYarns:
    """Light between the yarns of a cloth as one view of each footprint sees it.

    Attributes:
        cloth: the openness of the cloth.
        interior: radiances between the yarns.
        warp, weft: R and T of the yarns in the footprint.
        view: unit vectors [3] in the frame of the face that is seen.
        back: the face behind is seen.
    """

    cloth: Interreflection
    interior: Interior
    warp: Scattered
    weft: Scattered
    view: Vec3
    back: Mask

    @classmethod
    def of(
        cls,
        means: FootprintAlbedos,
        albedos: tuple[Albedos, Albedos],
        tint: Tint | None,
        view: Vec3,
        back: Mask,
    ) -> BetweenYarns | None:
        """Light between the yarns of a fabric's footprints; None without.

        Args:
            albedos: means of warp and weft over the footprint, tinted.
            view: see the attributes.
        """
        types = array_types(view.x)
        cloth = means.between_yarns(types)
        if cloth is None:
            return None
        layers = cloth.layers
        whole_warp, whole_weft = (
            _scattered(tinted(family, colour), layer)
            for family, layer, colour in zip(means.of_cloth(types), layers, colours_of(tint), strict=True)
        )
        interior = cloth.interior(whole_warp, whole_weft, back)
        warp, weft = map(_scattered, albedos, layers)
        return cls(cloth, interior, warp, weft, view, back)

    def far(self, diffuse_warp: Float, diffuse_weft: Float, hole: Float) -> Bounced:
        """Of footprints that show so much diffuse light of either family: means over what views see of them.

        Args:
            diffuse_warp, diffuse_weft: components of a light. As a share of how open a family is, they say
                how much of it is there; where no light falls, the mean does.
            hole: share of the view rays that pass through.
        """
        warp, weft, is_warp = self.cloth.blocked_from(self.view, self.back)
        of_warp = diffuse_warp * dr.rcp(maximum(1 - warp.by_warp - warp.by_weft, MIN_OPENNESS))
        of_weft = diffuse_weft * dr.rcp(maximum(1 - weft.by_warp - weft.by_weft, MIN_OPENNESS))
        lit = of_warp + of_weft
        share = dr.fma(WEIGHT_OF_CLOTH, is_warp, of_warp) * dr.rcp(lit + WEIGHT_OF_CLOTH)
        return self.of_families(_scaled(warp, share * (1 - hole)), _scaled(weft, (1 - share) * (1 - hole)))

    def of_shares(self, warp: Float, weft: Float) -> Bounced:
        """Of footprints whose view rays meet either family in these shares: linear in them."""
        of_warp, of_weft, _ = self.cloth.blocked_from(self.view, self.back)
        return self.of_families(_scaled(of_warp, warp), _scaled(of_weft, weft))

    def of_families(self, warp: Blocked, weft: Blocked) -> Bounced:
        """Of blocked shares that are means over all view rays: 0 where a ray meets no yarn of the family."""
        of_warp, of_weft = bounced(warp, self.warp, self.interior), bounced(weft, self.weft, self.interior)
        return of_warp[0] + of_weft[0], of_warp[1] + of_weft[1]


# A family that is less open than this is hardly seen.
MIN_OPENNESS = 0.1
# Diffuse component, 1/sr, of which the mean of the cloth weighs as much as what the footprint shows.
WEIGHT_OF_CLOTH = 2e-3


def _scaled(blocked: Blocked, share: Float) -> Blocked:
    return Blocked(blocked.by_warp * share, blocked.by_weft * share, blocked.far * share)


def _scattered(albedos: Albedos, layer: list[Float]) -> Scattered:
    return scattered(
        albedos.diffuse_reflect,
        albedos.diffuse_transmit,
        albedos.specular_reflect,
        albedos.specular_transmit,
        layer,
    )
