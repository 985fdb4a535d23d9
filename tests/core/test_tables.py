"""Tables that are declared once: what follows from a declaration, and what is said of faulty files."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.core.tables import (
    Shown,
    Tables,
    computed,
    derived,
    flag,
    given,
    setting,
    size,
    table,
)
from loomlight.fabric import fabric_from_text
from loomlight.models.interface import ShaderTables
from loomlight.realtime.records import RECORDS
from loomlight.realtime.words import Buffers, write_tables
from loomlight.sources.loom_file import LoomFile


class MapTables(Tables):
    """Levels of grey of a map."""

    version = 2
    record = "map"

    is_there = flag("0 where there is no map")
    columns = size(
        "texels of a row", of="texels", counted="texels a row", expected="an even number", multiple=2
    )
    rows = size("", "texels")
    width = given("float", "millimetres")
    step: float = setting("side of a texel, millimetres", "mm", 0.0)

    @computed("texels of the map")
    def count(self) -> int:
        return self.columns * self.rows

    texels: NDArray[np.uint8] = table("grey of each texel", ("rows", "columns"), words="bytes", high=9, low=0)
    means: NDArray[np.float64] = table(
        "of rows", ("rows",), words="words", shown=Shown(("2 * rows",), lambda means: np.repeat(means, 2))
    )
    edges: NDArray[np.int16] | None = table(
        "of each row and its border", ("rows + 1", "2 sides"), words="bytes", tensor="borders", default=None
    )

    @derived("brightest texel of each row", ("rows",), words="words", device="UInt32")
    def brightest(self) -> NDArray[np.uint8]:
        return np.asarray(self.texels.max(axis=1))


TEXELS = np.array([[1, 2, 3, 4], [5, 6, 7, 8]], np.uint8)
MEANS = np.array([2.5, 6.5])
BORDERS = np.zeros((3, 2), np.int16)


def loom(settings: dict[str, Any] | None = None, **tensors: Any) -> LoomFile:
    held = {"texels": TEXELS, "means": MEANS} | tensors
    return LoomFile(
        "map",
        fabric_from_text("plain"),
        {name: array for name, array in held.items() if array is not None},
        {"step": 0.5, "tables_version": 2} | (settings or {}),
        file="a.loom",
    )


def test_a_file_gives_the_tables_back() -> None:
    read = loom().tables(MapTables)
    assert (read.columns, read.rows, read.count, read.step, read.edges) == (4, 2, 8, 0.5, None)
    np.testing.assert_array_equal(read.texels, TEXELS)
    assert list(read.arrays()) == ["texels", "means"]
    assert read.settings() == {"step": 0.5, "tables_version": 2}
    assert list(loom(borders=BORDERS).tables(MapTables).arrays()) == ["texels", "means", "borders"]


@pytest.mark.parametrize(
    ("faulty", "sentence"),
    [
        (loom(texels=None), "the tensor model.texels is missing: it should be [any, any] uint8."),
        (loom(means=MEANS[:1]), "the tensor model.means is [1] float64: it should be [2] float64."),
        (
            loom(borders=np.zeros((2, 2), np.int16)),
            "the tensor model.borders is [2, 2] int16: it should be [3, 2]",
        ),
        (
            loom(texels=TEXELS[:, :3]),
            "the tensor model.texels has 3 texels a row: it should have an even number.",
        ),
        (
            loom(texels=TEXELS[:, :2] + 9),
            "the tensor model.texels is [[10, 11], [14, 15]]: it should be 0 to 9 each.",
        ),
        (loom(texels=np.tile(TEXELS, 4) + 9), "the tensor model.texels holds 10: it should be 0 to 9 each."),
        (loom({"step": 0.0}), "the setting step is 0: it should be above 0 mm."),
        (loom({"tables_version": 1}), "its tables are of another version of loomlight: bake it again."),
    ],
)
def test_faults_are_one_sentence(faulty: LoomFile, sentence: str) -> None:
    with pytest.raises(InputError) as caught:
        faulty.tables(MapTables)
    assert str(caught.value).startswith(f"a.loom: {sentence}")


def test_sizes_that_are_known_elsewhere_are_asked_of_files() -> None:
    with pytest.raises(InputError, match=r"texels is \[2, 4\] uint8: it should be \[3, any\] uint8"):
        loom().tables(MapTables, {"rows": 3})


def test_records_and_words_follow_from_the_declaration() -> None:
    fields = MapTables.record_fields()
    assert [(name, kind) for name, kind, _ in fields] == [
        ("is_there", "uint"),
        ("columns", "uint"),
        ("rows", "uint"),
        ("width", "float"),
        ("count", "uint"),
        ("texels", "uint"),
        ("means", "uint"),
        ("edges", "uint"),
        ("brightest", "uint"),
    ]
    assert fields[5][2] == "bytes: grey of each texel [rows, columns]"
    record = np.zeros(1, [(name, {"uint": "<u4", "float": "<f4"}[kind]) for name, kind, _ in fields])[0]
    buffers = Buffers()
    write_tables(record, ShaderTables(loom().tables(MapTables), {"width": 7.0}), buffers)
    assert record.tolist() == (1, 4, 2, 7.0, 8, 0, 2, 0, 6)
    words = buffers.words.words()
    assert words[:2].tobytes() == TEXELS.tobytes()
    np.testing.assert_array_equal(words[2:6].view(np.float32), np.repeat(MEANS, 2))
    np.testing.assert_array_equal(words[6:], [4, 8])


def test_room_for_tables_is_that_of_the_tables() -> None:
    counts = MapTables.word_counts({"columns": 4, "rows": 3})
    assert counts == {"texels": 3, "means": 6, "edges": 4, "brightest": 3}
    empty = MapTables.zeros({"columns": 4, "rows": 3}, edges=None, step=1.0)
    assert (empty.count, empty.means.tolist()) == (12, [0, 0, 0])


def test_every_table_of_a_model_has_a_field_of_its_record() -> None:
    for record in ("Lobes", "Clustered", "Neural", "Neumip", "Latent"):
        names = [name for name, _, _ in RECORDS[record]]
        assert len(names) == len(set(names)) > 15
