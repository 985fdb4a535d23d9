"""Edits of scene parameters: they show as cloth of what is edited, and bake no more than they must.

Wrong ones are refused in a sentence and leave nothing behind.

Covers: mitsuba/props.py, models/fabric_model.py, models/live_albedos.py
"""

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
from loomlight.models.clustered import model as clustered_model
from loomlight.models.fabric_model import parameter_of
from loomlight.models.lobes import model as lobes_model
from loomlight.models.neural import encoding
from loomlight.models.registry import MODELS
from tests.helpers.interactions import CHEAPEST, mean_value, pretrained, side_by_side, woven
from tests.marks import slow, slow_among

# Refused by the same code for all: those that bake for seconds are slow.
SLOW = ("woven_clustered", "woven_neural", "woven_samples", "neumip", "latent")
PLUGINS = slow_among((entry.plugin for entry in MODELS.values()), SLOW)
CLOTH = {"weave": "twill 2/1", "uv_size": "4,4", "sheen_strength": 0.3, "id": "mine"}
# Two colours in the warp: its albedos are one table.
OTHER = {"weave": "plain", "uv_size": "4,4", "warp_color": "#c08040,#4060c0", "id": "other"}
pytestmark = pytest.mark.usefixtures("variant", "narrow_network")


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
    for name in (
        "warp.roughness",
        "warp.specular_grazing",
        "warp.height_scale",
        "weft.twist",
        "sheen.strength",
        "sheen.roughness",
    ):
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


@pytest.mark.parametrize(
    "name", ["warp.roughness", "weft.specular_grazing", "weft.height_scale", "warp.inclination", "weft.twist"]
)
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


@pytest.fixture
def bakings(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Names of what was baked or encoded, in order."""
    found: list[str] = []

    def count(module: Any, name: str) -> None:
        bake = getattr(module, name)
        monkeypatch.setattr(module, name, lambda *arguments: (found.append(name), bake(*arguments))[1])

    count(lobes_model, "bake_tables")
    count(clustered_model, "bake_tables")
    count(encoding, "run_encoder")
    return found


# Models whose yarns are edited live; those that bake for seconds are slow.
edited_plugins = pytest.mark.parametrize(
    "plugin", ["woven_point", slow("woven_lobes"), "woven_neural", slow("woven_clustered")]
)


@edited_plugins
def test_colours_and_sheen_bake_nothing(plugin: str, bakings: list[str]) -> None:
    # Light between yarns is no multiple of albedos, and is left out.
    bsdf = woven(plugin, sheen_strength=0.3, interreflection=False)
    before, made = mean_value(bsdf), len(bakings)
    params = mi.traverse(bsdf)
    for family in ("warp", "weft"):
        for term in ("diffuse", "specular"):
            params[f"{family}.{term}_reflect"] *= 0.5
            params[f"{family}.{term}_transmit"] *= 0.5
    params["sheen.strength"] = 1e-3
    params.update()
    halved = mean_value(bsdf)
    assert len(bakings) == made
    assert (halved < before).all()
    # What is left of the sheen takes and adds a thousandth.
    np.testing.assert_allclose(halved, 0.5 * mean_value(woven(plugin, interreflection=False)), rtol=5e-3)


@pytest.mark.slow
@edited_plugins
def test_editing_yarns_is_the_fabric_of_those_yarns(plugin: str, bakings: list[str]) -> None:
    # With light between yarns the albedos of a colour depend on the yarns, and edits of yarns keep albedos.
    single = {"interreflection": False}
    bsdf = woven(plugin, **single)
    params, made = mi.traverse(bsdf), len(bakings)
    params["warp.roughness"] = 0.7
    params["weft.twist"] = float(np.radians(20))
    params["weft.height_scale"] = 0.5
    params.update()
    assert len(bakings) == 2 * made
    wanted = woven(plugin, warp_roughness=0.7, weft_twist_deg=20.0, weft_height_scale=0.5, **single)
    np.testing.assert_allclose(mean_value(bsdf), mean_value(wanted), rtol=1e-4)
    assert np.abs(mean_value(bsdf) / mean_value(woven(plugin, **single)) - 1).max() > 5e-4
    params["warp.roughness"] = 7.0
    with pytest.raises(InputError, match=r"warp\.roughness"):
        params.update()


@edited_plugins
def test_colours_thread_by_thread(plugin: str, bakings: list[str]) -> None:
    bsdf = woven(plugin, warp_color="#ff0000,#00ff00,#0000ff")
    params, made = mi.traverse(bsdf), len(bakings)
    # Four albedos a thread, of three numbers or of four, the last of which fills an aligned load.
    table = np.array(params["warp.albedos"])
    albedos = table.reshape(3, 4, -1)[..., :3]
    np.testing.assert_allclose(albedos[:, 0], bsdf.model.fabric.appearance().warp.diffuse_reflect, atol=1e-6)
    before = mean_value(bsdf)
    params["warp.albedos"] = mi.Float(np.zeros(len(table), np.float32))
    params.update()
    assert (mean_value(bsdf) < before).all()
    assert len(bakings) == made


@edited_plugins
def test_the_rise_towards_grazing_bakes_nothing(plugin: str, bakings: list[str]) -> None:
    """And is that of the fabric; what diffuse light loses to it follows the roughness."""
    single = {"interreflection": False}
    bsdf = woven(plugin, **single)
    params, made, before = mi.traverse(bsdf), len(bakings), mean_value(bsdf)
    params["weft.specular_grazing"] = 3.0
    params.update()
    assert len(bakings) == made
    risen = mean_value(bsdf)
    np.testing.assert_allclose(
        risen, mean_value(woven(plugin, weft_specular_grazing=3.0, **single)), rtol=1e-4
    )
    # In the mean over directions highlights gain little more than diffuse light loses.
    assert np.abs(risen / before - 1).max() > 5e-4
    params["weft.specular_grazing"] = 0.0
    params.update()
    np.testing.assert_allclose(mean_value(bsdf), before, rtol=1e-4)


def test_what_diffuse_light_loses_to_the_rise_follows_the_roughness() -> None:
    risen = {"interreflection": False, "weft_specular_grazing": 3.0}
    bsdf = woven("woven_point", **risen)
    params = mi.traverse(bsdf)
    params["warp.roughness"] = 0.8
    params.update()
    np.testing.assert_allclose(
        mean_value(bsdf), mean_value(woven("woven_point", warp_roughness=0.8, **risen)), rtol=1e-4
    )


@pytest.mark.slow
@pytest.mark.parametrize("plugin", ["woven_point", "woven_lobes"])
def test_roughness_bakes_nothing(plugin: str, bakings: list[str]) -> None:
    # With light between yarns albedos follow from the roughness, and an edit leaves albedos alone.
    rough = woven(plugin, interreflection=False)
    params, made = mi.traverse(rough), len(bakings)
    params["warp.roughness"] = 0.7
    params.update()
    assert len(bakings) == made
    np.testing.assert_allclose(
        mean_value(rough), mean_value(woven(plugin, warp_roughness=0.7, interreflection=False)), rtol=1e-4
    )
    assert np.abs(mean_value(rough) / mean_value(woven(plugin, interreflection=False)) - 1).max() > 5e-3
