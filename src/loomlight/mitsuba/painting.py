"""Maps of a fabric on a surface of Mitsuba: which variant each sample shows, and its tint.

A map that chooses has shares of its variants. Their means over the footprint are the chances by which a
sample shows one of them, drawn by the bits of its place: pictures are mixed as the shares say, for the cost
of one variant and the noise of a choice where several meet.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Color3, Float, Mask, UInt
from loomlight.core.backend import clip
from loomlight.core.errors import InputError
from loomlight.core.footprint import Footprint
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.map_fields import FAMILIES
from loomlight.fabric.surface_maps import Painting, ShareAxis, Tint, painting_of
from loomlight.mesh.picture_places import PicturePlace
from loomlight.mitsuba.filtered_texture import FilteredTexture
from loomlight.models.interface import Model
from loomlight.models.registry import make_model, model_class
from loomlight.scattering.variation import hash_bits
from loomlight.sources.kinds import Source

# Channels of a texture.
_CHANNELS = 3


def attribute_name(number: int) -> str:
    """The attribute of a mesh that holds the uv of the place with this number; see `picture_uv`."""
    return f"vertex_picture{number}"


@dataclass(frozen=True)
class Painted:
    """A fabric whose maps choose among models.

    Attributes:
        source: the fabric with its maps.
        variants: a model of each of its variants.
        shown: which of them a sample shows.
    """

    source: Fabric
    variants: tuple[Model, ...]
    shown: ShownPainting


def painted_of(source: Source, model_name: str, options: Any = None) -> Painted | None:
    """A fabric with maps by a model, a variant each; None of other sources.

    Raises:
        InputError: a map that cannot be, or a model that is trained for one cloth.
    """
    if not isinstance(source, Fabric) or not source.fields.maps:
        return None
    if model_class(model_name).trains:
        raise InputError(
            f"{source.name} has maps, and {model_name} is trained for one cloth: leave them out, or use "
            "another model."
        )
    painting = painting_of(source)
    assert painting is not None
    variants = tuple(make_model(model_name, fabric, options) for fabric in painting.variants)
    return Painted(source, variants, ShownPainting(painting))


@dataclass(frozen=True)
class _Here:
    """Where samples are: the interaction, its footprint in uv, and that on the cloth."""

    si: Any
    edges: tuple[Any, Any]
    cloth: Footprint
    active: Mask


class _Place:
    """Reads where a picture lies at an interaction."""

    def __init__(self, place: PicturePlace, number: int) -> None:
        self._attribute, self._place = attribute_name(number), place

    def at(self, here: _Here) -> tuple[Any, tuple[Any, Any], Mask]:
        """The interaction with the picture's uv, its footprint there, and whether the picture is there."""
        place, si = self._place, mi.SurfaceInteraction3f(here.si)
        if place.is_on_cloth:
            assert place.width_mm is not None
            size = mi.Vector2f(place.width_mm, -place.width_mm * place.aspect)
            across, along, centre = (
                mi.Vector2f(each.x, each.y)
                for each in (here.cloth.duv_dx, here.cloth.duv_dy, here.cloth.centre)
            )
            si.uv = mi.Point2f((centre - mi.Vector2f(*place.at_mm)) / size + 0.5)
            edges, inside = (across / size, along / size), mi.Bool(True)
        else:
            found = here.si.shape.eval_attribute_3(self._attribute, here.si, here.active)
            # Surfaces that nobody has prepared have pictures on their own uv, and none that are thrown.
            is_set = found.z != 0
            ratio = dr.select(is_set, dr.abs(found.z), 1)
            si.uv = dr.select(is_set, mi.Point2f(found.x, found.y), here.si.uv)
            edges = here.edges[0] * ratio, here.edges[1] * ratio
            inside = found.z > 0 if place.side else ~(found.z < 0)
        if not place.repeat:
            inside &= (si.uv.x >= 0) & (si.uv.x < 1) & (si.uv.y >= 0) & (si.uv.y < 1)
        return si, edges, inside


class _Axis:
    """Shares of the levels of one map."""

    def __init__(self, axis: ShareAxis, place: _Place) -> None:
        self.place, self.count = place, len(axis.levels)
        # The last one is what the others leave.
        self._textures = [
            _texture(axis.shares[..., first : min(first + _CHANNELS, self.count - 1)])
            for first in range(0, self.count - 1, _CHANNELS)
        ]

    def level(self, at: _Here, number: Float) -> UInt:
        """A level, drawn by a number in [0, 1)."""
        if self.count == 1:
            return mi.UInt32(0)
        here, footprint, inside = self.place.at(at)
        level, total = mi.UInt32(0), mi.Float(0)
        for index in range(self.count - 1):
            if index % _CHANNELS == 0:
                shares = self._textures[index // _CHANNELS].over(here, *footprint, at.active)
            total += shares[index % _CHANNELS]
            level += dr.select(number >= total, mi.UInt32(1), 0)
        return dr.select(inside, level, 0)


class _Tint:
    """A picture that multiplies albedos."""

    def __init__(self, tint: Tint, place: _Place, axis: int | None) -> None:
        self.place, self.axis, self.family = place, axis, tint.family
        self._texture = _texture(tint.picture)

    def colour(self, at: _Here) -> Color3:
        here, footprint, inside = self.place.at(at)
        found = clip(self._texture.over(here, *footprint, at.active), 0, 1)
        return dr.select(inside, found, 1)


class ShownPainting:
    """All maps of one fabric, their pictures on the device.

    Attributes:
        places: where they lie.
    """

    def __init__(self, painting: Painting) -> None:
        self.places = painting.places
        places = {place: _Place(place, number) for number, place in enumerate(painting.places)}
        self._axes = [_Axis(axis, places[axis.place]) for axis in painting.axes]
        numbers = {id(axis): number for number, axis in enumerate(painting.axes)}
        self._tints = [
            _Tint(tint, places[tint.place], None if tint.axis is None else numbers[id(tint.axis)])
            for tint in painting.tints
        ]

    def shown(
        self, si: Any, edges: tuple[Any, Any], cloth: Footprint, active: Mask
    ) -> tuple[UInt, Color3, Color3]:
        """The number of the variant that a sample shows, and what tints albedos of its warp and its weft.

        Args:
            edges: of the footprint in uv.
            cloth: the footprint on the cloth, millimetres.
        """
        at = _Here(si, edges, cloth, active)
        # The bits of the place: of samples of a pixel no two are alike.
        bits = dr.reinterpret_array(mi.UInt32, si.uv.x) ^ hash_bits(
            dr.reinterpret_array(mi.UInt32, si.uv.y), dr.reinterpret_array(mi.UInt32, si.t)
        )
        variant, levels = mi.UInt32(0), []
        for number, axis in enumerate(self._axes):
            draw = (mi.Float(hash_bits(bits, mi.UInt32(number)) >> 9) + 0.5) * 2**-23
            level = axis.level(at, draw)
            levels.append(level)
            variant = variant * axis.count + level
        tints = [mi.Color3f(1), mi.Color3f(1)]
        for tint in self._tints:
            colour = mi.Color3f(tint.colour(at))
            if tint.axis is not None and self._axes[tint.axis].count > 1:
                colour = dr.select(levels[tint.axis] == 1, colour, 1)
            family = FAMILIES.index(tint.family)
            tints[family] = tints[family] * colour
        return variant, tints[0], tints[1]


def _texture(pixels: NDArray[np.float64] | Sequence[Any]) -> FilteredTexture:
    """A picture [h, w, up to 3] as a texture of numbers that are averaged over footprints."""
    rows = np.asarray(pixels, np.float32)
    rows = np.concatenate([rows, np.zeros((*rows.shape[:2], _CHANNELS - rows.shape[2]), np.float32)], axis=2)
    bitmap = mi.Bitmap(np.ascontiguousarray(rows))
    return FilteredTexture(mi.load_dict({"type": "bitmap", "bitmap": bitmap, "raw": True}))
