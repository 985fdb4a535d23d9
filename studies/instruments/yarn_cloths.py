"""A cloth of every kind of yarn: weave and colour are usual ones, all else is by `yarn = "…"`."""

from __future__ import annotations

from loomlight.fabric import Fabric, fabric_from_text
from loomlight.fabric.fields import YARNS
from loomlight.mitsuba import ClothScene, build_scene, material_bsdf
from loomlight.models.registry import make_model

# Kinds that have a gap of their own.
OF_GAPS = ("cotton", "linen", "wool", "silk", "filament polyester", "viscose")
CLOTHS = {
    "smooth": ("plain", "#b9ab92", "#b9ab92"),
    "cotton": ("plain", "#ddd6c6", "#ddd6c6"),
    "mercerised cotton": ("plain", "#2c5f94", "#2c5f94"),
    "linen": ("plain", "#c9ba98", "#bfae8a"),
    "wool": ("twill 2/2", "#70757d", "#a06a41"),
    "silk": ("satin 5/2", "#93263a", "#93263a"),
    "filament polyester": ("plain", "#44627f", "#44627f"),
    "viscose": ("twill 2/1", "#4d6f4b", "#4d6f4b"),
}
# What fibres absorb over what deep hair of the yarn's albedo does, linear RGB: their cloth shows our colour.
# `python -m studies accuracy/fibre_truth --fit` finds it.
ABSORPTION = {
    "cotton": (1.28, 3.42, 2.75),
    "linen": (3.42, 2.63, 1.91),
    "wool": (1.38, 1.43, 1.33),
    "silk": (2.22, 3.0, 2.94),
    "filament polyester": (1.76, 1.56, 1.49),
    "viscose": (1.77, 1.57, 1.8),
}


def cloth(name: str, more: str = "") -> Fabric:
    """The cloth of a kind of yarn; `more` are fields."""
    weave, warp, weft = CLOTHS[name]
    kind = f'yarn = "{name}"\n' if name in YARNS else ""
    return fabric_from_text(
        f'weave = "{weave}"\n{kind}{more}\n[warp]\ncolor = "{warp}"\n[weft]\ncolor = "{weft}"\n'
    )


def flat_scene(fabric: Fabric, side: int, threads: float) -> ClothScene:
    """The flat scene, of which a picture of `side` pixels a side shows `threads` threads."""
    spacing = float(fabric.layout().warp.spacing[0])
    return build_scene(
        "flat",
        material_bsdf(make_model("point", fabric)),
        size=(side, side),
        # The flat scene is 100 mm wide.
        zoom=100 / (spacing * threads),
    )
