"""A first picture as a user meets it: on a new machine, with what that left in its caches, and in stages.

A new machine is a home without caches: of Dr.Jit's kernels, of loomlight, of LLVM. Costs are those of the
whole command `loomlight render`, its start included; `first_*` until a picture can be looked at. Warm ones
are the least of three. Stages are CPU seconds of the same steps in a process that takes them one by one.
"""

from __future__ import annotations

import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Cell, Table
from studies.harness.study import Figures, Found, Run, Study, listed
from studies.instruments.processes import Cost, cost_of, in_own_process, loomlight


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
        return in_own_process(take_stages, fabric, size, environment=self.environment)


def take_stages(fabric: str, size: str) -> dict[str, float]:
    """Renders a picture stage by stage; the CPU seconds of each."""
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
    return stages


@dataclass(frozen=True)
class FirstPicture(Settings):
    fabric: str = setting("twill 3/1", "A fabric file, or a weave's name.")
    sizes: str = setting("320x240,640x480", "Of pictures.", metavar="WxH,…")
    rounds: int = setting(3, "Warm pictures.", low=1)


def measure(settings: FirstPicture, run: Run) -> Found:
    """Costs of pictures of every size, on a new machine and after."""
    pictures: dict[str, Any] = {}
    for size in listed(settings.sizes):
        with tempfile.TemporaryDirectory() as folder:
            home = Home(Path(folder))
            new = home.render(settings.fabric, size)
            warm = [home.render(settings.fabric, size) for _ in range(settings.rounds)]
            staged = home.stages(settings.fabric, size)
        with tempfile.TemporaryDirectory() as folder:
            staged_new = Home(Path(folder)).stages(settings.fabric, size)
        pictures[size] = {
            "new machine": new,
            "warm": min(warm, key=lambda cost: cost["cpu_seconds"]),
            "stages, new machine": staged_new,
            "stages, warm": staged,
        }
    return Found({"fabric": settings.fabric, "pictures": pictures})


def tables(figures: Figures) -> list[Table]:
    """Costs by size and machine, and stages."""
    kinds = ("new machine", "warm")
    costs: dict[str, list[Cell]] = {
        f"{size}, {kind}": [
            found[kind].get(key)
            for key in ("cpu_seconds", "seconds", "first_cpu_seconds", "first_seconds", "peak_megabytes")
        ]
        for size, found in figures["pictures"].items()
        for kind in kinds
    }
    staged = {
        f"{size}, {kind}": found[f"stages, {kind}"]
        for size, found in figures["pictures"].items()
        for kind in kinds
    }
    # Only some pictures have a coarse one first.
    names = max((list(found) for found in staged.values()), key=len)
    stages: dict[str, list[Cell]] = {
        case: [found.get(name) for name in names] for case, found in staged.items()
    }
    columns = ["processor s", "s", "until a picture: processor s", "s until a picture", "peak, MB"]
    return [
        Table("A first picture", columns, costs, f"{figures['fabric']}."),
        Table("Processor seconds of its stages", names, stages),
    ]


STUDY = Study(
    "speed/first_picture",
    "a first picture as a user meets it: on a new machine, with caches, and in stages",
    FirstPicture(),
    measure,
    tables,
    stands_on=("lobes cost",),
    small={"sizes": "32x24", "rounds": 1},
)
