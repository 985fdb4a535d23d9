"""Yarns close up: plies, fibres and slubs on the smooth tube of the geometry.

Nothing here moves the surface: normals and fibre directions turn, and diffuse albedos vary, about those of
the smooth yarn. Every turn is a rotation of the whole frame, so tangent and normal stay perpendicular and
the energy bound of `albedo.py` holds at every point.

- *Plies* are sub-cylinders that wind around the yarn: across a ply the sine of the normal's turn rises
  linearly from edge to edge, and the grooves between plies are darker.
- *Fibres* are long cells of the fibre coordinates. Noise that is smooth along a cell turns the normal across
  the fibre, and the fibre itself; fibres of a bundle move together.
- *Slubs* are noise along the thread: where it is thick it is lighter, where it is thin darker.

Turns are symmetric about 0 and gains have mean 1, so that means over many threads stay. Each part fades
before its period falls below the side of the footprint: what a pixel cannot resolve is not drawn.

Sources: plies, migrating fibres and fly-away fibres are those of the procedural yarns of Zhao, Luan and Bala
2016; plies as shading normals of a surface those of Montazeri et al. 2020.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import drjit as dr

from loomlight.core.arrays import Float, Mask, UInt, Vec3
from loomlight.core.backend import ArrayTypes, array_types, clip, maximum, minimum, opaque
from loomlight.scattering.appearance import Appearance, YarnDetail
from loomlight.scattering.variation import FIBRE_CELL_LENGTH, Gain, hash_bits, hash_key
from loomlight.yarn.flanks import SurfacePoint
from loomlight.yarn.threads import SECTION_ANGLE

# Sine of the turn of a ply's normal at its edges, and by what share of the albedo its grooves are darker.
PLY_EDGE_SINE = 0.62
GROOVE_DEPTH = 0.95
# Turned normals see less of a dome, as light from below the yarn's own surface is lost. How much more diffuse
# light makes up for it, over the mean of 1 − cos of the turn (`studies/accuracy/yarn_detail.py`).
DIFFUSE_TURN_LOSS = 0.85
# Fibres that stray together.
BUNDLE_FIBRES = 5.0
# Fibres wave along the yarn: the period in widths of a fibre, and the amplitude over period and stray.
WAVE_LENGTH = 25.0
WAVE_SHARE = 0.5
# Period of slubs, in widths of the yarn.
SLUB_LENGTH = 9.0
# Share of the albedo that fibres vary by for each radian that they stray, and at most.
TONE_OF_TILT, MAX_TONE = 0.5, 0.15
# By how much darker gaps between fibres, and between bundles, are over that share.
FIBRE_GROOVE = 4.5
# How much of the depth varies from bundle to bundle.
GROOVE_VARIATION = 0.5
LOWEST_EXCESS = -0.95
# Largest share of the albedo that slubs add or take.
SLUB_DEPTH = 0.15

BUNDLE_STREAM = 0x68BC21EB
WAVE_STREAM = 0x1B56C4E9
TILT_STREAM = 0x02E5BE93
SLUB_STREAM = 0x51D7348D

# 1 / deviation of the sum of noises that turn normals and fibres. Uniform numbers in ±1 have the variance
# 1/3, and smoothed along their cells 26/35 of it.
NOISE_VARIANCE = 26 / 105
TILT_SCALE = (2 * NOISE_VARIANCE + 1 / 3) ** -0.5
TURN_SCALE = (2 * NOISE_VARIANCE) ** -0.5


# Numbers of a family that points are computed with, by their names in records of shaders; what each is.
FAMILY_NUMBERS = {
    "has_plies": "1 where yarns have two plies or more",
    "plies_per_mm": "across the plies",
    "ply_sine": "sine of the angle from fibres to plies",
    "ply_cosine": "",
    "fibre_tilt": "deviation of the angles by which fibres stray",
    "fibre_tone": "share of the albedo that fibres vary by",
    "slub": "0 to 1",
    "slubs_per_mm": "along the thread",
    "hairiness": "0 to 1",
}


def family_numbers(detail: YarnDetail) -> dict[str, float]:
    """The numbers of `FAMILY_NUMBERS`."""
    circumference = math.pi * detail.width / math.sin(SECTION_ANGLE)
    lean = detail.ply_twist - detail.twist
    return {
        "has_plies": float(detail.plies > 1),
        "plies_per_mm": detail.plies / (circumference * math.cos(detail.ply_twist)),
        "ply_sine": math.sin(lean),
        "ply_cosine": math.cos(lean),
        "fibre_tilt": detail.fibre_tilt,
        "fibre_tone": min(TONE_OF_TILT * detail.fibre_tilt, MAX_TONE),
        "slub": detail.slub,
        "slubs_per_mm": 1 / (SLUB_LENGTH * detail.width),
        "hairiness": detail.hairiness,
    }


class DetailNumbers:
    """Detail and variation of a fabric's two families on one backend.

    All are opaque, and plies, fibres and slubs that a fabric lacks have the weight 0: fabrics share kernels.

    Attributes:
        has_hairs: a family has; without them pictures of close-ups take a tenth less.
        fibre_size: width of a fibre, millimetres.
        period: width and height of the repeat, millimetres.
        threads: of warp and of weft in the repeat.
        seed, noise: see `Variation` and `variation.NoiseNumbers`.
    """

    def __init__(
        self, appearance: Appearance, fibre_size: float, period: tuple[float, float], types: ArrayTypes
    ) -> None:
        families, variation = (appearance.warp, appearance.weft), appearance.variation

        self.has_hairs = any(family.detail.hairiness > 0 for family in families)
        self.fibre_size = opaque(types.Float, fibre_size)
        self.period = opaque(types.Float, period)
        self.threads = opaque(types.Int32, [len(family.diffuse_reflect) for family in families])
        self.seed = opaque(types.UInt32, variation.seed)
        strengths = variation.fibre_noise, appearance.thread_noise, appearance.layer_bound
        fibre, colour, bound = (opaque(types.Float, number) for number in strengths)
        self.noise = fibre, colour, self.seed, bound
        self._families = [
            {name: opaque(types.Float, number) for name, number in family_numbers(family.detail).items()}
            for family in families
        ]

    def of(self, name: str, is_warp: Mask) -> Float:
        """A number of the family that shows."""
        return dr.select(is_warp, self._families[0][name], self._families[1][name])


def fade(size: Float, period: Float) -> Float:
    """Weight of detail of a period for footprints of a side, millimetres: 1 up to a quarter, 0 from 1 on."""
    return clip(dr.fma(size * dr.rcp(period), -4 / 3, 4 / 3), 0, 1)


def ply_offset(numbers: DetailNumbers, point: SurfacePoint, back: Mask) -> Float:
    """Position across the ply of a point, −1 at one edge to 1 at the other."""
    sine = numbers.of("ply_sine", point.is_warp)
    across = dr.fma(
        point.fibre_across,
        numbers.of("ply_cosine", point.is_warp),
        point.fibre_along * dr.select(back, -sine, sine),
    )
    ply = across * numbers.of("plies_per_mm", point.is_warp)
    return dr.fma(2, ply - dr.floor(ply), -1)


@dataclass
class Frame:
    """The frame of a yarn point.

    Attributes:
        normal, tangent: unit vectors [3] at right angles.
        loss: mean of 1 − cos of the angle that detail turns normals by here.
        shade: mean share of light that hairs take here.
    """

    normal: Vec3
    tangent: Vec3
    loss: Float
    shade: Float = 0.0


def turned_frame(numbers: DetailNumbers, point: SurfacePoint, back: Mask, thread: UInt, size: Float) -> Frame:
    """The frame of a yarn point with its plies and fibres, without hairs.

    Args:
        thread: UInt32, number of the thread over the whole cloth.
        size: side of the footprint, millimetres.
    """
    normal, tangent = point.normal, point.tangent
    period = dr.rcp(numbers.of("plies_per_mm", point.is_warp))
    weight = numbers.of("has_plies", point.is_warp) * fade(size, period)
    sine = weight * PLY_EDGE_SINE * ply_offset(numbers, point, back)
    # Twice the mean of 1 − cos, as specular terms lose too and gain nothing
    # (`studies/accuracy/yarn_detail.py`).
    loss = dr.square(weight) * (PLY_EDGE_SINE**2 / 3)
    # The fibre in the frame of the ply, which then turns about its own axis.
    lean_sine = numbers.of("ply_sine", point.is_warp)
    lean_sine = dr.select(back, -lean_sine, lean_sine)
    lean_cosine = numbers.of("ply_cosine", point.is_warp)
    across = dr.cross(tangent, normal)
    along_ply = lean_cosine * tangent - lean_sine * across
    across_ply = lean_cosine * across + lean_sine * tangent
    cosine = dr.sqrt(dr.fma(-sine, sine, 1))
    across_turned = cosine * across_ply - sine * normal
    normal = cosine * normal + sine * across_ply
    tangent = lean_cosine * along_ply + lean_sine * across_turned

    bundle, fibre, slope = _fibre_noise(numbers, point, thread, size)
    amount = numbers.of("fibre_tilt", point.is_warp)
    # Fibres are round.
    tilt = TILT_SCALE * amount * (bundle.weight * bundle.tilt + fibre.weight * (fibre.tilt + fibre.offset))
    of_bundle, of_fibre = dr.square(bundle.weight), dr.square(fibre.weight)
    variance = (NOISE_VARIANCE * (of_bundle + of_fibre) + of_fibre / 3) * TILT_SCALE**2
    loss = dr.fma(0.5 * dr.square(amount), variance, loss)
    turn = TURN_SCALE * (bundle.weight * bundle.turn + fibre.weight * fibre.turn)
    turn = amount * dr.fma(-bundle.weight, slope, turn)
    across = dr.cross(tangent, normal)
    (sine, cosine) = dr.sincos(tilt)
    normal, across = cosine * normal + sine * across, cosine * across - sine * normal
    (sine, cosine) = dr.sincos(turn)
    tangent = cosine * tangent + sine * across
    return Frame(normal, tangent, loss)


def diffuse_gain(frame: Frame, blend: Float) -> Float:
    """Gain of the diffuse term of a turned frame, which keeps the mean over many points, Float ≥ 1.

    No point returns more than its albedo of light from everywhere: of that the diffuse term returns
    w·(1 + n_z)/2 + 1 − w.

    Args:
        blend: w, the weight of the yarn normal.
    """
    returned = dr.fma(0.5 * blend, frame.normal.z - 1, 1)
    return minimum(dr.fma(DIFFUSE_TURN_LOSS * blend, frame.loss, 1 + frame.shade), dr.rcp(returned))


@dataclass
class _Noise:
    """Noise of the bundle or the fibre at a point.

    Attributes:
        weight: of what it shows, 0 to 1.
        tilt, turn: in ±1.
        offset: position across it, −1 to 1.
    """

    weight: Float
    tilt: Float
    turn: Float
    offset: Float


def _fibre_noise(
    numbers: DetailNumbers, point: SurfacePoint, thread: UInt, size: Float
) -> tuple[_Noise, _Noise, Float]:
    """Noise of the bundle and of the fibre, and the slope of the wave at a stray of one radian."""
    fibre, seed = numbers.fibre_size, numbers.seed
    # Fibres wave together along the yarn.
    inverse = dr.rcp(WAVE_LENGTH * fibre)
    wave, slope = _wave(hash_key(thread, seed ^ WAVE_STREAM), point.fibre_along * inverse)
    amount = numbers.of("fibre_tilt", point.is_warp) * WAVE_SHARE * WAVE_LENGTH * fibre
    across = dr.fma(amount, wave, point.fibre_across)

    def noise(width: Float, stream: int) -> _Noise:
        column, row, offset = fibre_cell(across, point.fibre_along, width)
        tilt, turn = _noise(hash_key(thread, seed ^ stream), column, row)
        return _Noise(fade(size, width), tilt, turn, offset)

    return noise(BUNDLE_FIBRES * fibre, BUNDLE_STREAM), noise(fibre, TILT_STREAM), WAVE_SHARE * slope


def fibre_cell(across: Float, along: Float, width: Float) -> tuple[Float, Float, Float]:
    """Column and row of a cell of fibre coordinates, and the position across it, −1 to 1.

    Args:
        across, along: position, millimetres.
        width: of the cells, millimetres; they are `FIBRE_CELL_LENGTH` times as long. The row is not rounded.
    """
    inverse = dr.rcp(width)
    column = dr.floor(across * inverse)
    # Cells side by side are staggered, or their ends would line up.
    row = dr.fma(along * inverse, 1 / FIBRE_CELL_LENGTH, 0.618 * column)
    return column, row, dr.fma(2, across * inverse - column, -1)


def _noise(key: UInt, column: Float, position: Float) -> tuple[Float, Float]:
    """Two numbers in ±1 that change smoothly with a position, of a column of cells."""
    types = array_types(position)
    row = dr.floor(position)
    share = position - row
    share = dr.square(share) * dr.fma(-2, share, 3)
    cell = types.UInt32(types.Int32(column)) * 65536 + types.UInt32(types.Int32(row))
    low, high = hash_bits(key, cell), hash_bits(key, cell + 1)
    first = dr.lerp(_signed(low & 0xFFFF), _signed(high & 0xFFFF), share)
    return first, dr.lerp(_signed(low >> 16), _signed(high >> 16), share)


def _wave(key: UInt, position: Float) -> tuple[Float, Float]:
    """A number in ±1 that changes smoothly with a position, and its derivative."""
    types = array_types(position)
    row = dr.floor(position)
    share = position - row
    cell = types.UInt32(types.Int32(row))
    low, high = _signed(hash_bits(key, cell) & 0xFFFF), _signed(hash_bits(key, cell + 1) & 0xFFFF)
    slope = 6 * share * (1 - share) * (high - low)
    return dr.lerp(low, high, dr.square(share) * dr.fma(-2, share, 3)), slope


def _signed(bits: UInt) -> Float:
    """Sixteen bits as a number in ±1."""
    types = array_types(dr.float32_array_t(type(bits)))
    return dr.fma(types.Float(bits) + 0.5, 2**-15, -1)


def _groove(depth: Float, offset: Float) -> tuple[Float, Float]:
    """Excess of a gain of mean 1 that falls by `depth` at edges, ±1, of what is round; its largest."""
    eighth = dr.square(dr.square(dr.square(offset)))
    return depth * (1 / 9 - eighth), depth * (1 / 9)


def detail_gain(numbers: DetailNumbers, point: SurfacePoint, back: Mask, thread: UInt, size: Float) -> Gain:
    """Gain of the diffuse albedos by grooves between plies and fibres, and by slubs; see `turned_frame`."""
    period = dr.rcp(numbers.of("plies_per_mm", point.is_warp))
    weight = GROOVE_DEPTH * numbers.of("has_plies", point.is_warp) * fade(size, period)
    excess, largest = _groove(weight, ply_offset(numbers, point, back))

    bundle, fibre, _ = _fibre_noise(numbers, point, thread, size)
    tone = numbers.of("fibre_tone", point.is_warp)
    varied = dr.fma(GROOVE_VARIATION, bundle.tilt, 1 - GROOVE_VARIATION)
    for noise, depth in ((bundle, varied), (fibre, 1)):
        gap, most = _groove(FIBRE_GROOVE * tone * noise.weight * depth, noise.offset)
        excess += dr.fma(tone * noise.weight, noise.turn, gap)
        largest += dr.fma(tone, noise.weight, most)

    per_slub = numbers.of("slubs_per_mm", point.is_warp)
    weight = SLUB_DEPTH * numbers.of("slub", point.is_warp) * fade(size, dr.rcp(per_slub))
    lengthwise = dr.select(point.is_warp, point.y, -point.x)
    key = hash_key(thread, numbers.seed ^ SLUB_STREAM)
    wave, _ = _wave(key, lengthwise * per_slub)
    excess += weight * wave
    largest += weight
    # Where grooves cross.
    return Gain(maximum(excess, LOWEST_EXCESS), largest)
