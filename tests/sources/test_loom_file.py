"""`.loom` files: fabrics come back exactly, and whatever is wrong with a file is one sentence.

Covers: sources/load.py, sources/kinds.py
"""

from __future__ import annotations

import hashlib
import json
import re
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from safetensors import safe_open
from safetensors.numpy import save, save_file

from loomlight.core.errors import InputError
from loomlight.core.images import write_pixels
from loomlight.fabric import Fabric, fabric_from_text, load_fabric
from loomlight.fabric.read import edited_fabric
from loomlight.models.bake import bake
from loomlight.models.registry import make_model, model_from_loom
from loomlight.sources.load import fabric_of_path
from loomlight.sources.loom_file import (
    UNITS,
    LoomFile,
    checksum,
    is_loom,
    read_loom,
    write_loom,
)
from loomlight.weave import Draft, Threads, draw_drawdown, named_weave, write_wif

HOUNDSTOOTH = """
    name = "Straße 7"
    weave = "houndstooth"
    ends_per_cm = 17.3
    optical_depth = 1.7
    [warp]
    color = ["#123456", "#fedcba"]
    twist_deg = 12.25
    [weft]
    count = "2x20 tex"
    [sheen]
    strength = 0.3
    [variation]
    fibre_noise = 0.1
    seed = 5
    """
TENSORS = {
    "latents": np.arange(12, dtype=np.float32).reshape(3, 4) / 7,
    "half": np.ones((2, 0, 3), np.float16),
    "table": np.array([3, 1, 2], np.uint32),
}


def wif_fabric(folder: Path) -> Fabric:
    """A WIF file of uneven threads of many colours, named by a fabric file beside it."""
    rng = np.random.default_rng(0)

    def threads(count: int) -> Threads:
        index = rng.integers(0, 3, count)
        colours = rng.integers(0, 256, (3, 3))[index] / 255
        return Threads(colours, rng.uniform(0.2, 0.6, count), rng.uniform(0.1, 0.3, count), index)

    draft = Draft(rng.random((7, 5)) < 0.5, threads(5), threads(7), title="uneven")
    write_wif(draft, folder / "uneven.wif")
    (folder / "cloth.toml").write_text('draft = "uneven.wif"\nends_per_cm = 20\n[weft]\ncolor = "#808080"')
    return load_fabric(folder / "cloth.toml")


def picture_fabric(folder: Path) -> Fabric:
    """A picture of a drawdown."""
    write_pixels(folder / "satin.png", draw_drawdown(named_weave("satin 5/2"), cell_px=1))
    return load_fabric(folder / "satin.png")


FABRICS: dict[str, Callable[[Path], Fabric]] = {
    "name": lambda _: fabric_from_text("twill 3/1"),
    "text": lambda _: fabric_from_text(HOUNDSTOOTH),
    "longer by its colours": lambda _: fabric_from_text(
        'weave = "plain"\n[warp]\ncolor = ["#000", "#111", "#222"]'
    ),
    "wif": wif_fabric,
    "picture": picture_fabric,
}


def same(first: Any, second: Any) -> None:
    """Equal in every number and bit of two dataclasses of arrays and numbers."""
    assert type(first) is type(second)
    if hasattr(first, "__dataclass_fields__"):
        for name in first.__dataclass_fields__:
            same(getattr(first, name), getattr(second, name))
    elif isinstance(first, np.ndarray):
        assert first.dtype == second.dtype
        assert np.array_equal(first, second)
    else:
        assert first == second


@pytest.mark.parametrize("kind", FABRICS)
def test_a_fabric_comes_back_exactly_without_its_files(kind: str, tmp_path: Path) -> None:
    source = tmp_path / "source"
    source.mkdir()
    fabric = FABRICS[kind](source)
    write_loom(tmp_path / "cloth.loom", LoomFile("point", fabric))
    shutil.rmtree(source)
    actual = fabric_of_path(tmp_path / "cloth.loom")
    same(actual.layout(), fabric.layout())
    same(actual.appearance(), fabric.appearance())
    assert actual.name == fabric.name
    assert actual.repeat_mm == fabric.repeat_mm
    # And once more, with what was read.
    write_loom(tmp_path / "again.loom", LoomFile("point", actual))
    assert (tmp_path / "again.loom").read_bytes() == (tmp_path / "cloth.loom").read_bytes()


def test_no_folder_of_the_author_is_in_the_file(tmp_path: Path) -> None:
    write_loom(tmp_path / "cloth.loom", LoomFile("point", wif_fabric(tmp_path)))
    (tmp_path / "elsewhere.toml").write_text(f"draft = '{tmp_path / 'uneven.wif'}'")
    write_loom(tmp_path / "other.loom", LoomFile("point", load_fabric(tmp_path / "elsewhere.toml")))
    for name in ("cloth.loom", "other.loom"):
        data = (tmp_path / name).read_bytes()
        assert b"uneven.wif" in data
        assert tmp_path.name.encode() not in data


def test_fields_can_be_edited_without_the_drafts_file(tmp_path: Path) -> None:
    fabric = wif_fabric(tmp_path)
    write_loom(tmp_path / "cloth.loom", LoomFile("point", fabric))
    (tmp_path / "red.toml").write_text(fabric.to_toml().replace("#808080", "#ff0000"))
    expected = load_fabric(tmp_path / "red.toml")
    (tmp_path / "uneven.wif").unlink()
    actual = edited_fabric(fabric_of_path(tmp_path / "cloth.loom"), {"weft.color": "#ff0000"})
    same(actual.layout(), expected.layout())
    same(actual.appearance(), expected.appearance())


def test_what_a_model_stores_comes_back(tmp_path: Path) -> None:
    path = tmp_path / "cloth.loom"
    settings = {"points": 16, "gain": 0.1, "fine": True, "note": "été"}
    loom = LoomFile("neural", fabric_from_text("plain"), TENSORS, settings, {"encoder": "ab" * 32})
    write_loom(path, loom)
    actual = read_loom(path)
    assert actual.model == "neural"
    assert actual.settings == settings
    assert actual.networks == {"encoder": "ab" * 32}
    assert actual.file == str(path)
    assert set(actual.tensors) == set(TENSORS)
    for name, values in TENSORS.items():
        assert np.array_equal(actual.tensor(name, values.shape, values.dtype), values)
    assert actual.tensor("latents", (None, 4), np.float32).shape == (3, 4)
    assert actual.setting("points", int) == 16
    assert actual.setting("note", str) == "été"
    actual.require_network("encoder", "ab" * 32)
    actual.require_model("neural")


def test_the_former_name_of_the_network_is_read(tmp_path: Path) -> None:
    path = tmp_path / "cloth.loom"
    write_loom(path, LoomFile("woven", fabric_from_text("plain"), networks={"woven": "ab" * 32}))
    actual = read_loom(path)
    assert (actual.model, dict(actual.networks)) == ("neural", {"neural": "ab" * 32})


def test_views_of_arrays_are_written_as_they_read(tmp_path: Path) -> None:
    """safetensors would write the memory of a transposed or byte-swapped array as it lies."""
    values = np.arange(6, dtype=np.float64).reshape(2, 3)
    tensors = {"turned": values.T, "swapped": values.astype(">f8")}
    write_loom(tmp_path / "a.loom", LoomFile("m", fabric_from_text("plain"), tensors))
    actual = read_loom(tmp_path / "a.loom").tensors
    assert np.array_equal(actual["turned"], values.T)
    assert np.array_equal(actual["swapped"], values)


@pytest.mark.parametrize(
    "values", [np.array([1.0, np.nan]), np.array([np.inf]), np.array([1j]), np.array("a")]
)
def test_what_no_file_should_hold_is_not_written(values: NDArray[Any], tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="bad"):
        write_loom(tmp_path / "a.loom", LoomFile("m", fabric_from_text("plain"), {"bad": values}))
    assert list(tmp_path.iterdir()) == []


def test_a_file_that_cannot_be_written_leaves_the_old_one(tmp_path: Path) -> None:
    loom = LoomFile("m", fabric_from_text("plain"))
    for path in ("none/a.loom", "a.toml"):
        with pytest.raises(InputError):
            write_loom(tmp_path / path, loom)
    assert list(tmp_path.iterdir()) == []


def test_asking_for_what_is_not_there() -> None:
    loom = LoomFile("m", fabric_from_text("plain"), TENSORS, {"points": 16, "fine": True}, file="a.loom")
    queries: list[tuple[Callable[[], Any], str]] = [
        (
            lambda: loom.tensor("other", (3,), np.float32),
            r"model.other is missing: it should be \[3\] float32",
        ),
        (lambda: loom.tensor("latents", (3, 5), np.float32), r"is \[3, 4\] float32: it should be \[3, 5\]"),
        (lambda: loom.tensor("latents", (12,), np.float32), r"should be \[12\] float32"),
        (lambda: loom.tensor("latents", (3, 4), np.float16), "should be .* float16"),
        (lambda: loom.setting("other", int), "other is missing: it should be of type int"),
        (lambda: loom.setting("fine", int), "fine is true: it should be of type int"),
        (lambda: loom.require_network("encoder", "ab" * 32), "does not say which, .* abab.* bake it again"),
        (lambda: loom.require_model("neural"), '"m", not "neural"'),
    ]
    for ask, says in queries:
        with pytest.raises(InputError, match=rf"^a\.loom: .*{says}"):
            ask()


def test_another_network_than_the_installed_one() -> None:
    made_with, other = (hashlib.sha256(text).hexdigest() for text in (b"weights", b"weightz"))
    loom = LoomFile("m", fabric_from_text("plain"), networks={"encoder": made_with}, file="a.loom")
    loom.require_network("encoder", made_with)
    with pytest.raises(InputError, match=rf"a\.loom: the network encoder .* {made_with[:12]}.*bake it again"):
        loom.require_network("encoder", other)


@pytest.fixture
def good(tmp_path: Path) -> Path:
    path = tmp_path / "good.loom"
    write_loom(path, LoomFile("point", wif_fabric(tmp_path), TENSORS, {"points": 3}))
    return path


def parts(path: Path) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """Header and tensors of a file, to be changed."""
    with safe_open(path, framework="numpy") as file:
        names = list(file.keys())
        return json.loads(file.metadata()["loom"]), {name: file.get_tensor(name) for name in names}


def put(path: Path, header: Any, tensors: dict[str, NDArray[Any]], valid: bool = True) -> None:
    """Writes what may be wrong, with a checksum that fits."""
    if valid:
        header["checksum"] = checksum(header["material"], tensors)
    save_file(tensors, path, {"loom": json.dumps(header)})


Change = Callable[[dict[str, Any], dict[str, NDArray[Any]]], Any]


def with_value(name: str, place: int, value: Any) -> Change:
    def change(_: dict[str, Any], tensors: dict[str, NDArray[Any]]) -> None:
        tensors[name] = tensors[name].copy()
        tensors[name].ravel()[place] = value

    return change


FAULTS: dict[str, tuple[Change, str]] = {
    "no schema": (lambda m, t: m.pop("schema"), "schema is None"),
    "schema of another kind": (lambda m, t: m.update(schema="1"), 'schema is "1"'),
    "schema true": (lambda m, t: m.update(schema=True), "schema is true"),
    "schema 0": (lambda m, t: m.update(schema=0), "from 1 to 4"),
    "newer": (lambda m, t: m.update(schema=5), "schema is 5, and this loomlight reads up to 4"),
    "no model": (lambda m, t: m.pop("model"), "model: Field required"),
    "an empty model": (lambda m, t: m.update(model=""), "model"),
    "a list of settings": (lambda m, t: m["settings"].update(points=[1]), "settings.points"),
    "unknown entries": (lambda m, t: m.update(more=1), "more"),
    "no source": (lambda m, t: m.pop("source"), "source: Field required"),
    "no kind": (lambda m, t: m["source"].pop("kind"), "of the kind None"),
    "an unknown kind": (lambda m, t: m["source"].update(kind="marble"), '"marble", which does not'),
    "no fields": (lambda m, t: m["source"].pop("toml"), "source.toml"),
    "bad fields": (lambda m, t: m["source"].update(toml='weave = "plain"\ngap = 2'), "gap = 2"),
    "no TOML": (lambda m, t: m["source"].update(toml="weave ="), "no valid TOML"),
    "other units": (lambda m, t: m.update(units=UNITS | {"length": "inch"}), '"length": "inch"'),
    "no drawdown": (lambda m, t: t.pop("source.drawdown"), "source.drawdown is missing"),
    "a drawdown of numbers": (
        lambda m, t: t.update({"source.drawdown": t["source.drawdown"].astype(np.int64)}),
        "true and false",
    ),
    "an empty drawdown": (lambda m, t: t.update({"source.drawdown": np.zeros((0, 3), bool)}), "source.w"),
    "a drawdown turned": (
        lambda m, t: t.update({"source.drawdown": np.ascontiguousarray(t["source.drawdown"].T)}),
        "source.warp.colors must hold [7, 3] float64 numbers from 0 to 1",
    ),
    "single precision": (
        lambda m, t: t.update({"source.warp.spacing_mm": t["source.warp.spacing_mm"].astype(np.float32)}),
        "source.warp.spacing_mm must hold [5] float64",
    ),
    "a negative spacing": (with_value("source.warp.spacing_mm", 2, -0.1), "source.warp.spacing_mm must hold"),
    "a colour above 1": (with_value("source.warp.colors", 2, 1.5), "source.warp.colors must hold"),
    "no thickness": (with_value("source.weft.thickness_mm", 0, 0.0), "source.weft.thickness_mm must"),
    "a wrong index": (with_value("source.warp.color_index", 0, -1), "source.warp.color_index must"),
    "NaN in the source": (with_value("source.warp.colors", 2, np.nan), "source.warp.colors holds NaN"),
    "NaN in the model": (with_value("model.latents", 5, np.nan), "model.latents holds NaN or infinity"),
    "infinity": (with_value("model.latents", 5, np.inf), "model.latents holds NaN or infinity"),
    "a stranger": (lambda m, t: t.update({"x": np.zeros(2)}), '"x" is neither'),
}


def refused(path: Path) -> str:
    """The sentence that reading `path` ends in; it names the file and is one printable line."""
    with pytest.raises(InputError) as caught:
        read_loom(path)
    sentence = str(caught.value)
    assert path.name in sentence
    assert sentence.isprintable()
    assert sentence.endswith(".")
    return sentence


@pytest.mark.parametrize("name", FAULTS)
def test_a_fault_is_one_sentence(name: str, good: Path) -> None:
    change, says = FAULTS[name]
    header, tensors = parts(good)
    change(header["material"], tensors)
    put(good, header, tensors)
    assert says in refused(good)


def test_headers_that_are_none(good: Path) -> None:
    header, tensors = parts(good)
    for text, says in {
        "": "header is damaged",
        "{": "header is damaged",
        "[]": "holds no material",
        '{"material": 3}': "holds no material",
        '{"material": {"schema": NaN}}': "header is damaged",
        "[" * 100_000: "header is damaged",
        '{"material": {"schema": ' + "9" * 5000 + "}}": "header is damaged",
    }.items():
        save_file(tensors, good, {"loom": text})
        assert says in refused(good)
    header["material"]["model"] = "another"
    put(good, header, tensors, valid=False)
    assert "does not fit its checksum" in refused(good)


def test_truth_values_other_than_0_and_1(good: Path) -> None:
    header, tensors = parts(good)
    tensors["source.drawdown"] = tensors["source.drawdown"].copy()
    tensors["source.drawdown"].view(np.uint8)[0, 0] = 7
    put(good, header, tensors)
    assert "true and false" in refused(good)


def test_files_of_another_kind(good: Path) -> None:
    data = good.read_bytes()
    bfloat = data.replace(b'"F32"', b'"I32"', 1)
    assert bfloat != data
    eight = json.dumps(
        {"x": {"dtype": "F8_E4M3", "shape": [2], "data_offsets": [0, 2]}, "__metadata__": {"loom": ""}}
    )
    for content, says in {
        save({"weight": np.ones(3, np.float32)}): "without the entry loom",
        save({"weight": np.ones(3, np.float32)}, {"format": "pt"}): "without the entry loom",
        bfloat: "checksum",
        len(eight).to_bytes(8, "little") + eight.encode() + b"ab": "of type F8_E4M3",
    }.items():
        good.write_bytes(content)
        assert says in refused(good), content[:80]


def test_truncated_files(good: Path) -> None:
    data = good.read_bytes()
    assert len(data) < 6000
    for length in range(0, len(data), 7):
        good.write_bytes(data[:length])
        refused(good)
    good.write_bytes(data + b"\0")
    refused(good)


def read_or_sentence(path: Path) -> LoomFile | str:
    """What a file holds, or why it cannot be read."""
    try:
        return read_loom(path)
    except InputError as error:
        return str(error)


def test_flipped_bits(good: Path) -> None:
    """What is read in spite of a flipped bit is what was written: the checksum covers all that is used."""
    data = good.read_bytes()
    rng = np.random.default_rng(1)
    expected = read_loom(good)
    for _ in range(1500):
        damaged = bytearray(data)
        for place in rng.integers(0, len(data), rng.integers(1, 4)):
            damaged[place] ^= 1 << rng.integers(0, 8)
        good.write_bytes(damaged)
        actual = read_or_sentence(good)
        if isinstance(actual, str):
            assert good.name in actual
            assert actual.isprintable()
            continue
        assert actual.model == expected.model
        same(actual.source.layout(), expected.source.layout())
        same(actual.source.appearance(), expected.source.appearance())
        for name, values in expected.tensors.items():
            assert np.array_equal(actual.tensors[name], values)


def test_nonsense_behind_a_valid_checksum(good: Path) -> None:
    """A file that somebody made, not one that was damaged: every value is looked at."""
    rng = np.random.default_rng(2)
    header, tensors = parts(good)
    refusals = 0
    for _ in range(400):
        changed = json.loads(json.dumps(header))
        arrays = {name: values.copy() for name, values in tensors.items()}
        if rng.random() < 0.5:
            values = arrays[rng.choice(list(arrays))].reshape(-1).view(np.uint8)
            for place in rng.integers(0, max(values.size, 1), min(values.size, 3)):
                values[place] ^= 1 << rng.integers(0, 8)
        else:
            text = list(changed["material"]["source"]["toml"])
            text[rng.integers(0, len(text))] = chr(rng.choice([0, 34, 45, 48, 57, 91, 101, 955, 0x1F600]))
            changed["material"]["source"]["toml"] = "".join(text)
        put(good, changed, arrays)
        actual = read_or_sentence(good)
        if isinstance(actual, str):
            assert good.name in actual
            assert actual.isprintable()
            refusals += 1
    assert 100 < refusals < 400


def of_first_schema(path: Path) -> None:
    """Rewrites a file as the first schema had it: the source was a fabric, and named so."""
    header, tensors = parts(path)
    material = header["material"]
    material["schema"] = 1
    source = material.pop("source")
    assert source.pop("kind") == "fabric"
    material["fabric"] = source
    put(path, header, {name.replace("source.", "fabric."): values for name, values in tensors.items()})


def test_the_fabric_of_the_first_schema_is_read(good: Path) -> None:
    expected = edited_fabric(fabric_of_path(good), {"interreflection": False})
    of_first_schema(good)
    actual = read_loom(good)
    assert actual.schema == 1
    same(fabric_of_path(good).layout(), expected.layout())
    same(fabric_of_path(good).appearance(), expected.appearance())


@pytest.mark.parametrize(("field", "meant"), [("", False), ("interreflection = true\n", True)])
def test_fabrics_of_the_second_schema_keep_their_look(tmp_path: Path, field: str, meant: bool) -> None:
    """Direct light alone, as that was the default then; what the file says counts, and models are used."""
    path = tmp_path / "old.loom"
    write_loom(path, make_model("point", fabric_from_text(f'{field}weave = "plain"')).to_loom())
    assert fabric_of_path(path).appearance().openness is not None
    header, tensors = parts(path)
    header["material"]["schema"] = 2
    put(path, header, tensors)
    assert fabric_of_path(path).fields.interreflection is meant
    again = model_from_loom(path)
    assert (again.source.appearance().openness is not None) is meant
    write_loom(path, again.to_loom())
    assert fabric_of_path(path).fields.interreflection is meant


def test_a_model_of_the_first_schema_says_how_to_bake_it_again(good: Path) -> None:
    of_first_schema(good)
    again = re.escape(f"`loomlight bake {good} --model point -o {good}`")
    with pytest.raises(InputError, match=again):
        model_from_loom(good)
    write_loom(good, bake(good, "point").to_loom())
    assert model_from_loom(good).name == "point"


def test_material_files_are_known_by_their_suffix() -> None:
    assert is_loom("a.loom")
    assert is_loom(Path("A.LOOM"))
    assert not is_loom("a.toml")
    assert not is_loom("loom")


def test_other_fabrics_are_read_as_ever() -> None:
    same(fabric_of_path("twill 3/1").layout(), fabric_from_text("twill 3/1").layout())
    with pytest.raises(InputError, match=r"none\.toml does not exist"):
        fabric_of_path("none.toml")
