"""Figure 9: live edits of one fabric, and the time of each.

Roughness, height, inclination and twist need one run of the encoder; albedos and an albedo map none; another
pattern is another fabric. The cache of latents is empty, so that every run is a run. Times are processor
seconds.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from loomlight.evaluation.table import Table
from loomlight.fabric.fabric import Fabric
from loomlight.mitsuba.measured_scenes import MeasuredScene
from studies.harness.study import Found, Made, Pixels, Run, Study, on_display
from studies.instruments.renders import one_picture, timed_pictures
from studies.instruments.scene_edits import SceneEdits, bitmap_texture
from studies.instruments.sheet import Tile, contact_sheet, in_two_rows
from studies.instruments.timing import one_thread, spent
from studies.papers.chen2024.cache import without_cached_latents
from studies.papers.chen2024.fabrics import Look, paper_fabric
from studies.papers.chen2024.shots import DRAPE
from studies.papers.chen2024.stage import NetworkSettings, neural_bsdf

_LOOK = Look(("#2f6f7f", "#b0a888"), (0.3, 0.3), (0.6, 0.6), specular=0.7)
_PATTERN, _OTHER_PATTERN = "twill 5×5", "satin 8×8"
_FAMILIES = ("warp", "weft")
_MAP_SIDE = 256


@dataclass(frozen=True)
class _Edit:
    """A change of scene parameters.

    Attributes:
        label: what stands below the picture.
        values: by the end of the parameter's name.
    """

    label: str
    values: dict[str, object]


EDITS = (
    _Edit("roughness 0.3 → 0.9", {f"{family}.roughness": 0.9 for family in _FAMILIES}),
    _Edit("height 0.6 → 0.25", {f"{family}.height_scale": 0.25 for family in _FAMILIES}),
    _Edit("inclination 24° → 38°", {f"{family}.inclination": float(np.radians(38)) for family in _FAMILIES}),
    _Edit("twist −30° → 40°", {f"{family}.twist": float(np.radians(40)) for family in _FAMILIES}),
    _Edit("albedo of the warp", {"warp.diffuse_reflect": [0.45, 0.05, 0.08]}),
)


@dataclass(frozen=True, eq=False)
class _Shown:
    """A picture after an edit.

    Attributes:
        edit, first, following: processor seconds of the edit, of the first picture after it, of later ones.
    """

    label: str
    picture: Pixels
    edit: float
    first: float
    following: float


def edited(settings: NetworkSettings, run: Run) -> Found:
    """Figure 9: the strip of edits."""
    shown: list[_Shown] = []
    with without_cached_latents():
        for edited in _strip(settings):
            shown.append(edited)
            run.report(len(shown), len(EDITS) + 3)
    table = Table("Processor seconds of an edit", ["edit", "first picture", "following picture"])
    for edited in shown:
        table.rows[edited.label] = [edited.edit, edited.first, edited.following]
    tiles = [
        Tile(edited.picture, f"{edited.label}: {1e3 * edited.edit:.0f} ms, picture {edited.following:.2f} s")
        for edited in shown
    ]
    note = (
        "Each from the first by one edit. Processor time: milliseconds of the edit itself, with the encoder "
        "where it is needed; seconds of a picture after the first one. A new fabric or map is a new BSDF."
    )
    sheet = contact_sheet("chen2024 figure 9: editing", [], in_two_rows(tiles), note)
    return Found(settings.figures(table), sheet, {edited.label: edited.picture for edited in shown})


def _strip(settings: NetworkSettings) -> Iterator[_Shown]:
    fabric, other = paper_fabric(_PATTERN, _LOOK), paper_fabric(_OTHER_PATTERN, _LOOK)
    scene, seconds = _cpu_timed(lambda: settings.stage(DRAPE, fabric).neural_scene())
    yield _pictured("the fabric, encoded", scene, seconds)
    edits = SceneEdits(scene.scene)
    for edit in EDITS:
        before, seconds = _cpu_timed(partial(edits.apply, edit.values))
        yield _pictured(edit.label, scene, seconds)
        edits.apply(before)
    scene, seconds = _cpu_timed(lambda: settings.stage(DRAPE, other).neural_scene())
    yield _pictured(f"pattern {_OTHER_PATTERN}", scene, seconds)
    scene, seconds = _cpu_timed(lambda: _mapped_scene(settings, fabric))
    yield _pictured("albedo map", scene, seconds)


def _mapped_scene(settings: NetworkSettings, fabric: Fabric) -> MeasuredScene:
    """The fabric with the colours of a map."""
    albedo = bitmap_texture(albedo_map(_MAP_SIDE))
    bsdf = neural_bsdf(fabric, settings.weights, albedo=albedo)
    return settings.stage(DRAPE, fabric).neural_scene(bsdf)


def _pictured(label: str, scene: MeasuredScene, edit: float) -> _Shown:
    _, first = _cpu_timed(lambda: one_picture(scene, 1))
    (following,) = timed_pictures([(scene, 1)])
    return _Shown(label, on_display(following.linear), edit, first, following.cpu_seconds)


def _cpu_timed(run: Callable[[], Made]) -> tuple[Made, float]:
    """The result of `run`, and its processor seconds on one thread."""
    with one_thread():
        made, taken = spent(run)
    return made, taken.cpu_seconds


def albedo_map(side: int) -> NDArray[np.float32]:
    """Linear albedos [side, side, 3]: rings and bars with hard edges, which need filtering."""
    y, x = (np.indices((side, side)) + 0.5) / side * 2 - 1
    radius, angle = np.hypot(x, y), np.arctan2(y, x)
    petals = np.abs(np.cos(4 * angle)) * 0.35 + 0.45
    pattern = np.full((side, side, 3), (0.85, 0.82, 0.7))
    pattern[(radius * 12 % 1 < 0.5) & (radius < 1)] = (0.2, 0.45, 0.5)
    pattern[radius < petals] = (0.75, 0.2, 0.12)
    pattern[radius < 0.5 * petals] = (0.95, 0.7, 0.2)
    return pattern.astype(np.float32)


STUDY = Study(
    "papers/chen2024/fig9",
    "a strip of edits and what each costs",
    NetworkSettings(),
    edited,
    stands_on=("neural", "picture"),
    small={"size": (24, 16)},
)
