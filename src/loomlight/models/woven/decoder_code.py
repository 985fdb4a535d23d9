"""The decoder as code of `lane_code`: all that lies between a query and its answer, block after block.

Latents are fetched, places and directions coded, layers multiplied and bundles mixed while a block's numbers
stay near the core. Code depends on the network's shape alone; weights, and what belongs to a fabric, are read
from memory.

Questions and answers are arrays [n]. A footprint is the numbers of `Squares`; x, y, z of the view in the
frame of the face that is seen, z > 0; and 1 where that is the back, else 0.

- "answers", of a footprint and x, y, z of the light: four components, 1/sr, and the hole.
- "hole", of a footprint: the hole alone.
- "seen", of a footprint: the first angular layer without the light's part, `hidden` numbers, the hole, and
  how much of a correction counts.
- "components", of what is seen but the hole, the view, the face and the light: four components.
- "hidden", of a footprint and the light: what the last layer takes, `hidden` numbers.
"""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
from llvmlite import ir
from numpy.typing import NDArray

from loomlight.core.dense_code import Packed, dense
from loomlight.core.footprint import SQUARES
from loomlight.core.lane_code import Code, Rows
from loomlight.core.lane_values import INDEX, Lanes
from loomlight.core.machine_code import vectors
from loomlight.models.woven.architecture import BINS, BUNDLES, SLOPE, VIEW_FEATURES
from loomlight.models.woven.codings import (
    DIFFUSE,
    Direction,
    Fibre,
    fibre_features,
    mixed_bundles,
    one_blob,
    unmapped,
)
from loomlight.models.woven.latents import PACKET, fetched_channels
from loomlight.models.woven.places import Squares, own_share, place_of
from loomlight.models.woven.pyramid import FINEST
from loomlight.models.woven.weights import Weights

Question = Literal["answers", "hole", "seen", "components", "hidden"]
# What all queries share: packed layers, rows and levels of `LatentRows`, numbers of the fabric, and the
# packed correction of its last layer.
_LAYERS, _ROWS, _LEVELS, _FABRIC, _CORRECTION = range(5)
# Numbers of the fabric: where they begin.
_ENDS, _PICKS, _TEXELS, _LEVEL_COUNT, _FIBRES, _BUNDLES = 0, 1, 2, 3, 4, 10
_FOOTPRINT, _VIEW, _LIGHT = 5, 4, 3  # numbers of a question
_TAPS = 8
# Vectors of a texel that are summed at once, so that sums stay in registers.
_SUMS = 6


def packed_layers(weights: Weights) -> Packed:
    """Layers by what they are multiplied with, in the order in which they are."""
    table, packed = weights.table, Packed(vectors())

    def tensors(name: str) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        return weights.tensor(f"decoder.{name}.weight"), weights.tensor(f"decoder.{name}.bias")

    if table.fusion:
        # The latent's part is multiplied beforehand, its bias too.
        packed.add("place", weights.tensor("decoder.fusion.0.weight")[:, table.latent_size :])
        packed.add("fusion", *tensors("fusion.1"))
    packed.add("hole", *tensors("hole.0"))
    packed.add("share", *tensors("hole.1"))
    weight, bias = tensors("angular.0")
    spatial = weights.tensor("decoder.hole.0.weight").shape[1] - 2
    of_spatial, of_light, of_view, of_fibres = np.split(weight, [spatial, spatial + 3, spatial + 5], axis=1)
    of_views, of_lights = np.split(of_fibres, [VIEW_FEATURES], axis=1)
    packed.add("seen", np.concatenate([of_spatial, of_view, of_views], axis=1), bias)
    packed.add("light", np.concatenate([of_light, of_lights], axis=1))
    for number in range(1, weights.layers("decoder.angular")):
        packed.add(f"{number}", *tensors(f"angular.{number}"))
    return packed


def decoder_code(question: Question, weights: Weights, corrected: bool, repeat: tuple[int, int]) -> Code:
    """Code that answers one kind of question.

    Args:
        corrected: whether the fabric has a correction of its own.
        repeat: picks and ends, for latents of kind "vector".
    """
    writer = _Writer(question, weights, corrected, repeat)
    with writer.code.blocks():
        writer.write()
    return writer.code


class _Writer:
    """Writes the code of one question."""

    def __init__(
        self, question: Question, weights: Weights, corrected: bool, repeat: tuple[int, int]
    ) -> None:
        table = weights.table
        self.code = Code(f"woven_{question}", vectors())
        self._question, self._table, self._repeat = question, table, repeat
        self._linear_diffuse = weights.linear_diffuse
        self._layers = packed_layers(weights).layers
        self._count = weights.layers("decoder.angular")
        self._channels = fetched_channels(weights)
        self._hidden, self._corrected = table.hidden, corrected
        self._spatial = weights.tensor("decoder.hole.0.weight").shape[1] - 2
        queries, answers = {
            "answers": (_FOOTPRINT + _VIEW + _LIGHT, DIFFUSE + 2 + 1),
            "hole": (_FOOTPRINT + _VIEW, 1),
            "seen": (_FOOTPRINT + _VIEW, self._hidden + 2),
            "components": (self._hidden + 1 + _VIEW + _LIGHT, DIFFUSE + 2),
            "hidden": (_FOOTPRINT + _VIEW + _LIGHT, self._hidden),
        }[question]
        self._answers, self._shared = queries, queries + answers
        self._view = self._hidden + 1 if question == "components" else _FOOTPRINT

    def write(self) -> None:
        """Code of a block."""
        if self._question == "components":
            seen, own = self._given_seen()
        else:
            own = self.code.rows(1)
            seen = self._seen(own)
        if self._question == "seen":
            self._answer_rows(seen)
            with self.code.each_vector():
                self.code.answer(self._answers + self._hidden + 1, own[0])
        elif self._question != "hole":
            hidden = self._lit(seen)
            if self._question == "hidden":
                self._answer_rows(hidden)
            else:
                self._components(hidden, own)

    # Numbers of questions and of the fabric.

    def _array(self, number: int) -> ir.Value:
        return self.code.array(self._shared + number)

    def _number(self, number: int) -> Lanes:
        return self.code.shared(self._array(_FABRIC), number)

    def _view_and_face(self) -> tuple[Direction, Lanes]:
        x, y, z, back = (self.code.given(self._view + k) for k in range(_VIEW))
        return Direction(x, y, z), back > 0.5

    def _light(self) -> Direction:
        return Direction(*(self.code.given(self._view + _VIEW + k) for k in range(_LIGHT)))

    def _squares(self) -> Squares:
        return Squares(*(self.code.given(k) for k in range(_FOOTPRINT)))

    def _fibres(self, back: Lanes) -> tuple[Fibre, Fibre]:
        """See `LatentTable.fibres`."""
        numbers = [self._number(_FIBRES + k) for k in range(6)]
        (warp_x, warp_y, warp_roughness), (weft_x, weft_y, weft_roughness) = numbers[:3], numbers[3:]
        return (
            Fibre(self.code.select(back, -warp_x, warp_x), warp_y, warp_roughness),
            Fibre(weft_x, self.code.select(back, -weft_y, weft_y), weft_roughness),
        )

    def _layer(
        self, name: str, inputs: Rows, outputs: Rows, start: Rows | None = None, leaky: bool = False
    ) -> None:
        slope = SLOPE if leaky else None
        dense(self.code, self._array(_LAYERS), self._layers[name], inputs, outputs, start, slope)

    def _rows_of(self, name: str) -> Rows:
        """Rows for what a layer puts out."""
        return self.code.rows(self._layers[name].rows(self.code.vectors))

    # What a view sees of footprints.

    def _seen(self, own: Rows) -> Rows:
        """The first angular layer without the light's part; answers the hole, if asked."""
        code, table = self.code, self._table
        coded = code.rows(3 * BINS)
        long = code.rows(1)
        with code.each_vector():
            squares = self._squares()
            place = place_of(table, *self._repeat, squares.x, squares.y, squares.size(code), code)
            numbers = one_blob(place, code) if table.position == "one_blob" else place
            for number, value in enumerate(numbers):
                coded[number] = value
            own[0] = own_share(place[2], code)
            long[0] = code.abs(squares.step_x) + code.abs(squares.step_y)
        # The view's numbers stand behind what is fused. Before they do, more rows than that may be written.
        room = max(code.vectors.sums, code.vectors.lanes)
        fused = code.rows(self._spatial + room + 2 + VIEW_FEATURES)
        if table.fusion:
            fetched, hidden = self._fetched(long), self._rows_of("place")
            self._layer("place", coded, hidden, start=fetched, leaky=True)
            self._layer("fusion", hidden, fused, leaky=True)
        else:
            self._fetched(long, fused)
            with code.each_vector():
                for number in range(self._spatial - self._channels):
                    fused[self._channels + number] = coded[number]
        with code.each_vector():
            view, back = self._view_and_face()
            behind = [view.x, view.y]
            if table.fibres:
                behind += [fibre.cosine(view.x, view.y) for fibre in self._fibres(back)]
            for number, value in enumerate(behind):
                fused[self._spatial + number] = value
        seen = self._rows_of("seen")
        if self._question != "hole":
            self._layer("seen", fused, seen)
        if self._question != "hidden":
            self._answer_hole(fused)
        return seen

    def _answer_hole(self, fused: Rows) -> None:
        code = self.code
        hidden, share = self._rows_of("hole"), self._rows_of("share")
        self._layer("hole", fused, hidden, leaky=True)
        self._layer("share", hidden, share)
        with code.each_vector():
            code.answer(self._hole_answer(), code.clip(share[0], 0, 1))

    def _hole_answer(self) -> int:
        before = {"answers": DIFFUSE + 2, "hole": 0, "seen": self._hidden}
        return self._answers + before[self._question]

    def _write_taps(self, taps: Rows, number: Lanes, count: Lanes) -> None:
        """Texels, then weights, of one of so many squares, of the vector at hand; see `pyramid.taps`."""
        code = self.code
        _, back = self._view_and_face()
        face = code.select(back, self._number(_TEXELS), 0)
        if self._table.latent != "field":
            taps[0], taps[_TAPS] = face, code.number(1)
            return
        squares, place = self._squares(), number - 0.5 * (count - 1)
        x, y = (
            code.fma(place, step, middle)
            for step, middle in ((squares.step_x, squares.x), (squares.step_y, squares.y))
        )
        ends, picks, levels = (self._number(number) for number in (_ENDS, _PICKS, _LEVEL_COUNT))
        # Near the origin, where float32 is finest, and within the repeat whatever comes in: rows must exist.
        x, y = (
            code.clip(value - period * code.floor(value / period), 0, period)
            for value, period in ((x, ends), (y, picks))
        )
        place = code.clip(code.log2(code.maximum(squares.side, 1e-6)) + FINEST, 0, levels - 1)
        lower = code.minimum(code.floor(place), levels - 2)
        blend, whole = place - lower, 1 / count
        for side, share in enumerate(((1 - blend) * whole, blend * whole)):
            level = lower + side
            first, columns, rows, per_thread = self._level(level)
            running_mean = (level > FINEST) & (level < levels - 1)
            corner = code.select(running_mean, 1, 0.5)
            u, v = code.fma(x, per_thread, -corner), code.fma(y, per_thread, -corner)
            column, row = code.floor(u), code.floor(v)
            right, up = u - column, v - row
            for tall, along in enumerate((1 - up, up)):
                start = first + self._wrapped(row + tall, rows) * columns
                for wide, across in enumerate((1 - right, right)):
                    tap = 4 * side + 2 * tall + wide
                    taps[tap] = face + start + self._wrapped(column + wide, columns)
                    taps[_TAPS + tap] = share * along * across

    def _wrapped(self, index: Lanes, count: Lanes) -> Lanes:
        """An index from −1 to count, brought to 0 to count − 1."""
        code = self.code
        return code.select(index < 0, index + count, code.select(index >= count, index - count, index))

    def _level(self, level: Lanes) -> list[Lanes]:
        """First texel, columns, rows and texels a thread of a level in each lane: each level's in turn."""
        code = self.code
        count = code.whole(code.builder.load(code.element(self._array(_FABRIC), _LEVEL_COUNT)))
        return code.looked_up(self._array(_LEVELS), 4, count, level)

    def _fetched(self, long: Rows, into: Rows | None = None) -> Rows:
        """Means of interpolated latents over rows of squares: sums over channels a query, then turned.

        Args:
            long: a row, 0 where a footprint is one square.
        """
        code = self.code
        lanes, block = code.vectors.lanes, code.vectors.block
        padded = -(-self._channels // PACKET) * PACKET
        lines, taps = code.stack(block * padded), code.rows(2 * _TAPS)
        with code.loop(block * padded // lanes) as number:
            code.store(code.number(0), code.element(lines, code.times(number, lanes)))
        count = code.builder.select(code.anywhere(long), INDEX(SQUARES), INDEX(1))
        with code.loop(count) as number:
            with code.each_vector():
                self._write_taps(taps, code.counted(number), code.counted(count))
            self._add_taps(taps, lines, padded)
        found = code.rows(padded) if into is None else into
        with code.each_vector():
            own = code.element(lines, code.times(code.lane, padded))
            # Of padding nothing is read that was not written.
            with code.loop(-(-self._channels // lanes)) as number:
                column = code.times(number, lanes)
                square = [
                    code.load(code.element(own, code.builder.add(column, INDEX(lane * padded))))
                    for lane in range(lanes)
                ]
                for channel, value in enumerate(code.transposed(square)):
                    found[code.builder.add(column, INDEX(channel))] = value
        return found

    def _add_taps(self, taps: Rows, lines: ir.Value, padded: int) -> None:
        """Adds texels to a line of channels for each query."""
        code, lanes = self.code, self.code.vectors.lanes
        count = _TAPS if self._table.latent == "field" else 1
        rows = self._array(_ROWS)
        with code.loop(code.vectors.block) as query:
            texels = [
                code.builder.mul(
                    code.whole(code.builder.load(code.element(taps.place(tap), query))), INDEX(padded)
                )
                for tap in range(count)
            ]
            line = code.element(lines, code.times(query, padded))
            for first in range(0, padded, _SUMS * lanes):
                places = range(first, min(first + _SUMS * lanes, padded), lanes)
                sums = [code.load(code.element(line, place)) for place in places]
                for tap, texel in enumerate(texels):
                    weight = code.shared(taps.place(_TAPS + tap), query)
                    row = code.element(rows, texel)
                    sums = [
                        code.fma(weight, code.load(code.element(row, place)), total)
                        for place, total in zip(places, sums, strict=True)
                    ]
                for place, total in zip(places, sums, strict=True):
                    code.store(total, code.element(line, place))

    def _answer_rows(self, rows: Rows) -> None:
        """Answers what is hidden."""
        code = self.code
        with code.loop(self._hidden) as channel:
            answer = code.builder.add(channel, INDEX(self._answers))
            with code.each_vector():
                code.answer(answer, rows[channel])

    def _given_seen(self) -> tuple[Rows, Rows]:
        code = self.code
        seen, own = self._rows_of("seen"), code.rows(1)
        with code.loop(self._hidden) as channel, code.each_vector():
            seen[channel] = code.given(channel)
        with code.each_vector():
            own[0] = code.given(self._hidden)
        return seen, own

    # What lights make of it.

    def _lit(self, seen: Rows) -> Rows:
        """What the last layer takes for a light."""
        code = self.code
        directions = code.rows(self._layers["light"].inputs)
        with code.each_vector():
            light = self._light()
            view, back = self._view_and_face()
            numbers: list[Any] = [light.x, light.y, light.z]
            if self._table.fibres:
                numbers += fibre_features(light, view, self._fibres(back), code)
            for number, value in enumerate(numbers):
                directions[number] = value
        skip = self._rows_of("light")
        self._layer("light", directions, skip, start=seen)
        hidden = self._rows_of("light")
        with code.loop(self._hidden) as channel, code.each_vector():
            hidden[channel] = code.maximum(skip[channel], skip[channel] * SLOPE)
        for number in range(1, self._count - 1):
            outputs = self._rows_of(f"{number}")
            if number == 2:
                self._skipped(hidden, outputs, skip)
            else:
                self._layer(f"{number}", hidden, outputs, leaky=True)
            hidden = outputs
        return hidden

    def _skipped(self, hidden: Rows, outputs: Rows, skip: Rows) -> None:
        """The layer that the first one's sums are added to."""
        code = self.code
        self._layer("2", hidden, outputs)
        with code.loop(self._hidden) as channel, code.each_vector():
            total = outputs[channel] + skip[channel]
            outputs[channel] = code.maximum(total, total * SLOPE)

    def _correction(self, hidden: Rows) -> Rows | None:
        """What the fabric's own correction adds to what is put out for bundles."""
        if not self._corrected:
            return None
        packed = Packed(self.code.vectors)
        layer = packed.add("correction", np.zeros((2 * BUNDLES, self._hidden)))
        found = self.code.rows(layer.rows(self.code.vectors))
        dense(self.code, self._array(_CORRECTION), layer, hidden, found)
        return found

    def _components(self, hidden: Rows, own: Rows) -> None:
        """Answers the components."""
        code, name = self.code, f"{self._count - 1}"
        last = self._rows_of(name)
        self._layer(name, hidden, last)
        correction = self._correction(hidden)
        with code.each_vector():
            light, specular = self._light(), None
            if self._table.bundles:
                shares = [last[DIFFUSE + number] for number in range(2 * BUNDLES)]
                if correction is not None:
                    share = code.select(light.z > 0, own[0], 0)
                    shares = [
                        code.fma(share, correction[number], value) for number, value in enumerate(shares)
                    ]
                view, back = self._view_and_face()
                specular = mixed_bundles(shares, light, view, self._bundles(), back, code)
            output = [last[number] for number in range(DIFFUSE if specular else DIFFUSE + 2)]
            found = unmapped(output, specular, light.z, self._linear_diffuse, code)
            for number, value in enumerate(found):
                code.answer(self._answers + number, value)

    def _bundles(self) -> list[list[list[Lanes]]]:
        """Bundles of both families [2][`BUNDLES`][4]."""
        return [
            [
                [self._number(_BUNDLES + 4 * (family * BUNDLES + bundle) + k) for k in range(4)]
                for bundle in range(BUNDLES)
            ]
            for family in range(2)
        ]
