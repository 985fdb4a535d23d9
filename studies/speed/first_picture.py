"""A first picture as a user meets it: on a new machine, with what that left in its caches, and in stages.

    python -m studies.speed.first_picture [--output FILE.json]

A new machine is a home without caches: of Dr.Jit's kernels, of loomlight, of LLVM. Costs are those of the
whole command `loomlight render`, its start included; `first_*` until a picture can be looked at. Warm ones
are the least of three. Stages are CPU seconds of the same steps in a process that takes them one by one.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import time
from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import Any

from studies.instruments.harness import REPOSITORY, Figures, run
from studies.instruments.processes import Cost, cost_of, loomlight

SIZES = ("320x240", "640x480")
_WARM_RUNS = 3
_STAGES = "import sys; from studies.speed.first_picture import take_stages; take_stages(*sys.argv[1:])"


class Home:
    """A folder that stands for a user's home."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.environment = {"HOME": str(folder), "XDG_CACHE_HOME": str(folder / "cache")}
        self.picture = folder / "picture.png"

    def render(self, fabric: str, size: str) -> Cost:
        """What the command costs."""
        self.picture.unlink(missing_ok=True)
        command = loomlight("render", fabric, "--size", size, "-o", self.picture)
        return cost_of(command, self.environment, self.picture)

    def stages(self, fabric: str, size: str) -> dict[str, float]:
        """CPU seconds of every stage."""
        command = [sys.executable, "-c", _STAGES, fabric, size]
        done = subprocess.run(
            command,
            env={**os.environ, **self.environment},
            cwd=REPOSITORY,
            capture_output=True,
            text=True,
            check=True,
        )
        found: dict[str, float] = json.loads(done.stdout.splitlines()[-1])
        return found


def take_stages(fabric: str, size: str) -> None:
    """Renders a picture stage by stage and prints the CPU seconds of each as JSON."""
    stages: dict[str, float] = {}
    last = 0.0

    def ended(stage: str) -> None:
        nonlocal last
        now = time.process_time()
        stages[stage] = round(now - last, 2)
        last = now

    from loomlight.core.images import write_image
    from loomlight.mitsuba import RenderSettings, choose_variant
    from loomlight.mitsuba.pictures import RenderJob, TimeEstimate, shown_material

    width, height = map(int, size.split("x"))
    settings = RenderSettings(size=(width, height))
    ended("imports")
    choose_variant()
    ended("variant")
    job = RenderJob(shown_material(fabric, settings), settings)
    if job.coarse_size is not None:
        job.coarse_picture(job.coarse_size)
        ended("coarse picture")
    shown, close_up = job.scene_and_inset()
    ended("bake and scene")
    estimate = TimeEstimate(job.seconds(partial=True), None)
    picture = job.refined_picture(
        shown, close_up, estimate, lambda _: None if "first pass" in stages else ended("first pass")
    )
    ended("other passes and denoising")
    with tempfile.TemporaryDirectory() as folder:
        write_image(Path(folder, "picture.png"), picture)
    ended("writing")
    print(json.dumps(stages))


def measure(options: Namespace) -> Figures:
    """Costs of pictures of every size, on a new machine and after."""
    pictures: dict[str, Any] = {}
    for size in SIZES:
        with tempfile.TemporaryDirectory() as folder:
            home = Home(Path(folder))
            new = home.render(options.fabric, size)
            warm = [home.render(options.fabric, size) for _ in range(_WARM_RUNS)]
            staged = home.stages(options.fabric, size)
        with tempfile.TemporaryDirectory() as folder:
            staged_new = Home(Path(folder)).stages(options.fabric, size)
        pictures[size] = {
            "new machine": new,
            "warm": min(warm, key=lambda cost: cost["cpu_seconds"]),
            "stages, new machine": staged_new,
            "stages, warm": staged,
        }
    return {"fabric": options.fabric, "pictures": pictures}


def add_options(parser: ArgumentParser) -> None:
    """The fabric."""
    parser.add_argument("--fabric", default="twill 3/1", help="a fabric file, or a weave's name")


if __name__ == "__main__":
    run(measure, add_options)
