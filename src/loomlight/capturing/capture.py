"""A fabric file from a photograph of flat cloth: the steps in their order."""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np

from loomlight.capturing.captured import FABRIC_SUFFIX, Captured
from loomlight.capturing.crossings import Crossings, find_crossings
from loomlight.capturing.grid_choice import likeliest_grid
from loomlight.capturing.lighting import light_over
from loomlight.capturing.photo import FINE_SIDE, WORKING_SIDE, read_photo
from loomlight.capturing.thread_colours import colour_orders
from loomlight.capturing.weave_choice import Seen, chosen, light_of
from loomlight.capturing.weave_match import Structure, WeaveFit, fit_drafts, fit_structure, fit_weaves
from loomlight.capturing.yarn_fit import KINDS, Fit, YarnFitter, with_model_errors
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.files import PIXEL_SUFFIXES, require_file
from loomlight.core.images import write_pixels
from loomlight.core.outputs import check_output
from loomlight.weave.load import load_draft
from loomlight.weave.named import named_weave
from loomlight.weave.recognition import weave_name

Report = Callable[[int, int], None]
LIGHTS = ("flash", "window")
# Below so many pixels a thread the photograph is looked at again in more of its own pixels.
_FINE_PX = 14.0
# Score a vote below which no weave is better than none.
_MIN_GAIN = 0.02
# Kinds of yarn whose numbers are fitted.
_FITTED_KINDS = 2
# Mean square that is left by a kind, over that of the likest, up to which it may come to be likest.
_NEAR = 1.5
# Parts of the work that are reported.
_STEPS = 100


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
    face, first = _seen(photo, width_mm, white, grey_card, given)
    report(12, _STEPS)
    face = _evenly_lit(face, first)
    views = [face.crossings]
    if back is not None:
        views.append(_seen(back, width_mm, white, grey_card, _of_back(given))[0].crossings)
    report(20, _STEPS)
    # Find the weave by what crossings show, and by renders of the likeliest ones.
    if given is None:
        fits = fit_weaves(views)
        fits = sorted([*fits, *fit_drafts(views, fits)], key=lambda fit: -fit.score)
        _require_weave(photo, fits[0], face.crossings)
    else:
        fits = [fit_structure(given[0], given[1], views)]
    report(28, _STEPS)
    lit = light_of(face, fits[0], light)
    face, choice, fitter, start = chosen(
        face, fits, lit, lambda done, total: report(28 + 20 * done // total, _STEPS)
    )
    sketch = Captured(
        photo=str(photo),
        linear=face.photo.linear,
        width_mm=width_mm,
        light=lit,
        choice=choice,
        grid=face.grid,
        crossings=face.crossings,
        fit=start,
        is_given=given is not None,
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
    best = keep(with_model_errors(fitter.improved(best.fit, apart=True, steps=2, tell=better), kinds))
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


def _seen(
    path: str | os.PathLike[str],
    width_mm: float,
    white: str | None,
    grey_card: str | None,
    given: tuple[str, Structure] | None,
) -> tuple[Seen, WeaveFit]:
    """A photograph and its threads, in as many pixels as these need, and the likeliest small weave."""
    require_file(path)
    photo = read_photo(path, width_mm, white=white, grey_card=grey_card)
    is_reduced = max(photo.full_size) > WORKING_SIDE
    try:
        found = likeliest_grid(photo, given)
    except InputError as error:
        if not is_reduced:
            raise InputError(f"{path}: {error}") from error
        found = None
    if found is None or (is_reduced and _finest(found[0]) < _FINE_PX):
        photo = read_photo(path, width_mm, white=white, grey_card=grey_card, side=FINE_SIDE)
        try:
            found = likeliest_grid(photo, given)
        except InputError as error:
            raise InputError(f"{path}: {error}") from error
    return found


def _finest(seen: Seen) -> float:
    """Pixels a thread of the finer family."""
    return 1 / max(seen.grid.warp.per_px, seen.grid.weft.per_px)


def _evenly_lit(seen: Seen, fit: WeaveFit) -> Seen:
    """The same without the falling off of its light."""
    up = fit.table(seen.crossings.shape)
    orders = colour_orders(seen.crossings, up)
    light = light_over(seen.photo.path, seen.photo.linear.shape[:2], seen.grid, seen.crossings, up, orders)
    even = replace(seen.photo, linear=(seen.photo.linear / light[..., None]).astype(np.float32))
    return Seen(even, seen.grid, find_crossings(even.encoded, seen.grid))


def _of_back(given: tuple[str, Structure] | None) -> tuple[str, Structure] | None:
    """The weave as it is seen from behind: left is right, and the other family is on top."""
    return None if given is None else (given[0], ~given[1][:, ::-1])


def _given_structure(weave: str | None, draft: str | os.PathLike[str] | None) -> tuple[str, Structure] | None:
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


# ------------------------------------------------------------------------------------------------------ yarns


def _kinds(fitter: YarnFitter, start: Fit, report: Report) -> list[Fit]:
    """Kinds of yarn in the photograph's colours, likest first."""
    found = []
    for number, kind in enumerate(KINDS):
        found.append(fitter.begun(kind, start.yarns.colours, steps=1))
        report(number + 1, len(KINDS))
    return sorted(found, key=lambda fit: fit.cost)
