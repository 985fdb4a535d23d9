"""Albedos of one family, a row a thread: from colour, specular and translucency, or explicit."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import parse_colour
from loomlight.core.errors import InputError
from loomlight.fabric.defaults import ROUGHNESS, SPECULAR, TRANSLUCENCY
from loomlight.fabric.file import YarnTable
from loomlight.scattering.appearance import FamilyAppearance
from loomlight.weave.draft import Threads

_ALBEDOS = ("diffuse_reflect", "diffuse_transmit", "specular_reflect", "specular_transmit")


def family_appearance(table: YarnTable, name: str, threads: Threads) -> FamilyAppearance:
    """Appearance of the coloured `threads` of family `name` ("warp" or "weft").

    Raises:
        InputError: explicit albedos that together send back more light than arrives.
    """
    if threads.colors is None:
        raise ValueError("the threads have no colours")
    albedos = _derived(
        threads.colors,
        SPECULAR if table.specular is None else table.specular,
        TRANSLUCENCY if table.translucency is None else table.translucency,
    )
    for key in _ALBEDOS:
        value = getattr(table, key)
        if value is not None:
            albedos[key] = np.tile(parse_colour(value, f"{name}.{key}"), (len(threads.colors), 1))
    _require_bounded(albedos, name)
    return FamilyAppearance(**albedos, roughness=ROUGHNESS if table.roughness is None else table.roughness)


def _derived(
    colours: NDArray[np.float64], specular: float, translucency: float
) -> dict[str, NDArray[np.float64]]:
    left = colours * (1 - specular)
    shine = np.full_like(colours, specular)
    return {
        "diffuse_reflect": left * (1 - translucency),
        "diffuse_transmit": left * translucency,
        "specular_reflect": shine * (1 - translucency),
        "specular_transmit": shine * translucency,
    }


def _require_bounded(rows: dict[str, NDArray[np.float64]], name: str) -> None:
    total = (
        rows["diffuse_reflect"]
        + rows["diffuse_transmit"]
        + np.maximum(rows["specular_reflect"], rows["specular_transmit"])
    )
    if total.max() > 1 + 1e-9:
        raise InputError(f"the albedos of [{name}] send back {total.max():.3g} of the light.")
