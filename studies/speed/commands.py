"""Processor seconds of the commands of the README's table, each as a user types it, in a process of its own.

    python -m studies.speed.commands [--output FILE.json]

Kernels are compiled in each process but for those that Dr.Jit keeps on disk: one command of each kind runs
beforehand. Processor seconds of all cores stand beside seconds by the clock, which other programs lengthen.
"""

from __future__ import annotations

import os
import resource
import shlex
import subprocess
import sys
import tempfile
import time
from argparse import Namespace

from studies.instruments.harness import REPOSITORY, Figures, run

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


def spent(command: str) -> tuple[float, float]:
    """Processor seconds and seconds by the clock of a command, with all that it starts."""
    with tempfile.TemporaryDirectory() as folder:
        words = shlex.split(command.replace("{out}", folder))
        before, begun = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
        subprocess.run(
            [sys.executable, "-m", "loomlight", *words],
            cwd=REPOSITORY,
            check=True,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            env=os.environ | {"PYTHONPATH": str(REPOSITORY / "src")},
        )
        seconds, after = time.perf_counter() - begun, resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, seconds


def measure(options: Namespace) -> Figures:
    """Every command once."""
    del options
    found = {}
    for name, command in COMMANDS.items():
        spent(command)
        processor, clock = (seconds / PARTS.get(name, 1) for seconds in spent(command))
        found[name] = {
            "command": command,
            "processor_seconds": round(processor, 1),
            "seconds": round(clock, 1),
        }
        print(f"{name:20} {processor:6.1f} {clock:6.1f}", flush=True)
    return {"commands": found}


if __name__ == "__main__":
    run(measure, prints=False)
