"""Tables that are declared once: checks, files, uploads, shader words and records follow from a declaration.

A class of `Tables` is a frozen dataclass whose body declares, in the order in which shaders have them:

    class MapTables(Tables):
        is_baked = flag("0 where there is no map")
        columns = size("texels of a row", of="texels")
        width = given("float", "millimetres")
        texels: NDArray[np.uint8] = table("grey of each texel", ("rows", "columns"), words="bytes")

        @derived("mean of each row", ("rows",), words="words")
        def means(self) -> NDArray[np.float32]: ...

A `table` is an array and a `setting` a number of a file; a `size` is the extent of a table that others have
too; `derived` tables and `computed` numbers follow from these, and a `given` number comes of elsewhere when
shaders are given the tables. Shapes are made of whole numbers, which may have a label ("2 faces"), of names
of sizes, sums and products of these ("4 * (packs + 1)"), and None for any extent.

Four texts follow: what is wrong with arrays (`faults`, `assets.loom_file` writes the sentences), arrays on a
backend (`upload`), the fields of a shader's record (`record_fields`), and numbers of each table by products
of sizes, for hosts that reserve room (`products`).
"""

from __future__ import annotations

import ast
import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields
from functools import cache
from types import SimpleNamespace
from typing import (
    Any,
    ClassVar,
    Generic,
    Literal,
    Self,
    TypeAlias,
    TypeVar,
    dataclass_transform,
    get_args,
    get_origin,
    get_type_hints,
)

import numpy as np
from numpy.typing import NDArray

from loomlight.core.backend import ArrayTypes, upload

Extent: TypeAlias = int | str | None
Shape: TypeAlias = tuple[Extent, ...]
Array: TypeAlias = NDArray[Any]
Bound: TypeAlias = float | str | None
"""A number, or an expression of sizes."""
Packing: TypeAlias = Literal["", "words", "bytes", "elements", "layers"]
"""How shaders read a table, of which their record holds the first index; "" for not at all.

"words" are 32-bit words: unsigned integers, or numbers in single precision. "bytes" are the array's bytes,
four a word. "elements" are eight halves or four singles of `packed_numbers`, as the array's type is, and
"layers" layers of networks in such elements, of arrays (weights, biases) each.
"""
Layer: TypeAlias = tuple[Array, Array | None]
"""Weights [outputs, inputs] and biases [outputs] of a layer, halves or singles."""
Kind: TypeAlias = Literal["uint", "float"]
_Number = TypeVar("_Number", int, float)
# The setting that holds a class's version.
VERSION_SETTING = "tables_version"
_LABELLED = re.compile(r"(\d+) [a-z -]+")


@dataclass(frozen=True)
class Shown:
    """What shaders have of a table in the place of the whole array: its shape, and how it is made."""

    shape: Shape
    of: Callable[[Array], Any]


@dataclass(frozen=True)
class Shared:
    """Layers of a network that many sources share: packed once a checksum."""

    sha256: str
    layers: Callable[[], Sequence[Layer]]


@dataclass(frozen=True)
class Table:
    """An array of a file, or one that follows from such arrays.

    Attributes:
        meaning: what it holds, a phrase.
        shape: see the module.
        words: see `Packing`.
        shown: what shaders have of it.
        device: "Float" or "UInt32", its type on a backend; "" for no upload.
        tensor: its name in files, where that is another; "" for the same.
        low, high, beside: bounds of its values, both allowed, and one value that is right beside them.
        fault: says what an array is instead of a right one, such as "no pyramid"; "" where it is right.
        make: of a derived table.
    """

    meaning: str
    shape: Shape
    words: Packing = ""
    shown: Shown | None = None
    device: str = ""
    tensor: str = ""
    low: Bound = None
    high: Bound = None
    beside: float | None = None
    fault: Callable[[Array], str] | None = None
    make: Callable[[Any], Any] | None = None

    def __get__(self, tables: Tables | None, _: type) -> Any:
        if tables is None or self.make is None:
            return self
        return self.make(tables)

    def extents(self, sizes: Mapping[str, int] | None = None) -> list[int]:
        """Its extents as numbers."""
        return [_value(extent, (sizes or {}).__getitem__) for extent in self.shape]

    def shown_of(self, array: Array) -> Any:
        """What shaders have of an array."""
        return array if self.shown is None else self.shown.of(array)


@dataclass(frozen=True)
class Setting:
    """A number of a file beside its tensors.

    Attributes:
        meaning: what it is, with its unit.
        unit: in sentences of faults.
        above: no value is at or below it.
    """

    meaning: str
    unit: str
    above: float


@dataclass(frozen=True)
class Number(Generic[_Number]):
    """A number of a shader's record.

    Attributes:
        kind: of the field.
        meaning: a phrase.
        make: computes it from the tables; None for one that is given.
    """

    kind: Kind
    meaning: str
    make: Callable[[Any], _Number] | None = None
    words: Packing = ""

    def __get__(self, tables: Tables | None, _: type) -> _Number:
        if tables is None or self.make is None:
            return self  # type: ignore[return-value]  # the declaration itself, for the class
        return self.make(tables)


@dataclass(frozen=True)
class Size:
    """An extent of a table that other tables have too, and a number of the record.

    Attributes:
        meaning: a phrase.
        of: the table, whose shape names the size once.
        counted: what its extent counts, for sentences: "groups a face".
        expected: what is right: "a multiple of four".
        multiple, low: what it must be a multiple of, and its least value.
        kind: of the field of the record; "" for none.
    """

    meaning: str
    of: str
    counted: str = "entries"
    expected: str = "more"
    multiple: int = 1
    low: int = 1
    kind: Kind | Literal[""] = "uint"
    name: str = field(default="", compare=False)

    def __set_name__(self, _: type, name: str) -> None:
        object.__setattr__(self, "name", name)

    def __get__(self, tables: Tables | None, _: type) -> int:
        if tables is None:
            return self  # type: ignore[return-value]  # the declaration itself, for the class
        extent, per, beyond = self.solved(tables)
        return (extent - beyond) // per

    def solved(self, tables: Tables) -> tuple[int, int, int]:
        """The extent that holds the size, as `per` · size + `beyond`: extent, per and beyond."""
        declaration = declared(type(tables), self.of)
        axis = next(axis for axis, extent in enumerate(declaration.shape) if self.name in _names(extent))
        beyond, one = (_value(declaration.shape[axis], {self.name: number}.__getitem__) for number in (0, 1))
        return getattr(tables, self.of).shape[axis], one - beyond, beyond

    def fault(self, tables: Tables) -> str:
        """What is wrong with the extent of its table, the end of a sentence; "" where nothing is."""
        extent, per, beyond = self.solved(tables)
        value, rest = divmod(extent - beyond, per)
        if rest == 0 and value >= self.low and value % self.multiple == 0:
            return ""
        return f"has {extent} {self.counted}: it should have {self.expected}"


Declaration: TypeAlias = Table | Setting | Number[Any] | Size
_DECLARATIONS = (Table, Setting, Number, Size)


def table(
    meaning: str,
    shape: Shape,
    *,
    words: Packing = "",
    shown: Shown | None = None,
    device: str = "",
    tensor: str = "",
    low: Bound = None,
    high: Bound = None,
    beside: float | None = None,
    fault: Callable[[Array], str] | None = None,
    **default: Any,
) -> Any:
    """An array of a file; see `Table`. Its type is that of the annotation.

    Args:
        default: `default=None` for one that may be missing; those come last.
    """
    declaration = Table(meaning, shape, words, shown, device, tensor, low, high, beside, fault)
    return field(metadata={"declaration": declaration}, **default)


def setting(meaning: str, unit: str = "", above: float = -np.inf) -> Any:
    """A number of a file; see `Setting`."""
    return field(metadata={"declaration": Setting(meaning, unit, above)})


def number(kind: Kind, meaning: str) -> Any:
    """A number that is kept with the tables, which no file holds, and a field of the record."""
    return field(metadata={"declaration": Number(kind, meaning)})


def size(
    meaning: str,
    of: str,
    *,
    counted: str = "entries",
    expected: str = "more",
    multiple: int = 1,
    low: int = 1,
    kind: Kind | Literal[""] = "uint",
) -> Size:
    """An extent that tables share; see `Size`."""
    return Size(meaning, of, counted, expected, multiple, low, kind)


def flag(meaning: str) -> Number[int]:
    """A field that is 1 where the tables are there."""
    return Number("uint", meaning, lambda _: 1)


def given(kind: Kind, meaning: str, words: Packing = "") -> Number[Any]:
    """A number of the record, or with `words` a table, that whoever hands the tables to shaders adds."""
    return Number(kind, meaning, None, words)


def computed(meaning: str) -> Callable[[Callable[..., _Number]], Number[_Number]]:
    """Declares a method as a number of the record, of the type that it returns."""

    def declare(make: Callable[..., _Number]) -> Number[_Number]:
        return Number("uint" if make.__annotations__["return"] == "int" else "float", meaning, make)

    return declare


def derived(
    meaning: str, shape: Shape, *, words: Packing = "", device: str = ""
) -> Callable[[Callable[..., Array]], Table]:
    """Declares a method as a table that follows from others; see `Table`."""

    def declare(make: Callable[..., Array]) -> Table:
        return Table(meaning, shape, words, device=device, make=make)

    return declare


@dataclass_transform(frozen_default=True, eq_default=False, field_specifiers=(table, setting, number))
class Tables:
    """Arrays of one kind, whose class declares them; see the module."""

    declarations: ClassVar[dict[str, Declaration]] = {}
    # What tables in files mean; to be raised when older ones no longer fit the formulas. 0 for no version.
    version: ClassVar[int] = 0
    # The field of the source's record that holds the tables' own, whose type has the name capitalized.
    record: ClassVar[str] = ""

    def __init_subclass__(cls) -> None:
        cls.declarations = dict(_declarations(cls))
        dataclass(frozen=True, eq=False)(cls)

    @classmethod
    def tables_in_files(cls) -> dict[str, Table]:
        """Declarations of the arrays that files hold, in the order in which they are read.

        Tables that sizes are read off come first.
        """
        own = {
            name: found
            for name, found in cls.declarations.items()
            if isinstance(found, Table) and found.make is None
        }
        first = [size.of for size in cls.sizes().values()]
        return {name: own[name] for name in dict.fromkeys([*first, *own])}

    @classmethod
    def sizes(cls) -> dict[str, Size]:
        """Declarations of sizes by name."""
        return {name: found for name, found in cls.declarations.items() if isinstance(found, Size)}

    @classmethod
    def settings_in_files(cls) -> dict[str, Setting]:
        """Declarations of numbers that files hold beside arrays."""
        return {name: found for name, found in cls.declarations.items() if isinstance(found, Setting)}

    @classmethod
    def dtype_of(cls, name: str) -> np.dtype[Any]:
        """The type of the numbers of a table, by its annotation."""
        return _dtypes(cls)[name]

    @classmethod
    def record_fields(cls) -> list[tuple[str, Kind, str]]:
        """Fields of the shader's record: name, type and meaning; of tables, where they begin."""
        found: list[tuple[str, Kind, str]] = []
        for name, of in cls.declarations.items():
            if isinstance(of, Table) and of.words:
                shape = of.shape if of.shown is None else of.shown.shape
                extents = f" [{shape_text(shape)}]" if shape else ""
                found.append((name, "uint", cls._numbers_text(name) + of.meaning + extents))
            elif isinstance(of, Size | Number) and of.kind:
                found.append((name, of.kind, of.meaning))
        return found

    @classmethod
    def products(cls) -> dict[str, tuple[list[list[int | str]], int]]:
        """Numbers of each table that shaders read, as sums of products of sizes, and numbers a word."""
        found = {}
        for name, of in cls.declarations.items():
            if isinstance(of, Table) and of.words in ("words", "bytes"):
                shape = of.shape if of.shown is None else of.shown.shape
                if None not in shape:
                    per_word = 4 // cls.dtype_of(name).itemsize if of.words == "bytes" else 1
                    found[name] = _products(shape), per_word
        return found

    @classmethod
    def word_counts(cls, sizes: Mapping[str, int]) -> dict[str, int]:
        """Words of each of these tables."""
        return {
            name: -(-sum(_product(parts, sizes.__getitem__) for parts in products) // per_word)
            for name, (products, per_word) in cls.products().items()
        }

    @classmethod
    def _numbers_text(cls, name: str) -> str:
        """What of a table lies in words, where these are not its numbers one by one."""
        of = declared(cls, name)
        if of.words != "bytes":
            return "layers: " if of.words == "layers" else ""
        return "bytes: " if cls.dtype_of(name).itemsize == 1 else "16-bit numbers: "

    @classmethod
    def zeros(cls, sizes: Mapping[str, int], **known: object) -> Self:
        """Tables of zeros of these sizes, but for those that are known."""
        made = cls.of_parts(known)
        for name, of in cls.tables_in_files().items():
            if name not in known:
                made.put(name, np.zeros(of.extents(sizes), cls.dtype_of(name)))
        return made

    @classmethod
    def of_parts(cls, parts: Mapping[str, object]) -> Self:
        """Tables of which some fields are known, for those who `put` the others one by one."""
        made = cls.__new__(cls)
        for name, value in parts.items():
            made.put(name, value)
        return made

    def put(self, name: str, value: object) -> None:
        """Sets a field of tables that are being made; afterwards they do not change."""
        object.__setattr__(self, name, value)

    @classmethod
    def may_lack(cls, name: str) -> bool:
        """Whether files may lack a table."""
        # A type checker cannot see that subclasses are made dataclasses.
        return any(part.name == name and part.default is None for part in fields(cls))  # type: ignore[arg-type]

    def arrays(self) -> dict[str, Array]:
        """The arrays of files by their names there; those that are missing are left out."""
        held = {of.tensor or name: getattr(self, name) for name, of in self.tables_in_files().items()}
        return {name: array for name, array in held.items() if array is not None}

    def all_tables(self) -> dict[str, Array]:
        """All arrays by name: of files, and those that follow from them."""
        return {name: getattr(self, name) for name, of in self.declarations.items() if isinstance(of, Table)}

    def tables_with_words(self) -> dict[str, Array]:
        """Those of all arrays that shaders read."""
        return {name: array for name, array in self.all_tables().items() if declared(type(self), name).words}

    def settings(self) -> dict[str, float]:
        """The numbers of files beside arrays, and the version."""
        own = {name: getattr(self, name) for name in self.settings_in_files()}
        return own | ({VERSION_SETTING: self.version} if self.version else {})

    @property
    def nbytes(self) -> int:
        """Size of the arrays in a file."""
        return sum(array.nbytes for array in self.arrays().values())

    def upload(self, types: ArrayTypes) -> Any:
        """Flat Dr.Jit arrays of a backend by attribute, of the tables that a device has."""
        uploaded = {
            name: upload(getattr(types, of.device), getattr(self, name))
            for name, of in self.declarations.items()
            if isinstance(of, Table) and of.device
        }
        return SimpleNamespace(**uploaded)


def expected_shape(of: Table, tables: Tables, sizes: Mapping[str, int]) -> tuple[int | None, ...]:
    """Extents of a table, None where they depend on sizes that are not known yet.

    Args:
        tables: as far as they have been read.
        sizes: what is known beside them.
    """

    def known(name: str) -> int:
        return sizes[name] if name in sizes else int(getattr(tables, name))

    found: list[int | None] = []
    for extent in of.shape:
        try:
            found.append(None if extent is None else _value(extent, known))
        except AttributeError:
            found.append(None)
    return tuple(found)


def fault_of(name: str, tables: Tables) -> str:
    """What is wrong with the values of a table, the end of a sentence; "" where nothing is."""
    of, array = declared(type(tables), name), getattr(tables, name)
    for shared in tables.sizes().values():
        if shared.of == name and (fault := shared.fault(tables)):
            return fault
    if of.fault is not None and (fault := of.fault(array)):
        return f"is {fault}"
    if of.low is None and of.high is None:
        return ""
    low, high = (_bound(bound, tables) for bound in (of.low, of.high))
    wrong = (array < low) | (array > high)
    if of.beside is not None:
        wrong &= array != of.beside
    if not wrong.any():
        return ""
    given = f"is {array.tolist()}" if array.size <= 8 else f"holds {array[wrong][0]:g}"
    right = f"{low:g} to {high:g}" if of.high is not None else f"at least {low:g}"
    beside = "" if of.beside is None else f", or {of.beside:g}"
    return f"{given}: it should be {right}{' each' if array.size > 1 else ''}{beside}"


def declared(tables: type[Tables], name: str) -> Table:
    """The declaration of a table."""
    found = tables.declarations[name]
    assert isinstance(found, Table)
    return found


def shape_text(shape: Shape) -> str:
    """Extents as comments have them: "2 faces, rows, 4 · packs"."""
    return ", ".join("any" if extent is None else str(extent).replace("*", "·") for extent in shape)


def _declarations(tables: type[Tables]) -> Iterator[tuple[str, Declaration]]:
    """Declarations in the order of a class's body."""
    for name, value in vars(tables).items():
        found = getattr(value, "metadata", {}).get("declaration", value)
        if isinstance(found, _DECLARATIONS):
            yield name, found


_types_of: dict[type[Tables], dict[str, np.dtype[Any]]] = {}


def _dtypes(tables: type[Tables]) -> dict[str, np.dtype[Any]]:
    """Types of the numbers of tables by their names."""
    if tables not in _types_of:
        hints = get_type_hints(tables)
        for name, of in tables.declarations.items():
            if isinstance(of, Table) and of.make is not None:
                hints[name] = get_type_hints(of.make)["return"]
        found = {name: _dtype_of(hint) for name, hint in hints.items() if name in tables.declarations}
        _types_of[tables] = {name: kind for name, kind in found.items() if kind is not None}
    return _types_of[tables]


def _dtype_of(hint: object) -> np.dtype[Any] | None:
    """The type of an array's numbers, of the annotation `NDArray[np.uint8]`, or that or None."""
    for part in (hint, *get_args(hint)):
        if get_origin(part) is np.ndarray:
            return np.dtype(get_args(get_args(part)[1])[0])
    return None


def _bound(bound: Bound, tables: Tables) -> float:
    if isinstance(bound, str):
        return _value(bound, lambda name: getattr(tables, name))
    return np.nan if bound is None else bound


@cache
def _terms(extent: Extent) -> list[list[int | str]]:
    """An extent as a sum of products of names and whole numbers; labels of numbers are left out."""
    assert extent is not None
    labelled = _LABELLED.fullmatch(str(extent))
    text = str(extent) if labelled is None else labelled[1]
    return _sum_of_products(ast.parse(text, mode="eval").body)


def _names(extent: Extent) -> set[str]:
    """Names in an extent."""
    parts = [] if extent is None else [part for product in _terms(extent) for part in product]
    return {part for part in parts if isinstance(part, str)}


def _value(extent: Extent, of_name: Callable[[str], int]) -> int:
    """The number that an extent is."""
    return sum(_product(parts, of_name) for parts in _terms(extent))


def _product(parts: Sequence[int | str], of_name: Callable[[str], int]) -> int:
    return math.prod(of_name(part) if isinstance(part, str) else part for part in parts)


def _sum_of_products(node: ast.expr) -> list[list[int | str]]:
    """An expression of names, whole numbers, + , − and * as a sum of products."""
    match node:
        case ast.Constant(value=int(number)):
            return [[number]]
        case ast.Name(id=name):
            return [[name]]
        case ast.BinOp(left=left, op=ast.Add(), right=right):
            return [*_sum_of_products(left), *_sum_of_products(right)]
        case ast.BinOp(left=left, op=ast.Sub(), right=right):
            return [*_sum_of_products(left), *([-1, *parts] for parts in _sum_of_products(right))]
        case ast.BinOp(left=left, op=ast.Mult(), right=right):
            return [[*a, *b] for a in _sum_of_products(left) for b in _sum_of_products(right)]
    raise ValueError(f"an extent is made of names, numbers, +, - and *, not of {ast.unparse(node)}")


def _products(shape: Shape) -> list[list[int | str]]:
    """The number of entries of a shape, as a sum of products."""
    total: list[list[int | str]] = [[]]
    for extent in shape:
        total = [[*a, *b] for a in total for b in _terms(extent)]
    return total
