"""Content of a WIF file beyond the draft, kept so that a file that is written again loses nothing."""

from __future__ import annotations

from dataclasses import dataclass, field

# A section's lines in their order: key and value; None where the line had no "=".
Entries = tuple[tuple[str, str | None], ...]


@dataclass(frozen=True)
class FamilyDefaults:
    """Values of [WARP] or [WEFT] for all of its threads.

    Attributes:
        threads: the number of threads that is declared; None if none is.
        unit: name of the unit of lengths as the file spells it; "" if the file does not say.
        color_index: 0-based row of the palette; None without a default colour.
        spacing_mm: default spacing, millimetres.
        thickness_mm: default thickness, millimetres.
    """

    threads: int | None = None
    unit: str = ""
    color_index: int | None = None
    spacing_mm: float | None = None
    thickness_mm: float | None = None


@dataclass(frozen=True)
class WifSource:
    """The rest of a WIF file.

    Attributes:
        warp: the defaults of [WARP].
        weft: the defaults of [WEFT].
        color_range: the lowest and highest component in the file's colour table.
        entries: by section in capitals, the keys of known sections that say nothing about the cloth
            ("SOURCE PROGRAM" of [WIF], "AUTHOR" of [TEXT]).
        sections: private and unknown sections, name and lines, in file order.
    """

    warp: FamilyDefaults = field(default_factory=FamilyDefaults)
    weft: FamilyDefaults = field(default_factory=FamilyDefaults)
    color_range: tuple[int, int] = (0, 255)
    entries: tuple[tuple[str, Entries], ...] = ()
    sections: tuple[tuple[str, Entries], ...] = ()
