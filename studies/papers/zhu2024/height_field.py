"""Cloth as a ray-traced height field: every yarn is triangles, and shadows and parallax are Mitsuba's.

The independent check of what models say of parallax and shadows: heights come from `YarnGeometry`,
everything that hides or is hidden from the ray tracer. Vertices have the normals of the plain piece, so
that the frame of shading is the one of the cloth, and the local scattering of the yarn's point alone is
evaluated in it. Steps between yarns become steep triangles. Direct light of opaque cloth: behind the
triangles there is nothing.
"""

from __future__ import annotations

from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np

from loomlight.aggregate.components import colours
from loomlight.fabric.fabric import Fabric
from loomlight.mesh.cloth_mesh import ClothMesh, uv_size
from loomlight.mitsuba.bsdf import plain, variant_types
from loomlight.mitsuba.meshes import to_shape
from loomlight.scattering.point import YarnScattering
from loomlight.scattering.sheen import sheen_with_transmittance
from loomlight.yarn.geometry import YarnGeometry
from studies.instruments.cosine_bsdf import cosine_bsdf


def height_field_shape(piece: ClothMesh, fabric: Fabric) -> Any:
    """A Mitsuba shape of a finely tessellated piece whose vertices are moved to the heights of the yarns.

    Triangles with a vertex in a hole are left out. The piece's dp/du and dp/dv must not point in a mirrored
    order (`bsdf.py:draft_position`), as those of `shapes.py` do not.

    Args:
        piece: metres; its vertices must resolve the yarns, with 16 a thread or more.
    """
    millimetres = uv_size(piece)
    geometry = YarnGeometry(fabric.layout())
    types = variant_types()
    x, y = (types.Float((piece.uv[:, k] * millimetres[k]).astype(np.float32)) for k in (0, 1))
    height, hole = geometry.height(x, y, types.Bool(False))
    dr.eval(height, hole)
    heights = np.broadcast_to(np.asarray(height.numpy(), np.float64), (len(piece.uv),))
    holes = np.broadcast_to(np.asarray(hole.numpy(), bool), (len(piece.uv),))
    solid = piece.triangles[~holes[piece.triangles].any(axis=1)]
    positions = piece.positions + piece.normals * (1e-3 * np.where(holes, 0, heights))[:, None]
    bsdf = _yarn_bsdf(YarnScattering(geometry, fabric.appearance()), millimetres)
    return to_shape(ClothMesh(positions, piece.normals, piece.uv, solid, "height field"), bsdf)


def _yarn_bsdf(model: YarnScattering, millimetres: tuple[float, float]) -> Any:
    """The local scattering of the yarn at a point of the surface: no shadow, no parallax."""
    assert isinstance(model.surface, YarnGeometry)
    model.surface.upload(variant_types())
    model.parameters(variant_types())

    def value(si: Any, wo: Any) -> Any:
        types = variant_types()
        view, light = plain(si.wi), plain(wo)
        x, y = (types.Float(part) * size for part, size in zip(si.uv, millimetres, strict=True))
        point = model.at(x, y, types.Bool(False), types.Bool(False))
        # A ray may leave a triangle backwards and find nothing in its way: the yarn itself is.
        lit = dr.dot(point.normal, light) > 0
        found = colours(model.appearance, point, light, view, lit)
        if model.sheen is not None:
            sheen, transmittance = sheen_with_transmittance(light, view, *model.sheen)
            found = transmittance * found + dr.select(lit, sheen, 0)
        return mi.Spectrum(dr.select((light.z > 0) & (view.z > 0), found, 0))

    return cosine_bsdf(value, int(mi.BSDFFlags.Anisotropic))
