"""A function over items, on processes of this machine, on Slurm, or by joblib's backends.

Every process works through the same shards of one folder (`shards.py`), whichever is free. A process that is
killed loses the shard it was at, which another process takes; a later call with the same folder goes on.
"""

from __future__ import annotations

import traceback
import uuid
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Generic, TypeVar

from loomlight.core.errors import InputError, LoomlightError, LoomlightWarning
from loomlight.core.executors import Executor, Report
from loomlight.core.files import remove_leftovers
from loomlight.core.shards import Outcome, Shard, ShardFolder

_Item = TypeVar("_Item")


@dataclass(frozen=True)
class Work(Generic[_Item]):
    """The settings that every process gets; they are pickled.

    Attributes:
        function: from an item to the result; a function of a module, or a `functools.partial` of one.
        items: with their shards.
        folder: that they share.
        run: name of this call.
    """

    function: Callable[[_Item], bytes]
    items: Sequence[tuple[Shard, _Item]]
    folder: Path
    run: str = field(default_factory=lambda: uuid.uuid4().hex)

    def shared(self) -> ShardFolder:
        """The folder of shards."""
        return ShardFolder(self.folder, self.run)

    def remaining(self) -> int:
        """Number of shards without an outcome."""
        folder = self.shared()
        return sum(folder.outcome(shard) is None for shard, _ in self.items)

    def work_through(self, first: int, most: int | None, told: Callable[[], None]) -> None:
        """Works on shards that nobody has, from number `first` on, until all are complete.

        Args:
            most: shards to work on at most.
            told: called after each.
        """
        folder, count = self.shared(), len(self.items)
        done = 0
        # Then again, waiting for those that others had: their processes may have been killed.
        for wait in (False, True):
            for number in range(count):
                if most is not None and done >= most:
                    return
                shard, item = self.items[(first + number) % count]
                if folder.outcome(shard) is not None:
                    continue
                with folder.claimed(shard, wait=wait) as is_mine:
                    if is_mine and folder.outcome(shard) is None:
                        folder.store(shard, attempt(self.function, item))
                        done += 1
                        told()


def work_map(
    function: Callable[[_Item], bytes],
    items: Sequence[tuple[Shard, _Item]],
    folder: Path,
    executor: Executor | None = None,
    report: Report = lambda done, total: None,
) -> list[Outcome]:
    """The outcomes of all items, in their order; those that the folder holds already are read.

    Args:
        function: see `Work`; an InputError of it is the outcome's `fault`.
        folder: for claims and results, which no other function may share; made if need be, and kept.
        executor: who works; by default this process alone.
        report: called with (shards complete, shards in all).

    Raises:
        LoomlightError: processes ended before all was done; what is done stays.
        RuntimeError: the function raised an error that is no LoomlightError.
    """
    work = Work(function, items, folder)
    shared, total = work.shared(), len(items)
    missing = work.remaining()
    if missing:
        report(total - missing, total)
        try:
            (executor or Executor()).run(work, report)
        finally:
            remove_leftovers(folder)
        missing = work.remaining()
    if missing:
        raise LoomlightError(
            f"{missing} of {total} shards are missing, as their processes ended; {folder} keeps the others: "
            "the same command goes on from there."
        )
    outcomes = [shared.outcome(shard) or Outcome() for shard, _ in items]
    for outcome in outcomes:
        if outcome.defect is not None:
            raise RuntimeError(f"in another process:\n{outcome.defect}")
        for sentence in outcome.warnings:
            warnings.warn(sentence, LoomlightWarning, stacklevel=2)
    report(total, total)
    return outcomes


def attempt(function: Callable[[_Item], bytes], item: _Item) -> Outcome:
    """The outcome of an item: its result, or its fault."""
    content, fault, defect = b"", None, None
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", LoomlightWarning)
        try:
            content = function(item)
        except InputError as error:
            fault = str(error)
        except LoomlightError:
            raise
        except Exception:
            defect = traceback.format_exc()
    sentences = [str(each.message) for each in caught if issubclass(each.category, LoomlightWarning)]
    return Outcome(content, fault, defect, tuple(dict.fromkeys(sentences)))


def require_results(outcomes: Mapping[str, Outcome]) -> None:
    """Raises InputError if an item could not be used; the sentence has its fault.

    Args:
        outcomes: by the items' names.
    """
    faults = [outcome.fault for outcome in outcomes.values() if outcome.fault is not None]
    if len(faults) == 1 or len(outcomes) == 1:
        for fault in faults:
            raise InputError(fault)
    if faults:
        raise InputError(f"{len(faults)} of {len(outcomes)} cannot be used; the first: {faults[0]}")
