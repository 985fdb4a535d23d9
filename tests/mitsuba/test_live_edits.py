"""Wrong edits of scene parameters are refused in a sentence, and leave nothing behind."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest

from loomlight.core.colour import parse_colour
from loomlight.core.errors import InputError
from loomlight.fabric import fabric_from_text
from loomlight.fabric.read import edited_fabric
from loomlight.models.fabric_model import parameter_of
from loomlight.models.registry import MODELS
from tests.helpers.interactions import mean_value, pretrained, side_by_side
from tests.marks import slow, slow_among

# Refused by the same code for all: those that bake for seconds are slow.
SLOW = ("woven_clustered", "woven_neural", "woven_samples", "neumip", "latent")
PLUGINS = slow_among((entry.plugin for entry in MODELS.values()), SLOW)
CHEAPEST = {"woven_samples": {"points": 2}, "woven_clustered": {"clusters": 4, "texels": 32}}
CLOTH = {"weave": "twill 2/1", "uv_size": "4,4", "sheen_strength": 0.3, "id": "mine"}
# Two colours in the warp: its albedos are one table.
OTHER = {"weave": "plain", "uv_size": "4,4", "warp_color": "#c08040,#4060c0", "id": "other"}
pytestmark = pytest.mark.usefixtures("narrow_network")


def scene_of(plugin: str, folder: Path) -> Any:
    # The cheapest bakes: edits are refused alike by any.
    options = CHEAPEST.get(plugin, {})
    cloths = ({"type": plugin, **options, **cloth} for cloth in (CLOTH, OTHER))
    return side_by_side(*(pretrained(cloth, folder) for cloth in cloths))


def values_of(params: Any) -> dict[str, np.ndarray]:
    return {key: np.array(params[key]) for key in params.keys() if ".bsdf." in key}  # noqa: SIM118 (no mapping)


def wrong_values(key: str, value: Any) -> list[Any]:
    """Beyond either end of the range, and no number at all."""
    numbers = np.array(value, np.float32).ravel()
    low = -2.0 if key.endswith("twist") else -0.5
    beyond = (low,) if key.endswith("uv_size") else (low, 5.0)
    wrong = []
    for number in (*beyond, np.nan, np.inf):
        numbers = numbers.copy()
        numbers[-1] = number
        wrong.append(type(value)(*numbers.tolist()) if dr.depth_v(value) > 1 else type(value)(numbers))
    return wrong


@pytest.mark.quick("woven_point")
@pytest.mark.parametrize("plugin", PLUGINS)
def test_every_live_parameter_refuses_wrong_values(plugin: str, tmp_path: Path) -> None:
    scene = scene_of(plugin, tmp_path)
    params = mi.traverse(scene)
    before = values_of(params)
    assert len(before) >= 2  # of two cloths
    answers = [mean_value(shape.bsdf()) for shape in scene.shapes()]
    for key in before:
        cloth, _, name = key.partition(".bsdf.")
        for value in wrong_values(key, params[key]):
            # A right edit of the other cloth beside the wrong one: it must not show either.
            for other in (other for other in before if not other.startswith(cloth)):
                if other.endswith(("uv_size", "weft.roughness")):
                    params[other] = type(params[other])(0.7)
            params[key] = value
            with pytest.raises(InputError, match=name.replace(".", r"\.")) as caught:
                params.update()
            assert str(caught.value).startswith(("mine.", "other.")), str(caught.value)
            assert str(caught.value).count(". ") == 0, "more than a sentence"
            for each, kept in values_of(params).items():
                np.testing.assert_array_equal(kept, before[each], err_msg=f"{each} after {key}")
    for shape, answer in zip(scene.shapes(), answers, strict=True):
        np.testing.assert_allclose(mean_value(shape.bsdf()), answer, rtol=1e-5)


@pytest.mark.slow
@pytest.mark.parametrize("plugin", ["woven_point", "woven_lobes"])
def test_messages_name_value_and_range(plugin: str, tmp_path: Path) -> None:
    params = mi.traverse(scene_of(plugin, tmp_path))
    mine = next(key for key in params.keys() if key.endswith("sheen.strength")).partition("sheen")[0]  # noqa: SIM118
    for name, value, says in (
        ("warp.roughness", -1, r"mine\.warp\.roughness = -1 is wrong: give 0\.01 to 1\."),
        ("warp.roughness", 5, "= 5 is wrong"),
        ("warp.roughness", float("nan"), "= nan is wrong"),
        ("weft.twist", 3, "give -1.553 to 1.553 rad, which is -89° to 89°"),
        ("uv_size", [0, 1], "= 0, 1 is wrong: give 1e-06 mm or more"),
        ("warp.diffuse_reflect", [0.1, 2, 0.3], "= 0.1, 2, 0.3 is wrong: give 0 to 1"),
    ):
        params[f"{mine}{name}"] = value
        with pytest.raises(InputError, match=says):
            params.update()
    table = next(key for key in params.keys() if key.endswith("warp.albedos"))  # noqa: SIM118
    count = dr.width(params[table])
    params[table] = mi.Float(0.5)
    with pytest.raises(InputError, match=f"holds 1 numbers: give {count}"):
        params.update()


@pytest.mark.slow
@pytest.mark.parametrize("plugin", ["woven_point", slow("woven_lobes")])
def test_both_ends_of_a_range_are_allowed(plugin: str, tmp_path: Path) -> None:
    scene = scene_of(plugin, tmp_path)
    params = mi.traverse(scene)
    bsdf = next(shape.bsdf() for shape in scene.shapes() if shape.bsdf().id() == "mine")
    start = next(key for key in params.keys() if key.endswith("sheen.strength")).partition("sheen")[0]  # noqa: SIM118
    for name in ("warp.roughness", "warp.height_scale", "weft.twist", "sheen.strength", "sheen.roughness"):
        parameter = parameter_of(name, None)
        for bound in (parameter.low, parameter.high):
            params[f"{start}{name}"] = bound
            params.update()
            assert np.isfinite(mean_value(bsdf)).all(), (name, bound)


def test_sheen_comes_back_after_none() -> None:
    """Without sheen the fabric has no field of it, but the parameter stays."""
    bsdf = mi.load_dict({"type": "woven_lobes", **CLOTH})
    params, before = mi.traverse(bsdf), mean_value(bsdf)
    for strength in (0.0, 0.3):
        params["sheen.strength"] = strength
        params.update()
    np.testing.assert_allclose(mean_value(bsdf), before, rtol=1e-5)


@pytest.mark.parametrize("name", ["warp.roughness", "weft.height_scale", "warp.inclination", "weft.twist"])
def test_ranges_are_those_of_the_fabric_file(name: str) -> None:
    cloth = fabric_from_text("plain")
    parameter = parameter_of(name, None)
    is_angle = parameter.unit == "rad"
    field = f"{name}_deg" if is_angle else name
    for bound, outwards in ((parameter.low, -1), (parameter.high, 1)):
        value = round(float(np.degrees(bound)), 6) if is_angle else bound
        edited_fabric(cloth, {field: value})
        with pytest.raises(InputError, match=field.partition(".")[2]):
            edited_fabric(cloth, {field: value + 1e-3 * outwards})


@pytest.mark.slow
@pytest.mark.parametrize("plugin", ["woven_lobes", "woven_neural"])
def test_derivatives_that_there_are_none_of_are_refused(plugin: str, tmp_path: Path) -> None:
    params = mi.traverse(scene_of(plugin, tmp_path))
    for name in ("warp.roughness", "warp.albedos", "sheen.strength", "uv_size"):
        key = next(key for key in params.keys() if key.endswith(name))  # noqa: SIM118
        dr.enable_grad(params[key])
        with pytest.raises(InputError, match=r"has no derivatives: .*diffuse_reflect.* woven_point"):
            params.update()
        assert not dr.grad_enabled(params[key])
        params.update()


def test_textures_of_models_that_filter_have_no_derivatives() -> None:
    texture = {"type": "bitmap", "bitmap": mi.Bitmap(np.full((4, 4, 3), 0.5, np.float32)), "raw": True}
    params = mi.traverse(mi.load_dict({"type": "woven_lobes", **CLOTH, "albedo": texture}))
    dr.enable_grad(params["albedo.data"])
    with pytest.raises(InputError, match=r"mine\.albedo has no derivatives"):
        params.update()


def of_colours(plugin: str, warp: str, interreflection: bool) -> Any:
    colours = {"warp_color": warp, "weft_color": "#dfd7c5", "interreflection": interreflection}
    return mi.load_dict({"type": plugin, "weave": "twill 2/1", "uv_size": "4,4", "id": "mine", **colours})


@pytest.mark.quick("woven_point-1-True")
@pytest.mark.parametrize("interreflection", [False, True])
@pytest.mark.parametrize("threads", [1, 3])
@pytest.mark.parametrize("plugin", ["woven_point", "woven_lobes"])
def test_colours_are_edited_as_they_are_written(plugin: str, threads: int, interreflection: bool) -> None:
    """Highlight, transmission and light between yarns are those of cloth woven of the new colours."""
    old, new = ["#20a040", "#c04060", "#a08020"][:threads], ["#803010", "#405880", "#305020"][:threads]
    edited = of_colours(plugin, ",".join(old), interreflection)
    params = mi.traverse(edited)
    colours = np.concatenate([parse_colour(colour, "color") for colour in new])
    if threads == 1:
        params["warp.color"] = colours.tolist()
    else:
        params["warp.colors"] = colours.astype(np.float32)
    params.update()
    woven = of_colours(plugin, ",".join(new), interreflection)
    # Tables of mean albedos are computed in single precision.
    np.testing.assert_allclose(mean_value(edited), mean_value(woven), rtol=1e-4)
    for name, value in mi.traverse(woven):
        np.testing.assert_allclose(np.array(params[name]), np.array(value), rtol=1e-5, err_msg=name)


@pytest.mark.parametrize("plugin", ["woven_point", "woven_lobes"])
def test_albedos_win_over_colours_of_the_same_edit(plugin: str) -> None:
    params = mi.traverse(of_colours(plugin, "#20a040", False))
    transmitted = np.array(params["warp.diffuse_transmit"])
    params["warp.diffuse_reflect"], params["warp.color"] = [0.1, 0.2, 0.3], [0.4, 0.3, 0.2]
    params.update()
    np.testing.assert_allclose(np.array(params["warp.diffuse_reflect"]).ravel(), [0.1, 0.2, 0.3], rtol=1e-6)
    assert not np.allclose(np.array(params["warp.diffuse_transmit"]), transmitted)
    # The colour is no edit any more: albedos that are set afterwards stay.
    params["warp.diffuse_transmit"] = [0.05, 0.05, 0.05]
    params.update()
    np.testing.assert_allclose(np.array(params["warp.diffuse_transmit"]), 0.05, rtol=1e-6)


def test_errors_of_the_fabric_name_the_bsdf(monkeypatch: pytest.MonkeyPatch) -> None:
    bsdf = of_colours("woven_lobes", "#20a040", False)
    params = mi.traverse(bsdf)

    def refuse(*_: Any) -> Any:
        raise InputError("the fabric: no.")

    monkeypatch.setattr(type(bsdf.model), "updated", refuse)
    params["warp.roughness"] = 0.5
    with pytest.raises(InputError, match=r"^mine: the fabric: no\.$"):
        params.update()
