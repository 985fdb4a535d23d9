"""Flicker of cloth that moves: how colours of points of the cloth change from frame to frame, and should.

A towel of `instruments/towel.py` falls and swings. Points of the cloth are followed over three frames,
where the camera sees them in all, in pictures of `lobes` and of `point`, denoised or not, with one seed for
all frames or one for each. Their colours change as light and folds do; how far that is from the change in
`point` with many samples is flicker, the root of its mean square, in steps of 8-bit sRGB. "own" is that of
such a reference against another one. "change" is the whole change over the reference's: 1 is none of a
pattern's own, and the bar for `lobes` of many samples is a tenth more.
"""

from __future__ import annotations

import tempfile
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.colour import linear_to_srgb
from loomlight.core.picture_settings import RenderSettings
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from loomlight.mesh.moving import Frame, find_frames
from loomlight.mitsuba.moving import MovingCloth
from studies.harness.study import Figures, Found, Run, Study, example
from studies.instruments import towel

Floats = NDArray[np.float64]

# Name, zoom, and the first of three frames: falling, then hanging near the end.
CASES = (("denim", 1.0, 28), ("wool-houndstooth", 1.0, 28), ("denim", 10.0, 36))
SEED, MANY = 0, 256
# Model, samples, how it is denoised, and whether every frame has a seed of its own.
PICTURES: dict[str, tuple[str, int, str, bool]] = {
    "lobes 8, denoised, one seed": ("lobes", 8, "auto", False),
    "lobes 8, denoised, seed by frame": ("lobes", 8, "auto", True),
    "lobes 8, one seed": ("lobes", 8, "off", False),
    "lobes 8, seed by frame": ("lobes", 8, "off", True),
    "point 8, denoised, one seed": ("point", 8, "auto", False),
    "point 8, denoised, seed by frame": ("point", 8, "auto", True),
    f"lobes {MANY}": ("lobes", MANY, "off", True),
}
BAR = 1.1


class Towel:
    """A moving towel, of which pictures are taken by several models from the same camera."""

    def __init__(self, frames: list[Frame], fabric: str, zoom: float, size: tuple[int, int]) -> None:
        path = example(fabric)
        self._size = size
        self._cloths = {}
        for model in ("lobes", "point"):
            settings = RenderSettings(model=model, size=size, zoom=zoom)
            self._cloths[model] = MovingCloth(path, frames, settings)
        dressed = self._cloths["lobes"].shown.dressed
        assert dressed is not None
        (piece,) = dressed.pieces.values()
        self._triangles = piece.triangles
        self.triangle_count = len(piece.triangles)

    def picture(self, frame: Frame, model: str, spp: int, denoise: str, seed: int) -> Floats:
        """8-bit sRGB, not rounded, [height, width, 3]."""
        picture = self._cloths[model].picture(frame, spp=spp, denoise=denoise, seed=seed)
        return 255 * linear_to_srgb(np.asarray(picture)).astype(np.float64)

    def places(self, frame: Frame, triangle: NDArray[np.int64], weights: Floats) -> tuple[Floats, Any]:
        """Columns and rows of pixels [2, n] where points of the cloth are, and which of them are seen."""
        shown = self._cloths["lobes"].shown
        self._cloths["lobes"].show(frame)
        params = mi.traverse(shown.scene)
        vertices = np.array(params["cloth.vertex_positions"], np.float64).reshape(-1, 3)
        points = np.einsum("nk,nki->ni", weights, vertices[self._triangles[triangle]])
        to_world = np.array(shown.scene.sensors()[0].world_transform().matrix, np.float64).reshape(4, 4)
        x, y, z = (np.c_[points, np.ones(len(points))] @ np.linalg.inv(to_world).T)[:, :3].T
        pixels = min(self._size) / 2 / np.tan(np.radians(shown.view.field_of_view) / 2)
        # Mitsuba's camera looks along +z, with x to the left.
        place = np.stack([self._size[0] / 2 - pixels * x / z, self._size[1] / 2 - pixels * y / z]) - 0.5
        origin = to_world[:3, 3]
        away = points - origin
        distance = np.linalg.norm(away, axis=1)
        ray = mi.Ray3f(mi.Point3f(origin), mi.Vector3f((away / distance[:, None]).T.astype(np.float32)))
        hit = np.array(shown.scene.ray_intersect_preliminary(ray).t)
        inside = ((place > 2) & (place < np.array(self._size)[:, None] - 3)).all(axis=0)
        return place, (np.abs(hit - distance) < 1e-3) & inside


def sampled(picture: Floats, place: Floats) -> Floats:
    """Colours [n, 3] of a picture between its pixels."""
    column, row = np.floor(place).astype(int)
    across, down = (place - np.floor(place))[..., None]
    upper, lower = (
        picture[row + below, column] * (1 - across) + picture[row + below, column + 1] * across
        for below in (0, 1)
    )
    return upper * (1 - down) + lower * down


def of_case(
    frames: list[Frame], case: tuple[str, float, int], size: tuple[int, int], settings: MovingClothFlicker
) -> dict[str, Any]:
    """Flicker and change of each of the pictures, against references."""
    fabric, zoom, first = case
    towel, three = Towel(frames, fabric, zoom, size), frames[first : first + 3]
    random = np.random.default_rng(SEED)
    triangle = random.integers(0, towel.triangle_count, settings.points)
    weights = random.dirichlet([1, 1, 1], settings.points)
    found = [towel.places(frame, triangle, weights) for frame in three]
    seen = np.all([visible for _, visible in found], axis=0)

    def changes(model: str, spp: int, denoise: str, by_frame: bool, seed: int) -> Floats:
        colours = [
            sampled(towel.picture(frame, model, spp, denoise, seed + number * by_frame), place[:, seen])
            for number, (frame, (place, _)) in enumerate(zip(three, found, strict=True))
        ]
        return np.diff(colours, axis=0)

    reference = changes("point", settings.reference, "off", True, 100)
    rows: dict[str, Any] = {"points": int(seen.sum()), "reference": _root_mean_square(reference)}
    for name, how in {"own": ("point", settings.reference, "off", True), **PICTURES}.items():
        change = changes(*how, 1)
        rows[name] = {
            "flicker": _root_mean_square(change - reference),
            "change": _root_mean_square(change) / rows["reference"],
        }
    return rows


def _root_mean_square(values: Floats) -> float:
    return float(np.sqrt(np.square(values).mean()))


@dataclass(frozen=True)
class MovingClothFlicker(Settings):
    side: int = setting(160, "Pixels of the longer side.", low=16)
    reference: int = setting(1024, "Samples of the reference.", low=1)
    cases: int = setting(len(CASES), "Of the first so many.", low=1, high=len(CASES))
    points: int = setting(20_000, "Of the cloth, that are followed.", low=1)


def measure(settings: MovingClothFlicker, run: Run) -> Found:
    """Flicker of each case, and those where `lobes` changes more than the reference."""
    with tempfile.TemporaryDirectory() as folder:
        towel.write(Path(folder) / "frames", 48)
        frames = find_frames(Path(folder) / "frames" / "*.obj")
        size = settings.side, settings.side * 3 // 4
        rows = run.each(
            {
                f"{case[0]}, zoom {case[1]:g}": partial(of_case, frames, case, size, settings)
                for case in CASES[: settings.cases]
            }
        )
    missed = [name for name, row in rows.items() if row[f"lobes {MANY}"]["change"] > BAR]
    return Found({"size": size, "reference": settings.reference, "rows": rows, "missed": missed})


def tables(figures: Figures) -> list[Table]:
    """Flicker, and change over the reference's, by picture."""
    columns = list(figures["rows"])
    names = [name for name in ("own", *PICTURES) if any(name in row for row in figures["rows"].values())]
    return [
        Table(
            title,
            columns,
            {
                name: [row[name][key] if name in row else None for row in figures["rows"].values()]
                for name in names
            },
        )
        for title, key in (
            ("Flicker, steps of 8-bit sRGB", "flicker"),
            ("Change over the reference's", "change"),
        )
    ]


STUDY = Study(
    "accuracy/moving_cloth",
    "flicker of cloth that moves: how colours of its points change from frame to frame",
    MovingClothFlicker(),
    measure,
    tables,
    stands_on=("point", "lobes", "picture"),
    small={"side": 16, "reference": 1, "cases": 1, "points": 200},
)
