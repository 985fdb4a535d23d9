"""The fabrics that the figures show: the paper's patterns in plain colours.

The paper gives neither their parameters nor their colours. Inclination and twist are what fabric files take
for the weave by default; gap, blend and optical depth are the paper's.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from loomlight.fabric import fabric_from_text
from loomlight.fabric.fabric import Fabric
from loomlight.models.neural.weights import PARAMETER_RANGES
from studies.papers.chen2024.training.weaves import PAPER_WEAVES

# The one pattern of the paper that is no named weave.
_DRAFTS = {"satin 5×10": "satin-5x10.wif"}


@dataclass(frozen=True)
class Look:
    """Appearance parameters of a fabric of a figure.

    Attributes:
        colours: of warp and weft, "#rrggbb".
        roughness: α of warp and weft.
        height_scale: β of warp and weft.
        translucency: fraction of the light that threads scatter to the other side.
        specular: fraction of the albedo that is specular.
    """

    colours: tuple[str, str] = ("#ffffff", "#ffffff")
    roughness: tuple[float, float] = (0.3, 0.3)
    height_scale: tuple[float, float] = (0.6, 0.6)
    translucency: float = 0.0
    specular: float = 0.4


SEEN = {
    "plain": Look(("#b5452f", "#e6d9bd"), (0.35, 0.5), (0.7, 0.7)),
    "twill 3×3": Look(("#2b4a86", "#e8e4d8"), (0.3, 0.4), (0.6, 0.8)),
    "twill 5×5": Look(("#3f6b3a", "#cfc38a"), (0.25, 0.35), (0.6, 0.6)),
    "twill 8×8": Look(("#4a4a50", "#c9c4bb"), (0.4, 0.3), (0.8, 0.5)),
    "satin 5×5": Look(("#b58a2e", "#8c5a1d"), (0.15, 0.3), (0.5, 0.5)),
    "satin 8×8": Look(("#7a2447", "#4d1730"), (0.2, 0.4), (0.4, 0.6)),
    "satin 5×10": Look(("#2f7f86", "#d6e2df"), (0.2, 0.25), (0.5, 0.7)),
}
# In the paper's notation, twill 4×4 has a repeat of 4 × 4 threads; in weavers' notation, 4/4 is over four,
# under four. Both are excluded from every training.
UNSEEN = {
    "twill 4×4": ("twill 2/2", Look(("#2b4a86", "#e8e4d8"), (0.3, 0.4), (0.6, 0.8))),
    "twill 4/4": ("twill 4/4", Look(("#6b3a3a", "#d9cdb8"), (0.25, 0.35), (0.6, 0.6))),
}


def seen_fabrics() -> list[Fabric]:
    """The paper's seven patterns, which are in the training set with other parameters."""
    return [pattern_fabric(name) for name in SEEN]


def unseen_fabrics() -> list[Fabric]:
    """Twills that are in no training set."""
    return [pattern_fabric(name) for name in UNSEEN]


def pattern_fabric(name: str) -> Fabric:
    """A fabric of `SEEN` or `UNSEEN`, in its own colours."""
    return fabric_of(name, *UNSEEN[name]) if name in UNSEEN else paper_fabric(name)


def paper_fabric(name: str, look: Look | None = None) -> Fabric:
    """One of the paper's seven patterns, in its own colours unless a look is given."""
    return fabric_of(name, PAPER_WEAVES[name], SEEN[name] if look is None else look)


def fabric_of(name: str, weave: str, look: Look) -> Fabric:
    """A fabric of a weave's name, or of the paper's satin 5×10."""
    source = f'draft = "{_DRAFTS[weave]}"' if weave in _DRAFTS else f'weave = "{weave}"'
    tables = [
        f"[{family}]\n"
        f'color = "{look.colours[number]}"\n'
        f"roughness = {look.roughness[number]}\n"
        f"height_scale = {look.height_scale[number]}\n"
        f"translucency = {look.translucency}\nspecular = {look.specular}\n"
        for number, family in enumerate(("warp", "weft"))
    ]
    text = (
        f'name = "{name}"\n{source}\ninterreflection = false\n'
        f"diffuse_blend = {PARAMETER_RANGES.diffuse_blend}\n"
        f"optical_depth = {PARAMETER_RANGES.optical_depth}\n"
    )
    return fabric_from_text(text + "".join(tables), str(Path(__file__).parent))
