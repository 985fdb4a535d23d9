"""The image benchmark: its mask of pixels, yarns a pixel, and errors of known pictures.

Covers: evaluation/metrics.py, mitsuba/measured_scenes.py
"""

from __future__ import annotations

import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.evaluation.image_benchmark import (
    Shot,
    image_tables,
    run_image_benchmark,
    shots_of,
)
from loomlight.evaluation.metrics import flip_mean, picture_error
from loomlight.fabric import Fabric, fabric_from_text
from loomlight.mitsuba import choose_variant, render
from loomlight.mitsuba.measured_scenes import MEASURED_SCENES, measured_scene

SIZE = (48, 27)


@pytest.fixture(scope="module")
def fabrics() -> list[Fabric]:
    choose_variant()
    coloured = 'weave = "twill 3/1"\nends_per_cm = 30\n[warp]\ncolor = "#c04040"\ntranslucency = 0.0\n'
    return [fabric_from_text(coloured), fabric_from_text("plain")]


def test_flip_and_mse_of_known_pictures() -> None:
    reference = np.full((20, 30, 3), 0.4, np.float32)
    brighter = reference + 0.1
    counted = np.zeros((20, 30), bool)
    counted[:, 15:] = True
    error = picture_error(brighter, reference, counted)
    assert error.mse == pytest.approx(0.01, rel=1e-5)
    assert 0.02 < error.flip < 0.5
    assert (error.flip_map[~counted] == 0).all()
    assert error.flip_picture.shape == (20, 30, 3)
    same = picture_error(reference, reference, counted)
    assert same.mse == same.flip == 0
    # What lies beside the pixels that count is nobody's error.
    beside = np.where(counted[..., None], reference, 1.0).astype(np.float32)
    assert picture_error(beside, reference, counted).flip == 0
    assert flip_mean(brighter, reference, np.ones((20, 30), bool)) > 0.02


@pytest.mark.slow
def test_pixels_wholly_on_one_piece_count(fabrics: list[Fabric]) -> None:
    sphere = measured_scene("sphere", fabrics, "point", SIZE)
    height, width = sphere.counted.shape
    assert (width, height) == SIZE
    assert sphere.counted[height // 2, width // 2]
    assert not sphere.counted[0, 0]
    # The disc's share of the picture, less its outline.
    assert 0.3 < sphere.counted.mean() < 0.45
    both = measured_scene("two fabrics", fabrics, "point", SIZE)
    assert both.counted[0, 0]
    # The sphere's outline runs between both pieces.
    assert 0 < (~both.counted).mean() < 0.15


def test_the_median_pixel_covers_the_yarns_it_should(fabrics: list[Fabric]) -> None:
    # The same warp threads, counted: the footprint's side from two pixels' places on the cloth.
    scene = measured_scene("flat middle", fabrics, "point", SIZE)
    width, height = SIZE
    row, column = height // 2, width // 2
    # The BSDF of the scene knows its scale: millimetres a unit of uv.
    bsdf = next(iter(scene.scene.shapes())).bsdf()
    sensor = scene.scene.sensors()[0]

    def place(x: float, y: float) -> np.ndarray:
        ray, _ = sensor.sample_ray(0.0, 0.5, [x / width, y / height], [0.5, 0.5])
        uv = scene.scene.ray_intersect(ray).uv
        return np.array([uv.x[0] * bsdf.uv_size.x[0], uv.y[0] * bsdf.uv_size.y[0]])

    middle = place(column, row)
    area = abs(np.linalg.det([place(column + 1, row) - middle, place(column, row + 1) - middle]))
    layout = fabrics[0].layout()
    thread = np.sqrt(layout.warp.spacing[0] * layout.weft.spacing[0])
    # Perspective: the middle pixel is not quite the median one.
    assert np.sqrt(area) / thread == pytest.approx(scene.yarns_per_pixel, rel=0.1)


@pytest.mark.slow
def test_pixel_centres_are_hit(fabrics: list[Fabric]) -> None:
    centred = measured_scene("flat near", fabrics, "point", SIZE, pixel_centres=True)
    jittered = measured_scene("flat near", fabrics, "point", SIZE)

    def picture(scene: object, seed: int) -> np.ndarray:
        return render(scene.scene, spp=1, seed=seed, integrator=scene.integrator)

    # Always the same places, and direct light of one direction: no randomness is left but that of holes.
    alike = np.isclose(picture(centred, 1), picture(centred, 2), rtol=1e-4, atol=1e-6).mean()
    assert alike > 0.98
    assert np.isclose(picture(jittered, 1), picture(jittered, 2), rtol=1e-4, atol=1e-6).mean() < 0.5


def test_every_scene_is_rendered_and_more_samples_are_nearer(fabrics: list[Fabric]) -> None:
    results = run_image_benchmark(
        [], fabrics, scenes=["flat far", "two fabrics"], size=SIZE, reference_samples=64
    )
    for result in results:
        one, three = result.pictures["point, 1 spp"].error, result.pictures["point, 3 spp"].error
        assert 0 < three.flip < one.flip
        assert 0 < three.mse < 0.6 * one.mse  # a third, but for the reference's own noise
    flip, mse, seconds = image_tables(results)
    assert flip.columns == ["flat far (10)", "two fabrics (3)"]
    assert list(seconds.rows) == ["point, 1 spp", "point, 3 spp", "reference"]
    assert mse.rows["point, 1 spp"][0] == results[0].pictures["point, 1 spp"].error.mse


def test_faults(fabrics: list[Fabric]) -> None:
    with pytest.raises(InputError, match="flat near"):
        measured_scene("moon", fabrics, "point", SIZE)
    with pytest.raises(InputError, match="shows 2 fabrics"):
        measured_scene("two fabrics", fabrics[:1], "point", SIZE)
    with pytest.raises(InputError, match="does not exist"):
        shots_of(["wovne"])
    assert len(MEASURED_SCENES) == 8
    assert not Shot("point", 1).pixel_centres
    assert Shot("neural", 1).pixel_centres
