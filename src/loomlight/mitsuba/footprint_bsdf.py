"""What BSDFs of multi-scale models share: a fabric, a footprint and albedos in, Mitsuba's calls out."""

from __future__ import annotations

import math
from abc import abstractmethod
from dataclasses import replace
from typing import Any, Protocol

import drjit as dr
import mitsuba as mi
import numpy as np

from loomlight.aggregate.footprint_albedos import FootprintAlbedos
from loomlight.core.backend import clip
from loomlight.core.footprint import Footprint
from loomlight.core.pytree import leaves
from loomlight.fabric.fabric import Fabric
from loomlight.mitsuba.cloth_samples import bsdf_sample, declare_lobes, plain, variant_types
from loomlight.mitsuba.cloth_uv import draft_footprint, uv_footprint
from loomlight.mitsuba.fabric_props import fabric_of, number_of_props, uv_size_of, with_fields
from loomlight.mitsuba.filtered_texture import FilteredTexture
from loomlight.models.interface import FamilyAlbedos, Response
from loomlight.scattering.appearance import Appearance, FamilyAppearance
from loomlight.scattering.point import Albedos, DirectionSample
from loomlight.yarn.geometry import YarnGeometry

_FAMILIES = ("warp", "weft")
_ALBEDOS = ("diffuse_reflect", "diffuse_transmit", "specular_reflect", "specular_transmit")
# Scene parameters of a family that are fields of the fabric file.
_FIELDS = {
    "roughness": "roughness",
    "height_scale": "height_scale",
    "inclination": "inclination_deg",
    "twist": "twist_deg",
}
_ANGLES = ("inclination", "twist")
# Cloth with less open area than this casts the shadow of one without: a thousandth of the light, which is
# three steps of 8-bit sRGB on white cloth where nothing else brightens the shadow.
_SMALLEST_OPEN_AREA = 1e-3


class SeenCloth(Protocol):
    """What a view sees of footprints, for any light; directions are unit vectors [3]."""

    def response(self, light: Any, lit: Any = True) -> Response:
        """Components towards the view, free of albedos.

        Args:
            lit: lanes where components count; what is left out elsewhere may be anything, but for the hole.
        """

    def pdf(self, light: Any) -> Any:
        """Density of `sample` per solid angle, without delta: Float, 1/sr."""

    def response_and_pdf(self, light: Any) -> tuple[Response, Any]:
        """Both, for less than each alone."""

    def sample(self, choice: Any, u: Any) -> DirectionSample:
        """A light direction; see `Model.sample`."""

    def respond_and_sample(self, light: Any, choice: Any, u: Any) -> tuple[Response, Any, DirectionSample]:
        """Response and density of a light, and a sample: for less than each alone."""


def footprint_bsdf_class() -> type:
    """The base class in the current variant; plugins derive from it."""
    base: Any = mi.BSDF

    class FootprintBsdf(base):
        """Woven cloth over footprints, by a model that averages over them.

        Parameters (see `fabric_props` for the fabric's):
            uv_size: millimetres per unit of u and of v, "x,y" or a 2-vector; 100 mm.
            uv_scale: the same in repeats of the draft.
            albedo: a texture over the mesh's uv, averaged over footprints; the diffuse albedos are multiplied
                by it, clipped to [0, 1].
            pixel_angle: angle of a pixel seen from the camera, radians, for integrators that tell no
                footprint; 0 (default).

        Scene parameters: ``warp.roughness``, ``warp.height_scale``, ``warp.inclination`` and ``warp.twist``
        (radians), the same of ``weft``; the albedos ``warp.diffuse_reflect`` …; ``sheen.strength`` and
        ``sheen.roughness`` where there is sheen; ``uv_size``. Albedos of families whose threads differ are
        one array ``warp.albedos``: a row a thread, four albedos a row, three numbers an albedo. None is
        differentiable.

        A derived class reads its own properties in its constructor, whose last step is `finish`.

        Attributes:
            baked_parameters: scene parameters of a family that `bake` depends on; colours never are.
            symbolic: it is called in symbolic calls, where nothing can be uploaded any more.
            fabric: as the scene's parameters have it, but for its colours.
            model: of that fabric.
            own_parameters: scene parameters of the derived class, by name.
            pixel_samples, pixel_samples_told: how many samples share a pixel, which `footprint_path` tells.
            arrays: all that it holds, for frozen functions.
            lets_light_through: whether as much goes straight through holes that it would be seen in a shadow.
            literals: numbers of the fabric that kernels hold: where they change, they are compiled anew.
        """

        baked_parameters: tuple[str, ...]
        symbolic: bool

        def __init__(self, props: Any) -> None:
            super().__init__(props)
            self.fabric = fabric_of(props)
            self.uv_size = mi.Vector2f(uv_size_of(props, self.fabric))
            self.albedo = props.get_texture("albedo", 1.0) if "albedo" in props else None
            radians = "an angle in radians, such as 0.001"
            self.pixel_angle = number_of_props(props, "pixel_angle", 0.0, radians, least=0.0)
            for name in ("toml", "folder"):
                props.mark_queried(name)
            dr.make_opaque(self.uv_size)
            self.pixel_samples = dr.opaque(mi.Float, 1)
            self.pixel_samples_told = 1
            self.own_parameters: dict[str, Any] = {}
            self.arrays: list[Any] = []
            self.lets_light_through = True
            self.literals: tuple[float, ...] = ()
            declare_lobes(self)

        def finish(self) -> None:
            """Bakes and assembles the model of the fabric, whose numbers become the scene's parameters."""
            self._held = _numbers_of(self.fabric)
            self._numbers = {name: mi.Float(value) for name, value in self._held.items()}
            appearance = self.fabric.appearance()
            self._colours = {family: _colours_of(getattr(appearance, family)) for family in _FAMILIES}
            self.bake()
            self.model = self.assembled()
            self._recolour()
            self._refilter()
            self._settle(self.symbolic)

        def weave(self, fabric: Fabric) -> None:
            """Becomes the BSDF of another fabric; `mi.traverse` has to be called again.

            A BSDF put in its place would be another instance, for which kernels are compiled anew.
            """
            self.fabric = fabric
            self.finish()

        @abstractmethod
        def bake(self) -> None:
            """Works out what of the model depends on `baked_parameters`."""

        @abstractmethod
        def assembled(self) -> Any:
            """The model of `fabric` from what was baked last."""

        @abstractmethod
        def seen_cloth(self, albedos: FamilyAlbedos, view: Any, footprint: Footprint) -> SeenCloth:
            """What a view [3] sees of footprints."""

        @abstractmethod
        def mean_albedos(self, means: FootprintAlbedos, view: Any, footprint: Footprint) -> FamilyAlbedos:
            """Albedos of the threads that a view [3] sees in footprints."""

        @abstractmethod
        def hole(self, view: Any, footprint: Footprint) -> Any:
            """Share of the view rays that pass through footprints: Float."""

        def traverse(self, callback: Any) -> None:
            fixed = mi.ParamFlags.NonDifferentiable
            callback.put("uv_size", self.uv_size, fixed)
            for name, value in self._numbers.items():
                callback.put(name, value, fixed)
            for family, colours in self._colours.items():
                for name, value in colours.items():
                    callback.put(f"{family}.{name}", value, fixed)
            for name, value in self.own_parameters.items():
                callback.put(name, value, fixed)
            if self.albedo is not None:
                callback.put("albedo", self.albedo, fixed)

        def parameters_changed(self, keys: Any) -> None:
            edits = self._edits()
            if edits:
                self.fabric = with_fields(self.fabric, dict(_field(*edit) for edit in edits.items()))
                self._held = _numbers_of(self.fabric)
            if any(name.rpartition(".")[2] in self.baked_parameters for name in edits):
                self.bake()
            anew = bool(edits) or any(key in self.own_parameters for key in keys)
            if anew:
                self.model = self.assembled()
            if self._may_colour(keys):
                self._recolour()
            if any(key.startswith("albedo") for key in keys):
                self._refilter()
            self._settle(self.symbolic and anew)

        def _edits(self) -> dict[str, float]:
            """Scene parameters that no longer are what the fabric says."""
            values = {name: number_of(value) for name, value in self._numbers.items()}
            # In single precision, and radians to degrees and back, the last digits move.
            return {name: value for name, value in values.items() if abs(value - self._held[name]) > 1e-6}

        def _may_colour(self, keys: Any) -> bool:
            """Whether an edit of some scene parameters, all where none is named, may be one of colours."""
            # Mitsuba names what lies deeper by the last part of its name.
            colours = {name for family in self._colours.values() for name in family}
            return not keys or any(key.rpartition(".")[2] in colours for key in keys)

        def _settle(self, with_model: bool) -> None:
            """Uploads what calls use: what is uploaded at first use must not meet a symbolic call."""
            # Equal literals are one variable until one is edited, which frozen functions would notice.
            dr.make_opaque(self._numbers, self._colours, self.own_parameters)
            if with_model:
                self.model.upload(variant_types())
            self._means.upload(variant_types())
            # Dr.Jit looks for arrays in the attributes of BSDFs, and no deeper.
            self.arrays = []
            self.arrays = leaves(self)
            appearance = self.fabric.appearance()
            sheen = appearance.sheen
            self.lets_light_through = self.fabric.layout().open_area > _SMALLEST_OPEN_AREA
            self.literals = (
                sheen.strength,
                sheen.roughness,
                appearance.diffuse_blend,
                float(self.lets_light_through),
            )

        def _recolour(self) -> None:
            """Takes over the albedos."""
            held = self.fabric.appearance()
            warp, weft = (_with_colours(getattr(held, family), self._colours[family]) for family in _FAMILIES)
            self._means = FootprintAlbedos(YarnGeometry(self.fabric.layout()), Appearance(warp, weft))

        def _refilter(self) -> None:
            self._texture = None if self.albedo is None else FilteredTexture(self.albedo)

        def _footprint(self, si: Any) -> Footprint:
            footprint = draft_footprint(si, self.uv_size, uv_footprint(si, self.pixel_angle))
            return replace(footprint, samples=self.pixel_samples)

        def _albedos(self, si: Any, footprint: Footprint, active: Any) -> FamilyAlbedos:
            view = plain(si.wi)
            albedos = self.mean_albedos(self._means, view, footprint)
            if self._texture is not None:
                edges = uv_footprint(si, self.pixel_angle)
                tint = plain(clip(self._texture.over(si, *edges, active), 0, 1))
                albedos = FamilyAlbedos(_tinted(albedos.warp, tint), _tinted(albedos.weft, tint))
            return albedos

        def _seen(self, si: Any, active: Any) -> tuple[SeenCloth, FamilyAlbedos]:
            """Everything but the light: what the view sees, and mean albedos."""
            footprint = self._footprint(si)
            albedos = self._albedos(si, footprint, active)
            return self.seen_cloth(albedos, plain(si.wi), footprint), albedos

        def eval(self, ctx: Any, si: Any, wo: Any, active: Any = True) -> Any:
            seen, albedos = self._seen(si, active)
            return self._value(seen.response(plain(wo)), albedos, si, wo, active)

        def pdf(self, ctx: Any, si: Any, wo: Any, active: Any = True) -> Any:
            seen, _ = self._seen(si, active)
            return dr.select(active, seen.pdf(plain(wo)), 0)

        def eval_pdf(self, ctx: Any, si: Any, wo: Any, active: Any = True) -> Any:
            return self._value_and_pdf(*self._seen(si, active), si, wo, active)

        def sample(self, ctx: Any, si: Any, sample1: Any, sample2: Any, active: Any = True) -> Any:
            return self._drawn(self._seen(si, active)[0], si, sample1, sample2, active)

        def eval_pdf_sample(
            self, ctx: Any, si: Any, wo: Any, sample1: Any, sample2: Any, active: Any = True
        ) -> Any:
            # What the view sees is computed once for both lights.
            seen, albedos = self._seen(si, active)
            u = variant_types().Vector2(sample2)
            response, pdf, drawn = seen.respond_and_sample(plain(wo), sample1, u)
            value = self._value(response, albedos, si, wo, active)
            return value, dr.select(active, pdf, 0), *bsdf_sample(drawn, si, active)

        def eval_and_null_transmission(
            self, ctx: Any, si: Any, wo: Any, active: Any = True, entering: Any = True
        ) -> tuple[Any, Any]:
            """`eval` of active lanes and `eval_null_transmission` of entering ones, for less than both."""
            seen, albedos = self._seen(si, active)
            # In shadow the cloth is asked for its holes alone.
            response = seen.response(plain(wo), active)
            through = self.model.straight_through(plain(si.wi), response.hole)
            value = self._value(response, albedos, si, wo, active)
            return value, mi.Spectrum(dr.select(entering, through, 0))

        def eval_null_transmission(self, si: Any, active: Any = True) -> Any:
            view = plain(si.wi)
            through = self.model.straight_through(view, self.hole(view, self._footprint(si)))
            return mi.Spectrum(dr.select(active, through, 0))

        def eval_diffuse_reflectance(self, si: Any, active: Any = True) -> Any:
            footprint = self._footprint(si)
            albedos = self._albedos(si, footprint, active)
            mean = 0.5 * (albedos.warp.diffuse_reflect + albedos.weft.diffuse_reflect)
            return mi.Spectrum(dr.select(active, mean * (1 - self.hole(plain(si.wi), footprint)), 0))

        def _value(self, response: Response, albedos: Any, si: Any, wo: Any, active: Any) -> Any:
            value = self.model.composed(response, albedos, plain(wo), plain(si.wi))
            return mi.Spectrum(dr.select(active, value, 0))

        def _value_and_pdf(self, seen: Any, albedos: Any, si: Any, wo: Any, active: Any) -> Any:
            response, pdf = seen.response_and_pdf(plain(wo))
            return self._value(response, albedos, si, wo, active), dr.select(active, pdf, 0)

        def _drawn(self, seen: Any, si: Any, choice: Any, square: Any, active: Any) -> Any:
            return bsdf_sample(seen.sample(choice, variant_types().Vector2(square)), si, active)

        def described(self, **own: str) -> str:
            """What `to_string` says: the class, the fabric and its scale, and facts of the derived class."""
            width, height = self.fabric.repeat_mm
            picks, ends = self.fabric.layout().warp_on_top.shape
            facts = {
                "fabric": f'"{self.fabric.name}"',
                "draft": f"{ends} ends × {picks} picks",
                "repeat": f"{width:.4g} × {height:.4g} mm",
                **own,
                "uv_size": f"{self.uv_size.x[0]:.6g} × {self.uv_size.y[0]:.6g} mm",
                "albedo": "none" if self.albedo is None else self.albedo.class_name(),
            }
            lines = ",\n".join(f"  {name} = {fact}" for name, fact in facts.items())
            return f"{type(self).__name__}[\n{lines}\n]"

    return FootprintBsdf


def number_of(value: Any) -> float:
    """The number that a Dr.Jit array of one holds."""
    return float(value[0])


def _numbers_of(fabric: Fabric) -> dict[str, float]:
    """Scene parameters that are fields of the fabric."""
    layout, appearance = fabric.layout(), fabric.appearance()
    found = {}
    for family in _FAMILIES:
        yarn = getattr(layout, family)
        found[f"{family}.roughness"] = getattr(appearance, family).roughness
        for name in ("height_scale", "inclination", "twist"):
            found[f"{family}.{name}"] = getattr(yarn, name)
    if appearance.sheen.strength > 0:
        found["sheen.strength"] = appearance.sheen.strength
        found["sheen.roughness"] = appearance.sheen.roughness
    return {name: float(value) for name, value in found.items()}


def _field(name: str, value: float) -> tuple[str, float]:
    """The field of the fabric file that a scene parameter is, and its value there."""
    family, _, parameter = name.rpartition(".")
    if family == "sheen":
        return name, value
    return f"{family}.{_FIELDS[parameter]}", math.degrees(value) if parameter in _ANGLES else value


def _colours_of(family: FamilyAppearance) -> dict[str, Any]:
    """Albedos as scene parameters: a colour each, or one array where threads differ."""
    rows = np.stack([np.asarray(getattr(family, name), np.float64) for name in _ALBEDOS], axis=1)
    if np.allclose(rows, rows[:1], rtol=0, atol=1e-12):
        return {name: mi.Color3f(value) for name, value in zip(_ALBEDOS, rows[0], strict=True)}
    return {"albedos": mi.Float(rows.astype(np.float32).ravel())}


def _with_colours(family: FamilyAppearance, colours: dict[str, Any]) -> FamilyAppearance:
    """A family with the albedos of its scene parameters."""
    threads = len(family.diffuse_reflect)
    if "albedos" in colours:
        rows = np.array(colours["albedos"], np.float64).reshape(threads, len(_ALBEDOS), 3)
    else:
        shared = np.stack([np.array(colours[name], np.float64).reshape(3) for name in _ALBEDOS])
        rows = np.tile(shared, (threads, 1, 1))
    named = {name: rows[:, number] for number, name in enumerate(_ALBEDOS)}
    return FamilyAppearance(**named, roughness=family.roughness)


def _tinted(albedos: Albedos, tint: Any) -> Albedos:
    return replace(
        albedos,
        diffuse_reflect=albedos.diffuse_reflect * tint,
        diffuse_transmit=albedos.diffuse_transmit * tint,
    )
