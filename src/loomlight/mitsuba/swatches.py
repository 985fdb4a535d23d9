"""Cards of fabrics for a contact sheet: drawdown, swatch, drape and facts."""

from __future__ import annotations

import functools
import gc
import os
import re
import shutil
import time
import warnings
from collections.abc import Callable, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Unpack

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from loomlight.core.contact_sheet import Card, card_from_bytes, card_to_bytes, sheet_page, sheet_picture
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.files import PIXEL_SUFFIXES, discarding_empty, replacing
from loomlight.core.fleet import Executor, Outcome, Report, Shard, ShardFolder, work_map
from loomlight.core.images import encoded, write_pixels
from loomlight.core.outputs import check_output
from loomlight.core.picture_settings import Placement, SwatchKeywords, SwatchSettings
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.facts import cloth_facts, repeat_text, three_digits
from loomlight.mitsuba.plugins import material_bsdf
from loomlight.mitsuba.rendering import render
from loomlight.mitsuba.scenes import build_scene
from loomlight.mitsuba.variants import choose_variant
from loomlight.models.registry import make_model, require_model_name
from loomlight.sources.load import fabric_of_path, source_identity
from loomlight.weave.draft import Draft
from loomlight.weave.drawing import draw_drawdown

# Millimetres of cloth across a swatch, the same for all, so that they compare; the flat scene has 100.
SWATCH_MM, _FLAT_MM = 25.0, 100.0
# Threads across a drawdown: more cannot be told apart.
_MAX_THREADS = 48
# What is told of the cards so far takes a tenth of the time at most.
_LOOKS_APART = 9
Pixels = NDArray[np.uint8]


def swatches(
    fabrics: Sequence[str | os.PathLike[str]],
    output: str | os.PathLike[str],
    settings: SwatchSettings | None = None,
    *,
    executor: Executor | None = None,
    report: Report = lambda done, total: None,
    **changes: Unpack[SwatchKeywords],
) -> Path:
    """Writes a labelled contact sheet: of each fabric its drawdown, a swatch, a drape and facts.

    The sheet grows as fabrics are rendered; a file that cannot be used is left out with a warning. What is
    rendered is kept until the sheet is whole, so that the same call goes on where another ended.

    Args:
        fabrics: fabric files, drafts, `.loom` files or weaves' names.
        output: a .png or .jpg picture, or an .html page that needs no other file.
        settings: by default those of `SwatchSettings`.
        executor: who renders; this process by default.
        report: called with (fabrics done, fabrics in all).
        changes: settings by name, such as `size=160, spp=4`.

    Returns:
        The path of the sheet.

    Raises:
        InputError: none of the fabrics can be used, an unknown setting, or a path that cannot be written.
        LoomlightError: processes ended before all was done; what is done stays.
    """
    chosen, sheet = (settings or SwatchSettings()).changed(**changes), Path(output)
    names = [str(fabric) for fabric in fabrics]
    check_output(sheet, (*PIXEL_SUFFIXES, ".html"), names)
    require_model_name(chosen.model)
    chosen = chosen.changed(variant=choose_variant(chosen.variant))

    def write(cards: list[Card]) -> None:
        if sheet.suffix.lower() == ".html":
            with replacing(sheet) as temporary:
                temporary.write_text(sheet_page(cards, chosen.heading), encoding="utf-8")
        else:
            write_pixels(sheet, sheet_picture(cards))

    parts = work_folder_of(sheet)
    with discarding_empty(parts):
        write(fabric_cards(names, chosen, parts, executor, report, write))
    shutil.rmtree(parts, ignore_errors=True)
    return sheet


def work_folder_of(sheet: Path) -> Path:
    """Where cards are kept until the sheet is whole."""
    return sheet.with_name(f".loomlight-{sheet.name}.parts")


def fabric_cards(
    fabrics: Sequence[str],
    settings: SwatchSettings,
    folder: Path,
    executor: Executor | None = None,
    report: Report = lambda done, total: None,
    partial: Callable[[list[Card]], None] = lambda cards: None,
) -> list[Card]:
    """The cards of fabrics; one that cannot be used is left out with a warning.

    Args:
        fabrics: fabric files, drafts, `.loom` files or weaves' names.
        folder: keeps the cards.
        executor: who renders; this process by default.
        report: called with (fabrics done, fabrics in all).
        partial: called with the cards so far as they come; more seldom where it takes long.

    Raises:
        InputError: none can be used.
        LoomlightError: processes ended before all was done; what is done stays.
    """
    outcomes: dict[int, Outcome] = {}
    of_card = {name: value for name, value in asdict(settings).items() if name != "heading"}
    items: list[tuple[Shard, str]] = []
    numbers: list[int] = []
    for number, fabric in enumerate(fabrics):
        try:
            identity = source_identity(fabric_of_path(fabric), of_card)
        except InputError as error:
            outcomes[number] = Outcome(fault=str(error))
            continue
        name = re.sub(r"[^\w.+]+", "-", Path(fabric).name)[:100]
        items.append((Shard(f"{number:05d}-{name}", identity), fabric))
        numbers.append(number)
    shared, next_look = ShardFolder(folder, ""), 0.0

    def tell(done: int, total: int) -> None:
        nonlocal next_look
        report(done, total)
        begun = time.monotonic()
        if done in (0, total) or begun < next_look:
            return
        found = [shared.outcome(shard) for shard, _ in items]
        ready = [card_from_bytes(each.content) for each in found if each is not None and each.succeeded]
        if ready:
            partial(ready)
        next_look = time.monotonic() + _LOOKS_APART * (time.monotonic() - begun)

    results = work_map(functools.partial(_card, settings), items, folder, executor, tell)
    outcomes |= zip(numbers, results, strict=True)
    cards = []
    for number in range(len(fabrics)):
        outcome = outcomes[number]
        if outcome.fault is None:
            cards.append(card_from_bytes(outcome.content))
        elif len(fabrics) == 1:
            raise InputError(outcome.fault)
        else:
            warnings.warn(f"{outcome.fault} It is left out.", LoomlightWarning, stacklevel=2)
    if not cards:
        raise InputError(f"None of the {len(fabrics)} fabrics can be used.")
    return cards


def _card(settings: SwatchSettings, path: str) -> bytes:
    """The card of a fabric file, a draft, a `.loom` or a weave's name.

    Raises:
        InputError: no fabric, or one that the model cannot handle.
    """
    choose_variant(settings.variant)
    fabric = fabric_of_path(path)
    made, side = make_model(settings.model, fabric), settings.size

    def picture(scene: str, placement: Placement, view: str | tuple[float, float] | None = None) -> Pixels:
        # A kernel holds all living BSDFs: with those of the last picture it would be another one.
        gc.collect()
        shown = build_scene(
            scene, material_bsdf(made), size=(side, side), placement=placement, edge=None, view=view
        )
        linear = render(
            shown.scene,
            spp=settings.spp,
            integrator=shown.integrator,
            white_balance=settings.white_balance,
            denoise=settings.denoise,
        )
        return encoded(linear)

    pictures = {
        "drawdown": _drawdown(fabric.draft, side),
        f"{SWATCH_MM:g} mm of it": picture("flat", Placement(scale=_FLAT_MM / SWATCH_MM)),
        "draped": picture("drape", Placement(), settings.view),
    }
    return card_to_bytes(Card(fabric.name, fact_lines(fabric), pictures))


def fact_lines(fabric: Fabric) -> list[str]:
    """Text of a card: structure, sett, cover, weight."""
    facts = cloth_facts(fabric)
    weave = fabric.fields.weave or fabric.named_draft.title or "draft"
    about = "about" if facts.counted else "at most"
    return [
        f"{weave}; {repeat_text(fabric)}",
        f"{facts.warp.per_cm:.3g} ends/cm of {three_digits(facts.warp.tex)} tex, "
        f"{facts.weft.per_cm:.3g} picks/cm of {three_digits(facts.weft.tex)} tex",
        f"covers {100 * facts.cover:.0f} %, {about} {facts.weight:.0f} g/m², "
        f"{facts.thickness_mm:.2g} mm thick",
    ]


def _drawdown(draft: Draft, side: int) -> Pixels:
    """The drawdown, repeated until it fills the square, or the first part of a large one."""
    threads = min(max(draft.ends, draft.picks, 12), _MAX_THREADS)
    repeats = -(-threads // min(draft.ends, draft.picks))
    cell = max(side // threads, 1)
    drawn = draw_drawdown(draft, cell_px=cell, repeats=min(repeats, _MAX_THREADS))
    shown = drawn[-threads * cell :, : threads * cell]
    return np.asarray(Image.fromarray(shown).resize((side, side), Image.Resampling.LANCZOS))
