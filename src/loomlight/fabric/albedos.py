"""Albedos of one family, a row a thread: from colour, specular and translucency, or explicit."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import parse_colour
from loomlight.fabric.defaults import ROUGHNESS, SPECULAR, TRANSLUCENCY
from loomlight.fabric.file import YarnTable
from loomlight.scattering.albedo import Albedos, albedos_from_colour, check_albedos
from loomlight.scattering.appearance import FamilyAppearance

if TYPE_CHECKING:  # it needs Dr.Jit, and fabrics do not
    from loomlight.scattering.openness import Openness


def family_appearance(
    table: YarnTable,
    name: str,
    colours: NDArray[np.float64],
    optical_depth: float,
    shown_by: tuple[Openness, int] | None = None,
) -> FamilyAppearance:
    """Appearance of threads of linear RGB `colours` [n, 3] in family `name` ("warp" or "weft").

    A tint only takes from the highlight, so it keeps the energy bound.

    Args:
        shown_by: the cloth's openness and the number of the family, by which colours are those that cloth
            shows (`authored_colour.py`), unless the file gives albedos; None makes albedos of them.

    Raises:
        InputError: explicit albedos that together send back more light than arrives.
    """
    specular = SPECULAR if table.specular is None else table.specular
    translucency = TRANSLUCENCY if table.translucency is None else table.translucency
    roughness = ROUGHNESS if table.roughness is None else table.roughness
    bound = None
    if shown_by is not None:
        from loomlight.fabric.authored_colour import colour_for
        from loomlight.scattering.fibre import cloth_layer_bound

        bound = cloth_layer_bound(roughness, optical_depth)
        if table.albedo is None:
            openness, number = shown_by
            colours = colour_for(colours, specular, translucency, openness, number, roughness, optical_depth)
    albedos = albedos_from_colour(colours, specular, translucency, optical_depth, bound)
    if table.specular_tint is not None:
        tint = parse_colour(table.specular_tint, f"{name}.specular_tint")
        albedos = albedos._replace(
            specular_reflect=albedos.specular_reflect * tint,
            specular_transmit=albedos.specular_transmit * tint,
        )
    albedos = _with_explicit(albedos, table, name)
    check_albedos(albedos, name, optical_depth, bound)
    return FamilyAppearance(**albedos._asdict(), roughness=roughness)


def _with_explicit(albedos: Albedos, table: YarnTable, name: str) -> Albedos:
    given = {key: getattr(table, key) for key in Albedos._fields if getattr(table, key) is not None}
    threads = len(albedos.diffuse_reflect)
    rows = {key: np.tile(parse_colour(value, f"{name}.{key}"), (threads, 1)) for key, value in given.items()}
    return albedos._replace(**rows)
