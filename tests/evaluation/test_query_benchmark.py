"""The query benchmark: its truth against brute force, its rows, and errors of known predictions.

Covers: evaluation/query_benchmark.py
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from drjit.llvm.ad import Array2f, Float
from scipy import stats

from loomlight.aggregate.queries import QuerySet
from loomlight.core.errors import InputError
from loomlight.core.footprint import Footprint
from loomlight.evaluation.query_benchmark import (
    HeldOut,
    Prediction,
    model_predictor,
    monte_carlo_predictor,
    multi_jittered,
    query_classes,
    query_truth,
    reference_model,
    run_query_benchmark,
)
from loomlight.fabric import Fabric, fabric_from_text
from loomlight.models.registry import make_model
from studies.instruments.reference import reference

TOML = """
weave = "twill 2/1"
[warp]
color = ["#a03020", "#2040a0", "#d0d0c0"]
roughness = 0.5
translucency = 0.3
[weft]
roughness = 0.6
translucency = 0.3
"""


@pytest.fixture(scope="module")
def cloth() -> HeldOut:
    return HeldOut("twill", fabric_from_text(TOML), unseen_weave=False, coloured=True)


@pytest.fixture(scope="module", autouse=True)
def own_cache(tmp_path_factory: pytest.TempPathFactory) -> object:
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("cache")))
        yield


@pytest.mark.slow
def test_the_truth_is_that_of_brute_force(cloth: HeldOut) -> None:
    queries, means = query_truth(cloth.fabric, 5, 40, 3, with_colours=True)
    light, view = queries.lights[queries.pairs[:, 0]], queries.views[queries.pairs[:, 1]]
    sizes = queries.sizes.ravel()
    # Smaller footprints fall within a texel of the grid, which knows nothing of what lies in it.
    chosen = np.flatnonzero(sizes > 0.5 * 0.5)
    side = Float(sizes[chosen].astype(np.float32))
    centre = Array2f(np.ascontiguousarray(queries.centres.reshape(-1, 2)[chosen].T, dtype=np.float32))
    footprint = Footprint(centre, Array2f(side, Float(0)), Array2f(Float(0), side))
    pair = chosen // queries.sizes.shape[1]
    estimate = reference(reference_model(cloth.fabric), footprint, light[pair], view[pair], 1024, seed=1)
    # One channel a query, or they would not be independent; only those that most samples contribute to.
    rng = np.random.default_rng(2)
    channel = rng.choice([0, 1, 5, 6, 7], len(chosen))
    rows = np.arange(len(chosen))
    actual = means.reshape(len(sizes), -1)[chosen, channel]
    deviation = np.sqrt(estimate.variance[rows, channel])
    lit = estimate.mean[rows, channel] > 5 * deviation
    z = (actual - estimate.mean[rows, channel])[lit] / deviation[lit]
    assert lit.sum() > 40
    # Sums of squares of standard normal numbers; one run in 10 000 falls outside by chance.
    assert 5e-5 < stats.chi2.cdf((z**2).sum(), len(z)) < 1 - 5e-5
    assert abs(z.mean()) < 4 / np.sqrt(len(z))


def test_the_truth_is_kept_and_a_damaged_file_replaced(cloth: HeldOut, tmp_path: Path) -> None:
    queries, means = query_truth(cloth.fabric, 1, 4, 3, folder=tmp_path)
    assert means.shape == (4, 3, 5)
    (file,) = tmp_path.iterdir()
    written = file.stat().st_mtime_ns
    again, same = query_truth(cloth.fabric, 1, 4, 3, folder=tmp_path)
    assert file.stat().st_mtime_ns == written
    np.testing.assert_array_equal(same, means)
    np.testing.assert_array_equal(again.centres, queries.centres)
    file.write_bytes(file.read_bytes()[:100])
    _, recomputed = query_truth(cloth.fabric, 1, 4, 3, folder=tmp_path)
    # Sums run in another order on other threads.
    np.testing.assert_allclose(recomputed, means, rtol=1e-5, atol=1e-7)
    assert file.stat().st_size > 100


def test_another_fabric_or_seed_is_another_truth(cloth: HeldOut, tmp_path: Path) -> None:
    query_truth(cloth.fabric, 1, 4, 3, folder=tmp_path)
    query_truth(cloth.fabric, 2, 4, 3, folder=tmp_path)
    query_truth(fabric_from_text(TOML.replace("0.6", "0.61")), 1, 4, 3, folder=tmp_path)
    assert len(list(tmp_path.iterdir())) == 3


def test_a_folder_that_cannot_be_written_costs_no_result(cloth: HeldOut, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    _, means = query_truth(cloth.fabric, 1, 4, 3, folder=tmp_path / "file")
    assert np.isfinite(means).all()


@pytest.mark.parametrize("samples", [1, 3, 4, 16])
def test_multi_jittered_points_fill_rows_and_columns(samples: int) -> None:
    points = multi_jittered(np.random.default_rng(0), 50, samples)
    assert points.shape == (50, samples, 2)
    fine = np.sort(np.floor(points * samples).astype(int), axis=1)
    assert (fine == np.arange(samples)[None, :, None]).all()
    if samples == 16:
        cells = np.floor(points * 4).astype(int) @ [4, 1]
        assert (np.sort(cells, axis=1) == np.arange(16)).all()


@pytest.mark.slow
def test_few_samples_are_unbiased_and_more_are_better(cloth: HeldOut) -> None:
    result = run_query_benchmark({}, [cloth], pairs=40, footprints=40, monte_carlo=(1, 4))
    one, four = (result.rows[name] for name in ("1 sample", "4 samples"))
    assert four.metric("reflection") < 0.75 * one.metric("reflection")
    # Some 800 queries with relative deviations of about 1: 4 standard errors.
    assert abs(one.metric("reflection", metric="bias")) < 4 / np.sqrt(800)
    # A point of a small footprint is nearly its mean; a point of several repeats is not.
    assert one.metric("reflection", "b0") < 0.5 * one.metric("reflection", "b3")


@pytest.mark.slow
def test_known_predictions_get_the_errors_they_have(cloth: HeldOut) -> None:
    def exact(fabric: Fabric, queries: QuerySet, factor: float = 1.0) -> Prediction:
        _, means = query_truth(fabric, 2024, 8, 10, with_colours=True)
        return Prediction(means[..., :5] * factor, means[..., 5:8] * factor, means[..., 8] * factor)

    def brighter(fabric: Fabric, queries: QuerySet) -> Prediction:
        return exact(fabric, queries, 1.25)

    def refusing(fabric: Fabric, queries: QuerySet) -> Prediction:
        raise InputError("too large")

    result = run_query_benchmark({"exact": exact, "brighter": brighter}, [cloth], pairs=8, footprints=10)
    for quantity in (
        "reflection",
        "transmission",
        "colour",
        "diffuse_warp",
        "specular_weft",
        "hole",
        "sheen",
    ):
        assert result.rows["exact"].metric(quantity) == pytest.approx(0, abs=1e-7)
        assert result.rows["brighter"].metric(quantity) == pytest.approx(0.25, rel=1e-5)
    assert result.rows["brighter"].metric("reflection", metric="bias") == pytest.approx(0.25, rel=1e-5)
    assert result.rows["brighter"].metric("reflection", "b2") == pytest.approx(0.25, rel=1e-5)
    assert "brighter" in result.tables()[0].to_markdown()

    partly = run_query_benchmark({"refusing": refusing, "exact": exact}, [cloth], pairs=8, footprints=10)
    assert partly.rows["refusing"].refused == {"twill": "too large"}
    assert partly.fabrics == []
    assert partly.to_dict()["rows"]["exact"]["metrics"] == {}


@pytest.mark.slow
def test_a_model_by_the_interface(cloth: HeldOut) -> None:
    queries, truth = query_truth(cloth.fabric, 3, 10, 20, with_colours=True)
    actual = model_predictor(lambda fabric: make_model("point", fabric))(cloth.fabric, queries)
    assert actual.means.shape == (10, 20, 5)
    assert actual.rate is not None
    assert actual.rate > 0
    small = queries.sizes < queries.sizes.min() * 1.5
    # Where the footprint is smaller than a texel of the truth's grid, its centre nearly is the truth.
    error = np.abs(actual.means[small] - truth[small][:, :5]).mean()
    assert error < 0.1 * truth[small][:, :5].mean()
    few = monte_carlo_predictor(1)(cloth.fabric, queries)
    np.testing.assert_allclose(few.colours.shape, actual.colours.shape)


def test_classes_by_angle_and_roughness(cloth: HeldOut) -> None:
    high, low = [0.0, 0.0, 1.0], [np.sqrt(1 - 0.16), 0.0, 0.4]
    queries = QuerySet(
        np.array([high, low]),
        np.array([high]),
        np.array([[0, 0], [1, 0]]),
        np.zeros((2, 1, 2)),
        np.full((2, 1), 0.2),
    )
    band, rough, angle, weave = query_classes(cloth.fabric, queries, unseen_weave=True)
    assert band.names[band.codes[0, 0]] == "b1"
    assert rough.names[rough.codes[0, 0]] == "α > 0.4"
    assert [angle.names[code] for code in angle.codes[:, 0]] == ["within 60°", "beyond 60°"]
    assert weave.names[weave.codes[0, 0]] == "unseen weaves"
