"""The BTF of a Mitsuba scene of one tile: paths traced through nine copies of its shapes.

Geometry may stick out of its tile by up to half of it, as yarns do that cross its sides: each copy brings its
own. BSDFs are shared by all copies.
"""

from __future__ import annotations

import copy
import warnings
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import mitsuba as mi
import numpy as np

from loomlight.assets.tile import TileScene
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.mitsuba.faults import reason_of
from loomlight.mitsuba.meshes import check_scene_meshes
from loomlight.mitsuba.periodic_paths import COPIES, PeriodicPaths, Tile
from loomlight.mitsuba.variants import choose_variant

# Rays start so many times the shorter side of the tile away from surfaces: a hundredth of a fibre of 0.001 of
# that side.
_EPSILON = 1e-5
# Rays that say whether there are holes at all.
_TRIALS = 1 << 14
_SCENE = "loomlight-tile.xml"
_CURVES = ("bsplinecurve", "linearcurve")
# Of a curve that is not met: a millionth of a fibre.
_NO_RADIUS = 1e-9


class TileBtf(PeriodicPaths):
    """f·cos of paths through a tile.

    Attributes:
        faces: 2 for a tile of two sides.
        transmits: whether light from the other side counts.
        has_holes: whether rays pass straight through.
    """

    def __init__(self, source: TileScene) -> None:
        """
        Raises:
            InputError: a scene that Mitsuba cannot load, that emits light, has no shapes, or whose geometry
                sticks out of its tile by more than half of it.
        """
        choose_variant(None)
        scene = _loaded(source)
        box, (width, height) = scene.bbox(), source.size_mm
        if not scene.shapes():
            raise InputError(f"{source.name}: its scene has no shapes.")
        if scene.emitters():
            raise InputError(f"{source.name}: its scene holds an emitter; queries bring their own light.")
        low, high = (np.array(corner).ravel() for corner in (box.min, box.max))
        sides = np.array([width, height])
        # Of all copies.
        overhang = np.maximum(-COPIES * sides - low[:2], high[:2] - (1 + COPIES) * sides).clip(min=0)
        if (overhang > 0.5 * sides).any():
            raise InputError(
                f"{source.name}: its geometry sticks out of size_mm = {list(source.size_mm)} by "
                f"{overhang.max():.3g} mm; at most half of a side may."
            )
        epsilon = _EPSILON * min(width, height)
        outside = float(overhang[0]), float(overhang[1])
        super().__init__(
            Tile(scene, source.size_mm, float(high[2]), float(low[2]), outside, epsilon, source.bounces)
        )
        self.faces = 2 if source.two_sided else 1
        self.transmits = source.two_sided
        rng = np.random.default_rng(0)
        positions = rng.random((_TRIALS, 2), np.float32) * sides.astype(np.float32)
        upright = np.tile(np.array([0, 0, 1], np.float32), (_TRIALS, 1))
        self.has_holes = bool(self.holes(positions, upright).any())


def _loaded(source: TileScene) -> Any:
    root = ElementTree.fromstring(source.scene)
    curves = {
        node.get("value")
        for shape in root.findall("shape")
        if shape.get("type") in _CURVES
        for node in shape.findall("string")
    }
    with TemporaryDirectory(prefix="loomlight-") as name:
        folder = Path(name)
        for path, held in source.files.items():
            try:
                (folder / path).parent.mkdir(parents=True, exist_ok=True)
                (folder / path).write_bytes(_with_last_curve(held) if path in curves else held)
            except OSError as error:  # one file's name is another one's folder
                raise InputError(f"{source.name}: its file {path} cannot be written.") from error
        file = folder / _SCENE
        try:
            # Each mesh once, before there are copies of it; one that cannot be checked is refused.
            file.write_text(source.scene, encoding="utf-8")
            with warnings.catch_warnings():
                warnings.simplefilter("error", LoomlightWarning)
                check_scene_meshes(file)
            file.write_text(_repeated(root, source), encoding="utf-8")
            return mi.load_file(str(file), parallel=False, optimize=False)
        except (InputError, LoomlightWarning, RuntimeError) as error:
            said = reason_of(error).replace(f"{folder}/", "")
            raise InputError(f"{source.name}: Mitsuba cannot load its scene: {said}") from error


def _with_last_curve(held: bytes) -> bytes:
    """A file of curves and one that no ray meets.

    Mitsuba 3.9 finds the segment of a hit anew from its place among all, rounded. At the end of the last one
    that is a segment too many, and reads beyond all of them: a crash, which a further curve prevents.
    """
    points = [line.split() for line in held.decode("utf-8", "replace").splitlines()]
    first = [words for words in points if len(words) == 4][:4]
    last = "".join(f"{x} {y} {z} {_NO_RADIUS}\n" for x, y, z, _ in first)
    return held + b"\n\n" + last.encode()


def _repeated(root: ElementTree.Element, source: TileScene) -> str:
    """The scene with all copies of its shapes."""
    width, height = source.size_mm
    for number, shape in enumerate(list(root.findall("shape"))):
        if shape.get("type") == "shapegroup":
            continue
        root.remove(shape)
        for bsdf in shape.findall("bsdf"):
            # Before the shapes that refer to it.
            name = bsdf.get("id") or f"loomlight-bsdf-{number}"
            bsdf.set("id", name)
            shape.remove(bsdf)
            root.insert(0, bsdf)
            ElementTree.SubElement(shape, "ref", {"name": "bsdf", "id": name})
        for row in range(-COPIES, COPIES + 1):
            for column in range(-COPIES, COPIES + 1):
                root.append(_moved(shape, column * width, row * height, -source.reference_height_mm))
    return ElementTree.tostring(root, encoding="unicode")


def _moved(shape: ElementTree.Element, x: float, y: float, z: float) -> ElementTree.Element:
    moved = copy.deepcopy(shape)
    # All copies of a shape cannot have its name.
    moved.attrib.pop("id", None)
    to_world = next((node for node in moved.findall("transform") if node.get("name") == "to_world"), None)
    if to_world is None:
        to_world = ElementTree.SubElement(moved, "transform", {"name": "to_world"})
    ElementTree.SubElement(to_world, "translate", {"x": repr(x), "y": repr(y), "z": repr(z)})
    return moved
