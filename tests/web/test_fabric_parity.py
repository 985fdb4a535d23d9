"""The fabric package of the web clients against this one: drafts, colours, lengths, and what is refused."""

from __future__ import annotations

import base64
import json
import os
import shutil
import subprocess
import warnings
from math import degrees
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image, ImageColor

from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.fabric import Fabric, fabric_from_text, load_fabric
from loomlight.fabric.facts import cloth_facts
from loomlight.fabric.yarns import with_yarns
from loomlight.weave import Draft, load_draft, named_weave
from loomlight.weave.named import weave_names
from loomlight.weave.wif_writer import wif_text_of
from tests.limits import HANG

from ..weave import odd_drafts

# By the kind of a question and its text or path.
Answers = dict[tuple[str, str], dict[str, Any]]

WEB = Path(__file__).parents[2] / "web"
FIXTURES = sorted((Path(__file__).parents[1] / "weave" / "fixtures").glob("*.wif"))
# Both compute in double precision; their powers and sums differ in the last bits.
ROUNDING = 1e-12
# The layout cuts widths above the spacing; sums over thousands of threads run in another order.
WEIGHT_ROUNDING = 1e-9

# Names of the pages for users, of both directions, without numbers, and at the edges of what can be woven.
WEAVES = [
    *weave_names(),
    *(
        "tabby",
        "twill 2/1",
        "twill 2/2 s",
        "twill 3/1/1/2 z",
        "satin 8/3",
        "satin 5",
        "sateen 8/3",
        "satin 16",
    ),
    *("basket 3", "basket 2/3", "warp rib 2/3", "weft rib 3/2", "rib 3", "herringbone", "diamond 3/1 5"),
    *("Waffle16", "crêpe", "dogtooth 4", "houndstooth3", "shepherd's check", "glen-check 2", "LOG CABIN"),
    *("hairline", "prince of wales", "argyle", "diamond figure", "damask 160", "herringbone 2/1 5", "ogee"),
    *("2/2 twill", "s 2/2 Twill", "5-end satin", "8 shaft sateen", "satin weave 5", "5 weft-faced satin"),
    *(
        "gabardine",
        "gabardine s",
        "Serge 2/1",
        "poplin",
        "oxford",
        "oxford 3/1",
        "basket weave",
        "twill weave 2/1",
    ),
    *("tartan B/24 W4 B24 R2 K24 G24 W/2", "tartan ...R4 G4 DB3", "tartan K4R24,K24 Y4", "tartan k 5 lb 2…"),
]
REFUSED_WEAVES = [
    *("satin 8/2", "satin 6", "satin", "twill", "twill 2", "twill 2/0", "twill 99999/1", "houndstooth 0"),
    *("hounstooth", "hounds-tooth 4", "velvet", "", "waffle 5", "waffle 66", "damask 100", "argyle 33"),
    *("plain 2", "twill 2/1 q", "basket 1/2/3", "satin 8/3/1", "glen check 129", "diamond figure 40"),
    *("herringbone 2/2 1", "twill 1/1/1", "pinstripe 2000", "basket 3000"),
    *("2/2 velvet", "my twill 2/2", "2 plain", "tartan", "tartan B4", "tartan Q4 B4", "tartan B4 W/4 B4"),
    *("tartan B9999 W2", "tartan B4 W? K2", "tartan ...B/4 W4", "tartan B0 W4", "tartan B1001 W999 K3"),
]
TOML = [
    'weave = "twill 3/1"',
    'weave = "plain"\nends_per_cm = 30\n[warp]\ncolor = ["#f00", [0.1, 0.2, 0.3], "#00ff00"]\ngap = 0.1',
    'weave = "houndstooth"\nepi = 60\nppi = 40.5\nwarp.color = ["#000", "#fff"]\nweft.color = "#888"',
    'weave = "satin 8/3"\npicks_per_cm = 12\nwarp.count = "Ne 40/2"\nweft.width_mm = 0.3\nwarp.twist_deg = 9',
    'weave = "sateen 5"\nname = "a \\"b\\"\\n\\u00e9"\n[sheen]\nstrength = 1\n[variation]\nseed = 7',
    'weave = "twill 2/2"\nends_per_cm = 18\nwarp.count = "30 tex"\nweft.count = "Nm 28"\nweft.gap = 0.1',
    'weave = "twill 2/2"\nends_per_cm = 14\nyarn = "wool"\nwarp.count = "Nm 8"\nweft.yarn = "silk"',
    'weave = "plain"\npicks_per_cm = 9\nyarn = "linen"\nweft.yarn = "wool"\nweft.count = "Nm 8"',
    'weave = "gingham 4"\nwarp.color = ["#111", "#222", "#333"]\ngap = 0\nweft.height_scale = 2',
    'weave = "plain"\nwarp.color = "20 #223355, 4x#eee, #a0b0c0"\nweft.color = "#111,#222"',
    'weave = "twill 2/2"\nwarp.color = ["3 #223355", [0, 0.5, 1], "2 x #fff"]\nweft.albedo = "4 #666"',
]
REFUSED_TOML = [
    "",
    "gap = 0.1",
    "weave = 3",
    'weave = "plain"\ngap = 0.96',
    'weave = "plain"\ngap = true',
    'weave = "plain"\ngap = nan',
    'weave = "plain"\nroughness = 0.3',
    'weave = "plain"\nwarp = 3',
    'weave = "plain"\nwarp.roughness = "0.3"',
    'weave = "plain"\nwarp.color = []',
    'weave = "plain"\nwarp.color = "blue"',
    'weave = "plain"\nwarp.color = "0 #fff, 3 #000"',
    'weave = "plain"\nwarp.color = "9000 #fff, 9000 #000"',
    'weave = "plain"\nwarp.color = "3 #fff, blue"',
    'weave = "plain"\nwarp.color = "3 #fffff, 2 #000"',
    'weave = "plain"\nwarp.color = [0.1, 2, 0.3]',
    'weave = "plain"\nwarp.color = ["#fff", 3]',
    'weave = "houndstooth"\nwarp.count = "40 sheep"',
    'weave = "plain"\nvariation.seed = 1.0',
    'weave = "plain"\nvariation.seed = -1',
    'weave = "plain"\nends_per_cm = 10\nepi = 20',
    'weave = "plain"\nweft.gap = 0.1\nweft.width_mm = 0.3',
    'weave = "plain"\ndraft = "a.wif"',
    'weave = "plain"\nweave = "twill 2/1"',
    'weave = "plain',
    'weave = ""',
    'weave = "satin 5/2"\nwarp.color = ["#000", "#111"]\nsheen.colour = 1',
]


def _ask(questions: list[dict[str, Any]]) -> list[dict[str, Any]]:
    node = shutil.which("node")
    if node is None or not (WEB / "node_modules").is_dir():
        pytest.skip("needs Node and `npm install` in web/")
    done = subprocess.run(
        [node, "fabric/tools/report.mjs"],
        cwd=WEB,
        input=json.dumps(questions),
        capture_output=True,
        text=True,
        timeout=HANG,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    answers: list[dict[str, Any]] = json.loads(done.stdout)
    return answers


def _wif_files() -> list[Path]:
    data = os.environ.get("LOOMLIGHT_DATA")
    outside = [*sorted(Path(data, "wif").rglob("*.wif")), *Path(data, "cases").rglob("*.wif")] if data else []
    return [*FIXTURES, *outside]


def _asked(file: Path) -> dict[str, str]:
    return {"kind": "wif", "name": file.name, "base64": base64.b64encode(file.read_bytes()).decode()}


@pytest.fixture(scope="module")
def answers() -> Answers:
    """Answers of the web package by kind and text or path, all of one run of Node."""
    questions: list[dict[str, str]] = []
    keys: list[tuple[str, str]] = []
    for text in (*WEAVES, *REFUSED_WEAVES):
        questions.append({"kind": "weave", "text": text})
        keys.append(("weave", text))
    for text in (*TOML, *REFUSED_TOML):
        questions.append({"kind": "toml", "text": text})
        keys.append(("toml", text))
    for file in _wif_files():
        questions.append(_asked(file))
        keys.append(("wif", str(file)))
    return dict(zip(keys, _ask(questions), strict=True))


def _assert_same(answer: dict[str, Any], fabric: Fabric) -> None:
    draft = fabric.draft
    assert "error" not in answer, answer.get("error")
    assert (answer["ends"], answer["picks"]) == (draft.ends, draft.picks)
    packed = np.frombuffer(base64.b64decode(answer["drawdown"]), np.uint8)
    bits = np.unpackbits(packed, count=draft.drawdown.size)
    assert np.array_equal(bits.astype(bool).reshape(draft.drawdown.shape), draft.drawdown)
    layout = fabric.layout()
    assert answer["weight"] == pytest.approx(cloth_facts(fabric).weight, rel=WEIGHT_ROUNDING)
    for family, bend, threads, lying in (
        ("warp", answer["bends"][0], draft.warp, layout.warp),
        ("weft", answer["bends"][1], draft.weft, layout.weft),
    ):
        assert threads.colors is not None
        _assert_close(answer[family], threads.colors)
        # Widths above the spacing are cut by the layout, later than here.
        spacing, width = np.split(np.array(answer["lengths"][family]), 2)
        _assert_close(spacing, np.broadcast_to(lying.spacing, spacing.shape))
        _assert_close(np.minimum(width, 0.995 * spacing), np.minimum(lying.width, 0.995 * spacing))
        table = getattr(with_yarns(fabric.fields), family)
        if table.inclination_deg is None:
            assert bend["inclinationDeg"] == pytest.approx(degrees(lying.inclination))
        if table.twist_deg is None:
            assert bend["twistDeg"] == pytest.approx(degrees(lying.twist))


def _assert_close(found: object, expected: NDArray[np.float64]) -> None:
    values = np.asarray(found, dtype=np.float64).ravel()
    np.testing.assert_allclose(values, np.ravel(expected), rtol=ROUNDING, atol=ROUNDING)


@pytest.mark.parametrize("text", WEAVES)
def test_named_weaves_are_the_same(answers: Answers, text: str) -> None:
    answer = answers["weave", text]
    _assert_same(answer, fabric_from_text(text))
    assert answer["name"] == named_weave(text).title


@pytest.mark.parametrize("text", REFUSED_WEAVES)
def test_names_that_make_no_weave_are_refused_in_the_same_words(answers: Answers, text: str) -> None:
    with pytest.raises(InputError) as refusal:
        named_weave(text)
    assert answers["weave", text]["error"] == str(refusal.value)


@pytest.mark.parametrize("text", TOML)
def test_fabric_files_are_the_same(answers: Answers, text: str) -> None:
    answer = answers["toml", text]
    fabric = fabric_from_text(text)
    _assert_same(answer, fabric)
    assert fabric_from_text(answer["written"]).fields == fabric.fields


@pytest.mark.parametrize("text", REFUSED_TOML)
def test_fabric_files_that_cannot_be_are_refused(answers: Answers, text: str) -> None:
    with pytest.raises(InputError):
        fabric_from_text(text or "\n=")
    assert answers["toml", text]["error"]


@pytest.mark.parametrize("file", _wif_files(), ids=lambda file: f"{file.parent.name}/{file.stem}")
def test_weaving_information_files_are_the_same(answers: Answers, file: Path, tmp_path: Path) -> None:
    _assert_read_alike(answers["wif", str(file)], file, tmp_path)


def test_odd_files_are_the_same(tmp_path: Path) -> None:
    contents = [*odd_drafts.SILENT.values(), *(content for content, _ in odd_drafts.WARNED.values())]
    files = [tmp_path / f"{number}.wif" for number in range(len(contents))]
    for file, content in zip(files, contents, strict=True):
        file.write_bytes(content)
    for file, answer in zip(files, _ask([_asked(file) for file in files]), strict=True):
        _assert_read_alike(answer, file, tmp_path)


def _assert_read_alike(answer: dict[str, Any], file: Path, folder: Path) -> None:
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        draft, refusal = _draft_or_refusal(file)
    if draft is None:
        # The page knows a file by its name alone.
        assert answer["error"] == refusal.replace(str(file), file.name)
        return
    said = [str(warning.message) for warning in caught if issubclass(warning.category, LoomlightWarning)]
    assert answer["warnings"] == [text.replace(str(file), file.name) for text in said]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        _assert_same(answer, load_fabric(file))
    assert answer["isLoomTrue"]
    assert answer["isKeptByWriting"]
    assert answer["notes"] == list(draft.notes)
    written = folder / f"written-{file.name}"
    written.write_text(answer["written"], newline="")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        # Everything but the line that says which program wrote it.
        assert _lines(wif_text_of(load_draft(written))) == _lines(wif_text_of(draft))


def _draft_or_refusal(file: Path) -> tuple[Draft | None, str]:
    try:
        return load_draft(file), ""
    except InputError as refusal:
        return None, str(refusal)


def _lines(text: str) -> list[str]:
    return [line for line in text.split("\r\n") if not line.startswith("Source ")]


@pytest.mark.quick("black #eee")
@pytest.mark.parametrize("colours", ["blue red", "#30497a #6b2020", "black #eee", "#88f #ffa", "#222 #222"])
def test_pictures_are_read_by_the_same_rule(colours: str, tmp_path: Path) -> None:
    one, other = (np.array([*ImageColor.getrgb(colour), 255], np.uint8) for colour in colours.split())
    pixels = np.where(named_weave("twill 3/1 s").drawdown[..., None], one, other)
    path = tmp_path / "two.png"
    Image.fromarray(pixels).save(path)
    height, width = pixels.shape[:2]
    rgba = base64.b64encode(pixels.tobytes()).decode()
    question = {"kind": "picture", "name": str(path), "rgba": rgba, "width": width, "height": height}
    (answer,) = _ask([question])
    if np.array_equal(one, other):
        with pytest.raises(InputError) as refusal:
            load_draft(path)
        assert answer["error"] == str(refusal.value)
        return
    draft = load_draft(path)
    bits = np.unpackbits(np.frombuffer(base64.b64decode(answer["drawdown"]), np.uint8), count=16)
    assert np.array_equal(bits.astype(bool).reshape(4, 4), draft.drawdown)
