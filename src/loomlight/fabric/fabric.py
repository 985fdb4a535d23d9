"""A fabric: a draft, where its threads lie and how they scatter, made from the fields of a fabric file."""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from loomlight.fabric.fields import FabricFile
from loomlight.fabric.resolve import ResolvedFabric, ResolvedFamily, resolve
from loomlight.fabric.write import fabric_toml
from loomlight.scattering.appearance import Appearance, FamilyAppearance
from loomlight.weave.draft import Draft
from loomlight.yarn.layout import ClothLayout


@dataclass(frozen=True, eq=False)
class Fabric:
    """One fabric, valid as a whole; `load_fabric` and `fabric_from_text` make it.

    Attributes:
        name: in messages and reports.
        fields: of the fabric file, without defaults.
        named_draft: the draft as `fields` name it, before they colour and repeat it.
        folder: the folder that paths in `fields` are relative to.
        resolved: all numbers of it.
    """

    name: str
    fields: FabricFile
    named_draft: Draft
    folder: str
    resolved: ResolvedFabric

    @property
    def draft(self) -> Draft:
        """One repeat, thread colours included."""
        return self.resolved.draft

    def layout(self) -> ClothLayout:
        """Where the threads of one repeat lie, millimetres and radians."""
        return self._layout

    @cached_property
    def _layout(self) -> ClothLayout:
        return self.resolved.layout

    def appearance(self) -> Appearance:
        """Scattering parameters: albedos a thread (linear RGB), roughness, sheen, variation, openness."""
        return self._appearance

    @cached_property
    def _appearance(self) -> Appearance:
        # Colours and rays need Dr.Jit, which reading a fabric does not load.
        from loomlight.fabric.colour import family_appearance, warn_of_colours_out_of_reach
        from loomlight.scattering.openness import openness_of

        resolved, openness = self.resolved, None
        blend, depth = resolved.diffuse_blend, resolved.optical_depth
        if resolved.interreflection:
            roughness = resolved.warp.roughness, resolved.weft.roughness
            openness = openness_of(self._layout, blend, roughness, depth)
            warn_of_colours_out_of_reach(self.fields, resolved, openness)
        return Appearance(
            warp=family_appearance(resolved.warp, "warp", depth, openness),
            weft=family_appearance(resolved.weft, "weft", depth, openness),
            sheen=resolved.sheen,
            variation=resolved.variation,
            diffuse_blend=blend,
            optical_depth=depth,
            openness=openness,
        )

    def recoloured(self, family: str, colours: NDArray[np.float64]) -> FamilyAppearance:
        """The appearance of `family`, "warp" or "weft", with another `color` a thread [n, 3], linear RGB."""
        from loomlight.fabric.colour import family_appearance

        own: ResolvedFamily = getattr(self.resolved, family)
        own = replace(own, colours=colours, are_albedos=False)
        return family_appearance(own, family, self.resolved.optical_depth, self._appearance.openness)

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
    resolved = resolve(fields, draft)
    for family in ("warp", "weft"):
        own: ResolvedFamily = getattr(resolved, family)
        if own.given_albedos:
            # Albedos of colours keep the bound; those that a file states may break it.
            from loomlight.fabric.colour import family_appearance

            family_appearance(own, family, resolved.optical_depth, None)
    return Fabric(name, fields, draft, folder, resolved)
