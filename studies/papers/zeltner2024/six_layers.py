"""A material of six layers: steel that was painted, chipped, rusted, handled and left to the dust.

None of the materials of `layered_materials.py` has more than three layers, and a network of fixed size is
meant for more of them. From below, each with textures of its own, and each over the one before by the weight
of a texture:

- steel: a rough conductor with brushing in its normals, its colour and its α;
- rust: matt, with bumps;
- primer: rough plastic;
- paint: a base with orange peel under a clear coat;
- grease: fingerprints and smears;
- dust: diffuse.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from loomlight.sources.material import Material
from studies.papers.zeltner2024.layered_materials import SIDE, material_of, png_of
from studies.papers.zeltner2024.layered_textures import (
    fingerprint,
    grid,
    mixed,
    noise,
    normal_map,
    scratches,
    step,
)

SIX_LAYERS = "worn-machine"
# From below; the weight of each but the first is a texture of its name.
LAYERS = ("steel", "rust", "primer", "paint", "grease", "dust")


def six_layer_material(side: int = SIDE) -> Material:
    """`SIX_LAYERS` as a source.

    Args:
        side: texels of its textures.
    """
    pictures = {f"{file}.png": png_of(file, values) for file, values in _textures(side).items()}
    return material_of(SIX_LAYERS, _tree(), pictures)


def _textures(side: int) -> dict[str, NDArray[np.float64]]:
    """Maps by the names of their files."""
    _, v = grid(side)
    fine = noise(side, 101, side / 3, falloff=0.3)
    # Paint chips first, primer in the middle of its chips; rust eats what is bare, and creeps under edges.
    chips = noise(side, 102, 12, falloff=0.9) + 0.3 * noise(side, 103, side / 4, falloff=0.6)
    cuts = scratches(side, 104, 45, 0.007)
    bare = np.maximum(chips, 1.6 * cuts)
    spots = noise(side, 105, 24, falloff=0.8)
    lines = 0.7 * noise(side, 106, side / 2.2, 3, falloff=0.25) + 0.5 * noise(
        side, 107, side / 8, 2, falloff=0.4
    )
    prints = np.zeros((side, side))
    for number, (x, y, turn) in enumerate([(0.4, 0.58, 0.3), (0.55, 0.66, 0.0), (0.68, 0.56, -0.4)]):
        prints = np.maximum(prints, fingerprint(side, (x, y), turn, 0.09, 110 + number))
    smear = step(noise(side, 120, 8, falloff=1.4), 0.4, 1.8)
    film = step(v + 0.12 * noise(side, 121, 12), 0.45, 1.15)
    specks = step(noise(side, 122, side / 3, falloff=0.2), 2.2, 2.8)
    cloud = noise(side, 123, 20, falloff=1.2)
    return {
        "steel-colour": mixed((0.40, 0.39, 0.38), (0.66, 0.65, 0.64), (0.5 + 0.15 * lines).clip(0, 1)),
        "steel-alpha": (0.24 + 0.03 * lines + 0.08 * cuts).clip(0.12, 1),
        "steel-normal": normal_map(0.0002 * lines - 0.0006 * cuts, 1.0),
        "rust": 0.95 * step(spots + 0.3 * fine, 0.1, 1.1),
        "rust-colour": mixed((0.10, 0.028, 0.010), (0.36, 0.13, 0.035), (0.5 + 0.3 * spots).clip(0, 1)),
        "rust-roughness": (0.75 + 0.08 * fine).clip(0.5, 1),
        "rust-normal": normal_map(0.0016 * spots + 0.0005 * fine, 1.0),
        "primer": 1 - step(bare, 1.15, 1.4),
        "primer-colour": mixed((0.30, 0.27, 0.24), (0.42, 0.38, 0.33), (0.5 + 0.25 * fine).clip(0, 1)),
        "paint": 1 - step(bare, 0.7, 0.9),
        "paint-colour": mixed((0.02, 0.13, 0.15), (0.04, 0.24, 0.25), (0.5 + 0.3 * cloud).clip(0, 1)),
        "paint-roughness": (0.38 + 0.05 * cloud + 0.1 * step(chips, 0.2, 0.8)).clip(0.2, 1),
        "paint-normal": normal_map(
            0.0007 * noise(side, 124, 28, falloff=0.3) - 0.002 * step(bare, 0.5, 1), 1.0
        ),
        "grease": (0.45 * smear + 0.5 * prints).clip(0, 0.75),
        "grease-colour": mixed((0.018, 0.05, 0.05), (0.06, 0.075, 0.05), smear),
        "grease-roughness": (0.26 + 0.08 * noise(side, 125, 30, falloff=0.8)).clip(0.15, 1),
        "dust": (0.08 * step(cloud, -0.5, 2) + 0.35 * film + 0.5 * specks * (0.3 + film)).clip(0, 0.8),
        "dust-colour": mixed((0.36, 0.32, 0.27), (0.52, 0.48, 0.42), (0.5 + 0.25 * spots).clip(0, 1)),
    }


def _tree() -> str:
    """The XML: blends of all layers below with the next one."""
    layers = {
        "steel": _tilted(
            "steel",
            _bsdf(
                "roughconductor",
                '<string name="material" value="none"/><string name="distribution" value="ggx"/>',
                _map("specular_reflectance", "steel-colour"),
                _map("alpha", "steel-alpha"),
            ),
        ),
        "rust": _tilted("rust", _principled("rust", specular=0.2)),
        "primer": _bsdf(
            "roughplastic",
            '<float name="alpha" value="0.3"/>',
            _map("diffuse_reflectance", "primer-colour"),
        ),
        "paint": _tilted("paint", _principled("paint", specular=0.5, clearcoat=1.0, clearcoat_gloss=0.7)),
        "grease": _principled("grease", specular=0.6),
        "dust": _bsdf("diffuse", _map("reflectance", "dust-colour")),
    }
    tree = layers[LAYERS[0]]
    for name in LAYERS[1:]:
        tree = _bsdf("blendbsdf", _map("weight", name), tree, layers[name])
    return tree


def _bsdf(kind: str, *parts: str) -> str:
    return f'<bsdf type="{kind}">{"".join(parts)}</bsdf>'


def _map(parameter: str, file: str) -> str:
    """A bitmap; all but colours are raw."""
    raw = "false" if "colour" in file else "true"
    return (
        f'<texture type="bitmap" name="{parameter}"><string name="filename" value="{file}.png"/>'
        f'<boolean name="raw" value="{raw}"/></texture>'
    )


def _tilted(layer: str, bsdf: str) -> str:
    return _bsdf("normalmap", _map("normalmap", f"{layer}-normal"), bsdf)


def _principled(layer: str, **numbers: float) -> str:
    floats = "".join(f'<float name="{name}" value="{value}"/>' for name, value in numbers.items())
    return _bsdf(
        "principled",
        _map("base_color", f"{layer}-colour"),
        _map("roughness", f"{layer}-roughness"),
        floats,
    )
