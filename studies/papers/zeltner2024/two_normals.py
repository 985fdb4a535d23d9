"""Two materials of two normal maps each, tilted by 10 to 15° under lobes of α 0.05 to 0.1.

The four of `layered_materials.py` hardly need learned frames: they have one normal map each, whose median
tilt is less than α in two of them. In these, two lobes are about normals that differ from one another by
many times their width, as under the paper's coats.

- varnished wood: fibres that run along v under a varnish with brush marks;
- crushed foil: a wrinkled metal under another, finer film.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from loomlight.sources.material import Material
from studies.papers.zeltner2024.layered_materials import SIDE, material_of, png_of
from studies.papers.zeltner2024.layered_textures import Map, noise, normal_map

_Layer = tuple[float, tuple[float, float, float]]
# α and reflectance of the two lobes, and the share of the second.
_LOBES: dict[str, tuple[_Layer, _Layer, float]] = {
    "varnished-wood": ((0.1, (0.42, 0.2, 0.08)), (0.05, (0.7, 0.68, 0.62)), 0.35),
    "crushed-foil": ((0.07, (0.75, 0.5, 0.2)), (0.05, (0.35, 0.5, 0.75)), 0.5),
}
TWO_NORMALS = tuple(_LOBES)


def _heights(name: str, side: int) -> tuple[Map, Map]:
    if name == "varnished-wood":
        return noise(side, 81, 24, 3, falloff=0.5), noise(side, 82, 3, 12, falloff=0.6)
    return noise(side, 83, 10, falloff=0.8), noise(side, 84, 20, falloff=0.6)


def two_normal_maps(name: str, side: int = SIDE) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Normal maps [side, side, 3] of both lobes; the root mean square of tilts is 15°, medians 10 to 13°."""
    maps = []
    for height in _heights(name, side):
        across, along = (0.5 * side * (np.roll(height, -1, k) - np.roll(height, 1, k)) for k in (1, 0))
        steepness = math.sqrt(float((across**2 + along**2).mean()))
        maps.append(normal_map(height, math.tan(math.radians(15)) / steepness))
    return maps[0], maps[1]


def two_normal_material(name: str, side: int = SIDE) -> Material:
    """One of `TWO_NORMALS` as a source.

    Args:
        side: texels of its textures.
    """
    first, second, share = _LOBES[name]
    xml = (
        f'<bsdf type="blendbsdf"><float name="weight" value="{share}"/>'
        f"{_lobe('first', *first)}{_lobe('second', *second)}</bsdf>"
    )
    maps = zip(("first", "second"), two_normal_maps(name, side), strict=True)
    return material_of(name, xml, {f"{file}.png": png_of(file, values) for file, values in maps})


def _lobe(file: str, alpha: float, colour: tuple[float, float, float]) -> str:
    """A metal of one reflectance under a normal map."""
    red, green, blue = colour
    return (
        '<bsdf type="normalmap"><texture type="bitmap" name="normalmap"><boolean name="raw" value="true"/>'
        f'<string name="filename" value="{file}.png"/></texture><bsdf type="roughconductor">'
        f'<string name="material" value="none"/><string name="distribution" value="ggx"/>'
        f'<float name="alpha" value="{alpha}"/>'
        f'<rgb name="specular_reflectance" value="{red}, {green}, {blue}"/></bsdf></bsdf>'
    )
