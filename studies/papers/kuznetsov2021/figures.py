"""kuznetsov2021: Fig. 5, learned offsets, and Fig. 10, the ablation of channels and layers.

Do learned offsets follow the relief, which no training sees? Their means along four views, in millimetres,
deviations, and correlations with the height are of all texels. How much do channels and layers matter? MSE of
π f·cos, the mean of levels 0 and 1, over that of the published 7 channels and 4 layers, and weights of both
networks.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from drjit.llvm.ad import Float, UInt
from numpy.typing import NDArray

from loomlight.core.llvm import require_llvm
from loomlight.core.settings import same_setting, setting
from loomlight.evaluation.table import Table
from loomlight.models.texture.neumip import MIN_COSINE, NeumipModel
from loomlight.models.texture.pyramid import PyramidShape
from studies.harness.study import Found, Pixels, Run, Study, listed_counts, with_tables
from studies.instruments.sheet import Row, Tile, contact_sheet
from studies.papers.kuznetsov2021.designs import DESIGNS, OURS, Design
from studies.papers.kuznetsov2021.stage import (
    StageSettings,
    model_picture,
    plane_shot,
    predictor,
    stage_error,
    stage_settings,
    traced,
    trained_model,
)
from studies.papers.setting import TrainedSettings

OFFSET_MATERIAL, ABLATION_MATERIAL = "turtle shell", "twisted wool"
_HIDDEN = 25
# Views of Fig. 5: x and y.
_VIEWS = ((-0.7, 0.0), (0.7, 0.0), (0.0, -0.7), (0.0, 0.7))
_SIDE = 256  # pixels of a map


@dataclass(frozen=True)
class AblationSettings(StageSettings):
    """Of Fig. 10; trainings are of 64 texels a side."""

    resolution: int | None = same_setting(TrainedSettings, "resolution", default=64, otherwise="")
    channels: str = setting("3,5,7,9", "Of both textures; the published are 7.", metavar="N,…")
    layers: str = setting("2,3,4,5", "Of both networks; the published are 4.", metavar="N,…")


def offsets(settings: StageSettings, run: Run) -> Found:
    """Fig. 5: the offset texture of the turtle shell, and the offsets of four views in red and green."""
    require_llvm()
    source = settings.heightfield(OFFSET_MATERIAL)
    model = trained_model(source, settings, run.runs)
    maps = {view: offset_map(model, view) for view in _VIEWS}
    largest = max(float(np.abs(part).max()) for part in maps.values()) or 1.0
    pictures: dict[str, Pixels] = {"height": _grey(source.height), "texture": _texture_picture(model)}
    table = Table(
        "Offsets in millimetres", ["mean along the view", "deviation", "correlation with height"], digits=3
    )
    height = _resampled(source.height)
    for view, found in maps.items():
        name = f"view {view[0]:g}, {view[1]:g}"
        pictures[name] = _coloured(found / largest)
        along = found @ (np.array(view) / math.hypot(*view)) * source.repeat_mm[0]
        table.rows[name] = [
            float(along.mean()),
            float(along.std()),
            float(np.corrcoef(along.ravel(), height.ravel())[0, 1]),
        ]
    tiles = [Tile(picture) for picture in pictures.values()]
    note = table.note = (
        f"{OFFSET_MATERIAL}, {_trained_as(settings)}. Red and green are x and y of the offset, half of "
        f"each is none, all is {largest * source.repeat_mm[0]:.2f} mm. No height was shown to the training."
    )
    sheet = contact_sheet("kuznetsov2021 figure 5: learned offsets", list(pictures), [Row("", tiles)], note)
    return Found(with_tables(table), sheet, pictures)


def offset_map(model: NeumipModel, view: tuple[float, float]) -> NDArray[np.float64]:
    """The offset in repeats [rows, columns, 2] over one repeat, row 0 at the top, for x and y of a view."""
    v, u = (part.ravel() for part in np.meshgrid(*(2 * [(np.arange(_SIDE) + 0.5) / _SIDE]), indexing="ij"))
    x, y = (Float(np.full(u.size, part, np.float32)) for part in view)
    device = model.device_weights(Float)
    depth = device.depth(Float(u.astype(np.float32)), Float(v.astype(np.float32)), [x, y], UInt(0))
    cosine = max(math.sqrt(1 - view[0] ** 2 - view[1] ** 2), MIN_COSINE)
    found = np.asarray(depth.numpy(), np.float64).reshape(_SIDE, _SIDE)[::-1, :, None]
    return found / cosine * np.array(view) * np.array(model.weights.shape.unit)


def ablation(settings: AblationSettings, run: Run) -> Found:
    """Fig. 10: the MSE of other numbers of channels and layers over that of the published ones."""
    source = settings.heightfield(ABLATION_MATERIAL)
    resolution = settings.resolution
    assert resolution is not None
    texel = PyramidShape.of(source.repeat_mm, resolution, 1).texel_mm
    shots = [plane_shot(source, texel, level, settings.size) for level in (0, 1)]
    truths = [traced(source, shot, settings.spp) for shot in shots]
    published = DESIGNS[OURS]
    channels = listed_counts("--channels", settings.channels, 1, 64)
    layers = listed_counts("--layers", settings.layers, 2, 16)
    by_channels = {f"{n} channels": Design(n, published.hidden, offset=True) for n in channels}
    by_layers = {f"{n} layers": Design(7, (_HIDDEN,) * (n - 1), offset=True) for n in layers}
    errors: dict[Design, float] = {}
    designs = dict.fromkeys([*by_channels.values(), *by_layers.values(), published])
    for number, design in enumerate(designs):
        name = f"{design.latent}-channels-{len(design.hidden) + 1}-layers"
        predict = predictor(source, settings, run.runs, name, design)
        found = [
            stage_error(model_picture(predict, shot), truth).mse
            for shot, truth in zip(shots, truths, strict=True)
        ]
        errors[design] = float(np.mean(found))
        run.report(number + 1, len(designs))
    base = errors[published]
    table = Table("MSE over that of 7 channels and 4 layers", ["ratio", "MSE × 1000", "weights"])
    for name, design in {**by_channels, **by_layers}.items():
        table.rows[name] = [errors[design] / base, 1e3 * errors[design], design.weights]
    note = table.note = f"{ABLATION_MATERIAL}, {_trained_as(settings)}; mean of levels 0 and 1."
    rows = [Row("", [Tile(_bars(table))])]
    return Found(with_tables(table), contact_sheet("kuznetsov2021 figure 10: ablation", [], rows, note))


def _trained_as(settings: StageSettings) -> str:
    used = stage_settings(settings)
    return f"{used.resolution} texels a side, {used.steps} steps of {used.batch} queries"


def _bars(table: Table) -> Pixels:
    """A bar for each row, whose length is its first column, with name and number."""
    from PIL import Image, ImageDraw, ImageFont

    step, scale = 26, 160
    values = {name: cells[0] for name, cells in table.rows.items()}
    picture = Image.new("RGB", (620, step * len(values)), (255, 255, 255))
    draw, font = ImageDraw.Draw(picture), ImageFont.load_default(14)
    for number, (name, value) in enumerate(values.items()):
        length = float(value) if isinstance(value, float) else 0.0
        top = step * number
        draw.text((4, top + 4), name, fill=(20, 20, 20), font=font)
        draw.rectangle((110, top + 4, 110 + min(scale * length, 440), top + step - 4), fill=(96, 130, 180))
        draw.text((116, top + 4), f"{length:.2f}", fill=(255, 255, 255), font=font)
    return np.asarray(picture)


def _texture_picture(model: NeumipModel) -> Pixels:
    """Three channels of the offset texture that vary most, as RGB."""
    shape, texels = model.weights.shape, model.weights.offset_texels
    if texels is None:
        return np.full((_SIDE, _SIDE, 3), 128, np.uint8)
    chosen = np.argsort(-texels.std(axis=0))[:3]
    low, high = np.percentile(texels[:, chosen], [1, 99], axis=0)
    scaled = np.clip((texels[:, chosen] - low) / np.maximum(high - low, 1e-9), 0, 1)
    return np.rint(255 * _resampled(scaled.reshape(shape.rows, shape.columns, 3))).astype(np.uint8)


def _resampled(values: NDArray[np.floating]) -> NDArray[np.float64]:
    """The nearest of a map [rows, columns, …] at each pixel of a picture, row 0 at the top."""
    rows, columns = ((np.arange(_SIDE) * count) // _SIDE for count in values.shape[:2])
    return np.asarray(values[rows][:, columns][::-1], np.float64)


def _grey(values: NDArray[np.float32]) -> Pixels:
    return np.rint(255 * _resampled(values)[..., None].repeat(3, axis=2)).astype(np.uint8)


def _coloured(offset: NDArray[np.float64]) -> Pixels:
    """x in red and y in green, −1 to 1."""
    blue = np.zeros((*offset.shape[:2], 1))
    return np.rint(127.5 * (1 + np.concatenate([offset, blue], axis=2))).astype(np.uint8)


STUDIES = (
    Study(
        "papers/kuznetsov2021/fig5",
        "learned offsets of the turtle shell for four views",
        StageSettings(),
        offsets,
        stands_on=("neumip",),
        small={"steps": 3, "resolution": 8, "side": 16},
    ),
    Study(
        "papers/kuznetsov2021/fig10",
        "ablation: channels of the textures, layers of the networks",
        AblationSettings(),
        ablation,
        stands_on=("neumip",),
        small={
            "size": (16, 9),
            "spp": 4,
            "steps": 3,
            "resolution": 8,
            "side": 16,
            "channels": "3,7",
            "layers": "2",
        },
    ),
)
