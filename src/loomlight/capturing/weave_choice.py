"""Which weave a photograph shows: the likeliest ones of its crossings, rendered beside it.

All are judged by one yardstick: what crossings show of a structure, and what its render, of the likeliest of
a few kinds of yarn, leaves of the photograph. Renders are compared in samples of one size, so that a pair of
threads and a single one twice as thick are.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import lcm

import numpy as np
from numpy.typing import NDArray

from loomlight.capturing.captured import WeaveChoice
from loomlight.capturing.crossings import Crossings
from loomlight.capturing.grouped import MAX_GROUP, core_of, grouped, groupings
from loomlight.capturing.photo import Photo
from loomlight.capturing.photographer import Light
from loomlight.capturing.thread_colours import ColourOrder, colour_orders
from loomlight.capturing.thread_grid import ThreadGrid
from loomlight.capturing.tile import Tile, folded
from loomlight.capturing.weave_match import WeaveFit, complement_of, placed
from loomlight.capturing.yarn_fit import MODEL_ERROR, Cloth, Fit, YarnFitter
from loomlight.weave.draft import Draft

Report = Callable[[int, int], None]
# Sides that a window may be at, degrees from the right, and the kind of yarn that is tried under each.
_WINDOWS, _MATT = (0.0, 90.0, 180.0, 270.0), "cotton"
# Kinds of yarn that weaves are rendered in: matt, glossy and between.
_TRIED_KINDS = ("cotton", "worsted", "viscose", "silk")
# Of these the likeliest in which groups of threads are, beside the weave that they are groups of.
_GROUP_KINDS = 2
# Weaves that are rendered beside the photograph, and by how much likelier the best may be than another.
_RENDERED, _MARGIN = 3, 0.6
# Threads a side of the repeat that yarns are fitted to; of a larger one it is a part.
_MAX_FITTED = 32
# Samples of a thread that may be a group of two, three or four; of groups larger than these only if one of
# two is likelier than a single thread.
_GROUP_SAMPLES, _FIRST_LIMIT = 12, 2
# Evidence of a crossing at which half of the weaves are right, and the share of the variance between repeats
# that a render may be off by: fitted to 52 swatches of seeds 69, 71 and 72 (studies/accuracy/capture.py).
_HALF_RIGHT, _FAR_OFF = 0.2, 0.3
# Another weave is told of where it is so likely beside the likeliest, and at most so many are.
_RIVAL, _MAX_RIVALS = 0.1, 2
# Groups of three or four threads are so much rarer than pairs, a logarithm times _TEMPER.
_RARE = -8.0
# What renders err by is alike over a whole photograph, so that crossings are fewer witnesses than they count
# as: logarithms of likelihoods are divided by this.
_TEMPER = 4.0
# Repeats in the picture that a mean is taken of at least.
_MIN_REPEATS = 1.8


@dataclass(frozen=True, eq=False)
class Seen:
    """A photograph with its threads."""

    photo: Photo
    grid: ThreadGrid
    crossings: Crossings


@dataclass(frozen=True, eq=False)
class Hypothesis:
    """A weave, and what its render leaves of the photograph.

    Attributes:
        seen: the photograph, with the threads of this weave.
        choice: structure, place and colours; its confidence is not known yet.
        start: the likeliest yarns.
        within: mean square of encoded pixels about the mean of many repeats; infinite if one is seen.
        cost: mean square of what the render leaves of that mean.
        votes: crossings that count.
        kinds: of yarn that it was rendered in, likeliest first.
        fitter: that rendered it; None where it was in other samples than yarns are fitted in.
        prior: logarithm of how much rarer such a weave is than a common one.
    """

    seen: Seen
    choice: WeaveChoice
    start: Fit
    within: float
    cost: float
    votes: float
    kinds: tuple[str, ...]
    fitter: YarnFitter | None = None
    prior: float = 0.0

    @property
    def fit(self) -> WeaveFit:
        """Structure and place."""
        return self.choice.fit

    @property
    def evidence(self) -> float:
        """What a crossing shows of it, a logarithm of a likelihood; less where its render is far off."""
        explained = _FAR_OFF * self.within / self.cost if np.isfinite(self.within) else 1.0
        return max(self.fit.score / self.votes, 0.0) * min(explained, 1.0)


def chosen(
    face: Seen, fits: list[WeaveFit], light: Light, report: Report
) -> tuple[Seen, WeaveChoice, YarnFitter, Fit]:
    """The likeliest weave with its threads, how sure it is, and its yarns so far."""
    if len(fits) == 1:
        choice = choice_of(face, fits[0])
        return face, choice, *begun(face, choice, light)
    found = hypotheses(face, fits, light, report)
    scores = likelihoods(found)
    best = found[int(np.argmax(scores))]
    # As it is on its own repeat, which comes before larger ones.
    best = next(each for each in found if each.fit is best.fit)
    shares = np.exp((scores - scores.max()) / _TEMPER)
    # Two places or grids of one weave are no rivals.
    same = np.array([each.fit.name == best.fit.name != "" or each is best for each in found])
    confidence = _share(found, same) * reliability(best.evidence)
    likeliest = [
        found[number].fit.name for number in np.argsort(-shares) if shares[number] > _RIVAL * shares.max()
    ]
    rivals = [name for name in dict.fromkeys(likeliest) if name not in ("", best.fit.name)]
    choice = replace(best.choice, confidence=confidence, rivals=tuple(rivals[:_MAX_RIVALS]))
    if best.fitter is not None:
        return best.seen, choice, best.fitter, best.start
    return best.seen, choice, *begun(best.seen, choice, light)


def _share(found: list[Hypothesis], same: NDArray[np.bool_]) -> float:
    """The share of some hypotheses in the likelihood of all, with shading as it should be, or turned round.

    The mean counts: highlights turn it round, but a weave that is likely only then is not sure.
    """
    ways = [likelihoods(found, signed) for signed in (0.0, 0.5, 1.0)]
    parts = [np.exp((scores - scores.max()) / _TEMPER) for scores in ways]
    return float(np.mean([part[same].sum() / part.sum() for part in parts]))


def reliability(evidence: float) -> float:
    """How often the likeliest weave is right where crossings show so much of it, beside all that was tried.

    Where they show little, threads may be other than was thought, and then no weave that is tried is right.
    """
    return evidence**2 / (evidence**2 + _HALF_RIGHT**2)


def hypotheses(face: Seen, fits: list[WeaveFit], light: Light, report: Report) -> list[Hypothesis]:
    """The likeliest weaves of the crossings, rendered."""
    votes = face.crossings.votes
    tried = [fit for fit in fits[:_RENDERED] if fits[0].score - fit.score < _MARGIN * votes]
    # Highlights part crossings too: the likeliest weave with a name stands beside one without.
    named = next(fit for fit in fits if fit.name)
    tried += [] if named in tried else [named]
    opposite = complement_of(named, fits, face.crossings)
    if opposite is not None and all(
        (opposite.name, opposite.shift) != (fit.name, fit.shift) for fit in tried
    ):
        tried.append(opposite)
    found = []
    for number, fit in enumerate(tried):
        found += _with_groups(face, fit, light, votes)
        report(number + 1, len(tried))
    return found + _on_larger_repeats(face, tried, light, votes)


def _on_larger_repeats(face: Seen, tried: list[WeaveFit], light: Light, votes: float) -> list[Hypothesis]:
    """Weaves rendered on the repeats of others that are multiples of their own.

    Plies repeat too, by chance in about a multiple of one weave and not of another: what a repeat of a weave
    explains of them any weave explains that fits it.
    """
    sizes = dict.fromkeys(fit.structure.shape for fit in tried)
    found = []
    for fit in tried:
        picks, ends = fit.structure.shape
        for size in sizes:
            if size != (picks, ends) and size[0] % picks == 0 and size[1] % ends == 0:
                larger = replace(fit, structure=np.tile(fit.structure, (size[0] // picks, size[1] // ends)))
                on_larger = _rendered(face, choice_of(face, larger), light, votes)
                found.append(replace(on_larger, choice=choice_of(face, fit), fitter=None))
    return found


def _with_groups(face: Seen, fit: WeaveFit, light: Light, votes: float) -> list[Hypothesis]:
    """A weave, and those in which one of its threads is a group of several, or a group of them one."""
    encoded = face.photo.encoded
    core = core_of(encoded, fit, face.grid, face.crossings)
    sizes = 1 / core.grid.weft.per_px, 1 / core.grid.warp.per_px
    pairs = [times for times in groupings(core, sizes, _FIRST_LIMIT) if times != core.times]
    if not pairs:
        return [_rendered(face, choice_of(face, fit), light, votes)]
    done = {core.times: _rendered(face, choice_of(face, fit), light, votes, core.times)}
    kinds = done[core.times].kinds[:_GROUP_KINDS]

    def render(times: tuple[int, int]) -> None:
        group = grouped(encoded, core, times)
        seen = Seen(face.photo, group.grid, group.crossings)
        choice = WeaveChoice(group.fit, 1.0, *group.orders)
        done[times] = _rendered(seen, choice, light, votes, times, kinds)

    for times in pairs:
        render(times)
    # A group of two that is likelier than a single thread may be one of three or four.
    scores = likelihoods([*done.values()])
    best = [*done][int(np.argmax(scores))]
    for times in groupings(core, sizes, MAX_GROUP):
        if times not in done and all(
            more == count or count > 1 for more, count in zip(times, best, strict=True)
        ):
            render(times)
    return [*done.values()]


def likelihoods(found: list[Hypothesis], signed: float = 0.5) -> NDArray[np.float64]:
    """Logarithms of how likely each hypothesis is [n], but for a common term.

    Args:
        signed: weight, 0 to 1, of what shading says of which family is on top.
    """
    cost = np.array([each.cost for each in found])
    within = np.array([each.within for each in found])
    # What the best repeat cannot explain none can: beyond that, a render is off. How much pixels differ from
    # repeat to repeat is not known of what is seen once: it is as much as that of the best.
    best = float(within.min()) if np.isfinite(within.min()) else 0.0
    left = np.where(np.isfinite(within), within, best) + cost
    off = left - best + MODEL_ERROR**2
    votes = np.array([each.votes for each in found])
    shown = np.array([signed * each.fit.score + (1 - signed) * each.fit.unsigned for each in found])
    # A draft that was made of these crossings fits what is chance in them, such as highlights.
    is_named = np.array([each.fit.name != "" for each in found])
    if is_named.any():
        shown = np.where(is_named, shown, 0.5 * (shown + np.minimum(shown, shown[is_named].max())))
    prior = np.array([each.prior for each in found])
    return np.asarray(prior + shown - 0.5 * votes * (np.log(left) + np.log(off)))


def _rendered(
    seen: Seen,
    choice: WeaveChoice,
    light: Light,
    votes: float,
    times: tuple[int, int] | None = None,
    kinds: tuple[str, ...] = _TRIED_KINDS,
) -> Hypothesis:
    """A weave in the likeliest of a few kinds of yarn; a group of `times` picks and ends is one thread."""
    samples = None if times is None else (_GROUP_SAMPLES // times[0], _GROUP_SAMPLES // times[1])
    fitter, starts = _kinds_begun(seen, choice, light, samples, kinds)
    start = starts[0]
    # A mean of few repeats follows what is chance in them.
    repeats = fitter.repeats
    within = fitter.within * repeats / (repeats - 1) if repeats > _MIN_REPEATS else np.inf
    is_rare = times is not None and max(times) > _FIRST_LIMIT
    likeliest = tuple(each.yarns.kind for each in starts)
    prior = _RARE if is_rare else 0.0
    kept = fitter if samples is None else None
    return Hypothesis(seen, choice, start, within, start.cost, votes, likeliest, kept, prior)


def begun(seen: Seen, choice: WeaveChoice, light: Light) -> tuple[YarnFitter, Fit]:
    """A weave with the likeliest of a few kinds of yarn."""
    fitter, starts = _kinds_begun(seen, choice, light, None, _TRIED_KINDS)
    return fitter, starts[0]


def _kinds_begun(
    seen: Seen, choice: WeaveChoice, light: Light, samples: tuple[int, int] | None, kinds: tuple[str, ...]
) -> tuple[YarnFitter, list[Fit]]:
    """A weave in some kinds of yarn, likeliest first."""
    cloth, tile = cloth_and_tile(seen, choice, samples)
    fitter = YarnFitter(cloth, tile, light)
    colours = choice.warp.colours, choice.weft.colours
    starts = [fitter.begun(kind, colours, steps=1) for kind in kinds]
    return fitter, sorted(starts, key=lambda start: start.cost)


def light_of(face: Seen, fit: WeaveFit, kind: str) -> Light:
    """The light of a kind; of windows the one at the side from which a matt cloth looks likest."""
    if kind == "flash":
        return Light(kind)
    choice = choice_of(face, fit)
    cloth, tile = cloth_and_tile(face, choice)
    colours = choice.warp.colours, choice.weft.colours
    windows = [Light(kind, azimuth) for azimuth in _WINDOWS]
    return min(windows, key=lambda each: YarnFitter(cloth, tile, each).begun(_MATT, colours, steps=1).cost)


def choice_of(face: Seen, fit: WeaveFit) -> WeaveChoice:
    """A weave with the orders of its colours, as sure as it is where there is no other."""
    return WeaveChoice(fit, 1.0, *colour_orders(face.crossings, fit.table(face.crossings.shape)))


def cloth_and_tile(
    face: Seen, choice: WeaveChoice, samples: tuple[int, int] | None = None
) -> tuple[Cloth, Tile]:
    """The repeat of weave and colours from the lower left crossing on, and its mean in the photograph."""
    fit, orders = choice.fit, (choice.warp, choice.weft)
    shape = face.crossings.shape
    ends, picks = (
        _fitted_repeat(of_weave, order, available)
        for of_weave, order, available in zip(fit.structure.shape[::-1], orders, shape[::-1], strict=True)
    )
    drawdown = placed(fit.structure, fit.shift, (picks[0], ends[0]))
    roles = tuple(order.of_threads(count) for order, (count, _) in zip(orders, (ends, picks), strict=True))
    grid, photo = face.grid, face.photo
    per_cm = (10 * grid.warp.per_px * photo.px_per_mm, 10 * grid.weft.per_px * photo.px_per_mm)
    tile = folded(
        photo.linear,
        photo.encoded,
        grid,
        (float(face.crossings.first[0]), float(face.crossings.first[1])),
        (picks[0], ends[0]),
        once=not (ends[1] and picks[1]),
        samples=samples,
    )
    colours = len(choice.warp.colours), len(choice.weft.colours)
    return Cloth(Draft(drawdown), (roles[0], roles[1]), colours, per_cm), tile


def _fitted_repeat(of_weave: int, order: ColourOrder, available: int) -> tuple[int, bool]:
    """Threads of the repeat that yarns are fitted to, and whether it is a whole one."""
    whole = lcm(of_weave, len(order.order))
    if order.repeats and whole <= max(_MAX_FITTED, of_weave):
        return whole, True
    return min(max(_MAX_FITTED // of_weave, 1) * of_weave, available), False
