"""The command `loomlight`: parse, call one function, print; what goes wrong is one sentence, exit code 2."""

from __future__ import annotations

import errno
import os
import sys
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any, TextIO

import typer

from loomlight import __version__
from loomlight.cli import bake, capture, compare, doctor, live, pictures, weave
from loomlight.cli.options import ListsModels, ListsOptions, WholeSentences
from loomlight.cli.terminal import INTERRUPTED, note_left, report_interruption, was_interrupted
from loomlight.core.errors import LoomlightError, LoomlightWarning

app = typer.Typer(
    name="loomlight",
    cls=WholeSentences,
    help="From a weave draft to a picture you would believe.",
    no_args_is_help=True,
    add_completion=True,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
    context_settings={"help_option_names": ["-h", "--help"]},
)


def _show_version(requested: bool) -> None:
    if requested:
        print(f"loomlight {__version__}")
        raise typer.Exit


@app.callback()
def _options(
    version: Annotated[
        bool, typer.Option("--version", callback=_show_version, is_eager=True, help="Show the version.")
    ] = False,
) -> None:
    pass


app.add_typer(weave.app, name="weave")
app.command("render", cls=ListsModels, epilog=pictures.RENDER_EXAMPLE)(pictures.render)
app.command("swatches", cls=ListsModels, epilog=pictures.SWATCHES_EXAMPLE)(pictures.swatches)
app.command("play", epilog=live.PLAY_EXAMPLE)(live.play)
app.command("view", epilog=live.VIEW_EXAMPLE)(live.view)
app.command("compare", cls=ListsModels, epilog=compare.EXAMPLE)(compare.compare)
app.command("demo", epilog=pictures.DEMO_EXAMPLE)(pictures.demo)
app.command("capture", epilog=capture.EXAMPLE)(capture.capture)
app.command("bake", cls=ListsOptions, epilog=bake.BAKE_EXAMPLE)(bake.bake)
app.command("bake-maps", epilog=bake.BAKE_MAPS_EXAMPLE)(bake.bake_maps)
app.command("export", epilog=bake.EXPORT_EXAMPLE)(bake.export)
app.command("doctor", epilog=doctor.EXAMPLE)(doctor.doctor)

# What pydantic calls a text that is no number.
_NUMBERS = {"int_parsing": "whole number", "float_parsing": "number"}
# Typer brings its own copy of Click or uses an installed one, by version; this is the base of both.
_UsageError: type[Exception] = typer.BadParameter.__mro__[1]

BAD_INPUT = 2
# What a device says that takes no more.
_FULL = (errno.ENOSPC, errno.EDQUOT, errno.EIO, errno.EFBIG)


def run(arguments: list[str], commands: typer.Typer = app, name: str = "loomlight") -> int:
    """Runs a command line and returns its exit code; prints what is wrong to stderr.

    Args:
        arguments: words after the name.
        commands: what they are parsed by.
        name: of the program.
    """
    warnings.simplefilter("always", LoomlightWarning)
    warnings.showwarning = _show_each_once()
    note_left(None)
    try:
        code = _invoke(arguments, commands, name)
        sys.stdout.flush()
        if code == INTERRUPTED:  # Typer, by version, returns it or raises
            return report_interruption()
        return code if isinstance(code, int) else 0
    except LoomlightError as error:
        return _refuse(str(error))
    except _UsageError as error:
        return _refuse(_sentence(error))
    except (KeyboardInterrupt, typer.Abort):
        return report_interruption()
    except BrokenPipeError:
        return _without_stdout(0)
    except SystemExit:  # what Typer does when the pipe breaks while it prints
        return _without_stdout(0)
    except Exception as error:
        if was_interrupted(error):
            return report_interruption()
        if not isinstance(error, OSError) or error.errno not in _FULL:
            raise
        place = "what is printed" if error.filename is None else str(error.filename)
        return _without_stdout(_refuse(f"{place} cannot be written: {error.strerror}."))


def _invoke(arguments: list[str], commands: typer.Typer, name: str) -> Any:
    try:
        return commands(arguments, prog_name=name, standalone_mode=False)
    except _UsageError as error:
        if type(error).__name__ != "NoArgsIsHelpError":
            raise
        print(error)  # no arguments: Typer raises the help, which is no fault
        return 0


def _without_stdout(code: int) -> int:
    """The exit code, where stdout takes no more, such as by `head`: what Python flushes at exit is lost."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.__stdout__.fileno() if sys.__stdout__ else 1)
    return code


def _refuse(sentence: str) -> int:
    from loomlight.core.sentences import one_line

    print(f"loomlight: {one_line(sentence)}", file=sys.stderr)
    return BAD_INPUT


def _sentence(error: Any) -> str:
    message = error.format_message()
    faults = getattr(error.__cause__, "errors", None)
    if callable(faults):
        # The option's type refused a value that the message does not repeat.
        fault = faults()[0]
        number = _NUMBERS.get(fault["type"])
        message = f"{message} (given was {fault['input']!r})"
        if number is not None and error.param is not None:
            message = f"{error.param.opts[0]} {fault['input']} is no {number}"
    path = error.ctx.command_path if error.ctx is not None else "loomlight"
    return f"{' '.join(message.split()).rstrip('.')}; `{path} --help` shows how it is used."


def _show_each_once() -> Callable[..., None]:
    """A replacement of `warnings.showwarning`: a file that is read twice is complained about once."""
    shown: set[str] = set()

    def show(
        message: Warning | str,
        category: type[Warning],
        filename: str,
        lineno: int,
        file: TextIO | None = None,
        line: str | None = None,
    ) -> None:
        text = str(message)
        if not issubclass(category, LoomlightWarning):
            if sys.warnoptions:  # whoever asks for warnings wants to know where they arise
                sys.stderr.write(warnings.formatwarning(message, category, filename, lineno, line))
                return
            # Of another library: a sentence for those who report it.
            text = f"{' '.join(text.split())[:200]} ({category.__name__} of {Path(filename).stem})."
        if text not in shown:
            shown.add(text)
            print(f"loomlight: warning: {text}", file=sys.stderr)

    return show
