"""Models of fabrics: what they share, and a fabric's numbers and colours as parameters of a scene."""

from __future__ import annotations

import math
from abc import abstractmethod
from copy import copy
from dataclasses import replace
from functools import cached_property
from typing import Any, Self, final

import drjit as dr
import numpy as np
from numpy.typing import NDArray

from loomlight.aggregate.footprint_albedos import FootprintAlbedos
from loomlight.core.backend import ArrayTypes, upload
from loomlight.core.errors import InputError
from loomlight.core.footprint import Footprint
from loomlight.fabric.fabric import Fabric
from loomlight.fabric.fields import yarn_range
from loomlight.fabric.read import edited_fabric
from loomlight.models.interface import Model, Parameter, Values
from loomlight.models.live_albedos import LiveAlbedos
from loomlight.scattering.appearance import Appearance, FamilyAppearance
from loomlight.scattering.irregularity import IrregularYarns
from loomlight.scattering.point import Albedos
from loomlight.scattering.variation import Unevenness
from loomlight.sources.kinds import Source
from loomlight.sources.loom_file import LoomFile
from loomlight.weave.draft import Threads
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.stack import cloth_geometry

FAMILIES = ("warp", "weft")
ALBEDOS = ("diffuse_reflect", "diffuse_transmit", "specular_reflect", "specular_transmit")
_YARN_NUMBERS = ("height_scale", "inclination", "twist")
_GLOSS_NUMBERS = ("roughness", "specular_grazing")
# Ranges of parameters of yarns as in the fabric file, angles in degrees; others are albedos or sheen.
_ANGLES = ("inclination", "twist")
_RANGES = {
    name: yarn_range(f"{name}_deg" if name in _ANGLES else name) for name in (*_GLOSS_NUMBERS, *_YARN_NUMBERS)
}
# In single precision, and radians to degrees and back, the last digits move.
_SAME = 1e-6


class FabricModel(Model):
    """A model whose source is a fabric.

    Attributes:
        fabric: the source.
        irregular: how its yarns vary.
    """

    has_holes = True

    def __init__(self, fabric: Fabric) -> None:
        self.fabric = fabric
        self.source = fabric
        spacings = [float(np.mean(family.spacing)) for family in (fabric.layout().warp, fabric.layout().weft)]
        self._unevenness = Unevenness(fabric.appearance(), (spacings[0], spacings[1]))
        self.irregular = IrregularYarns(YarnGeometry(fabric.layout()), fabric.appearance())

    def upload(self, types: ArrayTypes) -> None:
        """Puts the numbers of uneven threads on a backend; derived classes put theirs too."""
        self._unevenness.upload(types)
        self.irregular.upload(types)

    @final
    def on_cloth(self, footprint: Footprint) -> Footprint:
        """The footprint in the draft, whose threads the cloth's wander about, thick here and thin there."""
        footprint = replace(footprint, centre=self._unevenness.place(footprint.centre))
        return self.among_irregular(footprint)

    @abstractmethod
    def among_irregular(self, footprint: Footprint) -> Footprint:
        """The footprint, whose centre is moved to where thick and thin yarns of the draft are even."""

    @property
    @final
    def open_area(self) -> float:
        """Share of the cloth that is gaps, 0 to 1."""
        return self.fabric.layout().open_area

    @final
    def facts(self) -> dict[str, str]:
        """The fabric, its draft and its repeat, and `own_facts`."""
        width, height = self.fabric.repeat_mm
        picks, ends = self.fabric.layout().warp_on_top.shape
        return {
            "fabric": f'"{self.fabric.name}"',
            "draft": f"{ends} ends × {picks} picks",
            "repeat": f"{width:.4g} × {height:.4g} mm",
            **self.own_facts(),
        }

    def own_facts(self) -> dict[str, str]:
        """Facts about this model beside those of its fabric."""
        return {}


class FilteredFabricModel(FabricModel):
    """A model of a fabric that averages over footprints: numbers of yarns and albedos are edited live.

    Scene parameters: ``warp.roughness``, ``warp.specular_grazing``, ``warp.height_scale``,
    ``warp.inclination`` and ``warp.twist`` (radians), the same of ``weft``; ``warp.color``, as fabric files
    have it, in linear RGB; the albedos ``warp.diffuse_reflect`` …; ``sheen.strength`` and ``sheen.roughness``
    where there is sheen. Where threads of a family differ, they are arrays ``warp.colors``, three numbers a
    thread, and ``warp.albedos``: a row a thread, four albedos a row, three numbers an albedo. Albedos of
    families whose threads are alike are differentiable.
    """

    filters = True

    @final
    def among_irregular(self, footprint: Footprint) -> Footprint:
        """Footprints of a thread and more stay: they show shares."""
        size = footprint.spread_side
        return replace(footprint, centre=self.irregular.place(footprint.centre, size))

    @cached_property
    def means(self) -> FootprintAlbedos:
        """Mean albedos of threads over footprints."""
        return FootprintAlbedos(cloth_geometry(self.fabric.layout()), self.fabric.appearance())

    @abstractmethod
    def with_fabric(self, fabric: Fabric, edits: frozenset[str]) -> Self:
        """The model of a fabric that differs in the parameters named `edits`: "warp.twist", …"""

    def upload(self, types: ArrayTypes) -> None:
        """Puts albedos on a backend; derived classes put theirs too."""
        super().upload(types)
        self.means.upload(types)

    def literals(self) -> tuple[float, ...]:
        """Sheen, the share of the yarn normal in diffuse terms, and the rise of highlights."""
        appearance = self.fabric.appearance()
        sheen, grazing = appearance.sheen, appearance.grazing
        return sheen.strength, sheen.roughness, appearance.diffuse_blend, grazing.gain, grazing.loss

    def parameters(self, types: ArrayTypes) -> Values:
        """Numbers and albedos of the fabric."""
        found = {
            name: parameter_of(name, types.Float(value))
            for name, value in _numbers_of(self.fabric).items()
            if self.fabric.appearance().sheen.strength > 0 or not name.startswith("sheen.")
        }
        for family in FAMILIES:
            values = _albedo_values(getattr(self.fabric.appearance(), family), types)
            for name, value in values.items():
                found[f"{family}.{name}"] = parameter_of(name, value, name in ALBEDOS)
        return {**found, **colour_parameters(self.fabric, types)}

    def bound_to(self, values: Values) -> Self:
        """The model that reads albedos of families whose threads are alike from arrays, with derivatives."""
        return self.with_means(_means_of(self.fabric, self.fabric.appearance(), values))

    @final
    def with_means(self, means: FootprintAlbedos) -> Self:
        """The model with other mean albedos of threads; tables know nothing of albedos and are shared."""
        model = copy(self)
        model.means = means
        return model

    def updated(self, values: Values, changed: frozenset[str]) -> Self:
        """The model after an edit: what a change of colours leaves alone is kept."""
        changed |= recolour(self.fabric, values, changed)
        held = {name: number for name, number in _numbers_of(self.fabric).items() if name in values}
        edits = {
            name: number
            for name, number in ((name, number_of(values[name])) for name in held)
            if abs(number - held[name]) > _SAME
        }
        model = self
        if edits:
            fabric = edited_fabric(self.fabric, dict(_field(*edit) for edit in edits.items()))
            model = self.with_fabric(fabric, frozenset(edits))
            model = model.with_means(self.means.with_openness(fabric.appearance()))
        if any(_is_albedo(name) for name in changed):
            appearance = appearance_of(model.fabric, values)
            model = model.with_means(_means_of(model.fabric, appearance, values))
        return model


def fabric_source(source: Source, model: str) -> Fabric:
    """The source as a fabric.

    Raises:
        InputError: it is none.
    """
    if not isinstance(source, Fabric):
        raise InputError(f"{source.name} is no fabric, and the model {model} takes nothing else.")
    return source


def plane_source(source: Source, model: str) -> Fabric:
    """The source as a fabric whose threads lie in one plane.

    Raises:
        InputError: it is none, or layered cloth.
    """
    fabric = fabric_source(source, model)
    layers = fabric.layout().depth
    if layers > 1:
        raise InputError(
            f"{fabric.name} has {layers} layers of cloth, and the model {model} shows a single one: "
            "use lobes, samples, point, neumip or latent."
        )
    return fabric


def fabric_in_loom(loom: LoomFile, model: str) -> Fabric:
    """The fabric of a `.loom` of a model.

    Raises:
        InputError: another model's file, or one whose source is no fabric.
    """
    loom.require_model(model)
    return fabric_source(loom.source, model)


def number_of(value: Any) -> float:
    """The number that a Dr.Jit array of one holds, or that a parameter of one does."""
    array = value.value if isinstance(value, Parameter) else value
    return float(array[0])


def _numbers_of(fabric: Fabric) -> dict[str, float]:
    """Scene parameters that are fields of the fabric."""
    layout, appearance = fabric.layout(), fabric.appearance()
    found = {}
    for family in FAMILIES:
        for name in _GLOSS_NUMBERS:
            found[f"{family}.{name}"] = getattr(getattr(appearance, family), name)
        for name in _YARN_NUMBERS:
            found[f"{family}.{name}"] = getattr(getattr(layout, family), name)
    found["sheen.strength"] = appearance.sheen.strength
    found["sheen.roughness"] = appearance.sheen.roughness
    return {name: float(value) for name, value in found.items()}


def parameter_of(name: str, value: Any, differentiable: bool = False) -> Parameter:
    """The parameter of a fabric `name`, "warp.twist" or "diffuse_reflect", with the range of its field."""
    field = name.rpartition(".")[2]
    if name.startswith("sheen.") or field not in _RANGES:
        return Parameter(value, differentiable, 0.0, 1.0)
    low, high = _RANGES[field]
    if field in _ANGLES:
        return Parameter(value, differentiable, math.radians(low), math.radians(high), "rad")
    return Parameter(value, differentiable, low, high)


def _field(name: str, value: float) -> tuple[str, float]:
    """The field of the fabric file that a scene parameter is, and its value there.

    A bound of its range in single precision may lie a digit beyond it.
    """
    field = name.rpartition(".")[2]
    if field in _ANGLES:
        name, value = f"{name}_deg", math.degrees(value)
    low, high = _RANGES[field] if not name.startswith("sheen.") and field in _RANGES else (0.0, 1.0)
    nearest = min(max(value, low), high)
    return name, nearest if math.isclose(value, nearest, rel_tol=_SAME) else value


def _albedo_values(family: FamilyAppearance, types: ArrayTypes) -> dict[str, Any]:
    """Albedos as scene parameters: a colour each, or one array where threads differ."""
    rows = np.stack([np.asarray(getattr(family, name), np.float64) for name in ALBEDOS], axis=1)
    if np.allclose(rows, rows[:1], rtol=0, atol=1e-12):
        return {name: types.Color3(*row.tolist()) for name, row in zip(ALBEDOS, rows[0], strict=True)}
    return {"albedos": upload(types.Float, rows)}


def colour_parameters(fabric: Fabric, types: ArrayTypes) -> Values:
    """Colours of both families as scene parameters: `warp.color`, or `warp.colors` where threads differ."""
    found = {}
    for family in FAMILIES:
        threads: Threads = getattr(fabric.draft, family)
        rows = np.asarray(threads.colors, np.float64)
        if (rows == rows[:1]).all():
            found[f"{family}.color"] = parameter_of("color", types.Color3(*rows[0].tolist()))
        else:
            found[f"{family}.colors"] = parameter_of("colors", upload(types.Float, rows))
    return found


def recolour(fabric: Fabric, values: Values, changed: frozenset[str]) -> frozenset[str]:
    """Gives the albedos of scene parameters the values of edited colours, and returns their names.

    Albedos that are edited too keep their values.
    """
    written = set()
    for family in FAMILIES:
        for name in changed & {f"{family}.color", f"{family}.colors"}:
            colours = np.broadcast_to(
                _numbers(values[name]).reshape(-1, 3), (len(getattr(fabric.draft, family).colors), 3)
            )
            appearance = fabric.recoloured(family, colours)
            for albedo in (f"{family}.{part}" for part in (*ALBEDOS, "albedos")):
                if albedo in values and albedo not in changed:
                    _write_albedos(values[albedo].value, appearance, albedo.rpartition(".")[2])
                    written.add(albedo)
    return frozenset(written)


def _write_albedos(array: Any, appearance: FamilyAppearance, name: str) -> None:
    """Changes an albedo of threads that are alike, or the table of all, in place."""
    if name in ALBEDOS:
        for channel, value in enumerate(getattr(appearance, name)[0].tolist()):
            array[channel] = type(array[channel])(value)
        return
    rows = np.stack([getattr(appearance, part) for part in ALBEDOS], axis=1)
    # The point model pads each albedo to four numbers.
    padding = dr.width(array) // rows[..., 0].size - 3
    array[:] = type(array)(np.pad(rows, ((0, 0), (0, 0), (0, padding))).astype(np.float32).ravel())


def _is_albedo(name: str) -> bool:
    return name.rpartition(".")[2] in (*ALBEDOS, "albedos")


def _means_of(fabric: Fabric, appearance: Appearance, values: Values) -> FootprintAlbedos:
    """Mean albedos of a fabric; those of families whose threads are alike are the scene's arrays."""
    shared = [_shared_albedos(family, values) for family in FAMILIES]
    return LiveAlbedos(cloth_geometry(fabric.layout()), appearance, *shared)


def appearance_of(fabric: Fabric, values: Values) -> Appearance:
    """The appearance of a fabric with the albedos of its scene parameters."""
    held = fabric.appearance()
    warp, weft = (_with_albedos(getattr(held, family), family, values) for family in FAMILIES)
    return replace(held, warp=warp, weft=weft)


def _shared_albedos(family: str, values: Values) -> Albedos | None:
    """The scene's own albedos of a family whose threads are alike; None where they differ."""
    if f"{family}.albedos" in values:
        return None
    shared = [values[f"{family}.{albedo}"].value for albedo in ALBEDOS]
    # Literals would be compiled into kernels.
    dr.make_opaque(shared)
    return Albedos(*shared)


def _with_albedos(family: FamilyAppearance, name: str, values: Values) -> FamilyAppearance:
    threads = len(family.diffuse_reflect)
    if f"{name}.albedos" in values:
        rows = _numbers(values[f"{name}.albedos"]).reshape(threads, len(ALBEDOS), 3)
    else:
        shared = [_numbers(values[f"{name}.{albedo}"]).reshape(3) for albedo in ALBEDOS]
        rows = np.tile(np.stack(shared), (threads, 1, 1))
    reflect, transmit, specular, specular_transmit = (rows[:, number] for number in range(len(ALBEDOS)))
    return FamilyAppearance(
        reflect,
        transmit,
        specular,
        specular_transmit,
        roughness=family.roughness,
        detail=family.detail,
        specular_grazing=family.specular_grazing,
    )


def _numbers(parameter: Parameter) -> NDArray[np.float64]:
    return np.array(dr.detach(parameter.value), np.float64)
