"""The fabric package of the web clients against this one: drafts, colours, lengths, and what is refused."""

from __future__ import annotations

import base64
import json
import os
import shutil
import subprocess
import warnings
from dataclasses import asdict
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
from loomlight.viewer.messages import artwork_json
from loomlight.weave import Draft, load_draft, named_weave
from loomlight.weave.named import weave_names
from loomlight.weave.wif_writer import wif_text_of
from tests.limits import HANG

from ..weave import odd_drafts

# By the kind of a question and its text or path.
Answers = dict[tuple[str, str], dict[str, Any]]

WEB = Path(__file__).parents[2] / "web"
# Judge both languages: drafts, weaves, fabric files, counts.
CASES = Path(__file__).parents[1] / "cases"
FIXTURES = sorted((CASES / "drafts").glob("*.wif"))
# Both compute in double precision; their powers and sums differ in the last bits.
ROUNDING = 1e-12
# The layout cuts widths above the spacing; sums over thousands of threads run in another order.
WEIGHT_ROUNDING = 1e-9

# Of `cases`, which say what is read and what is refused; all names of the pages for users beside those.
_WEAVES, _FABRICS = (
    json.loads((CASES / f"{kind}.json").read_text("utf-8")) for kind in ("weaves", "fabrics")
)
WEAVES, REFUSED_WEAVES = [*weave_names(), *_WEAVES["woven"]], _WEAVES["refused"]
TOML, REFUSED_TOML = _FABRICS["read"], _FABRICS["refused"]


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
        resolved = asdict(getattr(fabric.resolved, family).irregularity)
        # Neps' albedos follow from what cloth is like, not from the file alone.
        assert answer["irregularity"][family] == {
            name: pytest.approx(value, rel=ROUNDING)
            for name, value in resolved.items()
            if name != "nep_albedo"
        }
        # The page lays layered cloth in one plane, whose weave is that of all threads.
        if layout.layers:
            continue
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


# Text of a fabric file after `image`, and colours and size of a random picture.
ARTWORKS = {
    "damask": (
        """ends_per_cm = 30
[weaves]
"#c00000" = "satin 8/3"
"#FFF" = "sateen 8/3"
"#336" = "twill 2/2 s"
""",
        ["#c00000", "#ffffff", "#333366"],
        (48, 40),
    ),
    "a weave that is cut": (
        """[weaves]
"#c00000" = "satin 7/2"
"#ffffff" = "plain"
""",
        ["#c00000", "#ffffff"],
        (48, 40),
    ),
    "two wefts in an order": (
        """picks_per_cm = 24
[weaves]
"#c00000" = ["plain", "satin 16"]
"#ffffff" = ["satin 16", "sateen 8/3"]
"#00c000" = ["twill 1/3", "BACK"]
[artwork]
order = "2x1, 2"
[weft]
color = ["#e8e0cc", "#c8902c"]
""",
        ["#c00000", "#ffffff", "#00c000"],
        (64, 32),
    ),
    "extra wefts": (
        """epi = 120
[weaves]
"#c00000" = ["plain", "back", "back"]
"#ffffff" = ["plain", "sateen 8/3", "back"]
"#00c000" = ["twill 2/2", "back", "satin 5"]
[artwork]
regulator = 2
longest_float = 6
""",
        ["#c00000", "#ffffff", "#00c000"],
        (40, 40),
    ),
    "the nearest colour": (
        """[weaves]
"#f00000" = "satin 5"
"#0000f0" = "sateen 5"
[artwork]
nearest = true
""",
        ["#e01010", "#1020d0", "#802080"],
        (50, 30),
    ),
    "a colour that no pixel has": (
        """[weaves]
"#c00000" = "plain"
"#ffffff" = "basket 2/2"
"#010203" = "weft rib 12"
""",
        ["#c00000", "#ffffff"],
        (32, 32),
    ),
}
REFUSED_ARTWORKS = [
    """[weaves]\n"#c00000" = "satin 8/3"\n"#c0ffee" = "plain"\n""",
    """[weaves]\n"#c00000" = "satin 8/2"\n"#ffffff" = "plain"\n""",
    """[weaves]\n"#c00000" = ["back", "back"]\n"#ffffff" = ["plain", "plain"]\n""",
    """[weaves]\n"#c00000" = "back"\n"#ffffff" = "plain"\n""",
    """[weaves]\n"#c00000" = "plain"\n"#ffffff" = "plain"\n[artwork]\norder = "1 2"\n""",
    """[weaves]\n"#c00000" = ["plain", "crepe"]\n"#ffffff" = ["plain", "crepe"]\n[artwork]\nregulator = 3""",
    """[weaves]\n"#c00000" = "satin 16"\n"#ffffff" = "sateen 16"\n[artwork]\nlongest_float = 2\n""",
]


def _artwork_question(path: Path, toml: str, colours: list[str], size: tuple[int, int]) -> dict[str, Any]:
    """Writes an artwork of blots and its fabric file, and asks the web package for its cloth."""
    width, height = size
    draws = np.random.default_rng(len(toml))
    # Blots four pixels wide, and single pixels among them.
    blots = draws.integers(len(colours), size=(height // 4 + 1, width // 4 + 1)).repeat(4, 0).repeat(4, 1)
    single = draws.integers(len(colours), size=(height, width))
    index = np.where(draws.random((height, width)) < 0.05, single, blots[:height, :width])
    palette = np.array([ImageColor.getrgb(colour) for colour in colours], np.uint8)
    Image.fromarray(palette[index]).save(path)
    text = f'image = "{path.name}"\n{toml}'
    path.with_suffix(".toml").write_text(text)
    opaque = np.full((height, width, 1), 255, np.uint8)
    rgba = base64.b64encode(np.concatenate([palette[index], opaque], axis=2).tobytes()).decode()
    return {
        "kind": "artwork",
        "name": path.name,
        "toml": text,
        "rgba": rgba,
        "width": width,
        "height": height,
    }


def test_artworks_are_woven_the_same(tmp_path: Path) -> None:
    questions = [
        _artwork_question(tmp_path / f"art{number}.png", *case)
        for number, case in enumerate(ARTWORKS.values())
    ]
    for question, answer in zip(questions, _ask(questions), strict=True):
        file = tmp_path / question["name"]
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            fabric = load_fabric(file.with_suffix(".toml"))
        _assert_same(answer, fabric)
        said = [str(warning.message) for warning in caught if "is cut where" in str(warning.message)]
        assert said == ([] if answer["cut"] is None else [answer["cut"].replace(file.name, str(file))])
        assert answer["json"] == artwork_json(fabric)


def test_artworks_that_cannot_be_woven_are_refused_in_the_same_words(tmp_path: Path) -> None:
    # The commonest of two colours that the first one names no weave for is told of.
    questions = [
        _artwork_question(tmp_path / f"bad{number}.png", toml, colours, (32, 32))
        for number, toml in enumerate(REFUSED_ARTWORKS)
        for colours in [["#c00000", "#ffffff", "#00ff00"] if number == 0 else ["#c00000", "#ffffff"]]
    ]
    for question, answer in zip(questions, _ask(questions), strict=True):
        file = tmp_path / question["name"]
        with pytest.raises(InputError) as refusal:
            load_fabric(file.with_suffix(".toml"))
        expected = (
            str(refusal.value).replace(f"{file.with_suffix('.toml')}: ", "").replace(str(file), file.name)
        )
        assert answer["error"] == expected
