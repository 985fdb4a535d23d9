"""loomlight: from a weave draft to a picture you would believe.

The public names are loaded when they are first used: importing the package needs neither Dr.Jit nor a
renderer. `import loomlight.mitsuba` registers the Mitsuba plugins.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from loomlight.capturing.capture import capture
    from loomlight.core.errors import (
        InputError,
        LoomlightError,
        LoomlightWarning,
        MissingDependencyError,
    )
    from loomlight.core.picture_settings import RenderSettings
    from loomlight.evaluation.compare import compare
    from loomlight.exporters.exporter import export
    from loomlight.fabric.fabric import Fabric
    from loomlight.fabric.read import fabric_from_text, load_fabric
    from loomlight.mitsuba.moving import render_frames
    from loomlight.mitsuba.pictures import render
    from loomlight.mitsuba.swatches import swatches
    from loomlight.models.bake import bake, bake_maps, load, save
    from loomlight.models.registry import make_model, model_from_loom
    from loomlight.scattering.appearance import Appearance
    from loomlight.viewer.notebook import view
    from loomlight.viewer.server import edit
    from loomlight.weave.draft import Draft
    from loomlight.weave.load import load_draft
    from loomlight.weave.named import named_weave, weave_names
    from loomlight.weave.wif_reader import read_wif
    from loomlight.weave.wif_writer import write_wif
    from loomlight.window import play
    from loomlight.yarn.layout import ClothLayout

__version__ = "0.1.0"

_HOMES = {
    "Appearance": "loomlight.scattering.appearance",
    "ClothLayout": "loomlight.yarn.layout",
    "Draft": "loomlight.weave.draft",
    "Fabric": "loomlight.fabric.fabric",
    "InputError": "loomlight.core.errors",
    "LoomlightError": "loomlight.core.errors",
    "LoomlightWarning": "loomlight.core.errors",
    "MissingDependencyError": "loomlight.core.errors",
    "RenderSettings": "loomlight.core.picture_settings",
    "bake": "loomlight.models.bake",
    "bake_maps": "loomlight.models.bake",
    "capture": "loomlight.capturing.capture",
    "compare": "loomlight.evaluation.compare",
    "edit": "loomlight.viewer.server",
    "export": "loomlight.exporters.exporter",
    "fabric_from_text": "loomlight.fabric.read",
    "load": "loomlight.models.bake",
    "load_draft": "loomlight.weave.load",
    "load_fabric": "loomlight.fabric.read",
    "make_model": "loomlight.models.registry",
    "model_from_loom": "loomlight.models.registry",
    "named_weave": "loomlight.weave.named",
    "play": "loomlight.window",
    "read_wif": "loomlight.weave.wif_reader",
    "render": "loomlight.mitsuba.pictures",
    "render_frames": "loomlight.mitsuba.moving",
    "save": "loomlight.models.bake",
    "swatches": "loomlight.mitsuba.swatches",
    "view": "loomlight.viewer.notebook",
    "weave_names": "loomlight.weave.named",
    "write_wif": "loomlight.weave.wif_writer",
}

__all__ = [
    "Appearance",
    "ClothLayout",
    "Draft",
    "Fabric",
    "InputError",
    "LoomlightError",
    "LoomlightWarning",
    "MissingDependencyError",
    "RenderSettings",
    "bake",
    "bake_maps",
    "capture",
    "compare",
    "edit",
    "export",
    "fabric_from_text",
    "load",
    "load_draft",
    "load_fabric",
    "make_model",
    "model_from_loom",
    "named_weave",
    "play",
    "read_wif",
    "render",
    "render_frames",
    "save",
    "swatches",
    "view",
    "weave_names",
    "write_wif",
]


def __getattr__(name: str) -> Any:
    home = _HOMES.get(name)
    if home is None:
        raise AttributeError(f"module 'loomlight' has no attribute '{name}'")
    value = getattr(import_module(home), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
