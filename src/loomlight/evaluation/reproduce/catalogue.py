"""Every figure and table that `loomlight reproduce` makes, by name."""

from __future__ import annotations

import difflib

from loomlight.core.errors import InputError
from loomlight.evaluation.reproduce import (
    ablation,
    comparison,
    components,
    cost,
    editing,
    kuznetsov2021_figures,
    kuznetsov2021_tables,
    latents,
    zeltner2024_polar,
    zeltner2024_sampling,
    zeltner2024_tables,
    zhu2024_control,
    zhu2024_cylinder,
    zhu2024_sampling,
    zhu2024_sheen,
    zhu2024_table1,
)
from loomlight.evaluation.reproduce.evidence import Item
from loomlight.evaluation.reproduce.setting import CLUSTERED, LATENT, NEUMIP, POINT

_ITEMS = (
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
    Item(
        "zhu2024/table1",
        "five scenes: samples and seconds to equal quality",
        zhu2024_table1.speed_up,
        zhu2024_table1.TRUTH_SAMPLES,
        CLUSTERED,
    ),
    Item(
        "zhu2024/fig5",
        "importance sampling under an environment map, 32 samples",
        zhu2024_sampling.importance_sampling,
        1024,
        CLUSTERED,
    ),
    Item(
        "zhu2024/fig6",
        "parallax near and far, against a ray-traced height field",
        zhu2024_cylinder.parallax,
        model=CLUSTERED,
    ),
    Item("zhu2024/fig7", "sheen on black cloth", zhu2024_sheen.sheen, model=CLUSTERED),
    Item(
        "zhu2024/fig8",
        "a cylinder of cloth: parallax and sheen, against a height field",
        zhu2024_cylinder.cylinder,
        model=CLUSTERED,
    ),
    Item(
        "zhu2024/fig11",
        "the choice of α: base, residual and their sum",
        zhu2024_control.choice_of_alpha,
        model=POINT,
    ),
    Item(
        "zeltner2024/tables1-4",
        "four layered materials: a plain network, with encoder, with frames",
        zeltner2024_tables.ablation,
        model=LATENT,
    ),
    Item(
        "zeltner2024/tables5-11",
        "2×16, 2×32 and 3×64, close and from far",
        zeltner2024_tables.quality,
        model=LATENT,
    ),
    Item(
        "zeltner2024/fig5",
        "beside a simple analytic BRDF with 8 channels",
        zeltner2024_tables.eight_channels,
        model=LATENT,
    ),
    Item(
        "zeltner2024/sampler",
        "noise of the importance sampler, at equal samples and time",
        zeltner2024_sampling.sampler_variance,
        model=LATENT,
    ),
    Item(
        "zeltner2024/polar",
        "polar plots of values and of the sampler's density",
        zeltner2024_polar.polar_plots,
        model=LATENT,
    ),
    Item(
        "kuznetsov2021/table2",
        "five height fields: ours, ours without offset, and the decoders of Rainer et al.",
        kuznetsov2021_tables.comparison,
        64,
        NEUMIP,
    ),
    Item(
        "kuznetsov2021/table3",
        "the error of ours over eight levels of detail",
        kuznetsov2021_tables.by_level,
        64,
        NEUMIP,
    ),
    Item(
        "kuznetsov2021/table4",
        "weights of the networks and channels of the textures",
        kuznetsov2021_tables.sizes,
        1,
        NEUMIP,
    ),
    Item(
        "kuznetsov2021/fig5",
        "learned offsets of the turtle shell for four views",
        kuznetsov2021_figures.offsets,
        1,
        NEUMIP,
    ),
    Item(
        "kuznetsov2021/fig10",
        "ablation: channels of the textures, layers of the networks",
        kuznetsov2021_figures.ablation,
        64,
        NEUMIP,
    ),
    Item(
        "kuznetsov2021/fig11",
        "five height fields at eight levels of detail, over the reference",
        kuznetsov2021_tables.zooms,
        64,
        NEUMIP,
    ),
)
CATALOGUE = {item.name: item for item in _ITEMS}


def find_item(name: str) -> Item:
    """The figure of that name.

    Raises:
        InputError: there is none.
    """
    if name not in CATALOGUE:
        near = difflib.get_close_matches(name, CATALOGUE, 1, 0.3)
        hint = f'; did you mean "{near[0]}"?' if near else "."
        raise InputError(f'"{name}" is no figure: `loomlight reproduce --list` names them all{hint}')
    return CATALOGUE[name]
