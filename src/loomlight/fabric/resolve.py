"""A resolved fabric: the fields of a fabric file and its draft made into numbers, none of them left open.

What a file omits is taken from its kind of yarn (`yarns.py`), from the draft, or from the defaults below; all
that is made of a fabric, its layout, its appearance, its facts, is made of these numbers. Inclination and
twist are those commonly suggested for the three basic weaves (Jin et al. 2022); to a draft that has no name
they apply by its structure.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from dataclasses import dataclass, replace
from enum import Enum
from functools import partial
from math import radians
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import parse_colour
from loomlight.core.errors import InputError
from loomlight.fabric.fields import FabricFile, YarnTable, colours_in_order
from loomlight.fabric.layering import front_drawdown, layers_of, stacked_layers, ties_between
from loomlight.fabric.yarns import Yarn, kind_of, with_yarns
from loomlight.scattering.albedo import Albedos
from loomlight.scattering.appearance import Irregularity, Sheen, Variation, YarnDetail
from loomlight.weave.draft import Draft, Threads
from loomlight.weave.palette import WARP_COLOUR, WEFT_COLOUR, with_palette
from loomlight.weave.textile import CM_PER_INCH, DEFAULT_SETT_PER_CM, yarn_diameter_mm
from loomlight.yarn.layout import ClothLayout, FamilyLayout, Layer, Stacking, Ties

SPECULAR = 0.4
TRANSLUCENCY = 0.1
ROUGHNESS = 0.3
HEIGHT_SCALE = 1.0
# S twist, against the Z twist of the singles.
PLY_TWIST_DEG = 24.0
DIFFUSE_BLEND = 0.5
OPTICAL_DEPTH = 2.0
# Of fibres that took no dye, or have lost it.
NEP_COLOUR = "#e4dccb"
# Crossings of a fabric: those of 4096 by 16384 threads, for which rendering takes gigabytes (docs/drafts.md).
MAXIMUM_CROSSINGS = 1 << 26
_MM_PER_CM = 10.0


@dataclass(frozen=True, eq=False)
class ResolvedFamily:
    """The threads of one family.

    Attributes:
        kind: of yarn; one of cotton's density, without gloss, where the file names none.
        count: of the yarn as the file has it; "" where it has none.
        layout: where the threads lie and how they bend, millimetres and radians.
        detail: plies, fibres, slubs and hairs.
        irregularity: how yarns vary over millimetres to metres, as much as `[variation]` says; the albedo of
            neps is left to `colour.py`, as that of threads is.
        nep_colour: of neps [3], linear RGB, as cloth of nothing else shows it.
        colours: of the threads [n, 3], linear RGB.
        are_albedos: whether `colours` are the yarn's albedos, not what cloth of it shows.
        specular: share of the light that the highlight takes, 0 to 1.
        specular_tint: what the highlight is multiplied by [3], linear RGB.
        specular_grazing: what its albedo gains towards grazing, 0 to 4.
        translucency: share of the diffuse light that goes through, 0 to 1.
        roughness: α, 0.01 to 1.
        worn: how much its threads are rubbed, 0 to 1.
        given_albedos: those that the file states outright, by their names in `Albedos` [3].
    """

    kind: Yarn
    count: str
    layout: FamilyLayout
    detail: YarnDetail
    irregularity: Irregularity
    nep_colour: NDArray[np.float64]
    colours: NDArray[np.float64]
    are_albedos: bool
    specular: float
    specular_tint: NDArray[np.float64]
    specular_grazing: float
    translucency: float
    roughness: float
    worn: float
    given_albedos: Mapping[str, NDArray[np.float64]]


@dataclass(frozen=True, eq=False)
class ResolvedFabric:
    """All numbers of a fabric.

    Attributes:
        draft: one repeat, with a colour for every thread. It is longer than the draft in the file where a
            list of colours repeats later than the weave does.
        wear: how much the face is rubbed, 0 to 1.
        diffuse_blend: share of the cloth's normal in diffuse light, 0 to 1.
        optical_depth: Tρ of the fibre layer, > 0.
        interreflection: whether there is light between the yarns.
        layers, stacking, ties: cloths that lie upon one another, see `ClothLayout`; none of a single one.
    """

    draft: Draft
    warp: ResolvedFamily
    weft: ResolvedFamily
    sheen: Sheen
    variation: Variation
    wear: float
    diffuse_blend: float
    optical_depth: float
    interreflection: bool
    layers: tuple[Layer, ...]
    stacking: Stacking | None
    ties: tuple[Ties, ...]

    @property
    def layout(self) -> ClothLayout:
        """Where the threads of one repeat lie."""
        return ClothLayout(
            self.draft.drawdown, self.warp.layout, self.weft.layout, self.layers, self.stacking, self.ties
        )


def resolve(fields: FabricFile, draft: Draft) -> ResolvedFabric:
    """The numbers of a file's fields and of the draft that they name.

    Raises:
        InputError: fields that contradict the draft, an unreadable yarn count, or more than 67 million
            crossings.
    """
    fields = with_yarns(fields)
    coloured = coloured_draft(draft, fields)
    if coloured.drawdown.size > MAXIMUM_CROSSINGS:
        raise InputError(
            f"the repeat of {coloured.ends} ends and {coloured.picks} picks has "
            f"{coloured.drawdown.size / 1e6:.0f} million crossings, and at most "
            f"{MAXIMUM_CROSSINGS / 1e6:.0f} million can be rendered: render a part of it."
        )
    found = layers_of(coloured.drawdown)
    # In layered cloth the whole drawdown resembles none of its weaves: the front one's bends are meant.
    warp_bend, weft_bend = bends_of(front_drawdown(coloured.drawdown, found))
    warp_spacing = family_spacing(fields, "warp", coloured.warp, coloured.weft, coloured.ends)
    weft_spacing = family_spacing(
        fields, "weft", coloured.weft, coloured.warp, coloured.picks, _take_up(fields, draft.weft)
    )
    wear, on_face = _or(fields.wear, 0.0), float(coloured.drawdown.mean())
    # What lies on the face most is rubbed first, the other family in proportion to how much of it does.
    most = max(on_face, 1 - on_face)
    warp = _family(fields, "warp", coloured.warp, warp_spacing, warp_bend, wear * on_face / most)
    weft = _family(fields, "weft", coloured.weft, weft_spacing, weft_bend, wear * (1 - on_face) / most)
    families = warp.layout, weft.layout
    layers, stacking = stacked_layers(
        coloured.drawdown, found, families, partial(_width_in_room, fields, coloured, families)
    )
    return ResolvedFabric(
        draft=coloured,
        warp=warp,
        weft=weft,
        wear=wear,
        sheen=Sheen(**fields.sheen.model_dump(exclude_none=True)),
        variation=Variation(**fields.variation.model_dump(exclude_none=True)),
        diffuse_blend=_or(fields.diffuse_blend, DIFFUSE_BLEND),
        optical_depth=_or(fields.optical_depth, OPTICAL_DEPTH),
        interreflection=fields.interreflection is not False,
        layers=layers,
        stacking=stacking,
        ties=ties_between(coloured.drawdown, found, layers),
    )


def _width_in_room(
    fields: FabricFile,
    draft: Draft,
    families: tuple[FamilyLayout, FamilyLayout],
    name: str,
    threads: NDArray[np.intp],
    spacing: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Widths of some threads of a family where each has another room than in one plane, millimetres.

    Gaps that are shares of the spacing grow with it. So does the thickness of a draft whose threads leave no
    gaps to each other in one plane: such files say that cloth is dense, and of yarn that thick its layers
    would be nets.
    """
    family, of_draft = (families[0], draft.warp) if name == "warp" else (families[1], draft.weft)
    thickness = of_draft.thickness_mm
    if thickness is not None:
        room = family.spacing[threads]
        fills = (thickness[threads] >= 0.95 * room) & (thickness[threads] <= room)
        thickness = thickness[threads] * np.where(fills, spacing / room, 1)
    return family_width(fields, name, Threads(thickness_mm=thickness), spacing)


def _family(
    fields: FabricFile, name: str, threads: Threads, spacing: NDArray[np.float64], bend: Bend, worn: float
) -> ResolvedFamily:
    table: YarnTable = getattr(fields, name)
    assert threads.colors is not None  # of a coloured draft
    layout = FamilyLayout(
        spacing=spacing,
        width=family_width(fields, name, threads, spacing),
        inclination=radians(_or(table.inclination_deg, bend.inclination_deg)),
        twist=radians(_or(table.twist_deg, bend.twist_deg)),
        height_scale=_or(table.height_scale, HEIGHT_SCALE),
    )
    given = {key: getattr(table, key) for key in Albedos._fields if getattr(table, key) is not None}
    tint = (1.0, 1.0, 1.0) if table.specular_tint is None else table.specular_tint
    return ResolvedFamily(
        kind=kind_of(table),
        count=table.count or "",
        layout=layout,
        detail=_detail(table, layout),
        irregularity=_irregularity(table, _or(fields.variation.irregularity, Variation().irregularity)),
        nep_colour=parse_colour(
            NEP_COLOUR if table.nep_color is None else table.nep_color, f"{name}.nep_color"
        ),
        colours=threads.colors,
        are_albedos=table.albedo is not None,
        specular=_or(table.specular, SPECULAR),
        specular_tint=parse_colour(tint, f"{name}.specular_tint"),
        specular_grazing=_or(table.specular_grazing, 0.0),
        translucency=_or(table.translucency, TRANSLUCENCY),
        roughness=_or(table.roughness, ROUGHNESS),
        worn=worn,
        given_albedos={key: parse_colour(value, f"{name}.{key}") for key, value in given.items()},
    )


def _or(value: float | None, default: float) -> float:
    return default if value is None else value


def _detail(table: YarnTable, layout: FamilyLayout) -> YarnDetail:
    """Numbers of the file by their names there, with angles in radians; twist and width are the layout's."""
    given = table.model_dump(exclude_none=True)
    numbers: dict[str, Any] = {"ply_twist": radians(PLY_TWIST_DEG)}
    for name in (field.name for field in dataclasses.fields(YarnDetail)):
        if name in given:
            numbers[name] = given[name]
        elif f"{name}_deg" in given:
            numbers[name] = radians(given[f"{name}_deg"])
    layouts = {"twist": layout.twist, "width": float(layout.visible_width.mean())}
    return YarnDetail(**(numbers | layouts))


# Numbers of `Irregularity` that say how much yarns vary; lengths and the size of a thick place say how.
AMOUNTS = ("mass_cv", "thick_places", "shade", "melange", "neps")
# Numbers of `Irregularity` by the fields of `[warp]` and `[weft]` that say them, lengths in millimetres.
IRREGULARITY_FIELDS = {
    name if name in YarnTable.model_fields else f"{name}_mm": name
    for name in (field.name for field in dataclasses.fields(Irregularity))
    if name != "nep_albedo"
}


def _irregularity(table: YarnTable, amount: float) -> Irregularity:
    """Numbers of the file, with `amount` times the `AMOUNTS`.

    Of thick places and neps that makes more or fewer, each as large as before: those of a smaller amount are
    among those of a larger one.
    """
    given = table.model_dump(include=set(IRREGULARITY_FIELDS), exclude_none=True)
    numbers = {IRREGULARITY_FIELDS[key]: value for key, value in given.items()}
    yarn = Irregularity(
        **{name: value * (amount if name in AMOUNTS else 1) for name, value in numbers.items()}
    )
    return yarn if yarn.is_on else Irregularity()


# -------------------------------------------------------------------------------------------- bends of weaves


# Crossings of a drawdown that are looked at once, to fit caches.
_CROSSINGS_AT_ONCE = 1 << 18


class Structure(Enum):
    """Which basic weave a drawdown resembles most."""

    PLAIN = "plain"
    TWILL = "twill"
    SATIN = "satin"


@dataclass(frozen=True)
class Bend:
    """Bend of one family: inclination of a float's ends and twist of the fibres, degrees."""

    inclination_deg: float
    twist_deg: float


_BENDS = {
    Structure.PLAIN: (Bend(22, 0), Bend(16, 0)),
    Structure.TWILL: (Bend(24, -30), Bend(24, -30)),
    Structure.SATIN: (Bend(60, 0), Bend(35, 0)),
}


def structure_of(drawdown: NDArray[np.bool_]) -> Structure:
    """The structure of a drawdown [picks, ends].

    Plain: each end crosses like its neighbour or exactly the other way (tabby, basket, rib). Satin: most
    points that stand alone among their four neighbours stand alone among all eight. Twill: all else.
    """
    picks, ends = drawdown.shape
    same, opposite = np.ones((2, ends), bool)
    of_four = of_eight = 0
    step = max(1, _CROSSINGS_AT_ONCE // ends)
    for first in range(0, picks, step):
        near = drawdown[np.arange(first - 1, min(first + step, picks) + 1) % picks]
        here, below, above = near[1:-1], near[:-2], near[2:]
        beside = here != np.roll(here, 1, axis=1)
        same &= ~beside.any(axis=0)
        opposite &= beside.all(axis=0)
        alone = beside & (here != np.roll(here, -1, axis=1)) & (here != below) & (here != above)
        of_four += int(alone.sum())
        for diagonal in (np.roll(row, shift, axis=1) for row in (below, above) for shift in (1, -1)):
            alone &= here != diagonal
        of_eight += int(alone.sum())
    if (same | opposite).all():
        return Structure.PLAIN
    return Structure.SATIN if of_four * 50 >= drawdown.size and 2 * of_eight >= of_four else Structure.TWILL


def bends_of(drawdown: NDArray[np.bool_]) -> tuple[Bend, Bend]:
    """Default bends of warp and weft; in a weft-faced satin the weft takes the warp's."""
    structure = structure_of(drawdown)
    warp, weft = _BENDS[structure]
    weft_faced = drawdown.mean() < 0.5
    return (weft, warp) if structure is Structure.SATIN and weft_faced else (warp, weft)


# ------------------------------------------------------------------------------------------ spacing and width


def family_spacing(
    fields: FabricFile, name: str, threads: Threads, other: Threads, count: int, take_up: float = 1.0
) -> NDArray[np.float64]:
    """Distance that each thread of family `name` ("warp" or "weft") takes up [count], millimetres.

    The file's threads/cm come first; the draft's spacing, where there is one, keeps its proportions
    and is scaled to them. Without either, the other family's density is used, so that the cloth is square.
    Of an artwork with a regulator the file's density counts the share `take_up` of the threads.
    """
    density = threads_per_cm(fields, name)
    if threads.spacing_mm is not None:
        scale = 1.0 if density is None else take_up * _MM_PER_CM / density / float(threads.spacing_mm.mean())
        return threads.spacing_mm * scale
    if density is None:
        density = threads_per_cm(fields, "weft" if name == "warp" else "warp")
    if density is not None:
        return np.full(count, _MM_PER_CM / density)
    if other.spacing_mm is not None:
        return np.full(count, float(other.spacing_mm.mean()))
    return np.full(count, _MM_PER_CM / DEFAULT_SETT_PER_CM)


def _take_up(fields: FabricFile, weft: Threads) -> float:
    """Share of the picks that take up cloth: all but those while an artwork's regulator stands still."""
    first = fields.artwork.regulator
    if first is None or weft.color_index is None:
        return 1.0
    # Wefts are rows 1, 2 … of the palette of an artwork; a draft of another origin may have no such wefts.
    return float((weft.color_index < first).mean()) or 1.0


def threads_per_cm(fields: FabricFile, name: str) -> float | None:
    """Threads/cm that the file gives for a family, in centimetres or in inches; None without."""
    per_cm, per_inch = (
        (fields.ends_per_cm, fields.epi) if name == "warp" else (fields.picks_per_cm, fields.ppi)
    )
    return per_inch / CM_PER_INCH if per_inch is not None else per_cm


def family_width(
    fields: FabricFile, name: str, threads: Threads, spacing: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Width of each thread of family `name`, millimetres, as many as `spacing`.

    The family's own width or gap comes first, then its count, the draft's thickness, the file's gap, and the
    gap of its kind of yarn. A yarn of a count is at least as wide as it is when round; where its kind leaves
    a smaller gap it spreads towards that, by the kind's `spread` at most, as an ellipse of the same area.

    Raises:
        InputError: a yarn count that cannot be read.
    """
    table: YarnTable = getattr(fields, name)
    of_count = None if table.count is None else yarn_diameter(table, f"{name}.count")
    if table.width_mm is not None:
        return np.full_like(spacing, table.width_mm)
    if table.gap is not None:
        return spacing * (1 - table.gap)
    if of_count is not None:
        kind = kind_of(table)
        return np.clip((1 - kind.gap) * spacing, of_count, of_count * kind.spread)
    if threads.thickness_mm is not None:
        return threads.thickness_mm
    return spacing * (1 - (kind_of(table).gap if fields.gap is None else fields.gap))


def yarn_diameter(table: YarnTable, field: str) -> float:
    """Diameter of a round yarn of the table's count and kind, millimetres.

    Raises:
        InputError: a yarn count that cannot be read; the message names `field`.
    """
    kind = kind_of(table)
    try:
        return yarn_diameter_mm(str(table.count), density=kind.density, packing=kind.packing)
    except InputError as error:
        raise InputError(f"{field}: {error}") from error


# ----------------------------------------------------------------------------------------- colours of threads


def coloured_draft(draft: Draft, fields: FabricFile) -> Draft:
    """`draft` with a colour for every thread: the file's, else its own, else a dark warp and a light weft.

    Where a family of the draft has two or more colours in an order of its own, a list of as many replaces
    them, in the order of the draft's palette. A longer list, and any list where there is no such order, is in
    thread order and repeats.

    Raises:
        InputError: a list that is shorter than the draft's order, or that makes too long a repeat.
    """
    warp = _listed_colours(fields.warp, "warp", draft.warp)
    weft = _listed_colours(fields.weft, "weft", draft.weft)
    by_role = replace(draft, warp=_with_roles(draft.warp, warp), weft=_with_roles(draft.weft, weft))
    return with_palette(by_role, warp, weft)


def _with_roles(threads: Threads, listed: NDArray[np.float64] | None) -> Threads:
    """`threads` whose `color_index` counts the colours that this family uses; None for thread order."""
    if threads.color_index is None or listed is None:
        return threads
    used, role = np.unique(threads.color_index, return_inverse=True)
    in_thread_order = len(used) == 1 or len(listed) > len(used)
    return replace(threads, color_index=None if in_thread_order else role.reshape(-1))


def _listed_colours(table: YarnTable, name: str, threads: Threads) -> NDArray[np.float64] | None:
    """The list of colours [k, 3] to apply; None leaves the draft's own."""
    given = table.albedo if table.color is None else table.color
    if given is None:
        if threads.colors is not None:
            return None
        given = WARP_COLOUR if name == "warp" else WEFT_COLOUR
    field = f"{name}.{'albedo' if table.color is None else 'color'}"
    return np.array([parse_colour(colour, field) for colour in colours_in_order(given, field)])
