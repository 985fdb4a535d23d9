"""Code that answers many queries at once, written in LLVM's language: vectors with a lane for each query.

Arithmetic on `Lanes` reads as that of arrays, and `Code` has functions that numpy and Dr.Jit have, so that
formulas may be written once for all three. A function of such code answers block after block of queries;
whatever a block needs between its first number and its last lies in rows on the stack, near the core.
`machine_code` compiles and runs it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from copy import copy
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import numpy as np
from llvmlite import ir
from numpy.polynomial import Chebyshev, Polynomial
from numpy.typing import NDArray

from loomlight.core.lane_values import (
    BYTE,
    FLOAT,
    INDEX,
    TRUTH,
    WHOLE,
    LaneKind,
    Lanes,
    LaneTypes,
    SharedNumber,
    Table,
    leaves_of,
    with_leaves,
)

# Functions that run side by side take about so many queries at a time.
_QUERIES_AT_ONCE = 1024
_BYTES = 64  # of a line of the cache, which rows begin with
# Degrees that leave errors of single precision.
_LOGARITHM_DEGREE, _EXPONENTIAL_DEGREE, _ARC_TANGENT_DEGREE, _SINE_DEGREE = 9, 7, 9, 5
# ln 2 as a number of few digits and a rest, so that a multiple of it can be taken away exactly.
_LN2 = 0.693359375, math.log(2) - 0.693359375
_PI = 3.140625, math.pi - 3.140625


@dataclass(frozen=True)
class Vectors:
    """How code uses a processor's vectors.

    Attributes:
        lanes: numbers of a vector.
        registers: vectors that a core holds at once.
        of_block: vectors of a block of queries. Three keep every weight for three multiply-adds, and leave
            their sums room for eight outputs.
    """

    lanes: int
    registers: int
    of_block: int = 3

    @property
    def block(self) -> int:
        """Queries of a block."""
        return self.lanes * self.of_block

    @property
    def sums(self) -> int:
        """Outputs of a layer whose sums stay in registers, for all vectors of a block: a power of two, as
        layers' widths are multiples of one."""
        room = (self.registers - self.of_block - 1) // self.of_block
        return 1 << (room.bit_length() - 1)


class Rows:
    """Numbers of a block's queries on the stack, a row for each channel."""

    def __init__(self, code: Code, pointer: ir.Value) -> None:
        self._code, self.pointer = code, pointer

    def after(self, channel: int) -> Rows:
        """Rows without so many of the first."""
        return Rows(self._code, self.place(channel))

    def place(self, channel: Any) -> ir.Value:
        """Where a row begins."""
        return self._code.element(self.pointer, self._code.times(channel, self._code.vectors.block))

    def __getitem__(self, channel: Any) -> Lanes:
        """A channel of the vector at hand."""
        return self._code.load(self._code.element(self.place(channel), self._code.lane))

    def __setitem__(self, channel: Any, lanes: Any) -> None:
        self._code.store(self._code.number(lanes), self._code.element(self.place(channel), self._code.lane))


class Code:
    """A function of blocks of queries that is being written.

    It is given where blocks that are taken are counted, how many there are, and addresses of arrays of
    floats: a query's numbers lie in the first arrays, its answers are put into others, and what all queries
    share is in the rest.

    Attributes:
        vectors: of the processor.
        module: LLVM's; its one function of public linkage is `name`.
        builder: writes the next instruction.
        lane: of the vector at hand, the number of its first lane within the block.
    """

    def __init__(self, name: str, vectors: Vectors) -> None:
        self.name, self.vectors = name, vectors
        self.module = ir.Module(name)
        self._vector = ir.VectorType(FLOAT, vectors.lanes)
        self._wholes = ir.VectorType(WHOLE, vectors.lanes)
        pointers = FLOAT.as_pointer().as_pointer()
        kind = ir.FunctionType(ir.VoidType(), [INDEX.as_pointer(), INDEX, pointers])
        self._function = ir.Function(self.module, kind, name)
        self._entry = self._function.append_basic_block("entry")
        self.builder = ir.IRBuilder(self._entry)
        self._taken, self._end, self._addresses = self._function.args
        self.lane: Any = INDEX(0)
        self._block: Any = INDEX(0)
        self.types = LaneTypes(self)
        self._first_shared, self._numbers, self._tables = 0, 0, 0

    # Where code goes.

    @contextmanager
    def blocks(self) -> Iterator[None]:
        """Code for each block; the function is finished afterwards.

        Functions that run side by side take blocks from one count, a few at a time, until none is left.
        """
        start = self.builder.append_basic_block("blocks")
        self.builder.position_at_end(start)
        some, last = self.variable(INDEX), INDEX(max(1, _QUERIES_AT_ONCE // self.vectors.block))

        def is_more() -> ir.Value:
            first = self.builder.atomic_rmw("add", self._taken, last, "monotonic")
            self.builder.store(first, some)
            return self.builder.icmp_signed("<", first, self._end)

        with self.as_long_as(is_more):
            first = self.builder.load(some)
            rest = self.builder.sub(self._end, first)
            fewer = self.builder.icmp_signed("<", rest, last)
            with self.loop(self.builder.select(fewer, rest, last)) as number:
                self._block = self.times(self.builder.add(first, number), self.vectors.block)
                yield
        self.builder.ret_void()
        # All rows have been asked for.
        self.builder.position_at_end(self._entry)
        self.builder.branch(start)

    @contextmanager
    def loop(self, count: Any) -> Iterator[ir.Value]:
        """Code for each number from 0 to count − 1; at least for 0."""
        builder, before = self.builder, self.builder.block
        body = builder.append_basic_block("turn")
        builder.branch(body)
        builder.position_at_end(body)
        number = builder.phi(INDEX)
        number.add_incoming(INDEX(0), before)
        yield number
        following = builder.add(number, INDEX(1))
        number.add_incoming(following, builder.block)
        done = builder.append_basic_block("done")
        more = builder.icmp_signed("<", following, count if isinstance(count, ir.Value) else INDEX(count))
        builder.cbranch(more, body, done)
        builder.position_at_end(done)

    @contextmanager
    def as_long_as(self, condition: Callable[[], ir.Value]) -> Iterator[None]:
        """Code that is run again and again, as long as a condition holds before it."""
        head, inside, done = (self.builder.append_basic_block(name) for name in ("again", "turn", "done"))
        self.builder.branch(head)
        self.builder.position_at_end(head)
        self.builder.cbranch(condition(), inside, done)
        self.builder.position_at_end(inside)
        yield
        self.builder.branch(head)
        self.builder.position_at_end(done)

    @contextmanager
    def each_vector(self) -> Iterator[None]:
        """Code for each vector of the block."""
        with self.loop(self.vectors.of_block) as number:
            self.lane = self.times(number, self.vectors.lanes)
            yield
        self.lane = INDEX(0)

    @contextmanager
    def function(self, name: str, kinds: Sequence[ir.Type]) -> Iterator[Sequence[ir.Value]]:
        """Code of a function of its own; its arguments."""
        function = ir.Function(self.module, ir.FunctionType(ir.VoidType(), kinds), name)
        function.linkage = "private"
        function.attributes.add("noinline")
        outer, self.builder = self.builder, ir.IRBuilder(function.append_basic_block("entry"))
        yield function.args
        self.builder.ret_void()
        self.builder = outer

    def call(self, name: str, arguments: Sequence[ir.Value]) -> None:
        """Calls a function that `function` wrote."""
        self.builder.call(self.module.get_global(name), arguments)

    def has(self, name: str) -> bool:
        """Whether a function of that name is written."""
        return name in self.module.globals

    # Where numbers lie.

    def rows(self, count: int) -> Rows:
        """Rows on the stack, not yet filled."""
        return Rows(self, self.stack(count * self.vectors.block))

    def stack(self, count: int) -> ir.Value:
        """Room for so many floats on the stack."""
        with self.builder.goto_block(self._entry):
            room = self.builder.alloca(ir.ArrayType(FLOAT, count))
            room.align = max(_BYTES, 4 * self.vectors.lanes)
            return self.builder.bitcast(room, FLOAT.as_pointer())

    def array(self, number: Any) -> ir.Value:
        """Where an array begins."""
        return self._constant(self.builder.load(self.builder.gep(self._addresses, [self._index(number)])))

    def queries(self, number: Any) -> ir.Value:
        """Where the numbers of the vector at hand lie in an array of queries or answers."""
        return self.element(self.array(number), self.builder.add(self._block, self.lane))

    def first_query(self) -> ir.Value:
        """The number of the block's first query: an index."""
        return self._block

    def given(self, number: Any) -> Lanes:
        """What an array holds for the queries at hand."""
        return self.load(self.queries(number), align=4)

    def answer(self, number: Any, lanes: Any) -> None:
        """Puts the answers to the queries at hand into an array."""
        self.store(self.number(lanes), self.queries(number), align=4)

    def variable(self, kind: ir.Type) -> ir.Value:
        """Room for one number on the stack."""
        with self.builder.goto_block(self._entry):
            return self.builder.alloca(kind)

    def element(self, pointer: ir.Value, number: Any) -> ir.Value:
        """Where an element of an array lies."""
        return self.builder.gep(pointer, [self._index(number)])

    def load(self, pointer: ir.Value, align: int | None = None) -> Lanes:
        """A vector from memory, with its first lane there."""
        found = self.builder.load(self.builder.bitcast(pointer, self._vector.as_pointer()))
        found.align = align or 4 * self.vectors.lanes
        return Lanes(self, found)

    def sum_of_bytes(self, pointer: ir.Value, numbers: Sequence[Any]) -> Lanes:
        """Sums of bytes of an array, those of each of some numbers: of the first lane, the others follow."""
        kind = ir.VectorType(BYTE, self.vectors.lanes).as_pointer()
        total: Any = None
        for number in numbers:
            place = self.builder.gep(self._bytes(pointer), [self._index(number)])
            found = self.builder.load(self.builder.bitcast(place, kind))
            found.align = 1
            wide = self.builder.zext(found, self._wholes)
            total = wide if total is None else self.builder.add(total, wide)
        return Lanes(self, self.builder.sitofp(total, self._vector))

    def byte(self, pointer: ir.Value, number: Any) -> ir.Value:
        """A byte of an array, a whole number."""
        place = self.builder.gep(self._bytes(pointer), [self._index(number)])
        return self.builder.zext(self.builder.load(place), WHOLE)

    def _bytes(self, pointer: ir.Value) -> ir.Value:
        return self.builder.bitcast(pointer, BYTE.as_pointer())

    def store_whole(self, lanes: Lanes, factor: int, pointer: ir.Value) -> None:
        """Puts multiples of whole numbers into memory, for `whole_at`."""
        whole = self.builder.fptosi(lanes.value, self._wholes)
        multiple = self.builder.mul(whole, self._wholes_of(factor))
        self.store(Lanes(self, self.builder.bitcast(multiple, self._vector)), pointer)

    def whole_at(self, pointer: ir.Value, number: Any) -> ir.Value:
        """The number of an element that `store_whole` put there."""
        place = self.builder.bitcast(self.element(pointer, number), WHOLE.as_pointer())
        return self.builder.sext(self.builder.load(place), INDEX)

    def looked_up(self, pointer: ir.Value, width: int, count: ir.Value, row: Lanes) -> list[Lanes]:
        """Of a small table in memory, the row of each lane.

        Args:
            width: of rows.
            count: of rows; all are looked at.
            row: whole numbers.
        """
        start, before = self.number(0), self.builder.block
        with self.loop(count) as number:
            held = [self.builder.phi(start.value.type) for _ in range(width)]
            for part in held:
                part.add_incoming(start.value, before)
            turn = self.counted(number)
            here = (row >= turn) & (row < turn + 1.0)
            own = self.element(pointer, self.times(number, width))
            found = [self.select(here, self.shared(own, k), Lanes(self, part)) for k, part in enumerate(held)]
            for part, value in zip(held, found, strict=True):
                part.add_incoming(value.value, self.builder.block)
        return found

    def store(self, lanes: Lanes, pointer: ir.Value, align: int | None = None) -> None:
        """Puts a vector into memory."""
        place = self.builder.bitcast(pointer, self._vector.as_pointer())
        self.builder.store(lanes.value, place).align = align or 4 * self.vectors.lanes

    def shared(self, pointer: ir.Value, number: Any) -> Lanes:
        """An element of an array in all lanes."""
        return self.spread(self.builder.load(self.element(pointer, number)))

    # What all queries share, as formulas for arrays ask for it.

    def shares(self, first: int) -> None:
        """From this array on lie the numbers and then the tables of `SharedNumbers`."""
        self._first_shared, self._numbers, self._tables = first, 0, 0

    def shared_number(self, number: float) -> Lanes:
        """The next number, whatever it is."""
        del number
        self._numbers += 1
        return SharedNumber(self, (self._first_shared, self._numbers - 1))

    def shared_table(self, values: NDArray[Any], kind: ir.Type) -> Table:
        """The next table, whatever is in it."""
        del values
        self._tables += 1
        return Table(kind, self._first_shared + self._tables)

    def gather(self, kind: LaneKind, table: Table, index: Lanes) -> Any:
        """Elements of a table; of a kind that is several numbers a row of them each, as a list."""
        pointer = self.array(table.array)
        if kind.count == 1:
            return self.gathered_from(pointer, index, kind.element)
        pairs = [index if kind.count == 2 else index * (kind.count // 2) + k for k in range(kind.count // 2)]
        return [half for pair in pairs for half in self._pair(pointer, pair, kind.element)]

    def _pair(self, pointer: ir.Value, index: Lanes, kind: ir.Type) -> list[Lanes]:
        """Two neighbours, fetched as one: a number of 64 bits takes as long as one of 32."""
        lanes = self.vectors.lanes
        wide = ir.VectorType(INDEX, lanes)
        places = self._places(self.builder.bitcast(pointer, INDEX.as_pointer()), index)
        every, nothing = self.constant(True, TRUTH), ir.Constant(wide, ir.Undefined)
        full = f"llvm.masked.gather.v{lanes}i64.v{lanes}p0"
        function = self._declared(full, wide, [places.type, WHOLE, every.type, wide])
        both = self.builder.call(function, [places, WHOLE(4), every, nothing])
        upper = self.builder.lshr(both, ir.Constant(wide, [32] * lanes))
        halves = [Lanes(self, self.builder.trunc(part, self._wholes)) for part in (both, upper)]
        return [self.as_kind(self.as_floats(half), kind) for half in halves]

    def gathered_from(self, pointer: ir.Value, index: Lanes, kind: ir.Type = FLOAT) -> Lanes:
        """Elements of an array in memory."""
        vector = self._vector if kind == FLOAT else self._wholes
        places = self._places(pointer, index)
        every = self.constant(True, TRUTH)
        lanes, letter = self.vectors.lanes, "f" if kind == FLOAT else "i"
        full = f"llvm.masked.gather.v{lanes}{letter}32.v{lanes}p0"
        function = self._declared(full, vector, [places.type, WHOLE, every.type, vector])
        nothing = ir.Constant(vector, ir.Undefined)
        return Lanes(self, self.builder.call(function, [places, WHOLE(4), every, nothing]))

    def scatter_to(self, pointer: ir.Value, index: Lanes, lanes: Lanes, where: Lanes) -> None:
        """Puts numbers into elements of an array in memory, which must differ."""
        places = self._places(pointer, index)
        full = f"llvm.masked.scatter.v{self.vectors.lanes}f32.v{self.vectors.lanes}p0"
        kinds = [self._vector, places.type, WHOLE, where.value.type]
        function = self._declared(full, ir.VoidType(), kinds)
        self.builder.call(function, [lanes.value, places, WHOLE(4), where.value])

    def _places(self, pointer: ir.Value, index: Lanes) -> ir.Value:
        """Where elements lie: a vector of pointers, which the builder does not know how to make."""
        made = ir.instructions.GEPInstr(self.builder.block, pointer, [WHOLE(0)], False, "")
        made.operands = [pointer, index.value]
        made.indices = [index.value]
        made.type = ir.VectorType(pointer.type, self.vectors.lanes)
        self.builder._insert(made)
        return made

    def _declared(self, name: str, result: ir.Type, kinds: Sequence[ir.Type]) -> ir.Function:
        function = self.module.globals.get(name)
        return function or ir.Function(self.module, ir.FunctionType(result, kinds), name)

    def _constant(self, load: ir.Value) -> ir.Value:
        """A load of what nothing here changes."""
        load.set_metadata("invariant.load", self.module.add_metadata([]))
        return load

    # Lanes together.

    def count_of(self, chosen: Lanes) -> ir.Value:
        """In how many lanes something is true: an index."""
        bits = self.builder.bitcast(chosen.value, ir.IntType(self.vectors.lanes))
        wide = self.builder.zext(bits, INDEX)
        return self.builder.call(self._declared("llvm.ctpop.i64", INDEX, [INDEX]), [wide])

    def is_anywhere(self, chosen: Lanes) -> ir.Value:
        """Whether something is true in any lane."""
        bits = self.builder.bitcast(chosen.value, ir.IntType(self.vectors.lanes))
        return self.builder.icmp_unsigned("!=", bits, bits.type(0))

    def total(self, lanes: Lanes) -> ir.Value:
        """Sum over lanes: a float."""
        name = f"llvm.vector.reduce.fadd.v{self.vectors.lanes}f32"
        function = self._declared(name, FLOAT, [FLOAT, self._vector])
        # In pairs, not one after another.
        return self.builder.call(function, [FLOAT(0.0), lanes.value], fastmath=("reassoc",))

    def first(self, lanes: Lanes) -> ir.Value:
        """The number in the first lane: a float."""
        return self.builder.extract_element(lanes.value, WHOLE(0))

    def compress(self, lanes: Lanes, chosen: Lanes, pointer: ir.Value) -> None:
        """Puts chosen lanes into memory, one after another."""
        full = f"llvm.masked.compressstore.v{self.vectors.lanes}f32"
        kinds = [self._vector, FLOAT.as_pointer(), chosen.value.type]
        function = self._declared(full, ir.VoidType(), kinds)
        self.builder.call(function, [self.as_floats(lanes).value, pointer, chosen.value])

    def as_floats(self, lanes: Lanes) -> Lanes:
        """The bits of numbers, told to be floats."""
        return lanes if lanes.kind == FLOAT else Lanes(self, self.builder.bitcast(lanes.value, self._vector))

    def as_kind(self, floats: Lanes, kind: ir.Type) -> Lanes:
        """What `as_floats` was told."""
        return (
            floats if kind == FLOAT else Lanes(self, self.builder.bitcast(floats.value, self._of_kind(kind)))
        )

    def in_all_lanes(self, number: ir.Value) -> Lanes:
        """An index as a whole number in all lanes."""
        nowhere = ir.Constant(self._wholes, ir.Undefined)
        one = self.builder.insert_element(nowhere, self.builder.trunc(number, WHOLE), WHOLE(0))
        return Lanes(self, self.builder.shuffle_vector(one, nowhere, self._lanes([0] * self.vectors.lanes)))

    def numbered(self, first: ir.Value) -> Lanes:
        """Whole numbers from one on, lane by lane."""
        return self.in_all_lanes(first) + Lanes(self, self._lanes(list(range(self.vectors.lanes))))

    # Work that goes on lane by lane, as Dr.Jit has it.

    def while_loop(self, state: Any, condition: Callable[..., Lanes], body: Callable[..., Any]) -> Any:
        """State, a tuple of trees of lanes, changed by `body` as long as a condition holds, lane by lane."""
        leaves = [self.as_lanes(leaf) for leaf in leaves_of(state)]
        before = self.builder.block
        head, inside, done = (self.builder.append_basic_block(name) for name in ("while", "body", "left"))
        values = [leaf.value for leaf in leaves]
        self.builder.branch(head)
        self.builder.position_at_end(head)
        held = []
        for value in values:
            phi = self.builder.phi(value.type)
            phi.add_incoming(value, before)
            held.append(phi)
        now = with_leaves(state, iter([Lanes(self, phi) for phi in held]))
        active = condition(*now)
        self.builder.cbranch(self.is_anywhere(active), inside, done)
        self.builder.position_at_end(inside)
        for phi, leaf, old in zip(held, leaves_of(body(*now)), leaves_of(now), strict=True):
            kept = self.as_lanes(leaf, old.kind)
            # Shared numbers are read here, not where they are asked for.
            phi.add_incoming(self.select(active, kept, old).value, self.builder.block)
        self.builder.branch(head)
        self.builder.position_at_end(done)
        return now

    def masked_branch(self, active: Lanes, value: Any, change: Callable[[Any], Any]) -> Any:
        """`change(value)` in active lanes, `value` in others, and no time where there are none."""
        leaves = [self.as_lanes(leaf) for leaf in leaves_of(value)]
        values, before = [leaf.value for leaf in leaves], self.builder.block
        inside, done = (self.builder.append_basic_block(name) for name in ("change", "changed"))
        self.builder.cbranch(self.is_anywhere(active), inside, done)
        self.builder.position_at_end(inside)
        changed = [
            self.select(active, self.as_lanes(leaf, old.kind), old).value
            for leaf, old in zip(leaves_of(change(value)), leaves, strict=True)
        ]
        last = self.builder.block
        self.builder.branch(done)
        self.builder.position_at_end(done)
        found = []
        for old, new in zip(values, changed, strict=True):
            phi = self.builder.phi(old.type)
            phi.add_incoming(old, before)
            phi.add_incoming(new, last)
            found.append(Lanes(self, phi))
        return with_leaves(value, iter(found))

    def as_lanes(self, leaf: Any, kind: ir.Type = FLOAT) -> Lanes:
        """Lanes; a number of Python's in all of them."""
        return leaf if isinstance(leaf, Lanes) else Lanes(self, self.constant(leaf, kind))

    def spread(self, value: ir.Value) -> Lanes:
        """A number in all lanes."""
        nowhere = ir.Constant(self._vector, ir.Undefined)
        one = self.builder.insert_element(nowhere, value, WHOLE(0))
        return Lanes(self, self.builder.shuffle_vector(one, nowhere, self._lanes([0] * self.vectors.lanes)))

    def counted(self, number: ir.Value) -> Lanes:
        """A turn of a loop, or a number of turns, in all lanes."""
        return self.spread(self.builder.uitofp(number, FLOAT))

    def anywhere(self, row: Rows) -> ir.Value:
        """Whether a row of the block is above 0 anywhere."""
        found: ir.Value = ir.IntType(1)(0)
        for number in range(self.vectors.of_block):
            place = self.element(row.pointer, number * self.vectors.lanes)
            found = self.builder.or_(found, self.is_anywhere(self.load(place) > 0))
        return found

    def transposed(self, lines: Sequence[Lanes]) -> list[Lanes]:
        """Of as many vectors as they have lanes, those whose lanes are the vectors."""
        half, lanes = self.vectors.lanes // 2, self.vectors.lanes
        low = self._lanes([lane // 2 + lanes * (lane % 2) for lane in range(lanes)])
        high = self._lanes([lane // 2 + half + lanes * (lane % 2) for lane in range(lanes)])
        found = [line.value for line in lines]
        for _ in range(lanes.bit_length() - 1):
            found = [
                self.builder.shuffle_vector(found[number // 2], found[number // 2 + half], order)
                for number, order in ((k, high if k % 2 else low) for k in range(lanes))
            ]
        return [Lanes(self, value) for value in found]

    # Two vectors side by side, of which one is worked at while the other waits for a result.

    def doubled(self) -> Code:
        """This code, written with vectors of twice as many lanes."""
        twice = copy(self)
        twice.vectors = replace(self.vectors, lanes=2 * self.vectors.lanes)
        twice._vector, twice._wholes = (twice._of_kind(kind) for kind in (FLOAT, WHOLE))
        return twice

    def joined(self, first: Lanes, second: Lanes) -> Lanes:
        """Of two vectors of half as many lanes one."""
        order = self._lanes(list(range(self.vectors.lanes)))
        return Lanes(self, self.builder.shuffle_vector(first.value, second.value, order))

    def halves(self, lanes: Lanes) -> list[Lanes]:
        """The two vectors that were `joined` in a code of twice as many lanes."""
        count = self.vectors.lanes
        orders = (self._lanes(list(range(first, first + count))) for first in (0, count))
        value = lanes.value
        return [Lanes(self, self.builder.shuffle_vector(value, value, order)) for order in orders]

    # What may be done with numbers, as modules of arrays have it.

    def number(self, value: Any) -> Lanes:
        """A number of Python's, in all lanes; lanes as they are."""
        return value if isinstance(value, Lanes) else Lanes(self, self.constant(value, FLOAT))

    def constant(self, value: Any, kind: ir.Type) -> ir.Value:
        """A number of Python's in all lanes, as LLVM has it; of lanes their value."""
        if isinstance(value, Lanes):
            return value.value
        one = float(np.float32(value)) if kind == FLOAT else int(value)
        return ir.Constant(self._of_kind(kind), [one] * self.vectors.lanes)

    def _of_kind(self, kind: ir.Type) -> ir.Type:
        return ir.VectorType(kind, self.vectors.lanes)

    def converted(self, value: Any, kind: ir.Type) -> Lanes:
        """Lanes of a kind: of floats the whole part, of whole numbers the floats that they are."""
        if not isinstance(value, Lanes):
            return Lanes(self, self.constant(value, kind))
        own = value.value
        if own.type.element == kind:
            return value
        convert = self.builder.fptosi if kind == WHOLE else self.builder.sitofp
        return Lanes(self, convert(own, self._of_kind(kind)))

    def fma(self, a: Any, b: Any, c: Any) -> Lanes:
        """a b + c, rounded once."""
        return self._intrinsic("fma", a, b, c)

    def sqrt(self, value: Any) -> Lanes:
        """Square root of a number that is not negative; 0 below 1e-30."""
        # Of reciprocals of roots there are estimates, which take a fifth of the time.
        value = self.number(value)
        return value * self.rsqrt(self.maximum(value, 1e-30))

    def floor(self, value: Any) -> Lanes:
        """The next whole number below."""
        return self._intrinsic("floor", value)

    def round(self, value: Any) -> Lanes:
        """The nearest whole number."""
        return self._intrinsic("rint", value)

    def abs(self, value: Any) -> Lanes:
        """Magnitude."""
        return self._intrinsic("fabs", value)

    def square(self, value: Any) -> Lanes:
        """Square."""
        return self.number(value) * value

    def rcp(self, value: Any) -> Lanes:
        """Reciprocal."""
        return 1.0 / self.number(value)

    def rsqrt(self, value: Any) -> Lanes:
        """Reciprocal of a square root."""
        return 1.0 / self._intrinsic("sqrt", value)

    def select(self, chosen: Lanes, first: Any, second: Any) -> Lanes:
        """One number where something is true, another where it is not."""
        known = next((value.kind for value in (first, second) if isinstance(value, Lanes)), FLOAT)
        if known == TRUTH:
            return (chosen & first) | (~chosen & second)
        values = self.constant(first, known), self.constant(second, known)
        return Lanes(self, self.builder.select(chosen.value, *values))

    def maximum(self, first: Any, second: Any) -> Lanes:
        """The larger one; the second where either is no number."""
        return self.select(self.number(first) > second, first, second)

    def minimum(self, first: Any, second: Any) -> Lanes:
        """The smaller one; the second where either is no number."""
        return self.select(self.number(first) < second, first, second)

    def clip(self, value: Any, low: Any, high: Any) -> Lanes:
        """Brought into a range; `low` where it is no number."""
        return self.minimum(self.maximum(value, low), high)

    def log2(self, value: Any) -> Lanes:
        """Binary logarithm of a positive number that is not subnormal."""
        bits = self.builder.bitcast(self.number(value).value, self._wholes)
        # From 1/√2 to √2, and a power of two.
        root = self._wholes_of(int(np.float32(math.sqrt(0.5)).view(np.int32)))
        power = self.builder.ashr(self.builder.sub(bits, root), self._wholes_of(23))
        near_one = self.builder.sub(bits, self.builder.shl(power, self._wholes_of(23)))
        less_one = Lanes(self, self.builder.bitcast(near_one, self._vector)) - 1.0
        share = self._polynomial(_logarithm(), less_one)
        return self.fma(less_one, share, Lanes(self, self.builder.sitofp(power, self._vector)))

    def log(self, value: Any) -> Lanes:
        """Natural logarithm of a positive number that is not subnormal."""
        return math.log(2) * self.log2(value)

    def exp(self, value: Any) -> Lanes:
        """Exponential of a number between −87 and 88."""
        value = self.clip(value, -87.0, 88.0)
        power = self.round(value * (1 / math.log(2)))
        rest = self.fma(power, -_LN2[1], self.fma(power, -_LN2[0], value))
        found = self._polynomial(_exponential(), rest)
        whole = self.builder.fptosi(power.value, self._wholes)
        raised = self.builder.add(
            self.builder.bitcast(found.value, self._wholes), self.builder.shl(whole, self._wholes_of(23))
        )
        return Lanes(self, self.builder.bitcast(raised, self._vector))

    def atan2(self, y: Any, x: Any) -> Lanes:
        """Angle of a vector with the x axis, −π to π; 0 where it has no length."""
        across, along = self.abs(x), self.abs(y)
        ratio = self.minimum(across, along) / self.maximum(self.maximum(across, along), 1e-30)
        angle = ratio * self._polynomial(_arc_tangent(), ratio * ratio)
        angle = self.select(along > across, 0.5 * math.pi - angle, angle)
        angle = self.select(self.number(x) < 0, math.pi - angle, angle)
        return self.select(self.number(y) < 0, -angle, angle)

    def sincos(self, angle: Any) -> tuple[Lanes, Lanes]:
        """Sine and cosine of an angle of a few turns at the most."""
        turns = self.round(angle * (1 / math.pi))
        rest = self.fma(turns, -_PI[1], self.fma(turns, -_PI[0], angle))
        odd = turns - 2 * self.floor(0.5 * turns) > 0.5
        sign, square = self.select(odd, -1.0, 1.0), rest * rest
        return sign * rest * self._polynomial(_sine(), square), sign * self._polynomial(_cosine(), square)

    def asin(self, value: Any) -> Lanes:
        """Arc sine of −1 to 1."""
        return self.atan2(value, self.sqrt(self.maximum(self.fma(-value, value, 1), 0)))

    # Numbers of arrays.

    def times(self, number: Any, factor: int) -> Any:
        """A multiple of a number of an array's element."""
        if isinstance(number, ir.Value) and not isinstance(number, ir.Constant):
            return self.builder.mul(number, INDEX(factor))
        return INDEX(int(getattr(number, "constant", number)) * factor)

    def whole(self, value: ir.Value) -> ir.Value:
        """The number of an element that a float holds."""
        return self.builder.fptosi(value, INDEX)

    def _index(self, number: Any) -> ir.Value:
        return number if isinstance(number, ir.Value) else INDEX(number)

    def _polynomial(self, coefficients: tuple[float, ...], value: Lanes) -> Lanes:
        found = self.number(coefficients[-1])
        for coefficient in reversed(coefficients[:-1]):
            found = self.fma(found, value, coefficient)
        return found

    def _intrinsic(self, name: str, *values: Any) -> Lanes:
        function = self._declared(
            f"llvm.{name}.v{self.vectors.lanes}f32", self._vector, [self._vector] * len(values)
        )
        arguments = [self.number(value).value for value in values]
        return Lanes(self, self.builder.call(function, arguments))

    def _lanes(self, numbers: Sequence[int]) -> ir.Constant:
        return ir.Constant(self._wholes, list(numbers))

    def _wholes_of(self, number: int) -> ir.Constant:
        return self._lanes([number] * self.vectors.lanes)


@cache
def _logarithm() -> tuple[float, ...]:
    """Of log2(1 + t)/t."""
    return _fitted(
        lambda t: np.log1p(t) / (t * math.log(2)), math.sqrt(0.5) - 1, math.sqrt(2) - 1, _LOGARITHM_DEGREE
    )


@cache
def _exponential() -> tuple[float, ...]:
    """Of e^t."""
    return _fitted(np.exp, -0.51 * math.log(2), 0.51 * math.log(2), _EXPONENTIAL_DEGREE)


@cache
def _arc_tangent() -> tuple[float, ...]:
    """Of atan(√t)/√t."""
    return _fitted(lambda t: np.arctan(np.sqrt(t)) / np.sqrt(t), 0.0, 1.0, _ARC_TANGENT_DEGREE)


@cache
def _sine() -> tuple[float, ...]:
    """Of sin(√t)/√t, up to a right angle."""
    return _fitted(lambda t: np.sinc(np.sqrt(t) / math.pi), 0.0, (0.5 * math.pi) ** 2, _SINE_DEGREE)


@cache
def _cosine() -> tuple[float, ...]:
    """Of cos √t, up to a right angle."""
    return _fitted(lambda t: np.cos(np.sqrt(t)), 0.0, (0.5 * math.pi) ** 2, _SINE_DEGREE)


def _fitted(function: Callable[[Any], Any], low: float, high: float, degree: int) -> tuple[float, ...]:
    """Coefficients of a polynomial that is a function to within rounding, lowest power first."""
    fitted: Any = Chebyshev.interpolate(function, degree, [low, high])
    return tuple(fitted.convert(kind=Polynomial).coef.tolist())
