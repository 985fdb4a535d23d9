"""Options of models as text, such as "resolution=128" on a command line."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from numbers import Integral, Real
from typing import Any

from loomlight.assets.load import load_source
from loomlight.assets.sources import Source
from loomlight.core.errors import InputError
from loomlight.fabric.sentences import closest, shown
from loomlight.models.interface import Option
from loomlight.models.registry import model_class

_TRUTH = {"true": True, "false": False}


def parse_options(model: str, texts: Iterable[str]) -> dict[str, Any]:
    """The options of a model by name, of texts "name=value".

    Raises:
        InputError: no such model or option, or a value that the option does not take.
    """
    kind = model_class(model)
    known = {option.name: option for option in kind.options}
    found: dict[str, Any] = {}
    for text in texts:
        name, equals, value = text.partition("=")
        if not equals:
            raise InputError(f'{shown(text)} is no option: write its name, "=" and its value.')
        require_options(model, [name])
        found[name] = _value(known[name], value, kind.source_kind)
    return found


def require_options(model: str, names: Iterable[str]) -> None:
    """Raises InputError unless a model has options of these names; the message names one like it."""
    known = [option.name for option in model_class(model).options]
    for name in names:
        if name not in known:
            advice = f": {closest(name, known)}" if known else ", which has none."
            raise InputError(f"{shown(name)} is no option of {model}{advice}")


def require_values(model: str, options: Mapping[str, Any]) -> None:
    """Raises InputError unless a model has these options, and numbers and truth values where they belong.

    None stands for a default.
    """
    require_options(model, options)
    for option in model_class(model).options:
        value = options.get(option.name)
        if value is None or option.type not in (bool, int, float):
            continue
        kinds = {bool: bool, int: Integral, float: Real}[option.type]
        fits = isinstance(value, kinds) and isinstance(value, bool) == (option.type is bool)
        if not fits or not option.low <= value <= option.high:  # nor is NaN
            raise InputError(f"{option.name} = {value!r} is wrong: give {option.expected}.")


def _value(option: Option, text: str, source_kind: str) -> Any:
    if option.type is Source:
        return load_source(text, source_kind)
    if option.type is str:
        return text
    wrong = InputError(f"{option.name} = {shown(text)} is wrong: give {option.expected}.")
    if option.type is bool:
        if text not in _TRUTH:
            raise wrong
        return _TRUTH[text]
    try:
        number = option.type(text)
    except (ValueError, OverflowError) as error:
        raise wrong from error
    if not math.isfinite(number) or not option.low <= number <= option.high:
        raise wrong
    return number
