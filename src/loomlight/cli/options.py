"""Options of commands: made of declared settings (`core/settings.py`), and those that commands share."""

from __future__ import annotations

import inspect
import math
import os
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import wraps
from pathlib import Path
from typing import Annotated, Any, cast

import typer

from loomlight.cli.values import parse_named, parse_numbers, parse_size, require_within
from loomlight.core.errors import InputError
from loomlight.core.settings import Setting, Settings, declared, default_text

FabricsArgument = Annotated[
    list[str],
    typer.Argument(metavar="FABRIC...", help="Fabric files, drafts, .loom files, or weaves' names."),
]
FabricArgument = Annotated[
    str, typer.Argument(metavar="FABRIC", help="A fabric file, a draft, a .loom, or a weave's name.")
]

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


def _last_named(flag: str, texts: list[str], example: str) -> dict[str, str]:
    return {name: values[-1] for name, values in parse_named(flag, texts, example).items()}


# Settings of values by name, which texts write in ways of their own.
_MAPPINGS: dict[str, Callable[[str, list[str], str], Mapping[str, object]]] = {
    "colors": _colours,
    "cloths": _last_named,
}
