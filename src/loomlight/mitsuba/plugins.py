"""Plugins exist in whichever supported variant is set, without choosing one for the user."""

from __future__ import annotations

from collections.abc import Callable
from threading import RLock
from typing import Any

import mitsuba as mi

from loomlight.mitsuba.integrator import footprint_path_class
from loomlight.mitsuba.variants import is_supported, require_backend
from loomlight.mitsuba.woven_lobes import woven_lobes_class
from loomlight.mitsuba.woven_neural import woven_neural_class
from loomlight.mitsuba.woven_point import woven_point_class

# Mitsuba's base classes differ from variant to variant, so a plugin is a function that makes its class.
_INTEGRATORS: dict[str, Callable[[], type]] = {"footprint_path": footprint_path_class}
_BSDFS: dict[str, Callable[[], type]] = {
    "woven_point": woven_point_class,
    "woven_lobes": woven_lobes_class,
    "woven_neural": woven_neural_class,
}

# Mitsuba makes the parts of a scene on several threads, and Dr.Jit's recordings are not made for that: a test
# hung within Dr.Jit. A thread that waits for a kernel may begin the next part: it may enter the lock again.
_MAKING = RLock()


def follow_variants() -> None:
    """Registers the plugins now if a supported variant is set, and again whenever the variant changes."""
    mi.detail.add_variant_callback(_on_variant)
    if mi.variant() is not None:
        _on_variant(None, mi.variant())


def _on_variant(_previous: str | None, variant: str | None) -> None:
    if variant is None or not is_supported(variant):
        return
    require_backend(variant)
    for name, make_class in _INTEGRATORS.items():
        mi.register_integrator(name, _constructor(make_class()))
    for name, make_class in _BSDFS.items():
        mi.register_bsdf(name, _constructor(make_class()))


def _constructor(plugin: type) -> Callable[[Any], Any]:
    def make(props: Any) -> Any:
        with _MAKING:
            return plugin(props)

    return make
