# SPDX-License-Identifier: GPL-3.0-or-later
"""*Apply* and *Cancel*. A timer asks a running process whether it is done, so that the window never waits."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import bpy

from . import pictures, preferences
from .apply import clothe
from .fabric_file import FileError
from .job import Job, JobError, read_manifest
from .material import MapsError

# Seconds between questions to a process.
_INTERVAL = 0.25
_FAULTS = (FileError, JobError, MapsError, preferences.NotFoundError)


@dataclass
class _Running:
    """A process, and whom its material is for: names, as objects may be gone when it is done."""

    job: Job
    scene: str
    things: list[str]
    displacement: bool


_running: list[_Running] = []


def is_running() -> bool:
    """Whether loomlight runs."""
    return bool(_running)


class LOOMLIGHT_OT_apply(bpy.types.Operator):  # noqa: N801 (Blender's convention)
    """Make the fabric's material and give it to the selected meshes"""

    bl_idname = "loomlight.apply"
    bl_label = "Apply"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Whether nothing runs."""
        return not _running

    def execute(self, context: bpy.types.Context) -> set[str]:
        """Starts loomlight, or takes what is ready."""
        settings = context.scene.loomlight
        try:
            things = _chosen(context)
            if settings.source == "READY":
                _clothe(
                    context.scene,
                    things,
                    pictures.READY,
                    read_manifest(pictures.READY),
                    settings.displacement,
                )
                return {"FINISHED"}
            text = settings.text()
            job = Job(preferences.command(), text)
        except _FAULTS as error:
            return _refuse(self, context.scene, str(error))
        _running.append(
            _Running(job, context.scene.name, [thing.name for thing in things], settings.displacement)
        )
        _say(context.scene, "loomlight makes the maps…")
        bpy.app.timers.register(look, first_interval=_INTERVAL, persistent=True)
        return {"FINISHED"}


class LOOMLIGHT_OT_cancel(bpy.types.Operator):  # noqa: N801 (Blender's convention)
    """Stop making the material; the scene stays as it is"""

    bl_idname = "loomlight.cancel"
    bl_label = "Cancel"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Whether something runs."""
        return is_running()

    def execute(self, context: bpy.types.Context) -> set[str]:
        """Ends the process."""
        stop()
        _say(context.scene, "Cancelled; nothing has changed.")
        return {"FINISHED"}


def look() -> float | None:
    """Asks the process; at its end gives the objects their material. Returns when to ask again, seconds."""
    if not _running:
        return None
    running = _running[0]
    if not running.job.is_done():
        return _INTERVAL
    scene = bpy.data.scenes.get(running.scene)
    try:
        folder, manifest = running.job.result()
        things = [thing for thing in map(bpy.data.objects.get, running.things) if thing is not None]
        if scene is not None and things:
            _clothe(scene, things, folder, manifest, running.displacement)
        elif scene is not None:
            _say(scene, "The objects are gone that the fabric was for.", is_fault=True)
    except _FAULTS as error:
        if scene is not None:
            _say(scene, str(error), is_fault=True)
    finally:
        stop()
    return None


def stop() -> None:
    """Ends the process, if one runs, and removes what it wrote."""
    while _running:
        _running.pop().job.close()


def wait() -> None:
    """Waits for the process and its material; for scripts without a window."""
    while _running:
        _running[0].job.wait()
        look()


def _chosen(context: bpy.types.Context) -> list[bpy.types.Object]:
    """The selected meshes, else the active one.

    Raises:
        FileError: there is none, or one without uv.
    """
    found = [thing for thing in context.view_layer.objects if thing.select_get() and thing.type == "MESH"]
    active = context.view_layer.objects.active
    if not found and active is not None and active.type == "MESH":
        found = [active]
    if not found:
        raise FileError("No mesh is selected: select the objects that the fabric is for.")
    for thing in found:
        if not thing.data.uv_layers:
            raise FileError(f"{thing.name} has no UV map: unwrap it (in Edit Mode, UV > Unwrap).")
    return found


def _clothe(
    scene: bpy.types.Scene,
    things: list[bpy.types.Object],
    folder: Path,
    manifest: dict[str, Any],
    relief: bool,
) -> None:
    material = clothe(things, folder, manifest, relief)
    _say(scene, f"{material.name}: done.")
    if not bpy.app.background:
        bpy.ops.ed.undo_push(message="Apply fabric")


def _refuse(operator: bpy.types.Operator, scene: bpy.types.Scene, sentence: str) -> set[str]:
    _say(scene, sentence, is_fault=True)
    operator.report({"WARNING"}, sentence)
    return {"CANCELLED"}


def _say(scene: bpy.types.Scene, sentence: str, is_fault: bool = False) -> None:
    scene.loomlight.message, scene.loomlight.is_fault = sentence, is_fault
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            area.tag_redraw()


def register() -> None:
    """Registers the operators."""
    bpy.utils.register_class(LOOMLIGHT_OT_apply)
    bpy.utils.register_class(LOOMLIGHT_OT_cancel)


def unregister() -> None:
    """Takes them away, and ends what runs."""
    stop()
    if bpy.app.timers.is_registered(look):
        bpy.app.timers.unregister(look)
    bpy.utils.unregister_class(LOOMLIGHT_OT_cancel)
    bpy.utils.unregister_class(LOOMLIGHT_OT_apply)
