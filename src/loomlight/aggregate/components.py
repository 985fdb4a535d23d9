"""The integrand at yarn points, at albedo 1, for parallel view rays.

Each point and pair of directions has five channels (chen2024 eq. 7 and the hole of its 6.5):

    C_warp, C_weft   blended diffuse term of the family that is hit, cosine included, 1/sr
    S_warp, S_weft   fibre layer of the family that is hit, cosine included, 1/sr
    hole             the ray passes through the cloth

The first four include the visibility of the light. They are reflection where the light is on the side of the
view, transmission where it is on the other. With one albedo a family, f·cos = k_d^warp C_warp + k_d^weft
C_weft + k_s^warp S_warp + k_s^weft S_weft is the point model's value (eq. 8) without sheen and procedural
variation. Sheen is shadowed like everything else at a point (zhu2024 eq. 3–5) and is the same function of
light and view everywhere, so over a footprint it is that function times

    light_visibility   the ray meets yarn that the light reaches

plus the hole, over which fly-away fibres stand as well.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import drjit as dr

from loomlight.core.arrays import Color3, Float, Mask, Vec3
from loomlight.core.backend import array_types
from loomlight.scattering.appearance import Appearance
from loomlight.scattering.diffuse import diffuse_reflection
from loomlight.scattering.fibre import reflection, transmission
from loomlight.scattering.point import YarnPoint, YarnScattering, to_face_frame, towards_grazing
from loomlight.yarn.visibility import first_hit

CHANNELS = ("diffuse_warp", "diffuse_weft", "specular_warp", "specular_weft", "hole")
COMPONENTS = CHANNELS[:4]
COLOURS = ("red", "green", "blue")
LIGHT_VISIBILITY = "light_visibility"
# A ray that ends deeper below the surface than this fraction of the finest thread has hit a wall. The error
# of the search on continuous yarn is smaller; of rays that hit walls, 1 in 100 ends closer to the upper edge.
_WALL, _FOOT = 1e-3, 0.1


@dataclass
class ViewHits:
    """Intersections of parallel view rays with the cloth.

    Attributes:
        point: the yarn points, on the yarns' tubes (`yarn/flanks.py`).
        wall: the ray has ended well below its yarn's tube, on the side of a yarn or where it dives.
        foot: on such a side, so far below that light reaches it as it reaches the yarn beside it.
        x, y: where the ray has ended, millimetres.
    """

    point: YarnPoint
    wall: Mask
    foot: Mask
    x: Float
    y: Float


def without_sheen_and_variation(model: YarnScattering, between_yarns: bool = True) -> YarnScattering:
    """The model without sheen and procedural variation, which components and colours do not include.

    Args:
        between_yarns: keep light between yarns, which colours include and components do not.
    """
    old = model.appearance
    appearance = Appearance(
        old.warp,
        old.weft,
        diffuse_blend=old.diffuse_blend,
        optical_depth=old.optical_depth,
        openness=old.openness if between_yarns else None,
    )
    return YarnScattering(model.surface, appearance, model.quality)


def trace_views(model: YarnScattering, x: Float, y: Float, view: Vec3, active: Mask = True) -> ViewHits:
    """Intersections of the view rays through x, y on the plane z = 0, with exact parallax.

    Args:
        x, y: draft coordinates, millimetres.
        view: unit vector [3] towards the eye; z < 0 sees the back.
    """
    types = array_types(x)
    back = types.Bool(view.z < 0)
    seen = to_face_frame(view, back)
    hit = first_hit(model.surface, x, y, seen, back, active, model.quality)
    ray = seen, hit.height
    point = model.at(hit.x, hit.y, back, hit.hole, ray=ray)
    depth, finest = model.surface.surface(hit.x, hit.y, back, ray).depth, min(model.surface.finest)
    wall, foot = (~hit.hole & (depth > dr.opaque(types.Float, share * finest)) for share in (_WALL, _FOOT))
    return ViewHits(point, wall, foot, hit.x, hit.y)


class Scattering(Protocol):
    """Parameters of scattering beside those of the yarn point; an `Appearance` is one."""

    @property
    def diffuse_blend(self) -> Float:
        """w, the weight of the yarn normal in the diffuse term."""

    @property
    def optical_depth(self) -> Float:
        """Tρ of the fibre layer."""


def lobes(
    appearance: Scattering, point: YarnPoint, light: Vec3, view: Vec3, transmits: bool | None = None
) -> tuple[Float, Float]:
    """Diffuse and specular term of yarn points at albedo 1, cosine included, without shadows: Float, 1/sr.

    Args:
        light, view: unit vectors [3].
        transmits: whether light and view lie on different sides in all lanes; None decides lane by lane.
    """
    types = array_types(point.x)
    facing_view, facing = to_face_frame(view, point.back), to_face_frame(light, point.back)
    frame = (point.normal, point.tangent, point.roughness, types.Float(appearance.optical_depth))
    blend = types.Float(appearance.diffuse_blend)
    is_transmission = types.Bool(facing.z < 0)
    # Diffuse transmission is diffuse reflection of the opposite direction.
    diffuse = point.diffuse(
        diffuse_reflection(dr.select(is_transmission, -facing, facing), point.normal, blend)
    )
    if transmits is None:
        specular = dr.select(
            is_transmission,
            transmission(facing, facing_view, *frame),
            reflection(facing, facing_view, *frame),
        )
    else:
        specular = (transmission if transmits else reflection)(facing, facing_view, *frame)
    lit = dr.select(is_transmission, 1, point.under_hairs(facing))
    return diffuse * lit, specular * lit


def components(
    appearance: Appearance,
    point: YarnPoint,
    light: Vec3,
    view: Vec3,
    visible: Mask,
    transmits: bool | None = None,
) -> tuple[Float, ...]:
    """The channels C_warp, C_weft, S_warp, S_weft of yarn points: four Float, 1/sr; zero in holes.

    Args:
        visible: the light is not occluded at the point; see `YarnScattering.visibility`.
        transmits: see `lobes`.
    """
    diffuse, specular = lobes(appearance, point, light, view, transmits)
    lit = visible & ~point.hole
    warp, weft = lit & point.is_warp, lit & ~point.is_warp
    return (
        dr.select(warp, diffuse, 0),
        dr.select(weft, diffuse, 0),
        dr.select(warp, specular, 0),
        dr.select(weft, specular, 0),
    )


def light_visibility(point: YarnPoint, visible: Mask) -> Float:
    """1 where a view ray meets yarn that the light reaches, else 0 (holes too): Float.

    Args:
        visible: the light is not occluded at the point; see `YarnScattering.visibility`.
    """
    return dr.select(visible & ~point.hole, array_types(point.x).Float(1), 0)


def colours(
    appearance: Appearance,
    point: YarnPoint,
    light: Vec3,
    view: Vec3,
    visible: Mask,
    transmits: bool | None = None,
) -> Color3:
    """f·cos of yarn points with the albedos of their threads: Color3, 1/sr; zero in holes.

    Exact also where threads of one family differ in colour, unlike mean albedos. In shadow there is light
    between yarns alone.
    """
    diffuse, specular = lobes(appearance, point, light, view, transmits)
    grazing = appearance.grazing
    albedos = towards_grazing(point.albedos, grazing, light, view)
    through = to_face_frame(light, point.back).z < 0 if transmits is None else transmits
    reflected = albedos.diffuse_reflect * diffuse + albedos.specular_reflect * specular
    transmitted = albedos.diffuse_transmit * diffuse + albedos.specular_transmit * specular
    value = dr.select(visible & ~point.hole, dr.select(through, transmitted, reflected), 0)
    if point.bounced is None:
        return value
    reflected, transmitted = point.bounced
    between = dr.select(through, transmitted, reflected) * (abs(light.z) * dr.inv_pi)
    if grazing.gain > 0:
        between *= grazing.kept(light, view)
    return value + between
