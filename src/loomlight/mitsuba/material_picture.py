"""A picture of a fabric in one call: what `loomlight render` does, without writing a file."""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Unpack

import numpy as np
from numpy.typing import NDArray

from loomlight.assets.load import load_source
from loomlight.assets.loom_file import LOOM_SUFFIX, is_loom, read_loom
from loomlight.assets.sources import Source, kind_of_file
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.white_balance import white_balance as white_balance_gains
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.load import FABRIC_SUFFIX, edited_fabric
from loomlight.mitsuba.inset import SMALLEST_PICTURE, Inset, composed, resized
from loomlight.mitsuba.material import material_bsdf
from loomlight.mitsuba.rendering import PartialPicture, Progress, filling_grid, render
from loomlight.mitsuba.scenes import DEFAULT_SIZE, SCENES, ClothScene, SceneOptions, build_scene
from loomlight.mitsuba.time_estimate import (
    LOOPS_SECONDS,
    MODEL_SECONDS,
    SCENE_SECONDS,
    START_SECONDS,
    ModelSeconds,
    TimeEstimate,
    sample_seconds,
)
from loomlight.mitsuba.variants import choose_variant
from loomlight.models.compile_ahead import compile_ahead, loops_are_compiled, wait_for_loops
from loomlight.models.interface import Model
from loomlight.models.registry import DEFAULT_MODEL, REFERENCE_MODEL, model_of, require_model_name

DEFAULT_SAMPLES = 9
# Of a pixel of the close-up's film, which has seven for each pixel that is shown.
_INSET_SAMPLES = 2
_LARGEST_EXPOSURE = 30
# The first picture: at so many times fewer pixels each way, so many samples of each.
_COARSE_SCALE, _COARSE_SAMPLES = 2, 4
# Shorter sides below that are no more coarse than needed.
_SMALLEST_COARSE = 128

Picture = NDArray[np.float32]


def render_fabric(
    fabric: Source | str | os.PathLike[str],
    scene: str | os.PathLike[str] = "drape",
    *,
    model: str | None = None,
    spp: int = DEFAULT_SAMPLES,
    seed: int = 0,
    exposure: float = 0.0,
    white_balance: float | None = None,
    inset: bool | None = None,
    variant: str | None = None,
    colors: Mapping[str, Any] | None = None,
    cloths: Mapping[str, Source | str | os.PathLike[str]] | None = None,
    progress: Progress | None = None,
    partial: PartialPicture | None = None,
    **setting: Unpack[SceneOptions],
) -> Picture:
    """Linear RGB [height, width, 3] of a fabric on a piece of cloth, a mesh, or the marked shapes of a scene.

    Args:
        fabric: a fabric or another source; or the path of a fabric file, a draft or a `.loom`; or a weave's
            name, such as "twill 3/1".
        scene: flat, sphere, cylinder, drape, or the path of a Mitsuba scene, FILE.xml.
        model: "lobes", which averages over footprints and needs few samples; "point", exact at every point;
            "neural", the network that averages over footprints; "samples", the mean of many points; by
            default the one that a `.loom` holds, else "lobes". A warning says so if a `.loom` holds another.
        spp: samples a pixel, ≥ 1.
        seed: any 32-bit number; the same seed gives the same picture, but for rounding.
        exposure: stops, −30 to 30; colours are multiplied by 2**exposure.
        white_balance: colour temperature of the light that is shown as white, 1667 to 25000 K; None leaves
            colours as they are, relative to daylight of 6500 K.
        inset: a close-up in the upper left corner, in which the weave can be read; by default where `fabric`
            is a weave's name or a draft and the whole drape is shown, at 160 pixels or more each way.
        variant: llvm_ad_rgb or cuda_ad_rgb; by default the one that is set, else llvm_ad_rgb.
        colors: other colours of a fabric's yarns, by "warp" and "weft", each as a fabric file's `color`.
        cloths: of a scene file, further fabrics by the id of the BSDF that each replaces.
        progress: called with (milliseconds passed, milliseconds in all, as estimated), at first at once.
        partial: called with whole pictures, coarse at first, that later ones refine.
        setting: mesh, metres_per_unit, environment, environment_turn, light, light_from, zoom, size,
            max_depth, placement: see `loomlight.mitsuba.build_scene`.

    Raises:
        InputError: a fabric, file or value that cannot be used.
        MissingDependencyError: no usable LLVM library, or no usable CUDA device.
    """
    if not -_LARGEST_EXPOSURE <= exposure <= _LARGEST_EXPOSURE:
        raise InputError(
            f"exposure = {exposure:g} is out of range: it lies between -{_LARGEST_EXPOSURE} and "
            f"{_LARGEST_EXPOSURE} stops."
        )
    if white_balance is not None:
        white_balance_gains(white_balance)
    if model is not None:
        require_model_name(model)
    if str(scene) not in SCENES and inset:
        raise InputError(f"inset = {inset} does not go with the scene {scene}, whose camera is its own.")
    if model is not None and _is_loom(fabric):
        _warn_of_override(fabric, model)
    bare = _is_bare(fabric)
    material = recoloured(fabric, model, colors) if colors else fabric
    wanted = _Wanted(
        material, scene, model, spp, seed, (exposure, white_balance), inset, bare, cloths or {}, setting
    )
    loops = compile_ahead(wanted.model)
    estimate = TimeEstimate(wanted.seconds(partial is not None), progress)
    with estimate.step("start"):
        choose_variant(variant)
    if partial is not None and wanted.coarse_size is not None:
        with estimate.step("coarse"):
            partial(wanted.coarse_picture(wanted.coarse_size))
    with estimate.step("bake"):
        wait_for_loops(loops)
        shown, close_up = wanted.scene_and_inset()
    return wanted.refined_picture(shown, close_up, estimate, partial)


def recoloured(
    fabric: Source | str | os.PathLike[str], model: str | None, colors: Mapping[str, Any]
) -> Source | Model:
    """A fabric, or the model that a `.loom` holds, in other colours.

    Raises:
        InputError: no fabric, a family that is neither warp nor weft, or what is no colour.
    """
    held = model_of(fabric) if _is_loom(fabric) and model is None else None
    source = held.source if held is not None else _source(fabric)
    if not isinstance(source, Fabric):
        raise InputError(f"Colours of yarns go with fabrics, and {source.name} is none.")
    for family in colors:
        if family not in ("warp", "weft"):
            raise InputError(f'There are no yarns "{family}": colours are of warp or of weft.')
    edited = edited_fabric(source, {f"{family}.color": value for family, value in colors.items()})
    return edited if held is None else held.with_source(edited)


def _source(fabric: Source | str | os.PathLike[str]) -> Source:
    return load_source(fabric) if isinstance(fabric, str | os.PathLike) else fabric


class _Wanted:
    """What `render_fabric` was asked for."""

    def __init__(
        self,
        fabric: Source | Model | str | os.PathLike[str],
        scene: str | os.PathLike[str],
        model: str | None,
        spp: int,
        seed: int,
        development: tuple[float, float | None],
        inset: bool | None,
        bare: bool,
        cloths: Mapping[str, Source | str | os.PathLike[str]],
        setting: SceneOptions,
    ) -> None:
        self._fabric = fabric
        self._scene = scene
        self._given_model = model
        self._spp, self._seed = spp, seed
        self._exposure, self._white_balance = development
        self._setting = setting
        self._cloths = cloths
        self._own_scene = str(scene) not in SCENES
        self._size = setting.get("size") or DEFAULT_SIZE
        self._has_points = _is_fabric(fabric)
        whole_drape = scene == "drape" and setting.get("mesh") is None and setting.get("zoom", 1.0) == 1
        readable = min(self._size) >= SMALLEST_PICTURE
        self._inset = whole_drape and readable and bare if inset is None else inset

    @property
    def model(self) -> str:
        """The name of the model; of one that is used as it is, nothing is baked, and it is empty."""
        is_baked = isinstance(self._fabric, Model) or _is_loom(self._fabric)
        return self._given_model or ("" if is_baked else DEFAULT_MODEL)

    @property
    def coarse_size(self) -> tuple[int, int] | None:
        """Of the first picture, by yarn points.

        None where there are none, where the scene takes time to build, or where the picture is small itself.
        """
        slow = self._own_scene or self._setting.get("mesh") is not None
        if slow or not self._has_points or min(self._size) < _COARSE_SCALE * _SMALLEST_COARSE:
            return None
        width, height = self._size
        return -(-width // _COARSE_SCALE), -(-height // _COARSE_SCALE)

    def seconds(self, partial: bool) -> dict[str, float]:
        """Predicted seconds of every step."""
        cost = MODEL_SECONDS.get(self.model or DEFAULT_MODEL, ModelSeconds())
        pixels = self._size[0] * self._size[1]
        steps = {"start": START_SECONDS, "bake": SCENE_SECONDS + (cost.bake if self.model else 0.0)}
        if self.model == DEFAULT_MODEL and not loops_are_compiled():
            steps["bake"] += LOOPS_SECONDS
        if partial and self.coarse_size is not None:
            samples = (1 + self._inset) * _COARSE_SAMPLES * self.coarse_size[0] * self.coarse_size[1]
            steps["coarse"] = (
                SCENE_SECONDS
                + MODEL_SECONDS[REFERENCE_MODEL].compile
                + sample_seconds(REFERENCE_MODEL, samples)
            )
        if self._inset:
            steps["inset"] = sample_seconds(self.model, min(self._spp, _INSET_SAMPLES) * pixels)
        steps["whole"] = cost.compile + sample_seconds(self.model, filling_grid(max(self._spp, 1)) * pixels)
        return steps

    def coarse_picture(self, size: tuple[int, int]) -> Picture:
        """The picture by single yarn points, of fewer pixels: it needs no baking and no large kernel."""
        fabric = self._fabric.source if isinstance(self._fabric, Model) else self._fabric
        point = model_of(fabric, REFERENCE_MODEL)
        if not isinstance(self._fabric, Model) and not _is_loom(self._fabric):
            # Not read again: large drafts take a while.
            self._fabric = point.source
        shown, close_up = self._built(point, size)
        film = self._render(shown, _COARSE_SAMPLES)
        whole = resized(film, self._size)
        if close_up is None:
            return whole
        shown.look_from(close_up.view)
        inset = close_up.cut(self._render(shown, _COARSE_SAMPLES))
        return composed(whole, inset, close_up.magnification, close_up.margin)

    def scene_and_inset(self) -> tuple[ClothScene, Inset | None]:
        """The scene, with the model baked, and what its close-up shows."""
        if self._own_scene:
            # A scene file may hold several pieces of cloth, each with a model of its own.
            bsdf = material_bsdf(self._fabric, self._given_model)
            others = {name: material_bsdf(cloth) for name, cloth in self._cloths.items()}
            return build_scene(self._scene, bsdf, others=others, **self._setting), None
        if self._cloths:
            raise InputError(
                f"The cloth {next(iter(self._cloths))} needs a scene file whose BSDFs have names, and "
                f"{self._scene} is none."
            )
        return self._built(model_of(self._fabric, self._given_model), self._size)

    def refined_picture(
        self,
        shown: ClothScene,
        close_up: Inset | None,
        estimate: TimeEstimate,
        partial: PartialPicture | None,
    ) -> Picture:
        """The picture itself, close-up first; `partial` gets it after every pass."""
        if close_up is None:
            with estimate.step("whole") as progress:
                return self._render(shown, self._spp, progress=progress, partial=partial)
        shown.look_from(close_up.view)
        with estimate.step("inset") as progress:
            film = self._render(shown, self._spp, take=min(self._spp, _INSET_SAMPLES), progress=progress)
        inset = close_up.cut(film)
        shown.look_from(shown.view)

        def with_inset(whole: Picture) -> Picture:
            return composed(whole, inset, close_up.magnification, close_up.margin)

        def show(whole: Picture) -> None:
            if partial is not None:
                partial(with_inset(whole))

        with estimate.step("whole") as progress:
            return with_inset(self._render(shown, self._spp, progress=progress, partial=show))

    def _built(self, model: Model, size: tuple[int, int]) -> tuple[ClothScene, Inset | None]:
        setting: SceneOptions = {**self._setting, "size": size}
        shown = build_scene(self._scene, material_bsdf(model), **setting)
        if not self._inset:
            return shown, None
        if not isinstance(model.source, Fabric):
            raise InputError(f"inset = {self._inset} needs a fabric, and {model.source.name} is none.")
        close_up = Inset.of(model.source, shown, self._size)
        # From its own place, so that the close-up's kernels are those of the whole picture.
        shown.look_from(shown.view)
        return shown, close_up

    def _render(
        self,
        shown: ClothScene,
        spp: int,
        *,
        take: int | None = None,
        progress: Progress | None = None,
        partial: PartialPicture | None = None,
    ) -> Picture:
        return render(
            shown.scene,
            spp=spp,
            take=take,
            seed=self._seed,
            exposure=self._exposure,
            white_balance=self._white_balance,
            integrator=shown.integrator,
            progress=progress,
            partial=partial,
        )


def _is_loom(fabric: Source | Model | str | os.PathLike[str]) -> bool:
    return isinstance(fabric, str | os.PathLike) and is_loom(fabric)


def _is_fabric(fabric: Source | Model | str | os.PathLike[str]) -> bool:
    """Whether the source is a fabric, as far as can be said without reading a draft."""
    if isinstance(fabric, Model):
        return isinstance(fabric.source, Fabric)
    if not isinstance(fabric, str | os.PathLike):
        return isinstance(fabric, Fabric)
    if is_loom(fabric):
        return isinstance(read_loom(fabric).source, Fabric)
    return kind_of_file(fabric, "fabric") == "fabric"


def _warn_of_override(loom: Source | str | os.PathLike[str], model: str) -> None:
    held = read_loom(str(loom)).model
    if held != model:
        warnings.warn(
            f"{loom} holds the model {held}; {model} is baked from its fabric instead.",
            LoomlightWarning,
            stacklevel=3,
        )


def _is_bare(fabric: Source | str | os.PathLike[str]) -> bool:
    """Whether it is a weave's name or a draft: nobody has said yet what cloth it makes."""
    if not isinstance(fabric, str | os.PathLike):
        return False
    return Path(fabric).suffix.lower() not in (FABRIC_SUFFIX, LOOM_SUFFIX)
