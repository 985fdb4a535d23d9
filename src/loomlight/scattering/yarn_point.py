"""A yarn point and what is asked of it: its albedos, its frame, the rays that shadows take from it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import drjit as dr

from loomlight.core.arrays import Color3, Float, Mask, Vec3
from loomlight.core.backend import array_types
from loomlight.core.masked_branch import masked_branch
from loomlight.yarn.search import Surface


@dataclass
class Albedos:
    """The four albedos of a point, Color3 each."""

    diffuse_reflect: Color3
    diffuse_transmit: Color3
    specular_reflect: Color3
    specular_transmit: Color3


@dataclass
class YarnPoint:
    """A yarn point as a view ray meets it, in the frame of the face that is seen.

    Attributes:
        back: the face behind is seen.
        hole: the ray passes through; only sheen and delta transmission are left.
        x, y, height: where, millimetres.
        normal, tangent: of the yarn and its fibres [3], turned by detail.
        is_warp: the family.
        roughness: α.
        albedos: of its thread; None where they are not asked for.
        surface_normal: of the yarn's surface [3], which hides light; None is `normal`.
        diffuse_gain: what turned normals gain (`detail.diffuse_gain`); None is 1.
        hairs: those over it, and the share of the footprint that one covers; None without.
        bounced: albedos of light between yarns, reflected and transmitted, Color3 each; None without.
    """

    back: Mask
    hole: Mask
    x: Float
    y: Float
    height: Float
    normal: Vec3
    tangent: Vec3
    is_warp: Mask
    roughness: Float
    albedos: Any
    surface_normal: Any = None
    diffuse_gain: Any = None
    hairs: Any = None
    bounced: Any = None

    def diffuse(self, value: Float) -> Float:
        """The diffuse term at this point, of its value for smooth yarn."""
        return value if self.diffuse_gain is None else value * self.diffuse_gain

    def under_hairs(self, light: Vec3) -> Float:
        """Share of light from a direction [3], in the frame of the face, that hairs let by."""
        if self.hairs is None:
            return array_types(self.x).Float(1)
        hairs, cover = self.hairs
        return dr.lerp(hairs.lit(light), 1, cover)


@dataclass
class DirectionSample:
    """A sampled light direction.

    Attributes:
        light: unit direction [3].
        pdf: density per solid angle, or the probability of passing straight through.
        weight: evaluate / pdf, Color3.
        is_null: the direction goes straight through a hole (delta).
    """

    light: Vec3
    pdf: Float
    weight: Color3
    is_null: Mask


@dataclass
class ShadowQuery:
    """The visibility query of a yarn point and a light, in the frame of the face that the light falls on.

    Attributes:
        height: of the point, millimetres.
        direction: unit vector [3] to the light.
        back: which face that is.
        searched: whether a search is needed; False where the yarn shadows itself, and in holes.
    """

    height: Float
    direction: Vec3
    back: Mask
    searched: Mask


def shadow_query(surface: Surface, point: YarnPoint, light: Vec3) -> ShadowQuery:
    """The visibility query of a yarn point and a light, unit vector [3].

    Light from the other side falls on the yarn's other surface, so the geometry of that face occludes it.
    """
    types = array_types(point.x)
    facing = to_face_frame(light, point.back)
    beyond = facing.z < 0
    # Visibility is a Mask, so no derivatives are needed.
    surface_normal = point.normal if point.surface_normal is None else point.surface_normal
    own: tuple[Vec3, Float] = dr.detach((surface_normal, types.Float(point.height)))

    def turned(_: tuple[Vec3, Float]) -> tuple[Vec3, Float]:
        far = surface.surface(point.x, point.y, ~point.back)
        return dr.detach((far.normal, far.height))

    normal, height = masked_branch(beyond, own, turned, "cloth: other side")
    direction = types.Vector3(facing.x, facing.y, abs(facing.z))
    # The yarn itself occludes lights below its tangent plane.
    searched = ~point.hole & (dr.dot(normal, direction) > 0)
    return ShadowQuery(height, direction, point.back ^ beyond, searched)


def tinted(albedos: Albedos, tint: Color3 | None) -> Albedos:
    """Albedos whose diffuse terms are multiplied with a tint; None leaves them."""
    if tint is None:
        return albedos
    return Albedos(
        albedos.diffuse_reflect * tint,
        albedos.diffuse_transmit * tint,
        albedos.specular_reflect,
        albedos.specular_transmit,
    )


def to_face_frame(direction: Vec3, back: Mask) -> Vec3:
    """A direction in the frame of a face: z is negated for the back. It is its own inverse."""
    z = dr.select(back, -direction.z, direction.z)
    return type(direction)(direction.x, direction.y, z)
