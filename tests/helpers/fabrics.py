"""Fabrics that models are tried on, and the cheapest bakes of their models."""

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
        specular_grazing = 3.0
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
# With all that answers of a BSDF share: holes, sheen, light between yarns, threads of several colours, and
# highlights that rise towards grazing.
EVERYTHING = """
    weave = "satin 5/2"
    gap = 0.2
    interreflection = true
    [warp]
    color = ["#e0c060", "#80a0c0"]
    translucency = 0.2
    specular_grazing = 4.0
    [weft]
    color = "#f0f0f0"
    [sheen]
    strength = 0.3
    """
_DETAIL = "plies = 2\nfibre_tilt_deg = 12\nslub = 0.5\nhairiness = 1\n"
SMOOTH = 'weave = "twill 2/2"\ngap = 0.1\n'
# The same whose plies, fibres and hairs show close up.
DETAILED = f"{SMOOTH}[warp]\n{_DETAIL}[weft]\n{_DETAIL}"
# That stress tables of groups.
STRESSING = {
    # Holes.
    "open plain": 'weave = "plain"\ngap = 0.4',
    # Narrow highlights; each face shows little of one family.
    "smooth satin": """
        weave = "satin 8/3"
        [warp]
        roughness = 0.1
        twist_deg = -30.0
        [weft]
        roughness = 0.3
        """,
    # Light from the other side, families unlike each other.
    "translucent twill": """
        weave = "twill 2/1"
        diffuse_blend = 0.8
        optical_depth = 1.2
        [warp]
        translucency = 0.6
        roughness = 0.6
        height_scale = 0.5
        [weft]
        translucency = 0.3
        inclination_deg = 35.0
        """,
    # A repeat that is longer than wide.
    "long rib": 'weave = "warp rib 3/3"\nends_per_cm = 30.0\npicks_per_cm = 12.0',
}
CLOTHS = {**TEXTS, **STRESSING, "white": WHITE, "everything": EVERYTHING, "detailed": DETAILED}
# Options of the cheapest bake, by model: what holds for all bakes holds for these.
CHEAPEST: dict[str, dict[str, Any]] = {"clustered": {"clusters": 4, "texels": 32}}


def fabric(name: str) -> Fabric:
    """A fabric of `TEXTS`."""
    return fabric_from_text(TEXTS[name])
