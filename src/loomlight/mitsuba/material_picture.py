"""A picture of a material in one call: what `loomlight render` does, without writing a file."""

from __future__ import annotations

import gc
import math
import os
import warnings
from dataclasses import dataclass
from typing import Any, Unpack, cast

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.images import Picture
from loomlight.fabric.fabric import Fabric
from loomlight.mitsuba.camera import MAX_ZOOM
from loomlight.mitsuba.inset import MIN_PICTURE, Inset, resized
from loomlight.mitsuba.plugins import material_bsdf
from loomlight.mitsuba.rendering import PartialPicture, Progress
from loomlight.mitsuba.rendering import render as render_scene
from loomlight.mitsuba.scenes import DEFAULT_SIZE, SCENES, BsdfFactory, ClothScene, SceneOptions, build_scene
from loomlight.mitsuba.time_estimate import (
    MODEL_SECONDS,
    SCENE_SECONDS,
    START_SECONDS,
    ModelSeconds,
    TimeEstimate,
    sample_seconds,
)
from loomlight.mitsuba.variants import choose_variant
from loomlight.models.material_spec import Material, MaterialSpec, resolve
from loomlight.models.registry import REFERENCE_MODEL
from loomlight.picture_settings import RenderKeywords, RenderSettings
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
    return job.refined_picture(shown, close_up, estimate, partial).view(Picture)


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
    return spec.recoloured(settings.colors) if settings.colors else spec


def further_cloths(settings: RenderSettings) -> dict[str, BsdfFactory]:
    """What `settings.cloths` names, each with a model of its own."""
    return {name: material_bsdf(cloth) for name, cloth in settings.cloths.items()}


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
        self._size = setting.size or DEFAULT_SIZE
        whole_drape = str(setting.scene) == "drape" and setting.mesh is None and setting.zoom == 1
        readable = min(self._size) >= MIN_PICTURE
        is_wanted = whole_drape and readable and self.material.is_bare
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
            shown = build_scene(self.settings.scene, bsdf, others=others, **scene_options(self.settings))
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
        shown = build_scene(self.settings.scene, material_bsdf(material), others=others, **setting)
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
