"""zeltner2024: the learned importance sampler beside cosine-distributed directions and the reference's own.

Direct light of the studio that directions alone find, and with multiple importance sampling of the light, at
equal samples. The error of each picture is the mean squared error against a picture of the *same* BSDF with
many samples, so that only the noise of its sampler is in it. Errors times processor seconds are compared too:
they stay as they are when samples are traded for time.
"""

from __future__ import annotations

import math
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, Mask, Vec2, Vec3
from loomlight.core.backend import array_types, maximum
from loomlight.core.footprint import Footprint
from loomlight.evaluation.table import Table
from loomlight.mitsuba import choose_variant
from loomlight.mitsuba.measured_scenes import MeasuredScene
from loomlight.models.interface import FootprintBsdf, Model
from loomlight.scattering.point import DirectionSample, to_face_frame
from studies.harness.study import Found, Run, Study, on_display, with_tables
from studies.instruments.altered_models import AlteredModel, UniformDirections
from studies.instruments.composed_scenes import directions_alone
from studies.instruments.renders import halved_truth, one_picture
from studies.instruments.sheet import PictureTable, Tile
from studies.instruments.timing import Spent, spent
from studies.papers.zeltner2024.stage import (
    StageSettings,
    model_factory,
    reference_factory,
    stage_scene,
    trained,
)

SAMPLES = 16
_COLUMNS = ("cosine", "learned sampler", "reference's own")
_WAYS = ("directions alone", "with light samples (MIS)")
# Direct light: camera to sphere to light.
_DEPTH = 2


class _CosineDirections(UniformDirections):
    """Another BSDF's values, at directions distributed by the cosine."""

    def pdf(self, light: Vec3) -> Float:
        facing = to_face_frame(light, self.view.z < 0)
        return maximum(facing.z, 0) * (1 / math.pi)

    def sample(self, choice: Float, u: Vec2) -> DirectionSample:
        types = array_types(self.view.x)
        radius = dr.sqrt(u.x)
        sin, cos = dr.sincos(2 * math.pi * u.y)
        facing = types.Vector3(radius * cos, radius * sin, dr.sqrt(maximum(1 - u.x, 0)))
        light = to_face_frame(facing, self.view.z < 0)
        pdf = self.pdf(light)
        weight = dr.select(pdf > 0, self.value(light) / maximum(pdf, 1e-30), 0)
        return DirectionSample(light=light, pdf=pdf, weight=weight, is_null=types.Bool(choice < 0))


def cosine_sampled(model: Model) -> AlteredModel:
    """The model without its sampler: directions are distributed by the cosine."""

    def at(of: Model, view: Vec3, footprint: Footprint, tint: Any, active: Mask) -> FootprintBsdf:
        return _CosineDirections(of.at(view, footprint, tint, active))

    return AlteredModel(model, at)


def sampler_variance(settings: StageSettings, run: Run) -> Found:
    """Noise at equal samples and at equal time, of three samplers."""
    choose_variant()
    noise = {way: Table(f"MSE of {SAMPLES} samples, {way}", [*_COLUMNS, "gain"], digits=3) for way in _WAYS}
    cost = Table(
        "MSE times processor seconds, directions alone", ["cosine", "learned sampler", "gain"], digits=3
    )
    shown = PictureTable("zeltner2024: the importance sampler", _COLUMNS)
    sources = settings.sources()
    for number, source in enumerate(sources):
        name = source.name
        model = trained(source, settings, run.runs)
        factories = {
            _COLUMNS[0]: model_factory(cosine_sampled(model)),
            _COLUMNS[1]: model_factory(model),
            _COLUMNS[2]: reference_factory(source),
        }
        scenes = {
            column: stage_scene(factory, "whole", settings, _DEPTH) for column, factory in factories.items()
        }
        truths = {column: halved_truth(scenes[column], settings.spp, 11) for column in _COLUMNS[1:]}
        truths[_COLUMNS[0]] = truths[_COLUMNS[1]]
        seconds: dict[str, float] = {}
        for way in _WAYS:
            errors: dict[str, float] = {}
            tiles = []
            for column, scene in scenes.items():
                picture, times = _noisy(scene, way)
                errors[column] = truths[column].squared_error(picture, scene.counted)
                tiles.append(Tile(on_display(picture), f"MSE {errors[column]:.2e}"))
                seconds.setdefault(column, times.cpu_seconds)
            gain = errors[_COLUMNS[0]] / errors[_COLUMNS[1]]
            noise[way].rows[name] = [*errors.values(), gain]
            if way == _WAYS[0]:
                products = [errors[column] * seconds[column] for column in _COLUMNS[:2]]
                cost.rows[name] = [*products, products[0] / products[1]]
            shown.add(f"{name}, {way}", tiles)
        run.report(number + 1, len(sources))
    note = (
        f"{SAMPLES} samples a pixel, direct light of an environment; truths: {settings.spp} samples of "
        f"the same BSDF, in two halves; 2×32, quality {settings.quality}."
    )
    return shown.found(with_tables(*noise.values(), cost), note)


def _noisy(scene: MeasuredScene, way: str) -> tuple[NDArray[np.float32], Spent]:
    """A picture of a few samples, and its time; one before it compiled."""
    integrator = scene.integrator if way == _WAYS[1] else directions_alone()
    noisy = MeasuredScene(scene.scene, integrator, scene.counted, scene.yarns_per_pixel)
    # Networks are many times slower in symbolic calls, which Mitsuba's own integrators would make.
    with (
        dr.scoped_set_flag(dr.JitFlag.SymbolicCalls, False),
        dr.scoped_set_flag(dr.JitFlag.SymbolicLoops, False),
    ):
        one_picture(noisy, SAMPLES, 3)
        return spent(lambda: one_picture(noisy, SAMPLES, 4))


STUDY = Study(
    "papers/zeltner2024/sampler",
    "noise of the importance sampler, at equal samples and time",
    StageSettings(),
    sampler_variance,
    stands_on=("latent", "picture"),
    small={"size": (24, 16), "spp": 4, "steps": 6, "resolution": 16, "materials": "rough-plastic"},
)
