"""What the size of a draft costs: large ones against a plain weave of the same sett, and one of 4096 × 4096.

    LOOMLIGHT_DATA=folder python -m benchmarks.draft_size [--output FILE.json]
    python -m benchmarks.draft_size --steps [--output benchmarks/results/draft_size_steps.json]

With --steps it is what the largest drafts cost step by step, each in a process of its own: a scarf of 641 ×
8208 threads in six colours and a cloth of 4096 × 16384 in eight, written as WIF files, read, described by
`weave info`, drawn as `weave show` does, and rendered by two models; and a draft of 16384 × 16384, which
is too large to be rendered. Seconds are CPU seconds of all threads.

Without it, seconds are those of rendering alone, after a first picture that compiles; the fabrics take turns
(A B A B …) in one process, so that both see the same machine, and the figure is the median of the ratios of
neighbours. Memory is the peak of a whole process that renders one picture. Bars: 1.3 times and 2 GB.
"""

from __future__ import annotations

import json
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from argparse import ArgumentParser, Namespace
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import numpy as np

import loomlight
from benchmarks.harness import REPOSITORY, Figures, outside_data, run
from experiments.timing import timed
from loomlight.core.images import write_png
from loomlight.fabric import Fabric, fabric_from_text, load_fabric
from loomlight.fabric.fabric import MAXIMUM_CROSSINGS
from loomlight.mitsuba import build_scene, choose_variant, material_bsdf, render
from loomlight.weave import draw_draft, load_draft, summary

SIDE, SAMPLES, TURNS = 256, 16, 15
LARGE = ("multi-byte-liftplan.wif", "multi-byte-multi-treadled.wif", "multi-byte-single-treadled.wif")
MAX_TIMES, MAX_BYTES = 1.3, 2e9
HUGE = 4096
_ONCE = "import sys; from benchmarks.draft_size import render_once; render_once(sys.argv[1])"
_STEP = "import sys; from benchmarks.draft_size import take_step; take_step(*sys.argv[1:])"
# Ends, picks, shafts and colours.
MAX = {"scarf": (641, 8208, 24, 6), "cloth": (4096, 16384, 32, 8), "square": (16384, 16384, 32, 8)}
STEPS: dict[str, Callable[[str], object]] = {
    "read": load_draft,
    "described": lambda file: summary(load_draft(file)),
    "drawn": lambda file: write_png(f"{file}.png", draw_draft(load_draft(file))),
    "rendered by point": lambda file: loomlight.render(file, model="point", size=(SIDE, SIDE), spp=SAMPLES),
    "rendered by lobes": lambda file: loomlight.render(file, model="lobes", size=(SIDE, SIDE), spp=SAMPLES),
}


def plain_like(fabric: Fabric) -> Fabric:
    """A plain weave of 2 ends and 2 picks with the mean sett and mean gap of `fabric`."""
    layout = fabric.layout()
    warp, weft = layout.warp, layout.weft
    gaps = [
        float(np.clip(1 - family.width.mean() / family.spacing.mean(), 0, 0.95)) for family in (warp, weft)
    ]
    return fabric_from_text(
        f'weave = "plain"\nends_per_cm = {10 / float(warp.spacing.mean())!r}\n'
        f"picks_per_cm = {10 / float(weft.spacing.mean())!r}\n"
        f"[warp]\ngap = {gaps[0]!r}\n[weft]\ngap = {gaps[1]!r}\n"
    )


def picture_of(fabric: Fabric, scene: str) -> Callable[[], float]:
    """A function that renders `fabric` once and returns the seconds that this took."""
    shown = build_scene(scene, material_bsdf(fabric, "point"), size=(SIDE, SIDE))
    return lambda: timed(lambda: render(shown.scene, integrator=shown.integrator, spp=SAMPLES))[1]


def ratio(large: Fabric, small: Fabric, scene: str) -> dict[str, Any]:
    """Median seconds of both fabrics, and the median of the ratios of neighbouring turns."""
    first, second = picture_of(large, scene), picture_of(small, scene)
    first(), second()
    pairs = [(first(), second()) for _ in range(TURNS)]
    return {
        "scene": scene,
        "seconds": round(statistics.median(pair[0] for pair in pairs), 3),
        "plain_seconds": round(statistics.median(pair[1] for pair in pairs), 3),
        "ratio": round(statistics.median(a / b for a, b in pairs), 3),
    }


def whole_process(fabric: str) -> dict[str, float]:
    """Seconds and peak memory, megabytes, of a process that renders `fabric` once."""
    command = [sys.executable, "-c", _ONCE, fabric]
    done, seconds = timed(
        lambda: subprocess.run(command, capture_output=True, text=True, check=True, cwd=REPOSITORY)
    )
    return {"process_seconds": round(seconds, 2), "peak_megabytes": round(int(done.stdout) / 1e6, 1)}


def render_once(fabric: str) -> None:
    """Renders `fabric` and prints the peak memory of this process, bytes."""
    choose_variant()
    picture_of(load_fabric(fabric), "drape")()
    print(peak_bytes())


def peak_bytes() -> int:
    """Peak memory of this process."""
    status = Path("/proc/self/status")
    if status.exists():
        # What getrusage says began as the memory of the process that started this one.
        line = next(line for line in status.read_text().splitlines() if line.startswith("VmHWM:"))
        return int(line.split()[1]) * 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024


def take_step(name: str, file: str) -> None:
    """Takes a step with a draft and prints its CPU seconds, imports included, and the peak memory."""
    STEPS[name](file)
    print(
        json.dumps(
            {"cpu_seconds": round(time.process_time(), 2), "peak_megabytes": round(peak_bytes() / 1e6)}
        )
    )


def wif_of(ends: int, picks: int, shafts: int, colours: int) -> str:
    """A WIF file of a network-like twill: threading and treadling wander, colours lie in stripes."""
    chance = np.random.default_rng(ends + picks)
    end, pick = np.arange(ends), np.arange(picks)
    turn = 2 * shafts - 2
    threading = 1 + np.abs((end * 7 // 5 + (40 * np.sin(end / 97)).astype(int)) % turn - (shafts - 1))
    treadling = 1 + np.abs((pick + (60 * np.sin(pick / 211)).astype(int)) % turn - (shafts - 1))
    lifted = [shaft for shaft in range(shafts) if shaft * 3 % 8 < 4]
    tieup = [",".join(str((treadle + shaft) % shafts + 1) for shaft in lifted) for treadle in range(shafts)]
    table = [",".join(map(str, chance.integers(20, 250, 3))) for _ in range(colours)]
    sections = {
        "WIF": ["Version=1.1"],
        "WEAVING": [f"Shafts={shafts}", f"Treadles={shafts}", "Rising Shed=yes"],
        "WARP": [f"Threads={ends}", "Units=cm", "Spacing=0.04"],
        "WEFT": [f"Threads={picks}", "Units=cm", "Spacing=0.05"],
        "COLOR PALETTE": ["Range=0,255", f"Entries={colours}"],
        "COLOR TABLE": _numbered(table),
        "THREADING": _numbered(threading),
        "TIEUP": _numbered(tieup),
        "TREADLING": _numbered(treadling),
        "WARP COLORS": _numbered(1 + end // 37 % colours),
        "WEFT COLORS": _numbered(1 + (pick // 53 + pick % 2) % colours),
    }
    return "\n".join(line for name, lines in sections.items() for line in (f"[{name}]", *lines))


def _numbered(values: Iterable[object]) -> list[str]:
    return [f"{number}={value}" for number, value in enumerate(values, 1)]


def measure_steps() -> Figures:
    """CPU seconds and peak memory of each step with the largest drafts."""
    drafts: dict[str, dict[str, Any]] = {}
    with tempfile.TemporaryDirectory() as folder:
        for name, (ends, picks, shafts, colours) in MAX.items():
            file = Path(folder, f"{name}.wif")
            file.write_text(wif_of(ends, picks, shafts, colours))
            drafts[name] = {"threads": f"{ends} × {picks}", "megabytes": round(file.stat().st_size / 1e6, 2)}
            for step in STEPS:
                if step.startswith("rendered") and ends * picks > MAXIMUM_CROSSINGS:
                    continue
                command = [sys.executable, "-c", _STEP, step, str(file)]
                done = subprocess.run(command, capture_output=True, text=True, check=True, cwd=REPOSITORY)
                drafts[name][step] = json.loads(done.stdout.splitlines()[-1])
                print(name, step, drafts[name][step], flush=True)
    return {"picture": f"drape, {SIDE} × {SIDE}, {SAMPLES} samples a pixel", "drafts": drafts}


def huge_draft(path: Path) -> None:
    """Writes a figured draft of 4096 × 4096 as a picture: rings of twill and satin, no two alike."""
    line = np.arange(HUGE)
    end, pick = np.meshgrid(line, line)
    ring = np.hypot(end - 1900, pick - 2200) / 37 + 3 * np.sin(end / 311) * np.cos(pick / 173)
    grounds = np.stack([(3 * end - pick) % 8 == 0, (end + pick) % 4 < 2, (3 * end + pick) % 8 != 0])
    warp_up = np.take_along_axis(grounds, (ring.astype(int) % 3)[None], axis=0)[0]
    write_png(path, np.where(warp_up, 0, 255).astype(np.uint8))


def measure(options: Namespace) -> Figures:
    """Ratios and memory of large drafts, and of a huge one; or what their steps cost."""
    if options.steps:
        return measure_steps()
    choose_variant()
    runs: dict[str, dict[str, Any]] = {}
    for name in LARGE:
        draft = outside_data("wif", "good", name).resolve()
        fabric = load_fabric(draft)
        plain = plain_like(fabric)
        scenes = [ratio(fabric, plain, "drape")]
        runs[name] = {"threads": f"{fabric.draft.ends} × {fabric.draft.picks}", "scenes": scenes}
        runs[name] |= whole_process(str(draft))
        print(name, runs[name], flush=True)
    with tempfile.TemporaryDirectory() as folder:
        picture = Path(folder, "huge.png")
        huge_draft(picture)
        huge = load_fabric(picture)
        scenes = [ratio(huge, plain_like(huge), "drape")]
        runs["figured"] = {"threads": f"{HUGE} × {HUGE}", "scenes": scenes, **whole_process(str(picture))}
        print("figured", runs["figured"], flush=True)
    runs["plain"] = {"threads": "2 × 2", **whole_process("plain")}
    measured = [run for name, run in runs.items() if name in LARGE]
    largest = max(scene["ratio"] for run in measured for scene in run["scenes"])
    peak = max(run["peak_megabytes"] for run in measured)
    bars = {"ratio": largest > MAX_TIMES, "memory": peak * 1e6 >= MAX_BYTES}
    missed = [name for name, misses in bars.items() if misses]
    print(f"ratio {largest}, peak {peak} MB")
    return {
        "picture": f"{SIDE} × {SIDE}, {SAMPLES} samples a pixel, {TURNS} turns",
        "largest_ratio": largest,
        "bar_ratio": MAX_TIMES,
        "peak_megabytes": peak,
        "bar_megabytes": MAX_BYTES / 1e6,
        "missed": missed,
        "runs": runs,
    }


def add_options(parser: ArgumentParser) -> None:
    """The choice between ratios and steps."""
    parser.add_argument("--steps", action="store_true", help="the steps of the largest drafts")


if __name__ == "__main__":
    run(measure, add_options, prints=False)
