"""The names that users may rely on, and that asking for them loads no renderer."""

from __future__ import annotations

import subprocess
import sys

import pytest

import loomlight
from tests.limits import HANG

PUBLIC = {
    "Appearance",
    "ClothLayout",
    "Draft",
    "Fabric",
    "InputError",
    "LoomlightError",
    "LoomlightWarning",
    "MissingDependencyError",
    "RenderSettings",
    "bake",
    "bake_maps",
    "capture",
    "compare",
    "edit",
    "export",
    "fabric_from_text",
    "load",
    "load_draft",
    "load_fabric",
    "make_model",
    "model_from_loom",
    "named_weave",
    "play",
    "read_wif",
    "render",
    "render_frames",
    "save",
    "swatches",
    "view",
    "weave_names",
    "write_wif",
}


def test_the_public_names_are_these() -> None:
    assert set(loomlight.__all__) == PUBLIC
    assert set(dir(loomlight)) >= PUBLIC


@pytest.mark.parametrize("name", sorted(PUBLIC))
def test_every_public_name_is_there_and_documented(name: str) -> None:
    value = getattr(loomlight, name)
    assert value.__doc__
    assert value.__name__ == name


def test_other_names_are_not() -> None:
    with pytest.raises(AttributeError, match="no attribute 'render_everything'"):
        loomlight.render_everything  # noqa: B018


def test_fabrics_load_neither_dr_jit_nor_mitsuba() -> None:
    program = (
        "import sys, loomlight\n"
        "assert not {'numpy', 'pydantic'} & set(sys.modules)\n"
        "loomlight.fabric_from_text('twill 3/1').layout()\n"
        "assert not {'drjit', 'mitsuba'} & set(sys.modules)\n"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=HANG)
    assert done.returncode == 0, done.stderr
