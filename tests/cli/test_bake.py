"""`loomlight bake`, and pictures of what it writes.

Covers: models/bake.py, sources/load.py, cli/options.py
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import mitsuba as mi
import numpy as np
import pytest

import loomlight.mitsuba  # noqa: F401 (registers the plugins)
from loomlight.cli.main import run
from loomlight.core.errors import InputError
from loomlight.core.llvm import require_llvm
from loomlight.fabric import load_fabric
from loomlight.models.registry import MODELS, model_from_loom
from loomlight.sources.loom_file import read_loom
from loomlight.weave import named_weave, write_wif
from tests.marks import slow_among

require_llvm()
mi.set_variant("llvm_ad_rgb")

PICTURE = ["--scene", "flat", "--size", "16x12", "--spp", "1", "--zoom", "40", "--light", "directional"]


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A fabric file with a WIF file beside it, and the same baked for samples."""
    monkeypatch.chdir(tmp_path)
    write_wif(named_weave("houndstooth"), "hound.wif")
    Path("cloth.toml").write_text('draft = "hound.wif"\nends_per_cm = 18\n[weft]\nroughness = 0.2')
    assert run(["bake", "cloth.toml", "--model", "samples", "-o", "cloth.loom"]) == 0
    return tmp_path


@pytest.mark.slow
def test_a_baked_fabric_needs_its_draft_no_more(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert model_from_loom("cloth.loom").name == "samples"
    picture = ["--scene", "flat", "--size", "24x16", "--spp", "1", "--zoom", "30"]
    assert run(["render", "cloth.toml", "--model", "samples", "-o", "before.exr", *picture]) == 0
    (folder / "hound.wif").unlink()
    (folder / "cloth.toml").unlink()
    assert run(["render", "cloth.loom", "-o", "after.exr", *picture]) == 0
    capsys.readouterr()
    assert run(["render", "cloth.loom", "--model", "samples", "-o", "named.exr", *picture]) == 0
    assert capsys.readouterr().err == ""
    before, after, named = (np.array(mi.Bitmap(f"{name}.exr")) for name in ("before", "after", "named"))
    assert before.std() > 0.01
    np.testing.assert_allclose(named, after, rtol=1e-4, atol=1e-6)
    # A picture of a material is one by the model that it holds: the same samples, in whatever order threads
    # add them up.
    np.testing.assert_allclose(after, before, rtol=1e-4, atol=1e-6)
    # A material can be baked for another model, too.
    capsys.readouterr()
    assert run(["bake", "cloth.loom", "--model", "point", "-o", "again.loom"]) == 0
    assert capsys.readouterr().out == "again.loom\n"
    assert read_loom("again.loom").model == "point"


# Options of the shortest bake.
SHORT = {"clustered": ["--set", "clusters=4", "--set", "texels=32"]}


@pytest.mark.quick("lobes")
@pytest.mark.parametrize("model", slow_among(MODELS, ("neumip", "latent", "neural", "clustered")))
def test_a_loom_of_any_model_is_rendered(
    model: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """With the model that it holds, and without a word; the contract has that its answers are the same."""
    monkeypatch.chdir(tmp_path)
    assert run(["bake", "twill 3/1", "--model", model, "-o", "a.loom", *SHORT.get(model, [])]) == 0
    assert run(["render", "a.loom", "-o", "held.exr", *PICTURE]) == 0
    assert capsys.readouterr().err == ""
    assert np.array(mi.Bitmap("held.exr")).std() > 0.01


@pytest.mark.slow
def test_another_model_than_a_loom_holds_is_said(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    capsys.readouterr()
    assert run(["render", "cloth.loom", "--model", "point", "-o", "other.exr", *PICTURE]) == 0
    error = capsys.readouterr().err
    assert error == (
        "loomlight: warning: cloth.loom holds the model samples; point is baked from its fabric instead.\n"
    )
    assert run(["render", "cloth.toml", "--model", "point", "-o", "point.exr", *PICTURE]) == 0
    other, point = (np.array(mi.Bitmap(f"{name}.exr")) for name in ("other", "point"))
    np.testing.assert_allclose(other, point, rtol=1e-4, atol=1e-6)


@pytest.mark.slow
def test_compare_takes_a_loom(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    capsys.readouterr()
    arguments = ["compare", "cloth.loom", "--models", "point", "-o", "report", "--scenes", "flat near"]
    assert run([*arguments, "--size", "24x18", "--spp", "2"]) == 0
    captured = capsys.readouterr()
    assert captured.err == (
        "loomlight: warning: cloth.loom holds the model samples; compare bakes each model from its fabric.\n"
    )
    assert "| point" in captured.out
    assert (folder / "report" / "index.html").exists()


def test_scenes_take_materials_and_edit_them(folder: Path) -> None:
    expected = load_fabric("cloth.toml")
    (folder / "hound.wif").unlink()
    plain = mi.load_dict({"type": "woven_point", "fabric": "cloth.loom"})
    assert np.array_equal(plain.model.source.draft.drawdown, expected.draft.drawdown)
    edited = mi.load_dict({"type": "woven_point", "fabric": "cloth.loom", "warp_roughness": 0.7})
    assert edited.model.source.appearance().warp.roughness == 0.7
    assert edited.model.source.appearance().weft.roughness == 0.2
    assert np.array_equal(edited.model.source.layout().warp.spacing, expected.layout().warp.spacing)
    other = mi.load_dict({"type": "woven_point", "fabric": "cloth.loom", "weave": "plain"})
    assert other.model.source.layout().warp_on_top.shape == (2, 2)
    with pytest.raises((RuntimeError, InputError), match="roughness"):
        mi.load_dict({"type": "woven_point", "fabric": "cloth.loom", "warp_roughness": 7.0})


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["plain", "--model", "pont", "-o", "a.loom"], 'model "pont" does not exist: did you mean point?'),
        (["plain", "--model", "x", "-o", "a.loom"], "known are lobes, point, samples"),
        (["broken.loom", "--model", "point", "-o", "a.loom"], "broken.loom: it is no .loom file, or damaged"),
    ],
)
def test_a_fault_is_one_sentence(
    arguments: list[str], says: str, folder: Path, refused: Callable[..., str]
) -> None:
    (folder / "broken.loom").write_bytes((folder / "cloth.loom").read_bytes()[:-5])
    error = refused(["bake", *arguments])
    assert error.startswith("loomlight: ")
    assert says in error


@pytest.mark.slow
def test_a_catalogue_is_baked_by_processes_and_again_only_what_changed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("cloth.toml").write_text('weave = "plain"')
    command = ["bake", "cloth.toml", "twill 2/1", "satin 5", "--model", "point", "-o", "out"]
    assert run([*command, "--workers", "2"]) == 0
    assert capsys.readouterr().out.split() == ["out/cloth.loom", "out/twill-2-1.loom", "out/satin-5.loom"]
    assert model_from_loom("out/satin-5.loom").source.name == "satin 5"
    before = {path.name: path.stat().st_mtime_ns for path in Path("out").glob("*.loom")}
    Path("cloth.toml").write_text('weave = "plain"\ngap = 0.3')
    Path("out/satin-5.loom").unlink()
    assert run(command) == 0
    after = {path.name: path.stat().st_mtime_ns for path in Path("out").glob("*.loom")}
    assert [name for name in sorted(before) if after[name] == before[name]] == ["twill-2-1.loom"]
    assert read_loom("out/cloth.loom").source.fields.gap == 0.3


@pytest.mark.parametrize(
    ("sources", "output", "sentence"),
    [
        (["plain", "twill"], "a.loom", "several sources are baked into a folder"),
        (["a/x.toml", "b/x.toml"], "out", "would both be out/x.loom"),
        (["plain", "no.toml"], "out", "no.toml does not exist"),
        (["out/a.loom", "plain"], "out", "out/a.loom is one of the sources"),
    ],
)
def test_faults_of_a_catalogue(
    sources: list[str],
    output: str,
    sentence: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    assert run(["bake", *sources, "--model", "point", "-o", output]) == 2
    assert sentence in capsys.readouterr().err
    assert not Path("out", "a.loom").exists()


def test_what_is_read_is_not_overwritten(folder: Path, refused: Callable[..., str]) -> None:
    error = refused(["bake", "cloth.loom", "--model", "point", "-o", "cloth.loom"])
    assert "cloth.loom is read by this command" in error
