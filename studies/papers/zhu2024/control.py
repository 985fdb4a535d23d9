"""zhu2024, figure 11: the choice of α in control variates, for satin and twill.

The integral of f·v over a pixel is that of α·f, the base, and of f·(v − α), the residual (eq. 6 and 7).
Whatever α is, both add up to the same picture; how much of it is left to the few samples of the residual is
α's doing. Here f and v are the point model's, so that the figure shows the choice of α and nothing else:
the base has many samples (summed-area tables give it at once), the residual the paper's two. α is 1 (no
visibility), the mean visibility of the repeat for the light, or that of the cluster that a point belongs to
(eq. 8), of 8 clusters of points whose visibility from all directions is alike.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray
from scipy.cluster.vq import kmeans2

from loomlight.aggregate.components import colours
from loomlight.core.arrays import Color3, Float, Mask, UInt, Vec2, Vec3
from loomlight.core.backend import array_types, clip, minimum, upload
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import llvm_float
from loomlight.evaluation.metrics import picture_error
from loomlight.evaluation.table import Table
from loomlight.fabric.fabric import Fabric
from loomlight.mitsuba import choose_variant, material_bsdf, shapes
from loomlight.mitsuba.measured_scenes import MeasuredShot, shot_scene
from loomlight.mitsuba.plugins import make_bsdf
from loomlight.mitsuba.scenes import BsdfFactory
from loomlight.models.interface import FootprintBsdf, Model
from loomlight.models.point import PointModel
from loomlight.scattering.point import DirectionSample, YarnScattering
from loomlight.yarn.geometry import YarnGeometry
from studies.harness.study import Found, Run, Study, on_display, with_tables
from studies.instruments.altered_models import AlteredModel
from studies.instruments.renders import one_picture
from studies.instruments.sheet import PictureTable, Tile, error_caption
from studies.papers.setting import PictureSettings
from studies.papers.zhu2024.scenes import table_fabric

CLUSTERS = 8
_RESIDUAL_SAMPLES = 2
# Texels of the repeat along each side, and bins of light directions: rings of equal height, sectors.
_TEXELS, _RINGS, _SECTORS = 96, 12, 24
_SEED = 1
_COLUMNS = ("base, many samples", "residual, 2 samples", "base + residual", "f·v, 2 samples", "reference")
_FABRICS = ("drape satin", "cylinder twill")
_SHOT = MeasuredShot((shapes.sphere,), (0.0, 0.0, 1.0), (-0.45, 0.6, 0.75), yarns=3.0)


@dataclass(frozen=True, eq=False)
class Alphas:
    """α by the cluster of a point and the direction of the light.

    Attributes:
        clusters: number of each texel of the repeat, rows of y [texels, texels].
        values: mean visibility [clusters, rings, sectors], 0 to 1.
    """

    clusters: NDArray[np.intp]
    values: NDArray[np.float64]

    @classmethod
    def constant(cls, value: float) -> Alphas:
        """One α for all points and lights."""
        return cls(np.zeros((1, 1), np.intp), np.full((1, 1, 1), value))


def visibility_clusters(fabric: Fabric, count: int) -> Alphas:
    """k-means of the texels of one repeat by what light reaches them from every bin of directions."""
    types = array_types(llvm_float())
    model = YarnScattering(YarnGeometry(fabric.layout()), fabric.appearance())
    width, height = fabric.repeat_mm
    line = (np.arange(_TEXELS) + 0.5) / _TEXELS
    y, x = (part.ravel() for part in np.meshgrid(line * height, line * width, indexing="ij"))
    place_x, place_y = (upload(types.Float, part) for part in (x, y))
    _, hole = model.surface.height(place_x, place_y, types.Bool(False))
    point = model.at(place_x, place_y, types.Bool(False), hole)
    seen = np.empty((_TEXELS**2, _RINGS, _SECTORS))
    for ring in range(_RINGS):
        for sector in range(_SECTORS):
            z = (ring + 0.5) / _RINGS
            azimuth = 2 * np.pi * (sector + 0.5) / _SECTORS
            radius = np.sqrt(1 - z * z)
            direction = radius * np.cos(azimuth), radius * np.sin(azimuth), z
            # No literals: every direction would be a kernel of its own.
            light = types.Vector3(*(dr.opaque(types.Float, float(part)) for part in direction))
            lit = dr.select(model.visibility(point, light), types.Float(1), 0)
            seen[:, ring, sector] = np.broadcast_to(lit.numpy(), (_TEXELS**2,))
    rows = seen.reshape(_TEXELS**2, -1)
    if count > 1:
        _, labels = kmeans2(rows, count, minit="++", seed=_SEED)
    else:
        labels = np.zeros(len(rows), np.intp)
    means = np.stack(
        [rows[labels == k].mean(axis=0) if (labels == k).any() else rows.mean(axis=0) for k in range(count)]
    )
    return Alphas(labels.reshape(_TEXELS, _TEXELS).astype(np.intp), means.reshape(count, _RINGS, _SECTORS))


class _Tables:
    """α on the device."""

    def __init__(self, alphas: Alphas, size: tuple[float, float]) -> None:
        types = array_types(llvm_float())
        self._shape = alphas.clusters.shape
        self._bins = alphas.values.shape[1:]
        self._clusters = upload(types.UInt32, alphas.clusters)
        self._values = upload(types.Float, alphas.values)
        self._size = size
        dr.eval(self._clusters, self._values)

    def at(self, x: Float, y: Float, light: Vec3) -> Float:
        """α of points x, y (millimetres) for lights: Float."""
        types = array_types(x)
        rows, columns = self._shape
        row, column = (
            self._index(part * (1 / length), count)
            for part, length, count in ((y, self._size[1], rows), (x, self._size[0], columns))
        )
        cluster = dr.gather(types.UInt32, self._clusters, row * columns + column)
        rings, sectors = self._bins
        ring = minimum(types.UInt32(clip(abs(light.z), 0, 1) * rings), rings - 1)
        sector = self._index(dr.atan2(light.y, light.x) * (1 / (2 * np.pi)), sectors)
        return dr.gather(types.Float, self._values, (cluster * rings + ring) * sectors + sector)

    @staticmethod
    def _index(turns: Float, count: int) -> UInt:
        types = array_types(turns)
        return minimum(types.UInt32((turns - dr.floor(turns)) * count), count - 1)


class _Part(FootprintBsdf):
    """f times α, or times v − α, at the yarn point of the footprint's centre."""

    def __init__(
        self, model: YarnScattering, alphas: _Tables, residual: bool, view: Vec3, footprint: Footprint
    ) -> None:
        super().__init__(view, footprint)
        self._model, self._alphas, self._residual = model, alphas, residual
        self._point = model.locate(footprint.centre.x, footprint.centre.y, view)

    @property
    def hole(self) -> Float:
        return dr.select(self._point.hole, array_types(self.view.x).Float(1), 0)

    @property
    def diffuse_reflectance(self) -> Color3:
        return dr.select(self._point.hole, 0, self._point.albedos.diffuse_reflect)

    def value(self, light: Vec3, active: Mask = True) -> Color3:
        types = array_types(light.x)
        point, model = self._point, self._model
        unshadowed = colours(model.appearance, point, light, self.view, types.Bool(True))
        share = self._alphas.at(point.x, point.y, light)
        if self._residual:
            share = dr.select(model.visibility(point, light, active), types.Float(1), 0) - share
        return unshadowed * share

    def pdf(self, light: Vec3) -> Float:
        return self._model.pdf(self._point, light, self.view)

    def sample(self, choice: Float, u: Vec2) -> DirectionSample:
        drawn = self._model.sample(self._point, self.view, choice, u, active=False)
        weight = dr.select(drawn.pdf > 0, self.value(drawn.light) / drawn.pdf, 0)
        return DirectionSample(light=drawn.light, pdf=drawn.pdf, weight=weight, is_null=drawn.is_null)


def _bsdf(fabric: Fabric, alphas: Alphas, residual: bool) -> BsdfFactory:
    tables = _Tables(alphas, fabric.repeat_mm)

    def at(of: Model, view: Vec3, footprint: Footprint, tint: Any, active: Mask) -> FootprintBsdf:
        del tint, active
        assert isinstance(of, PointModel)
        return _Part(of.point_model, tables, residual, view, footprint)

    return lambda millimetres: make_bsdf(AlteredModel(PointModel(fabric), at), millimetres)


def choice_of_alpha(settings: PictureSettings, run: Run) -> Found:
    """Figure 11: base, residual and their sum for three choices of α, two fabrics."""
    choose_variant()
    shown = PictureTable("zhu2024 figure 11: the choice of alpha", _COLUMNS)
    table = Table("MSE of two samples", ["base + residual", "f·v alone", "times less"])
    for number, name in enumerate(_FABRICS):
        fabric = table_fabric(name)
        point = shot_scene(_SHOT, [(fabric, material_bsdf(fabric, "point"))], settings.size)
        truth = one_picture(point, settings.spp, 1)
        plain = one_picture(point, _RESIDUAL_SAMPLES, 3)
        error = picture_error(plain, truth, point.counted)
        choices = {
            "alpha = 1": Alphas.constant(1.0),
            "mean visibility": visibility_clusters(fabric, 1),
            f"{CLUSTERS} clusters": visibility_clusters(fabric, CLUSTERS),
        }
        for label, alphas in choices.items():
            base, residual = (
                one_picture(
                    shot_scene(_SHOT, [(fabric, _bsdf(fabric, alphas, is_residual))], settings.size),
                    samples,
                    seed,
                )
                for is_residual, samples, seed in ((False, settings.spp, 2), (True, _RESIDUAL_SAMPLES, 3))
            )
            full = base + residual
            found = picture_error(full, truth, point.counted)
            row = f"{name}, {label}"
            table.rows[row] = [found.mse, error.mse, error.mse / found.mse]
            tiles = [
                Tile(on_display(base)),
                Tile(on_display(np.abs(residual)), "its absolute value"),
                Tile(on_display(full), error_caption(found)),
                Tile(on_display(plain), error_caption(error)),
                Tile(on_display(truth), f"{settings.spp} spp"),
            ]
            shown.add(row, tiles)
        run.report(number + 1, len(_FABRICS))
    note = (
        f"{_SHOT.yarns:g} yarns a pixel, one directional light, direct light. The base has {settings.spp} "
        "samples. Residuals may be negative: what a base above the picture has too much."
    )
    return shown.found(with_tables(table), note)


STUDY = Study(
    "papers/zhu2024/fig11",
    "the choice of α: base, residual and their sum",
    PictureSettings(),
    choice_of_alpha,
    stands_on=("point", "picture"),
    small={"size": (24, 16), "spp": 4},
)
