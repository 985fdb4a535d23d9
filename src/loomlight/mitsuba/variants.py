"""Which Mitsuba variant is set: chosen by the user, checked before anything is compiled."""

from __future__ import annotations

import drjit as dr
import mitsuba as mi

from loomlight.core.errors import InputError, MissingDependencyError
from loomlight.core.llvm import require_llvm

DEFAULT_VARIANT = "llvm_ad_rgb"
SUPPORTED_VARIANTS = ("llvm_ad_rgb", "cuda_ad_rgb")


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
