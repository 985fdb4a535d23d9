"""Four layered materials of the character of zeltner2024's, as trees of Mitsuba's BSDFs.

The paper's materials are not public. Like them these have several layers, each with procedural textures of
its own: a coat over a base, dirt over the coat, and normals that differ between layers. Their trees are files
of `examples/materials`, the textures are made here.

- glazed ceramic: a painted body under a crackled clear glaze, fingerprints on the glaze and dust over all;
- brushed metal: anisotropic steel with scratches along the brushing and greasy smudges;
- rough plastic: grained, with shiny smudges, worn edges of the grain and lint;
- patinated metal: hammered bronze, polished where hands touch it, under verdigris and soot.
"""

from __future__ import annotations

import io
from collections.abc import Callable, Mapping
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from loomlight.core.colour import linear_to_srgb
from loomlight.sources.material import Bytes, Material, material_from_xml
from studies.papers.zeltner2024.layered_textures import (
    cracks,
    fingerprint,
    grid,
    mixed,
    noise,
    normal_map,
    scratches,
    step,
)

EXAMPLES = Path(__file__).resolve().parents[3] / "examples" / "materials"
Textures = Mapping[str, NDArray[np.float64]]
SIZE_MM = (120.0, 120.0)
SIDE = 256
# Names of maps that hold colours: they are written as sRGB.
_COLOUR = "colour"


def _ceramic(side: int) -> Textures:
    u, v = grid(side)
    cloud = noise(side, 1, 24, falloff=1.3)
    # A vine: stems that wave about parallels of v, with leaves along them.
    stem = np.abs(((v * 3 + 0.09 * np.sin(2 * np.pi * 4 * u)) % 1) - 0.5)
    brush = 0.05 * noise(side, 2, 48)
    # Flowers of five petals between the stems, in two rows that are offset.
    row = np.floor(3 * v + 0.5)
    sideways, upwards = (6 * u + 0.5 * row) % 1 - 0.5, 2 * ((3 * v + 0.5) % 1 - 0.5)
    radius, angle = np.hypot(sideways, upwards), np.arctan2(upwards, sideways) + row
    petals = 0.30 + 0.10 * np.cos(5 * angle) - radius + brush * 0.6
    heart = step(-radius, -0.10, -0.07)
    leaves = np.cos(2 * np.pi * 24 * u) * step(-stem, -0.17, -0.05)
    painted = np.maximum(step(-stem + 0.3 * brush, -0.04, -0.02), step(leaves + brush, 0.45, 0.6))
    flowers = step(petals, 0, 0.03) * (0.45 + 0.55 * step(radius, 0.16, 0.33)) * (1 - heart)
    painted = np.maximum(painted, flowers)
    crackle = cracks(side, 3, 9, 0.003)
    body = mixed((0.80, 0.77, 0.70), (0.015, 0.045, 0.26), painted * (0.85 + 0.1 * cloud).clip(0, 1))
    body = body * (1 - 0.45 * crackle[..., None] * np.array([0.6, 0.8, 1.0]))
    prints = np.zeros((side, side))
    for number, (across, along, turn, size) in enumerate(
        [(0.42, 0.58, 0.4, 0.085), (0.56, 0.66, 0.1, 0.08), (0.69, 0.6, -0.3, 0.075), (0.3, 0.3, 1.2, 0.08)]
    ):
        prints = np.maximum(prints, fingerprint(side, (across, along), turn, size, 10 + number))
    smear = step(noise(side, 5, 10), 0.6, 2.2)
    roughness = np.clip(0.06 + 0.3 * prints + 0.1 * smear, 0, 1)
    ripple = 0.0018 * noise(side, 6, 10, falloff=0.8) - 0.0004 * crackle
    specks = step(noise(side, 7, side / 3, falloff=0.2), 2.3, 2.9)
    film = step(v + 0.12 * noise(side, 8, 12), 0.5, 1.15)
    dust = np.clip(0.1 * step(cloud, -0.5, 2.5) + 0.28 * film + 0.6 * specks * (0.3 + film), 0, 0.8)
    return {
        "colour": body,
        "roughness": roughness,
        "normal": normal_map(ripple, 1.0),
        "dust": dust,
    }


def _metal(side: int) -> Textures:
    # Brushed along v: fine lines that are long in v and narrow in u.
    fine = noise(side, 21, side / 2.2, 3, falloff=0.25)
    broad = noise(side, 22, side / 8, 2, falloff=0.4)
    lines = 0.65 * fine + 0.5 * broad
    cuts = scratches(side, 23, 60, 0.003, 1.2)
    grease = step(noise(side, 24, 7, falloff=1.6), 0.2, 1.4)
    prints = np.zeros((side, side))
    for number, (x, y, turn) in enumerate([(0.6, 0.6, 0.5), (0.45, 0.42, -0.2)]):
        prints = np.maximum(prints, fingerprint(side, (x, y), turn, 0.09, 25 + number))
    tarnish = step(noise(side, 29, 9, falloff=1.3), 0.2, 2.2)
    share = np.clip(0.55 + 0.14 * lines - 0.4 * tarnish, 0, 1)
    colour = mixed((0.36, 0.33, 0.29), (0.66, 0.65, 0.64), share)
    roughness = np.clip(0.33 + 0.035 * lines + 0.2 * cuts + 0.06 * grease, 0.1, 1)
    height = 0.00022 * lines - 0.00012 * cuts
    return {
        "colour": colour,
        "roughness": roughness,
        "normal": normal_map(height, 1.0),
        "smudge": np.clip(0.28 * grease + 0.5 * prints, 0, 0.75),
    }


def _plastic(side: int) -> Textures:
    grain = cracks(side, 41, 40, 0.012)
    fine = noise(side, 42, side / 4, falloff=0.3)
    smudge = step(noise(side, 43, 8, falloff=1.5), 0.0, 1.3)
    prints = np.zeros((side, side))
    for number, (x, y, turn) in enumerate([(0.36, 0.6, 0.2), (0.62, 0.44, 0.9), (0.52, 0.7, -0.4)]):
        prints = np.maximum(prints, fingerprint(side, (x, y), turn, 0.1, 45 + number))
    wear = step(noise(side, 50, 12), 0.8, 2.2)
    colour = mixed((0.32, 0.018, 0.012), (0.40, 0.06, 0.04), np.clip(0.5 + 0.2 * fine, 0, 1))
    colour = colour * (1 - 0.35 * grain[..., None]) + 0.05 * wear[..., None]
    roughness = np.clip(0.46 + 0.05 * fine - 0.14 * smudge - 0.1 * prints + 0.1 * grain, 0.15, 1)
    lint = scratches(side, 52, 60, 0.0025) * step(noise(side, 53, 9), 0.0, 1)
    return {
        "colour": colour.clip(0, 1),
        "roughness": roughness,
        "normal": normal_map(-0.0024 * grain + 0.0004 * fine, 1.0),
        "grease": np.clip(0.32 * smudge + 0.35 * prints, 0, 0.7),
        "lint": np.clip(0.55 * lint + 0.04, 0, 0.7),
    }


def _patina(side: int) -> Textures:
    dents = cracks(side, 61, 11, 0.06)
    cloud = noise(side, 62, 28, falloff=1.2)
    pits = step(noise(side, 63, side / 5, falloff=0.4), 1.2, 2.4)
    edges = np.clip(dents + 0.35 * cloud, 0, 2)
    grains = noise(side, 64, side / 4, falloff=0.5)
    verdigris = step(0.55 * cloud + 1.1 * edges + 0.4 * grains, 0.5, 1.9)
    share = np.clip(0.5 + 0.25 * cloud, 0, 1)
    colour = mixed((0.22, 0.09, 0.035), (0.72, 0.42, 0.19), share * (1 - 0.5 * dents))
    green = mixed((0.05, 0.19, 0.15), (0.22, 0.46, 0.37), np.clip(0.5 + 0.3 * noise(side, 65, 60), 0, 1))
    roughness = np.clip(0.24 + 0.1 * cloud + 0.25 * dents + 0.2 * pits, 0.12, 1)
    height = -0.0055 * dents + 0.0007 * noise(side, 66, 40, falloff=0.6) - 0.0012 * pits
    return {
        "colour": colour,
        "roughness": roughness,
        "normal": normal_map(height, 1.0),
        "patina": np.clip(verdigris, 0, 0.95),
        "patina-colour": green,
    }


_TEXTURES: dict[str, Callable[[int], Textures]] = {
    "glazed-ceramic": _ceramic,
    "brushed-metal": _metal,
    "rough-plastic": _plastic,
    "patinated-metal": _patina,
}
LAYERED = tuple(_TEXTURES)


def layered_parts(name: str, side: int = SIDE) -> tuple[str, dict[str, Bytes]]:
    """The XML of a layered material of `LAYERED`, and the bytes of its pictures by their file's name.

    Args:
        side: texels of its textures.
    """
    xml = (EXAMPLES / name / f"{name}.xml").read_text(encoding="utf-8")
    return xml, {f"{file}.png": png_of(file, values) for file, values in _TEXTURES[name](side).items()}


def layered_material(name: str, side: int = SIDE) -> Material:
    """One of `LAYERED` as a source; arguments as of `layered_parts`."""
    return material_of(name, *layered_parts(name, side))


def material_of(name: str, xml: str, pictures: Mapping[str, Bytes]) -> Material:
    """The material of an XML and the bytes of its pictures by their file's name."""
    with TemporaryDirectory() as folder:
        for file, content in pictures.items():
            (Path(folder) / file).write_bytes(content.tobytes())
        return material_from_xml(xml, folder, name, SIZE_MM)


def png_of(file: str, values: NDArray[np.float64]) -> Bytes:
    """The bytes of a picture of a map; colours, by the name of their file, are encoded as sRGB."""
    encoded = linear_to_srgb(values.clip(0, 1)) if _COLOUR in file else values
    pixels = np.rint(255 * np.clip(encoded, 0, 1)).astype(np.uint8)
    stream = io.BytesIO()
    # Row 0 of a map is at v = 0, the bottom of a picture.
    Image.fromarray(pixels[::-1]).save(stream, "PNG", optimize=True)
    return np.frombuffer(stream.getvalue(), np.uint8)
