"""Makes a library of BRDFs in MERL's format, as `latent` takes those that were measured.

    python -m examples.makers.merl_library FOLDER [COUNT]

COUNT files of 35 MB each, 16 by default, from near-mirrors to chalk, of metals and of plastics: analytic
BRDFs, none of them measured.
"""

from __future__ import annotations

import sys
from pathlib import Path

from studies.papers.zeltner2024.analytic_brdfs import LIBRARY_SIZE, write_analytic_library


def main(folder: Path, count: int = LIBRARY_SIZE) -> None:
    """Writes the files into a folder, which is made."""
    folder.mkdir(parents=True, exist_ok=True)
    write_analytic_library(folder, count)


if __name__ == "__main__":
    main(Path(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else LIBRARY_SIZE)
