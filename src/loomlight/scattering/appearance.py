"""Scattering parameters of the point model: albedos a thread, roughness a family, sheen."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from loomlight.scattering.albedo import layer_albedo_bound

if TYPE_CHECKING:
    from loomlight.scattering.grazing import Grazing
    from loomlight.scattering.openness import Openness

# Of a family's albedos, in the order of their tables.
ALBEDO_NAMES = ("diffuse_reflect", "diffuse_transmit", "specular_reflect", "specular_transmit")


@dataclass(frozen=True)
class YarnDetail:
    """Plies, fibres, slubs and hairs of one family, seen close up (`detail.py`); all off by default.

    Attributes:
        plies: yarns twisted together, 1 to 12; 1 shows no plies.
        ply_twist: angle of the plies to the yarn, radians; negative for Z twist.
        fibre_tilt: standard deviation of the angles by which fibres stray, radians, 0 to π/6.
        slub: how much the thickness of the yarn varies along it, 0 to 1.
        hairiness: 0 to 1, of fibres that stand off the yarn; at 1 they cover a twelfth of the cloth.
        twist: ψ of the fibres, radians, as in the layout.
        width: of the yarn, millimetres, > 0.
    """

    plies: int = 1
    ply_twist: float = 0.0
    fibre_tilt: float = 0.0
    slub: float = 0.0
    hairiness: float = 0.0
    twist: float = 0.0
    width: float = 1.0

    @property
    def is_on(self) -> bool:
        """Whether the yarn shows anything beside its smooth surface."""
        return self.plies > 1 or max(self.fibre_tilt, self.slub, self.hairiness) > 0


@dataclass(frozen=True)
class Irregularity:
    """How the yarns of one family vary along themselves and from one to the next; all off by default.

    `scattering/irregularity.py` makes a process of it, of which footprints show means.

    Attributes:
        mass_cv: coefficient of variation of the mass of lengths of 8 mm (Uster's CVm), 0 to 0.6.
        fibre_length: of the staple, millimetres, > 0.
        thick_places: per metre of yarn, ≥ 0.
        thick_length: of one, millimetres, > 0.
        thick_size: how much more mass one has in its middle than the mean, ≥ 0; 1 is twice the mean.
        shade: deviation of the depth of shade along the yarn, of the logarithm of the dye in it, 0 to 1.
        melange: the same, of fibres of several colours mixed, which varies within millimetres, 0 to 1.
        neps: per metre of yarn, ≥ 0: small knots of fibres of another colour.
        nep_length: of one, millimetres, > 0.
        nep_albedo: its diffuse albedo, linear RGB.
    """

    mass_cv: float = 0.0
    fibre_length: float = 28.0
    thick_places: float = 0.0
    thick_length: float = 30.0
    thick_size: float = 1.0
    shade: float = 0.0
    melange: float = 0.0
    neps: float = 0.0
    nep_length: float = 4.0
    nep_albedo: tuple[float, float, float] = (0.5, 0.5, 0.5)

    @property
    def is_on(self) -> bool:
        """Whether the yarn varies at all."""
        return max(self.mass_cv, self.thick_places, self.shade, self.melange, self.neps) > 0


@dataclass(frozen=True, eq=False)
class FamilyAppearance:
    """One family of threads.

    Attributes:
        diffuse_reflect: albedo [n, 3] of the blended diffuse reflection, a row a thread, linear RGB.
        diffuse_transmit: the same for the far side [n, 3].
        specular_reflect: single-scattering albedo k_s of the fibre layer in reflection [n, 3].
        specular_transmit: the same in transmission [n, 3].
        roughness: α of the fibre SGGX distribution, 0.01 to 1.
        specular_grazing: what specular_reflect gains towards grazing, 0 to 4.
        detail: what the yarn shows close up.
        irregularity: how it varies over millimetres to metres.

    Per channel diffuse_reflect + diffuse_transmit + κ·max(specular_reflect, specular_transmit) ≤ 1, checked
    where the values are made (`scattering/albedo.py`, which has κ).
    """

    diffuse_reflect: NDArray[np.float64]
    diffuse_transmit: NDArray[np.float64]
    specular_reflect: NDArray[np.float64]
    specular_transmit: NDArray[np.float64]
    roughness: float
    detail: YarnDetail = YarnDetail()
    irregularity: Irregularity = Irregularity()
    specular_grazing: float = 0.0


@dataclass(frozen=True)
class Sheen:
    """Fly-away fibres on top (zhu2024 3.3): strength 0 to 1 scales the lobe, roughness 0 to 1."""

    strength: float = 0.0
    roughness: float = 0.4


@dataclass(frozen=True)
class Variation:
    """Procedural variation (Jin et al. 2022), seeded; all off by default.

    Attributes:
        fibre_noise: 0 to 1, how much the specular strength varies from fibre to fibre.
        colour_noise: 0 to 1, relative spread of the albedo from thread to thread.
        irregularity: 0 to 2, how much of the `Irregularity` of yarns shows; 0 is even cloth.
        seed: any 32-bit number.
    """

    fibre_noise: float = 0.0
    colour_noise: float = 0.0
    irregularity: float = 1.0
    seed: int = 0


@dataclass(frozen=True, eq=False)
class Appearance:
    """Everything that scatters in one fabric.

    Attributes:
        diffuse_blend: w, the share of the yarn normal in the blended diffuse term (chen2024 eq. 1).
        optical_depth: Tρ of the fibre layer, > 0.
        openness: of the cloth's yarns, for light between them; None scatters light of the sky once.
    """

    warp: FamilyAppearance
    weft: FamilyAppearance
    sheen: Sheen = field(default_factory=Sheen)
    variation: Variation = field(default_factory=Variation)
    diffuse_blend: float = 0.5
    optical_depth: float = 2.0
    openness: Openness | None = None

    @property
    def is_irregular(self) -> bool:
        """Whether yarns vary along themselves, and from thread to thread by the same process."""
        return self.warp.irregularity.is_on or self.weft.irregularity.is_on

    @property
    def thread_noise(self) -> float:
        """Relative spread of the albedo from thread to thread that no process of irregular yarns has."""
        return 0.0 if self.is_irregular else self.variation.colour_noise

    @property
    def grazing(self) -> Grazing:
        """How highlights rise towards grazing: the mean of both families, as yarns of a place rise alike."""
        # It needs Dr.Jit, and appearances do not.
        from loomlight.scattering.grazing import Grazing

        families = (self.warp, self.weft)
        gain, roughness = (
            sum(getattr(family, name) for family in families) / 2
            for name in ("specular_grazing", "roughness")
        )
        return Grazing.of(gain, roughness)

    @property
    def layer_bound(self) -> float:
        """κ of the energy bound that the albedos keep, of the larger highlight (`albedo.LayerBound`)."""
        if self.openness is None:
            return layer_albedo_bound(self.optical_depth)
        # It needs Dr.Jit, and appearances do not.
        from loomlight.scattering.fibre import bound_in_use, cloth_layer_bound

        return max(
            bound_in_use(
                cloth_layer_bound(family.roughness, self.optical_depth),
                family.specular_reflect,
                family.specular_transmit,
            )
            for family in (self.warp, self.weft)
        )
