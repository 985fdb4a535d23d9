"""Baked tables: the same bytes every time, small, and refused in one sentence where a file is damaged."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.fabric import fabric_from_text
from loomlight.models.lobes.model import MAX_GROUPS, LobesModel, LobesOptions
from loomlight.models.registry import model_from_loom
from loomlight.sources import loom_file
from loomlight.sources.loom_file import LoomFile, write_loom

from .cloths import TEXTS, cloth, model_of, prefiltered_parts, random_queries

Tensor = NDArray[Any]


def _damaged(name: str, change: Callable[[Tensor], Tensor]) -> LoomFile:
    """A file of which one tensor is changed."""
    loom = model_of("open plain").to_loom()
    tensors = {key: values.copy() for key, values in loom.tensors.items()}
    return replace(loom, tensors={**tensors, name: change(tensors[name])}, file="cloth.loom")


def _refused(loom: LoomFile, *words: str) -> None:
    with pytest.raises(InputError) as caught:
        LobesModel.from_loom(loom)
    message = str(caught.value)
    assert message.startswith("cloth.loom: "), message
    assert message.endswith("."), message
    assert "\n" not in message
    assert message.count(". ") == 0
    for word in words:
        assert word in message, (word, message)


def test_tables_of_another_version_are_refused() -> None:
    loom = replace(model_of("open plain").to_loom(), file="cloth.loom")
    older = {key: value for key, value in loom.settings.items() if key != "tables_version"}
    _refused(replace(loom, settings=older), "another version", "bake it again")


@pytest.mark.quick("translucent twill")
@pytest.mark.parametrize("name", TEXTS)
def test_baking_twice_gives_the_same_bytes(name: str) -> None:
    first, second = model_of(name).tables, LobesModel.for_source(cloth(name)).tables
    assert first.base_size == second.base_size
    for key, values in first.arrays().items():
        assert values.tobytes() == second.arrays()[key].tobytes(), key


def test_colours_and_roughness_are_not_baked() -> None:
    """So that edits of them bake nothing: the tables are the same, and the model's answers are not."""
    base = TEXTS["open plain"]
    plain = LobesModel.for_source(fabric_from_text(base))
    edited = LobesModel.for_source(
        fabric_from_text(base + '\n[warp]\nroughness = 0.9\ncolor = "#aa2211"\n[sheen]\nstrength = 0.5')
    )
    for key, values in plain.tables.arrays().items():
        assert np.array_equal(values, edited.tables.arrays()[key]), key
    queries = random_queries(plain.fabric, plain.tables.base_size, 100, seed=1)
    actual, other = (prefiltered_parts(model, queries)["specular_warp"] for model in (plain, edited))
    assert not np.allclose(actual, other, rtol=0.05)


def test_only_so_many_groups() -> None:
    for groups in (0, MAX_GROUPS + 1):
        with pytest.raises(InputError, match=f"groups = {groups} is wrong"):
            LobesModel.for_source(cloth("open plain"), LobesOptions(groups=groups))


@pytest.mark.parametrize(
    ("name", "change"),
    [
        ("coverage", lambda values: values[:, 1:]),
        ("coverage", lambda values: values[:, :, 4:]),
        ("coverage", lambda values: values.astype(np.int16)),
        ("projected_area", lambda values: values[:, 1:]),
        ("projected_area", lambda values: values[:1]),
        ("light_visibility", lambda values: values[..., :4]),
        ("light_visibility", lambda values: values[:, 0]),
        ("joint", lambda values: values[:, :1]),
        ("joint", lambda values: values.astype(np.float32)),
        ("irradiance", lambda values: values.astype(np.float32)),
        ("moments", lambda values: values[..., :11]),
        ("moments", lambda values: values.astype(np.float64)),
        ("hole_weight", lambda values: values[:1]),
        ("warp_packs", lambda values: values[:1]),
        ("warp_packs", lambda values: values + 100),
        ("levels", lambda values: values.astype(np.int32)),
        ("levels", lambda values: values[:, :2]),
    ],
)
def test_tensors_of_another_shape_or_type(name: str, change: Callable[[Tensor], Tensor]) -> None:
    _refused(_damaged(name, change), f"tensor model.{name} is ", "it should be ")


@pytest.mark.parametrize(
    "name",
    [
        "coverage",
        "projected_area",
        "light_visibility",
        "irradiance",
        "moments",
        "hole_weight",
        "levels",
        "warp_packs",
        "joint",
    ],
)
def test_tensors_that_are_missing(name: str) -> None:
    loom = _damaged(name, lambda values: values)
    rest = {key: values for key, values in loom.tensors.items() if key != name}
    _refused(replace(loom, tensors=rest), f"tensor model.{name} is missing")


def _with_level(row: int, *numbers: int) -> Callable[[Tensor], Tensor]:
    def change(levels: Tensor) -> Tensor:
        levels[row] = numbers
        return levels

    return change


@pytest.mark.parametrize(
    "change",
    [
        lambda levels: levels[:0],
        lambda levels: levels[1:],
        lambda levels: levels + np.array([1, 0, 0]),
        lambda levels: levels * np.array([1, 0, 1]),
        lambda levels: levels * np.array([1, -1, -1]),
        _with_level(1, 7, 3, 3),
        _with_level(0, 0, 1 << 40, 1 << 40),
    ],
)
def test_levels_that_are_no_pyramid(change: Callable[[Tensor], Tensor]) -> None:
    _refused(_damaged("levels", change), "model.levels is no pyramid", "bake it again")


@pytest.mark.parametrize("groups", [0, 4, 12])
def test_groups_that_fill_no_packs_of_both_families(groups: int) -> None:
    loom = _damaged("moments", lambda values: np.resize(values, (2, groups, values.shape[2])))
    widths = {
        "coverage": groups + 4,
        "projected_area": groups + 4,
        "light_visibility": groups,
        "irradiance": groups,
    }
    resized = {
        name: np.resize(loom.tensors[name], (*loom.tensors[name].shape[:-1], width))
        for name, width in widths.items()
    }
    tensors = {**loom.tensors, **resized}
    _refused(replace(loom, tensors=tensors), f"model.moments has {groups} groups", "packs of four")


@pytest.mark.parametrize("size", [0.0, -1.0, float("nan"), float("inf")])
def test_sizes_that_are_none(size: float) -> None:
    loom = _damaged("moments", lambda values: values)
    _refused(
        replace(loom, settings={**loom.settings, "base_size": size}), "setting base_size is ", "above 0 mm"
    )


@pytest.mark.parametrize("settings", [{}, {"base_size": 1}, {"base_size": "small"}])
def test_sizes_of_another_kind(settings: dict[str, Any]) -> None:
    loom = _damaged("moments", lambda values: values)
    rest = {key: value for key, value in loom.settings.items() if key != "base_size"}
    _refused(replace(loom, settings={**rest, **settings}), "setting base_size is ", "float")


def test_another_models_file() -> None:
    _refused(replace(_damaged("moments", lambda values: values), model="point"), '"point"', '"lobes"')


@pytest.mark.parametrize("name", ["moments", "hole_weight"])
def test_moments_that_are_no_numbers(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """None can be written; a file that holds some all the same is refused when it is read."""

    def spoilt(values: Tensor) -> Tensor:
        values.ravel()[3 % values.size] = np.nan
        return values

    loom = _damaged(name, spoilt)
    path = tmp_path / "cloth.loom"
    with pytest.raises(ValueError, match="NaN"):
        write_loom(path, loom)
    assert not path.exists()
    monkeypatch.setattr(loom_file, "_plain", lambda _, values: np.ascontiguousarray(values))
    write_loom(path, loom)
    with pytest.raises(InputError, match=rf"cloth\.loom: the tensor model\.{name} holds NaN"):
        model_from_loom(path)
