"""Every draft of the outside corpus through `loomlight render`: seconds a picture, faults in one sentence.

    LOOMLIGHT_DATA=folder python -m benchmarks.corpus [--output benchmarks/results/corpus.json]

The folder holds wif/good, wif/bad and wif/warn. Each file is one process, from its start to its end, so
imports and the compiler are in the figure. Bars: good files are silent and take at most 30 s; bad ones end
with exit code 2, one sentence that names section, key and value, and no picture; warn files render and warn.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
from argparse import Namespace
from pathlib import Path
from typing import Any

from benchmarks.harness import Figures, outside_data, run
from loomlight.evaluation.timing import timed

OPTIONS = ["--size", "256x256", "--spp", "32"]
MOST_SECONDS = 30.0
# A section that is missing as a whole has no key: "[TREADLING] 1=6 needs the section [TIEUP]".
_PLACE = re.compile(r"\[[A-Z ]+\]( [\w ]+=\S+| is missing)")


def rendered(draft: Path) -> dict[str, Any]:
    """Exit code, seconds, stderr and whether there is a picture, of one run of the command line."""
    with tempfile.TemporaryDirectory() as folder:
        picture = Path(folder, "picture.png")
        command = [sys.executable, "-m", "loomlight", "render", str(draft), "-o", str(picture)]
        done, seconds = timed(
            lambda: subprocess.run([*command, *OPTIONS], capture_output=True, text=True, check=False)
        )
        return {
            "exit_code": done.returncode,
            "seconds": round(seconds, 2),
            "says": done.stderr.replace(f"{draft.parent}{os.sep}", "").splitlines(),
            "picture": picture.is_file() and picture.stat().st_size > 1000,
            "left": sorted(path.name for path in Path(folder).iterdir()),
        }


def passes(kind: str, outcome: dict[str, Any]) -> bool:
    """Whether an outcome is what files of the folder `kind` (good, bad, warn) should end in."""
    says: list[str] = outcome["says"]
    if kind == "bad":
        # The message of the fault is the last line; warnings may come before it.
        faults = [line for line in says if not line.startswith("loomlight: warning: ")]
        named = len(faults) == 1 and _PLACE.search(faults[0]) is not None
        return outcome["exit_code"] == 2 and named and not outcome["left"]
    done = outcome["exit_code"] == 0 and outcome["picture"] and outcome["seconds"] <= MOST_SECONDS
    if kind == "good":
        return done and not says
    return done and len(says) >= 1 and all(line.startswith("loomlight: warning: ") for line in says)


def measure(_: Namespace) -> Figures:
    """Every file, as it comes, and which of them miss their bar."""
    runs: dict[str, dict[str, Any]] = {}
    for kind in ("good", "bad", "warn"):
        runs[kind] = {}
        for draft in sorted(outside_data("wif", kind).glob("*.wif")):
            outcome = rendered(draft)
            runs[kind][draft.name] = {**outcome, "passes": passes(kind, outcome)}
            print(
                f"{kind:5}{draft.name:52}{outcome['seconds']:7.2f} s  {' '.join(outcome['says'])[:120]}",
                flush=True,
            )
    every = {f"{kind}/{name}": outcome for kind, part in runs.items() for name, outcome in part.items()}
    slowest = max(outcome["seconds"] for outcome in runs["good"].values())
    missed = [name for name, outcome in every.items() if not outcome["passes"]]
    print(f"{len(every)} files, {len(missed)} failed, slowest {slowest} s")
    return {
        "options": " ".join(OPTIONS),
        "slowest_seconds": slowest,
        "bar_seconds": MOST_SECONDS,
        "files": len(every),
        "missed": missed,
        "runs": runs,
    }


if __name__ == "__main__":
    run(measure, prints=False)
