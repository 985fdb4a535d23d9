"""Simulates a towel that falls, held by two of its corners, and writes a numbered OBJ file for each frame.

python -m examples.makers.towel -o frames
"""

from __future__ import annotations

import argparse
from pathlib import Path

from studies.instruments.towel import write


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("-o", "--output", type=Path, required=True, help="folder of the frames")
    parser.add_argument("--count", type=int, default=48, help="frames, of which a second has 24")
    options = parser.parse_args()
    write(options.output, options.count)


if __name__ == "__main__":
    main()
