"""The add-on in Blender itself, without a window: `pytest -m blender tests/integrations`.

They need the package bpy in an environment of its own, whose Python LOOMLIGHT_BLENDER names, by default
.venv-bpy/bin/python.

Covers: exporters/blender.py, exporters/blender_addon.py
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import textwrap
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from loomlight.exporters import export
from loomlight.fabric import fabric_from_text
from loomlight.mesh.cloth_mesh import uv_size
from loomlight.mitsuba import read_mesh
from tests.limits import HANG

pytestmark = pytest.mark.blender
ROOT = Path(__file__).parents[2]
BLENDER = Path(os.environ.get("LOOMLIGHT_BLENDER", ROOT / ".venv-bpy" / "bin" / "python"))
# Few threads, and holes between them.
TEXT = 'name = "Scrim"\nweave = "plain"\ngap = 0.3\n[warp]\ncolor = "#803020"\n[weft]\ncolor = "#203080"\n'
# What every script begins with: the add-on is installed as users install it, a plane of 50 mm is selected.
BEGIN = """
import json, sys
from pathlib import Path
import bpy
given = json.loads(sys.argv[1])
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.extensions.package_install_files(
    filepath=given["zip"], repo="user_default", enable_on_install=True, overwrite=True
)
import importlib
def module(name):
    return importlib.import_module(f"bl_ext.user_default.loomlight.{name}")
bpy.ops.mesh.primitive_plane_add(size=0.05)
thing = bpy.context.object
settings = bpy.context.scene.loomlight
preferences = bpy.context.preferences.addons["bl_ext.user_default.loomlight"].preferences
preferences.command = given["python"]
def blocks():
    kinds = ("materials", "node_groups", "images")
    return {kind: sorted(block.name for block in getattr(bpy.data, kind)) for kind in kinds}
def ready():
    settings.source = "READY"
    assert bpy.ops.loomlight.apply() == {"FINISHED"}, settings.message
def done(**found):
    print("found " + json.dumps(found))
"""


@pytest.fixture(scope="module")
def packed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The add-on's zip with a fabric of two colours ready in it."""
    if not BLENDER.is_file():
        pytest.skip(f"{BLENDER} is missing: python -m venv .venv-bpy, and pip install bpy there.")
    folder = export(fabric_from_text(TEXT), "blender-addon", tmp_path_factory.mktemp("blender") / "addon")
    return next(folder.glob("*.zip"))


@pytest.fixture
def blender(packed: Path, tmp_path: Path) -> Callable[..., dict[str, Any]]:
    """Runs a script in Blender, after `BEGIN`; returns what it hands to `done`."""

    def run(script: str, **given: object) -> dict[str, Any]:
        names = {"zip": str(packed), "python": sys.executable, "folder": str(tmp_path)} | given
        environment = os.environ | {"BLENDER_USER_RESOURCES": str(tmp_path / "user")}
        done = subprocess.run(
            [str(BLENDER), "-c", BEGIN + textwrap.dedent(script), json.dumps(names)],
            capture_output=True,
            text=True,
            timeout=HANG,
            env=environment,
            cwd=tmp_path,
        )
        lines = [line for line in done.stdout.splitlines() if line.startswith("found ")]
        assert lines, done.stdout + done.stderr
        assert "Traceback" not in done.stderr, done.stderr
        found: dict[str, Any] = json.loads(lines[-1].removeprefix("found "))
        return found

    return run


def test_it_registers_and_unregisters(blender: Callable[..., dict[str, Any]]) -> None:
    found = blender("""
        before = hasattr(bpy.types.Scene, "loomlight"), hasattr(bpy.types, "LOOMLIGHT_PT_sidebar")
        items = [len(module("pictures").fabrics()), len(module("pictures").weaves())]
        # Without a window there are no icons; the pictures are read all the same.
        sizes = [min(picture.image_size) for picture in module("pictures")._pictures[0].values()]
        bpy.ops.preferences.addon_disable(module="bl_ext.user_default.loomlight")
        after = hasattr(bpy.types.Scene, "loomlight"), hasattr(bpy.types, "LOOMLIGHT_PT_sidebar")
        done(before=before, after=after, items=items, sizes=sizes)
    """)
    assert found["before"] == [True, True]
    assert found["after"] == [False, False]
    assert min(found["items"]) > 20
    assert len(found["sizes"]) == sum(found["items"])
    assert min(found["sizes"]) >= 128


def test_blender_s_own_check_of_extensions_takes_the_zip(packed: Path) -> None:
    below = "lib/python*/site-packages/bpy/*/scripts/addons_core/bl_pkg/cli/blender_ext.py"
    (check,) = BLENDER.parents[1].glob(below)
    subprocess.run([str(BLENDER), str(check), "validate", str(packed)], check=True, timeout=HANG)


def test_what_is_ready_needs_no_loomlight(blender: Callable[..., dict[str, Any]]) -> None:
    found = blender(
        """
        ready()
        material = thing.active_material
        node = material.node_tree.nodes["loomlight"]
        name = material.name
        images = {part.image for part in node.node_tree.nodes if part.type == "TEX_IMAGE"}
        count = len(images)
        bpy.ops.wm.save_as_mainfile(filepath=given["folder"] + "/saved.blend")
        bpy.ops.wm.open_mainfile(filepath=given["folder"] + "/saved.blend")
        again = [image for image in bpy.data.images if image.name.startswith("Scrim")]
        done(
            name=name,
            images=count,
            packed=[image.packed_file is not None and image.has_data or image.size[0] for image in again],
            paths=[image.filepath for image in again],
            warp=list(bpy.data.materials[0].node_tree.nodes["loomlight"].inputs["Warp Color"].default_value),
            scales=list(bpy.data.objects["Plane"]["loomlight_mm"]),
        )
        """,
        python="/nowhere",
    )
    assert found["name"] == "Scrim"
    # Three densities of seven maps, and the heights.
    assert found["images"] == 22
    assert len(found["paths"]) == 22
    assert all(found["packed"])
    assert not any(path.startswith("/") and not path.startswith("//") for path in found["paths"])
    assert found["scales"] == pytest.approx([50, 50, 0], rel=1e-5)
    # #803020 in linear RGB: (128 / 255 + 0.055)/1.055 to the power of 2.4, and so on.
    assert found["warp"] == pytest.approx([0.21586, 0.02956, 0.01444, 1], rel=1e-3)


def test_a_fabric_file_is_made_by_loomlight(blender: Callable[..., dict[str, Any]], tmp_path: Path) -> None:
    """The process is polled; until it is done nothing changes, and then the objects have the material."""
    (tmp_path / "cloth.toml").write_text('weave = "twill 2/1"\nepi = 30\n[warp]\nalbedo = "#ff0000"\n')
    found = blender("""
        settings.source, settings.file = "FILE", given["folder"] + "/cloth.toml"
        settings.use_warp, settings.warp = True, (0.2, 0.3, 0.4)
        settings.ends_per_cm, settings.picks_per_cm, settings.yarn = 8, 6, "linen"
        assert bpy.ops.loomlight.apply() == {"FINISHED"}, settings.message
        during = blocks(), module("operators").is_running(), module("operators").look()
        module("operators").wait()
        node = thing.active_material.node_tree.nodes["loomlight"]
        done(
            during=during,
            message=settings.message,
            fault=settings.is_fault,
            warp=list(node.inputs["Warp Color"].default_value)[:3],
            left=module("operators").is_running(),
        )
    """)
    assert found["during"][0] == {"materials": [], "node_groups": [], "images": []}
    assert found["during"][1] is True
    assert found["message"] == "cloth: done."
    assert not found["fault"]
    # The colour goes through 8 bits of sRGB: half a step is 1.5 % there.
    assert found["warp"] == pytest.approx([0.2, 0.3, 0.4], rel=0.015)
    assert not found["left"]


FAULTS = {
    "no loomlight": ('preferences.command = "/nowhere/loomlight"', "/nowhere/loomlight is no program"),
    "no mesh": ("bpy.data.objects.remove(thing)", "No mesh is selected"),
    "no uv": ("thing.data.uv_layers.remove(thing.data.uv_layers[0])", "Plane has no UV map"),
    "no file": ('settings.source, settings.file = "FILE", "/nowhere/a.toml"', "is no file"),
    "no fabric": (
        'settings.source, settings.file = "FILE", given["folder"] + "/a.toml"',
        "a.toml is no fabric",
    ),
    "no weave": ('settings.source, settings.weave = "WEAVE", "gobbledygook"', "gobbledygook"),
    "huge draft": (
        'settings.source, settings.file = "FILE", given["folder"] + "/b.toml"',
        "more than 4096 threads",
    ),
    "too old": ('preferences.command = given["folder"] + "/old"', "too old"),
    "nonsense": ('preferences.command = given["folder"] + "/nonsense"', "no maps that the add-on can read"),
    "cut short": ('preferences.command = given["folder"] + "/short"', "cannot be read"),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_is_one_sentence_and_changes_nothing(
    fault: str, blender: Callable[..., dict[str, Any]], tmp_path: Path
) -> None:
    (tmp_path / "a.toml").write_text("weave = \n")
    (tmp_path / "b.toml").write_text('weave = "damask 40000"\n')
    manifest = '{"format": 2, "fabric": "x", "colors": {"warp": [1, 1, 1], "weft": [1, 1, 1]}}'
    programs = {
        "old": """echo 'Error: --to "blender" is unknown: use one of slang.' >&2; exit 2""",
        "nonsense": 'mkdir "$6"',
        "short": f'mkdir "$6"; echo \'{manifest}\' > "$6/manifest.json"',
    }
    for name, body in programs.items():
        file = tmp_path / name
        # The words are export FABRIC --to blender -o FOLDER.
        file.write_text(f"#!/bin/sh\n{body}\n")
        file.chmod(0o755)
    change, says = FAULTS[fault]
    found = blender(f"""
        {change}
        before = blocks()
        bpy.ops.loomlight.apply()
        module("operators").wait()
        done(before=before, after=blocks(), message=settings.message, fault=settings.is_fault)
    """)
    assert says in found["message"]
    assert found["fault"]
    assert "\n" not in found["message"]
    assert found["before"] == found["after"] == {"materials": [], "node_groups": [], "images": []}


def test_cancelling_ends_the_process(blender: Callable[..., dict[str, Any]]) -> None:
    found = blender("""
        settings.source = "GALLERY"
        bpy.ops.loomlight.apply()
        job = module("operators")._running[0].job
        bpy.ops.loomlight.cancel()
        done(ended=job.is_done(), folder=job.folder.exists(), blocks=blocks(), message=settings.message)
    """)
    assert found["ended"]
    assert not found["folder"]
    assert found["blocks"] == {"materials": [], "node_groups": [], "images": []}
    assert "nothing has changed" in found["message"]


def test_displacement_is_linked_where_it_is_chosen(blender: Callable[..., dict[str, Any]]) -> None:
    found = blender("""
        states = []
        for chosen in (False, True):
            settings.displacement = chosen
            ready()
            tree = thing.active_material.node_tree
            output = next(node for node in tree.nodes if node.type == "OUTPUT_MATERIAL")
            amount = tree.nodes["loomlight"].inputs["Displacement"].default_value
            linked = output.inputs["Displacement"].is_linked
            method = thing.active_material.displacement_method
            states.append([linked, amount, method])
        done(states=states)
    """)
    assert found["states"] == [[False, 0, "BUMP"], [True, 1, "BOTH"]]


def test_a_second_material_takes_the_place_of_the_first(blender: Callable[..., dict[str, Any]]) -> None:
    found = blender("ready()\nready()\ndone(**blocks())")
    assert len(found["materials"]) == len(found["node_groups"]) == 1
    assert len(found["images"]) == 22


def test_millimetres_a_unit_of_uv_are_loomlight_s(
    blender: Callable[..., dict[str, Any]], tmp_path: Path
) -> None:
    """A cushion whose uv are stretched in places, scaled by two in the scene."""
    cushion = ROOT / "examples" / "cushion.obj"
    found = blender(
        """
        bpy.ops.wm.obj_import(filepath=given["mesh"])
        thing = bpy.context.selected_objects[0]
        thing.scale = (2, 2, 2)
        bpy.context.view_layer.update()
        done(size=module("uv_scale").uv_size(thing, 1.0))
        """,
        mesh=str(cushion),
    )
    # Single precision of places.
    assert found["size"] == pytest.approx(uv_size(read_mesh(cushion), 2.0), rel=1e-4)


def test_edits_of_colour_are_seen_at_once(blender: Callable[..., dict[str, Any]]) -> None:
    """The warp is dyed green in the material itself: the picture turns green, and nothing is made anew."""
    found = blender(
        """
        ready()
        import numpy as np
        scene = bpy.context.scene
        scene.camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
        scene.camera.location, scene.camera.data.angle = (0, 0, 0.5), 0.1
        bpy.context.collection.objects.link(scene.camera)
        sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
        sun.data.energy = 3
        bpy.context.collection.objects.link(sun)
        scene.render.engine, scene.cycles.samples, scene.cycles.use_denoising = "CYCLES", 4, False
        scene.render.resolution_x = scene.render.resolution_y = 16
        scene.render.image_settings.file_format = "OPEN_EXR"
        scene.render.filepath = given["folder"] + "/picture.exr"
        node = thing.active_material.node_tree.nodes["loomlight"]
        means = []
        for colour in (node.inputs["Warp Color"].default_value[:], (0.0, 0.8, 0.0, 1)):
            node.inputs["Warp Color"].default_value = colour
            bpy.ops.render.render(write_still=True)
            image = bpy.data.images.load(scene.render.filepath, check_existing=False)
            means.append(np.array(image.pixels).reshape(-1, 4)[:, :3].mean(axis=0).tolist())
        done(means=means)
        """
    )
    (red, green, _), (red_then, green_then, _) = found["means"]
    assert red > green
    assert green_then > 3 * green
    assert red_then < 0.6 * red
