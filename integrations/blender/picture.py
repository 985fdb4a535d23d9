# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders a mesh with the add-on's material in Cycles, for comparisons: `python picture.py JOB.json`.

The job names files and numbers: "maps", a folder of `loomlight export --to blender`; "mesh", an .npz with
positions, uv and triangles; "camera", a matrix [3, 4] to the world whose columns are right, up, backward and
the place; "field_of_view", degrees; "side", pixels; "samples"; "sun", the direction to it; "irradiance"
across its rays; "sky", radiance; "displacement"; "output", an .exr with linear RGB. Lengths are metres.
"""

from __future__ import annotations

import importlib
import json
import math
import sys
from pathlib import Path
from typing import Any

import bpy
import numpy as np
from mathutils import Matrix, Vector

sys.path.insert(0, str(Path(__file__).resolve().parent))


def picture(job: dict[str, Any]) -> None:
    """Renders what a job says."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    cloth = sheet(job["mesh"])
    clothe(cloth, Path(job["maps"]), bool(job["displacement"]))
    camera(scene, job)
    lights(scene, job)
    scene.render.engine = "CYCLES"
    scene.render.resolution_x = scene.render.resolution_y = job["side"]
    scene.render.threads_mode, scene.render.threads = "FIXED", 1
    cycles = scene.cycles
    cycles.samples, cycles.use_adaptive_sampling, cycles.use_denoising = job["samples"], False, False
    # Direct light alone, through any number of holes.
    cycles.max_bounces, cycles.transparent_max_bounces = 0, 32
    cycles.pixel_filter_type, cycles.sample_clamp_direct = "BOX", 0
    image = scene.render.image_settings
    image.file_format, image.color_depth, image.color_mode = "OPEN_EXR", "32", "RGB"
    scene.render.filepath = job["output"]
    bpy.ops.render.render(write_still=True)


def sheet(file: str) -> bpy.types.Object:
    """The mesh of an .npz as a smooth object."""
    with np.load(file) as found:
        positions, uv, triangles = (found[name] for name in ("positions", "uv", "triangles"))
    mesh = bpy.data.meshes.new("cloth")
    mesh.from_pydata(positions.tolist(), [], triangles.tolist())
    mesh.uv_layers.new(name="UVMap").uv.foreach_set("vector", uv[triangles].astype(np.float32).ravel())
    mesh.shade_smooth()
    thing = bpy.data.objects.new("cloth", mesh)
    bpy.context.collection.objects.link(thing)
    return thing


def clothe(thing: bpy.types.Object, maps: Path, displacement: bool) -> None:
    """Gives an object the material of a folder of maps, as the add-on does."""
    apply = importlib.import_module("addon.apply")
    apply.clothe([thing], maps, apply.read_manifest(maps), displacement)


def camera(scene: bpy.types.Scene, job: dict[str, Any]) -> None:
    """The camera of a job."""
    lens = bpy.data.cameras.new("camera")
    lens.angle, lens.clip_start, lens.clip_end = math.radians(job["field_of_view"]), 1e-4, 1e3
    scene.camera = bpy.data.objects.new("camera", lens)
    scene.camera.matrix_world = Matrix([*job["camera"], (0, 0, 0, 1)])
    bpy.context.collection.objects.link(scene.camera)


def lights(scene: bpy.types.Scene, job: dict[str, Any]) -> None:
    """A sun of parallel rays and an even sky."""
    sun = bpy.data.lights.new("sun", "SUN")
    sun.energy, sun.angle = job["irradiance"], 0.0
    lamp = bpy.data.objects.new("sun", sun)
    lamp.rotation_euler = Vector(job["sun"]).to_track_quat("Z", "Y").to_euler()
    bpy.context.collection.objects.link(lamp)
    scene.world = bpy.data.worlds.new("sky")
    if bpy.app.version < (5, 0):
        scene.world.use_nodes = True
    nodes = scene.world.node_tree.nodes
    background = nodes.get("Background") or nodes.new("ShaderNodeBackground")
    background.inputs["Color"].default_value = (1, 1, 1, 1)
    background.inputs["Strength"].default_value = job["sky"]
    output = nodes.get("World Output") or nodes.new("ShaderNodeOutputWorld")
    scene.world.node_tree.links.new(background.outputs[0], output.inputs["Surface"])


if __name__ == "__main__":
    picture(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")))
