"""Writes the fibres of a fabric as a tile that `neumip` bakes: plies and fibres of every yarn, as curves.

python -m examples.makers.fibre_tile "basket 2/2" FOLDER [--plies 2] [--fibres 30]
loomlight bake FOLDER/tile.toml --model neumip -o basket.loom
"""

from __future__ import annotations

import argparse

from loomlight.fabric.read import load_fabric
from studies.instruments.fibre_curves import FibreSettings
from studies.instruments.fibre_tile import write_fibre_tile


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("fabric", help="a fabric file, a draft, or a weave's name")
    parser.add_argument("folder")
    parser.add_argument("--plies", type=int, default=FibreSettings.plies)
    parser.add_argument("--fibres", type=int, default=FibreSettings.fibres, help="of a ply")
    options = parser.parse_args()
    settings = FibreSettings(options.plies, options.fibres)
    print(write_fibre_tile(load_fabric(options.fabric), options.folder, settings))


if __name__ == "__main__":
    main()
