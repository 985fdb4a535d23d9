"""Settings, each declared once: type, range, default and a sentence, as a field of a frozen dataclass.

    @dataclass(frozen=True, kw_only=True)
    class Options(Settings):
        groups: int = setting(8, "Groups of yarn points of each family.", low=1, high=64)

From the declaration follow the checks of values that Python hands over (`Settings`), values read from text
(`Setting.value_of`), the options of the command line (`cli/options.py`), parameters of plugins, docstrings
and the tables of the documentation.
"""

from __future__ import annotations

import dataclasses
import math
import os
import types
import typing
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import cache
from numbers import Integral, Real
from typing import Any, ClassVar, Self, TypeVar

from loomlight.core.errors import InputError
from loomlight.core.sentences import closest, shown

_TRUTH = {"true": True, "false": False}
_DECLARATION = "setting"
_Class = TypeVar("_Class")
# Values that a `.loom` tells.
Stored = bool | int | float | str


@dataclass(frozen=True)
class Setting:
    """The declaration of a setting.

    Attributes:
        help: a sentence, or more: what it is, and its unit.
        low, high: bounds of a number, or of each number of a tuple; both allowed.
        choices: the values that it may have; empty if there are others.
        fits: whether a value of the right type and range is right.
        expected: what is right, the end of a sentence, where type, bounds and choices do not say it.
        otherwise: what None stands for, in words.
        flag: of the command line, where it is not made of the name; two with "/" between them for a bool.
        metavar: what stands for the value in help.
        example: of a text of several values, as the command line takes it.
        stored: whether a `.loom` tells it.
        single: whether one number may stand in the place of a tuple.
        name, default: of the field.
        kind: bool, int, float, str, os.PathLike, tuple, Mapping, `Settings` or another class: of a value that
            is not None.
        parts: types of a tuple.
    """

    help: str
    low: float = -math.inf
    high: float = math.inf
    choices: tuple[str, ...] = ()
    fits: Callable[[Any], bool] | None = None
    expected: str = ""
    otherwise: str = ""
    flag: str = ""
    metavar: str = ""
    example: str = ""
    stored: bool = False
    single: bool = False
    name: str = ""
    default: Any = None
    kind: type = str
    parts: tuple[type, ...] = ()

    @property
    def right(self) -> str:
        """What is right, the end of a sentence: "a whole number from 1 to 64"."""
        if self.expected:
            return self.expected
        if self.choices:
            return f"one of {', '.join(self.choices)}"
        if self.kind is bool:
            return "true or false"
        if self.kind is tuple:
            kind = f"{len(self.parts)} {'whole ' * (self.parts[0] is int)}numbers"
        else:
            kind = "a whole number" if self.kind is int else "a number"
        return kind + self.range

    @property
    def range(self) -> str:
        """The bounds, such as " from 1 to 64"; empty without any."""
        low = "" if self.low == -math.inf else f" from {number_text(self.low)}"
        high = "" if self.high == math.inf else f" to {number_text(self.high)}"
        return low + high

    def require(self, value: object) -> None:
        """Raises InputError unless the setting may have this value."""
        if value is None and self.default is None:
            return
        if self.choices and value not in self.choices:
            raise InputError(
                f"{self.name} = {shown(value)} does not exist: {closest(str(value), self.choices)}"
            )
        if not self._may_be(value):
            raise InputError(f"{self.name} = {shown(value)} is wrong: give {self.right}.")

    def value_of(self, text: str) -> object:
        """The value that a text denotes, checked; of other types than bool and numbers the text itself.

        Raises:
            InputError: no such value; the message names the setting.
        """
        if self.kind not in (bool, int, float):
            self.require(text)
            return text
        try:
            value = _TRUTH[text] if self.kind is bool else self.kind(text)
        except (KeyError, ValueError, OverflowError) as error:
            raise InputError(f"{self.name} = {shown(text)} is wrong: give {self.right}.") from error
        self.require(value)
        return value

    def _may_be(self, value: object) -> bool:
        if self.kind is tuple:
            is_one = self.single and self._is_number(value, self.parts[0])
            return is_one or self._may_be_numbers(value)
        if self.kind is Mapping or issubclass(self.kind, Settings):
            return isinstance(value, self.kind)
        if self.kind is bool:
            right = isinstance(value, bool)
        elif self.kind in (int, float):
            right = self._is_number(value, self.kind)
        else:
            right = True
        return right and (self.fits is None or self.fits(value))

    def _may_be_numbers(self, value: object) -> bool:
        try:
            numbers = [*typing.cast(Iterable[object], value)]
        except TypeError:
            return False
        return len(numbers) == len(self.parts) and all(map(self._is_number, numbers, self.parts))

    def _is_number(self, value: object, kind: type) -> bool:
        if not isinstance(value, Integral if kind is int else Real) or isinstance(value, bool):
            return False
        number = typing.cast(float, value)
        return self.low <= number <= self.high and math.isfinite(number)


def setting(default: Any, help: str, **declaration: Any) -> Any:
    """A field of `Settings`, as `dataclasses.field`.

    Args:
        default: a value, or a function of no arguments that makes one.
        help, declaration: see `Setting`.
    """
    metadata = {_DECLARATION: Setting(help, **declaration)}
    if callable(default):
        return field(default_factory=default, metadata=metadata)
    return field(default=default, metadata=metadata)


def same_setting(of: type[Settings], name: str, **changes: object) -> Any:
    """A field that is declared like that of other settings, but for `changes`."""
    found = dataclasses.replace(declared(of)[name], **typing.cast(dict[str, Any], changes))
    default = found.default
    metadata = {_DECLARATION: found}
    if isinstance(default, Settings | Mapping):
        return field(default_factory=lambda: default, metadata=metadata)
    return field(default=default, metadata=metadata)


class Settings:
    """A frozen dataclass of settings, which are checked when it is made.

    Attributes:
        title: what one of them is, for sentences: "setting of a picture".
    """

    title: ClassVar[str] = "setting"

    def __post_init__(self) -> None:
        """Raises InputError for the first value that cannot be."""
        for name, each in declared(type(self)).items():
            each.require(getattr(self, name))

    @classmethod
    def of(cls, values: Mapping[str, Any]) -> Self:
        """The settings with some given by name.

        Raises:
            InputError: a name that does not exist; the message names one like it. A value that cannot be.
        """
        require_names(cls, values)
        return cls(**values)

    def changed(self, **changes: object) -> Self:
        """The settings with others of these names; raises InputError as `of` does."""
        require_names(type(self), changes)
        return dataclasses.replace(typing.cast(Any, self), **changes)

    def chosen(self) -> dict[str, object]:
        """The settings that are not the defaults, by name."""
        values = {name: (getattr(self, name), each.default) for name, each in declared(type(self)).items()}
        return {name: value for name, (value, default) in values.items() if not _same(value, default)}

    def stored(self) -> dict[str, Stored]:
        """What a `.loom` tells of them, by name."""
        return {name: getattr(self, name) for name, each in declared(type(self)).items() if each.stored}


def _same(value: object, default: object) -> bool:
    try:
        return bool(value == default)
    except ValueError:  # of an array, which no default is
        return False


def require_names(cls: type[Settings], names: Iterable[str]) -> None:
    """Raises InputError unless there are settings of these names; the message names one like it."""
    known = declared(cls)
    for name in names:
        if name not in known:
            advice = f": {closest(name, known)}" if known else ", which has none."
            raise InputError(f"{shown(name)} is no {cls.title}{advice}")


def declared(cls: type[Settings]) -> dict[str, Setting]:
    """The settings of a class by name, in the order of its fields."""
    return _declared(typing.cast(Any, cls))


@cache
def _declared(cls: type) -> dict[str, Setting]:
    hints = typing.get_type_hints(cls)
    found = {}
    for each in dataclasses.fields(cls):
        made = each.default_factory
        default = each.default if made is dataclasses.MISSING else made()
        kind, parts = _type_of(hints[each.name])
        found[each.name] = dataclasses.replace(
            each.metadata[_DECLARATION], name=each.name, default=default, kind=kind, parts=parts
        )
    return found


def documented(cls: type[_Class]) -> type[_Class]:
    """A class decorator: the docstring ends with the settings and their sentences."""
    lines = [
        f"    {name}: {each.help}{default_text(each, ' By default {}.')}"
        for name, each in _declared(typing.cast(type, cls)).items()
    ]
    cls.__doc__ = "\n".join([f"{(cls.__doc__ or '').rstrip()}\n", "Attributes:", *lines, ""])
    return cls


def default_text(each: Setting, form: str = "{}") -> str:
    """The default in words, put into `form`; empty where there is nothing to say."""
    default = each.default
    if each.otherwise:
        text = each.otherwise
    elif default is None or isinstance(default, Mapping | Settings):
        return ""
    elif isinstance(default, bool):
        text = "true" if default else "false"
    elif isinstance(default, tuple):
        text = ("x" if each.parts[0] is int else ",").join(map(number_text, default))
    else:
        text = default if isinstance(default, str) else number_text(default)
    return form.format(text)


def range_text(each: Setting) -> str:
    """The values that a setting may have, in a few words: bounds, choices; empty for any."""
    if each.choices:
        return ", ".join(each.choices)
    if each.kind is bool:
        return "true, false"
    if each.low == -math.inf:
        return ""
    return f"{number_text(each.low)} – {number_text(each.high)}"


def number_text(number: float) -> str:
    """A number in words: powers of two and other whole numbers with all digits."""
    return f"{number:.0f}" if float(number).is_integer() and abs(number) < 10**12 else f"{number:g}"


def _type_of(hint: Any) -> tuple[type, tuple[type, ...]]:
    """The type of a value that is not None, and the types of a tuple's parts."""
    if typing.get_origin(hint) in (types.UnionType, typing.Union):
        kinds = [kind for kind in typing.get_args(hint) if kind is not type(None)]
        if any(typing.get_origin(kind) is os.PathLike or kind is os.PathLike for kind in kinds):
            return os.PathLike, ()
        return _type_of(kinds[0])
    origin = typing.get_origin(hint) or hint
    return origin, typing.get_args(hint) if origin is tuple else ()
