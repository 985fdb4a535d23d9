"""Where plugins exist, and what they say where they do not. Variants are set in processes of their own.

Covers: mitsuba/variants.py
"""

from __future__ import annotations

import subprocess
import sys

import mitsuba as mi
import pytest

from loomlight.mitsuba import SUPPORTED_VARIANTS
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
