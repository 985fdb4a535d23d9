"""Exports opened by three.js beside `loomlight render`: a cushion by glTF and by USD, in the light of a room.

The cushion of the examples, seen from its front so that a pixel is a texel of the textures (1080 rows and 26°
of view are cut to a square), lit by the room of the examples alone: Mitsuba shows `lobes`, three.js what its
own loaders make of the files in Chromium, USD as UsdPreviewSurface.
"""

from __future__ import annotations

import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import delta_e_2000, lab_of_linear, srgb_to_linear
from loomlight.core.errors import InputError
from loomlight.core.picture_settings import GarmentSettings
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.metrics import flip_mean
from loomlight.evaluation.table import Table
from loomlight.exporters.fit import FittedMaterial
from loomlight.exporters.garment import clothed_garment
from loomlight.exporters.garment_gltf import garment_glb, textures_of
from loomlight.exporters.materials import fitted
from loomlight.exporters.usd import write_package
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.read import load_fabric
from loomlight.mesh.reading import read_mesh
from loomlight.mitsuba import choose_variant, material_bsdf, render, to_shape, uv_size
from loomlight.mitsuba.lights import environment_dict
from studies.harness.study import EXAMPLES, Figures, Found, Run, Study, example, listed, names, on_display
from studies.instruments.sheet import Row, Tile, contact_sheet
from studies.instruments.three_page import ThreePage, missing, three_page

FABRICS = ("denim", "linen", "silk-satin", "wool-houndstooth")
# From the camera to the front of the cushion, metres.
DISTANCES = {"30 cm": 0.3, "2 m": 2.0}
_MESH, _ROOM, _FRONT = EXAMPLES / "cushion.obj", EXAMPLES / "room.exr", 0.09
_ROWS, _DEGREES, _SECONDS = 1080, 26.0, 120.0
FORMATS = ("glTF", "USD")


@dataclass(frozen=True)
class OpenedExports(Settings):
    fabrics: str = names(",".join(FABRICS), "Example fabrics.")
    distances: str = names(",".join(DISTANCES), "From the camera to the cloth.", tuple(DISTANCES))
    side: int = setting(256, "Pixels of a picture.", low=8)
    spp: int = setting(64, "Samples a pixel of Mitsuba's pictures.", low=1)


def measure(settings: OpenedExports, run: Run) -> Found:
    """FLIP, the difference of mean colours and the ratio of means, by fabric, distance and format."""
    if missing():
        raise InputError(f"accuracy/opened_exports draws with three.js, and {missing()}.")
    choose_variant(None)
    rows, tiles = [], []
    for name in listed(settings.fabrics):
        fabric = load_fabric(example(name))
        for label in listed(settings.distances):
            truth = _by_mitsuba(fabric, DISTANCES[label], settings)
            with tempfile.TemporaryDirectory() as folder:
                _export(fabric, fitted(fabric, "lobes", DISTANCES[label]), Path(folder))
                with three_page(Path(folder), _SECONDS, _ROOM) as page:
                    drawn = [_by_three(page, file, DISTANCES[label], settings) for file in _FILES]
            row = [Tile(on_display(truth))]
            for kind, picture in zip(FORMATS, drawn, strict=True):
                found = _errors(picture, truth)
                rows.append({"fabric": name, "distance": label, "format": kind} | found)
                row.append(Tile(on_display(picture), f"FLIP {found['flip']:.3f}"))
            tiles.append(Row(f"{name}, {label}", row))
            run.report(len(tiles), len(listed(settings.fabrics)) * len(listed(settings.distances)))
    sheet = contact_sheet("Exports in three.js", ["loomlight render", *FORMATS], tiles)
    return Found({"pictures": rows}, sheet)


_FILES = ("cloth.glb", "cloth.usdz")


def _export(fabric: Fabric, fit: FittedMaterial, folder: Path) -> None:
    """The cushion in a material that is fitted already, as both files."""
    garment = clothed_garment(fabric, GarmentSettings(mesh=_MESH), lambda _: fit)
    (folder / _FILES[0]).write_bytes(garment_glb(garment, [textures_of(cloth) for cloth in garment.cloths]))
    write_package(folder / _FILES[1], garment)


def _view(distance: float, side: int) -> tuple[tuple[float, float, float], float]:
    """Where the camera stands, and its field of view, degrees."""
    half = np.tan(np.radians(_DEGREES / 2)) * side / _ROWS
    return (0.0, 0.0, _FRONT + distance), float(2 * np.degrees(np.arctan(half)))


def _by_mitsuba(fabric: Fabric, distance: float, settings: OpenedExports) -> NDArray[np.float32]:
    mesh = read_mesh(_MESH)
    eye, degrees = _view(distance, settings.side)
    towards: Any = mi.ScalarTransform4f().look_at(list(eye), [0, 0, 0], [0, 1, 0])
    film = {"type": "hdrfilm", "width": settings.side, "height": settings.side, "rfilter": {"type": "box"}}
    scene = mi.load_dict(
        {
            "type": "scene",
            "shape": to_shape(mesh, material_bsdf(fabric)(uv_size(mesh, 1.0))),
            "room": environment_dict(_ROOM),
            "sensor": {"type": "perspective", "fov": degrees, "to_world": towards, "film": film},
        }
    )
    integrator = mi.load_dict({"type": "footprint_path", "max_depth": 4})
    return render(scene, spp=settings.spp, integrator=integrator, denoise="off")


def _by_three(page: ThreePage, file: str, distance: float, settings: OpenedExports) -> NDArray[np.float32]:
    eye, degrees = _view(distance, settings.side)
    _, picture = page.draw(file, eye, degrees=degrees, side=settings.side)
    return srgb_to_linear(picture / 255).astype(np.float32)


def _errors(picture: NDArray[np.float32], truth: NDArray[np.float32]) -> Figures:
    means = [each.reshape(-1, 3).mean(axis=0) for each in (picture, np.clip(truth, 0, 1))]
    return {
        "flip": flip_mean(picture, truth, np.ones(truth.shape[:2], bool)),
        "colour_difference": float(delta_e_2000(*map(lab_of_linear, means))),
        "brightness": float(means[0].mean() / means[1].mean()),
    }


def tables(figures: Figures) -> list[Table]:
    """Errors by fabric, distance and format."""
    columns = ["FLIP", "CIEDE2000 of mean colours", "brightness over render's"]
    rows = {
        f"{row['fabric']}, {row['distance']}, {row['format']}": [
            row["flip"],
            row["colour_difference"],
            row["brightness"],
        ]
        for row in figures["pictures"]
    }
    return [Table("Exports opened by three.js", columns, rows)]


STUDY = Study(
    "accuracy/opened_exports",
    "how near what three.js shows of glTF and USD comes to `loomlight render`, on a cushion in a room",
    OpenedExports(),
    measure,
    tables,
    stands_on=("lobes",),
    small={"fabrics": "denim", "distances": "2 m", "side": 32, "spp": 4},
)
