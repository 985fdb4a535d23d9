"""The command `loomlight`, also `python -m loomlight`; Ctrl-C is looked after before anything is loaded."""

from __future__ import annotations

import os
import sys

from loomlight.cli.terminal import report_interruption, supervised, was_interrupted


def main() -> None:
    """Runs the command line and exits: 0 when done, 2 for bad input, 130 when interrupted."""
    _open_streams()
    sys.exit(supervised(_run))


def _open_streams() -> None:
    """Gives the null device to streams that are closed, whose numbers files would take: daemons have none."""
    while (number := os.open(os.devnull, os.O_RDWR)) <= 2:
        os.set_inheritable(number, True)
    os.close(number)
    # They stay open as long as the process: no block closes them (SIM115).
    if sys.stdout is None:
        sys.stdout = open(1, "w", encoding="utf-8", closefd=False)  # noqa: SIM115
    if sys.stderr is None:
        sys.stderr = open(2, "w", encoding="utf-8", closefd=False)  # noqa: SIM115


def _run() -> int:
    try:
        os.getcwd()
    except FileNotFoundError:
        print("loomlight: the current folder does not exist any more: change to another.", file=sys.stderr)
        return 2
    try:
        from loomlight.cli.main import run
    except BaseException as error:
        if not was_interrupted(error):
            raise
        return report_interruption()
    return run(sys.argv[1:])


if __name__ == "__main__":
    main()
