"""Pictures of a material in one call: one that is refined as it comes, its close-up, and those of a turn."""

from __future__ import annotations

import gc
import math
import os
import re
import time
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Unpack, cast

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray
from PIL import Image

from loomlight.core.backend import upload
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.images import Picture
from loomlight.core.parallel_map import core_count
from loomlight.core.picture_settings import RenderKeywords, RenderSettings, Worn, layer_names
from loomlight.fabric.fabric import Fabric
from loomlight.mitsuba.camera import MAX_ZOOM, Corner, View, framing
from loomlight.mitsuba.plugins import material_bsdf
from loomlight.mitsuba.rendering import PartialPicture, Progress, render_layers
from loomlight.mitsuba.rendering import render as render_scene
from loomlight.mitsuba.scenes import (
    CLOTH_NAME,
    SCENES,
    UNCOVERED_NAME,
    ClothScene,
    SceneOptions,
    build_scene,
    default_size,
)
from loomlight.mitsuba.variants import choose_variant
from loomlight.models.material_spec import Material, MaterialSpec, resolve
from loomlight.models.registry import REFERENCE_MODEL
from loomlight.sources.kinds import Source

_PICTURE_OPTIONS = ("spp", "seed", "exposure", "white_balance", "denoise")
# The first picture: at so many times fewer pixels each way, so many samples of each.
_COARSE_SCALE, _COARSE_SAMPLES = 2, 4
# Yarns a pixel from which on no weave can be seen, and pixels a yarn that show it.
_HIDDEN, _PIXELS_PER_YARN = 2.0, 2.0
# Shorter sides below that are no more coarse than needed.
_MIN_COARSE = 128


def scene_options(settings: RenderSettings) -> SceneOptions:
    """The keyword arguments of `build_scene`."""
    return cast(SceneOptions, {name: getattr(settings, name) for name in SceneOptions.__annotations__})


def picture_options(settings: RenderSettings) -> dict[str, Any]:
    """The keyword arguments of `rendering.render`."""
    return {name: getattr(settings, name) for name in _PICTURE_OPTIONS}


def render(
    material: Material,
    scene: str | os.PathLike[str] | None = None,
    settings: RenderSettings | None = None,
    *,
    progress: Progress | None = None,
    partial: PartialPicture | None = None,
    **changes: Unpack[RenderKeywords],
) -> Picture:
    """Linear RGB [height, width, 3] of a material on a piece of cloth, a mesh, or marked shapes of a scene.

    Its `layers` are those of the setting `aov`: arrays [height, width, 3] by their names, of depth and
    roughness [height, width, 1].

    Args:
        material: a fabric or another source; a model; or the path of a fabric file, a draft or a `.loom`; or
            a weave's name, such as "twill 3/1".
        scene: flat, sphere, cylinder, drape (the default), or the path of a Mitsuba scene, FILE.xml.
        settings: by default those of `RenderSettings`.
        progress: called with (milliseconds passed, milliseconds in all, as estimated), at first at once.
        partial: called with whole pictures, coarse at first, that later ones refine.
        changes: settings by name, such as `spp=64, size=(960, 540)`; see `RenderSettings`.

    Raises:
        InputError: an unknown setting, or a material, file or value that cannot be used.
        MissingDependencyError: no usable LLVM library, or no usable CUDA device.
    """
    chosen = (settings or RenderSettings()).changed(**changes)
    if scene is not None:
        chosen = chosen.changed(scene=scene)
    if str(chosen.scene) not in SCENES and chosen.inset:
        raise InputError(
            f"inset = {chosen.inset} does not go with the scene {chosen.scene}, whose camera is its own."
        )
    job = RenderJob(shown_material(material, chosen), chosen)
    estimate = TimeEstimate(job.seconds(partial is not None), progress)
    with estimate.step("start"):
        choose_variant(chosen.variant)
    if partial is not None and job.coarse_size is not None:
        with estimate.step("coarse"):
            partial(job.coarse_picture(job.coarse_size))
    with estimate.step("bake"):
        shown, close_up = job.scene_and_inset()
    return with_layers(job.refined_picture(shown, close_up, estimate, partial), shown, chosen)


def with_layers(picture: NDArray[np.float32], shown: ClothScene, settings: RenderSettings) -> Picture:
    """A picture with the layers of its setting `aov`, of what the scene's camera sees now."""
    found = picture.view(Picture)
    if settings.aov is not None:
        names = layer_names(settings.aov)
        found.layers = render_layers(shown.scene, names, seed=settings.seed, integrator=shown.integrator)
    return found


def shown_material(material: Material, settings: RenderSettings) -> MaterialSpec:
    """The material that a picture shows, in the model and the colours of its settings.

    Raises:
        InputError: an unknown model, a material that cannot be read, or colours that it does not take.
    """
    spec = resolve(material, settings.model)
    spec.require_trained()
    if spec.replaces:
        warnings.warn(
            f"{material} holds the model {spec.replaces}; "
            f"{spec.model_name} is baked from its fabric instead.",
            LoomlightWarning,
            stacklevel=3,
        )
    spec = spec.recoloured(settings.colors) if settings.colors else spec
    return spec.mapped(settings.maps) if settings.maps else spec


def further_cloths(settings: RenderSettings) -> dict[str, Any]:
    """Keyword arguments of `build_scene` for what `settings.cloths` names, each with a model of its own."""
    worn = {
        name: cloth if isinstance(cloth, Worn) else Worn(cloth) for name, cloth in settings.cloths.items()
    }
    return {
        "others": {name: material_bsdf(each.fabric) for name, each in worn.items()},
        "turns": {name: each.turn for name, each in worn.items()},
    }


def warn_of_hidden_weave(source: Source, pixel_mm: float, settings: RenderSettings) -> None:
    """Warns of a fabric whose yarns are too thin for pixels, and names a zoom that shows them.

    Args:
        pixel_mm: side of what a pixel shows, millimetres.
    """
    if not isinstance(source, Fabric):
        return
    layout = source.layout()
    pitch, name = min(
        (float(layout.warp.spacing.mean()), "ends"), (float(layout.weft.spacing.mean()), "picks")
    )
    yarns = pixel_mm / (pitch * settings.placement.scale)
    zoom = settings.zoom * yarns * _PIXELS_PER_YARN
    if yarns < _HIDDEN or zoom > MAX_ZOOM:
        return
    shown_yarns = f"{yarns:.2g}" if yarns < 10 else f"{yarns:.0f}"
    # Of two digits, rounded up.
    step = 10.0 ** max(math.floor(math.log10(zoom)) - 1, 0)
    warnings.warn(
        f"{source.name}: {10 / pitch:.3g} {name}/cm are {shown_yarns} yarns a pixel here, too many to be "
        f"seen: --zoom {math.ceil(zoom / step) * step:g} shows them.",
        LoomlightWarning,
        stacklevel=2,
    )


@dataclass
class RenderJob:
    """A picture to render.

    Attributes:
        material: what is shown.
        settings: how it is shown.
    """

    material: MaterialSpec
    settings: RenderSettings

    def __post_init__(self) -> None:
        setting = self.settings
        self._own_scene = str(setting.scene) not in SCENES
        self._size = setting.size or default_size(setting.mesh, setting.camera)
        frames = setting.zoom == 1 and setting.target is None and setting.distance is None
        whole_drape = str(setting.scene) == "drape" and setting.mesh is None and frames
        readable = min(self._size) >= MIN_PICTURE
        is_wanted = whole_drape and readable and isinstance(self.material.source, Fabric)
        self._inset = is_wanted if setting.inset is None else setting.inset

    @property
    def coarse_size(self) -> tuple[int, int] | None:
        """Width and height of the first picture, by yarn points, pixels.

        None where there are none, where the scene takes time to build, or where the picture is small itself.
        """
        slow = self._own_scene or self.settings.mesh is not None
        is_small = min(self._size) < _COARSE_SCALE * _MIN_COARSE
        if slow or is_small or not isinstance(self.material.source, Fabric):
            return None
        width, height = self._size
        return -(-width // _COARSE_SCALE), -(-height // _COARSE_SCALE)

    def seconds(self, partial: bool) -> dict[str, float]:
        """Predicted seconds of every step."""
        model, spp, is_baked = self.material.model_name, self.settings.spp, self.material.held is not None
        cost = MODEL_SECONDS.get(model, ModelSeconds())
        pixels = self._size[0] * self._size[1]
        steps = {"start": START_SECONDS, "bake": SCENE_SECONDS + (0.0 if is_baked else cost.bake)}
        if partial and self.coarse_size is not None:
            samples = _COARSE_SAMPLES * self.coarse_size[0] * self.coarse_size[1]
            steps["coarse"] = (
                SCENE_SECONDS
                + MODEL_SECONDS[REFERENCE_MODEL].compile
                + sample_seconds(REFERENCE_MODEL, samples)
            )
        steps["whole"] = cost.compile + sample_seconds(model, max(spp, 1) * pixels)
        return steps

    def coarse_picture(self, size: tuple[int, int]) -> NDArray[np.float32]:
        """The picture by single yarn points, of fewer pixels: it needs no baking and no large kernel."""
        shown, close_up = self._built(self.material.by(REFERENCE_MODEL), size)
        film = self._render(shown, spp=_COARSE_SAMPLES, denoise="off")
        whole = resized(film, self._size)
        return whole if close_up is None else close_up.drawn_on(whole)

    def scene_and_inset(self) -> tuple[ClothScene, Inset | None]:
        """The scene, with the model baked, and what its close-up shows."""
        if self._own_scene:
            bsdf, others = material_bsdf(self.material), further_cloths(self.settings)
            shown = build_scene(self.settings.scene, bsdf, **others, **scene_options(self.settings))
            pixel_mm = shown.pixel_mm(self.settings.metres_per_unit)
            warn_of_hidden_weave(self.material.source, pixel_mm, self.settings)
            return shown, None
        if self.settings.cloths and self.settings.mesh is None:
            raise InputError(
                f"The cloth {next(iter(self.settings.cloths))} needs a mesh with parts, or a scene file "
                f"whose BSDFs have names, and {self.settings.scene} is neither."
            )
        shown, close_up = self._built(self.material, self._size)
        if close_up is None:
            warn_of_hidden_weave(self.material.source, shown.pixel_mm(), self.settings)
        return shown, close_up

    def refined_picture(
        self,
        shown: ClothScene,
        close_up: Inset | None,
        estimate: TimeEstimate,
        partial: PartialPicture | None,
    ) -> NDArray[np.float32]:
        """The picture itself; `partial` gets it after every pass."""

        def drawn(picture: NDArray[np.float32]) -> NDArray[np.float32]:
            return picture if close_up is None else close_up.drawn_on(picture)

        def show(picture: NDArray[np.float32]) -> None:
            if partial is not None:
                partial(drawn(picture))

        with estimate.step("whole") as progress:
            return drawn(self._render(shown, progress=progress, partial=show))

    def _built(self, material: MaterialSpec, size: tuple[int, int]) -> tuple[ClothScene, Inset | None]:
        # A kernel holds all living BSDFs: with those of an earlier picture it would be another one.
        gc.collect()
        setting: SceneOptions = {**scene_options(self.settings), "size": size}
        others = further_cloths(self.settings)
        shown = build_scene(self.settings.scene, material_bsdf(material), **others, **setting)
        shown.integrator.soft_terminator = self.settings.soft_terminator
        if not self._inset:
            return shown, None
        if not isinstance(material.source, Fabric):
            raise InputError(f"inset = {self._inset} needs a fabric, and {material.source.name} is none.")
        close_up = Inset.of(material.source, shown, self._size)
        shown.integrator.corner = close_up.corner
        return shown, close_up

    def _render(self, shown: ClothScene, **options: Any) -> NDArray[np.float32]:
        options = {**picture_options(self.settings), **options}
        return render_scene(shown.scene, integrator=shown.integrator, **options)


# ------------------------------------------------------------------------------------------------------ inset
# A close-up in the corner of a picture, in which the weave can be read.
#
# It takes the place of what the picture would show there: pixels of the corner look through the same camera
# from nearer. So it costs no sample, no kernel and no launch of its own.


Pixels = NDArray[np.float32]

# Of the picture's shorter side: the close-up's side, and its distance from the edges.
_SIDE, _MARGIN = 0.37, 0.025
# Pixels of the picture's shorter side below which a close-up is too small to read.
MIN_PICTURE = 160
# Threads across: so many repeats, but enough to see a cloth and few enough to tell them apart.
_REPEATS, _MIN_THREADS, _MAX_THREADS = 2.5, 18, 36
# Widths of lines in pixels, and their radiance.
FRAME, MARK = 2, 1
_PAPER = 1.0


@dataclass(frozen=True)
class Inset:
    """A close-up: what the middle square of the picture shows from nearer, with its field of view.

    Attributes:
        view: where its camera stands.
        size: width and height of the picture, pixels.
        side: of the close-up, pixels.
        margin: from the close-up to the picture's left and upper edge, pixels.
        magnification: pixels of the close-up for one of the whole picture.
    """

    view: View
    size: tuple[int, int]
    side: int
    margin: int
    magnification: float

    @classmethod
    def of(cls, fabric: Fabric, shown: ClothScene, size: tuple[int, int]) -> Inset:
        """The close-up for the picture of `size` = (width, height) pixels that a scene of a fabric makes."""
        shorter = min(size)
        picks, ends = fabric.draft.drawdown.shape
        threads = np.clip(_REPEATS * max(picks, ends), _MIN_THREADS, _MAX_THREADS)
        # The thinner family decides: of neither are more threads shown.
        pitch = min(length / count for length, count in zip(fabric.repeat_mm, (ends, picks), strict=True))
        point = np.array(shown.point)
        distance = float(np.linalg.norm(shown.view.origin - point))
        whole_mm = 2e3 * distance * np.tan(np.radians(shown.view.field_of_view) / 2)
        zoom = whole_mm / (threads * pitch)
        side = int(_SIDE * shorter)
        margin = round(_MARGIN * shorter) + FRAME
        return cls(shown.view.closer(zoom, point), size, side, margin, zoom * side / shorter)

    @property
    def corner(self) -> Corner:
        """The part of the picture that it takes."""
        size = np.array(self.size, float)
        low, high = self.margin / size, (self.margin + self.side) / size
        return Corner(low, high, min(self.size) / self.side, self.view.origin)

    def drawn_on(self, picture: Pixels) -> Pixels:
        """Linear RGB [h, w, 3] with a frame around the close-up, and a mark around what it shows."""
        picture = picture[..., :3].copy()
        width, height = self.size
        side = max(2, round(self.side / self.magnification))
        _outline(picture, (height - side) // 2, (width - side) // 2, side, MARK)
        _outline(picture, self.margin, self.margin, self.side, FRAME)
        return picture


def resized(picture: Pixels, size: tuple[int, int]) -> Pixels:
    """A linear picture [h, w, c] at another `size` = (width, height): means if smaller, else interpolated."""
    smaller = size[0] * size[1] < picture.shape[0] * picture.shape[1]
    method = Image.Resampling.BOX if smaller else Image.Resampling.BILINEAR
    planes = [
        np.asarray(Image.fromarray(np.ascontiguousarray(plane)).resize(size, method))
        for plane in np.moveaxis(picture, 2, 0)
    ]
    return np.stack(planes, axis=2)


def _outline(picture: Pixels, top: int, left: int, side: int, line: int) -> None:
    """Draws a white frame of `line` pixels around a square."""
    inner = picture[top : top + side, left : left + side].copy()
    picture[top - line : top + side + line, left - line : left + side + line] = _PAPER
    picture[top : top + side, left : left + side] = inner


# -------------------------------------------------------------------------------------------------- turntable
# Pictures of cloth on a turntable: it turns, camera and light stay.


# Positions of pieces of a mesh, by the names of their shapes.
_PIECE = re.compile(rf"({CLOTH_NAME}\d*|{UNCOVERED_NAME})\.vertex_positions")
# Degrees at which the whole cloth has to be in the picture.
_ANGLES = tuple(float(angle) for angle in range(0, 360, 15))
_UP = np.array([0.0, 1.0, 0.0])


def turntable(
    material: Material,
    count: int,
    scene: str | os.PathLike[str] | None = None,
    settings: RenderSettings | None = None,
    **changes: Unpack[RenderKeywords],
) -> Iterator[Picture]:
    """`count` pictures of one turn of a material on a built-in scene or a mesh, with layers; see `render`.

    Raises:
        InputError: a scene file, or a material or value that cannot be used.
    """
    chosen = (settings or RenderSettings()).changed(**changes)
    if scene is not None:
        chosen = chosen.changed(scene=scene)
    if str(chosen.scene) not in SCENES:
        raise InputError(
            f"turntable = {count} does not go with the scene {chosen.scene}: nothing in it turns."
        )
    choose_variant(chosen.variant)
    whole: SceneOptions = {**scene_options(chosen), "zoom": 1.0}
    spec = shown_material(material, chosen)
    bsdf, others = material_bsdf(spec), further_cloths(chosen)
    shown = build_scene(chosen.scene, bsdf, **others, **whole)
    shown.integrator.soft_terminator = chosen.soft_terminator
    turning = Turntable(shown, chosen.zoom, about_middle=chosen.mesh is not None)
    warn_of_hidden_weave(spec.source, shown.pixel_mm(), chosen)
    for picture in turning.pictures(count, **picture_options(chosen)):
        yield with_layers(picture, shown, chosen)


class Turntable:
    """A built-in scene, or one around a mesh, whose cloth turns about a vertical.

    The camera stands as far away as the whole turn of what it frames needs, and closer by `zoom`; one that
    has a place of its own stays there. Built-in cloths turn about the origin, where a ball carries the drape;
    `about_middle` is for others.
    """

    def __init__(self, shown: ClothScene, zoom: float = 1.0, *, about_middle: bool = False) -> None:
        self._shown = shown
        self._params: Any = mi.traverse(shown.scene)
        matches = map(_PIECE.fullmatch, self._params.keys())
        self._rows = {match[1]: self._rows_of(match[1]) for match in matches if match}
        positions = np.concatenate([rows for rows, _ in self._rows.values()])
        low, high = positions.min(axis=0), positions.max(axis=0)
        self._axis = (low + high) / 2 * (1 - _UP) if about_middle else 0 * _UP
        view, middle = shown.view, shown.point
        if shown.framed is not None:
            width, height = shown.scene.sensors()[0].film().size()
            framed = shown.framed.astype(np.float32).astype(np.float64)  # as the shapes hold it
            whole = np.concatenate([self._turned(framed, angle) for angle in _ANGLES])
            towards_camera, size = view.origin - view.target, (int(width), int(height))
            view = framing(whole, towards_camera, size, view.field_of_view, view.up)
            low, high = framed.min(axis=0), framed.max(axis=0)
            middle = self._axis + _UP * (low + high) / 2 if zoom > 1 else view.target
        shown.look_from(view.closer(zoom, middle))

    def pictures(self, count: int, **options: Any) -> Iterator[NDArray[np.float32]]:
        """`count` pictures of one turn, linear RGB [height, width, 3]; the first as the scene has the cloth.

        Args:
            options: of `render`: spp, seed, exposure, white_balance, denoise.
        """
        for number in range(count):
            self._turn(360 * number / count)
            yield render_scene(self._shown.scene, integrator=self._shown.integrator, **options)

    def _turn(self, angle: float) -> None:
        for piece, (positions, normals) in self._rows.items():
            rows = {"positions": self._turned(positions, angle), "normals": _rotated(normals, angle)}
            for name, values in rows.items():
                self._params[f"{piece}.vertex_{name}"] = upload(mi.Float, values.astype(np.float32))
        self._params.update()

    def _turned(self, positions: NDArray[np.float64], angle: float) -> NDArray[np.float64]:
        return _rotated(positions - self._axis, angle) + self._axis

    def _rows_of(self, piece: str) -> tuple[NDArray[np.float64], ...]:
        """Positions and normals [n, 3] of a piece."""
        arrays = ("vertex_positions", "vertex_normals")
        return tuple(
            np.array(self._params[f"{piece}.{name}"], dtype=np.float64).reshape(-1, 3) for name in arrays
        )


def _rotated(vectors: NDArray[np.float64], angle: float) -> NDArray[np.float64]:
    """[n, 3], counter-clockwise as seen from above, degrees."""
    cosine, sine = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    return vectors @ np.array([[cosine, 0, -sine], [0, 1, 0], [sine, 0, cosine]])


# ---------------------------------------------------------------------------------------------- time estimate
# Seconds of a picture: predicted from what is asked for, then corrected by what is measured.


@dataclass(frozen=True)
class ModelSeconds:
    """Cost of a model on two cores of a Zen 4 server, seconds.

    Attributes:
        bake: of a process that has not baked before.
        compile: of the rendering kernel.
        million: samples of paths of eight segments, in millions.
    """

    bake: float = 0.0
    compile: float = 2.5
    million: float = 2.0


# A wrong prediction only shows until the first pass is over.
MODEL_SECONDS = {
    "lobes": ModelSeconds(bake=0.4, compile=2.5, million=2.0),
    "point": ModelSeconds(compile=1.1, million=0.9),
    "neural": ModelSeconds(bake=1.5, compile=3.0, million=4.0),
    "samples": ModelSeconds(compile=2.5, million=8.0),
}
# Of setting Mitsuba's variant, which loads LLVM.
START_SECONDS = 0.4
SCENE_SECONDS = 0.5
_CORES_OF_FIGURES = 2
# Weight of the prediction against what is measured, seconds.
_TRUST = 1.0


def sample_seconds(model: str, samples: int) -> float:
    """Predicted seconds of `samples` of paths on this machine's cores; samples of a pixel times pixels."""
    seconds = MODEL_SECONDS.get(model, ModelSeconds()).million * samples / 1e6
    return seconds * _CORES_OF_FIGURES / core_count()


class TimeEstimate:
    """Time passed and time left of a work of several steps, done one after the other."""

    def __init__(
        self,
        predicted: dict[str, float],
        report: Progress | None,
        clock: Callable[[], float] = time.perf_counter,
    ) -> None:
        """Reports at once.

        Args:
            predicted: seconds of each step, in any order.
            report: called with (milliseconds passed, milliseconds in all, as estimated).
            clock: seconds from any origin.
        """
        self._ahead = dict(predicted)
        self._report = report
        self._clock = clock
        self._begun = self._since = clock()
        self._done = 0.0
        self._finished_seconds = 0.0
        self._step, self._fraction = 0.0, 0.0
        self._first: tuple[float, float] | None = None
        self._tell()

    @contextmanager
    def step(self, name: str) -> Iterator[Callable[[int, int], None]]:
        """While a step is worked on; gives the function that takes (parts done, parts in all)."""
        self._step, self._fraction, self._first = self._ahead.pop(name), 0.0, None
        self._since = self._clock()
        yield self._advance
        self._done += self._step
        self._finished_seconds += self._clock() - self._since
        self._step = self._fraction = 0.0
        self._first = None
        self._tell()

    def left(self) -> float:
        """Estimated seconds until all steps are done."""
        pace = (self._finished_seconds + _TRUST) / (self._done + _TRUST)
        return pace * sum(self._ahead.values()) + self._left_of_step(pace)

    def _advance(self, done: int, total: int) -> None:
        self._fraction = done / total
        if self._first is None:
            self._first = self._clock(), self._fraction
        self._tell()

    def _left_of_step(self, pace: float) -> float:
        rest = 1 - self._fraction
        if self._first is None or self._fraction <= self._first[1]:
            return pace * self._step * rest
        # The first part may compile kernels: later ones tell how fast the rest goes.
        seconds = self._clock() - self._first[0]
        return seconds / (self._fraction - self._first[1]) * rest

    def _tell(self) -> None:
        if self._report is not None:
            passed = self._clock() - self._begun
            self._report(round(1000 * passed), round(1000 * (passed + self.left())))
