"""What users are told while Mitsuba's own integrators trace a BSDF: one sentence, once."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import mitsuba as mi
import numpy as np
import pytest

from loomlight.core.errors import LoomlightWarning
from loomlight.mitsuba import bsdf, render


def write_triangle(file: Path, with_uv: bool) -> None:
    mesh = mi.Mesh("triangle", 3, 1, has_vertex_texcoords=with_uv)
    params = mi.traverse(mesh)
    params["vertex_positions"] = [-1, -1, 0, 1, -1, 0, 0, 1, 0]
    params["faces"] = [0, 1, 2]
    if with_uv:
        params["vertex_texcoords"] = [0, 0, 1, 0, 0, 1]
    params.update()
    mesh.write_ply(str(file))


def scene_of(integrator: str, plugin: str = "woven_point", **shapes: dict[str, Any]) -> Any:
    view = {
        "type": "perspective",
        "to_world": mi.ScalarTransform4f().look_at([0, 0, 4], [0, 0, 0], [0, 1, 0]),
        "film": {"type": "hdrfilm", "width": 8, "height": 8},
    }
    clothed = {name: shape | {"bsdf": {"type": plugin}} for name, shape in shapes.items()}
    rest = {
        "type": "scene",
        "integrator": {"type": integrator, "max_depth": 2},
        "light": {"type": "constant"},
    }
    return mi.load_dict(rest | {"view": view} | clothed)


def told(scene: Any) -> list[str]:
    """Warnings of two pictures."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", LoomlightWarning)
        for seed in range(2):
            np.array(mi.render(scene, spp=1, seed=seed))
    return [str(each.message) for each in caught if issubclass(each.category, LoomlightWarning)]


@pytest.mark.parametrize("integrator", ["path", "footprint_path"])
def test_a_mesh_without_uv_is_named_once(integrator: str, tmp_path: Path) -> None:
    bare, unwrapped = tmp_path / "bare.ply", tmp_path / "unwrapped.ply"
    write_triangle(bare, with_uv=False)
    write_triangle(unwrapped, with_uv=True)
    found = told(
        scene_of(
            integrator,
            bare={"type": "ply", "filename": str(bare), "id": "the jacket"},
            unwrapped={"type": "ply", "filename": str(unwrapped), "id": "the scarf"},
            ball={"type": "sphere"},
            square={"type": "rectangle"},
            box={"type": "cube"},
        )
    )
    assert len(found) == 1, found
    assert '"the jacket" has no uv coordinates' in found[0]


@pytest.mark.slow
@pytest.mark.usefixtures("narrow_network")
def test_networks_in_symbolic_calls_are_said_to_be_slow(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bsdf, "_WARNED", set())
    squares = {"a": {"type": "rectangle"}, "b": {"type": "sphere"}}
    assert told(scene_of("footprint_path", "woven_neural", **squares)) == []
    assert told(scene_of("path", "woven_lobes", **squares)) == []
    (sentence,) = told(scene_of("path", "woven_neural", **squares))
    assert "woven_neural" in sentence
    assert "footprint_path" in sentence
    # `render` takes its own integrator.
    assert np.isfinite(render(scene_of("path", "woven_neural", **squares), spp=1)).all()


def test_paths_from_lights_are_told_of_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bsdf, "_WARNED", set())
    (found,) = told(scene_of("ptracer", cloth={"type": "rectangle"}))
    assert "made for paths that begin at the camera" in found
