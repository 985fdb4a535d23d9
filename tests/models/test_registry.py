"""Models by name, and `.loom` files that no model here can use."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from loomlight.core.errors import InputError, MissingDependencyError
from loomlight.fabric import fabric_from_text
from loomlight.models.point import PointModel, SampledModel, SamplesOptions
from loomlight.models.registry import is_installed, make_model, model_class, model_from_loom, model_names
from loomlight.sources.loom_file import LoomFile, write_loom
from tests.limits import HANG


def test_names() -> None:
    assert {"point", "samples"} <= set(model_names())
    assert type(make_model("point", fabric_from_text("plain"))) is PointModel
    with pytest.raises(InputError, match='model "sample" does not exist: did you mean samples'):
        make_model("sample", fabric_from_text("plain"))


def test_names_load_no_model() -> None:
    program = (
        "import sys\nfrom loomlight.models.registry import model_names\nmodel_names()\n"
        "assert not [name for name in sys.modules if name.startswith(('loomlight.models.p', 'mitsuba'))]\n"
        "assert 'torch' not in sys.modules\n"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=HANG)
    assert done.returncode == 0, done.stderr


def test_without_llvmlite_all_models_but_networks_are_there(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "llvmlite", None)
    said = {}
    for name in model_names():
        for to_bake in (False, True):
            try:
                model_class(name, to_bake)
                assert is_installed(name)
            except MissingDependencyError as error:
                said[name, to_bake] = str(error)
                assert not is_installed(name)
    trained = ("networks", "train")
    networks = {"neural": ("neural", "neural"), "neumip": trained, "latent": trained}
    assert said == {
        (name, to_bake): f"{'Baking the' if to_bake else 'The'} model {name} needs llvmlite: "
        f"pip install 'loomlight[{extras[to_bake]}]'."
        for name, extras in networks.items()
        for to_bake in (False, True)
    }


def test_settings_come_back(tmp_path: Path) -> None:
    write_loom(
        tmp_path / "a.loom", SampledModel(fabric_from_text("plain"), SamplesOptions(points=7)).to_loom()
    )
    actual = model_from_loom(tmp_path / "a.loom")
    assert isinstance(actual, SampledModel)
    assert actual.options.points == 7
    with pytest.raises(InputError, match="points = 0 is wrong"):
        SamplesOptions(points=0)


@pytest.mark.parametrize(
    ("model", "settings", "says"),
    [
        ("wovne", {}, 'a.loom: its model "wovne" does not exist here'),
        ("samples", {}, "a.loom: the setting points is missing: it should be of type int"),
        ("samples", {"points": "many"}, 'a.loom: the setting points is "many": it should be of type int'),
        ("samples", {"points": 0}, "a.loom: points = 0 is wrong: give a whole number from 1 to 65536"),
    ],
)
def test_files_that_fit_no_model(
    model: str, settings: dict[str, int | str], says: str, tmp_path: Path
) -> None:
    write_loom(tmp_path / "a.loom", LoomFile(model, fabric_from_text("plain"), settings=settings))
    with pytest.raises(InputError) as caught:
        model_from_loom(tmp_path / "a.loom")
    assert says in str(caught.value)


def test_a_file_of_another_model() -> None:
    loom = PointModel(fabric_from_text("plain")).to_loom()
    with pytest.raises(InputError, match='it holds the model "point", not "samples"'):
        SampledModel.from_loom(loom)
