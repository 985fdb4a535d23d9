"""Models by name, and `.loom` files that no model here can use."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from loomlight.core.errors import InputError, MissingDependencyError
from loomlight.fabric import fabric_from_text
from loomlight.models.point import PointModel
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


def test_a_file_of_a_model_that_does_not_exist(tmp_path: Path) -> None:
    write_loom(tmp_path / "a.loom", LoomFile("wovne", fabric_from_text("plain")))
    with pytest.raises(InputError, match=r'a\.loom: its model "wovne" does not exist here'):
        model_from_loom(tmp_path / "a.loom")
