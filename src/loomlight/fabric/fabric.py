"""A fabric: a draft, where its threads lie and how they scatter, made from the fields of a fabric file."""

from __future__ import annotations

import dataclasses
import os
from dataclasses import dataclass, replace
from functools import cached_property
from math import radians
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.fabric.albedos import family_appearance
from loomlight.fabric.colours import coloured_draft
from loomlight.fabric.defaults import (
    DIFFUSE_BLEND,
    HEIGHT_SCALE,
    OPTICAL_DEPTH,
    PLY_TWIST_DEG,
    Bend,
    bends_of,
)
from loomlight.fabric.file import FabricFile, YarnTable
from loomlight.fabric.spacing import family_spacing, family_width
from loomlight.fabric.writing import fabric_toml
from loomlight.fabric.yarns import with_yarns
from loomlight.scattering.appearance import Appearance, FamilyAppearance, Sheen, Variation, YarnDetail
from loomlight.weave.draft import Draft, Threads
from loomlight.yarn.layout import ClothLayout, FamilyLayout

# Crossings of a fabric: those of 4096 by 16384 threads, for which rendering takes gigabytes (docs/drafts.md).
MAXIMUM_CROSSINGS = 1 << 26
_FAMILIES = ("warp", "weft")


@dataclass(frozen=True, eq=False)
class Fabric:
    """One fabric, valid as a whole; `load_fabric` and `fabric_from_text` make it.

    Attributes:
        name: in messages and reports.
        draft: one repeat, thread colours included. It is longer than the draft in the file where a list of
            colours repeats later than the weave does.
        named_draft: the draft as `fields` name it, before they colour and repeat it.
        fields: of the fabric file, without defaults.
        folder: the folder that paths in `fields` are relative to.
    """

    name: str
    draft: Draft
    named_draft: Draft
    fields: FabricFile
    folder: str
    _layout: ClothLayout
    _own_appearance: Appearance

    def layout(self) -> ClothLayout:
        """Where the threads of one repeat lie, millimetres and radians."""
        return self._layout

    def appearance(self) -> Appearance:
        """Scattering parameters: albedos a thread (linear RGB), roughness, sheen, variation, openness."""
        return self._appearance

    @cached_property
    def _appearance(self) -> Appearance:
        own = self._own_appearance
        if self.fields.interreflection is False:
            return own
        # Rays need Dr.Jit, which reading a fabric does not load.
        from loomlight.fabric.gamut import warn_of_colours_out_of_reach
        from loomlight.scattering.openness import openness_of

        roughness = own.warp.roughness, own.weft.roughness
        openness = openness_of(self._layout, own.diffuse_blend, roughness, own.optical_depth)
        own = replace(own, openness=openness)
        warp, weft = (
            self._family(name, with_yarns(self.fields), _colours(getattr(self.draft, name)), own)
            for name in _FAMILIES
        )
        warn_of_colours_out_of_reach(with_yarns(self.fields), own.optical_depth, openness)
        return replace(own, warp=warp, weft=weft)

    def recoloured(self, family: str, colours: NDArray[np.float64]) -> FamilyAppearance:
        """The appearance of `family`, "warp" or "weft", with another `color` a thread [n, 3], linear RGB."""
        fields = with_yarns(self.fields)
        table = getattr(fields, family).model_copy(update={"albedo": None})
        return self._family(family, fields.model_copy(update={family: table}), colours, self._appearance)

    def _family(
        self, name: str, fields: FabricFile, colours: NDArray[np.float64], appearance: Appearance
    ) -> FamilyAppearance:
        openness = appearance.openness
        shown_by = None if openness is None else (openness, _FAMILIES.index(name))
        family = family_appearance(getattr(fields, name), name, colours, appearance.optical_depth, shown_by)
        return replace(family, detail=getattr(appearance, name).detail)

    def _repr_png_(self) -> bytes | None:
        """The drawdown in the yarns' colours as PNG, which notebooks display."""
        return self.draft._repr_png_()

    @property
    def default_uv_size_mm(self) -> tuple[float, float]:
        """Default millimetres per unit of u and of v: 100, for any repeat."""
        return 100.0, 100.0

    @property
    def repeat_mm(self) -> tuple[float, float]:
        """Width and height of one repeat, millimetres."""
        return self._layout.size

    def to_toml(self, folder: str | os.PathLike[str] | None = None) -> str:
        """The fabric as the text of a fabric file that lies in `folder` (None: the one it was read from)."""
        return fabric_toml(self.fields, self.folder, self.folder if folder is None else folder)


def make_fabric(fields: FabricFile, draft: Draft, name: str, folder: str) -> Fabric:
    """The fabric of a file's fields and of the draft that they name.

    Raises:
        InputError: fields that contradict the draft, albedos that exceed the light, an unreadable yarn count,
            or more than 67 million crossings.
    """
    given, fields = fields, with_yarns(fields)
    coloured = coloured_draft(draft, fields)
    if coloured.drawdown.size > MAXIMUM_CROSSINGS:
        raise InputError(
            f"the repeat of {coloured.ends} ends and {coloured.picks} picks has "
            f"{coloured.drawdown.size / 1e6:.0f} million crossings, and at most "
            f"{MAXIMUM_CROSSINGS / 1e6:.0f} million can be rendered: render a part of it."
        )
    optical_depth = OPTICAL_DEPTH if fields.optical_depth is None else fields.optical_depth
    layout = _layout(fields, coloured)
    warp = family_appearance(fields.warp, "warp", _colours(coloured.warp), optical_depth)
    weft = family_appearance(fields.weft, "weft", _colours(coloured.weft), optical_depth)
    appearance = Appearance(
        warp=replace(warp, detail=_detail(fields.warp, layout.warp)),
        weft=replace(weft, detail=_detail(fields.weft, layout.weft)),
        sheen=_sheen(fields),
        variation=_variation(fields),
        diffuse_blend=DIFFUSE_BLEND if fields.diffuse_blend is None else fields.diffuse_blend,
        optical_depth=optical_depth,
    )
    return Fabric(name, coloured, draft, given, folder, layout, appearance)


def _colours(threads: Threads) -> NDArray[np.float64]:
    if threads.colors is None:
        raise ValueError("threads without colours reached the appearance")
    return threads.colors


def _layout(fields: FabricFile, draft: Draft) -> ClothLayout:
    warp_bend, weft_bend = bends_of(draft.drawdown)
    warp_spacing = family_spacing(fields, "warp", draft.warp, draft.weft, draft.ends)
    weft_spacing = family_spacing(fields, "weft", draft.weft, draft.warp, draft.picks)
    return ClothLayout(
        warp_on_top=draft.drawdown,
        warp=FamilyLayout(
            spacing=warp_spacing,
            width=family_width(fields, "warp", draft.warp, warp_spacing),
            **_bend(fields.warp, warp_bend),
        ),
        weft=FamilyLayout(
            spacing=weft_spacing,
            width=family_width(fields, "weft", draft.weft, weft_spacing),
            **_bend(fields.weft, weft_bend),
        ),
    )


def _bend(table: YarnTable, default: Bend) -> dict[str, float]:
    inclination = default.inclination_deg if table.inclination_deg is None else table.inclination_deg
    twist = default.twist_deg if table.twist_deg is None else table.twist_deg
    height_scale = HEIGHT_SCALE if table.height_scale is None else table.height_scale
    return {"inclination": radians(inclination), "twist": radians(twist), "height_scale": height_scale}


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


def _sheen(fields: FabricFile) -> Sheen:
    return Sheen(**fields.sheen.model_dump(exclude_none=True))


def _variation(fields: FabricFile) -> Variation:
    return Variation(**fields.variation.model_dump(exclude_none=True))
