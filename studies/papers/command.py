"""The command `python -m studies.papers`: lists the figures, or makes those that are named."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import NoReturn

from loomlight.cli.options import parse_size, require_within
from loomlight.cli.terminal import done, note_left, progress, report_interruption
from loomlight.core.errors import InputError, LoomlightError
from loomlight.core.outputs import require_not_read
from studies.papers.catalogue import CATALOGUE, find_item
from studies.papers.figure import Item
from studies.papers.make import make
from studies.papers.setting import NEURAL, SIZE, Setting

BAD_INPUT = 2


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        raise InputError(f"{message}; `python -m studies.papers --help` shows how it is used.")


def main(arguments: Sequence[str]) -> int:
    """Runs the command line; the exit code is 2 where something is wrong, which one sentence says."""
    try:
        _run(_parser().parse_args(arguments))
    except LoomlightError as error:
        print(f"papers: {error}", file=sys.stderr)
        return BAD_INPUT
    except KeyboardInterrupt:
        return report_interruption()
    except BrokenPipeError:  # the reader of the list has enough
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return 0


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(prog="python -m papers", description="Figures and tables of papers, made again.")
    parser.add_argument(
        "names", metavar="FIGURE", nargs="*", help="such as chen2024/fig4; none lists them all"
    )
    parser.add_argument("-o", "--output", type=Path, metavar="DIR", help="folder for pictures and table.json")
    parser.add_argument("--size", metavar="WxH", help="pixels of each picture; 384x216")
    parser.add_argument(
        "--spp", type=int, help="samples a pixel of references; 256, of zhu2024/table1 and fig5 1024"
    )
    parser.add_argument("--weights", type=Path, metavar="FILE", help="weights of the network; the package's")
    parser.add_argument(
        "--runs", type=Path, default=Path("runs"), metavar="DIR", help="trainings that figures read and make"
    )
    parser.add_argument("--model", metavar="NAME", help="the model of zhu2024's figures; clustered")
    parser.add_argument(
        "--environment", type=Path, metavar="FILE", help="latitude-longitude picture of zhu2024's blouse"
    )
    parser.add_argument(
        "--quality", default="preview", metavar="NAME", help="of trainings: preview, full or published"
    )
    parser.add_argument("--resolution", type=int, metavar="N", help="texels a side, of kuznetsov2021's")
    parser.add_argument("--steps", type=int, metavar="N", help="of each training; as the quality says")
    return parser


def _run(options: argparse.Namespace) -> None:
    if not options.names:
        for item in CATALOGUE.values():
            print(f"{item.name:24}{item.shows}")
        return
    chosen = [find_item(name) for name in options.names]
    output: Path | None = options.output
    if output is None:
        raise InputError("No folder is given: write -o DIR for pictures and table.json.")
    if options.steps is not None:
        require_within("--steps", options.steps, 1, 10_000_000)
    if options.resolution is not None:
        require_within("--resolution", options.resolution, 8, 4096)
    if options.spp is not None:
        require_within("--spp", options.spp, 1, 1_000_000)
    size = SIZE if options.size is None else parse_size(options.size)
    pictures = [output / f"{item.stem}.png" for item in chosen]
    written = [*pictures, output / "table.json", output / "pictures"]
    require_not_read(written, [options.weights, options.environment])
    for item in chosen:
        with progress(item.name) as report:
            setting = Setting(
                size,
                options.spp or item.samples,
                options.weights,
                options.runs,
                report,
                NEURAL if item.model is None else options.model or item.model,
                options.environment,
                options.quality,
                options.steps,
                options.resolution,
            )
            found = make(item.name, output, setting, _command(item, setting))
        for table in found.tables:
            print(table.to_markdown())
        done(output / f"{item.stem}.png")
        note_left(f"{output} holds the figures up to {item.name}.")


def _command(item: Item, setting: Setting) -> str:
    """The command that makes the same figure again, without folders."""
    width, height = setting.size
    command = f"python -m studies.papers {item.name} --size {width}x{height} --spp {setting.samples}"
    options = {"weights": setting.weights, "environment": setting.environment}
    named = "".join(f" --{option} {file.name}" for option, file in options.items() if file is not None)
    model = "" if item.model is None else f" --model {setting.model}"
    if item.name.startswith(("zeltner2024", "kuznetsov2021")):
        named += f" --quality {setting.quality}"
        numbers = {"steps": setting.steps, "resolution": setting.resolution}
        named += "".join(f" --{option} {number}" for option, number in numbers.items() if number is not None)
    return f"{command}{model}{named}"
