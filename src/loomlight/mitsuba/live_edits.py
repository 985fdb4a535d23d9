"""Edits of a BSDF's scene parameters are checked before anything follows them, and else taken back."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np

from loomlight.core.errors import InputError
from loomlight.models.interface import Parameter, Values


class LiveEdits:
    """The parameters of one BSDF, and their values as of the last edit that was right.

    Its slots keep these values out of `core.pytree.leaves`: no kernel reads them.

    Attributes:
        parameters: by name.
    """

    __slots__ = ("_kept", "parameters")

    def __init__(self, parameters: Values) -> None:
        self.parameters = parameters
        self._kept: dict[str, Any] = {}
        self.keep()

    def keep(self) -> None:
        """The present values are right."""
        self._kept = {name: _copy(parameter.value) for name, parameter in self.parameters.items()}

    def changed(self) -> frozenset[str]:
        """Names of the parameters that were edited since."""
        return frozenset(
            name
            for name, parameter in self.parameters.items()
            if not _same(parameter.value, self._kept[name])
        )

    def take_back(self) -> None:
        """Gives every parameter the value that was right."""
        for name in self.changed():
            mi.set_property(self.parameters[name].value, self._kept[name])

    def require_valid(self, cloth: str) -> None:
        """Checks the parameters that were edited since.

        Args:
            cloth: the name of the BSDF, for the message.

        Raises:
            InputError: numbers out of range, not finite, or of another count; derivatives of a parameter
                that has none. The message names parameter, value and range.
        """
        for name in self.changed():
            parameter = self.parameters[name]
            _require_valid(f"{cloth}.{name}", parameter, self._kept[name])
            if not parameter.differentiable and dr.grad_enabled(parameter.value):
                raise InputError(_without_derivatives(cloth, name, self.parameters))


def require_valid_edits(edits: Iterable[tuple[str, LiveEdits]]) -> None:
    """Checks the edits of several BSDFs, by name; of none is anything left where one of them is wrong.

    Raises:
        InputError: see `LiveEdits.require_valid`.
    """
    pending = list(edits)
    if dr.flag(dr.JitFlag.FreezingScope):
        # While a frozen function records, no array can be read.
        return
    try:
        for name, each in pending:
            each.require_valid(name)
    except InputError:
        for _, each in pending:
            each.take_back()
        raise


def _require_valid(name: str, parameter: Parameter, kept: Any) -> None:
    count, right = len(_numbers(kept)), _range(parameter)
    numbers = _numbers(parameter.value)
    if len(numbers) != count:
        raise InputError(f"{name} holds {len(numbers)} numbers: give {count}.")
    # In single precision, as they are kept, both bounds are allowed.
    low, high = np.float32(parameter.low), np.float32(parameter.high)
    wrong = ~(np.isfinite(numbers) & (numbers >= low) & (numbers <= high))
    if wrong.any():
        where = f"[{int(np.argmax(wrong))}]" if count > 3 else ""
        shown = ", ".join(f"{number:g}" for number in (numbers[wrong][:1] if where else numbers))
        raise InputError(f"{name}{where} = {shown} is wrong: give {right}.")


def _range(parameter: Parameter) -> str:
    """The expected value, the end of a sentence."""
    low, high = parameter.low, parameter.high
    if math.isinf(low) and math.isinf(high):
        return "a finite number"
    if math.isinf(high):
        return f"{low:g}{_unit(parameter)} or more"
    degrees = f", which is {math.degrees(low):.0f}° to {math.degrees(high):.0f}°"
    return f"{low:.4g} to {high:.4g}{_unit(parameter)}{degrees if parameter.unit == 'rad' else ''}"


def _unit(parameter: Parameter) -> str:
    return f" {parameter.unit}" if parameter.unit else ""


def _without_derivatives(cloth: str, name: str, parameters: Values) -> str:
    others = ", ".join(other for other, parameter in parameters.items() if parameter.differentiable)
    have = f"those that have some are {others}" if others else "no parameter of this model has"
    return f"{cloth}.{name} has no derivatives: {have}, and woven_point has more."


def _numbers(value: Any) -> np.ndarray:
    return np.array(dr.detach(value), np.float32).ravel()


def _copy(value: Any) -> Any:
    """Another array of the same variables."""
    return type(value)(value)


def _same(value: Any, other: Any) -> bool:
    """Whether two arrays are of the same variables, derivatives included."""
    if dr.depth_v(value) > 1:
        return len(value) == len(other) and all(map(_same, value, other))
    return bool(value.index == other.index and value.index_ad == other.index_ad)
