"""A toy model enters by one entry of the registry: a `.loom`, a BSDF, a command, a row of a benchmark.

Covers: models/interface.py, models/bake.py, mitsuba/plugins.py
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest
from typer.testing import CliRunner

from loomlight.core.errors import InputError
from loomlight.evaluation.query_benchmark import HeldOut, model_predictor, run_query_benchmark
from loomlight.fabric import fabric_from_text
from loomlight.mitsuba import build_scene, choose_variant, material_bsdf, render
from loomlight.mitsuba.plugins import register_plugins
from loomlight.models.bake import bake, save
from loomlight.models.registry import MODELS, ModelEntry, make_model, model_from_loom
from loomlight.sources.kinds import SOURCE_KINDS, SourceKind

from .toy import Paint, ToyModel

PAINT = SourceKind(
    Paint,
    lambda paint: ({"name": paint.name, "albedo": paint.albedo}, {}),
    lambda record, tensors, folder: Paint(record["name"], record["albedo"]),
    lambda path: Paint(str(path), 0.25),
)


@pytest.fixture(autouse=True)
def toys() -> Iterator[None]:
    """One entry a model, and one for the kind of source that one of them takes."""
    choose_variant("llvm_ad_rgb")
    SOURCE_KINDS["paint"] = PAINT
    MODELS["toy"] = ModelEntry(ToyModel.__module__, "ToyModel", "toy")
    MODELS["toy of fabrics"] = ModelEntry(ToyModel.__module__, "ToyOfFabrics", "toy_of_fabrics")
    register_plugins()
    yield
    del SOURCE_KINDS["paint"], MODELS["toy"], MODELS["toy of fabrics"]


def value_of(bsdf: Any) -> Any:
    """f·cos of light from above at one point [3]."""
    si = dr.zeros(mi.SurfaceInteraction3f)
    si.wi, si.n = mi.Vector3f(0, 0.6, 0.8), mi.Normal3f(0, 0, 1)
    si.dp_du, si.dp_dv = mi.Vector3f(1, 0, 0), mi.Vector3f(0, 1, 0)
    si.sh_frame = mi.Frame3f(mi.Vector3f(1, 0, 0), mi.Vector3f(0, 1, 0), mi.Vector3f(0, 0, 1))
    return np.array(bsdf.eval(mi.BSDFContext(), si, mi.Vector3f(0, 0, 1)))[:, 0]


def test_a_source_that_is_no_fabric_goes_through_a_loom(tmp_path: Path) -> None:
    save(bake(Paint("grey", 0.75), "toy"), tmp_path / "grey.loom")
    actual = model_from_loom(tmp_path / "grey.loom")
    assert isinstance(actual, ToyModel)
    assert actual.source == Paint("grey", 0.75)
    plugin = mi.load_dict({"type": "toy", "source": str(tmp_path / "grey.loom")})
    assert value_of(plugin) == pytest.approx(0.75 / np.pi)
    # Of sources that are no fabrics a repeat is one unit of uv.
    assert "uv_size = 50 × 50 mm" in str(plugin)
    assert 'source = "grey"' in str(plugin)
    (tmp_path / "red.paint").write_text("")
    named = mi.load_dict({"type": "toy", "source": str(tmp_path / "red.paint")})
    assert value_of(named) == pytest.approx(0.25 / np.pi)


def test_a_model_says_what_it_does_not_take(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="grey is no fabric, and the model lobes takes nothing else"):
        make_model("lobes", Paint("grey", 0.5))
    save(bake(Paint("grey", 0.5), "toy"), tmp_path / "grey.loom")
    with pytest.raises((InputError, RuntimeError), match="grey is no fabric"):
        mi.load_dict({"type": "woven_point", "fabric": str(tmp_path / "grey.loom")})
    with pytest.raises((InputError, RuntimeError), match="source is missing"):
        mi.load_dict({"type": "toy"})


def test_it_is_a_name_of_the_command_line(tmp_path: Path) -> None:
    from loomlight.cli.main import app

    loom, picture = tmp_path / "plain.loom", tmp_path / "plain.png"
    done = CliRunner().invoke(app, ["bake", "plain", "--model", "toy of fabrics", "-o", str(loom)])
    assert done.exit_code == 0, done.output
    size = ["--size", "16x16", "--spp", "1", "--scene", "flat"]
    done = CliRunner().invoke(app, ["render", str(loom), "-o", str(picture), *size])
    assert done.exit_code == 0, done.output
    assert picture.exists()


def test_pictures_of_it_are_those_of_mitsubas_diffuse() -> None:
    """Emission, shadows and bounces of a Lambertian whose truth Mitsuba knows."""
    pictures = []
    for bsdf in (
        material_bsdf("plain", "toy of fabrics"),
        {"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.5}}},
    ):
        shown = build_scene("sphere", bsdf, size=(24, 24))
        pictures.append(render(shown.scene, spp=1024, integrator=shown.integrator))
    # At the film's border Mitsuba's filter is cut off, and that of cloth that filters is not.
    found, wanted = (np.asarray(picture)[2:-2, 2:-2] for picture in pictures)
    # Camera rays of cloth that filters are others. Two seeds of either picture differ by 0.8 % of the mean at
    # a pixel: five of these at each, and four times what is left of it in the mean of 400 pixels.
    np.testing.assert_allclose(found, wanted, rtol=0.02, atol=0.04 * wanted.mean())
    assert abs((found - wanted).mean()) < 0.002 * wanted.mean()


def test_it_is_a_row_of_the_query_benchmark() -> None:
    cloth = HeldOut("plain", fabric_from_text("plain"), unseen_weave=False, coloured=True)
    predictors = {"toy": model_predictor(partial(make_model, "toy of fabrics"))}
    actual = run_query_benchmark(predictors, [cloth], pairs=6, footprints=4, monte_carlo=())
    row = actual.rows["toy"]
    assert set(row.sums) == {"reflection", "transmission", "colour"}
    # It keeps no light from the other side, and cloth is no Lambertian.
    assert row.metric("transmission") == pytest.approx(1)
    assert 0.1 < row.metric("reflection") < 3


def test_the_albedo_texture_of_a_scene_tints_it() -> None:
    red = {"type": "rgb", "value": [0.5, 0.25, 0.0]}
    bsdf = mi.load_dict({"type": "toy_of_fabrics", "fabric": "plain", "albedo": red})
    np.testing.assert_allclose(value_of(bsdf) * np.pi, [0.25, 0.125, 0], atol=1e-5)
