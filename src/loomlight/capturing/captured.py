"""What was captured of a cloth: its fabric, how well each field is known, and the file that says so."""

from __future__ import annotations

import os
import warnings
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.capturing.aligned import aligned_picture
from loomlight.capturing.crossings import Crossings
from loomlight.capturing.lighting import patchiness
from loomlight.capturing.photographer import Light, Linear
from loomlight.capturing.sheet import capture_sheet
from loomlight.capturing.thread_colours import ColourOrder
from loomlight.capturing.thread_grid import ThreadGrid
from loomlight.capturing.weave_match import WeaveFit
from loomlight.capturing.yarn_fit import FAMILIES, NINE_OF_TEN, PARAMETERS, Fit
from loomlight.core.colour import to_hex
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.core.files import replacing_all
from loomlight.fabric.fabric import Fabric, make_fabric
from loomlight.fabric.read import fabric_from_fields, validate_fields
from loomlight.fabric.write import fabric_toml
from loomlight.weave.draft import Draft
from loomlight.weave.wif_writer import write_wif

FABRIC_SUFFIX = ".toml"
# Of the spread of a kind of yarn: an error above it says that the photograph adds nothing.
_UNKNOWN = 0.8
_OF_THE_KIND = "of the kind of yarn; the photograph does not fix it"
_DIGITS = 3
# A weave that is less sure than this, and a repeat that differs by more of 255, are told of.
SURE, GOOD_ROOT = 0.8, 10.0
# Brightest over darkest part of the picture from which on a shadow or a label is told of.
_PATCHY = 1.6
# Pixels of a thread from which on weaves are told apart well.
GOOD_PX = 10.0


@dataclass(frozen=True)
class Estimate:
    """A number and its standard error, in the unit of its field."""

    value: float
    error: float

    @property
    def reach(self) -> float:
        """How far to either side the truth may be in 9 of 10 photographs."""
        return NINE_OF_TEN * self.error


@dataclass(frozen=True, eq=False)
class WeaveChoice:
    """The weave with its colours.

    Attributes:
        fit: structure and place.
        confidence: how often a weave that looks so sure is right, 0 to 1.
        warp, weft: colours in order.
        rivals: names of others that are not much less likely, likeliest first.
    """

    fit: WeaveFit
    confidence: float
    warp: ColourOrder
    weft: ColourOrder
    rivals: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Captured:
    """A captured cloth.

    Attributes:
        photo: path of the photograph.
        linear: its linear RGB [height, width, 3], as it was worked on.
        width_mm: of cloth that it is wide.
        light: of the photograph.
        choice: the weave and the order of colours.
        grid, crossings: where threads lie in the photograph, and what their crossings show.
        fit: of the yarns.
        is_given: whether the user said which weave it is.
        draft_file: that the user gave.
    """

    photo: str
    linear: NDArray[np.float32]
    width_mm: float
    light: Light
    choice: WeaveChoice
    grid: ThreadGrid
    crossings: Crossings
    fit: Fit
    is_given: bool = False
    draft_file: str | None = None
    _renders: dict[int, Linear] = field(default_factory=dict, init=False, repr=False)

    @property
    def setts(self) -> tuple[Estimate, Estimate]:
        """Threads a centimetre of warp and weft."""
        per_cm = 10 * self.linear.shape[1] / self.width_mm
        warp, weft = (
            Estimate(per_cm * family.per_px, per_cm * family.per_px * family.error)
            for family in (self.grid.warp, self.grid.weft)
        )
        return warp, weft

    @property
    def weave(self) -> str:
        """The name of the weave; "" of one without."""
        return self.choice.fit.name

    @property
    def draft(self) -> Draft:
        """One repeat of the weave, without colours."""
        return Draft(self.choice.fit.structure, title=self.weave or "captured")

    def fabric(self, folder: str | os.PathLike[str] = ".") -> Fabric:
        """The fabric; paths in it are relative to `folder`."""
        fields = validate_fields(self._fields(folder, None))
        if self.weave or self.draft_file is not None:
            return fabric_from_fields(fields.model_dump(exclude_none=True), folder)
        return make_fabric(fields, self.draft, str(fields.name), str(folder))

    def toml(self, folder: str | os.PathLike[str] = ".", draft: str | None = None) -> str:
        """The fabric file's text, with what is known of each field beside it.

        Args:
            draft: name of the file of a weave without a name.
        """
        text = fabric_toml(validate_fields(self._fields(folder, draft)), str(folder), str(folder))
        return _commented(text, self._notes(), self._head())

    def save(self, output: str | os.PathLike[str]) -> Path:
        """Writes the fabric file, and beside it the draft of a weave without a name.

        Raises:
            InputError: another suffix than .toml, or a path that cannot be written.
        """
        path = Path(output)
        if path.suffix.lower() != FABRIC_SUFFIX:
            raise InputError(f"{path} has no suffix that says what to write: it must end in {FABRIC_SUFFIX}.")
        if self.weave or self.draft_file is not None:
            with replacing_all([path]) as (temporary,):
                temporary.write_text(self.toml(path.parent), encoding="utf-8")
            return path
        wif = path.with_suffix(".wif")
        with replacing_all([wif, path]) as (draft, temporary):
            write_wif(self.draft, draft)
            temporary.write_text(self.toml(path.parent, wif.name), encoding="utf-8")
        return path

    def files(self, output: str | os.PathLike[str]) -> list[Path]:
        """The files that `save` writes."""
        path = Path(output)
        return [path] if self.weave or self.draft_file is not None else [path, path.with_suffix(".wif")]

    def render(self, samples: int = 4) -> Linear:
        """The cloth in the light of the photograph, its threads laid as there, linear RGB of its size."""
        if samples not in self._renders:
            self._renders[samples] = aligned_picture(
                self.linear,
                self.width_mm,
                self.grid,
                self.crossings,
                self.choice.fit,
                (self.choice.warp, self.choice.weft),
                self.fit.yarns,
                self.light,
                samples,
            )
        return self._renders[samples]

    def sheet(self) -> NDArray[np.uint8]:
        """Photograph, render in the same light, difference and draft, 8-bit sRGB [height, width, 3]."""
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", LoomlightWarning)
            draft = self.fabric().draft
        lines = [self.summary, *(f"Doubtful: {sentence}" for sentence in self.doubts)]
        return capture_sheet(self.linear, self.render(), draft, lines)

    @property
    def summary(self) -> str:
        """Weave, setts and kind of yarn in a line."""
        warp, weft = self.setts
        weave = self.weave or (self.draft_file and f"the weave of {self.draft_file}")
        sure = "as given" if self.is_given else f"{100 * self.choice.confidence:.0f} % sure"
        return (
            f"{weave or 'a weave without a name'}, {sure}; "
            f"{warp.value:.1f} ends and {weft.value:.1f} picks/cm; yarn like {self.fit.yarns.kind}"
        )

    @property
    def doubts(self) -> list[str]:
        """Sentences on what cannot be relied on; none where all can."""
        found = []
        if self.choice.confidence < SURE:
            found.append(self._guess())
        up = self.choice.fit.table(self.crossings.shape)
        uneven = patchiness(self.crossings, up, (self.choice.warp, self.choice.weft))
        if uneven > _PATCHY:
            found.append(
                f"some of the picture is {uneven:.1f} times as bright as the rest, as if a shadow, a fold or "
                "a label lay on it: crop that away, or light all of the cloth alike."
            )
        left = 255 * float(np.sqrt(self.fit.cost))
        if left > GOOD_ROOT:
            found.append(
                f"the render differs from the photograph by {left:.0f} of 255, root mean square: look at the "
                "sheet before you use the fabric."
            )
        return found

    def _guess(self) -> str:
        """That the weave is one, which others look like it, and what to do; of a given one its poor fit."""
        if self.is_given:
            return (
                f"{self.weave or self.draft_file} explains the picture poorly: see on the sheet whether "
                "it is that weave, and whether its warp runs up the picture."
            )
        named = " or ".join(self.choice.rivals)
        rivals = f", and {named} looks nearly the same" if named else ""
        pixels = 1 / max(self.grid.warp.per_px, self.grid.weft.per_px)
        nearer = (
            f" Move nearer: a thread has {pixels:.0f} pixels here, and {GOOD_PX:g} tell weaves apart."
            if pixels < GOOD_PX
            else ""
        )
        return (
            f"the weave {self.weave or 'in the draft'} is a guess, {100 * self.choice.confidence:.0f} % sure"
            f"{rivals}: check the draft, and give --weave or --draft if you know it.{nearer}"
        )

    @property
    def unfixed(self) -> list[str]:
        """Fields that the photograph does not fix, so that they are of the kind of yarn: "warp.roughness"."""
        return [
            f"{family}.{name}"
            for (family, name), note in self._notes().items()
            if note.endswith(_OF_THE_KIND)
        ]

    # ------------------------------------------------------------------------------------------------- fields

    def _fields(self, folder: str | os.PathLike[str], draft: str | None) -> dict[str, Any]:
        yarns = self.fit.yarns
        values: dict[str, Any] = {"name": Path(self.photo).stem}
        if self.weave:
            values["weave"] = self.weave
        elif self.draft_file is not None:
            values["draft"] = os.path.relpath(self.draft_file, folder).replace(os.sep, "/")
        elif draft is not None:
            values["draft"] = draft
        else:
            values["weave"] = "plain"
        values["ends_per_cm"], values["picks_per_cm"] = (_short(sett.value) for sett in self.setts)
        values["yarn"] = yarns.kind
        orders = self.choice.warp, self.choice.weft
        for number, family in enumerate(FAMILIES):
            numbers = {name: yarns.numbers[name][number] for name in PARAMETERS}
            fill = numbers.pop("fill")
            values[family] = {
                "color": _colours(orders[number], yarns.colours[number], self._start(number)),
                "gap": _short(max(1 - fill, 0.0)),
                **{name: _short(value) for name, value in numbers.items()},
            }
        return values

    def _start(self, family: int) -> int:
        """Which thread of the table of crossings is the first of a repeat of the weave."""
        count = self.choice.fit.structure.shape[1 - family]
        return -self.choice.fit.shift[1 - family] % count

    def _head(self) -> list[str]:
        lines = [
            f"Captured from {Path(self.photo).name}, {self.width_mm:g} mm wide, lit by a {self.light.kind}.",
        ]
        if self.is_given:
            lines.append("The weave was given.")
        elif self.weave:
            lines.append(
                f"The weave is {self.weave} with a confidence of {100 * self.choice.confidence:.0f} %."
            )
        lines.append(
            f"The mean repeat of the render differs from the photograph's by "
            f"{255 * np.sqrt(self.fit.cost):.1f} of 255, root mean square."
        )
        lines.append("Bounds beside numbers and colours hold in about 9 of 10 photographs of known cloths.")
        lines.append(
            "Twist, plies, hairs, unevenness, translucency and sheen are of the kind of yarn or defaults: "
            "one photograph from above does not fix them."
        )
        return lines

    def _notes(self) -> dict[tuple[str, str], str]:
        """What is known of fields, by table and name."""
        notes = {
            ("", "ends_per_cm"): f"± {self.setts[0].reach:.2g}",
            ("", "picks_per_cm"): f"± {self.setts[1].reach:.2g}",
            ("", "yarn"): "the likest in this light; others may look the same",
        }
        for number, family in enumerate(FAMILIES):
            notes[family, "color"] = f"within {self.fit.colour_error:.1f} of CIEDE2000"
            for name, errors in self.fit.errors.items():
                low, high = self.fit.bounds(name, number)
                if name == "fill":
                    notes[family, "gap"] = f"{1 - high:.2g} to {1 - low:.2g}"
                elif errors[number] > _UNKNOWN * PARAMETERS[name].spread:
                    notes[family, name] = f"{low:.2g} to {high:.2g}, {_OF_THE_KIND}"
                else:
                    notes[family, name] = f"{low:.2g} to {high:.2g}"
        return notes


def _short(value: float) -> float:
    return float(f"{value:.{_DIGITS + 1}g}")


def _colours(order: ColourOrder, colours: NDArray[np.float64], start: int) -> str | list[str]:
    """Colours of threads from the first of a repeat of the weave on, in runs."""
    texts = [to_hex(colour) for colour in colours]
    if len(set(texts)) == 1:
        return texts[0]
    count = len(order.order)
    first = (order.first + start) % count if order.repeats else 0
    listed = [texts[order.order[(first + number) % count]] for number in range(count)]
    runs: list[tuple[int, str]] = []
    for text in listed:
        if runs and runs[-1][1] == text:
            runs[-1] = (runs[-1][0] + 1, text)
        else:
            runs.append((1, text))
    return ", ".join(f"{number} {text}" for number, text in runs)


def _commented(text: str, notes: dict[tuple[str, str], str], head: list[str]) -> str:
    lines = [f"# {line}" for line in head]
    table = ""
    for line in text.splitlines():
        if line.startswith("["):
            table = line.strip("[]")
        name = line.partition(" = ")[0]
        note = notes.get((table, name))
        lines.append(line if note is None else f"{line}  # {note}")
    return "\n".join(lines) + "\n"
