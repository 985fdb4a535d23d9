"""Options of commands: those that commands share, those of declared settings, values of texts, and help."""

from __future__ import annotations

import inspect
import math
import os
import re
import tomllib
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import wraps
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, cast

import typer
from typer.core import TyperCommand, TyperGroup

from loomlight.core.errors import InputError
from loomlight.core.picture_settings import MAX_SIDE, Worn
from loomlight.core.settings import Setting, Settings, declared, default_text, range_text

if TYPE_CHECKING:
    from loomlight.core.fleet import Executor

FabricsArgument = Annotated[
    list[str],
    typer.Argument(metavar="FABRIC...", help="Fabric files, drafts, .loom files, or weaves' names."),
]
FabricArgument = Annotated[
    str, typer.Argument(metavar="FABRIC", help="A fabric file, a draft, a .loom, or a weave's name.")
]

# Of commands that run over many items.
Workers = Annotated[int, typer.Option("--workers", metavar="N", help="Processes, or jobs of Slurm.")]
ExecutorName = Annotated[
    str,
    typer.Option(
        "--executor",
        metavar="NAME",
        help="local: processes of this machine; slurm: jobs through submitit; joblib:BACKEND, such as "
        "joblib:dask or joblib:ray. See docs/fleet.md.",
    ),
]
SlurmSettings = Annotated[
    list[str] | None,
    typer.Option(
        "--slurm", metavar="NAME=VALUE", help="A parameter of submitit, such as slurm_partition=cpu."
    ),
]


def executor_of(name: str, workers: int, slurm: list[str] | None) -> Executor:
    """The executor of the options.

    Raises:
        InputError: no such executor, or a value out of range.
    """
    from loomlight.core.fleet import parse_executor

    settings = parse_named("--slurm", slurm or [], "slurm_partition=cpu,timeout_min=60")
    return parse_executor(name, workers, {name: values[-1] for name, values in settings.items()})


# ------------------------------------------------------------------------------------------ declared settings

# Values of settings by name: those that a command line gives.
Given = dict[str, Any]
# The parameter of a command that the options take the place of.
_PLACE = "given"


@dataclass(frozen=True)
class SettingOption:
    """The option of a setting.

    Attributes:
        path: names of the setting, and before it of those that it is part of.
        setting: its declaration.
    """

    path: tuple[str, ...]
    setting: Setting

    @property
    def key(self) -> str:
        """The name of the command's parameter."""
        return self.path[-1]

    @property
    def flag(self) -> str:
        """What is written before the value."""
        return self.setting.flag or f"--{self.key.replace('_', '-')}"

    def parameter(self) -> inspect.Parameter:
        """The parameter that Typer makes the option of; None where it is not given."""
        declaration = self.setting
        sentence = f"{declaration.help}{default_text(declaration, '  [default: {}]')}"
        completion = _completed_by(declaration.choices) if declaration.choices else None
        information = typer.Option(
            self.flag,
            help=sentence,
            metavar=declaration.metavar or "|".join(declaration.choices) or None,
            autocompletion=completion,
            show_default=False,
        )
        annotation: Any = Annotated[cast(Any, _typed(declaration)) | None, information]
        return inspect.Parameter(
            self.key, inspect.Parameter.KEYWORD_ONLY, default=None, annotation=annotation
        )

    def value(self, given: object) -> object:
        """The value of what Typer read.

        Raises:
            InputError: it cannot be; the message names the option.
        """
        declaration = self.setting
        if isinstance(given, list):
            return _MAPPINGS[self.key](self.flag, given, declaration.example)
        if isinstance(given, str) and declaration.kind is tuple:
            if declaration.parts[0] is int:
                size = parse_size(given, self.flag)
                return size[0] if declaration.single and given.strip().isdigit() else size
            return parse_numbers(self.flag, given, len(declaration.parts), declaration.example)
        if isinstance(given, int | float) and math.isfinite(declaration.high):
            require_within(self.flag, given, declaration.low, declaration.high)
        return given


def takes(settings: type[Settings]) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """A decorator of commands: options of all settings in the place of the parameter `given: Given`.

    The command is handed the values of those that are given.
    """
    options = [*options_of_settings(settings)]

    def decorate(command: Callable[..., None]) -> Callable[..., None]:
        own = inspect.signature(command, eval_str=True)
        parameters = []
        for parameter in own.parameters.values():
            made = [option.parameter() for option in options]
            parameters += made if parameter.name == _PLACE else [_by_keyword(parameter)]

        @wraps(command)
        def run(**words: Any) -> None:
            given: Given = {}
            for option in options:
                word = words.pop(option.key)
                if word is not None:
                    _put(given, option.path, option.value(word))
            for name, values in given.items():
                kind = declared(settings)[name].kind
                if issubclass(kind, Settings):
                    given[name] = kind(**values)
            command(**words, given=given)

        described = cast(Any, run)
        del described.__wrapped__  # Typer would read the parameters of what is wrapped
        described.__signature__ = own.replace(parameters=parameters)
        described.__annotations__ = {each.name: each.annotation for each in parameters}
        return run

    return decorate


def options_of_settings(settings: type[Settings], path: tuple[str, ...] = ()) -> Iterator[SettingOption]:
    """The options of all settings, in their order; those of parts of settings in the place of the part."""
    for name, each in declared(settings).items():
        if issubclass(each.kind, Settings):
            yield from options_of_settings(each.kind, (*path, name))
        else:
            yield SettingOption((*path, name), each)


def _by_keyword(parameter: inspect.Parameter) -> inspect.Parameter:
    return parameter.replace(kind=inspect.Parameter.KEYWORD_ONLY)


def _put(given: Given, path: tuple[str, ...], value: object) -> None:
    *parents, name = path
    for parent in parents:
        given = given.setdefault(parent, {})
    given[name] = value


def _typed(declaration: Setting) -> Any:
    """What Typer reads: numbers, truth values and paths itself, all else as text."""
    if declaration.kind is Mapping:
        return list[str]
    if declaration.kind is os.PathLike:
        return Path
    return declaration.kind if declaration.kind in (int, float, bool) else str


def _completed_by(choices: tuple[str, ...]) -> Callable[[str], list[str]]:
    def complete(incomplete: str) -> list[str]:
        return [choice for choice in choices if choice.startswith(incomplete)]

    return complete


def _colours(flag: str, texts: list[str], example: str) -> dict[str, object]:
    """Colours by family: one, or a list in the order of threads."""
    del example
    # A comma before a part without a name goes on with the order of threads before it.
    parts = [part for text in texts for part in re.split(r",(?=[^,=]*=)", text)]
    found: dict[str, list[str]] = {}
    for part in parts:
        family, _, colours = part.partition("=")
        if not family.strip() or not colours.strip():
            raise InputError(
                f'{flag} "{part}" is not understood: write NAME=VALUE, such as warp=#223355, or an order '
                'of threads, such as "warp=20 #223355, 4 #eeeeee".'
            )
        found.setdefault(family.strip(), []).append(colours.strip())
    return {family: values[0] if len(values) == 1 else values for family, values in found.items()}


def _maps(flag: str, texts: list[str], example: str) -> dict[str, object]:
    """Maps by name: a picture, and behind it, with colons, fields of `[maps]` as TOML has them."""
    found: dict[str, object] = {}
    for text in texts:
        name, _, rest = (part.strip() for part in text.partition("="))
        picture, *fields = re.split(r":(?=[a-z_]+=)", rest)
        if not name or not picture:
            raise InputError(
                f'{flag} "{text}" is not understood: write NAME=PICTURE, such as {example}, and behind it '
                f"fields with colons, {example}:side=front:width_mm=400."
            )
        pairs = (field.split("=", 1) for field in fields)
        found[name] = {"picture": picture} | {key: _toml_value(value) for key, value in pairs}
    return found


def _toml_value(text: str) -> object:
    """A number, a truth value or a list as TOML has them; all else is text."""
    try:
        return tomllib.loads(f"value = {text}")["value"]
    except tomllib.TOMLDecodeError:
        return text


def _cloths(flag: str, texts: list[str], example: str) -> dict[str, object]:
    """Fabrics by name, each of which a turn may follow."""
    found: dict[str, object] = {}
    for text in texts:
        last = None
        for part in text.split(","):
            ((name, values),) = parse_named(flag, [part], example).items()
            if name == "turn" and last is not None:
                found[last] = Worn(found[last], parse_numbers(flag, values[-1], 1, f"{last}=…,turn=45")[0])
                last = None
            else:
                found[name], last = values[-1], name
    return found


# Settings of values by name, which texts write in ways of their own.
_MAPPINGS: dict[str, Callable[[str, list[str], str], Mapping[str, object]]] = {
    "colors": _colours,
    "cloths": _cloths,
    "maps": _maps,
}


# ----------------------------------------------------------------------------------------------------- values
# Values that are more than one number: sizes, directions, values by name; and ranges.

# A sample takes 170 bytes while it is computed, and a pass has at least one a pixel: 11 GB.
MAX_AREA = 2**26


def parse_size(text: str, option: str = "--size") -> tuple[int, int]:
    """Width and height in pixels from the text of `option`: "960x540", or "512" for a square.

    Raises:
        InputError: anything else, a side outside 1 to 16384, or more than 2²⁶ pixels in all.
    """
    match = re.fullmatch(r"\s*(\d{1,9})(?:\s*[xX×]\s*(\d{1,9}))?\s*", text)
    width, height = (int(match[1]), int(match[2] or match[1])) if match else (0, 0)
    if not (1 <= width <= MAX_SIDE and 1 <= height <= MAX_SIDE):
        raise InputError(
            f'{option} "{text}" is no size: write WIDTHxHEIGHT in pixels from 1 to {MAX_SIDE}, '
            "such as 960x540."
        )
    if width * height > MAX_AREA:
        millions = MAX_AREA // 10**6
        raise InputError(
            f'{option} "{text}" is too large: at most {millions} million pixels in all, such as 8192x8192.'
        )
    return width, height


def parse_numbers(option: str, text: str, count: int, example: str) -> tuple[float, ...]:
    """`count` finite numbers separated by commas.

    Raises:
        InputError: anything else; the message names `option` and gives `example`.
    """
    try:
        numbers = tuple(float(part) for part in text.split(","))
    except ValueError:
        numbers = ()
    if len(numbers) != count or not all(map(math.isfinite, numbers)):
        raise InputError(
            f'{option} "{text}" is not understood: write {count} numbers with commas, such as {example}.'
        )
    return numbers


def parse_named(option: str, texts: list[str], example: str) -> dict[str, list[str]]:
    """Values by name from texts such as "warp=#223,weft=#eee"; a name may come more than once.

    Raises:
        InputError: a part without a name or a value; the message names `option` and gives `example`.
    """
    found: dict[str, list[str]] = {}
    for text in texts:
        for part in text.split(","):
            name, _, value = (word.strip() for word in part.partition("="))
            if not name or not value:
                raise InputError(f'{option} "{text}" is not understood: write NAME=VALUE, such as {example}.')
            found.setdefault(name, []).append(value)
    return found


def require_within(option: str, value: float, low: float, high: float) -> None:
    """Raises InputError unless low ≤ value ≤ high; NaN is refused."""
    if not low <= value <= high:
        raise InputError(
            f"{option} {_shown(value)} is out of range: write a number from {_shown(low)} to {_shown(high)}."
        )


def _shown(value: float) -> str:
    return f"{value}" if isinstance(value, int) and abs(value) < 10**12 else f"{value:g}"


# ------------------------------------------------------------------------------------------------------- help

# Contexts and formatters have no type to name: Typer brings its own copy of Click or uses an installed one.
_FIRST_SENTENCE = re.compile(r"(?s)(.*?[.?!])(?:\s|$)")


class WholeSentences(TyperGroup):
    """A group of commands that lists each with its whole first sentence; Click ends them in three dots."""

    def format_commands(self, ctx: Any, formatter: Any) -> None:
        """Writes the commands and what they do."""
        rows = []
        for name in self.list_commands(ctx):
            command = self.get_command(ctx, name)
            text = " ".join((command.help or "").split()) if command is not None else ""
            match = _FIRST_SENTENCE.match(text)
            rows.append((name, match[1] if match else text))
        with formatter.section("Commands"):
            formatter.write_dl(rows)


class ListsModels(TyperCommand):
    """A command with a model among its options: its help ends with all models, a line each."""

    def format_epilog(self, ctx: Any, formatter: Any) -> None:
        """Writes the models, then the example."""
        # Imported here: help of other commands is there at once.
        from loomlight.models.registry import MODELS

        with formatter.section("Models"):
            formatter.write_dl([(name, entry.summary) for name, entry in MODELS.items()])
        super().format_epilog(ctx, formatter)


def _facts(each: Setting) -> tuple[str, str]:
    """Range and default, in words; empty where there is nothing to say."""
    return range_text(each), default_text(each, "default: {}")


class ListsOptions(ListsModels):
    """A command that bakes: its help says what `--set` takes, too."""

    def format_epilog(self, ctx: Any, formatter: Any) -> None:
        """Writes the options of every model that is installed, then what `ListsModels` writes."""
        from loomlight.models.registry import MODELS, is_installed, model_class

        rows = [
            (f"{model}: {name}", f"{each.help} [{'; '.join(filter(None, _facts(each)))}]")
            for model in filter(is_installed, MODELS)
            for name, each in declared(model_class(model).options_class).items()
        ]
        with formatter.section("Options of models, for --set"):
            formatter.write_dl(rows)
        super().format_epilog(ctx, formatter)
