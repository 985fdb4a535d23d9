"""Maps over a surface: pictures that say where a garment has another colour, number or fabric.

`[maps]` of a fabric file names them, `--map` too. A colour multiplies what diffuse light yarns send back. A
number or a fabric chooses among a few *variants* of the cloth: at each place the picture says how much of
each is there, so that what a footprint shows is the mean of variants by their mean shares, which pyramids of
the shares give exactly. Numbers between those of two variants are mixtures of both.
"""

from __future__ import annotations

import itertools
import math
import os
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import srgb_to_linear
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.images import read_linear, read_map, read_picture
from loomlight.core.sentences import shown as quoted
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.fields import MapTable
from loomlight.fabric.map_fields import COLOURS, FABRIC, FAMILIES, fields_of, range_of
from loomlight.fabric.read import edited_fabric, load_fabric
from loomlight.fabric.resolve import IRREGULARITY_FIELDS, ResolvedFamily
from loomlight.mesh.picture_places import PicturePlace

Pixels = NDArray[np.float64]

# Numbers of a map's picture that become variants of their own. With four, a roughness of 0.05 to 0.9 is
# mixed of lobes whose widths differ by a third.
_LEVELS = 4
# Each variant is a model that is baked and a branch of a kernel.
MAX_VARIANTS = 32
# Of 8 bits: nearer numbers are one.
_STEP = 1 / 510
# Fields of yarns without dye, as bright as the energy of light lets them be.
_UNDYED: dict[str, Any] = {"color": None, "albedo": [1.0, 1.0, 1.0]}
# Between which what a print has to multiply is interpolated.
_GREYS = 129


@dataclass(frozen=True, eq=False)
class Tint:
    """A picture that diffuse albedos are multiplied with.

    Attributes:
        family: "warp" or "weft".
        picture: linear RGB [height, width, 3], 0 to 1.
        axis: the shares by which it counts, with the levels at which it does; None counts everywhere.
    """

    place: PicturePlace
    family: str
    picture: Pixels
    axis: ShareAxis | None = None


@dataclass(frozen=True, eq=False)
class ShareAxis:
    """One map that chooses among variants.

    Attributes:
        shares: of each level [height, width, levels], which sum to 1; the first is the cloth as it is.
        levels: what each changes: fields of the fabric by dotted name, or another fabric.
    """

    place: PicturePlace
    shares: Pixels
    levels: Sequence[Mapping[str, Any] | Fabric]


@dataclass(frozen=True, eq=False)
class Painting:
    """All maps of a fabric.

    Attributes:
        axes: of the maps that choose, in the order of `variants`: the last one's levels follow each other.
        tints: those that multiply.
        variants: a fabric for each combination of levels.
    """

    axes: tuple[ShareAxis, ...]
    tints: tuple[Tint, ...]
    variants: tuple[Fabric, ...]

    @property
    def places(self) -> tuple[PicturePlace, ...]:
        """Every place once."""
        drawn: list[ShareAxis | Tint] = [*self.axes, *self.tints]
        return tuple(dict.fromkeys(each.place for each in drawn))


def with_maps(fabric: Fabric, maps: Mapping[str, Any]) -> Fabric:
    """The fabric with further maps, by name: the path of a picture, or a dictionary of `[maps.NAME]`.

    Raises:
        InputError: a map that cannot be; the message names it.
    """
    if not maps:
        return fabric
    held = fabric.fields.model_dump(exclude_none=True)["maps"]
    return edited_fabric(fabric, {"maps": held | {name: _absolute(value) for name, value in maps.items()}})


def _absolute(value: Any) -> Any:
    """A map whose paths, relative to the working folder, are absolute."""
    if isinstance(value, str | os.PathLike):
        return os.path.abspath(value)
    if isinstance(value, Mapping):
        paths = {
            key: os.path.abspath(value[key])
            for key in ("picture",)
            if isinstance(value.get(key), str | os.PathLike)
        }
        if isinstance(value.get("fabrics"), list):
            paths["fabrics"] = [
                os.path.abspath(path) if isinstance(path, str | os.PathLike) else path
                for path in value["fabrics"]
            ]
        return {**value, **paths}
    return value


def print_on_uv(fabric: Fabric) -> Pixels | None:
    """Linear RGB [h, w, 3] of the map of colours that multiplies on a mesh's own uv; None without one.

    Raises:
        InputError: a picture that cannot be read.
    """
    table = fabric.fields.maps.get("color")
    if table is None or table.mode == "replace":
        return None
    _, (tint, *_) = _colour("color", table, fabric)
    return tint.picture if tint.place == PicturePlace(aspect=tint.place.aspect) else None


def without_maps(fabric: Fabric, where: str = "", shown: Sequence[str] = ()) -> Fabric:
    """The fabric without its maps; with a warning where some are lost, which names what cannot show them.

    Args:
        where: the beginning of that sentence, such as "A window"; "" for none.
        shown: names of maps that are shown all the same.
    """
    if not fabric.fields.maps:
        return fabric
    lost = [name for name in fabric.fields.maps if name not in shown]
    if where and lost:
        warnings.warn(
            f"{where} shows {fabric.name} without its maps of {', '.join(lost)}, which "
            "pictures of loomlight render have.",
            LoomlightWarning,
            stacklevel=3,
        )
    return edited_fabric(fabric, {"maps": {}})


def painting_of(fabric: Fabric) -> Painting | None:
    """The maps of a fabric, their pictures read; None without any.

    Raises:
        InputError: a picture or a fabric that cannot be read, a number out of range, or too many variants.
    """
    if not fabric.fields.maps:
        return None
    axes: list[ShareAxis] = []
    tints: list[Tint] = []
    for name, table in fabric.fields.maps.items():
        if name in COLOURS:
            axis, made = _colour(name, table, fabric)
            tints += made
        else:
            axis = _choice(name, table, fabric)
        axes += [] if axis is None else [axis]
    count = math.prod(len(axis.levels) for axis in axes)
    if count > MAX_VARIANTS:
        raise InputError(
            f"The maps {', '.join(fabric.fields.maps)} together make {count} variants of the cloth, and at "
            f"most {MAX_VARIANTS} can be: pictures of fewer greys make fewer, or leave one of the maps out."
        )
    plain = without_maps(fabric)
    variants = tuple(_variant(plain, levels) for levels in itertools.product(*(axis.levels for axis in axes)))
    return Painting(tuple(axes), tuple(tints), variants)


def _variant(fabric: Fabric, levels: Sequence[Mapping[str, Any] | Fabric]) -> Fabric:
    others = [level for level in levels if isinstance(level, Fabric)]
    edits = {key: value for level in levels if not isinstance(level, Fabric) for key, value in level.items()}
    base = others[-1] if others else fabric
    return edited_fabric(base, edits) if edits else base


# ---------------------------------------------------------------------------------------------- own numbers


def _own_number(fabric: Fabric, name: str) -> float:
    """What the fabric has for a field, in the unit of the file."""
    table, _, field = name.rpartition(".")
    resolved = fabric.resolved
    if table not in FAMILIES:
        return float(getattr(getattr(resolved, table) if table else resolved, field))
    family: ResolvedFamily = getattr(resolved, table)
    if field in ("gap", "width_mm"):
        width, spacing = float(family.layout.width.mean()), float(family.layout.spacing.mean())
        return width if field == "width_mm" else max(1 - width / spacing, 0.0)
    if field in IRREGULARITY_FIELDS:
        return float(getattr(family.irregularity, IRREGULARITY_FIELDS[field]))
    plain = field.removesuffix("_deg")
    holder: Any = next(part for part in (family, family.layout, family.detail) if hasattr(part, plain))
    value = float(getattr(holder, plain))
    return math.degrees(value) if field != plain else value


# ------------------------------------------------------------------------------------- pictures into variants


def _colour(name: str, table: MapTable, fabric: Fabric) -> tuple[ShareAxis | None, list[Tint]]:
    """Of a colour that multiplies a tint alone; one that replaces has yarns without dye below it."""
    colours, opacity = _picture(name, table, fabric)
    place = _place(table, opacity)
    families = [field.partition(".")[0] for field in fields_of(name)]
    if table.mode != "replace":
        return None, [Tint(place, family, 1 - opacity + opacity * colours) for family in families]
    # Warnings of a white that no cloth shows would speak of what nobody has written.
    white = {f"{family}.{key}": value for family in families for key, value in _UNDYED.items()}
    covers = bool((opacity == 1).all()) and place.repeat
    shares = np.ones((1, 1, 1)) if covers else np.concatenate([1 - opacity, opacity], axis=2)
    axis = ShareAxis(place, shares, [white] if covers else [{}, white])
    # Colours of a print are those of cloth that nobody has worn.
    undyed = edited_fabric(fabric, {"maps": {}, "wear": 0.0, **white})
    return axis, [Tint(place, family, _dyed(colours, undyed, family), axis) for family in families]


def _dyed(shown: Pixels, undyed: Fabric, family: str) -> Pixels:
    """What multiplies albedos of yarns without dye so that cloth of them shows the colours `shown`."""
    greys = np.linspace(0, 1, _GREYS) ** 2  # denser in the dark, where cloth has a foot
    albedos = undyed.recoloured(family, np.tile(greys[:, None], 3)).diffuse_reflect[:, 0]
    own = undyed.appearance()
    most = (own.warp if family == "warp" else own.weft).diffuse_reflect[0, 0]
    return np.interp(shown, greys, np.clip(albedos / most, 0, 1))


def _choice(name: str, table: MapTable, fabric: Fabric) -> ShareAxis:
    """The variants of a map of numbers or of fabrics, and their shares."""
    picture, opacity = _picture(name, table, fabric)
    place, grey = _place(table, opacity), picture.mean(axis=2)
    if name == FABRIC:
        others = [_other(path, fabric) for path in table.fabrics or ()]
        knots = np.linspace(0, 1, len(others) + 1)
        levels: list[Mapping[str, Any] | Fabric] = [{}, *others]
        return ShareAxis(place, _seen_through(_hats(grey, knots), opacity), levels)
    knots = _knots(grey[opacity[..., 0] > 0] if opacity.any() else grey.ravel())
    levels = [_edits(name, table, fabric, float(knot)) for knot in knots]
    shares = _hats(grey, knots)
    if place.repeat and (opacity == 1).all():
        return ShareAxis(place, shares, levels)
    return ShareAxis(
        place,
        np.concatenate([1 - opacity, shares * opacity], axis=2),
        [{}, *levels],
    )


def _edits(name: str, table: MapTable, fabric: Fabric, grey: float) -> dict[str, Any]:
    """What a grey of the picture makes of the fields.

    Raises:
        InputError: a number out of the field's range.
    """
    edits: dict[str, Any] = {}
    for field in fields_of(name):
        low, high = range_of(field)
        multiplies = table.mode == "multiply"
        ends = (0.0, 1.0) if multiplies else (low, high)
        first, last = (
            end if given is None else given for end, given in zip(ends, (table.low, table.high), strict=True)
        )
        value = first + grey * (last - first)
        if multiplies:
            value = min(max(value * _own_number(fabric, field), low), high)
        if not low <= value <= high:
            raise InputError(
                f"maps.{name}: its picture has places of {field} = {value:.4g}, and {low:g} to {high:g} can "
                "be: write other numbers for low and high, which black and white stand for."
            )
        edits[field] = value
        if field.endswith(".gap"):
            edits[field.replace("gap", "width_mm")] = None
        if field.endswith(".width_mm"):
            edits[field.replace("width_mm", "gap")] = None
    return edits


def _knots(grey: Pixels) -> Pixels:
    """Of greys [n] those that become variants: all where there are few, else some that are evenly spaced."""
    distinct = np.unique(np.round(grey / _STEP).astype(np.int64))
    if len(distinct) <= _LEVELS:
        return np.asarray(distinct * _STEP, np.float64)
    return np.linspace(float(grey.min()), float(grey.max()), _LEVELS)


def _hats(values: Pixels, knots: Pixels) -> Pixels:
    """Shares [h, w, knots] by which values are mixed of the knots next to them."""
    if len(knots) == 1:
        return np.ones((*values.shape, 1))
    place = np.interp(values, knots, np.arange(len(knots)))
    hats: Pixels = np.maximum(1 - np.abs(place[..., None] - np.arange(len(knots))), 0).astype(np.float64)
    return hats


def _seen_through(shares: Pixels, opacity: Pixels) -> Pixels:
    """Shares of which the first also has what the picture leaves transparent."""
    seen = shares * opacity
    seen[..., :1] += 1 - opacity
    return seen


def _other(path: str, fabric: Fabric) -> Fabric:
    found = load_fabric(Path(fabric.folder) / path)
    return without_maps(found)


def _place(table: MapTable, opacity: Pixels) -> PicturePlace:
    x, y = table.at_mm or (0.0, 0.0)
    return PicturePlace(
        uv=table.uv or "uv",
        side=table.side or "",
        width_mm=table.width_mm,
        at_mm=(float(x), float(y)),
        repeat=table.side is None if table.repeat is None else table.repeat,
        aspect=opacity.shape[0] / opacity.shape[1],
    )


def _picture(name: str, table: MapTable, fabric: Fabric) -> tuple[Pixels, Pixels]:
    """Colours [h, w, 3] (linear of maps of colours, else as stored) and opacity [h, w, 1] of a map's picture.

    Raises:
        InputError: no such picture; the message names the map.
    """
    path = Path(fabric.folder) / table.picture
    is_colour = name in COLOURS
    try:
        if path.suffix.lower() == ".exr":
            stored = read_linear(path) if is_colour else read_map(path, 3)
            numbers: Pixels = np.clip(stored.astype(np.float64), 0, 1)
            return numbers, np.ones((*numbers.shape[:2], 1))
        on_black = read_picture(path, background=0)
        opacity = np.clip(1 - (read_picture(path) - on_black).max(axis=2, keepdims=True), 0, 1)
    except InputError as error:
        raise InputError(f"maps.{name}.picture = {quoted(table.picture)}: {error}") from error
    numbers = np.clip(on_black / np.maximum(opacity, 1e-6), 0, 1)
    return (srgb_to_linear(numbers) if is_colour else numbers), np.round(opacity, 9)
