"""The figures of zeltner2024."""

from __future__ import annotations

from studies.papers.figure import Item
from studies.papers.setting import LATENT
from studies.papers.zeltner2024 import polar, sampling, tables

ITEMS = (
    Item(
        "zeltner2024/tables1-4",
        "four layered materials: a plain network, with encoder, with frames",
        tables.ablation,
        model=LATENT,
    ),
    Item(
        "zeltner2024/frames",
        "what frames gain of two normal maps, with half-vector features and without",
        tables.frames,
        model=LATENT,
    ),
    Item("zeltner2024/tables5-11", "2×16, 2×32 and 3×64, close and from far", tables.quality, model=LATENT),
    Item("zeltner2024/whole", "whole spheres by the default network", tables.whole, model=LATENT),
    Item(
        "zeltner2024/fig5",
        "beside a simple analytic BRDF with 8 channels",
        tables.eight_channels,
        model=LATENT,
    ),
    Item(
        "zeltner2024/sampler",
        "noise of the importance sampler, at equal samples and time",
        sampling.sampler_variance,
        model=LATENT,
    ),
    Item(
        "zeltner2024/polar",
        "polar plots of values and of the sampler's density",
        polar.polar_plots,
        model=LATENT,
    ),
)
