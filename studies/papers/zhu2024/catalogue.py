"""The figures of zhu2024."""

from __future__ import annotations

from studies.papers.figure import Item
from studies.papers.setting import CLUSTERED, POINT
from studies.papers.zhu2024 import control, cylinder, sampling, sheen, table1

ITEMS = (
    Item(
        "zhu2024/table1",
        "five scenes: samples and seconds to equal quality",
        table1.speed_up,
        table1.TRUTH_SAMPLES,
        CLUSTERED,
    ),
    Item(
        "zhu2024/fig5",
        "importance sampling under an environment map, 32 samples",
        sampling.importance_sampling,
        1024,
        CLUSTERED,
    ),
    Item(
        "zhu2024/fig6",
        "parallax near and far, against a ray-traced height field",
        cylinder.parallax,
        model=CLUSTERED,
    ),
    Item("zhu2024/fig7", "sheen on black cloth", sheen.sheen, model=CLUSTERED),
    Item(
        "zhu2024/fig8",
        "a cylinder of cloth: parallax and sheen, against a height field",
        cylinder.cylinder,
        model=CLUSTERED,
    ),
    Item(
        "zhu2024/fig11",
        "the choice of α: base, residual and their sum",
        control.choice_of_alpha,
        model=POINT,
    ),
)
