"""The fibres of a fabric as a tile that `neumip` bakes: plies and fibres of every yarn, as curves.

The tile is a Mitsuba scene of B-spline curves with its hair BSDF, as the basket weave of kuznetsov2021, Fig.
12, is. Absorption follows from the colour of a thread by the fit of Chiang et al. 2016, eq. 9.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from xml.sax.saxutils import quoteattr

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.core.files import replacing_all
from loomlight.fabric.fabric import Fabric
from studies.instruments.fibre_curves import FibreCurves, FibreSettings, fibre_curves

SCENE, TILE = "scene.xml", "tile.toml"
# Control points of a cubic B-spline [n, 3] and its radius, millimetres.
Curve = tuple[NDArray[np.float64], float]
# Roughness of fibres along and around them; colours are kept off black and white, where absorption ends.
_ROUGHNESS = 0.3
_OPAQUE_ROUGHNESS, _SPECULAR = 0.55, 0.3
_COLOURS = (0.01, 0.95)
# Vertices of a path: pale fibres scatter often.
_BOUNCES, _OPAQUE_BOUNCES = 16, 6


def write_fibre_tile(
    fabric: Fabric, folder: str | os.PathLike[str], settings: FibreSettings | None = None
) -> Path:
    """Writes the fibres of one repeat of a fabric as a tile, all files or none, and returns its TOML file.

    Raises:
        InputError: settings that cannot be, or a folder that cannot be written.
    """
    groups = [
        (np.array(colour), [(fibre, one.radius) for one in curves for fibre in one.points])
        for colour, curves in _by_colour(fabric, settings or FibreSettings())
    ]
    return write_curves(Path(folder), TILE, fabric.repeat_mm, groups)


def write_curves(
    folder: Path,
    name: str,
    size_mm: tuple[float, float],
    groups: Sequence[tuple[NDArray[np.float64], Sequence[Curve]]],
    digits: int = 5,
    heading: str = "",
    front_mm: float | None = None,
) -> Path:
    """Writes curves as a tile, all files or none, and returns its TOML file.

    Args:
        name: of the TOML file.
        groups: colours, linear RGB 0.01 to 0.95, and the curves that have them.
        digits: of millimetres.
        heading: the first lines of the TOML file.
        front_mm: where most of the front lies, of curves that are opaque and seen from there alone:
            a rough dielectric over a diffuse base covers them. None lets light through, as hair does.

    Raises:
        InputError: a folder that cannot be written.
    """
    shapes, texts = [], {}
    for number, (colour, curves) in enumerate(groups):
        file = f"fibres-{number}.txt"
        texts[file] = "\n\n".join(
            "\n".join(
                f"{x:.{digits}f} {y:.{digits}f} {z:.{digits}f} {radius:.{digits}f}" for x, y, z in points
            )
            for points, radius in curves
        )
        shapes.append(
            f"{_bsdf(colour, front_mm is not None, f'fibre-{number}')}"
            f'  <shape type="bsplinecurve">\n'
            f'    <string name="filename" value={quoteattr(file)}/>\n'
            f'    <ref id="fibre-{number}"/>\n'
            f"  </shape>\n"
        )
    texts[SCENE] = '<scene version="3.0.0">\n' + "".join(shapes) + "</scene>\n"
    width, height = size_mm
    seen = (
        f"two_sided = true\nbounces = {_BOUNCES}\n"
        if front_mm is None
        else f"reference_height_mm = {front_mm!r}\nbounces = {_OPAQUE_BOUNCES}\n"
    )
    texts[name] = f'{heading}tile = "{SCENE}"\nsize_mm = [{width!r}, {height!r}]\n{seen}'
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"{folder} cannot be made: {error.strerror}.") from error
    with replacing_all([folder / file for file in texts]) as files:
        for place, text in zip(files, texts.values(), strict=True):
            place.write_text(text, encoding="utf-8")
    return folder / name


def _by_colour(fabric: Fabric, settings: FibreSettings) -> list[tuple[tuple[float, ...], list[FibreCurves]]]:
    """Fibres of threads of one colour together."""
    appearance = fabric.appearance()
    groups: dict[tuple[float, ...], list[FibreCurves]] = {}
    for curves in fibre_curves(fabric.layout(), settings):
        family = appearance.warp if curves.is_warp else appearance.weft
        row = curves.thread % len(family.diffuse_reflect)
        # All that a thread scatters, to either side.
        albedo = sum(
            np.asarray(part[row])
            for part in (
                family.diffuse_reflect,
                family.diffuse_transmit,
                np.maximum(family.specular_reflect, family.specular_transmit),
            )
        )
        colour = tuple(float(value) for value in np.clip(albedo, *_COLOURS))
        groups.setdefault(colour, []).append(curves)
    return list(groups.items())


def _bsdf(colour: NDArray[np.float64], is_opaque: bool, name: str) -> str:
    """The element of a colour's BSDF."""
    if is_opaque:
        base = ", ".join(f"{value:.5f}" for value in colour)
        return (
            f'  <bsdf type="principled" id="{name}">\n'
            f'    <rgb name="base_color" value="{base}"/>\n'
            f'    <float name="roughness" value="{_OPAQUE_ROUGHNESS}"/>\n'
            f'    <float name="specular" value="{_SPECULAR}"/>\n'
            f"  </bsdf>\n"
        )
    absorption = ", ".join(f"{value:.5f}" for value in _absorption(colour))
    return (
        f'  <bsdf type="hair" id="{name}">\n'
        f'    <rgb name="sigma_a" value="{absorption}"/>\n'
        f'    <float name="longitudinal_roughness" value="{_ROUGHNESS}"/>\n'
        f'    <float name="azimuthal_roughness" value="{_ROUGHNESS}"/>\n'
        f"  </bsdf>\n"
    )


def _absorption(colour: NDArray[np.float64]) -> NDArray[np.float64]:
    """Absorption over the diameter of fibres that, many together, have this colour."""
    n = _ROUGHNESS
    divisor = 5.969 - 0.215 * n + 2.532 * n**2 - 10.73 * n**3 + 5.574 * n**4 + 0.245 * n**5
    return np.asarray((np.log(colour) / divisor) ** 2)
