"""Cards of fabrics for a contact sheet: drawdown, swatch, drape and facts."""

from __future__ import annotations

import os

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from loomlight.assets.load import fabric_of_path
from loomlight.core.contact_sheet import Card
from loomlight.core.images import encoded
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.facts import cloth_facts
from loomlight.mitsuba.material import material_bsdf
from loomlight.mitsuba.rendering import render
from loomlight.mitsuba.scenes import build_scene
from loomlight.models.registry import make_model
from loomlight.weave.draft import Draft
from loomlight.weave.drawing import draw_drawdown

# Millimetres of cloth across a swatch, the same for all, so that they compare; the flat scene has 100.
SWATCH_MM, _FLAT_MM = 25.0, 100.0
# Threads across a drawdown: more cannot be told apart.
_MOST_THREADS = 48
Pixels = NDArray[np.uint8]


def fabric_card(path: str | os.PathLike[str], side: int, *, model: str, spp: int) -> Card:
    """The card of a fabric file, a draft, a `.loom` or a weave's name; a variant must be set.

    Args:
        side: of each picture, pixels.
        model: by which it is rendered.
        spp: samples a pixel.

    Raises:
        InputError: no fabric, or one that the model cannot handle.
    """
    fabric = fabric_of_path(path)
    made = make_model(model, fabric)

    def picture(scene: str, zoom: float) -> Pixels:
        shown = build_scene(scene, material_bsdf(made), size=(side, side), zoom=zoom)
        return encoded(render(shown.scene, spp=spp, integrator=shown.integrator))

    pictures = {
        "drawdown": _drawdown(fabric.draft, side),
        f"{SWATCH_MM:g} mm of it": picture("flat", _FLAT_MM / SWATCH_MM),
        "draped": picture("drape", 1.0),
    }
    return Card(fabric.name, fact_lines(fabric), pictures)


def fact_lines(fabric: Fabric) -> list[str]:
    """What a card says: structure, sett, cover, weight."""
    facts, draft = cloth_facts(fabric), fabric.named_draft
    width, height = fabric.repeat_mm
    weave = fabric.fields.weave or draft.title or "draft"
    about = "about" if facts.counted else "at most"
    return [
        f"{weave}; {draft.ends} ends and {draft.picks} picks, {width:.3g} × {height:.3g} mm a repeat",
        f"{facts.warp.per_cm:.3g} ends/cm of {facts.warp.tex:.3g} tex, "
        f"{facts.weft.per_cm:.3g} picks/cm of {facts.weft.tex:.3g} tex",
        f"covers {100 * facts.cover:.0f} %, {about} {facts.weight:.0f} g/m², "
        f"{facts.thickness_mm:.2g} mm thick",
    ]


def _drawdown(draft: Draft, side: int) -> Pixels:
    """The drawdown, repeated until it fills the square, or the first part of a large one."""
    threads = min(max(draft.ends, draft.picks, 12), _MOST_THREADS)
    repeats = -(-threads // min(draft.ends, draft.picks))
    cell = max(side // threads, 1)
    drawn = draw_drawdown(draft, cell_px=cell, repeats=min(repeats, _MOST_THREADS))
    shown = drawn[-threads * cell :, : threads * cell]
    return np.asarray(Image.fromarray(shown).resize((side, side), Image.Resampling.LANCZOS))
