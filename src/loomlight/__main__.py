"""The command `loomlight`, also `python -m loomlight`; Ctrl-C is looked after before anything is loaded."""

from __future__ import annotations

import sys

from loomlight.cli.interruption import report_interruption, supervised


def main() -> None:
    """Runs the command line and exits: 0 when done, 2 for bad input, 130 when interrupted."""
    sys.exit(supervised(_run))


def _run() -> int:
    try:
        from loomlight.cli.main import run
    except KeyboardInterrupt:
        return report_interruption()
    return run(sys.argv[1:])


if __name__ == "__main__":
    main()
