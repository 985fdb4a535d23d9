"""Studies, listed and run: `python -m studies papers/zhu2024/table1 -o out`."""

from __future__ import annotations

import sys

from loomlight.cli.terminal import supervised


def main() -> None:
    """Runs the command line in a forked process, which must load Dr.Jit itself; exits with its code."""
    sys.exit(supervised(_run))


def _run() -> int:
    from studies.harness.command import main as run

    return run(sys.argv[1:])


if __name__ == "__main__":
    main()
