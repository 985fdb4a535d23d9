"""Light between yarns: what yarns scatter to each other before it leaves the cloth, in closed form.

The point model meets light of the sky once. The share 1 − D of a point's diffuse directions is blocked
(`openness.py`); from there it receives what other yarns scatter. Under a sky of radiance 1 all yarn of
family j on a face has one radiance L_j towards other yarn, as in an integrating sphere of two paints:

    L_j = R_j (D_j + (1 − D_j) Σ_k m_jk L_k) + what crosses from the other face by T_j                  (1)

with D_j the openness of the yarn that blocks light, m_jk the share of the blocked directions of family j that
meet family k, R and T what a yarn sends back and lets through at one scattering. The equations of
both faces are linear; `Interior` is their solution for light of either side, so that warp colours bleed into
the weft and back. A point of family j then scatters, beside what it does to light of the sky,

    ((1 − D) R Σ_k m_jk(D) L_k + (1 − D') T L')·⟨light·n_s⟩/π                                           (2)

of reflected light, D' and L' being those of the other face, and likewise of transmitted light. What enters
between the yarns from a light that is no white sky goes with its cosine. As R + T ≤ 1, L ≤ 1: with D exact no
point returns more light than arrives.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, NamedTuple

import drjit as dr

from loomlight.core.arrays import Array, Color3, Float, Mask, Vec3
from loomlight.core.backend import ArrayTypes, clip, maximum, opaque
from loomlight.scattering.appearance import Appearance
from loomlight.scattering.openness import point_terms, view_terms


class Scattered(NamedTuple):
    """Share of the light that a yarn sends back (R) and lets through (T) at one scattering, Color3 each."""

    back: Any
    through: Any


class Interior(NamedTuple):
    """Radiances between the yarns under a sky of radiance 1 on one side, Color3 each.

    Attributes:
        warp, weft: L of the face that is seen, from light on its side.
        leaked: mean radiance over the face that is seen, from light on the other side.
        far: mean radiance over the other face, from light on that side.
        far_leaked: mean radiance over the other face, from light on the side that is seen.
    """

    warp: Any
    weft: Any
    leaked: Any
    far: Any
    far_leaked: Any


@dataclass
class Blocked:
    """Blocked shares of the sky of yarn: Floats, 0 to 1, free of albedos, whose means are means over points.

    Attributes:
        by_warp, by_weft: what either family blocks on the side of the view; their sum is 1 − D.
        far: 1 − D for lights on the other side.
    """

    by_warp: Float
    by_weft: Float
    far: Float


def scattered(
    diffuse_reflect: Color3,
    diffuse_transmit: Color3,
    specular_reflect: Color3,
    specular_transmit: Color3,
    shares: Sequence[Float],
) -> Scattered:
    """R and T of albedos.

    Args:
        shares: what a fibre layer of albedo 1 sends back and lets through (`fibre.mean_layer_shares`).
    """
    turned, through = shares
    return Scattered(
        diffuse_reflect + turned * specular_reflect, diffuse_transmit + through * specular_transmit
    )


def beneath(upper: Scattered, lower: Scattered) -> Scattered:
    """R and T of two sheets that lie upon one another, with light to and fro between them.

    The lower one is alike from both sides.
    """
    between = upper.through * dr.rcp(1 - dr.minimum(upper.back * lower.back, 0.999))
    return Scattered(upper.back + between * lower.back * upper.through, between * lower.through)


class FaceRadiance(NamedTuple):
    """Radiances between the yarns of one face: see `Interior`."""

    warp: Any
    weft: Any
    mean: Any
    leaked: Any


def solved_interior(
    warp: Scattered, weft: Scattered, openness: Any, meets: Any, blocks: Any
) -> tuple[FaceRadiance, FaceRadiance]:
    """Radiances between the yarns of the front and of the back (eq. 1): of numbers, colours or arrays.

    Args:
        warp, weft: means over the threads.
        openness, meets, blocks: see `Openness`; `openness` is its `interior`.
    """
    families = (warp, weft)
    sky, crossing, opens = [], [], []
    for face in (0, 1):
        kept = [(1 - openness[face][i]) * families[i].back for i in (0, 1)]
        of_sky = [openness[face][i] * families[i].back for i in (0, 1)]
        sky.append(_sent(of_sky, kept, meets[face]))
        crossing.append(_sent([of.through for of in families], kept, meets[face]))
        opens.append(_mean(openness[face], blocks[face]))
    passed = []
    for face, other in ((0, 1), (1, 0)):
        # Light of this face's sky that has crossed to the other one, with what comes back and crosses again.
        here, there = _mean(crossing[face], blocks[face]), _mean(crossing[other], blocks[other])
        enters = opens[face] + (1 - opens[face]) * _mean(sky[face], blocks[face])
        passed.append(there * enters / (1 - here * there * (1 - opens[face]) * (1 - opens[other])))
    found = []
    for face, other in ((0, 1), (1, 0)):
        back = (1 - opens[other]) * passed[face]
        of_warp, of_weft = (sky[face][i] + back * crossing[face][i] for i in (0, 1))
        mean = _mean((of_warp, of_weft), blocks[face])
        found.append(FaceRadiance(of_warp, of_weft, mean, passed[other]))
    return found[0], found[1]


def _sent(first: list[Color3], kept: list[Color3], meets: Array) -> list[Color3]:
    """Radiances of warp and weft that send out `first` at the start: the inverse of a 2 × 2 matrix.

    Args:
        kept: what each yarn sends back of the radiance that its blocked directions meet.
        meets: share of a family's blocked directions that meet a family [from][to].
    """
    warp, weft = (1 - kept[i] * meets[i][i] for i in (0, 1))
    scale = 1 / (warp * weft - kept[0] * kept[1] * (meets[0][1] * meets[1][0]))
    return [
        (first[0] * weft + kept[0] * meets[0][1] * first[1]) * scale,
        (first[1] * warp + kept[1] * meets[1][0] * first[0]) * scale,
    ]


def _mean(parts: Any, weights: Array) -> Color3:
    return weights[0] * parts[0] + weights[1] * parts[1]


def bounced(blocked: Blocked, of: Scattered, interior: Interior) -> tuple[Color3, Color3]:
    """Albedos of light between yarns, of reflected and of transmitted light (eq. 2), Color3 each.

    Times ⟨light·n_s⟩/π they are f·cos of what came from other yarn.

    Args:
        of: R and T of the yarn.
    """
    met = blocked.by_warp * interior.warp + blocked.by_weft * interior.weft
    leaked = (blocked.by_warp + blocked.by_weft) * interior.leaked
    through = blocked.far * of.through
    return of.back * met + through * interior.far_leaked, through * interior.far + of.back * leaked


class Interreflection:
    """The openness of one cloth on one backend, and the closed form at points and over footprints.

    Attributes:
        layers: what fibre layers of albedo 1 of warp and weft send back and let through [2][2].
    """

    def __init__(self, appearance: Appearance, types: ArrayTypes) -> None:
        """
        Args:
            appearance: with openness.
        """
        self._types = types
        openness = appearance.openness
        assert openness is not None

        numbers = partial(opaque, types.Float)
        self._by_view, self._by_point = numbers(openness.by_view), numbers(openness.by_point)
        self._warp_seen = numbers(openness.warp_seen)
        self._interior, self._blocks = numbers(openness.interior), numbers(openness.blocks)
        self._meets = numbers(openness.meets)
        self._per_relief = numbers(1 / openness.relief)
        # Here and not where they are used: kernels that are recorded read edits of what is uploaded.
        self.layers: list[list[Float]] = numbers(openness.layers)

    def interior(self, warp: Scattered, weft: Scattered, back: Mask) -> Interior:
        """Radiances between the yarns, as the face that is seen has them.

        Args:
            warp, weft: means over the threads.
            back: the face behind is seen.
        """
        front, behind = solved_interior(warp, weft, self._interior, self._meets, self._blocks)
        return Interior(
            warp=dr.select(back, behind.warp, front.warp),
            weft=dr.select(back, behind.weft, front.weft),
            leaked=dr.select(back, behind.leaked, front.leaked),
            far=dr.select(back, front.mean, behind.mean),
            far_leaked=dr.select(back, front.leaked, behind.leaked),
        )

    def blocked_at(self, is_warp: Mask, back: Mask, normal_z: Float, height: Float) -> Blocked:
        """Blocked shares of a yarn point.

        Args:
            normal_z: z of its normal in the frame of the face that is seen.
            height: millimetres, on that face.
        """
        terms = point_terms(normal_z, height * self._per_relief)
        return self._blocked(self._by_point, terms, is_warp, back)

    def blocked_from(self, view: Vec3, back: Mask) -> tuple[Blocked, Blocked, Float]:
        """Means of the blocked shares of warp and of weft where views meet them, and the share that is warp.

        Args:
            view: unit vector [3] in the frame of the face that is seen, z > 0.
        """
        sine = dr.sqrt(maximum(dr.fma(view.x, view.x, view.y * view.y), 1e-12))
        terms = view_terms(view.x, view.y, view.z, sine)
        warp, weft = (
            self._blocked(self._by_view, terms, self._types.Bool(is_warp), back) for is_warp in (True, False)
        )
        is_warp = self._sum(self._warp_seen, terms, back)
        return warp, weft, clip(is_warp, 0, 1)

    def _sum(self, table: Array, terms: tuple[Float, ...], back: Mask) -> Float:
        """Σ terms times coefficients [face][term]."""
        total: Float = 0
        for number, term in enumerate(terms):
            total = total + dr.select(back, table[1][number], table[0][number]) * term
        return total

    def _blocked(self, table: Array, terms: tuple[Float, ...], is_warp: Mask, back: Mask) -> Blocked:
        """Blocked shares from coefficients [face][family][share][term]."""
        shares: list[Float] = []
        for share in range(3):
            of_family = [
                [
                    dr.select(is_warp, *(table[face][family][share][number] for family in (0, 1)))
                    for number in range(len(terms))
                ]
                for face in (0, 1)
            ]
            shares.append(clip(self._sum(of_family, terms, back), 0, 1))
        near, far, to_warp = shares
        return Blocked(near * to_warp, near * (1 - to_warp), far)
