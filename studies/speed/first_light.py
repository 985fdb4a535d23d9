"""How long the editor's page takes to its first picture in a browser that computes in software.

Headless Chromium with SwiftShader opens the page on a fresh profile, with the draped cloth and light between
yarns. Seconds, and CPU seconds of the browser's processes, until the cloth is there flat, until a first lit
frame (points, without shadows) and until it is drawn as asked for (`lobes`, with shadows): the visit of the
fewest CPU seconds.
"""

from __future__ import annotations

import os
import time
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import Any

from playwright.sync_api import sync_playwright

from loomlight.core.errors import InputError
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Table
from loomlight.viewer.app import Access
from loomlight.viewer.client import client_folder
from studies.harness.study import Figures, Found, Run, Study
from studies.instruments.browser import SWIFTSHADER, chromium, launched, serving, wait_until

FABRIC, SIZE = "twill 3/1", (1280, 800)
PATIENCE = 600  # seconds for a step
STEPS = {
    "flat cloth": "window.loomlight?.statistics()?.frames > 0",
    "first light": "window.loomlight.statistics().passes > 0",
    "full picture": "window.loomlight.statistics().preparing === null",
}


def browser_cpu_seconds() -> float:
    """CPU seconds of all processes below this one."""
    parents: dict[int, int] = {}
    ticks: dict[int, int] = {}
    for status in Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = status.read_text().rpartition(")")[2].split()
        except OSError:  # It has ended since.
            continue
        process = int(status.parent.name)
        parents[process], ticks[process] = int(fields[1]), sum(map(int, fields[11:15]))
    below = {os.getpid()}
    while more := {process for process, parent in parents.items() if parent in below} - below:
        below |= more
    return sum(ticks[process] for process in below - {os.getpid()}) / os.sysconf("SC_CLK_TCK")


def first_picture(playwright: Any, port: int, steps: Mapping[str, str]) -> dict[str, dict[str, float]]:
    """Seconds and CPU seconds to each step of one visit."""
    with launched(playwright, SWIFTSHADER) as browser:
        page = browser.new_context(viewport={"width": SIZE[0], "height": SIZE[1]}).new_page()
        page.set_default_timeout(1000 * PATIENCE)
        begun, cpu = time.perf_counter(), browser_cpu_seconds()
        page.goto(f"http://127.0.0.1:{port}/")
        found = {}
        for step, condition in steps.items():
            wait_until(page, condition, PATIENCE)
            seconds, cpu_seconds = time.perf_counter() - begun, browser_cpu_seconds() - cpu
            found[step] = {"seconds": round(seconds, 1), "cpu_seconds": round(cpu_seconds, 1)}
        return found


@dataclass(frozen=True)
class FirstLight(Settings):
    rounds: int = setting(3, "Visits.", low=1)
    full: bool = setting(True, "Waits for the full picture, and not for the flat cloth alone.")


def measure(settings: FirstLight, run: Run) -> Found:
    """The best of some visits.

    Raises:
        InputError: the browser is missing.
    """
    if chromium() is None:
        raise InputError("Chromium is missing (Debian, Ubuntu: apt install chromium).")
    steps = dict(islice(STEPS.items(), None if settings.full else 1))
    access = Access.for_host("127.0.0.1")
    with serving(client_folder(), access, FABRIC) as port, sync_playwright() as playwright:
        visits = [first_picture(playwright, port, steps) for _ in range(settings.rounds)]
    last = list(steps)[-1]
    return Found(
        {
            "fabric": FABRIC,
            "window": f"{SIZE[0]}x{SIZE[1]}",
            **min(visits, key=lambda visit: visit[last]["cpu_seconds"]),
        }
    )


def tables(figures: Figures) -> list[Table]:
    """Seconds to each step."""
    steps = [step for step in STEPS if step in figures]
    rows = {step: [figures[step]["cpu_seconds"], figures[step]["seconds"]] for step in steps}
    note = f"{figures['fabric']}, a window of {figures['window']}."
    return [Table("The editor's page in a browser", ["processor s", "s"], rows, note)]


STUDY = Study(
    "speed/first_light",
    "how long the editor's page takes to its first picture in a browser that computes in software",
    FirstLight(),
    measure,
    tables,
    stands_on=("shaders",),
    small={"rounds": 1, "full": False},
)
