"""The yarns of a photographed cloth: what makes a rendered repeat look like the photographed one.

Colours, roughness, specular, heights, gap and sharpness are fitted together to the mean repeat (`tile.py`) by
Levenberg and Marquardt's method, each begun from and held by what its kind of yarn says, as strongly as
yarns of a kind differ. What the photograph says beyond that narrows the error that is told of each.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.capturing.photographer import Light
from loomlight.capturing.tile import Tile, rendered, unsharp
from loomlight.core.colour import linear_to_srgb
from loomlight.fabric.fabric import Fabric, make_fabric
from loomlight.fabric.read import validate_fields
from loomlight.fabric.yarns import PRESETS
from loomlight.weave.draft import Draft, Threads

Numbers = NDArray[np.float64]
FAMILIES = ("warp", "weft")


@dataclass(frozen=True)
class Parameter:
    """A number that is fitted, of each family.

    Attributes:
        low, high: its range in fabric files, or narrower.
        spread: a standard deviation by which yarns of one kind differ, of its logarithm.
        misfit: a standard error of its logarithm that our renders add, as uneven yarns look like even ones.
        step: of differences, of its logarithm.
    """

    low: float
    high: float
    spread: float
    misfit: float
    step: float = 0.06


PARAMETERS = {
    "roughness": Parameter(0.05, 0.9, 0.35, 0.25),
    "specular": Parameter(0.02, 1.0, 0.5, 0.3),
    "height_scale": Parameter(0.3, 1.8, 0.25, 0.15),
    # Of the width that yarn fills, 1 − gap.
    "fill": Parameter(0.4, 0.99, 0.1, 0.05, 0.03),
}
# A kind whose render leaves so much more of the photograph than the likest, as a share, counts e times less.
_FARTHER = 0.25
# Root mean square of 255 that renders of cloths usually leave at most.
_USUAL_ROOT = 5.0
# Standard errors to either side between which 9 of 10 lie.
NINE_OF_TEN = 1.645
# CIEDE2000 that colours are off by at most in 9 of 10, and that more a root mean square of 255 left.
_COLOUR_ERROR = 1.5, 0.35
# Kinds that differ enough in a photograph; others are like one of them.
KINDS = ("cotton", "mercerised cotton", "linen", "wool", "worsted", "silk", "viscose")
# Errors of encoded values that no fit of ours is free of: what our yarns are not.
MODEL_ERROR = 0.01
# Deviation of encoded pixels that every place has.
NOISE = 0.03
# Values of neighbouring samples of a tile err alike, and a render by the same all over it: one in so many is
# independent.
_SAMPLES_A_VALUE = 48.0
_MIN_COLOUR, _MAX_COLOUR = 2e-3, 1.0
_BLURS = (0.3, 0.5, 0.8, 1.2, 1.8, 2.5)
_MIN_BLUR, _MAX_BLUR = 0.15, 4.0
_COLOUR_STEP = 0.1


@dataclass(frozen=True, eq=False)
class Cloth:
    """What is known of a cloth before its yarns are fitted.

    Attributes:
        draft: one repeat of weave and colours, without colours.
        roles: which of its colours each end, and each pick, of the repeat has.
        colours: how many warp and weft have; what is fitted of a long order need not show all of them.
        per_cm: threads a centimetre of warp and weft.
    """

    draft: Draft
    roles: tuple[NDArray[np.intp], NDArray[np.intp]]
    colours: tuple[int, int]
    per_cm: tuple[float, float]


@dataclass(frozen=True, eq=False)
class Yarns:
    """A guess of the yarns.

    Attributes:
        kind: of yarn.
        numbers: of PARAMETERS, for warp and weft.
        colours: linear RGB of each role, of warp [k, 3] and weft [k, 3].
        blur: deviation of the unsharpness, samples of the tile.
    """

    kind: str
    numbers: dict[str, tuple[float, float]]
    colours: tuple[Numbers, Numbers]
    blur: float = 0.8


@dataclass(frozen=True, eq=False)
class Fit:
    """What a fit came to.

    Attributes:
        yarns: the best.
        cost: mean square of what is left, of encoded values.
        picture: the rendered repeat, as unsharp as the photographed one, linear RGB.
        errors: a standard error of the logarithm of each number, for warp and weft; empty until it is known.
        model_errors: what our renders and the choice of a kind add to it, of the logarithm of each number.
    """

    yarns: Yarns
    cost: float
    picture: Numbers
    errors: dict[str, tuple[float, float]] = field(default_factory=dict)
    model_errors: dict[str, float] = field(default_factory=dict)

    def bounds(self, name: str, family: int) -> tuple[float, float]:
        """Between which a number of warp (0) or weft (1) lies in 9 of 10 photographs."""
        value, parameter = self.yarns.numbers[name][family], PARAMETERS[name]
        known = self.errors.get(name, (parameter.spread, parameter.spread))[family]
        reach = float(np.exp(NINE_OF_TEN * np.hypot(known, self.model_errors.get(name, parameter.misfit))))
        # Fits stay a little below 1, which yarns may have.
        return max(value / reach, parameter.low), min(value * reach, max(parameter.high, 1.0))

    @property
    def colour_error(self) -> float:
        """CIEDE2000 within which colours are in 9 of 10 photographs."""
        return _COLOUR_ERROR[0] + _COLOUR_ERROR[1] * 255 * float(np.sqrt(self.cost))


def with_model_errors(fit: Fit, kinds: Sequence[Fit]) -> Fit:
    """The fit with what it may be off by as other kinds of yarn look much the same.

    Args:
        kinds: each in the photograph's colours.
    """
    cost = np.array([kind.cost for kind in kinds])
    weight = np.exp(-(cost / cost.min() - 1) / _FARTHER)
    weight /= weight.sum()
    # What a render leaves beyond what it usually does is more than uneven yarns.
    off = max(255 * float(np.sqrt(fit.cost)) / _USUAL_ROOT, 1.0)
    found = {}
    for name, parameter in PARAMETERS.items():
        values = np.log(
            [yarns_of_kind(each.yarns.kind, each.yarns.colours).numbers[name][0] for each in kinds]
        )
        variance = float(weight @ np.square(values - weight @ values))
        found[name] = float(np.sqrt(variance + (off * parameter.misfit) ** 2))
    return replace(fit, model_errors=found)


def yarns_of_kind(kind: str, colours: tuple[Numbers, Numbers]) -> Yarns:
    """The yarns of a kind, as files have them that say no more."""
    preset = PRESETS[kind]
    numbers = {
        "roughness": preset.fields.roughness or 0.3,
        "specular": preset.fields.specular or 0.4,
        "height_scale": 1.0,
        "fill": 1 - preset.gap,
    }
    clipped = {
        name: float(np.clip(value, PARAMETERS[name].low, PARAMETERS[name].high))
        for name, value in numbers.items()
    }
    return Yarns(kind, {name: (value, value) for name, value in clipped.items()}, colours)


def even_fabric(cloth: Cloth, yarns: Yarns) -> Fabric:
    """The fabric of a guess, whose yarns are even: unevenness is no part of a mean repeat."""
    tables: dict[str, Any] = {
        family: {
            "yarn": yarns.kind,
            "gap": float(np.clip(1 - yarns.numbers["fill"][number], 0.0, 0.95)),
            "slub": 0.0,
            **{name: yarns.numbers[name][number] for name in ("roughness", "specular", "height_scale")},
        }
        for number, family in enumerate(FAMILIES)
    }
    fields = validate_fields(
        {
            "weave": "plain",
            "ends_per_cm": cloth.per_cm[0],
            "picks_per_cm": cloth.per_cm[1],
            "variation": {"irregularity": 0.0},
            **tables,
        }
    )
    # Colours of the draft: a fabric of which fields give none looks for none that is out of reach.
    warp, weft = (Threads(colors=colours) for colours in _of_threads(cloth, yarns))
    return make_fabric(fields, replace(cloth.draft, warp=warp, weft=weft), "photograph", ".")


def _of_threads(cloth: Cloth, yarns: Yarns) -> tuple[Numbers, Numbers]:
    warp, weft = (colours[roles] for colours, roles in zip(yarns.colours, cloth.roles, strict=True))
    return warp, weft


def _recoloured(fabric: Fabric, cloth: Cloth, yarns: Yarns) -> Fabric:
    """The fabric in the colours of a guess that differs in nothing else: how open it lies is the same."""
    warp, weft = _of_threads(cloth, yarns)
    other = replace(fabric)
    appearance = replace(
        fabric.appearance(), warp=fabric.recoloured("warp", warp), weft=fabric.recoloured("weft", weft)
    )
    other.__dict__.update(_layout=fabric.layout(), _appearance=appearance)
    return other


class YarnFitter:
    """Renders guesses beside one photographed repeat.

    Args:
        cloth: what is known.
        tile: the photographed repeat.
        light: of the photograph.
    """

    def __init__(self, cloth: Cloth, tile: Tile, light: Light) -> None:
        self._cloth, self._tile, self._light = cloth, tile, light
        # Where pixels of one place differ, as at boundaries of threads that wander, their mean says less.
        weights = np.minimum(tile.counts, 2 * tile.counts.mean()) / (NOISE**2 + tile.variance)
        self._weights = np.sqrt(weights / weights.mean())[..., None]
        self._masks = self._roles_shown()
        self._target = tile.encoded
        # The fabric that was rendered last, by all but its colours.
        self._last: tuple[tuple[object, ...], Fabric] | None = None

    @property
    def within(self) -> float:
        """Mean square of the photograph's encoded pixels about their mean repeat."""
        return self._tile.within

    @property
    def repeats(self) -> float:
        """How often the repeat is seen, about."""
        return self._tile.repeats

    @property
    def samples(self) -> int:
        """Independent values of the tile."""
        return max(int(self._target.size / _SAMPLES_A_VALUE), 16)

    def _roles_shown(self) -> list[list[NDArray[np.bool_]]]:
        """Where each colour of each family shows, bool [rows, columns] of the tile."""
        up = self._cloth.draft.drawdown
        ends, picks = self._cloth.roles
        found = []
        for role, on_top, count in (
            (np.broadcast_to(ends[None, :], up.shape), up, self._cloth.colours[0]),
            (np.broadcast_to(picks[:, None], up.shape), ~up, self._cloth.colours[1]),
        ):
            each = [on_top & (role == number) for number in range(count)]
            found.append([np.kron(mask, np.ones(self._tile.samples, bool)) for mask in each])
        return found

    def sharp(self, yarns: Yarns) -> Numbers:
        """The rendered repeat of a guess, linear RGB."""
        key = yarns.kind, tuple(yarns.numbers.items())
        if self._last is not None and self._last[0] == key:
            fabric = _recoloured(self._last[1], self._cloth, yarns)
        else:
            fabric = even_fabric(self._cloth, yarns)
            self._last = key, fabric
        return rendered(fabric, self._tile.samples, self._light)

    def residual(self, sharp: Numbers, blur: float) -> Numbers:
        """What is left of the photographed repeat, weighted [rows, columns, 3]."""
        return (linear_to_srgb(unsharp(sharp, (blur, blur))) - self._target) * self._weights

    def cost(self, sharp: Numbers, blur: float) -> float:
        """Mean square of that."""
        return float(np.square(self.residual(sharp, blur)).mean())

    def coloured(self, yarns: Yarns, steps: int = 2) -> tuple[Yarns, Numbers]:
        """The guess with colours whose means over the repeat are the photograph's, and its repeat."""
        sharp = self.sharp(yarns)
        for _ in range(steps):
            yarns = self._matched(yarns, sharp)
            sharp = self.sharp(yarns)
        blur = min(_BLURS, key=lambda each: self.cost(sharp, each))
        return replace(yarns, blur=blur), sharp

    def _matched(self, yarns: Yarns, sharp: Numbers) -> Yarns:
        shown = unsharp(sharp, (yarns.blur, yarns.blur))
        found = []
        for number in range(2):
            colours = yarns.colours[number].copy()
            for role, mask in enumerate(self._masks[number]):
                weight = self._tile.counts * mask
                if weight.sum() == 0:
                    continue
                here = (shown * weight[..., None]).sum(axis=(0, 1))
                there = (self._tile.linear * weight[..., None]).sum(axis=(0, 1))
                colours[role] = np.clip(
                    colours[role] * there / np.maximum(here, 1e-6), _MIN_COLOUR, _MAX_COLOUR
                )
            found.append(colours)
        return replace(yarns, colours=(found[0], found[1]))

    def begun(self, kind: str, colours: tuple[Numbers, Numbers], steps: int = 2) -> Fit:
        """A kind of yarn in the photograph's colours, and nothing else fitted."""
        yarns, sharp = self.coloured(yarns_of_kind(kind, colours), steps)
        return Fit(yarns, self.cost(sharp, yarns.blur), unsharp(sharp, (yarns.blur, yarns.blur)))

    def improved(
        self, start: Fit, *, apart: bool, steps: int = 4, tell: Callable[[Fit], None] = lambda fit: None
    ) -> Fit:
        """The fit after some steps; with `apart` each family has numbers of its own.

        Args:
            tell: called with each better fit.
        """
        prior = yarns_of_kind(start.yarns.kind, start.yarns.colours)
        space = _Space(start.yarns, prior, apart)
        point = space.point_of(start.yarns)
        yarns, sharp = start.yarns, self.sharp(start.yarns)
        noise = MODEL_ERROR**2 + start.cost
        damping, best = 1e-2, start
        objective = self._objective(sharp, yarns, space, point, noise)
        covariance: Numbers | None = None
        for _ in range(steps):
            residual, jacobian = self._linearised(yarns, sharp, space, point)
            scale = self.samples / (residual.size * noise)
            held = np.diag(space.precision)
            normal = scale * jacobian.T @ jacobian + held
            gradient = scale * jacobian.T @ residual + space.precision * (point - space.middle)
            covariance = np.asarray(np.linalg.inv(normal), np.float64)
            for _ in range(3):
                move = -np.linalg.solve(normal + damping * np.diag(np.diag(normal)), gradient)
                other = space.bounded(point + np.clip(move, -0.7, 0.7))
                guess = space.yarns_of(other, yarns)
                picture = self.sharp(guess)
                value = self._objective(picture, guess, space, other, noise)
                if value < objective:
                    break
                damping *= 8
            else:
                break
            gained = objective - value
            point, yarns, sharp, objective = other, guess, picture, value
            damping = max(damping / 6, 1e-4)
            noise_now = self.cost(sharp, yarns.blur)
            best = Fit(yarns, noise_now, unsharp(sharp, (yarns.blur, yarns.blur)))
            tell(best)
            if gained < 0.1:
                break
        errors = {} if covariance is None else space.errors(np.sqrt(np.diag(covariance)))
        return replace(best, errors=errors)

    def _objective(self, sharp: Numbers, yarns: Yarns, space: _Space, point: Numbers, noise: float) -> float:
        off = float((space.precision * np.square(point - space.middle)).sum())
        return 0.5 * (self.samples * self.cost(sharp, yarns.blur) / noise + off)

    def _linearised(
        self, yarns: Yarns, sharp: Numbers, space: _Space, point: Numbers
    ) -> tuple[Numbers, Numbers]:
        """What is left [n], and its derivatives by all coordinates [n, k]."""
        here = self.residual(sharp, yarns.blur)
        of_colours, columns = [], []
        # A channel of a colour changes that channel alone: one picture a family shows all of them.
        for family in range(2):
            colours = [each.copy() for each in yarns.colours]
            factor = np.exp(np.where(colours[family].max() > 0.85, -_COLOUR_STEP, _COLOUR_STEP))
            colours[family] = colours[family] * factor
            picture = self.sharp(replace(yarns, colours=(colours[0], colours[1])))
            change = (self.residual(picture, yarns.blur) - here) / np.log(factor)
            for mask in self._masks[family]:
                near = unsharp(mask[..., None].astype(np.float64), (yarns.blur, yarns.blur))
                near = np.clip(near, 0, 1) if len(self._masks[family]) > 1 else np.ones_like(near)
                for channel in range(3):
                    column = np.zeros_like(change)
                    column[..., channel] = change[..., channel] * near[..., 0]
                    of_colours.append(column.ravel())
        for number, step in enumerate(space.steps):
            # A step away from the nearer end of the range.
            step = -step if point[number] + step > space.high[number] else step
            moved = point.copy()
            moved[number] += step
            guess = space.yarns_of(moved, yarns)
            picture = sharp if number == space.blur_at else self.sharp(guess)
            columns.append(((self.residual(picture, guess.blur) - here) / step).ravel())
        return here.ravel(), np.stack([*columns, *of_colours], axis=1)


class _Space:
    """The coordinates that are fitted: logarithms of numbers, of the unsharpness, and of colours.

    Attributes:
        middle, precision: of what is known of each beforehand.
        steps: of differences, of the coordinates before the colours.
        high: where their ranges end.
        blur_at: which of them is the unsharpness.
    """

    def __init__(self, yarns: Yarns, prior: Yarns, apart: bool) -> None:
        self._apart = apart
        self._families: Sequence[tuple[int, ...]] = ((0,), (1,)) if apart else ((0, 1),)
        middle, spread, steps, low, high = [], [], [], [], []
        for name, parameter in PARAMETERS.items():
            for families in self._families:
                middle.append(np.log(prior.numbers[name][families[0]]))
                spread.append(parameter.spread)
                steps.append(parameter.step)
                low.append(np.log(parameter.low))
                high.append(np.log(parameter.high))
        self.blur_at = len(steps)
        middle.append(np.log(0.8))
        spread.append(1.0)
        steps.append(0.1)
        low.append(np.log(_MIN_BLUR))
        high.append(np.log(_MAX_BLUR))
        self._shapes = [colours.shape for colours in yarns.colours]
        colours = np.concatenate([np.log(each.ravel()) for each in yarns.colours])
        self.middle = np.concatenate([middle, colours])
        # Of colours nothing is known beforehand.
        self.precision = np.concatenate([1 / np.square(spread), np.full(colours.size, 1e-4)])
        self.steps = np.array(steps)
        self._low = np.concatenate([low, np.full(colours.size, np.log(_MIN_COLOUR))])
        self.high = np.concatenate([high, np.full(colours.size, np.log(_MAX_COLOUR))])

    def point_of(self, yarns: Yarns) -> Numbers:
        """The coordinates of a guess."""
        numbers = [
            np.mean([np.log(yarns.numbers[name][family]) for family in families])
            for name in PARAMETERS
            for families in self._families
        ]
        colours = [np.log(np.maximum(each.ravel(), _MIN_COLOUR)) for each in yarns.colours]
        return self.bounded(np.concatenate([numbers, [np.log(yarns.blur)], *colours]))

    def yarns_of(self, point: Numbers, like: Yarns) -> Yarns:
        """The guess at coordinates."""
        numbers, place = {}, 0
        for name in PARAMETERS:
            values = [0.0, 0.0]
            for families in self._families:
                for family in families:
                    values[family] = float(np.exp(point[place]))
                place += 1
            numbers[name] = (values[0], values[1])
        rest = np.exp(point[place + 1 :])
        split = int(np.prod(self._shapes[0]))
        colours = rest[:split].reshape(self._shapes[0]), rest[split:].reshape(self._shapes[1])
        return Yarns(like.kind, numbers, colours, float(np.exp(point[place])))

    def bounded(self, point: Numbers) -> Numbers:
        """Coordinates within their ranges."""
        return np.asarray(np.clip(point, self._low, self.high))

    def errors(self, deviations: Numbers) -> dict[str, tuple[float, float]]:
        """Of each number for warp and weft, from those of the coordinates."""
        found, place = {}, 0
        for name in PARAMETERS:
            values = [0.0, 0.0]
            for families in self._families:
                for family in families:
                    values[family] = float(deviations[place])
                place += 1
            found[name] = (values[0], values[1])
        return found
