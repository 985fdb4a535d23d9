"""Pictures of Blender's Cycles with the add-on's material, beside `lobes`: the same mesh, camera and light.

A sheet with gentle waves under parallel rays and an even sky; direct light alone, a box filter. A distance is
the width of cloth that the picture shows: in 10 mm yarns lie open, from 200 mm on they cover a pixel or less.
The middle of the picture is the middle of the maps: where they repeat, uneven yarns are others by chance, and
no picture of cloth is near that of the same cloth at another place (denim, 10 mm: FLIP 0.37).
Blender runs as a process of the Python that `python` names, in which `pip install bpy` was done.
"""

from __future__ import annotations

import json
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import delta_e_2000, lab_of_linear
from loomlight.core.errors import InputError
from loomlight.core.images import read_linear
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.metrics import flip_mean
from loomlight.evaluation.table import Table
from loomlight.exporters import export
from loomlight.fabric import Fabric, load_fabric
from loomlight.mesh.cloth_mesh import ClothMesh, uv_size, vertex_normals
from loomlight.mitsuba import choose_variant, material_bsdf, render, to_shape
from loomlight.mitsuba.camera import FIELD_OF_VIEW, View, perspective
from loomlight.mitsuba.scenes import empty_scene, loaded_bsdf
from loomlight.models.registry import make_model
from studies.harness.study import REPOSITORY, Figures, Found, Run, Study, example, listed, names, on_display
from studies.instruments.composed_scenes import cloth_pixels
from studies.instruments.sheet import Row, Tile, contact_sheet

FABRICS = ("denim", "linen", "silk-satin", "gabardine", "organza", "tweed")
# Widths of cloth in the middle of the picture, millimetres, and the largest FLIP that there is to be.
WIDTHS = {"10 mm": (10.0, 0.25), "200 mm": (200.0, 0.15), "500 mm": (500.0, 0.15)}
MAX_COLOUR_DIFFERENCE = 3.0
# The maps that are shown most.
_SHOWN = {"10 mm": "near", "200 mm": "mid", "500 mm": "far"}
PICTURE = REPOSITORY / "integrations" / "blender" / "picture.py"
# The sheet: side and height of its waves, metres, their number, and vertices a side.
_SIDE, _WAVE, _WAVES, _VERTICES = 0.8, 0.012, 5, 241
# Light: irradiance across parallel rays, as `render --light directional` has it, and radiance of the sky.
_IRRADIANCE, _SKY = float(np.pi), 0.25
_SUN = np.array([-0.45, 0.5, 0.75])
_TOWARDS_CAMERA = np.array([0.15, 0.3, 1.0])
Numbers = NDArray[np.float32]


@dataclass(frozen=True)
class Blender(Settings):
    fabrics: str = names(",".join(FABRICS), "Example fabrics.")
    widths: str = names("10 mm,200 mm", "Widths of cloth in the picture.", tuple(WIDTHS))
    side: int = setting(128, "Pixels of a picture.", low=8)
    spp: int = setting(32, "Samples a pixel of `lobes`.", low=1)
    blender_spp: int = setting(32, "Samples a pixel of Cycles.", low=1)
    displacement: bool = setting(False, "Displaces the sheet by the yarns, in place of their normals.")
    python: str = setting(".venv-bpy/bin/python", "The Python that has the package bpy.", metavar="PATH")


def measure(settings: Blender, run: Run) -> Found:
    """FLIP and difference of the mean colour by fabric and width; the maps of a fabric are fitted once."""
    if not Path(settings.python).is_file():
        raise InputError(f"{settings.python} is no Python with Blender: python -m venv, pip install bpy.")
    choose_variant(None)
    rows, tiles, missed = [], [], []
    for name in listed(settings.fabrics):
        fabric = load_fabric(example(name))
        with tempfile.TemporaryDirectory() as temporary:
            maps = export(fabric, "blender", Path(temporary) / "maps")
            densities = json.loads((maps / "manifest.json").read_text(encoding="utf-8"))["densities"]
            sizes = {density["name"]: density["size_mm"] for density in densities}
            for width in listed(settings.widths):
                across, up = sizes[_SHOWN[width]]
                sheet = waves((across / 2, up / 2))
                view = view_of(sheet, WIDTHS[width][0])
                truth, counted = of_lobes(fabric, sheet, view, settings)
                found = of_blender(maps, sheet, view, settings, Path(temporary))
                row = compared(truth, found, counted) | {"fabric": name, "width": width}
                rows.append(row)
                missed += misses(row)
                pictures = [on_display(truth), on_display(found)]
                caption = f"FLIP {row['flip']:.3f}, dE {row['colour_difference']:.1f}"
                tiles.append(Row(f"{name}, {width}", [Tile(pictures[0]), Tile(pictures[1], caption)]))
                run.report(len(rows), len(listed(settings.fabrics)) * len(listed(settings.widths)))
    page = contact_sheet("Cloth in Blender beside lobes", ["lobes", "Blender, Cycles"], tiles)
    return Found({"pictures": rows, "missed": missed}, page)


def compared(truth: Numbers, found: Numbers, counted: NDArray[np.bool_]) -> Figures:
    """Errors of a picture over the pixels that count."""
    means = [picture[counted].mean(axis=0, dtype=np.float64) for picture in (truth, found)]
    return {
        "flip": flip_mean(found, truth, counted),
        "colour_difference": float(delta_e_2000(*(lab_of_linear(mean) for mean in means))),
        "brightness": float(means[1].mean() / means[0].mean()),
    }


def misses(row: Figures) -> list[str]:
    """The bars that a picture does not meet, a sentence each."""
    bars = {"flip": WIDTHS[row["width"]][1], "colour_difference": MAX_COLOUR_DIFFERENCE}
    return [
        f"{row['fabric']}, {row['width']}: {key} {row[key]:.3f} above {bar:g}"
        for key, bar in bars.items()
        if row[key] > bar
    ]


# ----------------------------------------------------------------------------------------------- the pictures


def waves(middle_mm: tuple[float, float]) -> ClothMesh:
    """A sheet with gentle waves, its front towards +z; uv are metres.

    Args:
        middle_mm: uv of its middle, millimetres.
    """
    v, u = np.meshgrid(np.linspace(0, 1, _VERTICES), np.linspace(0, 1, _VERTICES), indexing="ij")
    x, y = _SIDE * (u - 0.5), _SIDE * (v - 0.5)
    turns = 2 * np.pi * _WAVES / _SIDE
    # The middle lies on a slope, across both families.
    z = _WAVE * np.sin(turns * (x + 0.4 * y))
    corner = np.arange(_VERTICES**2).reshape(_VERTICES, _VERTICES)
    a, b, c, d = (
        part.ravel() for part in (corner[:-1, :-1], corner[:-1, 1:], corner[1:, 1:], corner[1:, :-1])
    )
    triangles = np.concatenate([np.stack([a, b, c], axis=-1), np.stack([a, c, d], axis=-1)])
    positions = np.stack([x, y, z], axis=-1).reshape(-1, 3)
    uv = np.stack([x, y], axis=-1).reshape(-1, 2) + np.array(middle_mm) / 1000
    return ClothMesh(positions, vertex_normals(positions, triangles), uv, triangles, "waves")


def view_of(sheet: ClothMesh, width_mm: float) -> View:
    """The view of the sheet's middle that shows so much of it."""
    middle = sheet.positions[len(sheet.positions) // 2]
    distance = width_mm / 2000 / np.tan(np.radians(FIELD_OF_VIEW / 2))
    return View(middle + distance * _TOWARDS_CAMERA / np.linalg.norm(_TOWARDS_CAMERA), middle)


def of_lobes(
    fabric: Fabric, sheet: ClothMesh, view: View, settings: Blender
) -> tuple[Numbers, NDArray[np.bool_]]:
    """The linear picture of `lobes`, and which pixels are cloth."""
    size = (settings.side, settings.side)
    sensor = perspective(view, size)
    sensor["film"]["rfilter"] = {"type": "box"}
    shape = to_shape(sheet, loaded_bsdf(material_bsdf(make_model("lobes", fabric))(uv_size(sheet))))
    shape.set_id("piece0")
    sun = {"type": "rgb", "value": _IRRADIANCE}
    parts: dict[str, Any] = {
        **empty_scene(),
        "sensor": sensor,
        "piece0": shape,
        "sun": {"type": "directional", "direction": (-_SUN).tolist(), "irradiance": sun},
        "sky": {"type": "constant", "radiance": {"type": "rgb", "value": _SKY}},
    }
    scene = mi.load_dict(parts)
    integrator = mi.load_dict({"type": "footprint_path", "max_depth": 2})
    picture = render(scene, spp=settings.spp, seed=1, integrator=integrator)
    return np.asarray(picture, np.float32), cloth_pixels(scene, size)


def of_blender(maps: Path, sheet: ClothMesh, view: View, settings: Blender, folder: Path) -> Numbers:
    """The linear picture of Cycles.

    Raises:
        InputError: Blender failed; the message ends with what it said last.
    """
    np.savez(folder / "mesh.npz", positions=sheet.positions, uv=sheet.uv, triangles=sheet.triangles)
    right = np.cross(view.up, view.backward)
    right /= np.linalg.norm(right)
    to_world = np.stack([right, np.cross(view.backward, right), view.backward, view.origin], axis=-1)
    job = {
        "maps": str(maps),
        "mesh": str(folder / "mesh.npz"),
        "camera": to_world.tolist(),
        "field_of_view": view.field_of_view,
        "side": settings.side,
        "samples": settings.blender_spp,
        "sun": _SUN.tolist(),
        "irradiance": _IRRADIANCE,
        "sky": _SKY,
        "displacement": settings.displacement,
        "output": str(folder / "blender.exr"),
    }
    (folder / "job.json").write_text(json.dumps(job), encoding="utf-8")
    words = [settings.python, str(PICTURE), str(folder / "job.json")]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise InputError(f"Blender failed: {done.stderr.strip().splitlines()[-1:]}.")
    return read_linear(folder / "blender.exr")


def tables(figures: Figures) -> list[Table]:
    """Errors by fabric and width."""
    rows = {
        f"{row['fabric']}, {row['width']}": [row["flip"], row["colour_difference"], row["brightness"]]
        for row in figures["pictures"]
    }
    columns = ["FLIP", "ΔE2000 of the mean", "brightness over lobes'"]
    return [Table("Cloth in Cycles", columns, rows)]


STUDY = Study(
    "accuracy/blender",
    "how near the material of the Blender add-on comes to `lobes`, in Cycles",
    Blender(),
    measure,
    tables,
    stands_on=("lobes",),
    small={"fabrics": "denim", "widths": "200 mm", "side": 16, "spp": 1, "blender_spp": 1},
)
