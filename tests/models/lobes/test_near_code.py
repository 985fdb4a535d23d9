"""Close-ups in machine code against Dr.Jit's: the same searches and formulas, in other company."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from functools import cache
from typing import Any

import drjit as dr
import numpy as np
import pytest
from numpy.typing import NDArray

from loomlight.core.lane_code import Vectors
from loomlight.fabric import Fabric, fabric_from_text
from loomlight.fabric.fabric import make_fabric
from loomlight.fabric.file import FabricFile
from loomlight.models.interface import Response
from loomlight.models.lobes import model as lobes_model
from loomlight.models.lobes.compiled import CompiledCloseUps
from loomlight.models.lobes.model import LobesModel
from loomlight.weave.draft import Draft, Threads

from .cloths import Asked, askew, cloth, directions, far_parts

QUERIES = 20_000
# Footprints, in threads: of one point, and up to where groups answer alone.
SMALLEST, LARGEST = 1 / 40, 1.6
# Rounding, beside the mean where answers are small. At an outline it may show another yarn, which changes a
# query beyond that. Measured: 2 queries in 10,000 apart, none by more than ten times as much; other
# processors round in other ways.
RELATIVE, APART = 1e-4, 1e-3
# Of means over all queries: 3e-7 measured, and a query that sees another yarn changes them by 5e-5.
MEANS = 1e-4

Parts = dict[str, NDArray[np.float32]]


class NoCloseUps:
    """In place of close-ups: groups alone."""

    def run(self, queries: Sequence[Any], answers: Sequence[Any]) -> None:
        """Leaves what groups answer."""


@dataclass(frozen=True)
class Cloth:
    """A fabric to look at, by how its threads are found.

    Attributes:
        varied: whether threads differ, of warp and of weft.
        gap: share that threads leave free, if they are alike.
    """

    varied: tuple[bool, bool]
    gap: float

    def fabric(self) -> Fabric:
        """It, of a weave by chance."""
        ends, picks = 5, 7
        drawdown = np.random.default_rng(0).random((picks, ends)) < 0.5
        warp, weft = (self._threads(*of) for of in zip((ends, picks), self.varied, strict=True))
        # Where all threads have a thickness it says what gaps are.
        fields = FabricFile(gap=None if all(self.varied) else self.gap)
        return make_fabric(fields, Draft(drawdown, warp, weft), "threads", ".")

    def _threads(self, count: int, varied: bool) -> Threads:
        if not varied:
            return Threads(spacing_mm=np.full(count, 0.5))
        number = np.arange(count)
        spacing = np.where(number % 3, 0.4, 0.6)
        thickness = np.where(number % 2, 0.3, 0.36) if self.gap else None
        return Threads(spacing_mm=spacing, thickness_mm=thickness)


VARIED = {
    "varied warp": Cloth((True, False), 0.3),
    "varied weft, closed": Cloth((False, True), 0.0),
    "varied": Cloth((True, True), 0.3),
}
NAMES = ["open plain", "closed twill", *VARIED]
# Every way to find threads by default; where code differs most by other vectors too, which LLVM splits if
# they are too long.
CASES = [(name, None) for name in NAMES]
CASES += [(name, wide) for name in ("open plain", "varied") for wide in (Vectors(4, 16), Vectors(8, 16))]
CASES += [("varied", Vectors(16, 32))]


def fabric_of(name: str) -> Fabric:
    if name in VARIED:
        return VARIED[name].fabric()
    if name == "closed twill":
        return fabric_from_text(
            'weave = "twill 2/2"\ngap = 0.0\ndiffuse_blend = 0.7\n[weft]\nroughness = 0.2'
        )
    return cloth(name)


@pytest.fixture(autouse=True)
def compiled(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever the processor: elsewhere it would not be faster, but no less right."""
    monkeypatch.setattr(lobes_model, "close_ups_are_compiled", lambda: True)


@cache
def model_of(name: str) -> LobesModel:
    """A model whose groups, which are another test's, are few."""
    return LobesModel.for_fabric(fabric_of(name), groups=1)


def with_close_ups(model: LobesModel, close_ups: Any) -> LobesModel:
    """The same tables with other close-ups."""
    found = LobesModel(model.fabric, model.tables)
    found._compiled_close_ups = close_ups
    return found


@cache
def asked_of(name: str, count: int = QUERIES, largest: float = LARGEST) -> Asked:
    """Queries from everywhere, of footprints askew: both faces, lights on both sides."""
    rng, model = np.random.default_rng(1), model_of(name)
    sizes = np.exp(rng.uniform(np.log(SMALLEST), np.log(largest), count)) * model._thread
    centres = rng.uniform(-1, 2, (count, 2)) * np.asarray(model.fabric.repeat_mm)
    return Asked(directions(rng, count), directions(rng, count), centres, sizes, askew(rng, count))


def some_of(asked: Asked, chosen: Any) -> Asked:
    """Chosen queries."""
    given = (getattr(asked, field.name) for field in fields(Asked))
    return Asked(*(None if part is None else part[chosen] for part in given))


def parts_of(response: Response) -> Parts:
    dr.eval(response)
    dr.sync_thread()
    return {part.name: getattr(response, part.name).numpy() for part in fields(Response)}


def by_machine(model: LobesModel, asked: Asked) -> Parts:
    return parts_of(model.evaluate(asked.light, asked.view, asked.footprint))


@cache
def by_drjit(name: str) -> Parts:
    asked = asked_of(name)
    return parts_of(model_of(name)._answers([asked.light], asked.view, asked.footprint, None)[0][0])


def agree(found: Parts, wanted: Parts) -> None:
    for part, values in wanted.items():
        mean = values.mean(dtype=np.float64)
        assert mean > 0, part
        apart = ~np.isclose(found[part], values, rtol=RELATIVE, atol=RELATIVE * mean)
        assert apart.mean() <= APART, (part, apart.mean(), found[part][apart][:5], values[apart][:5])
        np.testing.assert_allclose(found[part].mean(dtype=np.float64), mean, rtol=MEANS, err_msg=part)


@pytest.mark.parametrize(("name", "wide"), CASES, ids=str)
def test_machine_code_says_what_drjit_does(name: str, wide: Vectors | None) -> None:
    model, asked = model_of(name), asked_of(name)
    close_ups = CompiledCloseUps(model.fabric.layout(), model.fabric.appearance(), wide)
    found, wanted = by_machine(with_close_ups(model, close_ups), asked), by_drjit(name)
    agree(found, wanted)


def test_cloths_differ_in_what_is_written() -> None:
    """Else the test above would look at less than it says."""
    uniform = {name: tuple(family.uniform for family in model_of(name)._geometry.families) for name in VARIED}
    assert uniform == {name: tuple(not varied for varied in of.varied) for name, of in VARIED.items()}
    for name in NAMES:
        holes, closed = by_drjit(name)["hole"], "closed" in name
        assert (holes.mean() < 1e-3) == closed, name
        # Whole pixels that are holes.
        assert (holes == 1).any() or closed, name


@pytest.mark.parametrize("wide", [None, Vectors(4, 16)], ids=str)
@pytest.mark.parametrize("count", [1, 511, 513])
def test_batches_answer_like_the_one_that_they_are_cut_from(count: int, wide: Vectors | None) -> None:
    """Blocks are of 512 queries and less: what else is searched with a ray does not change it."""
    model, asked = model_of("open plain"), some_of(asked_of("open plain"), slice(2000))
    close_ups = CompiledCloseUps(model.fabric.layout(), model.fabric.appearance(), wide)
    model = with_close_ups(model, close_ups)
    whole = by_machine(model, asked)
    for first in (0, 700):
        cut = slice(first, first + count)
        for name, values in by_machine(model, some_of(asked, cut)).items():
            np.testing.assert_array_equal(values, whole[name][cut], err_msg=name)


@pytest.mark.parametrize("name", ["open plain", "varied"])
def test_odd_numbers_harm_no_other_query(name: str) -> None:
    """Nothing is read where there is no table, and every search ends, whatever is asked."""
    model, asked = model_of(name), some_of(asked_of(name), slice(600))
    whole = by_machine(model, asked)
    spoilt = np.arange(600) % 3 == 0
    for part in ("lights", "views", "centres", "sizes"):
        for value in (np.nan, np.inf, -np.inf, 0.0, 1e30, -3e38):
            values = getattr(asked, part).copy()
            values[spoilt] = value
            with np.errstate(all="ignore"):
                found = by_machine(model, replace(asked, **{part: values}))
            for component, numbers in found.items():
                np.testing.assert_array_equal(
                    numbers[~spoilt], whole[component][~spoilt], err_msg=f"{part} {value} {component}"
                )


def test_close_up_points_count_and_far_away_groups_alone() -> None:
    """Also in blocks where some queries have points and others have none."""
    model = model_of("open plain")
    asked = asked_of("open plain", 3000, largest=60.0)
    found = by_machine(model, asked)
    groups = by_machine(with_close_ups(model, NoCloseUps()), asked)
    # Where they count nothing groups are not asked above.
    close_by = far_parts(model, asked)
    threads = asked.sizes / model._thread
    # Where groups alone count, rounding of the bound aside; see `model._HAND_OVER`.
    far = asked.sizes > 1.61 * max(model._thread, 0.8 * model.tables.size)
    near = threads < 0.3
    assert min(far.sum(), near.sum()) > 500
    for name, values in found.items():
        np.testing.assert_array_equal(values[far], groups[name][far])
        # One yarn is seen, or a hole, or a shadow, where groups are a mean over both families.
        np.testing.assert_array_equal(groups[name][near], 0)
        apart = np.abs(values[near] - close_by[name][near]).mean() / close_by[name][near].mean()
        # Measured: 1.1 to 1.6 of the groups' mean.
        assert apart > 0.5, (name, apart)


def test_close_ups_are_asked_for_once_per_evaluation(monkeypatch: pytest.MonkeyPatch) -> None:
    counts: list[int] = []
    run = CompiledCloseUps.run

    def counted(self: CompiledCloseUps, queries: Sequence[Any], answers: Sequence[Any]) -> None:
        counts.append(len(answers[0]))
        run(self, queries, answers)

    monkeypatch.setattr(CompiledCloseUps, "run", counted)
    by_machine(model_of("open plain"), some_of(asked_of("open plain"), slice(100)))
    assert counts == [100]


def test_without_it_batches_are_answered_alike(monkeypatch: pytest.MonkeyPatch) -> None:
    """As on processors whose lanes cannot be put together in memory."""

    def never(*_: object) -> None:
        raise AssertionError("close-ups were asked of machine code")

    monkeypatch.setattr(CompiledCloseUps, "run", never)
    monkeypatch.setattr(lobes_model, "close_ups_are_compiled", lambda: False)
    agree(by_machine(model_of("varied"), asked_of("varied")), by_drjit("varied"))


def test_fabrics_alike_share_their_code() -> None:
    """Numbers of a fabric are no part of it: another one is not compiled, and answers for itself."""
    codes = [model_of(name)._compiled_close_ups._code for name in ("open plain", "closed twill", "varied")]
    assert codes[0] is codes[1]
    assert codes[0] is not codes[2]
