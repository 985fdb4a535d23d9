"""Processor seconds of the commands of the README's table, each as a user types it, in a process of its own.

Kernels are compiled in each process but for those that Dr.Jit keeps on disk: one command of each kind runs
beforehand. Processor seconds of all cores stand beside seconds by the clock, which other programs lengthen.
"""

from __future__ import annotations

import shlex
import tempfile
from dataclasses import dataclass
from functools import partial

from loomlight.core.settings import Settings
from loomlight.evaluation.table import Table
from studies.harness.study import Figures, Found, Run, Study, listed, names
from studies.instruments.processes import Cost, cost_of, loomlight

DENIM = "examples/denim.toml"
COMMANDS = {
    "weave show": f"weave show {DENIM} -o {{out}}/a.png",
    "render": f"render {DENIM} -o {{out}}/a.png",
    "render --mesh": f"render {DENIM} -o {{out}}/a.png --mesh examples/cushion.obj --env examples/room.exr",
    "render --turntable": f"render {DENIM} -o {{out}}/a.webp --turntable 12 --size 320x240 --spp 4",
    "swatches": f"swatches {DENIM} -o {{out}}/a.png",
    "bake-maps": f"bake-maps {DENIM} -o {{out}}/maps.exr",
    "export --to gltf": f"export {DENIM} --to gltf -o {{out}}/gltf",
    "export --to wgsl": f"export {DENIM} --to wgsl -o {{out}}/wgsl",
    "bake": f"bake {DENIM} --model lobes -o {{out}}/a.loom",
    "compare": f"compare {DENIM} -o {{out}}/compared",
}
# Of these the whole stands for so many pictures or fabrics.
PARTS = {"render --turntable": 12}


def spent(command: str) -> Cost:
    """What a command costs, with all that it starts."""
    with tempfile.TemporaryDirectory() as folder:
        return cost_of(loomlight(*shlex.split(command.replace("{out}", folder))))


@dataclass(frozen=True)
class Commands(Settings):
    commands: str = names(",".join(COMMANDS), "Commands.", tuple(COMMANDS))


def measure(settings: Commands, run: Run) -> Found:
    """Every command once."""
    return Found({"commands": run.each({name: partial(_warm, name) for name in listed(settings.commands)})})


def _warm(name: str) -> Figures:
    """Of a command that has run before."""
    command = COMMANDS[name]
    spent(command)
    cost, parts = spent(command), PARTS.get(name, 1)
    return {
        "command": command,
        "processor_seconds": round(cost["cpu_seconds"] / parts, 1),
        "seconds": round(cost["seconds"] / parts, 1),
    }


def tables(figures: Figures) -> list[Table]:
    """Seconds by command."""
    rows = {
        f"`{name}`": [found["processor_seconds"], found["seconds"]]
        for name, found in figures["commands"].items()
    }
    return [Table("Commands of the README", ["processor s", "s"], rows, digits=2)]


STUDY = Study(
    "speed/commands",
    "processor seconds of the commands of the README's table, each as a user types it",
    Commands(),
    measure,
    tables,
    stands_on=("lobes cost", "point cost"),
    small={"commands": "weave show"},
)
