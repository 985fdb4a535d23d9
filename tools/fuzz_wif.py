"""Feeds mutilated weaving information files to the reader: each must be read, or refused in a sentence.

    python -m tools.fuzz_wif [--count 10000] [--seed 0] [--folder FOLDER …] [--output FILE.json]

Each original is there twice: as it is, and without the line [WIF], as some programs write it. A run fails on
an error other than InputError, on a message of more than one line, on a draft that does not survive being
written and read again, and on more than two CPU seconds. What failed is printed with its seed and text;
`--seed N --count 1` repeats it.
"""

from __future__ import annotations

import argparse
import random
import re
import sys
import time
import traceback
import warnings
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from benchmarks.harness import Figures, record
from loomlight.core.errors import InputError, LoomlightWarning
from loomlight.evaluation.table import write_json
from loomlight.weave import Draft
from loomlight.weave.wif_reader import draft_of
from loomlight.weave.wif_text import decode_wif, parse_wif_text
from loomlight.weave.wif_writer import wif_text_of

FIXTURES = Path(__file__).resolve().parents[1] / "tests" / "weave" / "fixtures"
SLOWEST_S = 2.0
# Larger files would only repeat in more time what smaller ones show.
MAX_BYTES = 30_000

_NASTY = (
    "", "0", "-1", "1", "16384", "16385", "99999999999999999999", "1e999", "-1e999", "nan", "inf", "1e-300",
    "0x10", "1.5", ",", ",,,", "1,", "1,2,3,4,5", "0,0", "255,0", "true", "maybe", "=", "[", "]", "[WIF]",
    "[THREADING]", ";", "#", "\x00", "\ufeff", "٣", "１", "²", "Ⅷ", "%(x)s", "${HOME}", "1" * 5000, " ", "\t",
)  # fmt: skip
_SECTIONS = (
    "WIF", "CONTENTS", "TEXT", "NOTES", "WEAVING", "WARP", "WEFT", "THREADING", "TIEUP", "TREADLING",
    "LIFTPLAN", "COLOR TABLE", "COLOR PALETTE", "WARP COLORS", "WEFT SPACING", "PRIVATE X", "", "NO SUCH",
)  # fmt: skip
_HEADER = re.compile(r"\[wif\]", re.IGNORECASE)

Mutation = Callable[[random.Random, bytes], bytes]


def _flip_bytes(chance: random.Random, content: bytes) -> bytes:
    mutable = bytearray(content)
    for _ in range(chance.randint(1, 8)):
        if mutable:
            mutable[chance.randrange(len(mutable))] = chance.randrange(256)
    return bytes(mutable)


def _cut(chance: random.Random, content: bytes) -> bytes:
    start, end = sorted(chance.randrange(len(content) + 1) for _ in range(2))
    return content[:start] + content[end:] if chance.random() < 0.5 else content[:end]


def _insert(chance: random.Random, content: bytes) -> bytes:
    at = chance.randrange(len(content) + 1)
    return content[:at] + chance.choice(_NASTY).encode() + content[at:]


def _lines(change: Callable[[random.Random, list[bytes]], None]) -> Mutation:
    def mutate(chance: random.Random, content: bytes) -> bytes:
        lines = content.split(b"\n")
        change(chance, lines)
        return b"\n".join(lines)

    return mutate


def _drop_line(chance: random.Random, lines: list[bytes]) -> None:
    del lines[chance.randrange(len(lines))]


def _repeat_line(chance: random.Random, lines: list[bytes]) -> None:
    lines.insert(chance.randrange(len(lines) + 1), chance.choice(lines))


def _swap_lines(chance: random.Random, lines: list[bytes]) -> None:
    first, second = chance.randrange(len(lines)), chance.randrange(len(lines))
    lines[first], lines[second] = lines[second], lines[first]


def _change_value(chance: random.Random, lines: list[bytes]) -> None:
    at = chance.randrange(len(lines))
    key, equals, _ = lines[at].partition(b"=")
    if equals:
        lines[at] = key + b"=" + chance.choice(_NASTY).encode()


def _change_key(chance: random.Random, lines: list[bytes]) -> None:
    at = chance.randrange(len(lines))
    _, equals, value = lines[at].partition(b"=")
    if equals:
        lines[at] = chance.choice(_NASTY).encode() + b"=" + value


def _change_number(chance: random.Random, lines: list[bytes]) -> None:
    at = chance.randrange(len(lines))
    key, equals, value = lines[at].partition(b"=")
    if equals and value.strip().isdigit() and len(value) < 20:
        lines[at] = key + b"=" + str(int(value) + chance.choice((-1, 1, 100, -100, 10**6))).encode()


def _rename_section(chance: random.Random, lines: list[bytes]) -> None:
    headers = [at for at, line in enumerate(lines) if line.startswith(b"[")]
    if headers:
        lines[chance.choice(headers)] = b"[" + chance.choice(_SECTIONS).encode() + b"]"


def _sections(change: Callable[[random.Random, list[bytes]], None]) -> Mutation:
    def mutate(chance: random.Random, content: bytes) -> bytes:
        parts = content.split(b"\n[")
        change(chance, parts)
        return b"\n[".join(parts)

    return mutate


MUTATIONS: tuple[Mutation, ...] = (
    _flip_bytes,
    _cut,
    _insert,
    *map(_lines, (_drop_line, _repeat_line, _swap_lines, _change_value, _change_key, _change_number)),
    *map(_lines, (_change_value, _change_number, _rename_section)),
    *map(_sections, (_drop_line, _repeat_line, _swap_lines)),
)


def mutated(seed: int, originals: list[bytes]) -> bytes:
    """The file of a seed: one of `originals` after one to six mutations."""
    chance = random.Random(seed)
    content = chance.choice(originals)
    for _ in range(chance.choice((1, 1, 1, 2, 3, 6))):
        content = chance.choice(MUTATIONS)(chance, content)
    return content


def _read(content: bytes) -> Draft:
    return draft_of(parse_wif_text(decode_wif(content), "file.wif"))


def _same(first: Draft, second: Draft) -> bool:
    if not np.array_equal(first.drawdown, second.drawdown) or first.notes != second.notes:
        return False
    if first.title != second.title:
        return False
    for one, other in ((first.warp, second.warp), (first.weft, second.weft)):
        for name in ("colors", "spacing_mm", "thickness_mm"):
            a, b = getattr(one, name), getattr(other, name)
            if (a is None) != (b is None) or (a is not None and not np.allclose(a, b, rtol=1e-12, atol=1e-9)):
                return False
    return True


@dataclass(frozen=True)
class Outcome:
    """How the reader takes a file.

    Attributes:
        kind: "read", "read with warnings", "refused" or "fault".
        seconds: CPU seconds to read it, and to write and read it again.
        fault: what is wrong; None if nothing is.
    """

    kind: str
    seconds: float
    fault: str | None = None


def outcome_of(content: bytes) -> Outcome:
    """How the reader takes `content`."""
    fault = None
    start = time.process_time()
    try:
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            draft = _read(content)
            warned = any(issubclass(warning.category, LoomlightWarning) for warning in caught)
            again = _read(wif_text_of(draft).encode("utf-8", errors="replace"))
        kind = "read with warnings" if warned else "read"
        if not _same(draft, again):
            fault = "the draft changed when it was written and read again"
    except InputError as error:
        kind = "refused"
        fault = f"a message of several lines: {error}" if "\n" in str(error) else None
    except Exception:  # whatever it is, a traceback is what the fuzzer looks for
        fault = traceback.format_exc()
    seconds = time.process_time() - start
    if fault is None and seconds > SLOWEST_S:
        fault = f"took {seconds:.1f} s"
    return Outcome("fault" if fault is not None else kind, seconds, fault)


def fault_of(content: bytes) -> str | None:
    """What is wrong with how the reader takes `content`; None if nothing is."""
    return outcome_of(content).fault


def originals_in(*folders: Path) -> list[bytes]:
    """All weaving information files below the folders that are small enough, each also without [WIF]."""
    files = sorted(file for folder in folders for file in folder.rglob("*.wif"))
    whole = [content for content in (file.read_bytes() for file in files) if len(content) <= MAX_BYTES]
    return [*whole, *(_HEADER.sub("", decode_wif(content), count=1).encode() for content in whole)]


def fuzz(originals: Sequence[bytes], seeds: Sequence[int]) -> Figures:
    """Outcomes of the files of some seeds; prints faults."""
    kinds: Counter[str] = Counter()
    slowest = 0.0
    for seed in seeds:
        content = mutated(seed, list(originals))
        outcome = outcome_of(content)
        kinds[outcome.kind] += 1
        slowest = max(slowest, outcome.seconds)
        if outcome.fault is not None:
            print(f"--- seed {seed}: {outcome.fault}\n{content[:4000]!r}\n", flush=True)
    return {
        "files": len(seeds),
        "originals": len(originals),
        "originals_without_header": len(originals) // 2,
        "outcomes": dict(sorted(kinds.items())),
        "slowest_cpu_seconds": round(slowest, 3),
        "bar_cpu_seconds": SLOWEST_S,
        "missed": ["faults"] if kinds["fault"] else [],
    }


def main() -> int:
    """Runs the fuzzer; returns the exit status."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--count", type=int, default=10_000, help="how many files (default: 10000)")
    parser.add_argument("--seed", type=int, default=0, help="seed of the first (default: 0)")
    parser.add_argument(
        "--folder", type=Path, nargs="+", default=[FIXTURES], help="where the files to mutilate lie"
    )
    parser.add_argument("--output", type=Path, default=None, help="a JSON file for the record")
    options = parser.parse_args()
    originals = originals_in(*options.folder)
    if not originals:
        print(f"{' and '.join(map(str, options.folder))}: no .wif file", file=sys.stderr)
        return 2
    figures = fuzz(originals, range(options.seed, options.seed + options.count))
    print(f"{figures['files']} files from {figures['originals']} originals: {figures['outcomes']}")
    if options.output is not None:
        write_json(options.output, record(figures))
    return 1 if figures["missed"] else 0


if __name__ == "__main__":
    sys.exit(main())
