"""An exported CUDA library on a CPU, with numbers that count what is executed: `realtime_counts.cpp`."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.exporters import export
from loomlight.realtime.materials import Material
from loomlight.realtime.records import numpy_type

_BUFFERS = ("fabrics", "families", "words", "packed_numbers")
_SOURCE = Path(__file__).with_name("realtime_counts.cpp")


@dataclass(frozen=True)
class Counts:
    """Means a query.

    Attributes:
        simple: operations such as add, multiply, compare, minimum; a fused multiply-add is two.
        divisions, roots: each one operation.
        loaded_bytes: of words of tables.
        sector_bytes: of the 32-byte sectors that these lie in, each fetched once for 64 queries in a row.
    """

    simple: float
    divisions: float
    roots: float
    loaded_bytes: float
    sector_bytes: float

    @property
    def operations(self) -> float:
        """All of them, each one."""
        return self.simple + self.divisions + self.roots


class CountedLibrary:
    """The library of a material and a model.

    Args:
        estimates: of `cloth_estimate`, else of `cloth_value`.

    Attributes:
        table_bytes: of all buffers.

    Raises:
        InputError: g++ is missing.
    """

    def __init__(self, material: Material, model: str, estimates: bool = False) -> None:
        compiler = shutil.which("g++")
        if compiler is None:
            raise InputError("Counting needs g++ (Debian, Ubuntu: apt install g++).")
        with TemporaryDirectory() as name:
            folder = Path(name) / "cuda"
            export(material, "cuda", folder, model)
            library = folder / "counted.so"
            function = ["-DCLOTH_ESTIMATE"] if estimates else []
            options = [
                *function,
                "-std=c++17",
                "-O1",
                "-w",
                "-ffp-contract=off",
                "-shared",
                "-fPIC",
                "-I",
                str(folder),
            ]
            subprocess.run([compiler, *options, str(_SOURCE), "-o", str(library)], check=True)
            self._run = ctypes.CDLL(str(library)).run
            # Of buffers that a model does not read there is no file.
            self._buffers = [
                np.fromfile(file, np.uint32) if file.is_file() else np.zeros(0, np.uint32)
                for file in (folder / f"{name}.bin" for name in _BUFFERS)
            ]
        self.table_bytes = sum(buffer.nbytes for buffer in self._buffers)

    def answers(self, queries: NDArray[np.void]) -> tuple[NDArray[np.float32], Counts]:
        """Answers [n, 4] to records `Query` of `loomlight.realtime.records`, and what they take."""
        data = np.ascontiguousarray(queries).view(np.uint32)
        found = np.zeros((len(queries), 4), np.float32)
        totals = np.zeros(5, np.uint64)

        def address(array: NDArray[Any]) -> ctypes.c_void_p:
            return ctypes.c_void_p(array.ctypes.data)

        fabrics, families, words, numbers = self._buffers
        self._run(
            address(fabrics),
            address(families),
            address(words),
            ctypes.c_ulong(words.size),
            address(numbers),
            ctypes.c_ulong(numbers.size),
            address(data),
            ctypes.c_uint(len(queries)),
            address(found),
            address(totals),
        )
        simple, divisions, roots, loads, sectors = (float(total) / len(queries) for total in totals)
        return found, Counts(simple, divisions, roots, 4 * loads, 32 * sectors)


def queries_of(
    centre: NDArray[Any], dx: NDArray[Any], dy: NDArray[Any], light: NDArray[Any], view: NDArray[Any]
) -> NDArray[np.void]:
    """Records of queries of fabric 0 from arrays [n, 2] and unit vectors [n, 3]."""
    records = np.zeros(len(centre), numpy_type("Query"))
    for name, values, axes in (
        ("centre", centre, "xy"),
        ("dx", dx, "xy"),
        ("dy", dy, "xy"),
        ("light", light, "xyz"),
        ("view", view, "xyz"),
    ):
        for column, axis in enumerate(axes):
            records[f"{name}_{axis}"] = values[:, column]
    return records
