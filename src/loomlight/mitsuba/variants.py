"""Mitsuba as it runs: the variant, checked before anything is compiled; whose turn it is; its messages."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import wraps
from threading import RLock
from typing import ParamSpec, TypeVar

import drjit as dr
import mitsuba as mi

from loomlight.core.errors import InputError, MissingDependencyError
from loomlight.core.llvm import require_llvm

DEFAULT_VARIANT = "llvm_ad_rgb"
SUPPORTED_VARIANTS = ("llvm_ad_rgb", "cuda_ad_rgb")
# Mitsuba makes the parts of a scene on several threads, and users render on several. Dr.Jit's recordings are
# not made for that: it hung or crashed (version 1.5), with Mitsuba's own BSDFs too. A thread that waits for a
# kernel may begin the next part of its scene: it may enter the lock again.
TURN = RLock()
_Parameters = ParamSpec("_Parameters")
_Result = TypeVar("_Result")


def in_turn(function: Callable[_Parameters, _Result]) -> Callable[_Parameters, _Result]:
    """The function, called by one thread at a time, and by none while another makes a BSDF."""

    @wraps(function)
    def waits(*arguments: _Parameters.args, **options: _Parameters.kwargs) -> _Result:
        with TURN:
            return function(*arguments, **options)

    return waits


def choose_variant(name: str | None = None) -> str:
    """Sets a Mitsuba variant and returns its name.

    Without `name` a supported variant that is already set stays; otherwise it becomes llvm_ad_rgb.

    Raises:
        InputError: `name` is none of the supported variants, or this Mitsuba was built without it.
        MissingDependencyError: no usable LLVM library, or no usable CUDA device.
    """
    current = mi.variant()
    chosen = (current if current in SUPPORTED_VARIANTS else DEFAULT_VARIANT) if name is None else name
    if chosen not in SUPPORTED_VARIANTS:
        raise InputError(f'variant = "{chosen}" is not supported: use {" or ".join(SUPPORTED_VARIANTS)}.')
    if chosen not in mi.variants():
        raise InputError(f'variant = "{chosen}" is missing from this Mitsuba, which has {mi.variants()}.')
    require_backend(chosen)
    if chosen != current:
        mi.set_variant(chosen)
    return chosen


def require_backend(variant: str) -> None:
    """Raises MissingDependencyError unless kernels of `variant` can be compiled here."""
    if variant.startswith("llvm"):
        require_llvm()
    elif not dr.has_backend(dr.JitBackend.CUDA):
        raise MissingDependencyError(
            f'variant = "{variant}" needs an NVIDIA GPU and its driver, and none was found: use llvm_ad_rgb.'
        )


# --------------------------------------------------------------------------------------------------- messages
# Messages of Mitsuba, as the end of a sentence for a person.


# "[parser.cpp:1718] At dictionary node …: [OBJMesh] what went wrong": only the last part is about the file.
_ORIGIN = re.compile(r".*\[[\w.:]+\] ")
# A sentence of ours, as the last line of a plugin's traceback.
_OURS = re.compile(r"^(?:\w+\.)*InputError: ")
# Mitsuba lists what it does not know below its sentence, an entry a line.
_ENTRY = "- "
# What Mitsuba's mesh readers stumble over when a file has no faces.
_NO_FACES = "Storing new normals in a Mesh"


def reason_of(error: Exception) -> str:
    """The last sentence of the message of `error`, without where in the library it was raised."""
    lines = [line.strip() for line in str(error).splitlines() if line.strip()]
    entries: list[str] = []
    while len(lines) > 1 and lines[-1].startswith(_ENTRY):
        entries.insert(0, lines.pop().removeprefix(_ENTRY))
    text = _OURS.sub("", _ORIGIN.sub("", lines[-1])) if lines else ""
    if entries:
        return f"{text} {', '.join(entries)}"
    if text.startswith(_NO_FACES):
        return "it holds no triangles."
    return text if " " in text else f"{type(error).__name__} {text}".strip()
