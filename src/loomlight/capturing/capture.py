"""A fabric file from a photograph of flat cloth: the steps in their order."""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable
from dataclasses import dataclass, replace
from math import lcm
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from loomlight.capturing.captured import FABRIC_SUFFIX, Captured, WeaveChoice
from loomlight.capturing.crossings import Crossings, find_crossings
from loomlight.capturing.lighting import light_over
from loomlight.capturing.photo import FINE_SIDE, WORKING_SIDE, Photo, read_photo
from loomlight.capturing.photographer import Light
from loomlight.capturing.thread_colours import ColourOrder, colour_orders
from loomlight.capturing.thread_grid import ThreadGrid, find_grid
from loomlight.capturing.tile import Tile, folded
from loomlight.capturing.weave_match import (
    WeaveFit,
    complement_of,
    fit_drafts,
    fit_structure,
    fit_weaves,
    placed,
)
from loomlight.capturing.yarn_fit import KINDS, MODEL_ERROR, Cloth, Fit, YarnFitter
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.files import PIXEL_SUFFIXES, require_file
from loomlight.core.images import write_pixels
from loomlight.core.outputs import check_output
from loomlight.weave.draft import Draft
from loomlight.weave.load import load_draft
from loomlight.weave.named import named_weave
from loomlight.weave.recognition import weave_name

Report = Callable[[int, int], None]
LIGHTS = ("flash", "window")
# Sides that a window may be at, degrees from the right, and the kind of yarn that is tried under each.
_WINDOWS, _MATT = (0.0, 90.0, 180.0, 270.0), "cotton"
# Below so many pixels a thread the photograph is looked at again in more of its own pixels.
_FINE_PX = 14.0
# Weaves that are rendered beside the photograph, and by how much likelier the best may be than another.
_RENDERED, _MARGIN = 3, 0.35
# Threads a side of the repeat that yarns are fitted to; of a larger one it is a part.
_MAX_FITTED = 32
# Score a vote below which no weave is better than none.
_MIN_GAIN = 0.02
# Kinds of yarn whose numbers are fitted.
_FITTED_KINDS = 2
# Mean square that is left by a kind, over that of the likest, up to which it may come to be likest.
_NEAR = 1.5
# Parts of the work that are reported.
_STEPS = 100


@dataclass(frozen=True, eq=False)
class _Seen:
    """A photograph with its threads."""

    photo: Photo
    grid: ThreadGrid
    crossings: Crossings


def capture(
    photo: str | os.PathLike[str],
    output: str | os.PathLike[str] | None = None,
    *,
    width_mm: float,
    weave: str | None = None,
    draft: str | os.PathLike[str] | None = None,
    back: str | os.PathLike[str] | None = None,
    light: str = "flash",
    white: str | None = None,
    grey_card: str | None = None,
    sheet: str | os.PathLike[str] | None = None,
    report: Report = lambda done, total: None,
    kept: Callable[[Captured], None] = lambda found: None,
) -> Captured:
    """The fabric that a photograph of flat cloth shows, and with `output` its file.

    The warp runs up the picture. What is found is written as soon as there is anything, and again as it gets
    better, so that an interruption keeps the last good fit.

    Args:
        photo: a picture file, of cloth that lies flat, from straight above, lit by a flash or a window.
        output: the fabric file (.toml); a weave without a name is written beside it as a draft (.wif).
        width_mm: millimetres of cloth that the picture is wide.
        weave: its name, where it is known.
        draft: a draft file, where that is known.
        back: a photograph of the same cloth from behind, as wide, turned like a page; it tells weaves apart.
        light: "flash" at the camera or "window" at a side.
        white: sRGB hex that white paper has in the photograph, in the same light.
        grey_card: the same of a grey card of 18 %.
        sheet: a .png or .jpg of photograph, render in the same light, difference and draft.
        report: called with parts of the work done and in all.
        kept: called with each better result.

    Returns:
        The fabric with what is known of each field, and how good it is.

    Raises:
        InputError: a photograph that shows no weave: blurred, too coarse, clipped, a knit, not flat; a weave
            or a draft that cannot be read; a path that cannot be written.
    """
    if light not in LIGHTS:
        raise InputError(f'light = "{light}" is unknown: write {" or ".join(LIGHTS)}.')
    if weave is not None and draft is not None:
        raise InputError("weave and draft say the same: give one of them.")
    if output is not None:
        check_output(Path(output), (FABRIC_SUFFIX,), [photo, back, draft])
    if sheet is not None:
        check_output(Path(sheet), PIXEL_SUFFIXES, [photo, back, draft, output])
    given = _given_structure(weave, draft)
    report(1, _STEPS)
    # Read, and find the threads.
    face = _seen(photo, width_mm, white, grey_card)
    report(12, _STEPS)
    views = [face.crossings]
    if back is not None:
        views.append(_seen(back, width_mm, white, grey_card).crossings)
    report(20, _STEPS)
    # Find the weave by what crossings show, and by renders of the likeliest ones.
    if given is None:
        fits = fit_weaves(views)
        fits = sorted([*fits, *fit_drafts(views, fits)], key=lambda fit: -fit.score)
        _require_weave(photo, fits[0], face.crossings)
    else:
        fits = [fit_structure(given[0], given[1], views)]
    report(28, _STEPS)
    face = _evenly_lit(face, fits[0])
    lit = _light(face, fits[0], light)
    choice, fitter, start = _chosen(face, fits, lit, report)
    sketch = Captured(
        photo=str(photo),
        linear=face.photo.linear,
        width_mm=width_mm,
        light=lit,
        choice=choice,
        grid=face.grid,
        crossings=face.crossings,
        fit=start,
        draft_file=None if draft is None else str(draft),
    )

    def keep(fit: Fit) -> Captured:
        found = replace(sketch, fit=fit)
        if output is not None:
            found.save(output)
        kept(found)
        return found

    def better(fit: Fit) -> None:
        keep(fit)

    keep(start)
    # Fit the yarns: of the likeliest kinds, and then of each family by itself.
    kinds = _kinds(fitter, start, lambda done, total: report(50 + 15 * done // total, _STEPS))
    best = keep(kinds[0])
    near = [kind for kind in kinds[:_FITTED_KINDS] if kind.cost < _NEAR * kinds[0].cost]
    for number, each in enumerate(near):
        fitted = fitter.improved(each, apart=False, steps=3)
        report(65 + 10 * (number + 1), _STEPS)
        if fitted.cost < best.fit.cost:
            best = keep(fitted)
    best = keep(fitter.improved(best.fit, apart=True, steps=2, tell=better))
    report(95, _STEPS)
    if sheet is not None:
        write_pixels(sheet, best.sheet())
    _warn(best)
    report(_STEPS, _STEPS)
    return best


def _warn(found: Captured) -> None:
    """Says of a result that cannot be relied on that it is one."""
    for sentence in found.doubts:
        warnings.warn(f"{found.photo}: {sentence}", LoomlightWarning, stacklevel=3)


# ----------------------------------------------------------------------------------------------------- seeing


def _seen(path: str | os.PathLike[str], width_mm: float, white: str | None, grey_card: str | None) -> _Seen:
    """A photograph and its threads, in as many pixels as these need."""
    require_file(path)
    photo = read_photo(path, width_mm, white=white, grey_card=grey_card)
    is_reduced = max(photo.full_size) > WORKING_SIDE
    try:
        grid = find_grid(photo.encoded)
    except InputError as error:
        if not is_reduced:
            raise InputError(f"{path}: {error}") from error
        grid = None
    if grid is None or (is_reduced and max(grid.warp.per_px, grid.weft.per_px) > 1 / _FINE_PX):
        photo = read_photo(path, width_mm, white=white, grey_card=grey_card, side=FINE_SIDE)
        try:
            grid = find_grid(photo.encoded)
        except InputError as error:
            raise InputError(f"{path}: {error}") from error
    return _Seen(photo, grid, find_crossings(photo.encoded, grid))


def _evenly_lit(seen: _Seen, fit: WeaveFit) -> _Seen:
    """The same without the falling off of its light."""
    up = fit.table(seen.crossings.shape)
    orders = colour_orders(seen.crossings, up)
    light = light_over(seen.photo.path, seen.photo.linear.shape[:2], seen.grid, seen.crossings, up, orders)
    even = replace(seen.photo, linear=(seen.photo.linear / light[..., None]).astype(np.float32))
    return _Seen(even, seen.grid, find_crossings(even.encoded, seen.grid))


def _given_structure(
    weave: str | None, draft: str | os.PathLike[str] | None
) -> tuple[str, NDArray[np.bool_]] | None:
    """The name and structure that the user gives."""
    if weave is not None:
        made = named_weave(weave)
        name = " ".join(weave.split())
        # The colours are the photograph's: of colour-and-weave effects the structure is kept.
        return name if made.palette is None else weave_name(made.drawdown) or name, made.drawdown
    if draft is not None:
        return "", load_draft(draft).drawdown
    return None


def _require_weave(photo: str | os.PathLike[str], best: WeaveFit, crossings: Crossings) -> None:
    if best.score < _MIN_GAIN * crossings.roundness.size:
        raise InputError(
            f"{photo}: its crossings look all alike, as loops of a knit and prints do, and show no weave; of "
            'woven cloth say which it is by --weave "twill 2/1" or --draft, or photograph it closer.'
        )


# ---------------------------------------------------------------------------------------------------- weaving


def _light(face: _Seen, fit: WeaveFit, kind: str) -> Light:
    """The light of a kind; of windows the one at the side from which a matt cloth looks likest."""
    if kind == "flash":
        return Light(kind)
    choice = _choice(face, fit, 1.0)
    cloth, tile = _cloth_and_tile(face, choice)
    colours = choice.warp.colours, choice.weft.colours
    windows = [Light(kind, azimuth) for azimuth in _WINDOWS]
    return min(windows, key=lambda each: YarnFitter(cloth, tile, each).begun(_MATT, colours, steps=1).cost)


def _chosen(
    face: _Seen, fits: list[WeaveFit], light: Light, report: Report
) -> tuple[WeaveChoice, YarnFitter, Fit]:
    """The weave whose render is likest, with how sure that is, and its yarns so far."""
    votes = face.crossings.votes
    tried = [fit for fit in fits[:_RENDERED] if fits[0].score - fit.score < _MARGIN * votes]
    if len(fits) > 1:
        opposite = complement_of(fits[0], fits)
        # Of plain weave and others it is the same, begun at another thread.
        if opposite is not None and all(
            (opposite.name, opposite.shift) != (fit.name, fit.shift) for fit in tried
        ):
            tried.append(opposite)
    if len(fits) == 1:
        fitter, start, _ = _begun(face, fits[0], light)
        return _choice(face, fits[0], 1.0), fitter, start
    found = []
    for number, fit in enumerate(tried):
        fitter, start, left = _begun(face, fit, light)
        # Of the pixels, and of their mean repeat, where families that have changed places differ.
        off = np.log(left) + np.log(start.cost + MODEL_ERROR**2)
        found.append((fit.unsigned - 0.5 * votes * off, fit, fitter, start))
        report(28 + 20 * (number + 1) // len(tried), _STEPS)
    found.sort(key=lambda each: -each[0])
    scores = np.array([each[0] for each in found])
    shares = np.exp(np.clip(scores - scores[0], -700, 0))
    _, fit, fitter, start = found[0]
    return _choice(face, fit, float(1 / shares.sum())), fitter, start


def _begun(face: _Seen, fit: WeaveFit, light: Light) -> tuple[YarnFitter, Fit, float]:
    """A weave with the likeliest of two kinds of yarn, and the mean square that is left of the picture."""
    choice = _choice(face, fit, 1.0)
    cloth, tile = _cloth_and_tile(face, choice)
    fitter = YarnFitter(cloth, tile, light)
    colours = choice.warp.colours, choice.weft.colours
    starts = [fitter.begun(kind, colours, steps=1) for kind in ("cotton", "silk")]
    best = min(starts, key=lambda start: start.cost)
    return fitter, best, tile.within + best.cost


def _choice(face: _Seen, fit: WeaveFit, confidence: float) -> WeaveChoice:
    warp, weft = colour_orders(face.crossings, fit.table(face.crossings.shape))
    return WeaveChoice(fit, confidence, warp, weft)


def _cloth_and_tile(face: _Seen, choice: WeaveChoice) -> tuple[Cloth, Tile]:
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
    )
    colours = len(choice.warp.colours), len(choice.weft.colours)
    return Cloth(Draft(drawdown), (roles[0], roles[1]), colours, per_cm), tile


def _fitted_repeat(of_weave: int, order: ColourOrder, available: int) -> tuple[int, bool]:
    """Threads of the repeat that yarns are fitted to, and whether it is a whole one."""
    whole = lcm(of_weave, len(order.order))
    if order.repeats and whole <= max(_MAX_FITTED, of_weave):
        return whole, True
    return min(max(_MAX_FITTED // of_weave, 1) * of_weave, available), False


# ------------------------------------------------------------------------------------------------------ yarns


def _kinds(fitter: YarnFitter, start: Fit, report: Report) -> list[Fit]:
    """Kinds of yarn in the photograph's colours, likest first."""
    found = []
    for number, kind in enumerate(KINDS):
        found.append(fitter.begun(kind, start.yarns.colours, steps=1))
        report(number + 1, len(KINDS))
    return sorted(found, key=lambda fit: fit.cost)
