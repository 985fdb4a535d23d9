"""Emits LLVM IR of SIMD kernels: one lane per query, a few vectors of lanes per block.

A kernel has a signature like a shader's: per-query inputs, per-query outputs, and uniform buffers that all
queries read. It takes block after block of queries; what a block needs between its inputs and its outputs
lies in buffers on the stack, which stay in the nearest cache. `jit.CompiledKernel` compiles and launches it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass

import numpy as np
from llvmlite import ir

from loomlight.core.simd.math import SimdMath
from loomlight.core.simd.values import FLOAT, INDEX, INT32, MASK, Index, Operand, SimdValue, UniformBuffer

# A thread takes about so many queries at a time from the common counter.
_QUERIES_PER_GRAB = 1024
_CACHE_LINE = 64  # bytes


@dataclass(frozen=True)
class SimdTarget:
    """The shape of kernels on the vector unit of a processor.

    Attributes:
        width: lanes of a vector.
        registers: vector registers of a core.
        vectors_per_block: vectors of a block of queries. With three, each weight that is loaded is used by
            three multiply-adds, and registers remain for the sums of up to nine outputs.
    """

    width: int
    registers: int
    vectors_per_block: int = 3

    @property
    def block_size(self) -> int:
        """Queries of a block."""
        return self.width * self.vectors_per_block

    @property
    def max_tile(self) -> int:
        """Most outputs of a dense layer whose sums fit in registers, beside a block's inputs and a weight."""
        return max(1, (self.registers - self.vectors_per_block - 1) // self.vectors_per_block)


class BlockBuffer:
    """Channels of a block of queries on the stack: FLOAT [channels, block_size].

    Attributes:
        pointer: address of the first number.
    """

    def __init__(self, kernel: KernelBuilder, pointer: ir.Value, channels: int) -> None:
        self._kernel, self.pointer, self.channels = kernel, pointer, channels

    def channel_pointer(self, channel: Index) -> ir.Value:
        """Address of a channel of the block's first query."""
        kernel = self._kernel
        return kernel.element_pointer(self.pointer, kernel.multiply(channel, kernel.target.block_size))

    def __getitem__(self, channel: Index) -> SimdValue:
        """A channel of the current vector."""
        kernel = self._kernel
        return kernel.load(kernel.element_pointer(self.channel_pointer(channel), kernel.lane_index))

    def __setitem__(self, channel: Index, value: Operand) -> None:
        kernel = self._kernel
        kernel.store(value, kernel.element_pointer(self.channel_pointer(channel), kernel.lane_index))


class KernelBuilder:
    """A kernel under construction.

    Attributes:
        name: of the only public function of `module`.
        target: widths and registers.
        inputs, outputs: how many numbers a query has and how many it gets.
        module: the LLVM module.
        ir: the llvmlite builder, at the next instruction.
        math: elementary functions.
        lane_index: within `each_vector`, the first lane of the current vector, counted within the block.
    """

    def __init__(self, name: str, target: SimdTarget, inputs: int, outputs: int) -> None:
        self.name, self.target, self.inputs, self.outputs = name, target, inputs, outputs
        self.module = ir.Module(name)
        self.math = SimdMath(self)
        arrays = FLOAT.as_pointer().as_pointer()
        signature = ir.FunctionType(ir.VoidType(), [INDEX.as_pointer(), INDEX, arrays])
        function = ir.Function(self.module, signature, name)
        self._next_block, self._block_count, self._arrays = function.args
        self._entry = function.append_basic_block("entry")
        self.ir = ir.IRBuilder(self._entry)
        self.lane_index: Index = 0
        self._first_query: Index = 0

    # Control flow.

    @contextmanager
    def each_block(self) -> Iterator[None]:
        """The body of the kernel, run for every block of queries; the kernel is complete afterwards.

        Threads that run the kernel side by side take blocks from one atomic counter.
        """
        start = self.ir.append_basic_block("blocks")
        self.ir.position_at_end(start)
        grab = INDEX(max(1, _QUERIES_PER_GRAB // self.target.block_size))
        head, body, done = (self.ir.append_basic_block(name) for name in ("grab", "grabbed", "finished"))
        self.ir.branch(head)
        self.ir.position_at_end(head)
        first = self.ir.atomic_rmw("add", self._next_block, grab, "monotonic")
        self.ir.cbranch(self.ir.icmp_signed("<", first, self._block_count), body, done)
        self.ir.position_at_end(body)
        rest = self.ir.sub(self._block_count, first)
        count = self.ir.select(self.ir.icmp_signed("<", rest, grab), rest, grab)
        with self.loop(count) as number:
            self._first_query = self.multiply(self.ir.add(first, number), self.target.block_size)
            yield
        self.ir.branch(head)
        self.ir.position_at_end(done)
        self.ir.ret_void()
        # By now the entry block allocates all buffers.
        self.ir.position_at_end(self._entry)
        self.ir.branch(start)

    @contextmanager
    def loop(self, count: Index) -> Iterator[ir.Value]:
        """A loop over 0 … count − 1 (INDEX); the body runs at least once."""
        before = self.ir.block
        body = self.ir.append_basic_block("loop")
        self.ir.branch(body)
        self.ir.position_at_end(body)
        number = self.ir.phi(INDEX)
        number.add_incoming(INDEX(0), before)
        yield number
        following = self.ir.add(number, INDEX(1))
        number.add_incoming(following, self.ir.block)
        done = self.ir.append_basic_block("done")
        self.ir.cbranch(self.ir.icmp_signed("<", following, self.index(count)), body, done)
        self.ir.position_at_end(done)

    @contextmanager
    def each_vector(self) -> Iterator[None]:
        """A loop over the vectors of the block."""
        with self.loop(self.target.vectors_per_block) as number:
            self.lane_index = self.multiply(number, self.target.width)
            yield
        self.lane_index = 0

    def call(self, name: str, body: Callable[..., None], *arguments: ir.Value) -> None:
        """Calls a private function of the kernel; `body` emits it from its parameters at the first call."""
        function = self.module.globals.get(name)
        if function is None:
            types = [argument.type for argument in arguments]
            function = ir.Function(self.module, ir.FunctionType(ir.VoidType(), types), name)
            function.linkage = "private"
            function.attributes.add("noinline")
            caller, self.ir = self.ir, ir.IRBuilder(function.append_basic_block("entry"))
            body(*function.args)
            self.ir.ret_void()
            self.ir = caller
        self.ir.call(function, arguments)

    # Inputs, outputs, uniforms.

    def load_input(self, number: Index) -> SimdValue:
        """An input of the queries of the current vector."""
        return self.load(self._query_pointer(number), align=4)

    def store_output(self, number: Index, value: Operand) -> None:
        """Writes an output of the queries of the current vector."""
        if isinstance(number, ir.Value):
            number = self.ir.add(number, INDEX(self.inputs))
        else:
            number += self.inputs
        self.store(value, self._query_pointer(number), align=4)

    def uniform_buffer(self, number: int) -> UniformBuffer:
        """The buffer of that place in the uniforms of a launch."""
        return UniformBuffer(self, number)

    def uniform_pointer(self, number: int) -> ir.Value:
        """Address of a uniform buffer."""
        return self._array_pointer(self.inputs + self.outputs + number)

    def _query_pointer(self, number: Index) -> ir.Value:
        first = self.ir.add(self.index(self._first_query), self.index(self.lane_index))
        return self.element_pointer(self._array_pointer(number), first)

    def _array_pointer(self, number: Index) -> ir.Value:
        pointer = self.ir.load(self.element_pointer(self._arrays, number))
        # Nothing in a kernel writes to the list of arrays.
        pointer.set_metadata("invariant.load", self.module.add_metadata([]))
        return pointer

    # Memory.

    def block_buffer(self, channels: int) -> BlockBuffer:
        """An uninitialised buffer on the stack."""
        return BlockBuffer(self, self.stack_floats(channels * self.target.block_size), channels)

    def stack_floats(self, count: int) -> ir.Value:
        """Address of so many uninitialised floats on the stack, aligned to cache lines."""
        with self.ir.goto_block(self._entry):
            room = self.ir.alloca(ir.ArrayType(FLOAT, count))
            room.align = max(_CACHE_LINE, 4 * self.target.width)
            return self.ir.bitcast(room, FLOAT.as_pointer())

    def element_pointer(self, pointer: ir.Value, number: Index) -> ir.Value:
        """Address of an element of an array."""
        return self.ir.gep(pointer, [self.index(number)])

    def load(self, pointer: ir.Value, align: int | None = None) -> SimdValue:
        """Consecutive floats, one per lane; aligned to a whole vector, or to `align` bytes."""
        loaded = self.ir.load(self.ir.bitcast(pointer, self.vector_type(FLOAT).as_pointer()))
        loaded.align = align or 4 * self.target.width
        return SimdValue(self, loaded)

    def store(self, value: Operand, pointer: ir.Value, align: int | None = None) -> None:
        """Writes one float per lane; see `load`."""
        place = self.ir.bitcast(pointer, self.vector_type(FLOAT).as_pointer())
        self.ir.store(self.constant(value, FLOAT), place).align = align or 4 * self.target.width

    def load_broadcast(self, pointer: ir.Value, number: Index) -> SimdValue:
        """An element of an array, in all lanes."""
        return self.broadcast(self.ir.load(self.element_pointer(pointer, number)))

    def load_index(self, pointer: ir.Value, number: Index) -> ir.Value:
        """An element of an array that holds whole floats, as INDEX."""
        return self.ir.fptosi(self.ir.load(self.element_pointer(pointer, number)), INDEX)

    def table_rows(self, pointer: ir.Value, width: int, count: ir.Value, row: SimdValue) -> list[SimdValue]:
        """Row `row` (whole floats) of a small table [count, width], per lane; every row is compared."""
        start, before, math = self.varying(0), self.ir.block, self.math
        with self.loop(count) as number:
            columns = [self.ir.phi(start.value.type) for _ in range(width)]
            for column in columns:
                column.add_incoming(start.value, before)
            current = self.broadcast_index(number)
            here = (row >= current) & (row < current + 1.0)
            table_row = self.element_pointer(pointer, self.multiply(number, width))
            found = [
                math.select(here, self.load_broadcast(table_row, k), SimdValue(self, column))
                for k, column in enumerate(columns)
            ]
            for column, value in zip(columns, found, strict=True):
                column.add_incoming(value.value, self.ir.block)
        return found

    # Operations across lanes.

    def broadcast(self, value: ir.Value) -> SimdValue:
        """A scalar float in all lanes."""
        undefined = ir.Constant(self.vector_type(FLOAT), ir.Undefined)
        first = self.ir.insert_element(undefined, value, INT32(0))
        return self._shuffle(first, undefined, [0] * self.target.width)

    def broadcast_index(self, number: ir.Value) -> SimdValue:
        """An INDEX in all lanes, as floats."""
        return self.broadcast(self.ir.uitofp(number, FLOAT))

    def any(self, mask: SimdValue) -> ir.Value:
        """Whether the mask is set in any lane: a scalar truth value."""
        bits = self.ir.bitcast(mask.value, ir.IntType(self.target.width))
        return self.ir.icmp_unsigned("!=", bits, bits.type(0))

    def any_positive(self, buffer: BlockBuffer) -> ir.Value:
        """Whether the first channel of a buffer is above 0 for any query of the block."""
        found: ir.Value = MASK(0)
        for number in range(self.target.vectors_per_block):
            place = self.element_pointer(buffer.pointer, number * self.target.width)
            found = self.ir.or_(found, self.any(self.load(place) > 0))
        return found

    def transpose(self, rows: Sequence[SimdValue]) -> list[SimdValue]:
        """The columns of a square of values: as many vectors as they have lanes."""
        width, half = self.target.width, self.target.width // 2
        low = [lane // 2 + width * (lane % 2) for lane in range(width)]
        high = [lane + half for lane in low]
        found = list(rows)
        # Each pass interleaves vectors k and k + half; after log2(width) passes rows have become columns.
        for _ in range(width.bit_length() - 1):
            found = [
                self._shuffle(found[k // 2].value, found[k // 2 + half].value, high if k % 2 else low)
                for k in range(width)
            ]
        return found

    def _shuffle(self, first: ir.Value, second: ir.Value, order: Sequence[int]) -> SimdValue:
        lanes = ir.Constant(self.vector_type(INT32), list(order))
        return SimdValue(self, self.ir.shuffle_vector(first, second, lanes))

    # Conversions and scalars.

    def vector_type(self, element: ir.Type) -> ir.VectorType:
        """One element per lane."""
        return ir.VectorType(element, self.target.width)

    def varying(self, value: Operand) -> SimdValue:
        """A Python number in all lanes, as floats; a value as it is."""
        return value if isinstance(value, SimdValue) else SimdValue(self, self.constant(value, FLOAT))

    def constant(self, value: Operand, element: ir.Type) -> ir.Value:
        """The LLVM vector of an operand; Python numbers become elements of that type."""
        if isinstance(value, SimdValue):
            return value.value
        one = float(np.float32(value)) if element == FLOAT else int(value)
        return ir.Constant(self.vector_type(element), [one] * self.target.width)

    def bitcast(self, value: SimdValue, element: ir.Type) -> SimdValue:
        """The same bits read as another 32-bit type."""
        return SimdValue(self, self.ir.bitcast(value.value, self.vector_type(element)))

    def to_float(self, value: SimdValue) -> SimdValue:
        """INT32 as the nearest floats."""
        return SimdValue(self, self.ir.sitofp(value.value, self.vector_type(FLOAT)))

    def to_int32(self, value: SimdValue) -> SimdValue:
        """Floats rounded towards 0."""
        return SimdValue(self, self.ir.fptosi(value.value, self.vector_type(INT32)))

    def index(self, number: Index) -> ir.Value:
        """An INDEX."""
        return number if isinstance(number, ir.Value) else INDEX(number)

    def multiply(self, number: Index, factor: int) -> Index:
        """A multiple of an INDEX, folded where it is a Python integer."""
        return self.ir.mul(number, INDEX(factor)) if isinstance(number, ir.Value) else number * factor
