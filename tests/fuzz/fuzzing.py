"""The common part of all fuzzers: mutations, a limited child process and the command line.

A fuzzer makes `Target`s and ends with `main`:

    python -m tests.fuzz.meshes [--seconds 60] [--count 2000] [--seed 0] [--only NAME] [--faults FOLDER]

Each file must be read, or refused by an InputError of one short line. Anything else is a fault: another
exception, a raw warning, a long message, an ended process, too long a time and too much memory.
`--seed N --count 1 --only NAME` repeats a file; `--faults` keeps each faulty one.
"""

from __future__ import annotations

import argparse
import json
import multiprocessing
import random
import re
import resource
import struct
import sys
import time
import traceback
import warnings
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from itertools import count as counting
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

from loomlight.core.errors import InputError, LoomlightWarning

Mutation = Callable[[random.Random, bytes], bytes]

MAX_MESSAGE = 600
NASTY_TEXTS = (
    "", "0", "-1", "1", "16385", "99999999999999999999", "1e999", "-1e999", "nan", "inf", "1e-300", "0x10",
    "1.5", ",", ",,,", "1,", "true", "maybe", "=", "[", "]", "{", ";", "#", "\\", "/", "//", "\x00", "\ufeff",
    "٣", "１", "²", "Ⅷ", "%(x)s", "${HOME}", "1" * 5000, "x" * 100_000, " ", "\t", "\r", "\x1a", '"',
)  # fmt: skip
NASTY_VALUES: tuple[Any, ...] = (
    None, True, False, 0, 1, -1, 2, 1.5, -0.5, 1e308, float("nan"), float("inf"), 2**31 - 1, 2**31, 2**32,
    2**63, 10**30, 400_000_000, "", "x", "x" * 100_000, [], [0], [0] * 20, {}, {"": 0}, [[]], [None], "../x",
    "data:,", "\n",
)  # fmt: skip
_NASTY_BINARY = (
    *(struct.pack("<I", value) for value in (0, 1, 2**16, 2**31 - 1, 2**31, 2**32 - 1)),
    *(struct.pack(">I", value) for value in (1, 2**16, 2**31)),
    *(struct.pack("<f", value) for value in (float("nan"), float("inf"), 1e38, 1e-42, -1.0)),
    *(struct.pack("<Q", value) for value in (2**32, 2**63, 2**64 - 1)),
)
_NUMBER = re.compile(rb"-?\d+(?:\.\d*)?(?:[eE][-+]?\d+)?")


def flip_bytes(chance: random.Random, content: bytes) -> bytes:
    """Up to eight bytes replaced."""
    mutable = bytearray(content)
    for _ in range(chance.randint(1, 8)):
        if mutable:
            mutable[chance.randrange(len(mutable))] = chance.randrange(256)
    return bytes(mutable)


def cut(chance: random.Random, content: bytes) -> bytes:
    """The end, or a part in the middle, left out."""
    start, end = sorted(chance.randrange(len(content) + 1) for _ in range(2))
    return content[:start] + content[end:] if chance.random() < 0.5 else content[:end]


def insert_text(chance: random.Random, content: bytes) -> bytes:
    """A nasty text anywhere."""
    at = chance.randrange(len(content) + 1)
    return content[:at] + chance.choice(NASTY_TEXTS).encode() + content[at:]


def overwrite_number(chance: random.Random, content: bytes) -> bytes:
    """A nasty binary number over the bytes of a multiple of two or four."""
    value = chance.choice(_NASTY_BINARY)
    at = chance.randrange(len(content) + 1) // chance.choice((1, 2, 4)) * chance.choice((1, 2, 4))
    return content[:at] + value + content[at + len(value) :]


def replace_number(chance: random.Random, content: bytes) -> bytes:
    """One number of a text replaced by a nasty text, or by a number near it."""
    found = list(_NUMBER.finditer(content))
    if not found:
        return content
    number = chance.choice(found)
    if chance.random() < 0.5 and number[0].isdigit() and len(number[0]) < 18:
        text = str(int(number[0]) + chance.choice((-1, 1, 100, -100, 10**6))).encode()
    else:
        text = chance.choice(NASTY_TEXTS).encode()
    return content[: number.start()] + text + content[number.end() :]


def on_pieces(change: Callable[[random.Random, list[bytes]], None], separator: bytes = b"\n") -> Mutation:
    """A mutation of the pieces (lines, sections) that `separator` parts."""

    def mutate(chance: random.Random, content: bytes) -> bytes:
        pieces = content.split(separator)
        change(chance, pieces)
        return separator.join(pieces)

    return mutate


def drop(chance: random.Random, pieces: list[bytes]) -> None:
    """One piece left out."""
    del pieces[chance.randrange(len(pieces))]


def repeat(chance: random.Random, pieces: list[bytes]) -> None:
    """One piece a second time, anywhere."""
    pieces.insert(chance.randrange(len(pieces) + 1), chance.choice(pieces))


def swap(chance: random.Random, pieces: list[bytes]) -> None:
    """Two pieces exchanged."""
    first, second = chance.randrange(len(pieces)), chance.randrange(len(pieces))
    pieces[first], pieces[second] = pieces[second], pieces[first]


def change_json(chance: random.Random, content: bytes) -> bytes:
    """One value anywhere in a JSON document replaced, left out or repeated; other content is kept."""
    try:
        tree = json.loads(content)
    except ValueError:
        return content
    places = list(_places(tree)) if isinstance(tree, dict | list) else []
    if not places:
        return content
    holder, key = chance.choice(places)
    act = chance.random()
    if act < 0.15:
        del holder[key]
    elif act < 0.25 and isinstance(holder, list):
        holder.insert(key, holder[key])
    elif act < 0.4 and isinstance(holder[key], int):
        holder[key] += chance.choice((-1, 1, 3, 100, -100, 10**6))
    else:
        holder[key] = chance.choice(NASTY_VALUES)
    return json.dumps(tree).encode()


def _places(tree: Any) -> Iterable[tuple[Any, Any]]:
    """Every container of a JSON document with each of its keys."""
    for key, value in list(tree.items() if isinstance(tree, dict) else enumerate(tree)):
        yield tree, key
        if isinstance(value, dict | list):
            yield from _places(value)


BYTES: tuple[Mutation, ...] = (flip_bytes, cut, insert_text, overwrite_number)
TEXT: tuple[Mutation, ...] = (
    flip_bytes, cut, insert_text, replace_number, replace_number, *map(on_pieces, (drop, repeat, swap)),
)  # fmt: skip


@dataclass(frozen=True, eq=False)
class Target:
    """What one fuzzer feeds.

    Attributes:
        name: a format or an entry.
        originals: files that are read.
        mutations: repeat one to have it chosen more often.
        subject: reads a file; raises InputError where it refuses it.
        max_seconds: of CPU time that a file may take; a child is ended at ten times as many of wall time.
        max_mb: of memory beyond what the process holds before its first file.
    """

    name: str
    originals: Sequence[bytes]
    mutations: Sequence[Mutation]
    subject: Callable[[bytes], None]
    max_seconds: float = 2.0
    max_mb: int = 900

    def mutated(self, seed: int) -> bytes:
        """The file of a seed: an original after one to six mutations."""
        chance = random.Random(seed)
        content = chance.choice(self.originals)
        for _ in range(chance.choice((1, 1, 1, 2, 3, 6))):
            content = chance.choice(self.mutations)(chance, content)
        return content


@dataclass(frozen=True)
class Outcome:
    """How the subject takes a file.

    Attributes:
        kind: "read", "read with warnings", "refused" or "fault".
        seconds: of CPU time.
        message: the refusal, or what is wrong.
    """

    kind: str
    seconds: float = 0.0
    message: str = ""


def outcome_of(subject: Callable[[bytes], None], content: bytes, max_seconds: float = 2.0) -> Outcome:
    """How `subject` takes `content`, in this process."""
    start = time.process_time()
    kind, messages = "read", []
    try:
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            subject(content)
    except InputError as error:
        kind, messages = "refused", [str(error)]
    except Exception:  # whatever it is, a traceback is what the fuzzer looks for
        return Outcome("fault", time.process_time() - start, traceback.format_exc())
    seconds = time.process_time() - start
    for warning in caught:
        if not issubclass(warning.category, LoomlightWarning):
            return Outcome("fault", seconds, f"a raw warning: {warning.message} ({warning.filename})")
        messages.append(str(warning.message))
        kind = "read with warnings" if kind == "read" else kind
    for message in messages:
        if "\n" in message or len(message) > MAX_MESSAGE:
            return Outcome("fault", seconds, f"a message of {len(message)} characters: {message[:1000]!r}")
    if seconds > max_seconds:
        return Outcome("fault", seconds, f"took {seconds:.1f} s")
    return Outcome(kind, seconds, " ".join(messages))


@dataclass(eq=False)
class Child:
    """A forked process that takes files one after the other; begun anew when one ends it.

    Attributes:
        peak_mb: the largest resident memory of any child so far.
    """

    target: Target
    peak_mb: float = 0.0
    _process: Any = field(default=None, init=False)
    _pipe: Connection | None = field(default=None, init=False)

    def take(self, content: bytes) -> Outcome:
        """How the target's subject takes `content`, within its limits."""
        if self._pipe is None:
            context = multiprocessing.get_context("fork")
            self._pipe, other = context.Pipe()
            self._process = context.Process(target=_serve, args=(other, self.target), daemon=True)
            self._process.start()
            other.close()
        seconds = 10 * self.target.max_seconds
        try:
            self._pipe.send_bytes(content)
            if not self._pipe.poll(seconds):
                self.close()
                return Outcome("fault", seconds, f"not done after {seconds:.0f} s")
            outcome, peak_mb = self._pipe.recv()
        except (EOFError, OSError):
            self._process.join()
            status = self._process.exitcode
            self.close()
            return Outcome("fault", 0.0, f"the process ended with status {status}")
        self.peak_mb = max(self.peak_mb, peak_mb)
        return outcome

    def close(self) -> None:
        """Ends the process."""
        if self._pipe is not None:
            self._pipe.close()
            self._process.kill()
            self._process.join()
            self._pipe = None


def _serve(pipe: Connection, target: Target) -> None:
    outcome_of(target.subject, target.originals[0])  # imports and caches count as held
    held = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[0]) * resource.getpagesize()
    limit = held + target.max_mb * 2**20
    resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
    while True:
        try:
            content = pipe.recv_bytes()
        except EOFError:
            return
        outcome = outcome_of(target.subject, content, target.max_seconds)
        pipe.send((outcome, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024))


def fuzz(
    target: Target, seeds: Iterable[int], seconds: float | None, faults: Path | None
) -> dict[str, float]:
    """Outcomes of a target's mutated files, until seeds or seconds end; faults are printed and kept."""
    kinds: Counter[str] = Counter()
    slowest, end = 0.0, None if seconds is None else time.monotonic() + seconds
    child = Child(target)
    for seed in seeds:
        if end is not None and time.monotonic() > end:
            break
        content = target.mutated(seed)
        outcome = child.take(content)
        kinds[outcome.kind] += 1
        slowest = max(slowest, outcome.seconds)
        if outcome.kind == "fault":
            print(f"--- {target.name}, seed {seed}: {outcome.message}\n{content[:400]!r}\n", flush=True)
            if faults is not None:
                faults.mkdir(parents=True, exist_ok=True)
                (faults / f"{target.name}-{seed}").write_bytes(content)
    child.close()
    return {
        "files": kinds.total(),
        "read": kinds["read"] + kinds["read with warnings"],
        "read_with_warnings": kinds["read with warnings"],
        "refused": kinds["refused"],
        "faults": kinds["fault"],
        "originals": len(target.originals),
        "slowest_cpu_seconds": round(slowest, 3),
        "peak_mb": round(child.peak_mb),
    }


def main(name: str, make_targets: Callable[[], Sequence[Target]]) -> int:
    """Runs a fuzzer's targets, which share the seconds; returns the exit status, 1 after faults.

    `name` is that of the fuzzer's module.
    """
    parser = argparse.ArgumentParser(prog=f"python -m tests.fuzz.{name}")
    parser.add_argument("--seconds", type=float, default=None, help="for all targets together")
    parser.add_argument("--count", type=int, default=None, help="files a target (2000 without --seconds)")
    parser.add_argument("--seed", type=int, default=0, help="seed of the first file (default: 0)")
    parser.add_argument("--only", default=None, help="the name of the one target to feed")
    parser.add_argument("--faults", type=Path, default=None, help="a folder for files that make faults")
    options = parser.parse_args()
    targets = [target for target in make_targets() if options.only in (None, target.name)]
    if not targets:
        print(f'there is no target "{options.only}"', file=sys.stderr)
        return 2
    count = options.count if options.count is not None or options.seconds is not None else 2000
    results: dict[str, dict[str, float]] = {}
    for target in targets:
        seeds = counting(options.seed) if count is None else range(options.seed, options.seed + count)
        share = None if options.seconds is None else options.seconds / len(targets)
        results[target.name] = fuzz(target, seeds, share, options.faults)
        print(f"{target.name}: {results[target.name]}", flush=True)
    return 1 if any(figures["faults"] for figures in results.values()) else 0
