"""How costs grow: with a draft's threads, with fabrics, pixels, samples and workers.

Each figure is of a whole process, its start included: CPU seconds of all threads, seconds, peak memory.
Caches are warm: what each line compiles has been compiled before. "threads" are the sides of figured drafts,
rings of twill and satin. "drape" is the time of rendering alone, of 4096 × 4096 threads against a plain weave
of the same sett, which take turns; its bar is 1.3. "steps" is what the largest WIF files cost to read, to
describe, to draw and to render (docs/large-drafts.md).
"""

from __future__ import annotations

import statistics
import sys
import tempfile
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from loomlight.core.images import write_pixels
from loomlight.core.settings import Settings, setting
from loomlight.evaluation.table import Cell, Table
from studies.harness.study import REPOSITORY, Figures, Found, Run, Study, listed, listed_numbers, names
from studies.instruments.processes import Cost, cost_of, loomlight
from studies.instruments.timing import timed

if TYPE_CHECKING:
    from loomlight.fabric import Fabric

MAX_TIMES, TURNS = 1.3, 7
# Ends, picks, shafts and colours.
LARGEST = {"scarf": (641, 8208, 24, 6), "cloth": (4096, 16384, 32, 8), "square": (16384, 16384, 32, 8)}
# Crossings that `weave info` and `weave show` take and pictures do not.
_RENDERED = 1 << 26
TITLES = {
    "threads": "Costs by a figured draft's sides",
    "fabrics": "Sheets by the number of fabrics",
    "size": "Pictures by their pixels",
    "spp": "Pictures by samples a pixel",
    "workers": "A catalogue of 24 fabrics by workers",
    "steps": "The largest WIF files",
}
_BAKE = "import sys; from loomlight.models.bake import bake; bake(sys.argv[1], sys.argv[2])"
_READ = "import sys; from loomlight.weave import load_draft; load_draft(sys.argv[1])"


def _catalogue() -> list[str]:
    return [str(path) for path in sorted((REPOSITORY / "examples").glob("*.toml"))]


def threads(folder: Path, settings: Growth) -> Figures:
    """What baking and a picture of a figured draft cost, by its sides."""
    found = {}
    for side in _counts("sides", settings.sides):
        picture = folder / f"{side}.png"
        figured_draft(picture, side)
        found[f"{side} × {side}"] = {
            "start": cost_of([sys.executable, "-c", _READ, str(picture)]),
            "bake of lobes": cost_of([sys.executable, "-c", _BAKE, str(picture), "lobes"]),
        }
        for model in ("point", "lobes"):
            found[f"{side} × {side}"][model] = _warm(_drape(picture, model, folder, settings))
    return found


def _drape(source: Path, model: str, folder: Path, settings: Growth) -> list[str]:
    """The command of a picture of a drape."""
    size = f"{settings.side}x{settings.side}"
    return loomlight("render", source, "--model", model, "--size", size, "--spp", 16, "-o", folder / "a.png")


def fabrics(folder: Path, settings: Growth) -> Figures:
    """Sheets of swatches, by the number of fabrics."""
    sheet = folder / "sheet.png"
    return {
        str(count): _warm(
            loomlight("swatches", *_catalogue()[:count], "--size", 160, "--spp", 4, "-o", sheet)
        )
        for count in _counts("fabrics", settings.fabrics)
    }


def size(folder: Path, settings: Growth) -> Figures:
    """Pictures by their pixels, 8 samples a pixel."""
    return {
        each: _warm(loomlight("render", "twill 3/1", "--size", each, "-o", folder / "a.png"))
        for each in listed(settings.sizes)
    }


def spp(folder: Path, settings: Growth) -> Figures:
    """Pictures by samples a pixel, not denoised."""
    command = loomlight("render", "twill 3/1", "--size", "320x240", "--denoise", "off")
    return {
        str(count): _warm([*command, "--spp", str(count), "-o", str(folder / "a.png")])
        for count in _counts("samples", settings.samples)
    }


def workers(folder: Path, settings: Growth) -> Figures:
    """A catalogue of 24 fabrics, baked by so many processes."""
    sources = []
    for number in range(24):
        file = folder / f"fabric{number}.toml"
        file.write_text(f'weave = "twill {number % 3 + 1}/{number % 5 + 1}"\nends_per_cm = {10 + number}\n')
        sources.append(str(file))
    found = {}
    for count in _counts("workers", settings.workers):
        baked = folder / f"by{count}"
        command = loomlight("bake", *sources, "--model", "lobes", "--workers", count, "-o", baked)
        cost = cost_of(command)
        files = list(baked.glob("*.loom"))
        bytes_each = round(sum(file.stat().st_size for file in files) / len(files))
        found[str(count)] = {"fabrics": len(files), **cost, "bytes a fabric": bytes_each}
    return found


def _counts(option: str, text: str) -> list[int]:
    return [int(number) for number in listed_numbers(option, text)]


def _warm(command: list[str]) -> Cost:
    """The cost of a command that has run before."""
    cost_of(command)
    return cost_of(command)


def drape(folder: Path, settings: Growth) -> Figures:
    """Seconds of rendering alone: a figured draft of 4096 × 4096 against a plain weave of its sett."""
    from loomlight.fabric import load_fabric
    from loomlight.mitsuba import choose_variant

    choose_variant()
    figured_draft(folder / "huge.png", 4096)
    large = load_fabric(folder / "huge.png")
    first, second = _picture_of(large, settings.side), _picture_of(_plain_like(large), settings.side)
    first(), second()
    pairs = [(first(), second()) for _ in range(TURNS)]
    return {
        "seconds": statistics.median(pair[0] for pair in pairs),
        "plain_seconds": statistics.median(pair[1] for pair in pairs),
        "ratio": statistics.median(large / plain for large, plain in pairs),
    }


def _picture_of(fabric: Fabric, side: int) -> Callable[[], float]:
    """A function that renders a drape of a fabric by `point` and returns the seconds that this took."""
    from loomlight.mitsuba import build_scene, material_bsdf, render

    shown = build_scene("drape", material_bsdf(fabric, "point"), size=(side, side))
    return lambda: timed(lambda: render(shown.scene, integrator=shown.integrator, spp=16))[1]


def _plain_like(fabric: Fabric) -> Fabric:
    """A plain weave with the mean sett and mean gap of a fabric."""
    from loomlight.fabric import fabric_from_text

    layout = fabric.layout()
    text = 'weave = "plain"\n'
    for name, family in (("ends", layout.warp), ("picks", layout.weft)):
        text += f"{name}_per_cm = {10 / float(family.spacing.mean())!r}\n"
    for name, family in (("warp", layout.warp), ("weft", layout.weft)):
        gap = float(np.clip(1 - family.width.mean() / family.spacing.mean(), 0, 0.95))
        text += f"[{name}]\ngap = {gap!r}\n"
    return fabric_from_text(text)


def steps(folder: Path, settings: Growth) -> Figures:
    """What each step with the largest WIF files costs."""
    found: Figures = {}
    for name, (ends, picks, shafts, colours) in LARGEST.items():
        file, picture = folder / f"{name}.wif", folder / "a.png"
        file.write_text(wif_of(ends, picks, shafts, colours))
        commands = {
            "read": [sys.executable, "-c", _READ, str(file)],
            "described": loomlight("weave", "info", file),
            "drawn": loomlight("weave", "show", file, "-o", picture),
        }
        if ends * picks <= _RENDERED:
            for model in ("point", "lobes"):
                commands[model] = _drape(file, model, folder, settings)
        found[name] = {"threads": f"{ends} × {picks}", "megabytes": round(file.stat().st_size / 1e6, 2)}
        for step, command in commands.items():
            found[name][step] = cost_of(command)
    return found


def figured_draft(path: Path, side: int) -> None:
    """Writes a figured draft as a picture: rings of twill and satin, where no two threads are alike."""
    line = np.arange(side, dtype=np.float32)
    warp_up = np.empty((side, side), bool)
    for pick in range(side):
        ring = np.hypot(line - 0.46 * side, pick - 0.54 * side) / 37 + 3 * np.sin(line / 311) * np.cos(
            pick / 173
        )
        grounds = np.stack([(3 * line - pick) % 8 == 0, (line + pick) % 4 < 2, (3 * line + pick) % 8 != 0])
        warp_up[pick] = np.take_along_axis(grounds, (ring.astype(int) % 3)[None], axis=0)[0]
    write_pixels(path, np.where(warp_up, 0, 255).astype(np.uint8))


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


PARTS: dict[str, Callable[[Path, Growth], Figures]] = {
    part.__name__: part for part in (threads, fabrics, size, spp, workers, steps, drape)
}


@dataclass(frozen=True)
class Growth(Settings):
    parts: str = names("size,workers", "What grows.", tuple(PARTS))
    sides: str = setting("4,64,641,4096", "Threads of figured drafts.", metavar="N,…")
    side: int = setting(256, "Of pictures of drapes, pixels.", low=16, high=8192)
    fabrics: str = setting("1,4", "Fabrics of sheets.", metavar="N,…")
    sizes: str = setting("160x120,320x240,640x480", "Pixels.", metavar="WxH,…")
    samples: str = setting("1,8,64", "Samples a pixel.", metavar="N,…")
    workers: str = setting("1,2", "Processes that bake.", metavar="N,…")


def measure(settings: Growth, run: Run) -> Found:
    """The figures of the parts asked for; those that load no renderer here come first."""
    found = run.each(
        {name: partial(_part, name, settings) for name in PARTS if name in listed(settings.parts)}
    )
    slow = "drape" in found and found["drape"]["ratio"] > MAX_TIMES
    return Found({**found, "missed": ["drape"] if slow else []})


def _part(name: str, settings: Growth) -> Figures:
    with tempfile.TemporaryDirectory() as folder:
        return PARTS[name](Path(folder), settings)


def tables(figures: Figures) -> list[Table]:
    """A table a part: of whole processes, and of their steps."""
    made = []
    for name, title in TITLES.items():
        if name in figures:
            rows: dict[str, list[Cell]] = {}
            for case, found in figures[name].items():
                if not isinstance(found, dict):
                    continue
                if "cpu_seconds" in found:
                    rows[case] = _cells(found)
                else:
                    rows |= {
                        f"{case}, {step}": _cells(cost)
                        for step, cost in found.items()
                        if isinstance(cost, dict)
                    }
            made.append(Table(title, ["processor s", "s", "peak, MB"], rows))
    if "drape" in figures:
        found = figures["drape"]
        row = [found[key] for key in ("seconds", "plain_seconds", "ratio")]
        columns = ["s", "s of plain weave", "ratio"]
        made.append(Table("A drape of 4096 × 4096 threads", columns, {"by `point`": row}))
    return made


def _cells(cost: Figures) -> list[Cell]:
    return [cost.get(key) for key in ("cpu_seconds", "seconds", "peak_megabytes")]


STUDIES = (
    Study(
        "speed/growth",
        "how costs grow with pixels, and what workers save",
        Growth(),
        measure,
        tables,
        stands_on=("lobes cost",),
        small={"parts": "size", "sizes": "16x12"},
    ),
    Study(
        "speed/growth_samples",
        "how costs grow with fabrics of a sheet and samples",
        Growth(parts="fabrics,spp"),
        measure,
        tables,
        stands_on=("lobes cost",),
        small={"parts": "spp", "samples": "1"},
    ),
    Study(
        "speed/growth_drafts",
        "how costs grow with a draft's threads, and what the largest WIF files cost",
        Growth(parts="threads,steps,drape"),
        measure,
        tables,
        stands_on=("lobes cost", "point cost"),
        small={"parts": "threads", "sides": "4", "side": 16},
    ),
)
