"""Options of models: a wrong one is a sentence, by the command line and by Python.

Covers: models/options.py, models/registry.py, models/texture/settings.py
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from loomlight.core.errors import InputError
from loomlight.core.settings import declared
from loomlight.models.bake import bake
from loomlight.models.registry import model_class, model_names, parse_options
from tests.helpers.model_answers import every_model

POWER_OF_2 = "is wrong: give a power of two from 8 to 1024"
GROUPS = "is wrong: give a whole number from 1 to 64."
# Model, option as the command line takes it, and a part of the sentence.
WRONG: list[tuple[str, str, str]] = [
    ("lobes", "grups=4", '"grups" is no option of lobes: did you mean groups?'),
    ("lobes", "groups=0", f"groups = 0 {GROUPS}"),
    ("lobes", "groups=65", f"groups = 65 {GROUPS}"),
    ("lobes", "groups=8.5", "groups = "),
    ("samples", "points=0", "points = 0 is wrong: give a whole number from 1 to 65536"),
    ("neural", "sampler=cosine", "known are learned, lobes"),
    ("clustered", "clusters=6", "clusters = 6 is wrong"),
    ("clustered", "rank=17", "rank = 17 is wrong"),
    ("clustered", "samples=9", "samples = 9 is wrong"),
    ("clustered", "texels=8", "texels = 8 is wrong"),
    ("neumip", "qualty=full", '"qualty" is no option of neumip: did you mean quality?'),
    ("neumip", "quality", '"quality" is no option: write its name, "=" and its value'),
    ("neumip", "quality=best", 'quality = "best" does not exist: known are preview, full.'),
    ("neumip", "resolution=100", f"resolution = 100 {POWER_OF_2}"),
    ("neumip", "resolution=4", f"resolution = 4 {POWER_OF_2}"),
    ("neumip", "steps=many", 'steps = "many" is wrong: give a whole number from 1'),
    ("neumip", "offset=no", 'offset = "no" is wrong: give true or false'),
    ("neumip", "device=tpu", 'device = "tpu" does not exist: did you mean cpu?'),
    ("latent", "quality=best", 'quality = "best" does not exist: known are preview, full, published'),
    ("latent", "decoder=2x33", 'decoder = "2x33" does not exist'),
    ("latent", "rung=frame", 'rung = "frame" does not exist: did you mean frames?'),
    ("latent", "resolution=100", f"resolution = 100 {POWER_OF_2}"),
    ("latent", "mips=nearest", 'mips = "nearest" does not exist: known are stochastic, trilinear.'),
    ("latent", "precision=int8", 'precision = "int8" does not exist'),
    ("latent", "features=all", 'features = "all" does not exist'),
    ("latent", "loss=l2", 'loss = "l2" does not exist'),
]


@pytest.mark.parametrize(("name", "option", "says"), WRONG)
def test_a_wrong_option_is_one_sentence(
    name: str, option: str, says: str, refused: Callable[..., str]
) -> None:
    """Of the command, which leaves no file; bakes ask the same options, before they begin."""
    assert says in refused(["bake", "plain", "--model", name, "-o", "a.loom", "--set", option])


@pytest.mark.parametrize("groups", ["8", True, 8.5, 0, 65, float("nan")])
def test_values_of_another_kind_are_refused(groups: Any) -> None:
    with pytest.raises(InputError, match=r"groups = .* is wrong: give a whole number from 1 to 64\."):
        bake("plain", "lobes", groups=groups)


@every_model
def test_declared_bounds_hold(name: str) -> None:
    """Of numbers: what lies beyond either bound is refused in a sentence of option and value."""
    options = model_class(name).options_class
    for option, setting in declared(options).items():
        if setting.kind not in (int, float):
            continue
        for bound, beyond in ((setting.low, -1), (setting.high, 1)):
            if abs(bound) == float("inf"):
                continue
            value = setting.kind(bound + beyond)
            with pytest.raises(InputError, match=rf"^{option} = {value} is wrong"):
                options.of({option: value})
            with pytest.raises(InputError, match=rf"^{option} = {value} is wrong"):
                parse_options(name, [f"{option}={value}"])


def test_models_with_options_are_in_the_table() -> None:
    assert {name for name, _, _ in WRONG} == {
        name for name in model_names() if declared(model_class(name).options_class)
    }
