"""Code of `lane_code`, compiled for this processor and run on all its cores."""

from __future__ import annotations

import ctypes
import hashlib
import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from typing import Any

import llvmlite
import llvmlite.binding as llvm
import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import LoomlightError
from loomlight.core.files import cache_folder, replacing
from loomlight.core.lane_code import Code, Vectors

_SPEED = 2  # LLVM's level of optimisation
_LINE = 16  # floats of a line of the cache
# Where object files are kept, and bytes of the digest that each begins with.
_FOLDER, _DIGEST = "machine_code", 32

Floats = NDArray[np.float32]


@cache
def cores() -> int:
    """Cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


@cache
def vectors() -> Vectors:
    """Vectors of this processor."""
    try:
        features = llvm.get_host_cpu_features()
    except RuntimeError:  # LLVM does not know how to ask
        features = {}
    if features.get("avx512f"):
        return Vectors(16, 32)
    if features.get("avx2") and features.get("fma"):
        return Vectors(8, 16)
    return Vectors(4, 32 if llvm.get_default_triple().startswith(("aarch64", "arm64")) else 16)


def aligned(values: Floats) -> Floats:
    """The same numbers, beginning with a line of the cache, which no vector of theirs then straddles."""
    room = np.empty(values.size + _LINE, np.float32)
    first = -(room.ctypes.data // room.itemsize) % _LINE
    found = room[first : first + values.size].reshape(values.shape)
    found[:] = values
    return found


class MachineCode:
    """A compiled function of queries."""

    def __init__(self, code: Code) -> None:
        self._block = code.vectors.block
        self._engine = _compiled(code)
        kind = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_int64, ctypes.c_void_p)
        self._function = kind(self._engine.get_function_address(code.name))

    def run(
        self, count: int, queries: Sequence[Floats], answers: Sequence[Floats], shared: Sequence[Floats]
    ) -> None:
        """Answers queries.

        Args:
            count: of queries.
            queries: the numbers that each is, arrays [count].
            answers: arrays [count] to be filled; code may read what they hold.
            shared: what all queries share, in memory one after another.
        """
        for array in (*queries, *answers):
            if array.shape != (count,) or array.dtype != np.float32 or not array.flags.c_contiguous:
                raise ValueError("queries and answers have to be float32 in a row, as many as are asked for")
        full = count // self._block
        if full:
            self._on_all_cores(full, [*queries, *answers, *shared])
        done = full * self._block
        if done < count:
            # A block that is not full is answered aside.
            last = [_padded(array[done:], self._block) for array in queries]
            found = [_padded(array[done:], self._block) for array in answers]
            self._on_all_cores(1, [*last, *found, *shared])
            for array, some in zip(answers, found, strict=True):
                array[done:] = some[: count - done]

    def _on_all_cores(self, blocks: int, arrays: Sequence[Floats]) -> None:
        addresses = np.array([array.ctypes.data for array in arrays], np.uint64)
        taken = np.zeros(1, np.int64)

        def take() -> None:
            self._function(taken.ctypes.data, blocks, addresses.ctypes.data)

        # A core that others use as well takes fewer blocks, and is not waited for.
        beside = [_workers().submit(take) for _ in range(min(blocks, cores()) - 1)]
        take()
        for other in beside:
            # One that has not begun by now is not needed.
            if not other.cancel():
                other.result()


@cache
def _workers() -> ThreadPoolExecutor:
    return ThreadPoolExecutor(cores(), thread_name_prefix="loomlight")


if hasattr(os, "register_at_fork"):
    # Threads stay behind.
    os.register_at_fork(after_in_child=_workers.cache_clear)


@cache
def _target() -> Any:
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    return llvm.Target.from_default_triple()


def _compiled(code: Code) -> Any:
    """LLVM's engine that holds the machine code."""
    target = _target()
    try:
        features = llvm.get_host_cpu_features().flatten()
    except RuntimeError:
        features = ""
    processor, text = llvm.get_host_cpu_name(), str(code.module)
    machine = target.create_target_machine(cpu=processor, features=features, opt=_SPEED, jit=True)
    told_by = [llvmlite.__version__, str(llvm.llvm_version_info), processor, features, str(_SPEED), text]
    key = hashlib.sha256("\0".join(told_by).encode()).hexdigest()
    found = _kept(key)
    if found is None:
        found = _optimised(text, machine)
        _keep(key, found)
    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), machine)
    engine.add_object_file(llvm.ObjectFileRef.from_data(found))
    engine.finalize_object()
    return engine


def _optimised(text: str, machine: Any) -> bytes:
    """An object file of LLVM's language."""
    module = llvm.parse_assembly(text)
    module.verify()
    # Layers are loops already, as long as they should be.
    options = llvm.create_pipeline_tuning_options(speed_level=_SPEED)
    options.loop_unrolling = options.loop_vectorization = options.slp_vectorization = False
    passes = llvm.create_pass_builder(machine, options)
    passes.getModulePassManager().run(module, passes)
    written: bytes = machine.emit_object(module)
    return written


# Close-ups of cloth take two seconds to compile; what was compiled is kept.


def _kept(key: str) -> bytes | None:
    """What `_keep` kept, if all of it is still there."""
    try:
        held = (cache_folder(_FOLDER) / key).read_bytes()
    except OSError:
        return None
    told, found = held[:_DIGEST], held[_DIGEST:]
    return found if hashlib.sha256(found).digest() == told else None


def _keep(key: str, found: bytes) -> None:
    """Keeps an object file where that is possible; elsewhere it is compiled anew next time."""
    folder = cache_folder(_FOLDER)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with replacing(folder / key) as temporary:
            temporary.write_bytes(hashlib.sha256(found).digest() + found)
    except (OSError, LoomlightError):
        return


def _padded(values: Floats, count: int) -> Floats:
    """Values [n] and, up to `count`, the last of them again."""
    return np.concatenate([values, np.repeat(values[-1:], count - len(values))])
