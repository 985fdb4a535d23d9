"""What Godot draws of a pack, without a card: the folder becomes a project, which the editor imports.

Needs `godot` of version 4 (the variable GODOT names another program), `xvfb-run` where there is no display,
and Vulkan: Mesa's lavapipe is enough.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from studies.instruments.engine_page import Light

_SCRIPT = Path(__file__).parent / "engine_pages" / "draw.gd"
_PROJECT = 'config_version=5\n\n[application]\nconfig/name="cloth"\n'


@dataclass(frozen=True)
class Job:
    """A picture: of a `.tres` in the folder, from where, how wide, and by which light."""

    file: str
    eye: tuple[float, float, float]
    degrees: float
    side: int
    light: Light


def godot() -> str | None:
    """The program, or None."""
    return shutil.which(os.environ.get("GODOT", "godot"))


def drawn_by_godot(
    folder: Path, mesh: Path, metres: float, jobs: Sequence[Job], seconds: float
) -> list[NDArray[np.uint8]]:
    """Pictures [side, side, 3], sRGB, of a mesh in materials of the folder, which becomes a project.

    Args:
        mesh: an .obj.
        metres: the length of a unit of its uv.
        seconds: to import and to draw, at most, each.

    Raises:
        RuntimeError: it drew nothing; the message is what it said.
    """
    (folder / "project.godot").write_text(_PROJECT, encoding="utf-8")
    shutil.copy(mesh, folder / "mesh.obj")
    shutil.copy(_SCRIPT, folder / "draw.gd")
    listed = [
        {
            "file": job.file,
            "metres": metres,
            "eye": job.eye,
            "degrees": job.degrees,
            "side": job.side,
            "sky": job.light.sky,
            "sun": job.light.sun,
            "toSun": job.light.to_sun,
            "picture": f"drawn-{number}.png",
        }
        for number, job in enumerate(jobs)
    ]
    (folder / "jobs.json").write_text(json.dumps(listed), encoding="utf-8")
    program = godot() or "godot"
    display = [] if "DISPLAY" in os.environ else ["xvfb-run", "-a"]
    said = ""
    for command in (
        [program, "--headless", "--path", str(folder), "--import"],
        [*display, program, "--path", str(folder), "--audio-driver", "Dummy", "--script", "draw.gd"],
    ):
        done = subprocess.run(command, capture_output=True, text=True, timeout=seconds, check=False)
        said += done.stdout + done.stderr
    files = [folder / str(each["picture"]) for each in listed]
    if not all(file.is_file() for file in files):
        raise RuntimeError(f"Godot drew nothing:\n{said}")
    return [np.asarray(Image.open(file).convert("RGB")) for file in files]
