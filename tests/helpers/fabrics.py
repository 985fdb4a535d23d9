"""Fabrics that every model is tried on, and the cheapest bakes of their models."""

from __future__ import annotations

from typing import Any

from loomlight.fabric import Fabric, fabric_from_text

TEXTS = {
    "plain": 'weave = "plain"\ngap = 0.3',
    "coloured twill": """
        weave = "twill 3/1"
        [warp]
        color = ["#c02020", "#2040c0", "#e0e0d0"]
        [weft]
        color = "#806020"
        """,
    "translucent satin": """
        weave = "satin 5/2"
        [warp]
        translucency = 0.6
        roughness = 0.5
        [weft]
        translucency = 0.4
        """,
    "with sheen": """
        weave = "twill 2/2"
        [sheen]
        strength = 0.7
        roughness = 0.4
        """,
    "irregular": """
        weave = "plain"
        gap = 0.25
        [warp]
        yarn = "linen"
        melange = 0.2
        [weft]
        yarn = "woollen"
        neps = 30
        nep_color = "#a02010"
        [variation]
        irregularity = 1.5
        """,
}
# All the light that the energy bound admits is sent on, half of it to the far side.
WHITE = """
    weave = "twill 2/1"
    [warp]
    color = [1.0, 1.0, 1.0]
    translucency = 0.5
    [weft]
    color = [1.0, 1.0, 1.0]
    translucency = 0.5
    [sheen]
    strength = 0.5
    """


# Options of the cheapest bake, by model: what holds for all bakes holds for these.
CHEAPEST: dict[str, dict[str, Any]] = {
    "samples": {"points": 2},
    "clustered": {"clusters": 4, "texels": 32},
}


def fabric(name: str) -> Fabric:
    """A fabric of `TEXTS`."""
    return fabric_from_text(TEXTS[name])
