"""The local frame of the whole package, and footprints: the part of the cloth that a pixel sees.

The frame and its conventions:

- ``z`` is the macro normal n_s, ``x`` = dp/du the weft direction, ``y`` = n_s × x the warp direction. On
  mirrored uv islands dp/dv points against ``y``; the draft's v is then flipped, so a Z twill stays Z.
- Directions are unit vectors pointing away from the surface, named ``light`` and ``view``. Mitsuba's
  ``si.wi`` is our ``view``; its ``wo`` argument is our ``light`` when tracing from the camera.
- Every model returns f(light, view)·|cos θ_light| in linear RGB, 1/sr.
- Lengths are millimetres, angles radians. End 1 of a draft lies at x = 0 and pick 1 at y = 0, both with
  their left or lower edge; a drawdown is ``True`` where the warp is on top.
- The back face is the front face of the cloth mirrored in the plane z = 0: drawdown inverted, twist
  negated, z of every direction negated. Scattering does not change under reflection.

A footprint is the parallelogram that a pixel covers on the plane of the cloth, or as much wider or narrower
as the film's filter asks for (`mitsuba/pixels.py`). Its points are centre + s·duv_dx + t·duv_dy with s
and t uniform in [−1/2, 1/2], so their covariance is Σ = (duv_dx duv_dxᵀ + duv_dy duv_dyᵀ)/12. Its
approximations:

- a square of the same area, for models that take one size;
- a Gaussian of σ = sqrt(area/12), the deviation of that square along each axis (kuznetsov2021);
- an axis-aligned box of the variances of Σ, width² = 12 Σ_xx and height² = 12 Σ_yy, for summed-area tables.
  The box neglects the correlation r of x and y: area / (width·height) = sqrt(1 − r²).
"""

from __future__ import annotations

from dataclasses import dataclass

import drjit as dr

from loomlight.core.arrays import Float, Vec2
from loomlight.core.backend import array_types, maximum, minimum

# Most anisotropic taps; and the ratio of squared length to squared width up to which one tap is enough.
ANISOTROPIC_TAPS = 4
MAX_RATIO_OF_ONE_TAP = 1.5


@dataclass
class Box:
    """An axis-aligned box, millimetres of draft: Vector2 each.

    Attributes:
        centre: its middle [2].
        size: width and height [2].
    """

    centre: Vec2
    size: Vec2


@dataclass
class Footprint:
    """The part of the cloth that a pixel sees, in draft coordinates, millimetres.

    Attributes:
        centre: middle of the parallelogram [2].
        duv_dx, duv_dy: its edges [2], the steps on the cloth to the next pixel along x and along y.
        samples: number of footprints that the caller averages, such as the samples of a pixel. Models that
            sample points of a footprint then use fewer points.
    """

    centre: Vec2
    duv_dx: Vec2
    duv_dy: Vec2
    samples: Float = 1

    @property
    def area(self) -> Float:
        """Square millimetres, ≥ 0."""
        return dr.abs(self.duv_dx.x * self.duv_dy.y - self.duv_dx.y * self.duv_dy.x)

    @property
    def square_side(self) -> Float:
        """Side of the square of the same area, millimetres."""
        return dr.sqrt(self.area)

    @property
    def spread_side(self) -> Float:
        """Side of the square whose variances have the same sum, millimetres.

        At least `square_side`. For square filters: for the long footprints of grazing views, means over this
        square have smaller errors than over the square of the same area, and no moiré.
        """
        return dr.sqrt(0.5 * (dr.squared_norm(self.duv_dx) + dr.squared_norm(self.duv_dy)))

    def anisotropic_taps(self) -> tuple[Float, Vec2]:
        """A row of `ANISOTROPIC_TAPS` square taps whose mean filters a long footprint, as of a grazing view.

        As in anisotropic texture filtering. The row has the footprint's sum of variances, and nearly its
        variances for footprints up to `ANISOTROPIC_TAPS` times as long as wide; taps of longer ones are
        wider. A footprint of nearly equal length and width is one tap of `spread_side`.

        Returns:
            side of a tap, millimetres, and the step [2] from one tap to the next, 0 for a single tap.
        """
        types = array_types(self.duv_dx.x)
        across = dr.square(self.duv_dx.x) + dr.square(self.duv_dy.x)
        along = dr.square(self.duv_dx.y) + dr.square(self.duv_dy.y)
        covariance = self.duv_dx.x * self.duv_dx.y + self.duv_dy.x * self.duv_dy.y
        half, mean = 0.5 * (across - along), 0.5 * (across + along)
        root = dr.sqrt(dr.square(half) + dr.square(covariance))
        # Squared length and width: twelve times the variances along the axes of the ellipse.
        long, wide = mean + root, maximum(mean - root, 0)
        excess = maximum(long - MAX_RATIO_OF_ONE_TAP * wide, 0)
        square = maximum(mean - 0.5 * excess, long * (1 / ANISOTROPIC_TAPS**2))
        # The variance of the taps' centres and that of a tap add up.
        step = dr.sqrt(maximum(minimum(excess, long - square), 0) * (1 / (ANISOTROPIC_TAPS**2 - 1)))
        cosine = half / maximum(root, 1e-30)
        x = dr.sqrt(maximum(0.5 * (1 + cosine), 0))
        y = dr.copysign(dr.sqrt(maximum(0.5 * (1 - cosine), 0)), covariance)
        return dr.sqrt(square), types.Vector2(step * x, step * y)

    def square(self) -> Box:
        """The square of the same area about the same centre."""
        side = self.square_side
        return Box(self.centre, array_types(side).Vector2(side, side))

    def box(self) -> Box:
        """The axis-aligned box of the same variances along x and y; see `box_correlation`."""
        types = array_types(self.area)
        width = dr.sqrt(dr.square(self.duv_dx.x) + dr.square(self.duv_dy.x))
        height = dr.sqrt(dr.square(self.duv_dx.y) + dr.square(self.duv_dy.y))
        return Box(self.centre, types.Vector2(width, height))

    def box_correlation(self) -> Float:
        """Correlation r of x and y over the footprint, −1 to 1, which `box` sets to 0.

        The box is larger than the footprint by 1/sqrt(1 − r²). At r = 0 the box has the footprint's area and
        second moments, and its shape only for edges along the axes: of a square turned by 45° it covers 83 %.
        """
        box = self.box().size
        covariance = self.duv_dx.x * self.duv_dx.y + self.duv_dy.x * self.duv_dy.y
        return covariance / maximum(box.x * box.y, 1e-30)

    def at(self, s: Float, t: Float) -> Vec2:
        """The point centre + s·duv_dx + t·duv_dy [2]; s and t are −1/2 to 1/2 within the footprint."""
        return self.centre + s * self.duv_dx + t * self.duv_dy


def box_footprint(box: Box) -> Footprint:
    """The footprint whose edges are those of an axis-aligned box."""
    types = array_types(box.size)
    nothing = dr.zeros(types.Float)
    return Footprint(box.centre, types.Vector2(box.size.x, nothing), types.Vector2(nothing, box.size.y))
