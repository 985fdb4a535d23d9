"""docs/mitsuba-parameters.md and mitsuba-edits.md against the code: ranges, defaults, live, differentiable.

Covers: mitsuba/props.py
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from typing import Any

import mitsuba as mi
import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.core.settings import declared
from loomlight.fabric import fabric_from_text
from loomlight.fabric.fields import FabricFile
from loomlight.fabric.read import edited_fabric
from loomlight.mitsuba.props import _field
from loomlight.models.bake import bake, save
from loomlight.models.registry import MODELS, model_class
from tests.helpers.interactions import pretrained
from tests.marks import slow_among

DOCS = Path(__file__).parents[2] / "docs"
PAGES = (DOCS / "mitsuba-parameters.md", DOCS / "mitsuba-edits.md")
TABLES = ("warp", "weft", "sheen", "variation")
_RANGE = re.compile(r"(-?[\d.]+) – (-?[\d.]+)")
pytestmark = pytest.mark.usefixtures("narrow_network")


@cache
def rows(first_header: str) -> list[dict[str, str]]:
    """Rows of all tables of the pages whose first column has this header."""
    found, header = [], None
    for line in (line for page in PAGES for line in page.read_text().splitlines()):
        if not line.startswith("|"):
            header = None
            continue
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if header is None:
            header = cells
        elif not set(line) <= set("|- ") and header[0] == first_header:
            found.append(dict(zip(header, cells, strict=True)))
    return found


def names_in(cell: str) -> list[str]:
    return re.findall(r"`([\w.]+)`", cell)


def test_every_field_and_option_stands_on_the_page() -> None:
    listed = {name for row in rows("property") for name in names_in(row["property"])}
    listed |= {name for row in rows("property") if "`draft`" in row["meaning"] for name in ("draft", "image")}
    fields = {name for name in FabricFile.model_fields if name not in (*TABLES, "maps", "weaves", "artwork")}
    for table in TABLES:
        own = FabricFile.model_fields[table].annotation.model_fields
        fields |= {f"{table}_{name}" for name in own if table != "weft"}
    assert listed - {"fabric", "source", "uv_size", "uv_scale", "albedo", "pixel_angle"} == fields
    assert all(_field(name) is not None for name in fields)
    options = {(row["BSDF"].strip("`"), *names_in(row["option"])) for row in rows("BSDF")}
    assert options == {
        (entry.plugin, option)
        for name, entry in MODELS.items()
        for option in declared(model_class(name).options_class)
    }


def test_ranges_of_properties_are_those_of_fields() -> None:
    cloth, checked = fabric_from_text("plain"), 0
    for row in rows("property"):
        span = _RANGE.fullmatch(row["range"])
        for name in names_in(row["property"]):
            field = _field(name)
            is_colour = "color" in row["unit"] + row["property"] or "colour" in row["unit"] or "tint" in name
            if (
                span is None
                or field is None
                or is_colour
                or field.partition(".")[2].endswith(("reflect", "transmit"))
            ):
                continue
            kind = int if name.endswith(("_seed", "_plies")) else float
            step = 1 if kind is int else 1e-3
            low, high = (kind(float(number)) for number in span.groups())
            for value, right in ((low, True), (high, True), (low - step, False), (high + step, False)):
                try:
                    edited_fabric(cloth, {field: value})
                    fits = True
                except InputError as error:
                    # Densities may contradict widths; only the field's own range is meant here.
                    fits = "cannot be used" not in str(error)
                assert fits == right, (field, value)
            checked += 1
    assert checked > 15


def bsdfs_of(plugin: str, folder: Path) -> list[Any]:
    """BSDFs that show every parameter among them."""
    texture = {"type": "bitmap", "bitmap": mi.Bitmap(np.full((4, 4, 3), 0.5, np.float32)), "raw": True}
    cloth: dict[str, Any] = {"type": plugin, "weave": "plain", "sheen_strength": 0.3, "albedo": texture}
    # The cheapest bakes: parameters are the same.
    if plugin == "woven_samples":
        cloth["points"] = 2
    if plugin == "woven_clustered":
        cloth |= {"clusters": 4, "texels": 32}
    if plugin == "woven_neural":
        cloth |= {"other": "twill 2/1", "refined": False}
    cloths = (cloth, cloth | {"warp_color": "#ff0000,#00ff00"})
    return [mi.load_dict(pretrained(each, folder)) for each in cloths]


@pytest.mark.quick("woven_neural", "woven_samples", "woven_point")
@pytest.mark.parametrize(
    "plugin",
    slow_among((entry.plugin for entry in MODELS.values()), ("woven_clustered", "neumip", "latent")),
)
def test_every_scene_parameter_stands_on_the_page(plugin: str, tmp_path: Path) -> None:
    wanted = {
        name: row
        for row in rows("parameter")
        for name in names_in(row["parameter"])
        if row[f"`{plugin}`"] != "–"
    }
    seen = set()
    for bsdf in bsdfs_of(plugin, tmp_path):
        params = mi.traverse(bsdf)
        for key in params.keys():  # noqa: SIM118 (no mapping)
            name = key.replace("weft.", "warp.")
            if name.startswith("albedo.") and name != "albedo.data":
                continue  # "the texture's own parameters"
            assert name in wanted, f"{key} of {plugin} does not stand on {PAGES[1].name}"
            seen.add(name)
            fixed = params.flags(key) & mi.ParamFlags.NonDifferentiable.value
            assert (wanted[name][f"`{plugin}`"] == "gradient") == (not fixed), key
            if name == "albedo.data":
                continue
            parameter = bsdf.edits.parameters[key]
            span = _RANGE.fullmatch(wanted[name]["range"])
            if span is not None:
                low, high = (float(number) for number in span.groups())
                np.testing.assert_allclose(
                    [parameter.low, parameter.high], [low, high], atol=1e-3, err_msg=key
                )
            assert parameter.unit == wanted[name]["unit"]
            if wanted[name]["default"][:1].isdigit():
                np.testing.assert_allclose(
                    np.array(params[key]).ravel()[0], float(wanted[name]["default"]), rtol=1e-6, err_msg=key
                )
    assert seen == set(wanted)


FORMS = {
    "a fabric file": {"fabric": "cloth.toml"},
    "fields replaced": {"fabric": "cloth.toml", "warp_roughness": 0.7},
    "a material": {"fabric": "cloth.loom"},
    "a draft": {"fabric": "scarf.wif"},
    "a draft as a field": {"draft": "scarf.wif", "ends_per_cm": 12.0},
    "a name": {"source": "satin 5"},
    "a name as a field": {"weave": "satin 5"},
}
WIF = """[WIF]
Version=1.1
[CONTENTS]
WEAVING=true
WARP=true
WEFT=true
THREADING=true
TIEUP=true
TREADLING=true
[WEAVING]
Shafts=5
Treadles=5
[WARP]
Threads=5
[WEFT]
Threads=5
[THREADING]
1=1
2=2
3=3
4=4
5=5
[TIEUP]
1=1
2=3
3=5
4=2
5=4
[TREADLING]
1=1
2=2
3=3
4=4
5=5
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    found = tmp_path_factory.mktemp("cloths")
    (found / "cloth.toml").write_text('weave = "satin 5"\n')
    (found / "scarf.wif").write_text(WIF)
    save(bake(str(found / "cloth.toml"), "point"), found / "cloth.loom")
    return found


@pytest.mark.parametrize("form", FORMS)
def test_sources_are_found_from_dictionaries_and_scene_files(
    form: str, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    values = "".join(
        f'<float name="{name}" value="{value}"/>'
        if isinstance(value, float)
        else f'<string name="{name}" value="{value}"/>'
        for name, value in FORMS[form].items()
    )
    file = folder / f"{form.replace(' ', '_')}.xml"
    file.write_text(
        '<scene version="3.0.0"><shape type="rectangle">'
        f'<bsdf type="woven_point">{values}</bsdf></shape></scene>'
    )
    # A scene file's folder is not the current one.
    of_file = mi.load_file(str(file)).shapes()[0].bsdf()
    monkeypatch.chdir(folder)
    of_dictionary = mi.load_dict({"type": "woven_point", **FORMS[form]})
    for bsdf in (of_file, of_dictionary):
        assert bsdf.model.fabric.layout().warp_on_top.shape == (5, 5)
