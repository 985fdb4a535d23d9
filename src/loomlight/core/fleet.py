"""A function over items, on processes of this machine, on Slurm, or by joblib's backends.

Every process works through the same shards of one folder (below), whichever is free. A process that is
killed loses the shard it was at, which another process takes; a later call with the same folder goes on.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import threading
import time
import traceback
import uuid
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import asdict, dataclass, field
from multiprocessing import connection, get_context, parent_process
from pathlib import Path
from typing import Any, Generic, Protocol, TypeVar

from filelock import FileLock, Timeout

from loomlight.core.errors import InputError, LoomlightError, LoomlightWarning, MissingDependencyError
from loomlight.core.extras import import_extra
from loomlight.core.files import remove_leftovers, replacing
from loomlight.core.parallel_map import core_count

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
    for shard, _ in items:
        shared.remove_lock(shard)
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
        except Exception:  # a defect: `work_map` raises it where the work was asked for
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


# ----------------------------------------------------------------------------------------------------- shards
# Shards of work that any number of processes share through a folder:
#
#     KEY.lock     locked by the process that works on the shard
#     KEY.claim    says which process that is, and how many died of the shard before
#     KEY.done     the outcome, written under a temporary name and renamed: there, the shard is complete
#
# The kernel releases a lock when its process ends, however it ends, on other machines too if the file
# system has locks (NFS has). So a claim without a lock is a dead process's, whatever the time, and is taken
# over.


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
        lock = FileLock(self._lock(shard))
        try:
            lock.acquire(blocking=wait)
        except Timeout:
            yield False
            return
        except (OSError, NotImplementedError) as error:  # filelock, where the system lacks what it needs
            raise InputError(f"{self.path} is on a file system without locks: {error}.") from error
        claim = self.path / f"{shard.key}.claim"
        try:
            deaths = self._deaths(claim)
            owner = {"run": self.run, "deaths": deaths, "host": socket.gethostname(), "process": os.getpid()}
            claim.write_text(json.dumps(owner), encoding="utf-8")
            if deaths >= _MAX_DEATHS and self.outcome(shard) is None:
                sentence = f"its process ended {deaths} times without an error: is there too little memory?"
                self.store(shard, Outcome(fault=f"{shard.key}: {sentence}"))
            yield True
        finally:
            claim.unlink(missing_ok=True)
            lock.release()

    def remove_lock(self, shard: Shard) -> None:
        """Removes the lock of a shard that is complete: whoever has it open finds the outcome."""
        with suppress(OSError):  # Windows keeps files that another process has open
            self._lock(shard).unlink(missing_ok=True)

    def _deaths(self, claim: Path) -> int:
        """How many processes of this run died of a shard: each left its claim."""
        try:
            before = json.loads(claim.read_text(encoding="utf-8"))
            return int(before["deaths"]) + 1 if before["run"] == self.run else 0
        except (OSError, ValueError, KeyError, TypeError):
            return 0

    def _lock(self, shard: Shard) -> Path:
        return self.path / f"{shard.key}.lock"

    def _marker(self, shard: Shard) -> Path:
        return self.path / f"{shard.key}.done"


# -------------------------------------------------------------------------------------------------- who works
# Who works on shards: processes of this machine, jobs of Slurm through submitit, or a backend of joblib.


KINDS = ("local", "slurm", "joblib")
# Shards that one process works on before a fresh one takes its place: compiled kernels stay in memory, and
# Linux grants a process 65 530 mappings, which about a thousand fabrics would fill.
MAX_SHARDS_OF_A_PROCESS = 64
# Processes that may end in error, one after the other, while nothing gets done.
_MAX_IDLE_DEATHS = 4
# Between looks at the folder, where other machines work.
_LOOK_SECONDS = 2.0
# What a process has to end by itself once it is told to.
_GRACE_SECONDS = 2.0
# What jobs have to end in once all shards are done.
_END_SECONDS = 30.0
_MAX_WORKERS = 4096

Report = Callable[[int, int], None]


class Shared(Protocol):
    """A work as executors see it."""

    @property
    def folder(self) -> Path:
        """That all processes share."""

    @property
    def items(self) -> Sequence[Any]:
        """One for each shard."""

    def remaining(self) -> int:
        """Number of shards without an outcome."""

    def work_through(self, first: int, most: int | None, told: Callable[[], None]) -> None:
        """Works on shards from number `first` on, at most on so many; calls `told` after each."""


@dataclass(frozen=True)
class Executor:
    """Who works.

    Attributes:
        kind: one of `KINDS`.
        backend: of joblib, such as loky, dask or ray; for Slurm a cluster of submitit: "local" are processes
            of this machine, to try it.
        workers: processes, or jobs.
        settings: parameters of submitit, such as slurm_partition and timeout_min.
    """

    kind: str = "local"
    backend: str = ""
    workers: int = 1
    settings: Mapping[str, int | str] = field(default_factory=dict)

    def run(self, work: Shared, report: Report) -> None:
        """Works until all shards have an outcome, or all processes have ended.

        Raises:
            LoomlightError: nothing gets done, or a process says why it cannot go on.
            MissingDependencyError: submitit, joblib or Slurm is missing.
        """
        if self.kind == "slurm":
            _run_jobs(self, work, report)
        elif self.kind == "joblib":
            _run_joblib(self, work, report)
        else:
            run_locally(work, self.workers, report)


def parse_executor(text: str, workers: int, settings: Mapping[str, str]) -> Executor:
    """The executor of the options --executor, --workers and --slurm.

    Args:
        text: local, slurm or joblib, or with a backend "joblib:dask".
        settings: of submitit, by name.

    Raises:
        InputError: no such executor, or a number of workers out of range.
    """
    kind, _, backend = text.strip().lower().partition(":")
    if kind not in KINDS or (kind == "local" and backend):
        raise InputError(f'--executor "{text}" is none: write local, slurm, joblib, or joblib:dask.')
    if not 1 <= workers <= _MAX_WORKERS:
        raise InputError(f"--workers {workers} is out of range: write a number from 1 to {_MAX_WORKERS}.")
    if settings and kind != "slurm":
        raise InputError(f"--slurm {next(iter(settings))} needs --executor slurm.")
    values = {name: int(value) if value.isdecimal() else value for name, value in settings.items()}
    return Executor(kind, backend, workers, values)


def run_locally(
    work: Shared, workers: int, report: Report = lambda done, total: None, first: int = 0
) -> None:
    """Works with processes of this machine; with this one alone where one suffices.

    Args:
        first: number of the shard to begin with.

    Raises:
        LoomlightError: as `Executor.run`.
    """
    count, missing = len(work.items), work.remaining()
    if min(workers, missing) <= 1 and missing <= MAX_SHARDS_OF_A_PROCESS:
        done = count - missing

        def told() -> None:
            nonlocal done
            done += 1
            report(done, count)

        work.work_through(first, None, told)
    elif missing:
        with _Crew(work, min(workers, missing), report, first) as crew:
            crew.wait()


class _Crew:
    """Processes that work; one that ends while there is work is replaced."""

    def __init__(self, work: Shared, workers: int, report: Report, first: int) -> None:
        self._work, self._report = work, report
        self._context = get_context("spawn")  # a fork has none of Dr.Jit's threads
        self._threads = max(1, core_count() // workers)
        self._processes: dict[connection.Connection, Any] = {}
        count = len(work.items)
        self._done = count - work.remaining()
        self._starts = [first + number * count // workers for number in range(workers)]

    def __enter__(self) -> _Crew:
        for first in self._starts:
            self._start(first)
        return self

    def wait(self) -> None:
        """Returns when no process works any more."""
        idle_deaths = 0
        while self._processes:
            for channel in connection.wait(list(self._processes)):
                assert isinstance(channel, connection.Connection)
                try:
                    sentence = channel.recv_bytes().decode()
                except (EOFError, ConnectionError):
                    process = self._processes.pop(channel)
                    channel.close()
                    process.join()
                    if process.exitcode:
                        idle_deaths += 1
                    if idle_deaths > _MAX_IDLE_DEATHS:
                        raise LoomlightError(
                            f"Processes end before they finish anything, the last by {_end_of(process)}; "
                            "what is finished is kept."
                        ) from None
                    if self._work.remaining():
                        self._start(self._starts[0])
                    continue
                if sentence:
                    raise LoomlightError(sentence)
                idle_deaths = 0
                self._done += 1
                self._report(min(self._done, len(self._work.items)), len(self._work.items))

    def __exit__(self, *_: object) -> None:
        for process in self._processes.values():
            process.terminate()
        end = time.monotonic() + _GRACE_SECONDS
        for process in self._processes.values():
            process.join(max(end - time.monotonic(), 0.01))
            process.kill()
            process.join()

    def _start(self, first: int) -> None:
        source, sink = self._context.Pipe(duplex=False)
        process = self._context.Process(
            target=_member, args=(self._work, first, sink, self._threads), daemon=True
        )
        process.start()
        sink.close()
        self._processes[source] = process


def _member(work: Shared, first: int, channel: connection.Connection, threads: int) -> None:
    """The loop of one process of a crew: works on shards and reports; a sentence says why it cannot go on."""
    threading.Thread(target=_end_with_parent, daemon=True).start()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))
    import drjit as dr

    dr.set_thread_count(threads)
    try:
        work.work_through(first, MAX_SHARDS_OF_A_PROCESS, lambda: channel.send_bytes(b""))
    except KeyboardInterrupt:
        sys.exit(128 + signal.SIGINT)
    except LoomlightError as error:
        channel.send_bytes(str(error).encode())


def _end_with_parent() -> None:
    parent = parent_process()
    if parent is not None:
        parent.join()
        signal.raise_signal(signal.SIGTERM)
        time.sleep(_GRACE_SECONDS)
        os._exit(128 + signal.SIGTERM)


def _end_of(process: Any) -> str:
    code = process.exitcode
    return signal.Signals(-code).name if code < 0 else f"exit code {code}"


def _run_jobs(chosen: Executor, work: Shared, report: Report) -> None:
    submitit = import_extra("submitit", "fleet", "--executor slurm")
    cluster = chosen.backend or "slurm"
    if cluster == "slurm" and shutil.which("sbatch") is None:
        raise MissingDependencyError(
            "--executor slurm needs Slurm's sbatch, which this machine lacks: use --executor local."
        )
    try:
        executor = submitit.AutoExecutor(folder=work.folder / "jobs", cluster=cluster)
        executor.update_parameters(name="loomlight", **chosen.settings)
    except (NameError, ValueError, TypeError, AssertionError) as error:
        reason = " ".join(str(error).split())[:300]
        raise InputError(f"submitit does not take these settings of --slurm: {reason}") from error
    count = len(work.items)
    workers = min(chosen.workers, work.remaining())
    starts = [number * count // workers for number in range(workers)]
    jobs = executor.map_array(lambda first: run_locally(work, 1, first=first), starts)
    try:
        with _looking(work, report):
            while work.remaining() and _running(jobs, cluster):
                time.sleep(_LOOK_SECONDS)
        end = time.monotonic() + _END_SECONDS
        while _running(jobs, cluster) and time.monotonic() < end:
            time.sleep(0.5)
    finally:
        for job in _running(jobs, cluster):
            job.cancel(check=False)
    failed = [job for job in jobs if not job.paths.result_pickle.exists() or job.exception() is not None]
    if failed and work.remaining():
        raise LoomlightError(
            f"{len(failed)} of {workers} jobs failed; {failed[0].paths.stderr} "
            "says why, and what is finished is kept: the same command goes on from there."
        )


def _running(jobs: Sequence[Any], cluster: str) -> list[Any]:
    """Jobs that have not ended. A Slurm without accounting tells of killed jobs only by its queue."""
    waiting = [job for job in jobs if not job.paths.result_pickle.exists()]
    if cluster != "slurm" or not waiting:
        return [job for job in waiting if not job.done()]
    command = ["squeue", "-h", "-j", ",".join(job.job_id for job in waiting)]
    said = subprocess.run(command, capture_output=True, text=True, check=False)
    is_gone = "Invalid job id" in said.stderr or not (said.returncode or said.stdout.strip())
    return [] if is_gone else waiting


def _run_joblib(chosen: Executor, work: Shared, report: Report) -> None:
    joblib = import_extra("joblib", "fleet", "--executor joblib")
    backend = chosen.backend or "loky"
    count = len(work.items)
    workers = min(chosen.workers, work.remaining())
    with _connected(backend), _looking(work, report):
        try:
            # `Parallel(backend="dask")` knows no backends of other packages; this call registers them.
            settings = joblib.parallel_config(backend, n_jobs=workers)
        except (ValueError, TypeError) as error:
            raise InputError(f"--executor joblib:{backend}: joblib has no such backend.") from error
        with settings:
            joblib.Parallel()(
                joblib.delayed(run_locally)(work, 1, first=number * count // workers)
                for number in range(workers)
            )


@contextmanager
def _connected(backend: str) -> Iterator[None]:
    """Connected to the cluster of a backend, which DASK_SCHEDULER_ADDRESS or RAY_ADDRESS names."""
    if backend == "dask":
        distributed = import_extra("distributed", "", "--executor joblib:dask")
        address = os.environ.get("DASK_SCHEDULER_ADDRESS")
        with distributed.Client(address) if address else distributed.Client():
            yield
        return
    if backend == "ray":
        import_extra("ray.util.joblib", "", "--executor joblib:ray").register_ray()
    yield


@contextmanager
def _looking(work: Shared, report: Report) -> Iterator[None]:
    """Reports the shards that others complete, now and then."""
    ended = threading.Event()

    def look() -> None:
        while not ended.wait(_LOOK_SECONDS):
            with suppress(InputError):
                report(len(work.items) - work.remaining(), len(work.items))

    thread = threading.Thread(target=look, daemon=True)
    thread.start()
    try:
        yield
    finally:
        ended.set()
        thread.join()
