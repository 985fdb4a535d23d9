"""The web client packs fabrics into the words that the Python package packs them into."""

from __future__ import annotations

import json
import shutil
import subprocess
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from loomlight.fabric import Fabric, fabric_from_text, load_fabric
from loomlight.models.lobes.model import DEFAULT_GROUPS
from loomlight.realtime.bake import BakePlan, _bake_record, _steps, plan_bake
from loomlight.realtime.records import numpy_type
from loomlight.realtime.words import Packed, pack_fabrics
from loomlight.scattering.irregularity import BLOCK, QUANTITIES, ROWS, SAMPLES
from loomlight.scattering.openness import Openness, ray_shares
from loomlight.viewer.messages import openness_json
from loomlight.weave.draft import Draft, Threads
from loomlight.yarn.geometry import YarnGeometry
from tests.limits import HANG
from tests.marks import slow

ROOT = Path(__file__).parents[2]
WEB = ROOT / "web"
EXAMPLES = [
    *sorted((ROOT / "examples").glob("*.toml")),
    *sorted((ROOT / "examples").glob("*.wif")),
    *sorted((ROOT / "tests" / "cases" / "drafts").glob("*.wif"))[:12],
]
# Beyond the examples: long floats, thin layers, wide gaps, colours in an order of their own.
TEXTS = [
    'weave = "houndstooth 4"\nwarp.color = ["#222222", "#c02040", "#ffffff"]\noptical_depth = 0.5',
    'weave = "satin 16/5"\nepi = 90\nppi = 60\nwarp.specular_grazing = 3\nweft.count = "Ne 30/2"',
    'weave = "basket 3"\ngap = 0.6\nwarp.inclination_deg = 70\nwarp.height_scale = 1.7\nweft.gap = 0',
    'weave = "plain"\nyarn = "wool"\nweft.plies = 3\nweft.ply_twist_deg = -20\nweft.hairiness = 0.2',
    'weave = "satin 5"\ninterreflection = true\nwarp.color = "#e0c060"\nweft.albedo = "#405060"',
    'weave = "gingham 8"\ninterreflection = true\noptical_depth = 0.6\nwarp.color = ["#fff", "#102"]\n'
    "weft.roughness = 0.2\nweft.translucency = 0.4\nweft.specular = 1\ngap = 0.4",
    'weave = "plain"\nyarn = "silk"\ninterreflection = true\nwarp.specular_transmit = "#123"\n'
    'warp.specular_tint = "#fc8"',
    # Neps of two colours, of warp and weft that vary alike, and others.
    'weave = "plain"\nyarn = "woollen"\nwarp.neps = 8\nweft.neps = 8\nweft.nep_color = "#a03020"\n'
    "variation.colour_noise = 0.2",
    'weave = "twill 3/1"\nwarp.yarn = "dupion silk"\nweft.yarn = "linen"\ninterreflection = true\n'
    "weft.neps = 3\nweft.melange = 0.3\nvariation.irregularity = 1.5",
    'weave = "twill 3/1"\nwear = 0.4\nwarp.color = "#1c2340"\nweft.albedo = "#000"\ninterreflection = true',
    'weave = "damask 160"\nwarp.color = ["#111", "#777", "#eee", "#900", "#070"]',
]
# Whose openness the page fits to rays itself.
FOUND = (
    'weave = "satin 5"\ninterreflection = true\nweft.color = "#b05040"\nweft.roughness = 0.5\n'
    'warp.color = ["#e0c060", "#506070", "#d0d0d0"]\nwarp.specular = 0.6\nwarp.translucency = 0.2'
)
# Both compute in double precision, where sums differ in their last bits, and round to single precision.
ROUNDING = 3e-7
UV_SIZE_MM = (90.0, 110.0)


@dataclass(frozen=True)
class Pair:
    """What Python packs a fabric into, and the bytes of the page's buffers by name."""

    packed: Packed
    plan: BakePlan
    page: dict[str, bytes]


def _threads(threads: Threads) -> dict[str, Any]:
    def flat(values: NDArray[Any] | None) -> list[float] | None:
        return None if values is None else np.ravel(values).tolist()

    return {
        "colors": flat(threads.colors),
        "spacingMm": flat(threads.spacing_mm),
        "thicknessMm": flat(threads.thickness_mm),
        "colorIndex": flat(threads.color_index),
    }


def _question(fabric: Fabric) -> dict[str, Any]:
    draft: Draft = fabric.named_draft
    return {
        "fields": fabric.fields.model_dump(exclude_none=True),
        "ends": draft.ends,
        "picks": draft.picks,
        "drawdown": "".join("01"[int(up)] for up in draft.drawdown.ravel()),
        "warp": _threads(draft.warp),
        "weft": _threads(draft.weft),
        "uvSizeMm": UV_SIZE_MM,
        "openness": None if fabric.fields.interreflection is False else openness_json(fabric),
    }


def _ray_words(fabric: Fabric) -> NDArray[np.uint32]:
    """What the kernel `bake_openness` would write of the rays that Python casts."""
    look = fabric.appearance()
    met = ray_shares(
        YarnGeometry(fabric.layout()),
        look.diffuse_blend,
        (look.warp.roughness, look.weft.roughness),
        look.optical_depth,
    )
    flags = np.stack([met.is_warp, ~met.is_yarn, met.is_blocked, met.meets_warp]).astype(np.uint32)
    bits = (flags << np.arange(4, dtype=np.uint32)[:, None]).sum(axis=0, dtype=np.uint32)
    layers = met.layers.reshape(4, -1)
    numbers = np.stack([met.normal_cosines, met.heights, *met.halves, met.far, *layers], axis=1)
    words = np.ascontiguousarray(numbers, np.float32).view(np.uint32)
    return np.concatenate([bits[:, None], words], axis=1)


@pytest.fixture(scope="module")
def pairs(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> dict[int, Pair]:
    """Of the fabrics that the chosen tests are of, by their numbers."""
    node = shutil.which("node")
    if node is None or not (WEB / "node_modules").is_dir():
        pytest.skip("needs Node, and `npm install` in web/: scripts/setup.sh does both")
    sources = [*EXAMPLES, *TEXTS]
    chosen = {item.callspec.params["number"] for item in request.session.items if _is_of_a_fabric(item)}
    numbers = [*sorted(chosen), len(sources)]
    fabrics = [_fabric_of(sources[number]) for number in numbers[:-1]] + [fabric_from_text(FOUND)]
    folder = tmp_path_factory.mktemp("packed")
    questions = [_question(fabric) for fabric in fabrics]
    questions[-1] |= {"openness": None, "rays": _ray_words(fabrics[-1]).ravel().tolist()}
    (folder / "questions.json").write_text(json.dumps(questions))
    command = [node, "loomlight-web/tools/pack_report.mjs", str(folder / "questions.json"), str(folder)]
    subprocess.run(command, cwd=WEB, check=True, timeout=HANG)
    result = {}
    for number, fabric in enumerate(fabrics):
        plan = plan_bake(fabric.layout(), DEFAULT_GROUPS)
        served = questions[number]["openness"]
        if served is not None:
            plan = replace(plan, joint=np.array(served["joint"], np.uint32).view(np.int16))
        packed = pack_fabrics([(fabric.layout(), fabric.appearance())], [UV_SIZE_MM], [plan.shader_tables()])
        names = ("fabrics", "families", "words", "bake", "steps")
        page = {name: (folder / f"{number}.{name}").read_bytes() for name in names}
        result[numbers[number]] = Pair(packed, plan, page)
    return result


def _is_of_a_fabric(item: Any) -> bool:
    return item.path == Path(__file__) and hasattr(item, "callspec") and "number" in item.callspec.params


def _fabric_of(source: Path | str) -> Fabric:
    return load_fabric(source) if isinstance(source, Path) else fabric_from_text(source)


# The quick ones have holes, plies, light between yarns, many colours, and irregular yarns.
NUMBERS = [
    number if number in (0, *range(len(EXAMPLES) + 2, len(EXAMPLES) + 9)) else slow(number)
    for number in range(len(EXAMPLES) + len(TEXTS))
]


def _assert_alike(ours: NDArray[np.void], theirs: NDArray[np.void], names: list[str]) -> None:
    for name in names:
        one, other = ours[name], theirs[name]
        if one.dtype.names:
            _assert_alike(one, other, list(one.dtype.names))
        elif one.dtype == np.uint32:
            assert one.tolist() == other.tolist(), name
        else:
            np.testing.assert_allclose(other, one, rtol=ROUNDING, atol=1e-12, err_msg=name)


@pytest.mark.parametrize("number", NUMBERS)
def test_records_are_those_of_python(pairs: dict[int, Pair], number: int) -> None:
    pair = pairs[number]
    for name, ours in (("fabrics", pair.packed.fabrics), ("families", pair.packed.families)):
        theirs = np.frombuffer(pair.page[name], ours.dtype)
        _assert_alike(ours, theirs, list(ours.dtype.names or ()))


@pytest.mark.parametrize("number", NUMBERS)
def test_words_are_those_of_python(pairs: dict[int, Pair], number: int) -> None:
    """Whole numbers bit for bit, others within rounding; axes of colours are compared by what they make."""
    packed, page = pairs[number].packed, pairs[number].page
    ours, theirs = packed.words, np.frombuffer(page["words"], np.uint32)
    assert ours.size == theirs.size
    is_compared = np.ones(ours.size, bool)
    for family in packed.families:
        is_compared[_colour_words(packed, family)] = False
    whole = ours == theirs
    # Sums in double precision, rounded to whole units: what lies half way may go either way.
    for first in set(packed.families["irregular_table"][packed.families["irregular_tone"] > 0].tolist()):
        table = slice(first, first + (ROWS + BLOCK + 1) * SAMPLES * QUANTITIES)
        whole[table] = np.abs(ours[table].view(np.int32) - theirs[table].view(np.int32)) <= 1
    close = np.isclose(ours.view(np.float32), theirs.view(np.float32), rtol=ROUNDING, atol=1e-9)
    assert (whole | close)[is_compared].all()
    fabric = packed.fabrics[0]
    runs = slice(int(fabric["run_words"]), int(fabric["lobes"]["levels"]))
    assert whole[runs].all()


def _colour_words(packed: Packed, family: np.void) -> slice:
    """Axes, and the tables along them, whose signs are free."""
    first, others = int(family["colour_axes"]), [int(other["before"]) for other in packed.families]
    ends = [end for end in (*others, int(packed.fabrics[0]["run_words"])) if end >= first]
    return slice(first, min(ends))


@pytest.mark.parametrize("number", NUMBERS)
def test_colours_over_footprints_are_those_of_python(pairs: dict[int, Pair], number: int) -> None:
    """Albedos of every thread, and their integrals over all prefixes of the repeat."""
    packed, page = pairs[number].packed, pairs[number].page
    theirs = np.frombuffer(page["words"], np.uint32)
    fabric = packed.fabrics[0]
    size = packed.words[int(fabric["run_words"]) : int(fabric["max_heights"])].size // 2
    for family in packed.families:
        quantities, count = int(family["quantities"]), int(family["count"])
        if quantities == 1:
            continue
        entries = (size // count + 1) * (count + 1)
        found = []
        for words in (packed.words, theirs):
            numbers = words.view(np.float32)
            axes = numbers[int(family["colour_axes"]) :][: 12 * (quantities - 1)].reshape(-1, 12)
            rows = numbers[int(family["colour_threads"]) :][: 3 * quantities * (count + 1)]
            areas = words[int(family["colour_areas"]) :][: entries * quantities].view(np.int32)
            found.append(
                (
                    rows.reshape(-1, quantities)[:, 1:] @ axes,
                    areas.reshape(-1, quantities)[:, 1:].astype(np.float64) @ axes,
                    areas.reshape(-1, quantities)[:, 0],
                )
            )
        (threads, sums, weights), (page_threads, page_sums, page_weights) = found
        scale = float(family["period"])
        np.testing.assert_allclose(page_threads, threads, atol=3e-7 * max(scale, 1))
        # Entries are rounded to whole units, each by half at most.
        assert np.abs(page_weights.astype(np.int64) - weights).max() <= 1
        # Axes in single precision of sums of 2e9 units at most: 1e-7 of them.
        np.testing.assert_allclose(page_sums, sums, atol=500)


@pytest.mark.parametrize("number", NUMBERS)
def test_bakes_are_told_what_python_tells_them(pairs: dict[int, Pair], number: int) -> None:
    pair = pairs[number]
    record = _bake_record(pair.plan, pair.packed.fabrics, 0)
    theirs = np.frombuffer(pair.page["bake"], numpy_type("Bake"))
    _assert_alike(record, theirs, list(record.dtype.names or ()))
    steps, their_steps = _steps(pair.plan).ravel(), np.frombuffer(pair.page["steps"], np.uint32)
    same = steps == their_steps
    assert (same | np.isclose(steps.view(np.float32), their_steps.view(np.float32), rtol=ROUNDING)).all()


def test_openness_is_fitted_as_python_fits_it(pairs: dict[int, Pair]) -> None:
    """The fit, and the colours that follow, of the same rays in single precision."""
    pair = pairs[len(EXAMPLES) + len(TEXTS)]
    packed, page = pair.packed, pair.page
    theirs = np.frombuffer(page["fabrics"], packed.fabrics.dtype)[0]
    ours = packed.fabrics[0]
    assert theirs["openness"] == ours["openness"]
    size = sum(Openness.word_counts({}).values())
    words = (packed.words, np.frombuffer(page["words"], np.uint32))
    numbers, found = (array.view(np.float32)[int(ours["openness"]) :][:size] for array in words)
    # Rays that are rounded to single precision move coefficients of terms that go together by 1e-5 at most.
    np.testing.assert_allclose(found, numbers, atol=1e-4)
    for family, threads in zip(packed.families, (3, 1), strict=True):
        first = int(family["albedo_table"])
        albedos = [array.view(np.float32)[first:][: 12 * threads] for array in words]
        # Halvings stop at 1e-6; openness that differs by 1e-7 may decide the last of them otherwise.
        np.testing.assert_allclose(albedos[1], albedos[0], atol=4e-6)
