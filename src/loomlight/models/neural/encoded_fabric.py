"""The encoded fabric: latents of both faces and fibres, and how footprints are coded to read them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Self

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.core.arrays import Float, Vec2
from loomlight.core.backend import array_types, maximum
from loomlight.core.errors import InputError
from loomlight.core.footprint import Footprint
from loomlight.core.tables import (
    Layer,
    Number,
    Shown,
    Tables,
    computed,
    derived,
    flag,
    given,
    number,
    size,
    table,
)
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.fields import yarn_range
from loomlight.models.neural.architecture import BUNDLE_POSITIONS, BUNDLE_SLOPES, BUNDLES, NetworkTable
from loomlight.yarn.layout import ClothLayout

# ----------------------------------------------------------------------------------------------------- fibres
# Directions and roughness of the fibres of a fabric: inputs of the decoder beside latents.


# Valid ranges of parameters, to which mixtures are clipped; angles in radians.
_LIMITS = {
    "roughness": yarn_range("roughness"),
    "inclination": (0.0, math.radians(yarn_range("inclination_deg")[1])),
    "height_scale": yarn_range("height_scale"),
}
_ROUNDING = 1e-6
# Slopes of bundles in units of the slope at the ends of floats, as yarns dive steeper between floats; and the
# smallest largest slope.
_SLOPE_MARGIN, _MIN_SLOPE = 1.15, 0.03
# The sine of the angle at a yarn's edges, seen along it.
_EDGE = 0.98
# α² of a lobe is that of the fibres plus this fraction of the squared distance to the next lobe: less leaves
# gaps between lobes, more blurs highlights.
_SPREAD = 0.3
# Added to α for each unit of the standard deviation of fibre directions in one direction.
_SPREAD_WIDTH = 1.7


@dataclass(frozen=True)
class Fibres:
    """Both families, the warp first.

    Attributes:
        twist: ψ, radians.
        roughness: α.
        inclination: U, radians.
        height_scale: β.
    """

    twist: tuple[float, float]
    roughness: tuple[float, float]
    inclination: tuple[float, float]
    height_scale: tuple[float, float]

    @classmethod
    def of(cls, fabric: Fabric) -> Self:
        """The fibres of a fabric, in single precision, as materials keep them."""
        layout, appearance = fabric.layout(), fabric.appearance()
        families = layout.warp, layout.weft
        numbers = [
            [family.twist for family in families],
            [appearance.warp.roughness, appearance.weft.roughness],
            [family.inclination for family in families],
            [family.height_scale for family in families],
        ]
        return cls.from_array(np.array(numbers, np.float32))

    @classmethod
    def from_array(cls, numbers: NDArray[np.float32]) -> Self:
        """The fibres of `array`'s numbers."""
        twist, roughness, inclination, height_scale = ((warp, weft) for warp, weft in numbers.tolist())
        return cls(twist, roughness, inclination, height_scale)

    def array(self) -> NDArray[np.float32]:
        """Twists, roughnesses, inclinations and height scales [4, 2 families]."""
        return np.array([self.twist, self.roughness, self.inclination, self.height_scale], np.float32)

    def face(self, back: bool) -> NDArray[np.float32]:
        """Fibre direction on the crown of a yarn, x and y, and α [2 families, 3], in the frame of one face.

        A twist keeps its sign seen from behind, but the frame of that face is mirrored.
        """
        turn = -1 if back else 1
        warp, weft = (turn * angle for angle in self.twist)
        return np.array(
            [
                [-np.sin(warp), np.cos(warp), self.roughness[0]],
                [-np.cos(weft), -np.sin(weft), self.roughness[1]],
            ],
            np.float32,
        )

    def bundles(self, back: bool) -> NDArray[np.float32]:
        """The lobe basis: bundles of parallel fibres, in the frame of one face [2 families, `BUNDLES`, 4].

        The four numbers are b [3] and a: the density of a bundle's normals towards the half vector h is
        1/(a + (b·h)²)², 1/sr. Bundles have `BUNDLE_SLOPES` slopes along the yarn, times `BUNDLE_POSITIONS`
        positions across it, which differ where fibres are twisted; the last one's density is 1 everywhere. On
        the back, bundles are mirrored across the yarn: both faces have the same ones in different order.
        """
        slopes, positions = np.indices((BUNDLE_SLOPES, BUNDLE_POSITIONS)).reshape(2, -1).astype(float)
        numbers = []
        for family in (0, 1):
            axis = self._axis(family, back, slopes, positions)
            square = np.full(len(axis), self.roughness[family] ** 2)
            for along, across in ((0.5, 0.0), (0.0, 0.5)):
                step = self._axis(family, back, slopes + along, positions + across) - self._axis(
                    family, back, slopes - along, positions - across
                )
                square += _SPREAD * np.square(step).sum(1)
            square = np.minimum(square, 1)
            # SGGX of fibres (appearance.md 3), α³/(π (α² + (t·h)²(1 − α²))²), as one square.
            scale = np.sqrt(math.pi / square**1.5)
            axis *= np.sqrt(scale * (1 - square))[:, None]
            bundles = np.concatenate([axis, (scale * square)[:, None]], axis=1)
            numbers.append(np.concatenate([bundles, [[0, 0, 0, 1]]]))
        return np.array(numbers, np.float32)

    def lobe_roughness(self) -> tuple[float, float]:
        """α of one lobe about the crown's fibres that covers those of the whole yarn, for both families.

        α grows with the standard deviation of fibre directions, as that of groups of `lobes` does.
        """
        slopes, positions = np.indices((BUNDLE_SLOPES, BUNDLE_POSITIONS)).reshape(2, -1).astype(float)
        widened = []
        for family in (0, 1):
            axis = self._axis(family, False, slopes, positions)
            crown = np.append(self.face(False)[family, :2], 0)
            variance = np.square(axis - crown).sum(1).mean()
            widened.append(min(self.roughness[family] + _SPREAD_WIDTH * math.sqrt(0.5 * variance), 1.0))
        return widened[0], widened[1]

    def _axis(
        self, family: int, back: bool, slopes: NDArray[np.float64], positions: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """Unit vectors along the fibres [n, 3] for indices of slopes and positions [n], in bundles."""
        twist = -self.twist[family] if back else self.twist[family]
        steepest = _SLOPE_MARGIN * math.tan(self.inclination[family]) + _MIN_SLOPE
        along = steepest * ((2 * slopes + 1) / BUNDLE_SLOPES - 1)
        # Evenly over the yarn's width; the outermost half of a position has the slope of its centre.
        sine = np.clip(_EDGE * ((2 * positions + 1) / BUNDLE_POSITIONS - 1), -_EDGE, _EDGE)
        across = -sine / np.sqrt(1 - sine * sine)
        # t = cos ψ e_u − sin ψ e_v of a surface with these slopes; heights are scaled afterwards.
        lengthwise = 1 + along * along
        crosswise = math.sin(twist) / np.sqrt(lengthwise * (lengthwise + across * across))
        x, y = -crosswise * lengthwise, crosswise * across * along + math.cos(twist) / np.sqrt(lengthwise)
        z = self.height_scale[family] * (across * x + along * y)
        axis = np.stack([x, y, z] if family == 0 else [-y, x, z], axis=1)
        return axis / np.linalg.norm(axis, axis=1, keepdims=True)

    def mixed(self, other: Fibres, weight: float) -> Fibres:
        """Interpolates to others: weight 0 is these, 1 the others; linear, roughness in its logarithm."""
        mine, theirs = self.array(), other.array()
        twist, roughness, inclination, height_scale = (1 - weight) * mine + weight * theirs
        roughness = np.exp((1 - weight) * np.log(mine[1]) + weight * np.log(theirs[1]))
        others = zip((roughness, inclination, height_scale), _LIMITS.values(), strict=True)
        values = [twist, *(np.clip(values, *limits) for values, limits in others)]
        return Fibres.from_array(np.stack(values).astype(np.float32))

    def validation_error(self) -> str | None:
        """A sentence that names a value out of its valid range; None if all are valid."""
        for name, (low, high) in _LIMITS.items():
            warp, weft = getattr(self, name)
            if not all(low - _ROUNDING <= value <= high + _ROUNDING for value in (warp, weft)):
                return f"{name} is {warp:g} and {weft:g}: both should be {low:g} to {high:g}"
        return None


# ------------------------------------------------------------------------------------------- footprint coding
# Inputs of the decoder from a footprint: taps of the latent field, position in the repeat, and size.
#
# Lengths are in threads. Levels 0 to 3 of the latent field have 8, 4, 2 and 1 texels a thread; the next are
# running means over 2, 4, 8 … threads, a texel a thread; the last is the mean of the repeat, one texel. A
# footprint reads two levels, bilinearly each. Formulas serve NumPy, Dr.Jit and kernels: `arrays` is the
# module of array functions.


FINEST_LEVEL = 3  # levels finer than one texel a thread
PACKET = 16  # numbers of a texel that are loaded at once: a cache line
# Ratio of squared length to squared width up to which taps lie along both edges.
MAX_COMPACTNESS = 5.5
# Footprints of at least so many repeats read the mean of the repeat.
WHOLE_REPEATS = 4


@dataclass(frozen=True)
class Level:
    """One level.

    Attributes:
        first: its first texel in the table of all.
        columns, rows: its texels.
        window: threads that a texel stands for; 0 for the whole repeat.
        per_thread: texels a thread.
    """

    first: int
    columns: int
    rows: int
    window: float
    per_thread: int


def levels_of(picks: int, ends: int) -> list[Level]:
    """The levels of a repeat."""
    levels: list[Any] = []
    first = 0
    for finer in range(FINEST_LEVEL, -1, -1):
        per_thread = 1 << finer
        levels.append(Level(first, ends * per_thread, picks * per_thread, 1 / per_thread, per_thread))
        first += ends * picks * per_thread**2
    window = 2
    while window <= WHOLE_REPEATS * max(picks, ends):
        levels.append(Level(first, ends, picks, window, 1))
        first += ends * picks
        window *= 2
    levels.append(Level(first, 1, 1, 0, 0))
    return levels


def taps(
    levels: list[Level], x: NDArray[np.float32], y: NDArray[np.float32], size: NDArray[np.float32]
) -> tuple[NDArray[np.int64], NDArray[np.float32]]:
    """Texels and weights [n, 8] of footprints at x, y of a side `size` [n], in threads."""
    first = np.array([level.first for level in levels])
    columns = np.array([level.columns for level in levels])
    rows = np.array([level.rows for level in levels])
    per_thread = np.array([level.per_thread for level in levels], np.float32)
    # A texel of a running mean stands around its upper corner, other texels around their middle.
    corner = np.array([1.0 if level.window > 1 else 0.5 for level in levels], np.float32)
    level_position = np.clip(np.log2(np.maximum(size, 1e-6)) + FINEST_LEVEL, 0, len(levels) - 1).astype(
        np.float32
    )
    lower = np.minimum(level_position.astype(np.int64), len(levels) - 2)
    blend = level_position - lower
    index = np.empty((len(x), 8), np.int64)
    weight = np.empty((len(x), 8), np.float32)
    for side in range(2):
        level = lower + side
        u = x * per_thread[level] - corner[level]
        v = y * per_thread[level] - corner[level]
        column, row = np.floor(u), np.floor(v)
        right, up = u - column, v - row
        level_weight = blend if side else 1 - blend
        lines = []
        for texel, count in ((column.astype(np.int64), columns[level]), (row.astype(np.int64), rows[level])):
            lower_index = texel % count
            upper_index = lower_index + 1
            # A remainder takes longer than all else here.
            lines.append((lower_index, np.where(upper_index == count, 0, upper_index)))
        for tap in range(4):
            index[:, 4 * side + tap] = first[level] + lines[1][tap // 2] * columns[level] + lines[0][tap % 2]
            across = right if tap % 2 else 1 - right
            along = up if tap // 2 else 1 - up
            weight[:, 4 * side + tap] = level_weight * across * along
    return index, weight


def log_fraction(size: Float, smallest: float, largest: float, arrays: Any = np) -> Float:
    """Position of a size between two others on a logarithmic scale, clipped to 0 to 1.

    Args:
        arrays: the module of the array's functions, numpy or drjit.
    """
    return arrays.clip(arrays.log(size / smallest) / math.log(largest / smallest), 0, 1)


# Smallest and largest footprint of "field", in threads; of "vector", in repeats, the smallest of at most
# `_MAX` threads. They are those of the query benchmark.
FIELD_SIZES = 1 / 64, 80.0
_REPEATS = 1 / 128, 5.0
# Sizes in threads at which the weight of a fabric's correction begins to rise from 0, and at which it is 1.
CORRECTED_SIZES = 1.0, 4.0
_MAX = 8.0
# Sizes in threads up to which footprints are read where their view ray meets yarn, and from which on they are
# read where it crosses the plane of the cloth, as rays of larger ones meet many heights.
NEAR_SIZES = 0.25, 2.0


@dataclass
class AnisotropicTaps:
    """Anisotropic taps of a footprint, in threads: one, or four at centre ± first ± second.

    Attributes:
        x, y: centre of the taps.
        side: of a tap, which is a square.
        first_x, first_y, second_x, second_y: steps from the centre; all 0 where the footprint has one tap.
    """

    x: Float
    y: Float
    side: Float
    first_x: Float
    first_y: Float
    second_x: Float
    second_y: Float

    def numbers(self) -> tuple[Float, ...]:
        """All seven."""
        return self.x, self.y, self.side, self.first_x, self.first_y, self.second_x, self.second_y

    def size(self, arrays: Any) -> Float:
        """The side of a square of the taps' area, an input of the decoder: twelve variances, to ¼.

        Args:
            arrays: the module of array functions, drjit or a kernel's `SimdMath`.
        """
        square = arrays.square(self.side)
        across, along = (
            arrays.fma(12.0, arrays.fma(first, first, arrays.square(second)), square)
            for first, second in ((self.first_x, self.second_x), (self.first_y, self.second_y))
        )
        mixed = 12.0 * arrays.fma(self.first_x, self.first_y, self.second_x * self.second_y)
        # The determinant is at least side⁴, but for rounding.
        area = arrays.maximum(across * along - arrays.square(mixed), arrays.square(square))
        return arrays.sqrt(arrays.sqrt(area))

    def place(self, number: Float, arrays: Any) -> tuple[Float, Float]:
        """Centre of tap `number`, 0 to 3: a float; of lanes with one tap, all are at the centre."""
        half = arrays.floor(0.5 * number)
        first, second = 2.0 * half - 1.0, 2.0 * number - 4.0 * half - 1.0
        return (
            arrays.fma(first, self.first_x, arrays.fma(second, self.second_x, self.x)),
            arrays.fma(first, self.first_y, arrays.fma(second, self.second_y, self.y)),
        )


def taps_of_footprint(footprint: Footprint, least: float) -> tuple[Float, Vec2, Vec2]:
    """Side of a tap and both steps [2] for a footprint, in its own unit of length; see `AnisotropicTaps`.

    Long footprints have a row of four (`Footprint.anisotropic_taps`). Others that are large enough have two
    along either edge: like the pixel's box, these vanish where threads have an odd number of periods along an
    edge and alias with the pixels. One square does not if it lies askew, and pictures show rings of moiré.

    Args:
        least: smallest side of the four taps. Latents of at least a thread are means of those of threads, so
            that their means are latents too; smaller ones are not.
    """
    types = array_types(footprint.area)
    side, step = footprint.anisotropic_taps()
    a, b = footprint.duv_dx, footprint.duv_dy
    total = dr.squared_norm(a) + dr.squared_norm(b)
    # Squared length and width, as in `Footprint.anisotropic_taps`: their sum and product.
    longest = 0.5 * (total + dr.sqrt(maximum(dr.square(total) - 4 * dr.square(footprint.area), 0)))
    is_compact = (longest < MAX_COMPACTNESS * (total - longest)) & (total > 8 * least**2)

    def steps(edge: Vec2, share: float) -> Vec2:
        compact, row = 0.25 * edge, share * step
        return types.Vector2(dr.select(is_compact, compact.x, row.x), dr.select(is_compact, compact.y, row.y))

    # A quarter of the variance is the taps' own: 12 (a/4)² is three quarters of a². A row is ±1 ± ½ steps.
    first, second = steps(a, 1), steps(b, 0.5)
    return dr.select(is_compact, dr.sqrt(0.125 * total), side), first, second


def footprint_coordinates(
    table: NetworkTable, picks: int, ends: int, x: Float, y: Float, size: Float, arrays: Any = np
) -> tuple[Float, Float, Float]:
    """Position x, y and size of footprints for the decoder, each 0 to 1.

    With latents of kind "field" positions are within a thread, as latents differ between threads; with
    "vector" they are within the repeat.

    Args:
        picks, ends: of the repeat.
        x, y, size: centre and side of footprints, in threads.
        arrays: the module of the arrays' functions, numpy or drjit.
    """
    size = arrays.maximum(size, 1e-6)
    if table.latent == "field":
        return x - arrays.floor(x), y - arrays.floor(y), log_fraction(size, *FIELD_SIZES, arrays)
    repeat = math.sqrt(picks * ends)
    smallest, largest = min(repeat, _MAX) * _REPEATS[0], repeat * _REPEATS[1]
    u, v = x / ends, y / picks
    return u - arrays.floor(u), v - arrays.floor(v), log_fraction(size, smallest, largest, arrays)


def near_weight(size: Float, arrays: Any = np) -> Float:
    """Weight, 0 to 1, of the place where the view ray meets yarn against that where it crosses the plane.

    Args:
        size: side of footprints, in threads.
    """
    return 1 - log_fraction(arrays.maximum(size, 1e-6), *NEAR_SIZES, arrays)


def fine_tuning_weight(size: Float, arrays: Any = np) -> Float:
    """Weight of a fabric's correction of the last layer, 0 to 1, for latents of kind "field".

    Args:
        size: the last of `footprint_coordinates`.
    """
    first, full = (float(log_fraction(threads, *FIELD_SIZES)) for threads in CORRECTED_SIZES)
    return arrays.clip((size - first) * (1 / (full - first)), 0, 1)


def footprints_in_threads(
    layout: ClothLayout, centres: NDArray[np.float64], sizes: NDArray[np.float64]
) -> NDArray[np.float32]:
    """Footprints [..., 3], position and side in threads, from centres [..., 2] and sides [...] in mm."""
    width, height = layout.size
    picks, ends = layout.warp_on_top.shape
    return np.stack(
        [centres[..., 0] * (ends / width), centres[..., 1] * (picks / height), sizes / mean_pitch(layout)], -1
    ).astype(np.float32)


def mean_pitch(layout: ClothLayout) -> float:
    """Geometric mean of the spacings of both families, millimetres: the unit of footprints."""
    width, height = layout.size
    picks, ends = layout.warp_on_top.shape
    return math.sqrt(width / ends * height / picks)


# --------------------------------------------------------------------------------------------- encoded fabric


def _fibre_fault(numbers: NDArray[np.float32]) -> str:
    error = Fibres.from_array(numbers).validation_error()
    return "" if error is None else f"out of range, as {error}"


def _crown(family: int, entry: int, meaning: str = "") -> Number[float]:
    """An entry of `Fibres.face` of the front."""
    return Number("float", meaning, lambda encoded: float(encoded.crowns[family, entry]))


def _lobe_roughness(family: int, meaning: str = "") -> Number[float]:
    return Number("float", meaning, lambda encoded: encoded.lobe_roughness[family])


def _last_layer(correction: NDArray[np.float32]) -> list[Layer]:
    return [(correction[:, :-1], correction[:, -1])]


class EncodedFabric(Tables):
    """The inputs of the decoder that belong to a fabric: in files, on devices and in shaders.

    Attributes:
        picks, ends: of the shortest repeat, without its colours.
    """

    record = "neural"

    is_encoded = flag("0 where the fabric has no latents")
    network = given("uint", "first element of the layers in packed_numbers", "layers")
    front: NDArray[np.float16] = table("latents of the front", ("texels", "latent_size"))
    back: NDArray[np.float16] = table("latents of the back", ("texels", "latent_size"))

    @derived("halves: latents of both faces", ("2 faces", "texels", "NEURAL_LATENT"), words="elements")
    def latents(self) -> NDArray[np.float16]:
        """In half precision, in memory as in files."""
        return np.concatenate(self.faces)

    texels = size("of one face", of="front")

    @derived("first texel, columns, rows, texels a thread of each level", (None, 4), words="words")
    def levels(self) -> NDArray[np.float32]:
        """Whole numbers below 2^24, which single precision holds exactly."""
        rows = [(level.first, level.columns, level.rows, level.per_thread) for level in self.pyramid]
        return np.array(rows, np.float32)

    @computed("the mean of the repeat")
    def top_level(self) -> int:
        """Its number."""
        return len(self.pyramid) - 1

    ends: int = number("float", "threads of the warp in the repeat of the latents")
    picks: int = number("float", "the same of the weft")
    ends_per_mm = given("float", "")
    picks_per_mm = given("float", "")
    pitch = given("float", "geometric mean of the spacings of both families")
    warp_x = _crown(0, 0, "fibre direction on the crown of a yarn of the warp, of the front")
    warp_y = _crown(0, 1)
    warp_roughness = _crown(0, 2, "α that the network sees")
    weft_x = _crown(1, 0, "the same of the weft")
    weft_y = _crown(1, 1)
    weft_roughness = _crown(1, 2)
    warp_lobe_roughness = _lobe_roughness(0, "α of the lobe that directions are sampled with")
    weft_lobe_roughness = _lobe_roughness(1)

    @derived("b and a of each lobe of the basis", ("2 families", f"{BUNDLES} lobes", 4), words="words")
    def bundles(self) -> NDArray[np.float32]:
        """See `Fibres.bundles`."""
        return self.fibres.bundles(False)

    @computed("1 where the last layer is fitted to the fabric")
    def is_corrected(self) -> int:
        """Whether there is a correction."""
        return int(self.correction is not None)

    fibre_numbers: NDArray[np.float32] = table(
        "twist, roughness, inclination and height scale of the fibres; see `Fibres`",
        (4, "2 families"),
        tensor="fibres",
        fault=_fibre_fault,
    )
    correction: NDArray[np.float32] | None = table(
        "added to the decoder's last layer, to its rows for the lobe basis, biases last; singles, as halves "
        "would round it",
        (2 * BUNDLES, "hidden + 1"),
        words="layers",
        shown=Shown((), _last_layer),
        default=None,
    )

    @classmethod
    def of(
        cls,
        repeat: tuple[int, int],
        faces: tuple[NDArray[np.float16], NDArray[np.float16]],
        fibres: Fibres,
        correction: NDArray[np.float32] | None = None,
    ) -> EncodedFabric:
        """A fabric of latents of front and back.

        Args:
            repeat: picks and ends.
        """
        picks, ends = repeat
        front, back = faces
        return cls(front, back, ends, picks, fibres.array(), correction)

    @property
    def faces(self) -> tuple[NDArray[np.float16], NDArray[np.float16]]:
        """Latents of front and back."""
        return self.front, self.back

    @cached_property
    def fibres(self) -> Fibres:
        """Of both families."""
        return Fibres.from_array(self.fibre_numbers)

    @cached_property
    def crowns(self) -> NDArray[np.float32]:
        """See `Fibres.face`, of the front."""
        return self.fibres.face(False)

    @cached_property
    def lobe_roughness(self) -> tuple[float, float]:
        """See `Fibres.lobe_roughness`."""
        return self.fibres.lobe_roughness()

    @cached_property
    def pyramid(self) -> list[Level]:
        """The levels of the latent field."""
        return levels_of(self.picks, self.ends)

    @cached_property
    def stacked(self) -> NDArray[np.float32]:
        """Front above back [2 texels, latent_size], in single precision."""
        return np.concatenate(self.faces).astype(np.float32)

    def mixed(self, other: EncodedFabric, weight: float) -> EncodedFabric:
        """Interpolates latents and fibres to another fabric of the same repeat.

        Args:
            weight: 0 is this fabric, 1 the other; other values extrapolate.

        Raises:
            InputError: repeats of different size.
        """
        if (self.picks, self.ends) != (other.picks, other.ends):
            raise InputError(
                f"fabrics of {self.ends} × {self.picks} and {other.ends} × {other.picks} threads cannot be "
                "interpolated: encode both for a common repeat."
            )
        front, back = (
            (mine + weight * (yours.astype(np.float32) - mine)).astype(np.float16)
            for mine, yours in zip(self.faces, other.faces, strict=True)
        )
        correction = None
        if self.correction is not None and other.correction is not None:
            correction = self.correction + np.float32(weight) * (other.correction - self.correction)
        fibres = self.fibres.mixed(other.fibres, weight)
        return EncodedFabric.of((self.picks, self.ends), (front, back), fibres, correction)


def sizes_of(picks: int, ends: int, network: NetworkTable) -> dict[str, int]:
    """Sizes of the tables of a repeat by a network, which files must have."""
    texels = levels_of(picks, ends)[-1].first + 1 if network.latent == "field" else 1
    return {"texels": texels, "latent_size": network.latent_size, "hidden": network.hidden}
