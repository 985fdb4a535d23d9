"""The fabrics that the figures show: the paper's patterns in plain colours.

The paper gives neither their parameters nor their colours. Inclination and twist are what fabric files take
for the weave by default; gap, blend and optical depth are the paper's.
"""

from __future__ import annotations

from dataclasses import dataclass

from loomlight.fabric.fabric import Fabric, make_fabric
from loomlight.fabric.file import FabricFile, YarnTable
from loomlight.models.woven.box import PAPER_WEAVES, PARAMETER_BOX, paper_draft
from loomlight.weave.draft import Draft
from loomlight.weave.named import named_weave


@dataclass(frozen=True)
class Look:
    """How a fabric of a figure looks.

    Attributes:
        colours: of warp and weft, "#rrggbb".
        roughness: α of warp and weft.
        height_scale: β of warp and weft.
        translucency: share of the light that threads scatter to the other side.
    """

    colours: tuple[str, str]
    roughness: tuple[float, float] = (0.3, 0.3)
    height_scale: tuple[float, float] = (0.6, 0.6)
    translucency: float = 0.0


_SEEN = {
    "plain": Look(("#b5452f", "#e6d9bd"), (0.35, 0.5), (0.7, 0.7)),
    "twill 3×3": Look(("#2b4a86", "#e8e4d8"), (0.3, 0.4), (0.6, 0.8)),
    "twill 5×5": Look(("#3f6b3a", "#cfc38a"), (0.25, 0.35), (0.6, 0.6)),
    "twill 8×8": Look(("#4a4a50", "#c9c4bb"), (0.4, 0.3), (0.8, 0.5)),
    "satin 5×5": Look(("#b58a2e", "#8c5a1d"), (0.15, 0.3), (0.5, 0.5)),
    "satin 8×8": Look(("#7a2447", "#4d1730"), (0.2, 0.4), (0.4, 0.6)),
    "satin 5×10": Look(("#2f7f86", "#d6e2df"), (0.2, 0.25), (0.5, 0.7)),
}
# A twill of 4 × 4 threads, and what weavers call 4/4; both are held out of every training.
_UNSEEN = {
    "twill 4×4": ("twill 2/2", Look(("#2b4a86", "#e8e4d8"), (0.3, 0.4), (0.6, 0.8))),
    "twill 4/4": ("twill 4/4", Look(("#6b3a3a", "#d9cdb8"), (0.25, 0.35), (0.6, 0.6))),
}


def seen_fabrics() -> list[Fabric]:
    """The paper's seven patterns, which training has seen; not with these parameters."""
    return [woven_as(name, paper_draft(name), look) for name, look in _SEEN.items()]


def unseen_fabrics() -> list[Fabric]:
    """Twills that no training has seen."""
    return [woven_as(name, named_weave(weave), look) for name, (weave, look) in _UNSEEN.items()]


def pattern(name: str, look: Look) -> Fabric:
    """One of the paper's seven patterns."""
    return woven_as(name, paper_draft(name), look)


def woven_as(name: str, draft: Draft, look: Look) -> Fabric:
    """A fabric of a draft."""
    tables = [
        YarnTable(
            color=look.colours[family],
            roughness=look.roughness[family],
            height_scale=look.height_scale[family],
            translucency=look.translucency,
        )
        for family in range(2)
    ]
    weave = PAPER_WEAVES.get(name, name)
    fields = FabricFile(
        weave=None if weave == "satin 5×10" else weave,
        diffuse_blend=PARAMETER_BOX.diffuse_blend,
        optical_depth=PARAMETER_BOX.optical_depth,
        warp=tables[0],
        weft=tables[1],
    )
    return make_fabric(fields, draft, name, ".")
