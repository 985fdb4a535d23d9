"""Textile facts of cloth: cover, yarn, crimp, weight, thickness, by Peirce's geometry of round yarns.

The rendered surface has heights of its own, chosen for how yarns look (see docs/drafts.md); these are the
numbers that a weaver would measure.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from loomlight.fabric.fabric import Fabric
from loomlight.fabric.resolve import ResolvedFamily
from loomlight.weave.textile import per_inch, tex_of_diameter, yarn_diameter_mm, yarn_tex

# Yarn cannot be longer than that over the cloth: jammed plain weaves have crimps up to .3.
_MAX_CRIMP = 0.5


@dataclass(frozen=True)
class FamilyFacts:
    """One family of threads.

    Attributes:
        per_cm: mean threads per centimetre.
        tex: mean linear density of a yarn, g/km.
        cover: share of the cloth's side that its threads cover, as rendered.
        crimp: how much longer its yarn is than the cloth, as a share.
    """

    per_cm: float
    tex: float
    cover: float
    crimp: float


@dataclass(frozen=True)
class ClothFacts:
    """A whole cloth.

    Attributes:
        warp: of the ends.
        weft: of the picks.
        cover: share of the area that yarn covers, as rendered.
        weight: g/m².
        thickness_mm: millimetres.
        counted: whether the file gives both counts. Otherwise yarns are taken as round, and as those of
            dense cloth are pressed flat, weight and thickness are upper bounds.
    """

    warp: FamilyFacts
    weft: FamilyFacts
    cover: float
    weight: float
    thickness_mm: float
    counted: bool


def cloth_facts(fabric: Fabric) -> ClothFacts:
    """Cover, yarn, crimp, weight and thickness of a fabric.

    A yarn has the count that the file gives, else the one whose diameter is the thread's width. With a count
    and a width above that count's diameter it is pressed flat: its height d is that of the ellipse of the
    same area. At every change of face a thread rises or falls by its crimp height h over the spacing p of the
    threads it crosses, and its length over that is p·(1 + 9/16·(h/p)²); both families share the heights
    evenly, half the sum of the diameters each, as in cloth at rest.

    Source: Peirce, "The geometry of cloth structure", Journal of the Textile Institute 28 (1937), T45:
    h = 4/3·p·√c and h₁ + h₂ = d₁ + d₂.
    """
    layout, yarns = fabric.layout(), fabric.resolved
    warp_mm, warp_tex = _yarn(yarns.warp)
    weft_mm, weft_tex = _yarn(yarns.weft)
    height = (warp_mm + weft_mm) / 2
    changes = layout.warp_on_top != np.roll(layout.warp_on_top, 1, axis=0)
    warp_crimp = _crimp(changes, layout.weft.spacing, height)
    changes = layout.warp_on_top != np.roll(layout.warp_on_top, 1, axis=1)
    weft_crimp = _crimp(changes.T, layout.warp.spacing, height)
    width, depth = layout.size
    ends, picks = len(layout.warp.spacing), len(layout.weft.spacing)
    warp = FamilyFacts(10 * ends / width, warp_tex, 1 - layout.warp.open_share, warp_crimp)
    weft = FamilyFacts(10 * picks / depth, weft_tex, 1 - layout.weft.open_share, weft_crimp)
    return ClothFacts(
        warp=warp,
        weft=weft,
        cover=1 - layout.open_area,
        # Threads per metre times grams per metre of each.
        weight=sum(family.per_cm * 100 * family.tex / 1000 * (1 + family.crimp) for family in (warp, weft)),
        thickness_mm=height + max(warp_mm, weft_mm),
        counted=bool(yarns.warp.count and yarns.weft.count),
    )


def three_digits(value: float) -> str:
    """A number by its first three digits, without an exponent: 2060, 82.1 or 0.43."""
    return f"{float(f'{value:.3g}'):g}"


def repeat_text(fabric: Fabric) -> str:
    """One repeat in words, with millimetres: of the weave, and with its colours where these repeat later."""
    whole, weave = fabric.draft, fabric.named_draft
    width, height = fabric.repeat_mm
    size = f"{whole.ends} ends and {whole.picks} picks, {width:.3g} × {height:.3g} mm"
    if (whole.ends, whole.picks) == (weave.ends, weave.picks):
        return size
    return f"{size}, of which the weave is {weave.ends} and {weave.picks}"


def facts_text(fabric: Fabric) -> str:
    """Sett, repeat, cover, yarn and weight of a fabric in a few lines for a person."""
    facts = cloth_facts(fabric)

    def pair(name: str) -> tuple[float, float]:
        return getattr(facts.warp, name), getattr(facts.weft, name)

    cover, tex, crimp = pair("cover"), pair("tex"), pair("crimp")
    about = "about" if facts.counted else "at most"
    per_cm = pair("per_cm")
    text = (
        f"sett: {per_cm[0]:.3g} ends/cm ({per_inch(per_cm[0]):.3g} epi), "
        f"{per_cm[1]:.3g} picks/cm ({per_inch(per_cm[1]):.3g} ppi)\n"
        f"repeat: {repeat_text(fabric)}\n"
        f"cover: warp {cover[0]:.2f}, weft {cover[1]:.2f}, together {facts.cover:.3g}\n"
        f"yarn: warp {three_digits(tex[0])} tex, weft {three_digits(tex[1])} tex; "
        f"crimp {100 * crimp[0]:.2g} % and {100 * crimp[1]:.2g} %\n"
        f"weight: {about} {facts.weight:.0f} g/m²; thickness: {about} {facts.thickness_mm:.2g} mm"
    )
    if facts.counted:
        return text
    return f"{text} (yarns taken as round: give count in [warp] and [weft] for closer numbers)"


def _yarn(family: ResolvedFamily) -> tuple[float, float]:
    """Mean height, millimetres, and linear density, tex."""
    kind, layout = family.kind, family.layout
    if family.count:
        diameter = yarn_diameter_mm(family.count, density=kind.density, packing=kind.packing)
        return min(diameter, diameter**2 / float(layout.visible_width.mean())), yarn_tex(family.count)
    tex = tex_of_diameter(layout.width, density=kind.density, packing=kind.packing)
    return float(layout.width.mean()), float(tex.mean())


def _crimp(changes: NDArray[np.bool_], crossed: NDArray[np.float64], height: float) -> float:
    """Mean crimp of threads that change face at `changes` [crossed threads, threads], evenly weighted."""
    extra = 9 / 16 * height**2 / crossed[:, None] * changes
    return min(float(extra.sum(axis=0).mean() / crossed.sum()), _MAX_CRIMP)
