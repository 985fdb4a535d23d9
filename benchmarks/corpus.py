"""Every draft of the outside corpus through `loomlight render`: seconds a picture, faults in one sentence.

    LOOMLIGHT_DATA=folder python benchmarks/corpus.py [--output benchmarks/results/corpus.json]

The folder holds wif/good, wif/bad and wif/warn. Each file is one process, from its start to its end, so
imports and the compiler are in the figure. Bars: good files are silent and take at most 30 s; bad ones end
with exit code 2, one sentence that names section, key and value, and no picture; warn files render and warn.
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

from loomlight.core.provenance import provenance
from loomlight.evaluation.table import write_json

OPTIONS = ["--size", "256x256", "--spp", "32"]
MOST_SECONDS = 30.0
# A section that is missing as a whole has no key: "[TREADLING] 1=6 needs the section [TIEUP]".
_PLACE = re.compile(r"\[[A-Z ]+\]( [\w ]+=\S+| is missing)")


def rendered(draft: Path) -> dict[str, Any]:
    """Exit code, seconds, stderr and whether there is a picture, of one run of the command line."""
    with tempfile.TemporaryDirectory() as folder:
        picture = Path(folder, "picture.png")
        command = [sys.executable, "-m", "loomlight.cli.main", "render", str(draft), "-o", str(picture)]
        start = time.perf_counter()
        done = subprocess.run([*command, *OPTIONS], capture_output=True, text=True, check=False)
        seconds = time.perf_counter() - start
        return {
            "exit_code": done.returncode,
            "seconds": round(seconds, 2),
            "says": done.stderr.replace(f"{draft.parent}{os.sep}", "").splitlines(),
            "picture": picture.is_file() and picture.stat().st_size > 1000,
            "left": sorted(path.name for path in Path(folder).iterdir()),
        }


def passes(kind: str, run: dict[str, Any]) -> bool:
    """Whether a run is what files of the folder `kind` (good, bad, warn) should end in."""
    says: list[str] = run["says"]
    if kind == "bad":
        # The message of the fault is the last line; warnings may come before it.
        faults = [line for line in says if not line.startswith("loomlight: warning: ")]
        named = len(faults) == 1 and _PLACE.search(faults[0]) is not None
        return run["exit_code"] == 2 and named and not run["left"]
    done = run["exit_code"] == 0 and run["picture"] and run["seconds"] <= MOST_SECONDS
    if kind == "good":
        return done and not says
    return done and len(says) >= 1 and all(line.startswith("loomlight: warning: ") for line in says)


def main() -> None:
    """Runs the benchmark, prints it, and exits with 1 if a bar is missed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=Path, default=None)
    arguments = parser.parse_args()
    data = os.environ.get("LOOMLIGHT_DATA")
    if data is None:
        sys.exit("LOOMLIGHT_DATA does not name the folder of outside drafts.")
    runs: dict[str, dict[str, Any]] = {}
    for kind in ("good", "bad", "warn"):
        runs[kind] = {}
        for draft in sorted(Path(data, "wif", kind).glob("*.wif")):
            run = rendered(draft)
            runs[kind][draft.name] = {**run, "passes": passes(kind, run)}
            print(
                f"{kind:5}{draft.name:52}{run['seconds']:7.2f} s  {' '.join(run['says'])[:120]}", flush=True
            )
    every = [run for kind in runs.values() for run in kind.values()]
    result = {
        **provenance("python benchmarks/corpus.py", Path(__file__).parent),
        "options": " ".join(OPTIONS),
        "slowest_seconds": max(run["seconds"] for run in runs["good"].values()),
        "bar_seconds": MOST_SECONDS,
        "files": len(every),
        "failed": sum(not run["passes"] for run in every),
        "runs": runs,
    }
    if arguments.output is not None:
        write_json(arguments.output, result, digits=None)
    print(f"{len(every)} files, {result['failed']} failed, slowest {result['slowest_seconds']} s")
    sys.exit(1 if result["failed"] else 0)


if __name__ == "__main__":
    main()
