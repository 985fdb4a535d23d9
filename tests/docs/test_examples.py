"""The numbered examples run as they stand, in an empty folder, and leave what they say."""

from __future__ import annotations

import runpy
from pathlib import Path

import numpy as np
import pytest

import loomlight
from loomlight.core.images import read_linear

from ..marks import slow

EXAMPLES = Path(__file__).parents[2] / "examples"
MAX_LINES = 40
# What each writes.
LEAVES = {
    "01_draft": ["draft.wif", "draft.png"],
    "02_fabric": ["stripes.toml"],
    "03_picture": ["linen.png", "linen.exr"],
    "04_mesh": ["cushion.png"],
    "05_animation": ["frame-0.png", "frame-3.png"],
    "06_models": ["denim.loom"],
    "07_mitsuba": ["satin.png"],
    "08_gradients": [],
    "09_maps": ["tweed_height.png", "tweed_normal.png"],
    "10_realtime": ["frame.png", "frame-twill.png"],
    "11_learned": ["leather.loom", "leather.png"],
    "12_export": ["linen-gltf/cloth.glb", "linen-wgsl/cloth.wgsl"],
}
FAST = ("01_draft", "02_fabric")


def test_every_example_is_tested_listed_and_short() -> None:
    files = {file.stem: file.read_text("utf-8") for file in EXAMPLES.glob("[0-9]*.py")}
    assert set(files) == set(LEAVES)
    assert [name for name, text in files.items() if len(text.splitlines()) > MAX_LINES] == []
    readme = (EXAMPLES.parent / "README.md").read_text("utf-8")
    assert [name for name in files if f"examples/{name}.py" not in readme] == []


@pytest.mark.usefixtures("less_work")
@pytest.mark.parametrize("name", [name if name in FAST else slow(name) for name in LEAVES])
def test_an_example_runs(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    runpy.run_path(str(EXAMPLES / f"{name}.py"))
    for left in LEAVES[name]:
        assert (tmp_path / left).is_file()
        if left.endswith(".png") and name not in ("01_draft", "09_maps"):
            assert np.ptp(read_linear(tmp_path / left)) > 0.05  # something is seen
    if name == "08_gradients":
        found = [float(word) for word in capsys.readouterr().out.split("[")[2].split("]")[0].split(",")]
        np.testing.assert_allclose(found, [0.5, 0.1, 0.05], atol=0.05)  # noise of 48 pixels of 8 samples
    if name == "01_draft":
        draft = loomlight.load_draft(tmp_path / "draft.wif")
        assert (draft.drawdown != loomlight.named_weave("herringbone 2/2 8").drawdown).sum() == 16
