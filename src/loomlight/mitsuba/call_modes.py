"""Modes in which Dr.Jit traces the calls of a BSDF, and what is looked at while it does."""

from __future__ import annotations

import functools
import warnings
from collections.abc import Callable
from typing import Any, TypeVar

import drjit as dr
import mitsuba as mi

from loomlight.core.errors import LoomlightWarning

_Method = TypeVar("_Method", bound=Callable[..., Any])
_LOOPS = dr.JitFlag.SymbolicLoops
_BRANCHES = dr.JitFlag.SymbolicConditionals
# BSDFs already warned about, and other warnings already given.
_WARNED: set[str] = set()


def nested(method: _Method) -> _Method:
    """A method of a BSDF whose loops are symbolic within a symbolic call.

    Integrators that differentiate by automatic differentiation evaluate loops, but calls of BSDFs stay
    symbolic. Dr.Jit then makes every loop within them symbolic too, and prints a warning for each.
    """

    @functools.wraps(method)
    def call(*arguments: Any, **named: Any) -> Any:
        if not dr.flag(dr.JitFlag.SymbolicScope):
            return method(*arguments, **named)
        with dr.scoped_set_flag(_LOOPS, True), dr.scoped_set_flag(_BRANCHES, True):
            return method(*arguments, **named)

    # A type checker cannot see that `wraps` keeps the signature.
    return call  # type: ignore[return-value]


def warn_of_slow_calls(plugin: str) -> None:
    """Warns once that a BSDF with a network is traced in symbolic calls.

    Args:
        plugin: the name of the BSDF.
    """
    # Evaluated calls are traced symbolically too, once, for the types of what they return.
    if plugin in _WARNED or not (dr.flag(dr.JitFlag.SymbolicScope) and dr.flag(dr.JitFlag.SymbolicCalls)):
        return
    _WARNED.add(plugin)
    warnings.warn(
        f"{plugin} takes some 30 times as long in symbolic calls, which this integrator makes: render with "
        "footprint_path, or switch off dr.JitFlag.SymbolicCalls and dr.JitFlag.SymbolicLoops.",
        LoomlightWarning,
        stacklevel=2,
    )


def warn_of_light_paths(ctx: mi.BSDFContext, plugin: str) -> None:
    """Warns once of an integrator that traces paths from lights.

    Mean reflection is reciprocal within some per cent, transmission is not: a model's footprint, and the path
    that light takes through yarns, are those of the view.
    """
    if ctx.mode != mi.TransportMode.Importance or "light paths" in _WARNED:
        return
    _WARNED.add("light paths")
    warnings.warn(
        f"{plugin} is made for paths that begin at the camera: from lights, cloth that lets light through is "
        "up to 1.8 times too bright or dark. Render with footprint_path or path.",
        LoomlightWarning,
        stacklevel=2,
    )


def warn_of_missing_uv(bsdf: mi.BSDF, si: mi.SurfaceInteraction3f) -> None:
    """Warns of every mesh with this BSDF that has no uv coordinates.

    Mitsuba hands out the barycentric coordinates of each triangle for uv then. A BSDF does not know its
    shapes, but a call of all shapes, which Dr.Jit traces once for each, does; it computes nothing.
    """
    told: set[str] = set()

    def look(shape: Any, _: Any) -> None:
        if shape is None or not shape.is_mesh() or shape.bsdf() is not bsdf:
            return
        name = str(shape.id())
        # Shapes that Mitsuba computes, such as rectangles, count as meshes too and have uv.
        uv = [value for key, value in mi.traverse(shape) if key.endswith("texcoords")]
        if name in told or not uv or dr.width(uv) > 0:
            return
        told.add(name)
        # Mitsuba merges meshes that share a BSDF, and the merged one has no name.
        what = f'The mesh "{name}"' if name else "A mesh"
        warnings.warn(
            f"{what} has no uv coordinates: every triangle shows the same corner of the cloth. Unwrap it.",
            LoomlightWarning,
            stacklevel=2,
        )

    dr.dispatch(si.shape, look, mi.UInt32(0))
