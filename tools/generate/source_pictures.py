"""Pictures of sources, and of what `neumip` or `latent` learned of them beside.

    python -m tools.generate.source_pictures jersey.jpg examples/jersey/jersey.toml jersey.loom --width-mm 8
    python -m tools.generate.source_pictures brass.jpg brass.toml brass.loom

Sources of `neumip` lie on a plane at 45° in daylight, a sun from the left and a sky brighter above, and
are path traced as trainings ask them. Those of `latent` cover a sphere in the studio's light; a library of
MERL's format is drawn at directions that the `.loom` beside it draws.
"""

from __future__ import annotations

import math
from argparse import ArgumentParser, Namespace, RawDescriptionHelpFormatter
from pathlib import Path
from typing import Any, cast

import drjit as dr
import numpy as np
from drjit.llvm.ad import Array2f, Array3f
from numpy.typing import NDArray
from PIL import Image

from loomlight.core.arrays import Color3, Float, Mask, Vec2, Vec3
from loomlight.core.backend import array_types, maximum
from loomlight.core.colour import linear_to_srgb
from loomlight.core.footprint import Box, Footprint, box_footprint
from loomlight.models.interface import FootprintBsdf, Model
from loomlight.models.registry import btf_of, model_from_loom
from loomlight.models.texture.pyramid import SIZE_OF_SIGMA
from loomlight.scattering.point import DirectionSample
from loomlight.sources.kinds import Source, kind_of_file
from loomlight.sources.load import load_source
from loomlight.sources.material import Material
from loomlight.sources.merl import MerlLibrary
from studies.instruments.altered_models import AlteredModel, UniformDirections
from studies.papers.kuznetsov2021.stage import Shot, plane_shot
from studies.papers.zeltner2024.stage import (
    StageSettings,
    model_factory,
    reference_factory,
    stage_picture,
    stage_scene,
)

# Share of the sun's light, its width, and where it stands.
_SUN, _SUN_WIDTH = 0.6, 0.15
_TOWARDS_SUN = np.array([-0.75, 0.35, 0.75])
_SEED, _QUALITY = 7, 86  # of JPEG

_Floats = NDArray[np.float32]


def daylight(rng: np.random.Generator, count: int) -> _Floats:
    """Directions [count, 3] of equal shares of the light: a wide sun, and a sky that is brighter above."""
    u, azimuth = rng.random(count), 2 * math.pi * rng.random(count)
    sky = np.stack([np.sqrt(u) * np.cos(azimuth), np.sqrt(u) * np.sin(azimuth), np.sqrt(1 - u)], 1)
    sun = _TOWARDS_SUN / np.linalg.norm(_TOWARDS_SUN) + _SUN_WIDTH * rng.standard_normal((count, 3))
    lights = np.where((rng.random(count) < _SUN)[:, None], sun, sky)
    lights[:, 2] = np.maximum(lights[:, 2], 0.02)
    return np.asarray(lights / np.linalg.norm(lights, axis=1, keepdims=True), np.float32)


def source_picture(source: Source, shot: Shot, samples: int) -> _Floats:
    """π f·cos [pixels, 3] under daylight, of so many paths a pixel."""
    btf, total = btf_of(source, "neumip"), np.zeros((len(shot.sides), 3), np.float32)
    for number in range(samples):
        rng = np.random.default_rng([_SEED, number])
        spread = rng.standard_normal((len(shot.sides), 2)) * (shot.sides / SIZE_OF_SIGMA)[:, None]
        points = (shot.positions + spread).astype(np.float32)
        total += btf.values(points, daylight(rng, len(points)), shot.views, (_SEED, number))
    return np.asarray(math.pi / samples * total, np.float32)


def model_picture(model: Model, shot: Shot, samples: int) -> _Floats:
    """The same of a model, by so many lights a pixel."""
    positions, views = (np.ascontiguousarray(part.T) for part in (shot.positions, shot.views))
    at = model.at(Array3f(views), box_footprint(Box(Array2f(positions), Array2f(shot.sides, shot.sides))))
    total = np.zeros((len(shot.sides), 3), np.float32)
    for number in range(samples):
        lights = daylight(np.random.default_rng([_SEED, number]), len(shot.sides))
        total += at.value(Array3f(np.ascontiguousarray(lights.T))).numpy().T
    return np.asarray(math.pi / samples * total, np.float32)


class _Measured(UniformDirections):
    """A library's own values, at directions that a model of it draws."""

    def __init__(self, inner: FootprintBsdf, library: MerlLibrary) -> None:
        super().__init__(inner)
        self._library = library

    def value(self, light: Vec3, active: Mask = True) -> Color3:
        types, centre = array_types(self.view.x), self.footprint.centre
        width, height = self._library.repeat_mm
        places, lights, views = (
            np.stack(np.broadcast_arrays(*(np.array(part) for part in vector))).T
            for vector in ((centre.x / width, centre.y / height), light, self.view)
        )
        found = self._library.evaluate(self._library.numbers_at(places), lights, views)
        return dr.select(active, types.Color3(np.ascontiguousarray(found.T)), 0)

    def pdf(self, light: Vec3) -> Float:
        return self._inner.pdf(light)

    def sample(self, choice: Float, u: Vec2) -> DirectionSample:
        drawn = self._inner.sample(choice, u)
        weight = dr.select(drawn.pdf > 0, self.value(drawn.light) / maximum(drawn.pdf, 1e-30), 0)
        return DirectionSample(drawn.light, drawn.pdf, weight, drawn.is_null)


def _measured(model: Model, library: MerlLibrary) -> AlteredModel:
    def at(of: Model, view: Vec3, footprint: Footprint, tint: Any, active: Mask) -> FootprintBsdf:
        return _Measured(of.at(view, footprint, tint, active), library)

    return AlteredModel(model, at)


def main() -> None:
    parser = ArgumentParser(description=__doc__, formatter_class=RawDescriptionHelpFormatter)
    parser.add_argument("output", type=Path)
    parser.add_argument("files", nargs="+", type=Path, help="a source, and a .loom of it")
    parser.add_argument("--width-mm", type=float, default=8.0, help="what a plane shows")
    parser.add_argument("--samples", type=int, default=64)
    parser.add_argument("--side", type=int, default=320, help="pixels of a picture")
    parser.add_argument("--exposure", type=float, default=1.0, help="a factor")
    parser.add_argument("--below", action="store_true", help="models are below their sources")
    options = parser.parse_args()
    found = [_picture(file, options) for file in options.files]
    if options.below:
        found = [np.concatenate(pair) for pair in zip(found[::2], found[1::2], strict=True)]
    pixels = np.rint(255 * np.concatenate(found, axis=1).clip(0, 1)).astype(np.uint8)
    Image.fromarray(pixels).save(options.output, quality=_QUALITY)


def _picture(file: Path, options: Namespace) -> NDArray[np.float64]:
    """sRGB [side, side, 3] of a file."""
    source, side = load_source(file, kind_of_file(file, "fabric")), options.side
    model = model_from_loom(file) if file.suffix == ".loom" else None
    if not isinstance(source, Material | MerlLibrary):
        shot = plane_shot(cast(Any, source), options.width_mm / side, 0, (side, side))
        flat = (
            source_picture(source, shot, options.samples)
            if model is None
            else model_picture(model, shot, options.samples)
        )
        return linear_to_srgb(options.exposure * flat.reshape(side, side, 3))
    if model is not None:
        factory = model_factory(model)
    elif isinstance(source, Material):
        factory = reference_factory(source)
    else:
        learned = next(model_from_loom(other) for other in options.files if other.suffix == ".loom")
        factory = model_factory(_measured(learned, source))
    settings = StageSettings(size=(side, side), spp=options.samples)
    picture = stage_picture(stage_scene(factory, "whole", settings), settings)
    return linear_to_srgb(options.exposure * picture)


if __name__ == "__main__":
    main()
