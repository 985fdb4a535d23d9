"""A fabric for Blender: maps of its fitted material in three densities, of which the add-on makes nodes.

The add-on (`blender_addon.py`) asks `loomlight export FABRIC --to blender` for this folder, whose form is
`FORMAT`. Colours are kept apart from weights: of each family there is a map of what a colour is multiplied
by, so that other colours need no new maps.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from loomlight.core.colour import linear_to_srgb
from loomlight.exporters.cycles import CyclesLayers, cycles_layers, with_light_of_texels
from loomlight.exporters.fit import FittedMaterial, fit_texels
from loomlight.exporters.gltf import eight_bits
from loomlight.exporters.texels import MIN_COVER, TexelGrid, Texels, TextureSize, texture_grid, tile_repeats
from loomlight.fabric.colour import faded
from loomlight.fabric.fabric import Fabric, make_fabric
from loomlight.fabric.fields import SheenTable
from loomlight.fabric.resolve import ResolvedFamily
from loomlight.models.interface import Model
from loomlight.models.registry import make_model

Numbers = NDArray[np.float64]
FAMILIES = ("warp", "weft")
# The form of the folder; the add-on says which it reads.
FORMAT = 3
# Texels of a density, in threads: near, eight a thread, is the default of `texture_grid`. And how many
# threads its maps hold at most of uneven yarns, which show as a pattern in pictures that hold more.
DENSITIES: dict[str, tuple[float | None, int]] = {"near": (None, 96), "mid": (1.0, 512), "far": (8.0, 1024)}
# A side, of any density: Blender holds some twenty such pictures.
MAX_TEXELS = 2048
# Texels a thread of the nearest density.
_TEXELS_A_THREAD = 8
# Share of what is seen that lies too deep to count for heights.
_DEEP = 0.02
# Reflectance of a family's colour below which weights would grow without bound.
_DARKEST = 2e-3


def write_maps(folder: Path, fabric: Fabric, model: str, distance: float | None) -> dict[str, object]:
    """Writes maps/DENSITY-NAME.png of three densities, and returns what the manifest says.

    Raises:
        InputError: too many texels, or the model does not take the fabric.
    """
    from loomlight.core.llvm import require_llvm

    require_llvm()
    (folder / "maps").mkdir()
    # Blender has the sheen of `lobes` (Zeltner, Burley and Chiang 2022): what is fitted lies below it.
    bare = _without_sheen(fabric)
    fitted = make_model(model, bare)
    colours = {name: shown_colour(getattr(fabric.resolved, name)) for name in FAMILIES}
    materials = {name: _write_density(folder, name, bare, fitted, colours) for name in DENSITIES}
    heights, (low, high) = heights_of(materials["near"][0])
    Image.fromarray(heights).save(folder / "maps" / "height.png")
    sheen = fabric.appearance().sheen
    return {
        "format": FORMAT,
        "loomlight": version("loomlight"),
        "colors": {name: colour.tolist() for name, colour in colours.items()},
        "sheen": {"strength": sheen.strength, "roughness": sheen.roughness},
        "diffuse_blend": bare.appearance().diffuse_blend,
        "height": {"file": "maps/height.png", "low_mm": low, "high_mm": high},
        "densities": [described for _, described in materials.values()],
    }


def repeats_of(fabric: Fabric, density: str) -> tuple[int, int]:
    """Repeats across and up that the maps of a density hold, fewer of uneven yarns if texels are too many."""
    picks, ends = fabric.layout().warp_on_top.shape
    threads, held = DENSITIES[density]
    across, up = tile_repeats(fabric, None, _TEXELS_A_THREAD * held)
    most = int(MAX_TEXELS * (threads or 1 / _TEXELS_A_THREAD))
    return min(across, max(most // ends, 1)), min(up, max(most // picks, 1))


def _without_sheen(fabric: Fabric) -> Fabric:
    bare = fabric.fields.model_copy(update={"sheen": SheenTable()})
    return make_fabric(bare, fabric.named_draft, fabric.name, fabric.folder)


def shown_colour(family: ResolvedFamily) -> Numbers:
    """The mean colour [3] of a family's threads as a fabric file states it, rubbed, linear RGB."""
    return np.maximum(faded(family.colours, family.worn).mean(axis=0), _DARKEST)


def _write_density(
    folder: Path, name: str, fabric: Fabric, model: Model, colours: dict[str, Numbers]
) -> tuple[FittedMaterial, dict[str, object]]:
    """Writes the maps of one density; returns the material, and what the manifest says of them."""
    columns, rows, repeats = _grid(fabric, name)
    grid = TexelGrid(fabric, columns, rows, repeats)
    material = fit_texels(fabric, model, grid, "gltf")
    blend = fabric.appearance().diffuse_blend
    if name == "near":
        material = with_light_of_texels(material, grid, model, blend)
    layers = cycles_layers(material, grid, model, blend)
    maps = density_maps(material, layers, grid.filled(), colours)
    entry: dict[str, object] = {
        "name": name,
        "size_mm": [*material.size],
        "texel_mm": max(material.size[0] / columns, material.size[1] / rows),
    }
    described = {}
    for key, one in maps.items():
        file = f"maps/{name}-{key}.png"
        Image.fromarray(one.pixels).save(folder / file)
        described[key] = {"file": file, "peak": one.peak, "is_color": one.is_color}
    facts = {"diffuse_roughness": layers.diffuse_roughness, "relative_rms_error": round(layers.error, 4)}
    return material, entry | {"texels": [columns, rows], "maps": described} | facts


def _grid(fabric: Fabric, density: str) -> TextureSize:
    """Textures of a density, whose texels are larger where those were too many."""
    layout, (threads, _) = fabric.layout(), DENSITIES[density]
    repeats = repeats_of(fabric, density)
    width, height = np.multiply(layout.size, repeats)
    texel = max(width, height) / MAX_TEXELS
    if threads is not None:
        texel = max(texel, threads * math.sqrt(float(np.prod(layout.size)) / layout.warp_on_top.size))
    size = texture_grid(fabric, None, repeats)
    if threads is not None or max(size.columns, size.rows) > MAX_TEXELS:
        size = texture_grid(fabric, texel, repeats)
    return size


@dataclass(frozen=True, eq=False)
class DensityMap:
    """A map of one density.

    Attributes:
        pixels: [rows, columns, 3], 8 bits, row 0 at the upper edge.
        peak: what values from 0 to 1 are multiplied by.
        is_color: whether `pixels` are coded as sRGB is.
    """

    pixels: NDArray[np.uint8]
    peak: float = 1.0
    is_color: bool = False


def density_maps(
    material: FittedMaterial, layers: CyclesLayers, texels: Texels, colours: dict[str, Numbers]
) -> dict[str, DensityMap]:
    """The maps of a fitted material by their names.

    "warp", "weft": what the colour of a family is multiplied by; their sum is diffuse reflection. "through":
    colour of diffuse transmission. "glossy": reflectance of the highlight, the same from everywhere.
    "normal": in the frame of u and v. "fibres": cosine and sine of twice the angle from u to the axis along
    which the highlight is narrow, coded as normals are, and its anisotropy 1 − √(α narrow / α wide).
    "surface": roughness, the root of the geometric mean of both α, and opacity.
    """
    glossy = material.weight * material.specular
    # What the highlight takes is not left for the layer below it.
    reflected = (
        material.base * (1 - material.transmission - glossy.max(-1) * (1 - material.transmission))[..., None]
    )
    parts = layers.diffuse * _parts(np.maximum(reflected, 0), texels)
    wide, narrow = material.alpha_x, material.alpha_y
    x, y = -material.direction[..., 1], material.direction[..., 0]
    fibres = [0.5 + 0.5 * (x * x - y * y), 0.5 + x * y, 1 - np.sqrt(narrow / wide)]
    opacity = material.cover
    return {
        name: _coloured(part / colours[name])
        for name, part in zip(FAMILIES, np.moveaxis(parts, -2, 0), strict=True)
    } | {
        "through": _coloured(material.transmit * material.transmission[..., None]),
        "glossy": _coloured(layers.glossy * glossy),
        "normal": DensityMap(eight_bits(0.5 + 0.5 * material.normal)),
        "fibres": DensityMap(eight_bits(np.stack(fibres, axis=-1))),
        "surface": DensityMap(eight_bits(np.stack([(wide * narrow) ** 0.25, opacity, 0 * opacity], axis=-1))),
    }


def _coloured(values: Numbers) -> DensityMap:
    peak = max(float(values.max()), 1e-6)
    return DensityMap(eight_bits(linear_to_srgb(values / peak)), peak, is_color=True)


def _parts(reflected: Numbers, texels: Texels) -> Numbers:
    """Diffuse reflection [rows, columns, 3] by family [rows, columns, 2, 3].

    A fit multiplies the albedos of each family by one factor, which least squares find again.
    """
    seen = texels.share[..., None] * texels.diffuse
    known = (texels.cover > MIN_COVER) & (reflected.max(-1) < 1)
    rows = np.moveaxis(seen[known], -2, -1).reshape(-1, 2)
    factors = np.linalg.lstsq(rows, reflected[known].ravel(), rcond=None)[0] if known.any() else np.ones(2)
    factors = np.maximum(factors, 0) if factors.max() > 0 else np.ones(2)
    weighed = seen * factors[:, None]
    total = weighed.sum(-2, keepdims=True)
    share = np.where(total > 1e-9, weighed / np.maximum(total, 1e-9), texels.share[..., None])
    return np.asarray(share * reflected[..., None, :])


def heights_of(material: FittedMaterial) -> tuple[NDArray[np.uint16], tuple[float, float]]:
    """Heights above the surface of the mesh, 16 bits, row 0 at the upper edge; and what 0 and 65535 are, mm.

    What lies deeper than nearly all that is seen, and holes, are as low as the lowest that counts.
    """
    is_seen = material.cover > MIN_COVER
    seen = material.height[is_seen]
    low, high = (float(np.quantile(seen, share)) for share in (_DEEP, 1)) if seen.size else (0.0, 0.0)
    found = np.where(is_seen, np.maximum(material.height, low), low)
    scale = 65535 / max(high - low, 1e-6)
    return np.rint(scale * (found[::-1] - low)).astype(np.uint16), (low, max(high, low + 1e-6))
