"""How near the standard material of `loomlight export --to gltf` comes to lobes: spheres, and their FLIP.

A sphere under one directional light, without shadows of the sphere. Textures are made for the distance from
which a pixel is a texel; a pixel reads the mean of 16 places of its footprint, as mipmaps give it. The
material is evaluated by `loomlight.exporters.fit`, which follows the specification, so that the error
is of the fit and the textures alone.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from drjit.llvm import Array2f, Array3f
from numpy.typing import NDArray

from loomlight.core.footprint import Footprint
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.metrics import flip_mean
from loomlight.evaluation.table import Table
from loomlight.exporters.fit import FittedMaterial, fit_material
from loomlight.exporters.standards import StandardMaterial, evaluate_gltf
from loomlight.exporters.texels import frames, texture_grid
from loomlight.fabric import load_fabric
from loomlight.models.interface import Model
from loomlight.models.registry import make_model
from studies.harness.study import Figures, Found, Run, Study, example, listed, names, on_display
from studies.instruments.sheet import Row, Tile, contact_sheet

FABRICS = ("denim", "silk-satin", "wool-houndstooth", "linen")
# Pixels a thread, in the middle of the sphere.
DISTANCES = {"close": 8.0, "middle": 1.0, "far": 0.25}
Numbers = NDArray[np.float64]


@dataclass(frozen=True)
class ExportFit(Settings):
    fabrics: str = names(",".join(FABRICS), "Example fabrics.")
    distances: str = names(",".join(DISTANCES), "Pixels a thread.", tuple(DISTANCES))
    side: int = setting(192, "Pixels of a picture.", low=8)


def measure(settings: ExportFit, run: Run) -> Found:
    """FLIP and brightness by fabric and distance."""
    rows, tiles = [], {}
    for name in listed(settings.fabrics):
        fabric = load_fabric(example(name))
        model = make_model("lobes", fabric)
        layout = fabric.layout()
        pitch = float(np.sqrt(np.prod(layout.size) / layout.warp_on_top.size))
        for distance in listed(settings.distances):
            texel = pitch / DISTANCES[distance]
            material = fit_material(fabric, model, *texture_grid(fabric, texel))
            sphere = _Sphere(texel, settings.side)
            truth, found = (
                sphere.picture(sphere.of_model(model)),
                sphere.picture(sphere.of_material(material)),
            )
            counted = sphere.is_hit
            row = {
                "fabric": name,
                "distance": distance,
                "flip": flip_mean(found, truth, counted),
                "brightness": float(found[counted].mean() / truth[counted].mean()),
                "relative_rms_error_of_fit": material.error,
            }
            rows.append(row)
            shown = [on_display(linear) for linear in (truth, found)]
            tiles[f"{name}, {distance}"] = [Tile(shown[0]), Tile(shown[1], f"FLIP {row['flip']:.3f}")]
    sheet = contact_sheet(
        "Standard materials beside lobes",
        ["lobes", "standard material"],
        [Row(label, both) for label, both in tiles.items()],
    )
    return Found({"pictures": rows}, sheet)


class _Sphere:
    """A sphere that fills a picture, seen by parallel rays; places and directions of its pixels [n, ...]."""

    def __init__(self, texel: float, side: int) -> None:
        self._side = side
        axis = (np.arange(side) + 0.5) / side * 2.1 - 1.05
        x, y = np.meshgrid(axis, -axis)
        self.is_hit = x**2 + y**2 < 0.97
        x, y = x[self.is_hit], y[self.is_hit]
        self.normal = np.stack([x, y, np.sqrt(1 - x**2 - y**2)], axis=-1)
        radius = texel * side / 2.1
        step = 2.1 / side
        self.centre = self._draft(x, y, radius)
        self.dx = self._draft(x + step / 8, y, radius) - self.centre
        self.dy = self._draft(x, y - step / 8, radius) - self.centre
        self.dx, self.dy = 8 * self.dx, 8 * self.dy
        along = np.stack([self.normal[:, 2], 0 * x, -self.normal[:, 0]], axis=-1)
        along /= np.linalg.norm(along, axis=-1, keepdims=True)
        axes = (along, np.cross(self.normal, along), self.normal)
        light = np.array([0.5, 0.6, 0.8]) / np.linalg.norm([0.5, 0.6, 0.8])
        self.light = np.stack([vectors @ light for vectors in axes], axis=-1)
        self.view = np.stack([vectors[:, 2] for vectors in axes], axis=-1)

    def _draft(self, x: Numbers, y: Numbers, radius: float) -> Numbers:
        z = np.sqrt(np.maximum(1 - x**2 - y**2, 1e-4))
        return radius * np.stack([np.arctan2(x, z), np.arcsin(y)], axis=-1)

    def picture(self, values: Numbers) -> NDArray[np.float32]:
        """A picture [rows, columns, 3] under an irradiance of 2π."""
        image = np.full((self._side, self._side, 3), 0.02, np.float32)
        lit = self.light[:, 2:] > 0
        image[self.is_hit] = 2 * np.pi * values * lit
        return image

    def of_model(self, model: Model) -> Numbers:
        """Values of a model, with its holes black."""
        places = (Array2f(rows.T.astype(np.float32)) for rows in (self.centre, self.dx, self.dy))
        view, light = (Array3f(rows.T.astype(np.float32)) for rows in (self.view, self.light))
        value = model.at(view, Footprint(*places)).value(light)
        return np.stack([np.asarray(part.numpy(), np.float64) for part in value], axis=-1)

    def of_material(self, material: FittedMaterial) -> Numbers:
        """Values of the material, from means of its textures."""

        def texture(values: Numbers) -> Numbers:
            rows, columns = material.cover.shape
            width, height = material.size
            total = np.zeros((len(self.centre), *values.shape[2:]))
            for s in (np.arange(4) + 0.5) / 4 - 0.5:
                for t in (np.arange(4) + 0.5) / 4 - 0.5:
                    place = self.centre + s * self.dx + t * self.dy
                    column = np.floor(place[:, 0] / width * columns).astype(int) % columns
                    row = np.floor(place[:, 1] / height * rows).astype(int) % rows
                    total += values[row, column] / 16
            return total

        normal = texture(material.normal)
        normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
        x, y = frames(normal)
        # A direction and its opposite are the same: their doubled angles have a mean.
        direction = material.direction
        doubled = np.stack(
            [direction[..., 0] ** 2 - direction[..., 1] ** 2, 2 * direction[..., 0] * direction[..., 1]],
            axis=-1,
        )
        mean = texture(doubled)
        angle = 0.5 * np.arctan2(mean[:, 1], mean[:, 0])
        axis_x = np.cos(angle)[:, None] * x + np.sin(angle)[:, None] * y
        places = StandardMaterial(
            base=texture(material.base),
            transmission=texture(material.transmission),
            transmit=texture(material.transmit),
            specular=texture(material.specular),
            weight=material.weight,
            alpha_x=texture(material.alpha_x),
            alpha_y=texture(material.alpha_y),
            normal=normal,
            axis_x=axis_x,
            axis_y=np.cross(normal, axis_x),
            sheen=material.sheen,
            sheen_roughness=material.sheen_roughness,
        )
        return evaluate_gltf(places, self.light, self.view) * texture(material.cover)[:, None]


def tables(figures: Figures) -> list[Table]:
    """FLIP and brightness by fabric and distance."""
    rows = {
        f"{row['fabric']}, {row['distance']}": [
            row["flip"],
            row["brightness"],
            row["relative_rms_error_of_fit"],
        ]
        for row in figures["pictures"]
    }
    columns = ["FLIP", "brightness over lobes'", "relative RMS error of the fit"]
    return [Table("Standard materials on spheres", columns, rows)]


STUDY = Study(
    "accuracy/export_fit",
    "how near the standard material of `loomlight export --to gltf` comes to `lobes`, on spheres",
    ExportFit(),
    measure,
    tables,
    stands_on=("lobes",),
    small={"fabrics": "denim", "distances": "far", "side": 24},
)
