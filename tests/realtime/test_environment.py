"""Environments: distributions, light against Mitsuba's, and what is no environment."""

from __future__ import annotations

from pathlib import Path

import mitsuba as mi
import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.core.images import write_image
from loomlight.evaluation.metrics import flip_mean
from loomlight.fabric import load_fabric
from loomlight.realtime import Camera, Cloth, Environment, Mesh, Renderer, rectangle
from studies.accuracy.realtime_frames import mitsuba_frame

EXAMPLES = Path(__file__).parents[2] / "examples"


def soft_map() -> np.ndarray:
    """A warm light on one side and a cold one, below, on the other."""
    row, column = np.mgrid[:64, :128]
    warm = np.exp(-((row - 14) ** 2 + (column - 24) ** 2) / 80)[..., None] * (6, 3, 1)
    cold = np.exp(-((row - 50) ** 2 + (column - 100) ** 2) / 200)[..., None] * (0, 1, 3)
    return warm + cold + 0.2


def test_distributions_are_those_of_the_radiance() -> None:
    radiance = soft_map()
    tables = Environment(radiance).tables()
    edges = np.cos(np.linspace(0, np.pi, 65))
    weights = radiance.mean(axis=2) * (edges[:-1] - edges[1:])[:, None] * 2 * np.pi / 128
    assert tables.total == pytest.approx(weights.sum())
    chances = np.diff(tables.rows)[:, None] * np.diff(tables.columns, axis=1)
    np.testing.assert_allclose(chances, weights / weights.sum(), rtol=0, atol=1e-7)


def test_large_maps_keep_their_light() -> None:
    radiance = np.random.default_rng(0).uniform(size=(512, 1030, 3))
    tables = Environment(radiance).tables()
    assert tables.radiance.shape == (256, 515, 3)
    assert tables.radiance.mean() == pytest.approx(radiance.mean(), rel=1e-6)


def test_a_black_map_gives_no_light() -> None:
    cloths = [Cloth(rectangle(0.1, 0.1), load_fabric(EXAMPLES / "denim.toml"))]
    renderer = Renderer(cloths, (4, 4), "point")
    picture = renderer.render(Camera((0, 0, 0.05)), [], environment=Environment(np.zeros((2, 4, 3))))
    assert (picture.linear[..., :3] == 0).all()


@pytest.mark.slow
def test_light_and_background_are_those_of_mitsuba() -> None:
    """Two sheets, the upper one open, so that environment light is shadowed too.

    Mitsuba stretches maps by half a row at either pole, which changes their light by a percent.
    """
    mi.set_variant("llvm_ad_rgb")
    low = rectangle(0.1, 0.1)
    raised = low.positions * (0.4, 0.4, 1) + np.array([0, 0, 0.01])
    high = Mesh(raised, low.normals, low.uv * 0.4, low.faces)
    fabrics = [load_fabric(EXAMPLES / f"{name}.toml") for name in ("denim", "organza")]
    cloths = [Cloth(mesh, fabric) for mesh, fabric in zip((low, high), fabrics, strict=True)]
    camera, size = Camera((0, -0.1, 0.15), field_of_view=30), (20, 20)
    environment = Environment(soft_map(), turn=30.0)
    options = {"environment": environment, "environment_samples": 8, "samples": 4}
    found = Renderer(cloths, size, "point").render(camera, [], passes=32, **options).linear[..., :3]
    expected = mitsuba_frame(cloths, camera, size, environment=environment, spp=384)
    np.testing.assert_allclose(found.mean(axis=(0, 1)), expected.mean(axis=(0, 1)), rtol=0.015)
    # 256 directions a pixel: two seeds of Mitsuba differ by half as much.
    assert flip_mean(found, expected, np.ones(size, bool)) <= 0.06


def test_environments_are_read_and_checked(tmp_path: Path) -> None:
    write_image(tmp_path / "sky.exr", soft_map())
    np.testing.assert_allclose(Environment.read(tmp_path / "sky.exr").radiance, soft_map(), rtol=1e-6)
    with pytest.raises(InputError, match="does not exist"):
        Environment.read(tmp_path / "none.exr")
    with pytest.raises(InputError, match=r"radiance \[rows, columns, 3\]"):
        Environment(np.zeros((4, 8)))
    with pytest.raises(InputError, match="negative or no finite number"):
        Environment(np.full((4, 8, 3), np.nan))
