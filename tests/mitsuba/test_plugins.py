"""Where plugins exist, and what they say where they do not. Variants are set in processes of their own.

Covers: mitsuba/variants.py
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import mitsuba as mi
import pytest

from loomlight.core.errors import InputError
from loomlight.fabric.read import load_fabric
from loomlight.mitsuba import SUPPORTED_VARIANTS
from loomlight.models.bake import bake, save
from loomlight.models.registry import MODELS, model_class
from loomlight.sources.loom_file import LoomFile, write_loom
from tests.limits import HANG

LOAD = """
import sys
import mitsuba as mi
first, second, plugin = sys.argv[1:]
mi.set_variant(first)
import loomlight.mitsuba
mi.set_variant(second)
print(mi.load_dict({"type": plugin}).class_name())
"""


def loaded(first: str, second: str, plugin: str) -> subprocess.CompletedProcess[str]:
    """A plugin loaded in the second variant, where `loomlight.mitsuba` was imported in the first."""
    command = [sys.executable, "-c", LOAD, first, second, plugin]
    return subprocess.run(command, capture_output=True, text=True, timeout=HANG)


@pytest.mark.quick("llvm_ad_rgb-scalar_spectral-woven_lobes")
@pytest.mark.parametrize("plugin", ["woven_lobes", "footprint_path"])
@pytest.mark.parametrize(
    ("first", "second"),
    [("scalar_rgb", "scalar_rgb"), ("llvm_ad_rgb", "scalar_spectral"), ("scalar_rgb", "llvm_ad_spectral")],
)
def test_other_variants_name_those_that_have_the_plugin(first: str, second: str, plugin: str) -> None:
    if {first, second} - set(mi.variants()):
        pytest.fail(f"this Mitsuba lacks {first} or {second}, which its wheel has")
    done = loaded(first, second, plugin)
    assert done.returncode != 0
    last = done.stderr.strip().splitlines()[-1]
    assert last == (
        f"InputError: {plugin} does not exist in the variant {second}: "
        f"set {' or '.join(SUPPORTED_VARIANTS)} before the scene is loaded."
    )


def test_a_supported_variant_after_another_has_them() -> None:
    done = loaded("scalar_rgb", "llvm_ad_rgb", "woven_point")
    assert done.returncode == 0, done.stderr
    assert "ModelBsdf" in done.stdout or "BSDF" in done.stdout


@pytest.mark.parametrize("name", ["neumip", "latent"])
@pytest.mark.parametrize("made_of", ["nothing", "a weave", "a fabric file", "a .loom of another", "an edit"])
def test_a_model_that_is_trained_takes_its_loom_alone(
    name: str, made_of: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """No scene trains for a minute, in silence, what a `.loom` was meant to hold."""

    def trained(*_: object, **__: object) -> None:
        raise AssertionError("it is trained")

    monkeypatch.setattr(model_class(name), "for_source", trained)
    file, loom, own = tmp_path / "linen.toml", tmp_path / "linen.loom", tmp_path / "own.loom"
    file.write_text('weave = "plain"\n')
    save(bake(str(file), "point"), loom)
    write_loom(own, LoomFile(name, load_fabric(file)))
    forms: dict[str, tuple[dict[str, str], Path | str]] = {
        "nothing": ({}, "SOURCE"),
        "a weave": ({"weave": "twill 2/1"}, "SOURCE"),
        "a fabric file": ({"fabric": str(file)}, file),
        "a .loom of another": ({"source": str(loom)}, loom),
        "an edit": ({"fabric": str(own), "warp_color": "#ff0000"}, own),
    }
    given, source = forms[made_of]
    with pytest.raises((InputError, RuntimeError)) as caught:
        mi.load_dict({"type": MODELS[name].plugin, **given})
    command = f"`loomlight bake {source} --model {name} -o x.loom`"
    assert f"{name} is trained for one source, which takes minutes: bake it with {command}" in str(
        caught.value
    )
