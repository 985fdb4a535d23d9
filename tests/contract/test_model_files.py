"""Files of models, `.loom`: they give the same numbers back, and what is wrong with one is a sentence.

That files are read within bounds, whatever they hold, tests/sources/test_loom_file.py asks.

Covers: models/registry.py, sources/loom_file.py, core/tables.py
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.core.llvm import require_llvm
from loomlight.models.interface import Model
from loomlight.models.registry import make_model, model_class, model_from_loom, model_names, model_of_loom
from loomlight.sources import loom_file
from loomlight.sources.loom_file import LoomFile, read_loom, write_loom
from tests.helpers.fabrics import STRESSING, fabric
from tests.helpers.model_answers import answers, built, every_fabric, every_model
from tests.helpers.queries import queries
from tests.marks import slow

require_llvm()

Tensor = NDArray[Any]
Change = Callable[[LoomFile], LoomFile]


def require_same_file(model: Any, path: Path) -> Any:
    """A model comes back from a file, which is written again byte for byte."""
    write_loom(path, model.to_loom())
    again = model_from_loom(path)
    assert type(again) is type(model)
    first = path.read_bytes()
    write_loom(path, again.to_loom())
    assert path.read_bytes() == first
    return again


def require_same_numbers(model: Any, again: Any) -> None:
    queried = queries(model.source, 300, seed=13)
    actual, wanted = answers(again, queried), answers(model, queried)
    for what in ("value", "pdf", "through"):
        assert np.array_equal(getattr(actual, what).numpy(), getattr(wanted, what).numpy()), what


@every_fabric
@every_model
def test_a_loom_file_gives_the_same_numbers(name: str, cloth: str, tmp_path: Path) -> None:
    model = built(name, cloth)
    require_same_numbers(model, require_same_file(model, tmp_path / "cloth.loom"))


# Options other than the defaults, and settings that files keep of them.
CHOSEN: list[Any] = [
    ("samples", {"points": 7}, {"points": 7}),
    ("lobes", {"groups": 5}, {"groups": 5}),
    slow("clustered", {"clusters": 4, "texels": 16, "rank": 2, "samples": 3}, {"texels": 16, "samples": 3}),
    ("neural", {"refined": False, "sampler": "lobes"}, {"sampler": "lobes"}),
    ("neumip", {"offset": False, "steps": 2}, {"footprint_texels": 2}),
    slow(
        "latent",
        {"rung": "encoder", "decoder": "2x16", "features": "none", "mips": "trilinear", "steps": 2},
        {"decoder": "2x16", "features": "none", "mips": "trilinear"},
    ),
    ("latent", {"precision": "float16", "steps": 2}, {"precision": "float16"}),
]


@pytest.mark.parametrize(("name", "options", "kept"), CHOSEN)
def test_chosen_options_come_back(
    name: str, options: dict[str, Any], kept: dict[str, Any], tmp_path: Path
) -> None:
    model = make_model(name, fabric("plain"), **options)
    again = require_same_file(model, tmp_path / "cloth.loom")
    assert kept.items() <= read_loom(tmp_path / "cloth.loom").settings.items()
    require_same_numbers(model, again)


@pytest.mark.parametrize(
    ("name", "cloth"),
    [
        ("lobes", "translucent twill"),
        *(slow("lobes", cloth) for cloth in STRESSING),
        slow("clustered", "plain"),
    ],
)
def test_baking_twice_gives_the_same_bytes(name: str, cloth: str, tmp_path: Path) -> None:
    first = built(name, cloth)
    write_loom(tmp_path / "first.loom", first.to_loom())
    write_loom(tmp_path / "again.loom", type(first).for_source(first.source, first.options).to_loom())
    assert (tmp_path / "first.loom").read_bytes() == (tmp_path / "again.loom").read_bytes()


def said_of(loom: LoomFile, read: Callable[[LoomFile], Model] = model_of_loom) -> str:
    """One sentence that names the file."""
    with pytest.raises(InputError) as caught:
        read(replace(loom, file="cloth.loom"))
    said = str(caught.value)
    assert said.startswith("cloth.loom: "), said
    assert said.endswith("."), said
    assert "\n" not in said
    assert said.count(". ") == 0, said
    return said


def without(name: str) -> Change:
    """The file without a tensor or a setting."""

    def change(loom: LoomFile) -> LoomFile:
        tensors, settings = (
            {key: value for key, value in held.items() if key != name}
            for held in (loom.tensors, loom.settings)
        )
        return replace(loom, tensors=tensors, settings=settings)

    return change


def tensor(name: str, change: Callable[[Tensor], Tensor]) -> Change:
    """The file with one tensor changed."""
    return lambda loom: replace(loom, tensors={**loom.tensors, name: change(loom.tensors[name].copy())})


def settings(**values: Any) -> Change:
    """The file with other settings."""
    return lambda loom: replace(loom, settings={**loom.settings, **values})


# What a model may do without, and is then another one.
OPTIONAL = {
    "neural": {"correction", "sampler"},
    "neumip": {"offset_texels", "opacity.0.weight", "sampler.0.weight", "footprint_texels"},
}


def damages(loom: LoomFile) -> Iterator[tuple[str, Change]]:
    """Each tensor and each setting missing, and of another type; each tensor of another shape."""
    for name, values in loom.tensors.items():
        yield name, without(name)
        yield name, tensor(name, lambda values: values.astype(np.float64))
        if values.ndim:
            yield name, tensor(name, lambda values: values[1:])
    for name, value in loom.settings.items():
        yield name, without(name)
        yield name, settings(**{name: 7 if isinstance(value, str) else "?"})


@every_model
def test_what_is_missing_or_of_another_kind_is_one_sentence(name: str) -> None:
    loom = built(name, "plain").to_loom()
    for what, change in damages(loom):
        damaged = change(loom)
        if what in OPTIONAL.get(name, set()) and not {what} & (
            damaged.tensors.keys() | damaged.settings.keys()
        ):
            model_class(name).from_loom(damaged)
        else:
            said_of(damaged)


@every_model
def test_a_file_of_another_model_is_one_sentence(name: str) -> None:
    other = "point" if name != "point" else "lobes"
    loom = built(name, "plain").to_loom()
    said = said_of(replace(loom, model=other), model_class(name).from_loom)
    assert f'it holds the model "{other}", not "{name}": bake it with that' in said
    # One that says it is of another model, which has tables of its own.
    said_of(replace(loom, model="clustered" if name == "lobes" else "lobes"))


@every_model
def test_a_file_that_is_cut_off_is_one_sentence(
    name: str, tmp_path: Path, refused: Callable[..., str]
) -> None:
    """Of the command that shows it, which writes no picture."""
    path = tmp_path / "cloth.loom"
    write_loom(path, built(name, "plain").to_loom())
    whole = path.read_bytes()
    for length in (len(whole) // 2, 100, 0):
        path.write_bytes(whole[:length])
        assert "cloth.loom" in refused(["render", "cloth.loom", "-o", "cloth.png"])


@every_model
def test_tables_that_are_no_numbers_are_one_sentence(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """None can be written; a file that holds some all the same is refused when it is read."""
    loom, path = built(name, "plain").to_loom(), tmp_path / "cloth.loom"
    tables = [key for key, values in loom.tensors.items() if values.dtype.kind == "f"]

    def spoilt(values: Tensor) -> Tensor:
        values.ravel()[3 % values.size] = np.nan
        return values

    for table in tables[:3]:
        damaged = tensor(table, spoilt)(loom)
        with pytest.raises(ValueError, match="NaN"):
            write_loom(path, damaged)
        assert not path.exists()
        with monkeypatch.context() as patch:
            patch.setattr(loom_file, "_plain", lambda _, values: np.ascontiguousarray(values))
            write_loom(path, damaged)
        with pytest.raises(InputError, match=rf"cloth\.loom: the tensor model\.{table} holds NaN"):
            model_from_loom(path)
        path.unlink()


def _with_level(row: int, *numbers: int) -> Callable[[Tensor], Tensor]:
    def change(levels: Tensor) -> Tensor:
        levels[row] = numbers
        return levels

    return change


def _with_groups(groups: int) -> Change:
    """Tables of `lobes` of so many groups on each face."""

    def change(loom: LoomFile) -> LoomFile:
        widths = {"coverage": 4, "projected_area": 4, "light_visibility": 0, "irradiance": 0}
        resized = {
            name: np.resize(loom.tensors[name], (*loom.tensors[name].shape[:-1], groups + more))
            for name, more in widths.items()
        }
        moments = np.resize(loom.tensors["moments"], (2, groups, loom.tensors["moments"].shape[2]))
        return replace(loom, tensors={**loom.tensors, **resized, "moments": moments})

    return change


PYRAMID = "model.levels is no pyramid: bake it again"
ABOVE_0 = "above 0 mm"
OTHER_TABLES = "its tables are of another version of loomlight: bake it again"
OTHER_NETWORKS = "its networks are of another version of loomlight: bake it again"
POWER_OF_2 = "columns = 3 is wrong: it is a power of two up to 4096"
# What a damaged file of a model is said of: model, what is changed, and a part of the sentence.
FAULTS: list[tuple[str, Change, str]] = [
    ("samples", settings(points=0), "points = 0 is wrong: give a whole number from 1 to 65536"),
    ("samples", settings(points="many"), 'the setting points is "many": it should be of type int'),
    ("lobes", without("tables_version"), OTHER_TABLES),
    ("lobes", settings(base_size=1), "the setting base_size is 1: it should be of type float"),
    *(("lobes", settings(base_size=size), ABOVE_0) for size in (0.0, -1.0, float("nan"), float("inf"))),
    ("lobes", tensor("coverage", lambda values: values[:, 1:]), "tensor model.coverage is "),
    ("lobes", tensor("coverage", lambda values: values[:, :, 4:]), "tensor model.coverage is "),
    ("lobes", tensor("coverage", lambda values: values.astype(np.int16)), "int16: it should be "),
    ("lobes", tensor("projected_area", lambda values: values[:, 1:]), "tensor model.projected_area is "),
    ("lobes", tensor("light_visibility", lambda values: values[..., :4]), "model.light_visibility is "),
    ("lobes", tensor("light_visibility", lambda values: values[:, 0]), "model.light_visibility is "),
    ("lobes", tensor("joint", lambda values: values[:, :1]), "tensor model.joint is "),
    ("lobes", tensor("moments", lambda values: values[..., :11]), "tensor model.moments is "),
    ("lobes", tensor("warp_packs", lambda values: values + 100), "tensor model.warp_packs "),
    ("lobes", tensor("levels", lambda values: values.astype(np.int32)), "int32: it should be "),
    ("lobes", tensor("levels", lambda values: values[:, :2]), "tensor model.levels is "),
    ("lobes", tensor("levels", lambda levels: levels[:0]), PYRAMID),
    ("lobes", tensor("levels", lambda levels: levels[1:]), PYRAMID),
    ("lobes", tensor("levels", lambda levels: levels + np.array([1, 0, 0])), PYRAMID),
    ("lobes", tensor("levels", lambda levels: levels * np.array([1, 0, 1])), PYRAMID),
    ("lobes", tensor("levels", lambda levels: levels * np.array([1, -1, -1])), PYRAMID),
    ("lobes", tensor("levels", _with_level(1, 7, 3, 3)), PYRAMID),
    ("lobes", tensor("levels", _with_level(0, 0, 1 << 40, 1 << 40)), PYRAMID),
    *(("lobes", _with_groups(groups), f"model.moments has {groups} groups") for groups in (0, 4, 12)),
    ("clustered", settings(tables_version=0), OTHER_TABLES),
    ("clustered", settings(tables_version=1), OTHER_TABLES),
    (
        "clustered",
        tensor("labels", lambda labels: np.full_like(labels, 77)),
        "model.labels holds 77: it should be 0 to 3 each, or 255",
    ),
    ("neumip", settings(columns=3), POWER_OF_2),
    ("neumip", settings(columns=32), "model.features is"),
    ("neumip", settings(faces=4), "faces = 4 is wrong"),
    ("latent", settings(version=1), OTHER_NETWORKS),
    ("latent", settings(features="all"), 'features = "all" is wrong: it is one of half-vector, none'),
    ("latent", settings(features="none"), "model.decoder.0.weight is"),
    ("latent", settings(columns=3), POWER_OF_2),
    ("latent", settings(columns=32), "model.latents is"),
    ("latent", settings(precision="int8"), 'precision = "int8" is wrong: it is one of float32, float16'),
    ("latent", settings(precision="float16"), "model.latents is"),
    ("latent", settings(faces=4), "faces = 4 is wrong"),
    ("latent", settings(decoder="9x9"), 'decoder = "9x9" is wrong: it is one of 2x16, 2x32, 3x64'),
    ("latent", settings(decoder="3x64"), "model.decoder.0.weight is"),
]


@pytest.mark.parametrize(
    ("name", "change", "says"), FAULTS, ids=[f"{number}-{name}" for number, (name, *_) in enumerate(FAULTS)]
)
def test_a_file_at_fault_is_one_sentence(name: str, change: Change, says: str) -> None:
    assert says in said_of(change(built(name, "plain").to_loom()))


def test_every_model_with_tables_has_faults_of_its_own() -> None:
    """Those without any have no tensors; `neural` has none but what all are asked above."""
    of_their_own = {name for name, _, _ in FAULTS}
    assert {*model_names()} - of_their_own == {"point", "neural"}
