"""Shards of work that any number of processes share through a folder: claims, outcomes, completion markers.

    KEY.claim    locked by the process that works on the shard; says which that is, and the how-manieth
    KEY.done     the outcome, written under a temporary name and renamed: there, the shard is complete

The kernel releases a lock when its process ends, however it ends, on other machines too if the file system
has locks (NFS has). So a claim without a lock is a dead process's, whatever the time, and is taken over.
"""

from __future__ import annotations

import errno
import json
import os
import re
import socket
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from loomlight.core.errors import InputError, MissingDependencyError
from loomlight.core.files import replacing

# Processes that a shard may end in one run, such as for want of memory, before it is given up.
_MAX_DEATHS = 2
_KEY = re.compile(r"[\w.+-]{1,200}")


@dataclass(frozen=True)
class Shard:
    """A piece of work.

    Attributes:
        key: its name, part of file names.
        identity: of everything that the outcome depends on: an outcome of another identity is none.
    """

    key: str
    identity: str

    def __post_init__(self) -> None:
        if not _KEY.fullmatch(self.key):
            raise ValueError(f"{self.key!r} is no name of a file")


@dataclass(frozen=True)
class Outcome:
    """The end of a shard.

    Attributes:
        content: the result.
        fault: what is wrong with the input, one sentence, where there is no result.
        defect: the traceback of an error that is this program's.
        warnings: sentences.
    """

    content: bytes = b""
    fault: str | None = None
    defect: str | None = None
    warnings: tuple[str, ...] = ()

    @property
    def succeeded(self) -> bool:
        """Whether there is a result."""
        return self.fault is None and self.defect is None


class ShardFolder:
    """The folder that processes share.

    Attributes:
        path: made if need be.
        run: name of one call, from whichever machines: failures of other runs are tried again.
    """

    def __init__(self, path: Path, run: str) -> None:
        """
        Raises:
            InputError: the folder cannot be made.
        """
        self.path, self.run = path, run
        try:
            path.mkdir(exist_ok=True)
        except OSError as error:
            raise InputError(f"{path} cannot be made: {error.strerror}.") from error

    def outcome(self, shard: Shard) -> Outcome | None:
        """The outcome of a shard that is complete, or has failed in this run; else None."""
        try:
            head, _, content = self._marker(shard).read_bytes().partition(b"\n")
            facts: dict[str, Any] = json.loads(head)
            if facts.pop("identity") != shard.identity:
                return None
            run = facts.pop("run")
            outcome = Outcome(content, **facts | {"warnings": tuple(facts["warnings"])})
        except (FileNotFoundError, ValueError, KeyError, TypeError):
            return None
        return outcome if outcome.succeeded or run == self.run else None

    def store(self, shard: Shard, outcome: Outcome) -> None:
        """Marks a shard as complete, or as failed in this run.

        Raises:
            InputError: the disk is full.
        """
        facts = asdict(outcome) | {"identity": shard.identity, "run": self.run}
        del facts["content"]
        with replacing(self._marker(shard)) as temporary:
            temporary.write_bytes(json.dumps(facts).encode() + b"\n" + outcome.content)

    def forget(self, shard: Shard) -> None:
        """Removes the outcome: the shard will be worked on again."""
        self._marker(shard).unlink(missing_ok=True)

    @contextmanager
    def claimed(self, shard: Shard, *, wait: bool) -> Iterator[bool]:
        """Claims a shard for the block; False if another process has it.

        Args:
            wait: until that process is done with it, or has ended.

        Raises:
            InputError: the file system has no locks.
        """
        path = self.path / f"{shard.key}.claim"
        handle = _locked(path, wait)
        if handle is None:
            yield False
            return
        try:
            deaths = self._begin(handle)
            if deaths >= _MAX_DEATHS and self.outcome(shard) is None:
                sentence = f"its process ended {deaths} times without an error: is there too little memory?"
                self.store(shard, Outcome(fault=f"{shard.key}: {sentence}"))
            yield True
        finally:
            # While it is locked: another process that has opened it finds another file, or none, by its name.
            with suppress(FileNotFoundError):
                path.unlink()
            os.close(handle)

    def _begin(self, handle: int) -> int:
        """Writes who has the claim; returns how many processes of this run died of the shard before."""
        try:
            before = json.loads(os.pread(handle, 1 << 12, 0))
            deaths = int(before["deaths"]) + 1 if before["run"] == self.run else 0
        except (ValueError, KeyError, TypeError):
            deaths = 0
        owner = {"run": self.run, "deaths": deaths, "host": socket.gethostname(), "process": os.getpid()}
        os.ftruncate(handle, 0)
        os.pwrite(handle, json.dumps(owner).encode(), 0)
        return deaths

    def _marker(self, shard: Shard) -> Path:
        return self.path / f"{shard.key}.done"


def _locked(path: Path, wait: bool) -> int | None:
    """A handle of a file that this process has locked, or None if another has."""
    try:
        import fcntl
    except ModuleNotFoundError as error:
        raise MissingDependencyError(
            "Several processes need file locks of POSIX: use --workers 1."
        ) from error
    while True:
        handle = os.open(path, os.O_RDWR | os.O_CREAT, 0o666)
        try:
            fcntl.flock(handle, fcntl.LOCK_EX if wait else fcntl.LOCK_EX | fcntl.LOCK_NB)
            # The owner before may have removed it between opening and locking.
            if os.fstat(handle).st_nlink and os.path.samestat(os.fstat(handle), os.stat(path)):
                return handle
        except FileNotFoundError:
            pass
        except OSError as error:
            os.close(handle)
            if error.errno in (errno.EAGAIN, errno.EACCES):
                return None
            raise InputError(f"{path.parent} is on a file system without locks: {error.strerror}.") from error
        except BaseException:
            os.close(handle)
            raise
        os.close(handle)
