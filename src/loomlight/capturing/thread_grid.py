"""Where the threads of a photographed cloth lie: directions, setts with their uncertainty, all boundaries.

Ends meet at upright edges and picks at level ones, in whatever weave and colours: so the edges across x, as
a picture of their own, repeat with the ends, and those across y with the picks. Along the right turn, edges
that lie in one line add up, and their autocorrelation has its first peak at one thread. The phase of that
frequency, demodulated over a neighbourhood of a few threads (geometric phase analysis, Hÿtch et al. 1998),
says where each boundary is, also of threads that wander and of cloth that the camera sees a little aslant.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError

Plane = NDArray[np.float64]

# A thread of fewer pixels shows no crossings; fewer threads than this across the picture no period.
MIN_THREAD_PX, MIN_THREADS = 6.0, 6.0
# Rows and columns may be turned by so much against the threads, degrees.
MAX_TURN = 10.0
# Of the turns that are tried, degrees; a picture's rows are told apart by a third of that.
_TURN_STEP = 0.5
# A photograph is usually turned by no more than this (a deviation), and turns that differ by less are one.
_USUAL_TURN, _SAME_TURN = 4.0, 1.6
# Edges of so much of the picture's height are taken to lie in one line: threads of uneven yarn wander.
_STRIP = 0.4
# Height of the autocorrelation's peaks over its dips, of its value at 0: below it nothing repeats. Noise has
# about 0.05.
_MIN_REPEAT = 0.2
# Deviation of the demodulating window, in threads: wide for the first look, then narrow, as threads wander.
_WIDE, _NARROW = 3.5, 1.6
# By how much a highlight is brighter than the thread beside it, as a share, where it is taken for one.
_CROWN = 0.02
# Another place of the grid is the better one where it leaves this share of the variance of hues in crossings.
_BETTER = 0.8
# Sum of encoded channels below which a hue is mostly noise.
_DARK = 0.15
# Bins of a folded profile, over one period.
_BINS = 48
# A boundary within a group of threads is fainter than that between groups: the first peak of the
# autocorrelation may have as small a share of the highest.
_MIN_INNER = 0.12
# Highest period that is looked for, as a share of the picture, and multiples of it that must repeat too.
_MAX_PERIOD, _MULTIPLES = 1 / 6, 4
# Peaks of each spectrum that are looked at, and pairs of them of which grids are made.
_PEAKS, _PAIRS = 12, 4
# Ends and picks may be off a right angle by so much (a deviation, radians), as cloth is skewed and cameras
# tilt; and a peak lies within so much of a period of the whole picture of where it is found.
_SKEW, _PEAK_ERROR = np.radians(0.4), 0.15
# Periods and turns that differ by less are of one grid: shares, and radians.
_SAME_PERIOD, _SAME_ANGLE = 0.03, np.radians(0.7)


@dataclass(frozen=True, eq=False)
class Family:
    """The threads of one family in the picture.

    Attributes:
        number: at each pixel [height, width], in threads: it grows by 1 a thread, and boundaries between
            threads are where it is whole.
        per_px: threads a pixel across the threads, mean over the picture.
        error: standard error of that, relative.
        turn: of the threads against the picture's sides, radians anticlockwise.
        strength: height of the autocorrelation's peaks over its dips, of its value at 0.
    """

    number: Plane
    per_px: float
    error: float
    turn: float
    strength: float


@dataclass(frozen=True, eq=False)
class ThreadGrid:
    """Both families of a picture: `warp` runs up the picture and `weft` across it, rows counted upwards."""

    warp: Family
    weft: Family

    def regrouped(self, times: tuple[float, float], start: tuple[float, float] = (0.0, 0.0)) -> ThreadGrid:
        """The grid in which each thread counts as so many of warp and weft, a fraction joins several.

        Args:
            start: numbers of this grid that become 0, for warp and weft.
        """
        warp, weft = (
            replace(family, number=(family.number - first) * count, per_px=family.per_px * count)
            for family, count, first in zip((self.warp, self.weft), times, start, strict=True)
        )
        return ThreadGrid(warp, weft)


def find_grid(shade: Plane) -> ThreadGrid:
    """The likeliest grid of threads; see `find_grids`."""
    return find_grids(shade)[0]


def find_grids(shade: Plane) -> list[ThreadGrid]:
    """Grids of threads that a picture may show, likeliest first.

    Twisted yarns that swell between their crossings are shaded in slanting lines, whose turn is another:
    where the strongest lines are turned far, the strongest among nearly upright ones are tried too. Such
    lines, and highlights, repeat in other periods than threads do, but hardly in two at right angles: peaks
    of the spectra that are make further grids.

    Args:
        shade: encoded colours [height, width, channels], 0 to 1.

    Raises:
        InputError: no period, or threads that are too fine.
    """
    # Of picks, the picture is laid on its side.
    warp_edges, weft_edges = _edges(shade, 1.0, True), _edges(shade, 1.0, False).T
    spectra = [_Spectrum(edges) for edges in (warp_edges, weft_edges)]
    # Threads cross at right angles: one turn for both, which rows and columns see in opposite ways.
    turns = np.radians(np.arange(-MAX_TURN, MAX_TURN + _TURN_STEP / 2, _TURN_STEP))
    strength = np.array([spectra[0].repeats(turn) + spectra[1].repeats(-turn) for turn in turns])
    upright = strength * np.exp(-0.5 * np.square(turns / np.radians(_USUAL_TURN)))
    tried = [float(turns[np.argmax(strength)]), float(turns[np.argmax(upright)])]
    if abs(tried[0] - tried[1]) < np.radians(_SAME_TURN):
        tried.pop()
    found, fault = [], None
    for turn in tried:
        try:
            found.append(_turned_grid(shade, (warp_edges, weft_edges), spectra, turn))
        except InputError as error:
            fault = fault or error
    if fault is not None and not found:
        raise fault
    for ends, picks in _right_angled(spectra):
        grid = _joined(shade, *_families(shade, (warp_edges, weft_edges), (ends, picks)))
        if not any(_is_same(grid, other) for other in found):
            found.append(grid)
    return found


def _is_same(grid: ThreadGrid, other: ThreadGrid) -> bool:
    """Whether two grids have the same setts and turns."""
    return all(
        abs(one.per_px / two.per_px - 1) < _SAME_PERIOD and abs(one.turn - two.turn) < _SAME_ANGLE
        for one, two in ((grid.warp, other.warp), (grid.weft, other.weft))
    )


def _right_angled(spectra: list[_Spectrum]) -> list[tuple[_Peak, _Peak]]:
    """Peaks of ends and picks that are at right angles, strongest pairs first."""
    sides = [spectrum.peaks() for spectrum in spectra]
    if not all(sides):
        return []
    highest = [max(peak.power for peak in peaks) for peaks in sides]

    def likelihood(ends: _Peak, picks: _Peak) -> float:
        error = np.hypot(_SKEW, np.hypot(ends.error, picks.error))
        # Of picks the picture is laid on its side, and turns the other way.
        off = (ends.turn + picks.turn) / error
        return float(np.log(ends.power / highest[0]) + np.log(picks.power / highest[1]) - 0.5 * off**2)

    pairs = [(ends, picks) for ends in sides[0] for picks in sides[1]]
    return sorted(pairs, key=lambda pair: -likelihood(*pair))[:_PAIRS]


def _families(shade: Plane, edges: tuple[Plane, Plane], peaks: tuple[_Peak, _Peak]) -> tuple[Family, Family]:
    """The families of two frequencies, of picks in the picture that is laid on its side."""
    warp, weft = (
        _in_phase(each, _followed_from(each, peak.fx, peak.fy), 1.0)
        for each, peak in zip(edges, peaks, strict=True)
    )
    return warp, weft


def _turned_grid(
    shade: Plane, edges: tuple[Plane, Plane], spectra: list[_Spectrum], turn: float
) -> ThreadGrid:
    """The grid whose threads are turned by about so many radians.

    Raises:
        InputError: no period, or threads that are too fine.
    """
    light = shade.mean(axis=-1)
    warp = _family(edges[0], light, spectra[0], turn)
    weft = _family(edges[1], light.T, spectra[1], -turn)
    return _joined(shade, warp, weft)


def _joined(shade: Plane, warp: Family, weft: Family) -> ThreadGrid:
    """The grid of two families, of which that of picks is of the picture laid on its side."""
    # Of rows that count downwards, picks count upwards.
    number = -weft.number.T
    number = number - np.floor(number.min())
    upright = Family(number, weft.per_px, weft.error, -weft.turn, weft.strength)
    return _in_place(_hue(shade), ThreadGrid(warp, upright))


def _in_place(hue: Plane, grid: ThreadGrid) -> ThreadGrid:
    """The grid, moved by half a thread where crossings are then of one hue.

    On glossy threads the edges of highlights outdo those of threads, and lie halfway between them.
    """
    places = {
        (x, y): _unevenness(hue, grid.warp.number + x, grid.weft.number + y)
        for x in (0.0, 0.5)
        for y in (0.0, 0.5)
    }
    best = min(places, key=lambda place: places[place])
    if places[best] > _BETTER * places[0.0, 0.0]:
        return grid
    warp, weft = (
        replace(family, number=family.number + shift)
        for family, shift in zip((grid.warp, grid.weft), best, strict=True)
    )
    return ThreadGrid(warp, weft)


def _unevenness(hue: Plane, ends: Plane, picks: Plane) -> float:
    """Variance of hues within the crossings of a grid, a mean over all."""
    column, row = np.floor(ends).astype(np.intp), np.floor(picks).astype(np.intp)
    index = ((row - row.min()) * (int(np.ptp(column)) + 1) + column - column.min()).ravel()
    counts = np.maximum(np.bincount(index), 1)
    total = 0.0
    for channel in np.moveaxis(hue, -1, 0):
        values = channel.ravel()
        means = np.bincount(index, values) / counts
        total += float((np.bincount(index, np.square(values)) - counts * np.square(means)).sum())
    return total / index.size


# ---------------------------------------------------------------------------------------------------- edges


def _edges(shade: Plane, sigma: float, across: bool) -> Plane:
    """Strength of edges and of grooves across x or y [height, width], of brightness and of hue.

    Highlights have edges that no thread has, but hardly those of hue.
    """
    return _strength(shade, sigma, across) + _strength(_hue(shade), sigma, across)


def _hue(shade: Plane) -> Plane:
    """Channels as shares of their sum."""
    return shade / (shade.sum(axis=-1, keepdims=True) + _DARK)


def _strength(channels: Plane, sigma: float, across: bool) -> Plane:
    """Local energy of first and second derivatives, which has one peak at a step as at a groove."""
    total = np.zeros(channels.shape[:2])
    axis = 1 if across else 0
    for channel in np.moveaxis(channels, -1, 0):
        slope = np.gradient(blurred(channel, sigma), axis=axis)
        total += np.square(slope) + np.square(sigma * np.gradient(slope, axis=axis))
    strength = np.sqrt(total)
    # Edges of colours far outdo those of shading: they are made comparable.
    level = np.median(strength) + 1e-6
    return np.asarray(np.log1p(strength / level))


def blurred(plane: Plane, sigma: float | tuple[float, float]) -> Plane:
    """A plane convolved with a Gaussian of deviation `sigma`, of rows and columns, mirrored outside."""
    sigmas = (sigma, sigma) if isinstance(sigma, int | float) else sigma
    for axis, deviation in enumerate(sigmas):
        plane = _blurred_along(plane, deviation, axis)
    return plane


def _blurred_along(plane: Plane, sigma: float, axis: int) -> Plane:
    if sigma <= 0:
        return plane
    count = plane.shape[axis]
    # A mirrored signal is periodic: its convolution is a product.
    mirrored = np.concatenate([plane, np.flip(plane, axis)], axis=axis)
    frequency = np.fft.rfftfreq(2 * count)
    shape = [1] * plane.ndim
    shape[axis] = -1
    gain = np.exp(-2 * np.square(np.pi * sigma * frequency)).reshape(shape)
    spectrum = np.fft.rfft(mirrored.real, axis=axis) * gain
    result = np.fft.irfft(spectrum, 2 * count, axis=axis)
    if np.iscomplexobj(plane):
        spectrum = np.fft.rfft(mirrored.imag, axis=axis) * gain
        result = result + 1j * np.fft.irfft(spectrum, 2 * count, axis=axis)
    return np.asarray(np.take(result, np.arange(count), axis=axis))


# --------------------------------------------------------------------------------------------------- a family


@dataclass(frozen=True)
class _Peak:
    """A frequency that a picture of edges has.

    Attributes:
        fx, fy: periods a pixel along x and y.
        power: at its top.
        error: of its turn, radians.
    """

    fx: float
    fy: float
    power: float
    error: float

    @property
    def turn(self) -> float:
        """Of lines across it, radians anticlockwise."""
        return float(-np.arctan2(self.fy, self.fx))


class _Spectrum:
    """Power of a picture of edges, of which autocorrelations along nearly level lines are made."""

    def __init__(self, edges: Plane) -> None:
        height, width = edges.shape
        window = np.hanning(width)
        ground = (edges - edges.mean()) * np.outer(np.hanning(height), window)
        self._power = np.square(np.abs(np.fft.rfft2(ground, (2 * height, 2 * width))))
        self._fx = np.arange(self._power.shape[1]) / (2 * width)
        self._fy = np.fft.fftfreq(2 * height)[:, None]
        self._height, self._width = height, width
        # A window shortens the signal: what it leaves of each lag.
        left = np.fft.irfft(np.square(np.abs(np.fft.rfft(window, 2 * width))), 2 * width)[: width // 2]
        self._left = np.maximum(left / left[0], 0.02)
        self._periods = np.arange(MIN_THREAD_PX / 2, width * _MAX_PERIOD, 0.25)

    def autocorrelation(self, turn: float) -> NDArray[np.float64]:
        """Of the edges of threads that are turned by an angle, over lags in pixels along a row."""
        near = np.abs(self._fy + np.tan(turn) * self._fx) < 1 / (_STRIP * self._height)
        line = np.where(near, self._power, 0).sum(axis=0)
        # Light, and wide stripes.
        line[self._fx < 3 / self._width] = 0
        return np.fft.irfft(line, 2 * self._width)[: self._width // 2] / self._left

    def peaks(self) -> list[_Peak]:
        """The strongest frequencies of nearly upright lines that threads may have, strongest first."""
        # Threads have frequencies in the first columns alone.
        columns = int(2 * self._width / MIN_THREAD_PX) + 3
        power, rows = self._power[:, :columns], len(self._power)
        fx = self._fx[:columns]
        steep = np.abs(self._fy) <= np.tan(np.radians(MAX_TURN)) * fx
        inside = steep & (fx > 1 / (_MAX_PERIOD * self._width)) & (fx < 1 / MIN_THREAD_PX)
        # Windows make a peak four bins wide.
        around = power
        for axis in (0, 1):
            around = np.max([np.roll(around, shift, axis) for shift in range(-2, 3)], axis=0)
        tops = np.argwhere((power >= around) & inside)
        tops = tops[np.argsort(-power[tops[:, 0], tops[:, 1]])][:_PEAKS]
        found = []
        for row, column in tops:
            beside = np.log(power[row, [column - 1, column, column + 1]] + 1e-30)
            over = np.log(power[[row - 1, row, (row + 1) % rows], column] + 1e-30)
            x = (column + _vertex(*beside)) / (2 * self._width)
            y = float(self._fy[row, 0]) + _vertex(*over) / (2 * self._height)
            error = _PEAK_ERROR / (self._height * x)
            found.append(_Peak(float(x), float(y), float(power[row, column]), float(error)))
        return found

    def repeats(self, turn: float) -> float:
        """How high the autocorrelation's peaks stand over its dips, at best."""
        values = self.autocorrelation(turn)
        lags = np.arange(len(values))
        multiples = np.arange(1, _MULTIPLES + 1)[None, :]
        peaks = multiples * self._periods[:, None]
        dips = peaks - 0.5 * self._periods[:, None]
        inside = peaks < len(values)
        height = np.interp(peaks, lags, values) - np.interp(dips, lags, values)
        return float(((height * inside).sum(axis=1) / inside.sum(axis=1)).max())

    def period(self, turn: float) -> tuple[float, float]:
        """Pixels along a row from thread to thread, and how surely they repeat, 0 to 2; 0 and 0 if not."""
        values = self.autocorrelation(turn)
        sure = self.repeats(turn) / max(float(values[0]), 1e-30)
        smooth = np.convolve(values, [0.25, 0.5, 0.25], "same")
        tops = [
            (lag, _over_dips(smooth, lag))
            for lag in range(int(MIN_THREAD_PX / 2), int(self._width * _MAX_PERIOD) + 1)
            if smooth[lag] >= smooth[lag - 1] and smooth[lag] > smooth[lag + 1]
        ]
        if not tops or sure < _MIN_REPEAT:
            return 0.0, 0.0
        highest = max(height for _, height in tops)
        period = float(next(lag for lag, height in tops if height > _MIN_INNER * highest))
        # Of many threads the lag is known better than of one.
        for number in range(1, int(len(values) * 0.6 / period) + 1):
            lag = round(number * period)
            reach = max(1, int(0.25 * period))
            part = smooth[max(lag - reach, 1) : lag + reach + 1]
            if len(part) < 3 or not 0 < int(np.argmax(part)) < len(part) - 1:
                break
            place = max(lag - reach, 1) + int(np.argmax(part))
            period = (place + _vertex(*smooth[place - 1 : place + 2])) / number
        return period, sure


def _over_dips(smooth: NDArray[np.float64], lag: int) -> float:
    """How high a peak stands over the deeper dips within half its lag on both sides."""
    before, after = smooth[max(1, lag - lag // 2) : lag + 1], smooth[lag : lag + max(2, lag // 2)]
    return float(smooth[lag] - max(before.min(), after.min()))


def _vertex(before: float, here: float, after: float) -> float:
    """Where the parabola through three neighbours is highest, from the middle one."""
    bend = before - 2 * here + after
    return float(0.5 * (before - after) / bend) if bend < 0 else 0.0


def _family(edges: Plane, light: Plane, spectrum: _Spectrum, turn: float) -> Family:
    """The family whose boundaries run upwards in a picture of edges, and in its brightness.

    Raises:
        InputError: nothing repeats, or threads are too fine or too few.
    """
    width = edges.shape[1]
    period, sure = spectrum.period(turn)
    if period == 0:
        raise InputError(
            "no threads that repeat were found: photograph woven cloth (no knit, felt or print) from "
            "straight above, flat and sharp, its threads along its sides and six pixels wide or more."
        )
    if period < MIN_THREAD_PX:
        raise InputError(
            f"the photograph is too coarse: a thread has {period:.1f} pixels, and {MIN_THREAD_PX:g} or more "
            "are needed; come closer, or use a higher resolution."
        )
    if width < MIN_THREADS * period:
        raise InputError(
            f"the photograph shows {width / period:.0f} threads across; step back until it shows "
            f"{MIN_THREADS:.0f} or more."
        )
    number, coherence = _followed_from(edges, 1 / period, -np.tan(turn) / period)
    family = _in_phase(edges, (number, coherence), sure)
    crown = _crown(light, family.number)
    return family if crown is None else _halved(family, 1 - crown)


def _followed_from(edges: Plane, fx: float, fy: float) -> tuple[Plane, float]:
    """Number of threads at each pixel, and how coherent it is, from a frequency that is about right."""
    number, coherence = np.zeros_like(edges), 0.0
    for threads in (_WIDE, _NARROW):
        number, coherence = _followed(edges, fx, fy, threads)
        fx, fy = _slope(number)
    return number, coherence


def _in_phase(edges: Plane, followed: tuple[Plane, float], sure: float) -> Family:
    """The family of followed threads, whose boundaries are where edges are strongest."""
    number, coherence = followed
    number = number - _peak_place(_profile(edges, number))
    fx, fy = _slope(number)
    per_px = float(np.hypot(fx, fy))
    # The mean slope is what both sides of the picture differ by: a tenth of a thread is not known there.
    error = 0.1 / (per_px * edges.shape[1]) * np.sqrt(2) / max(coherence, 0.1)
    number = number - np.floor(number.min())
    return Family(number, per_px, float(error), float(-np.arctan2(fy, fx)), sure)


def _halved(family: Family, start: int) -> Family:
    """The family of threads twice as thick, which begin at even (0) or odd (1) boundaries."""
    number = (family.number - start) / 2
    number = number - np.floor(number.min())
    return replace(family, number=number, per_px=family.per_px / 2, error=2 * family.error)


def _crown(light: Plane, number: Plane) -> int | None:
    """Which of even and odd boundaries are crowns of glossy threads, 0 or 1; None if none are.

    A highlight along a thread has edges as boundaries have, but is brighter than both sides of it.
    """
    # Bins 0 and 24 of the two periods are boundaries.
    profile = _around(_profile(light, number / 2))
    quarter = _BINS // 4
    rise = [
        float(profile[place] - 0.5 * (profile[place - quarter] + profile[(place + quarter) % _BINS]))
        / float(profile.mean())
        for place in (0, _BINS // 2)
    ]
    bright = int(np.argmax(rise))
    return bright if rise[bright] > _CROWN and rise[1 - bright] < rise[bright] - _CROWN else None


def _slope(number: Plane) -> tuple[float, float]:
    """Growth a pixel along x and y of the plane that fits a field best."""
    height, width = number.shape
    x, y = np.arange(width) - (width - 1) / 2, np.arange(height) - (height - 1) / 2
    return float(number.mean(axis=0) @ x / (x @ x)), float(number.mean(axis=1) @ y / (y @ y))


def _followed(edges: Plane, fx: float, fy: float, threads: float) -> tuple[Plane, float]:
    """Number of threads from the left at each pixel, by the phase of a frequency; and how coherent it is.

    The window has a deviation of so many threads. Its phase is found on nodes half of that apart.
    """
    height, width = edges.shape
    y, x = np.mgrid[0:height, 0:width]
    carrier = 2 * np.pi * (fx * x + fy * y)
    turned = (edges - edges.mean()) * np.exp(-1j * carrier)
    sigma = threads / np.hypot(fx, fy)
    (down, up), (across, back) = (_nodes(count, sigma) for count in (height, width))
    amplitude = down @ turned @ across.T
    size = np.abs(amplitude)
    residual = up @ _unwrapped(amplitude) @ back.T
    coherence = float(size.mean() / (np.sqrt(np.square(size).mean()) + 1e-12))
    return (carrier + residual) / (2 * np.pi), coherence


def _nodes(count: int, sigma: float) -> tuple[Plane, Plane]:
    """Matrices from `count` samples to Gaussian means at nodes [n, count], and from nodes back [count, n]."""
    number = max(2, round(2 * (count - 1) / sigma) + 1)
    places = np.linspace(0, count - 1, number)
    weights = np.exp(-0.5 * np.square((np.arange(count)[None, :] - places[:, None]) / sigma))
    weights /= weights.sum(axis=1, keepdims=True)
    along = np.arange(count) / (count - 1) * (number - 1)
    back = np.maximum(1 - np.abs(along[:, None] - np.arange(number)[None, :]), 0)
    return weights, back


def _unwrapped(amplitude: NDArray[np.complex128]) -> Plane:
    """The phase of a smooth complex field, continued without jumps, from rows and columns of large size."""
    phase = np.angle(amplitude)
    size = np.abs(amplitude)
    # Down the strongest column first, then along rows; a second order by columns checks nothing more.
    column = int(np.argmax(size.min(axis=0)))
    spine = np.unwrap(phase[:, column])
    right = np.unwrap(phase[:, column:], axis=1)
    left = np.unwrap(phase[:, column::-1], axis=1)[:, ::-1]
    rows = np.concatenate([left[:, :-1], right], axis=1)
    return np.asarray(rows + (spine - rows[:, column])[:, None])


def _profile(edges: Plane, number: Plane) -> NDArray[np.float64]:
    """Mean strength of edges over one period [48], from where `number` is whole."""
    part = number - np.floor(number)
    bins = np.minimum((part * _BINS + 0.5).astype(np.intp) % _BINS, _BINS - 1).ravel()
    total, counts = np.bincount(bins, edges.ravel(), _BINS), np.bincount(bins, minlength=_BINS)
    # Of a whole number of pixels a thread some bins have next to none.
    known = np.flatnonzero(counts > 0.2 * counts.mean())
    return np.interp(np.arange(_BINS), known, total[known] / counts[known], period=_BINS)


def _peak_place(profile: NDArray[np.float64]) -> float:
    """Where a profile is highest, as a share of the period, between its bins."""
    smooth = _around(profile)
    top = int(np.argmax(smooth))
    return float((top + _vertex(smooth[top - 1], smooth[top], smooth[(top + 1) % _BINS])) / _BINS)


def _around(profile: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.asarray((np.roll(profile, 1) + 2 * profile + np.roll(profile, -1)) / 4)
