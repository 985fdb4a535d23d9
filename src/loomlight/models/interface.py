"""The one interface of all models: a BSDF is made once a view and footprint, and answers lights.

    at = model.at(view, footprint)
    at.hole                                   share of the view rays that pass straight through
    at.value(light)                           f(light, view)·|cos θ_light|, linear RGB, 1/sr
    at.pdf(light), at.value_and_pdf(light)
    at.sample(choice, u)
    at.value_and_null_transmission(light)
    at.value_pdf_sample_and_null_transmission(light, choice, u)

Arguments are Dr.Jit arrays of any backend: `light` and `view` unit vectors (z < 0 on the back), and a
`Footprint` in millimetres of the source. A light on the other side than the view asks for transmission.
Values leave out delta transmission, which `null_transmission` describes.

What a model stands for is its source: a fabric, or any other surface that repeats (`sources/kinds.py`).
Models whose answers separate albedos from the rest give a `SeparableBsdf` (`separable.py`).
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, ClassVar, Self

import drjit as dr

from loomlight.core.arrays import Color3, Float, Mask, Vec2, Vec3
from loomlight.core.backend import ArrayTypes, array_types
from loomlight.core.fleet import Report
from loomlight.core.footprint import Footprint
from loomlight.core.tables import Tables
from loomlight.models.options import Options
from loomlight.scattering.point import DirectionSample, Tint
from loomlight.sources.kinds import Source
from loomlight.sources.loom_file import LoomFile

# What names a parameter of a scene and holds its value: a Dr.Jit array, changed in place by edits.
Values = Mapping[str, "Parameter"]


@dataclass(frozen=True)
class Parameter:
    """A number, colour or table of a model that scenes show and set.

    Attributes:
        value: a Dr.Jit array, which edits change in place.
        differentiable: whether values of the model carry its derivatives.
        low, high: bounds of each of its numbers, both allowed.
        unit: of its numbers, such as "rad"; empty for pure numbers.
    """

    value: Any
    differentiable: bool = False
    low: float = -math.inf
    high: float = math.inf
    unit: str = ""


@dataclass(frozen=True)
class ShaderTables:
    """What shaders read of a model beside its source.

    Attributes:
        tables: which declare the record and its tables.
        given: numbers and tables that they declare as given, by name.
        of_source: fields of the record of the source, where that is no fabric.
    """

    tables: Tables
    given: Mapping[str, Any] = field(default_factory=dict)
    of_source: Mapping[str, float] = field(default_factory=dict)


class FootprintBsdf(ABC):
    """The BSDF of footprints for one view: all that no light changes is computed once.

    Attributes:
        view: unit vectors [3].
        footprint: millimetres of the source.
    """

    def __init__(self, view: Vec3, footprint: Footprint) -> None:
        self.view = view
        self.footprint = footprint

    @property
    def hole(self) -> Float:
        """Share of the view rays that pass straight through, 0 to 1; 0 for surfaces without holes."""
        return array_types(self.view.x).Float(0)

    @property
    def null_transmission(self) -> Float:
        """Share of light that passes straight through: the hole, less what lies over it."""
        return self.hole

    @property
    def roughness(self) -> Float:
        """α of what the view sees of the footprint, 0 to 1; 1, as of diffuse surfaces, if none is known."""
        return array_types(self.view.x).Float(1)

    @property
    @abstractmethod
    def diffuse_reflectance(self) -> Color3:
        """Mean diffuse albedo over the footprint, holes counted as 0."""

    @abstractmethod
    def value(self, light: Vec3, active: Mask = True) -> Color3:
        """f·cos, 1/sr; anything in lanes that are not active."""

    @abstractmethod
    def pdf(self, light: Vec3) -> Float:
        """Density of `sample` per solid angle, without delta, 1/sr."""

    @abstractmethod
    def sample(self, choice: Float, u: Vec2) -> DirectionSample:
        """A light direction; straight through holes in proportion to `null_transmission`.

        Args:
            choice: uniform number in [0, 1) that chooses the lobe.
            u: uniform numbers in [0, 1).
        """

    def value_and_pdf(self, light: Vec3, active: Mask = True) -> tuple[Color3, Float]:
        """Both; models for which that costs less than each alone override it."""
        return self.value(light, active), self.pdf(light)

    def value_and_null_transmission(self, light: Vec3, active: Mask = True) -> tuple[Color3, Float]:
        """Both; models for which that costs less than each alone override it."""
        return self.value(light, active), self.null_transmission

    def value_pdf_sample_and_null_transmission(
        self, light: Vec3, choice: Float, u: Vec2
    ) -> tuple[Color3, Float, DirectionSample, Float]:
        """Value and density of a light, a sample, and null transmission; overridden where that costs less."""
        return *self.value_and_pdf(light), self.sample(choice, u), self.null_transmission

    def to_seen_face(self, direction: Vec3) -> Vec3:
        """A direction in the frame of the face that the view sees: z is positive on its side."""
        types = array_types(self.view.x)
        z = dr.select(self.view.z < 0, -direction.z, direction.z)
        return types.Vector3(direction.x, direction.y, z)


class Model(ABC):
    """A multi-scale model of one source.

    Every model passes `tests/contract/test_models.py`, which holds it to what it claims here.

    Attributes:
        name: as the command line and assets call it.
        source_kind: of the sources that it takes, a name of `SOURCE_KINDS`; files that say what they are
            may be of other kinds.
        filters: whether it averages over the footprint; otherwise it looks at one point of it.
        conserves_energy: whether no footprint sends back more light than arrives, at any direction.
        estimates: whether answers are unbiased Monte Carlo estimates, which may be negative, shares above 1.
        symbolic: whether Dr.Jit may trace it in symbolic calls; networks are many times slower there.
        has_holes: whether light passes straight through some of its sources.
        trains: whether baking it takes minutes, of which `for_source` then reports.
        options_class: the class of `options`.
        source: what it is a model of.
        options: what was chosen beside the source.
    """

    name: ClassVar[str]
    source_kind: ClassVar[str] = "fabric"
    filters: ClassVar[bool]
    conserves_energy: ClassVar[bool]
    estimates: ClassVar[bool] = False
    symbolic: ClassVar[bool] = True
    has_holes: ClassVar[bool] = False
    trains: ClassVar[bool] = False
    options_class: ClassVar[type[Options]] = Options
    source: Source
    options: Any = Options()

    @classmethod
    @abstractmethod
    def for_source(cls, source: Source, options: Any = None, report: Report | None = None) -> Self:
        """The model baked for a source.

        Args:
            options: of `options_class`; None for the defaults.
            report: told of the progress of models that are trained; others ignore it.

        Raises:
            InputError: a source or an option that this model cannot handle; the message says why.
        """

    @abstractmethod
    def to_loom(self) -> LoomFile:
        """The contents of a `.loom` file of which `from_loom` gives the same numbers bit for bit."""

    @classmethod
    @abstractmethod
    def from_loom(cls, loom: LoomFile) -> Self:
        """The model that a `.loom` file holds, without baking.

        Raises:
            InputError: another model's file; tensors or settings that are missing or of another kind; made
                with a shared network that is not the installed one.
        """

    @abstractmethod
    def at(
        self, view: Vec3, footprint: Footprint, tint: Tint | None = None, active: Mask = True
    ) -> FootprintBsdf:
        """The BSDF of footprints as views see them.

        Args:
            view: unit vectors [3] away from the surface; z < 0 sees the back.
            footprint: millimetres of the source.
            tint: what diffuse albedos are multiplied with; None for 1. Models that keep no albedos
                apart ignore it.
            active: lanes that are asked about; answers in others may be anything.
        """

    def with_source(self, source: Source) -> Self:
        """The model of another source, with the options that this one was made with.

        Raises:
            InputError: a source that this model cannot handle.
        """
        return type(self).for_source(source, self.options)

    def on_cloth(self, footprint: Footprint) -> Footprint:
        """The footprint of the source that one of the cloth shows: the same, but for uneven threads."""
        return footprint

    def upload(self, types: ArrayTypes) -> None:
        """Puts all tables on a backend: symbolic calls may not upload any."""
        del types

    def shader_tables(self, half: bool = True) -> ShaderTables | None:
        """What shaders read beside the source; None for nothing, or where there are no shaders.

        Args:
            half: texels in half precision, else in single precision, where there are any.
        """
        del half
        return None

    @property
    def open_area(self) -> float:
        """Share of the source that is holes, 0 to 1."""
        return 0.0

    def parameters(self, types: ArrayTypes) -> Values:
        """Numbers and colours that scenes show and set, by name: read by a model that is `bound_to` them."""
        del types
        return {}

    def bound_to(self, values: Values) -> Self:
        """The model that reads its parameters from arrays, which edits change in place.

        Args:
            values: from `parameters`.
        """
        del values
        return self

    def updated(self, values: Values, changed: frozenset[str]) -> Self:
        """The model after an edit, baked anew as far as the edit asks for it.

        Args:
            values: from `parameters`, edited in place.
            changed: names of what changed.

        Raises:
            InputError: a value that cannot be; the message names it.
        """
        del values, changed
        return self

    def literals(self) -> tuple[float, ...]:
        """Numbers that kernels hold as literals: where they change, kernels are compiled anew."""
        return ()

    def facts(self) -> dict[str, str]:
        """Facts about the model for readers of a scene, by name."""
        width, height = self.source.repeat_mm
        return {"source": f'"{self.source.name}"', "repeat": f"{width:.4g} × {height:.4g} mm"}
