"""`woven_neural`: the universal network of chen2024 as a Mitsuba BSDF, for any distance, one sample a pixel.

It averages over the footprint that `footprint_path` hands it. In a symbolic call a network is ten times
slower (`loomlight.models.woven.decoder`), so that integrator does without them where such a BSDF is about.
"""

from __future__ import annotations

import os
from dataclasses import replace
from functools import cache
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np

from loomlight.aggregate.footprint_albedos import FootprintAlbedos
from loomlight.core.files import require_file
from loomlight.core.llvm import llvm_float
from loomlight.fabric.fabric import Fabric
from loomlight.mitsuba.cloth_samples import bsdf_sample, declare_lobes, plain, variant_types
from loomlight.mitsuba.cloth_uv import draft_footprint, uv_footprint
from loomlight.mitsuba.fabric_props import fabric_of, other_fabric_of, uv_size_of, with_fields
from loomlight.mitsuba.filtered_texture import FilteredTexture
from loomlight.models.interface import FamilyAlbedos
from loomlight.models.woven.decoder import Seen
from loomlight.models.woven.encoding import EncodedFabric, encode, encode_pair
from loomlight.models.woven.model import WovenModel
from loomlight.models.woven.weights import Weights, read_weights, shipped_weights
from loomlight.scattering.appearance import Appearance, FamilyAppearance
from loomlight.scattering.point import Albedos
from loomlight.yarn.geometry import YarnGeometry

_FAMILIES = ("warp", "weft")
_ALBEDOS = ("diffuse_reflect", "diffuse_transmit", "specular_reflect", "specular_transmit")
# Scene parameters of a family that need another run of the encoder, and the fields that they are.
_ENCODED = {
    "roughness": "roughness",
    "height_scale": "height_scale",
    "inclination": "inclination_deg",
    "twist": "twist_deg",
}
_ANGLES = ("inclination", "twist")


def woven_neural_class() -> type:
    """The BSDF's class in the current variant, for `mi.register_bsdf`."""
    base: Any = mi.BSDF

    class WovenNeural(base):
        """Woven cloth over footprints, by the universal network.

        Parameters (see `fabric_props` for the fabric's):
            uv_size: millimetres per unit of u and of v, "x,y" or a 2-vector; 100 mm.
            uv_scale: the same in repeats of the draft.
            albedo: a texture over the mesh's uv, averaged over footprints; the diffuse albedos are multiplied
                by it, clipped to [0, 1].
            other: a second fabric, a path or a weave's name, whose latents this one's are mixed with.
            blend: how much of the other one: 0 (default) is this one, 1 the other; beyond, extrapolated.
                Colours stay this one's.
            weights: a weights file that `loomlight train woven` wrote; by default that of the package.
            pixel_angle: angle of a pixel seen from the camera, radians, for integrators that tell no
                footprint; 0 (default).

        Scene parameters: ``warp.roughness``, ``warp.height_scale``, ``warp.inclination`` and ``warp.twist``
        (radians), the same of ``weft``: a change costs one run of the encoder. Without one: the albedos
        ``warp.diffuse_reflect`` …, ``sheen.strength`` and ``sheen.roughness`` where there is sheen, ``blend``
        and ``uv_size``. Albedos of families whose threads differ are one array ``warp.albedos``: a row a
        thread, four albedos a row, three numbers an albedo. None is differentiable.
        """

        def __init__(self, props: Any) -> None:
            super().__init__(props)
            self.fabric = fabric_of(props)
            self.other = other_fabric_of(props)
            self.uv_size = mi.Vector2f(uv_size_of(props, self.fabric))
            self.albedo = props.get_texture("albedo", 1.0) if "albedo" in props else None
            self.pixel_angle = float(props.get("pixel_angle", 0.0))
            self.weights = _weights_of(props)
            for name in ("toml", "folder"):
                props.mark_queried(name)
            dr.make_opaque(self.uv_size)
            self._blend = mi.Float(float(props.get("blend", 0.0)))
            self._numbers = _numbers_of(self.fabric)
            appearance = self.fabric.appearance()
            self._colours = {family: _colours_of(getattr(appearance, family)) for family in _FAMILIES}
            self._encode()
            self._mix()
            self._recolour()
            self._refilter()
            declare_lobes(self)

        def traverse(self, callback: Any) -> None:
            fixed = mi.ParamFlags.NonDifferentiable
            callback.put("uv_size", self.uv_size, fixed)
            for name, value in self._numbers.items():
                callback.put(name, value, fixed)
            for family, colours in self._colours.items():
                for name, value in colours.items():
                    callback.put(f"{family}.{name}", value, fixed)
            if self.other is not None:
                callback.put("blend", self._blend, fixed)
            if self.albedo is not None:
                callback.put("albedo", self.albedo, fixed)

        def parameters_changed(self, keys: Any) -> None:
            edits = self._edits()
            if edits:
                self.fabric = with_fields(self.fabric, edits)
            if any(not name.startswith("sheen.") for name in edits):
                self._encode()
            self._mix()
            self._recolour()
            if any(key.startswith("albedo") for key in keys):
                self._refilter()

        def _edits(self) -> dict[str, float]:
            """Fields of the fabric that no longer are what the scene's parameters say."""
            edits = {}
            for name, held in _numbers_of(self.fabric).items():
                value = _number(self._numbers[name])
                # Radians to degrees and back moves the last digits.
                if abs(value - _number(held)) > 1e-6:
                    family, _, parameter = name.rpartition(".")
                    field = parameter if family == "sheen" else _ENCODED[parameter]
                    edits[f"{family}.{field}"] = float(np.degrees(value)) if parameter in _ANGLES else value
            return edits

        def _encode(self) -> None:
            """Runs the encoder, or reads its cache."""
            self._encoded: tuple[EncodedFabric, ...]
            if self.other is None:
                self._encoded = (encode(self.fabric, self.weights, llvm_float()),)
            else:
                self._encoded = encode_pair(self.fabric, self.other, self.weights, llvm_float())

        def _mix(self) -> None:
            """Puts the latents where the decoder reads them."""
            latents = self._encoded[0]
            if self.other is not None:
                latents = latents.mixed(self._encoded[1], _number(self._blend))
            self.model = WovenModel(self.fabric, latents, self.weights)

        def _recolour(self) -> None:
            """Takes over the albedos."""
            held = self.fabric.appearance()
            warp, weft = (_with_colours(getattr(held, family), self._colours[family]) for family in _FAMILIES)
            self._means = FootprintAlbedos(YarnGeometry(self.fabric.layout()), Appearance(warp, weft))

        def _refilter(self) -> None:
            self._texture = None if self.albedo is None else FilteredTexture(self.albedo)

        def _seen(self, si: Any, active: Any) -> tuple[Seen, FamilyAlbedos]:
            """Everything but the light: what the view sees, and mean albedos."""
            edges, view = uv_footprint(si, self.pixel_angle), plain(si.wi)
            footprint = draft_footprint(si, self.uv_size, edges)
            warp, weft = self._means.over(footprint, view.z < 0)
            if self._texture is not None:
                tint = plain(dr.clip(self._texture.over(si, *edges, active), 0, 1))
                warp, weft = _tinted(warp, tint), _tinted(weft, tint)
            return self.model.seen(view, footprint), FamilyAlbedos(warp, weft)

        def eval(self, ctx: Any, si: Any, wo: Any, active: Any = True) -> Any:
            seen, albedos = self._seen(si, active)
            return self._value(seen, albedos, si, wo, active)

        def pdf(self, ctx: Any, si: Any, wo: Any, active: Any = True) -> Any:
            seen, albedos = self._seen(si, active)
            return self._pdf(seen, albedos, si, wo, active)

        def eval_pdf(self, ctx: Any, si: Any, wo: Any, active: Any = True) -> Any:
            seen, albedos = self._seen(si, active)
            return self._value(seen, albedos, si, wo, active), self._pdf(seen, albedos, si, wo, active)

        def sample(self, ctx: Any, si: Any, sample1: Any, sample2: Any, active: Any = True) -> Any:
            seen, albedos = self._seen(si, active)
            return self._drawn(seen, albedos, si, sample1, sample2, active)

        def eval_pdf_sample(
            self, ctx: Any, si: Any, wo: Any, sample1: Any, sample2: Any, active: Any = True
        ) -> Any:
            # What the view sees is computed once for both lights.
            seen, albedos = self._seen(si, active)
            value = self._value(seen, albedos, si, wo, active)
            pdf = self._pdf(seen, albedos, si, wo, active)
            return value, pdf, *self._drawn(seen, albedos, si, sample1, sample2, active)

        def eval_null_transmission(self, si: Any, active: Any = True) -> Any:
            view = plain(si.wi)
            footprint = draft_footprint(si, self.uv_size, uv_footprint(si, self.pixel_angle))
            hole = self.model.seen(view, footprint).hole
            return mi.Spectrum(dr.select(active, self.model.straight_through(view, hole), 0))

        def eval_diffuse_reflectance(self, si: Any, active: Any = True) -> Any:
            seen, albedos = self._seen(si, active)
            mean = 0.5 * (albedos.warp.diffuse_reflect + albedos.weft.diffuse_reflect)
            return mi.Spectrum(dr.select(active, mean * (1 - seen.hole), 0))

        def _value(self, seen: Any, albedos: Any, si: Any, wo: Any, active: Any) -> Any:
            light, view = plain(wo), plain(si.wi)
            value = self.model.composed(self.model.lit(seen, light, view), albedos, light, view)
            return mi.Spectrum(dr.select(active, value, 0))

        def _pdf(self, seen: Any, albedos: Any, si: Any, wo: Any, active: Any) -> Any:
            return dr.select(active, self.model.pdf_seen(seen, albedos, plain(wo), plain(si.wi)), 0)

        def _drawn(self, seen: Any, albedos: Any, si: Any, choice: Any, square: Any, active: Any) -> Any:
            u = variant_types().Vector2(square)
            return bsdf_sample(self.model.sample_seen(seen, albedos, plain(si.wi), choice, u), si, active)

        def to_string(self) -> str:
            width, height = self.fabric.repeat_mm
            picks, ends = self.fabric.layout().warp_on_top.shape
            other = "none" if self.other is None else f'"{self.other.name}", blend = {_number(self._blend):g}'
            return (
                f'WovenNeural[\n  fabric = "{self.fabric.name}",\n  draft = {ends} ends × {picks} picks,\n'
                f"  repeat = {width:.4g} × {height:.4g} mm,\n  other = {other},\n"
                f"  uv_size = {self.uv_size.x[0]:.6g} × {self.uv_size.y[0]:.6g} mm,\n"
                f"  albedo = {'none' if self.albedo is None else self.albedo.class_name()}\n]"
            )

    return WovenNeural


def runs_network(bsdf: Any) -> bool:
    """Whether a BSDF evaluates a network, which symbolic calls make slow."""
    return type(bsdf).__name__ == "WovenNeural"


def _weights_of(props: Any) -> Weights:
    """The network that the properties name: one object a file, so that fabrics share its kernels."""
    if "weights" not in props:
        return shipped_weights()
    path = str(props["weights"])
    require_file(path)
    return _read_once(path, os.stat(path).st_mtime_ns)


@cache
def _read_once(path: str, _modified: int) -> Weights:
    return read_weights(path)


def _numbers_of(fabric: Fabric) -> dict[str, Any]:
    """Scene parameters that are fields of the fabric: Floats."""
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
    return {name: mi.Float(float(value)) for name, value in found.items()}


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


def _number(value: Any) -> float:
    return float(np.array(value).ravel()[0])
