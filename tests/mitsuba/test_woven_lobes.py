"""Lobes as a BSDF: the model's own numbers, what it samples, what editing costs, and pictures.

Covers: mitsuba/props.py, models/lobes/model.py, models/lobes/bsdf.py, models/fabric_model.py
"""

from __future__ import annotations

import threading
from pathlib import Path
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.core.frozen import named_leaves
from loomlight.fabric import fabric_from_text
from loomlight.mitsuba import build_scene, material_bsdf, render
from loomlight.models.bake import bake, save
from loomlight.models.lobes import model as lobes_model
from loomlight.models.lobes.model import DEFAULT_GROUPS
from loomlight.models.registry import make_model
from loomlight.sources.loom_file import write_loom
from tests.helpers.interactions import mean_value
from tests.marks import slow

GROUPS = 4
TWILL = {
    "type": "woven_lobes",
    "weave": "twill 2/1",
    "warp_color": "#c08040",
    "weft_color": "#4060c0",
    "warp_translucency": 0.3,
    "gap": 0.2,
    "uv_size": "4,4",
    "groups": GROUPS,
}


@pytest.fixture(autouse=True)
def baked(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Groups a family of every baking, in order."""
    found: list[int] = []
    bake_tables = lobes_model.bake_tables

    def counted(geometry: Any, diffuse_blend: float, per_family: int, float_type: type) -> Any:
        found.append(per_family)
        return bake_tables(geometry, diffuse_blend, per_family, float_type)

    monkeypatch.setattr(lobes_model, "bake_tables", counted)
    return found


def woven(**parameters: Any) -> Any:
    return mi.load_dict(TWILL | parameters)


@pytest.mark.slow
def test_nothing_is_uploaded_at_first_use() -> None:
    """Calls are symbolic, where nothing can be: neither at first nor after an edit or another weave."""
    bsdf = woven(sheen_strength=0.4, gap=0.3)
    # Albedos of threads that differ are read from tables.
    varied = fabric_from_text('weave = "houndstooth"\ngap = 0.3')
    for change in (
        lambda: None,
        lambda: edited(bsdf, "warp.height_scale", 0.4),
        lambda: bsdf.set_source(varied),
    ):
        change()
        held = named_leaves(bsdf).keys()
        context, si = mi.BSDFContext(), dr.zeros(mi.SurfaceInteraction3f)
        si.wi = mi.Vector3f(0, 0, 1)
        bsdf.eval_pdf_sample(context, si, si.wi, mi.Float(0.5), mi.Point2f(0.5, 0.5))
        bsdf.sample(context, si, mi.Float(0.5), mi.Point2f(0.5, 0.5))
        bsdf.eval_diffuse_reflectance(si)
        bsdf.eval_null_transmission(si)
        assert named_leaves(bsdf).keys() == held
    assert any("_areas" in name for name in held)


def edited(bsdf: Any, name: str, value: float) -> None:
    parameters = mi.traverse(bsdf)
    parameters[name] = value
    parameters.update()


def test_groups_are_checked_and_can_be_few(baked: list[int]) -> None:
    assert "twill 2/1" in str(woven(groups=1))
    assert baked == [1]
    with pytest.raises((RuntimeError, InputError), match="groups = 0"):
        woven(groups=0)


@pytest.mark.slow
def test_a_baked_material_is_not_baked_again(tmp_path: Path, baked: list[int]) -> None:
    file = tmp_path / "twill.loom"
    save(bake("twill 2/1", "lobes"), file)
    assert len(baked) == 1
    direct = mi.load_dict({"type": "woven_lobes", "fabric": str(file), "uv_size": "4,4"})
    built = material_bsdf(file, "lobes")((4.0, 4.0))
    assert len(baked) == 1
    np.testing.assert_allclose(mean_value(built), mean_value(direct), rtol=1e-4)
    np.testing.assert_allclose(
        mean_value(direct),
        mean_value(mi.load_dict({"type": "woven_lobes", "weave": "twill 2/1", "uv_size": "4,4"})),
        rtol=1e-4,
    )
    # Another fabric than the file's, and other groups than the file's, are baked.
    changed = mi.load_dict({"type": "woven_lobes", "fabric": str(file), "warp_height_scale": 0.5})
    assert changed.model.fabric.layout().warp.height_scale == 0.5
    mi.load_dict({"type": "woven_lobes", "fabric": str(file), "groups": 2})
    assert baked[2:] == [DEFAULT_GROUPS, 2]


@pytest.mark.slow
def test_a_material_keeps_its_groups_when_it_is_edited(tmp_path: Path, baked: list[int]) -> None:
    file = tmp_path / "twill.loom"
    write_loom(file, make_model("lobes", fabric_from_text("twill 2/1"), groups=GROUPS).to_loom())
    baked.clear()
    bsdf = mi.load_dict({"type": "woven_lobes", "fabric": str(file)})
    edited(bsdf, "warp.height_scale", 0.4)
    bsdf.set_source(fabric_from_text("plain"))
    mi.load_dict({"type": "woven_lobes", "fabric": str(file), "weft_twist_deg": 5.0})
    assert baked == [GROUPS] * 3


@pytest.mark.parametrize("zoom", [slow(1.0), 30.0])
def test_white_cloth_in_a_white_world(zoom: float) -> None:
    white = fabric_from_text(
        'weave = "twill 2/1"\n[warp]\ncolor = "#ffffff"\ntranslucency = 0.3\nspecular = 1.0\n'
        '[weft]\ncolor = "#ffffff"\nspecular = 1.0\n'
    )

    def blocks(model: str) -> np.ndarray:
        """Means of 16 pixels each of a white ball in a white world, 1024 paths."""
        ball = {"type": "sphere", "bsdf": material_bsdf(white, model)((200.0, 200.0))}
        camera = {
            "type": "perspective",
            "fov": 20 / zoom,
            "to_world": mi.ScalarTransform4f().look_at([0, 0, 8], [0.3, 0.2, 0], [0, 1, 0]),
            "film": {"type": "hdrfilm", "width": 24, "height": 24, "rfilter": {"type": "box"}},
        }
        light = {"type": "constant"}
        scene = mi.load_dict({"type": "scene", "ball": ball, "sky": light, "sensor": camera})
        integrator = mi.load_dict({"type": "footprint_path", "max_depth": 3})
        picture = render(scene, spp=64, integrator=integrator)
        return picture.reshape(6, 4, 6, 4, 3).mean(axis=(1, 3))

    found, wanted = blocks("lobes"), blocks("point")
    # Paths scatter by less than 0.6: 0.02 is their noise.
    assert found.max() < 1.02
    # Light that is scattered between yarns is lost by both alike.
    np.testing.assert_allclose(found.mean(), wanted.mean(), rtol=0.05)


@pytest.mark.slow
def test_from_afar_a_few_samples_are_the_point_models_many() -> None:
    denim = fabric_from_text(
        'weave = "twill 3/1"\nends_per_cm = 28\npicks_per_cm = 18\n[warp]\ncolor = "#2a4680"\n'
        '[weft]\ncolor = "#e4ddcd"\n'
    )
    shot = {"size": (64, 64), "max_depth": 2, "light": "directional"}
    pictures = {}
    for model, samples in (("lobes", 4), ("point", 4), ("point", 256)):
        shown = build_scene("sphere", material_bsdf(denim, model), **shot)
        pictures[model, samples] = render(shown.scene, spp=samples, integrator=shown.integrator, seed=samples)
    reference = pictures["point", 256]
    lit = reference.mean(axis=2) > 0.05

    def error(model: str) -> float:
        return float(np.abs(pictures[model, 4] - reference)[lit].mean() / reference[lit].mean())

    # Groups of like points are right to about a tenth (models/lobes); point samples of twill scatter by twice
    # that at 4 a pixel. In the mean over the picture both agree far better.
    assert error("lobes") < 0.12
    assert error("lobes") < 0.7 * error("point")
    np.testing.assert_allclose(pictures["lobes", 4][lit].mean(), reference[lit].mean(), rtol=0.05)


@pytest.mark.slow
def test_cloths_of_a_scene_are_made_by_one_thread_at_a_time(monkeypatch: pytest.MonkeyPatch) -> None:
    """Mitsuba loads on several threads; Dr.Jit's recordings are made by one."""
    making: list[int] = []
    together: list[int] = []
    bake = lobes_model.bake_tables

    def watched(*arguments: Any) -> Any:
        making.append(threading.get_ident())
        together.append(len(set(making)))
        tables = bake(*arguments)
        making.remove(threading.get_ident())
        return tables

    monkeypatch.setattr(lobes_model, "bake_tables", watched)
    cloths = {
        f"cloth{number}": {
            "type": "rectangle",
            "bsdf": {"type": "woven_lobes", "weave": "satin 8/3", "ends_per_cm": 20.5 + number},
        }
        for number in range(6)
    }
    mi.load_dict({"type": "scene", **cloths})
    assert len(together) == len(cloths)
    assert max(together) == 1
