"""The figures of chen2024."""

from __future__ import annotations

from studies.papers.chen2024 import ablation, comparison, components, cost, editing, latents
from studies.papers.figure import Item

ITEMS = (
    Item("chen2024/fig1", "nine fabrics in one picture, one network", comparison.many),
    Item(
        "chen2024/fig2",
        "the BSDF of a patch taken apart: R and T, diffuse and specular",
        components.separated,
    ),
    Item(
        "chen2024/fig4",
        "seven seen patterns: 1 and 3 samples, equal time, the network",
        comparison.training_patterns,
    ),
    Item("chen2024/fig5", "twills that no training has seen, the same columns", comparison.unseen_patterns),
    Item("chen2024/fig6", "plain cloth against the light, with and without the BTDF", comparison.backlit),
    Item("chen2024/fig7", "ablations: no one-blob coding, no spatial fusion", ablation.ablated),
    Item("chen2024/fig8", "latents interpolated and extrapolated against encoded ones", latents.interpolated),
    Item("chen2024/fig9", "a strip of edits and what each costs", editing.edited),
    Item("chen2024/table3", "the time of a picture: network, others, encoder", cost.split),
)
