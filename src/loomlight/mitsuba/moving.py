"""Pictures of moving cloth: everything is made once, and vertices move from frame to frame."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from typing import Any, Unpack

import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import upload
from loomlight.core.errors import InputError
from loomlight.core.images import Picture
from loomlight.core.picture_settings import RenderKeywords, RenderSettings
from loomlight.mesh.cloth_mesh import INDEX, ClothMesh, joined
from loomlight.mesh.moving import Frame, MovingMesh, chosen_frames, extremes, find_frames, moved
from loomlight.mesh.smoothing import Smoothing
from loomlight.mitsuba.camera import View, view_of_file
from loomlight.mitsuba.pictures import (
    further_cloths,
    picture_options,
    scene_options,
    shown_material,
    warn_of_hidden_weave,
    with_layers,
)
from loomlight.mitsuba.plugins import material_bsdf
from loomlight.mitsuba.rendering import render
from loomlight.mitsuba.scenes import SceneOptions, build_scene, file_camera
from loomlight.mitsuba.variants import choose_variant
from loomlight.models.material_spec import Material

Report = Callable[[int, int], None]


def render_frames(
    material: Material,
    frames: int | str | Iterable[int] | None = None,
    settings: RenderSettings | None = None,
    **changes: Unpack[RenderKeywords],
) -> Iterator[tuple[int, Picture]]:
    """Numbers of frames of moving cloth, and the linear picture [height, width, 3] of each; see `render`.

    Args:
        material: as `render` takes it.
        frames: one number; "A:B" or "A:B:STEP", from A to B, both included; or numbers; by default all.
        settings: by default those of `RenderSettings`, but for `mesh`, which there has to be.
        changes: settings by name, such as `mesh="frames/*.obj", spp=64`, or `mesh="fall.usd"`.

    Raises:
        InputError: no such frames, frames that are not one mesh, or what `render` raises.
    """
    chosen = (settings or RenderSettings()).changed(**changes)
    if chosen.mesh is None:
        raise InputError('render_frames needs a mesh that moves, such as mesh="frames/*.obj".')
    found = find_frames(chosen.mesh)
    wanted = chosen_frames(found, frames, chosen.mesh)
    moving = MovingCloth(material, found, chosen)
    for frame in wanted:
        yield frame.number, moving.picture(frame)


class MovingCloth:
    """A scene around a mesh that moves, of which pictures are taken frame by frame.

    Camera and light are where the whole motion needs them, whichever frames are shown; a camera of the file
    moves as it does there.

    Attributes:
        shown: the scene.
    """

    def __init__(
        self,
        material: Material,
        frames: Sequence[Frame],
        settings: RenderSettings,
        report: Report = lambda done, total: None,
    ) -> None:
        """Bakes the model, reads all frames and builds the scene.

        Args:
            material: as `render` takes it.
            frames: all frames of the motion, in their order.
            settings: of the pictures.
            report: called with (frames read, frames in all).

        Raises:
            InputError: frames that are not one mesh, or what `render` raises.
        """
        if settings.inset:
            raise InputError(f"inset = {settings.inset} does not go with frames of moving cloth.")
        choose_variant(settings.variant)
        self._mesh = MovingMesh(frames, settings.metres_per_unit)
        self._options = picture_options(settings)
        self._settings, self._report = settings, report
        self._views: dict[int, View] = {}
        # Hashes of where vertices are, by frame.
        self._hashes: dict[int, str] = {}
        # Bounds of the whole motion, by which floor and lamps are placed.
        self._surroundings = ""
        spec = shown_material(material, settings)
        options: SceneOptions = {**scene_options(settings), "mesh": self._mesh.first.path}
        others = further_cloths(settings)
        self.shown = build_scene(
            settings.scene,
            material_bsdf(spec),
            time=self._mesh.first.time,
            swept=self._swept,
            **others,
            **options,
        )
        self.shown.integrator.soft_terminator = settings.soft_terminator
        warn_of_hidden_weave(spec.source, self.shown.pixel_mm(), settings)
        dressed = self.shown.dressed
        assert dressed is not None, "a mesh is no scene file"
        self._dressed, self._pieces = dressed, [*dressed.pieces.values()]
        self._smoothing = Smoothing.of(joined(self._pieces))
        self._params: Any = mi.traverse(self.shown.scene)

    def hash_of(self, frame: Frame) -> str:
        """What stands for the cloth of a frame and for where camera and light are, hexadecimal."""
        digest = hashlib.sha256(f"{self._hashes[frame.number]} {self._surroundings}".encode())
        view = self._view(frame)
        for piece in self._pieces:
            digest.update(piece.uv.tobytes() + piece.triangles.tobytes())
        digest.update(np.concatenate([view.origin, view.target, view.up, [view.field_of_view]]).tobytes())
        return digest.hexdigest()

    def picture(self, frame: Frame, **options: Any) -> Picture:
        """The linear picture [height, width, 3] of a frame, with layers; see `render`.

        Args:
            options: of `rendering.render`, other than the settings: spp, seed, denoise and so on.

        Raises:
            InputError: what `MovingMesh.rows` raises.
        """
        self.show(frame)
        picture = render(self.shown.scene, integrator=self.shown.integrator, **{**self._options, **options})
        return with_layers(picture, self.shown, self._settings)

    def show(self, frame: Frame) -> None:
        """Moves the cloth's vertices to where they are in a frame.

        Raises:
            InputError: what `MovingMesh.rows` raises.
        """
        rows = self._mesh.rows(frame)
        pieces = [moved(piece, rows) for piece in self._pieces]
        normals = self._smoothing.of_moved(joined(pieces)).normals
        ends = np.cumsum([len(piece.positions) for piece in pieces])[:-1]
        pieces = [
            replace(piece, normals=own) for piece, own in zip(pieces, np.split(normals, ends), strict=True)
        ]
        for name, mesh in self._dressed.moved(pieces).items():
            for key, values in {"positions": mesh.positions, "normals": mesh.normals}.items():
                self._params[f"{name}.vertex_{key}"] = upload(mi.Float, values.astype(np.float32))
        self._params.update()
        if self._settings.camera is not None:
            self.shown.look_from(self._view(frame))

    def _view(self, frame: Frame) -> View:
        """Where the camera stands in a frame."""
        settings = self._settings
        if settings.camera is None:
            return self.shown.view
        if frame.number not in self._views:
            width, height = self.shown.scene.sensors()[0].film().size()
            camera = file_camera(frame.path, settings.camera, frame.time)
            view = view_of_file(camera, settings.metres_per_unit, (int(width), int(height)))
            self._views[frame.number] = view.closer(settings.zoom, self.shown.point)
        return self._views[frame.number]

    def _swept(self, pieces: Sequence[ClothMesh]) -> NDArray[np.float64]:
        """The outermost places of the cloth over all frames [n, 3]."""
        used = np.unique(np.concatenate([piece.attributes[INDEX][:, 0] for piece in pieces])).astype(np.int64)
        found = []
        for number, frame in enumerate(self._mesh.frames):
            rows = self._mesh.rows(frame)
            self._hashes[frame.number] = hashlib.sha256(rows[used].data).hexdigest()
            found.append(extremes(rows[used]))
            self._report(number + 1, len(self._mesh.frames))
        places = np.concatenate(found)
        self._surroundings = f"{places.min(axis=0).tolist()} {places.max(axis=0).tolist()}"
        return places
