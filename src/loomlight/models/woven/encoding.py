"""A fabric's latents: one run of the encoder a face, kept in memory and on disk."""

from __future__ import annotations

import hashlib
import math
import warnings
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache, cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray
from safetensors import SafetensorError
from safetensors.numpy import load_file, save_file

from loomlight.core.errors import InputError, LoomlightError, LoomlightWarning
from loomlight.core.extras import import_extra
from loomlight.core.files import cache_folder, replacing
from loomlight.fabric.defaults import Structure, structure_of
from loomlight.fabric.fabric import Fabric
from loomlight.models.woven.architecture import FIELD_MAP, MOST_THREADS, VECTOR_MAP
from loomlight.models.woven.box import PARAMETER_BOX, TRAINING_BOX, ParameterBox
from loomlight.models.woven.fibres import Fibres
from loomlight.models.woven.maps import face_maps
from loomlight.models.woven.pool import fabric_parameters
from loomlight.models.woven.pyramid import Level, levels_of
from loomlight.models.woven.weights import Weights
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout, FamilyLayout

# Part of every key: to be raised when maps of the same layout change.
_VERSION = 2
# Fabrics kept in memory, and texels above which a fabric is not kept on disk (8 MB of half precision).
_KEPT = 64
_LARGEST_KEPT = 1 << 16
# Of values that a file gives in other units, or that are computed.
_ROUNDING = 1e-3
_kept: OrderedDict[str, EncodedFabric] = OrderedDict()


@dataclass(frozen=True, eq=False)
class EncodedFabric:
    """What the decoder needs of a fabric.

    Attributes:
        picks, ends: of the shortest repeat, without its colours.
        faces: latents of front and back [texels, latent_size], in half precision: what they are computed and
            stored with are the same numbers.
        fibres: of both families.
        correction: what is added to the decoder's last layer, to its rows for bundles [2 · `BUNDLES`,
            hidden + 1], biases last; None where it is that of all fabrics. See `refinement.py`.
    """

    picks: int
    ends: int
    faces: tuple[NDArray[np.float16], NDArray[np.float16]]
    fibres: Fibres
    correction: NDArray[np.float32] | None = None

    @property
    def levels(self) -> list[Level]:
        """Where each level of a field begins."""
        return levels_of(self.picks, self.ends)

    @cached_property
    def both(self) -> NDArray[np.float32]:
        """Front above back [2 texels, latent_size], in single precision."""
        return np.concatenate(self.faces).astype(np.float32)

    def mixed(self, other: EncodedFabric, share: float) -> EncodedFabric:
        """Latents and fibres between this fabric (0) and another of the same repeat (1), or beyond them.

        Raises:
            InputError: repeats of different size.
        """
        if (self.picks, self.ends) != (other.picks, other.ends):
            raise InputError(
                f"fabrics of {self.ends} × {self.picks} and {other.ends} × {other.picks} threads cannot be "
                "interpolated: encode both for a common repeat."
            )
        front, back = (
            (mine + share * (yours.astype(np.float32) - mine)).astype(np.float16)
            for mine, yours in zip(self.faces, other.faces, strict=True)
        )
        correction = None
        if self.correction is not None and other.correction is not None:
            correction = self.correction + np.float32(share) * (other.correction - self.correction)
        fibres = self.fibres.mixed(other.fibres, share)
        return EncodedFabric(self.picks, self.ends, (front, back), fibres, correction)


def encode(
    fabric: Fabric,
    weights: Weights,
    float_type: type,
    repeats: tuple[int, int] = (1, 1),
    refined: bool = False,
) -> EncodedFabric:
    """The latents of both faces, from the cache where they are in it.

    Args:
        float_type: the Dr.Jit Float type that the encoder's maps are computed with.
        repeats: how often the repeat is laid along picks and along ends, for a common repeat of two fabrics.
        refined: whether the last layer is fitted to the fabric, which takes seconds (`refinement.py`), where
            the network mixes bundles and has a latent field; otherwise it is that of all fabrics.

    Raises:
        InputError: a repeat of more than 64 threads a side.
    """
    require_encodable(fabric)
    picks, ends = (count * times for count, times in zip(repeat_threads(fabric), repeats, strict=True))
    warn_outside_box(fabric, trained_box(weights))
    refined = refined and weights.table.bundles and weights.table.latent == "field"
    key = _key(fabric, weights, repeats, refined)
    found = _kept.get(key) or _read(key, picks, ends, weights, Fibres.of(fabric), refined)
    if found is None and refined:
        found = _refined(fabric, weights, float_type, repeats)
    if found is None:
        found = _run(fabric, weights, float_type, repeats)
    if key not in _kept:
        _write(key, found)
    _kept[key] = found
    _kept.move_to_end(key)
    while len(_kept) > _KEPT:
        _kept.popitem(last=False)
    return found


def require_encodable(fabric: Fabric) -> None:
    """Returns if the encoder takes the fabric.

    Raises:
        InputError: a repeat of more than 64 threads a side.
    """
    picks, ends = repeat_threads(fabric)
    if max(picks, ends) > MOST_THREADS:
        raise InputError(
            f"{fabric.name}: its repeat of {ends} ends × {picks} picks is too large for the model woven, "
            f'which takes up to {MOST_THREADS} a side: use the model "point".'
        )


def encode_pair(
    first: Fabric, second: Fabric, weights: Weights, float_type: type, refined: bool = False
) -> tuple[EncodedFabric, EncodedFabric]:
    """Two fabrics on their common repeat, to be interpolated.

    Raises:
        InputError: a common repeat of more than 64 threads a side.
    """
    mine, yours = repeat_threads(first), repeat_threads(second)
    common = [math.lcm(a, b) for a, b in zip(mine, yours, strict=True)]
    if max(common) > MOST_THREADS:
        raise InputError(
            f"{first.name} and {second.name} have a common repeat of {common[1]} ends × {common[0]} picks: "
            f"latents are interpolated up to {MOST_THREADS} a side."
        )
    one, other = (
        encode(fabric, weights, float_type, (common[0] // threads[0], common[1] // threads[1]), refined)
        for fabric, threads in ((first, mine), (second, yours))
    )
    return one, other


def clear_encodings() -> None:
    """Forgets what is kept in memory."""
    _kept.clear()


def trained_box(weights: Weights) -> ParameterBox:
    """What the network was trained for."""
    varied = weights.recipe.get("data", {}).get("layouts") == "varied"
    return TRAINING_BOX if varied else PARAMETER_BOX


def warn_outside_box(fabric: Fabric, box: ParameterBox) -> None:
    """Warns, naming the fields, of a fabric that lies outside what the network was trained for."""
    layout, appearance = fabric.layout(), fabric.appearance()
    satin = structure_of(fabric.draft.drawdown) is Structure.SATIN
    fields: list[tuple[str, float, tuple[float, float]]] = [
        ("diffuse_blend", appearance.diffuse_blend, (box.diffuse_blend,) * 2),
        ("optical_depth", appearance.optical_depth, (box.optical_depth,) * 2),
    ]
    for family in ("warp", "weft"):
        yarn, lobes = getattr(layout, family), getattr(appearance, family)
        gaps = 1 - yarn.width / yarn.spacing
        fields += [
            (f"{family}.roughness", lobes.roughness, box.roughness),
            (f"{family}.height_scale", yarn.height_scale, box.height_scale),
            (
                f"{family}.inclination_deg",
                math.degrees(yarn.inclination),
                box.satin_inclination_deg if satin else box.inclination_deg,
            ),
            (f"{family}.twist_deg", math.degrees(yarn.twist), box.twist_deg),
            (f"{family}.gap", _farthest(gaps, box.gap), box.gap),
        ]
    ratio = float(np.mean(layout.weft.spacing) / np.mean(layout.warp.spacing))
    fields.append(("ends per pick", ratio, box.sett_ratio))
    outside = [
        f"{name} = {value:.4g} ({low:g}{f' to {high:g}' if high > low else ''})"
        for name, value, (low, high) in fields
        if not low - _ROUNDING <= value <= high + _ROUNDING
    ]
    if outside:
        warnings.warn(
            f"{fabric.name}: {', '.join(outside)}: the model woven was trained on what stands in brackets, "
            "so it may be off here.",
            LoomlightWarning,
            stacklevel=3,
        )


def _farthest(values: NDArray[np.float64], bounds: tuple[float, float]) -> float:
    """The value that lies farthest outside, or deepest inside."""
    return float(values[np.abs(values - np.mean(bounds)).argmax()])


def shortest_repeat(layout: ClothLayout) -> ClothLayout:
    """The layout of one repeat of the weave, which stripes of colours may have made longer."""
    drawdown = layout.warp_on_top
    picks = _period(layout.weft, lambda step: bool((np.roll(drawdown, step, 0) == drawdown).all()))
    ends = _period(layout.warp, lambda step: bool((np.roll(drawdown, step, 1) == drawdown).all()))
    return ClothLayout(drawdown[:picks, :ends], _first(layout.warp, ends), _first(layout.weft, picks))


def _period(family: FamilyLayout, repeats: Callable[[int], bool]) -> int:
    count = len(family.spacing)
    for step in range(1, count):
        if (
            count % step == 0
            and repeats(step)
            and _alike(family.spacing, step)
            and _alike(family.width, step)
        ):
            return step
    return count


def _alike(values: NDArray[np.float64], step: int) -> bool:
    return bool(np.allclose(np.roll(values, step), values, rtol=1e-9, atol=0))


def _first(family: FamilyLayout, count: int) -> FamilyLayout:
    return replace(family, spacing=family.spacing[:count], width=family.width[:count])


def repeat_threads(fabric: Fabric) -> tuple[int, int]:
    """Picks and ends of a fabric's shortest repeat."""
    picks, ends = shortest_repeat(fabric.layout()).warp_on_top.shape
    return picks, ends


def _run(fabric: Fabric, weights: Weights, float_type: type, repeats: tuple[int, int]) -> EncodedFabric:
    """Two runs of the encoder."""
    layout = shortest_repeat(fabric.layout())
    picks, ends = layout.warp_on_top.shape
    geometry = YarnGeometry(layout)
    field = weights.table.latent == "field"
    rows, columns = (FIELD_MAP * picks, FIELD_MAP * ends) if field else (VECTOR_MAP, VECTOR_MAP)
    parameters = fabric_parameters(fabric)
    faces = []
    for back in (False, True):
        maps = face_maps(geometry, back, rows, columns, float_type)
        if field:
            maps = np.tile(maps, (1, *repeats))
        (latents,) = encoder_session(weights).run(None, {"maps": maps[None], "parameters": parameters})
        faces.append(latents.astype(np.float16))
    shape = picks * repeats[0], ends * repeats[1]
    return EncodedFabric(*shape, (faces[0], faces[1]), Fibres.of(fabric))


def _refined(fabric: Fabric, weights: Weights, float_type: type, repeats: tuple[int, int]) -> EncodedFabric:
    """Latents as they are, and a correction of the last layer."""
    # It needs the decoder, which needs this module.
    from loomlight.models.woven.refinement import fitted_correction

    own = encode(fabric, weights, float_type)
    correction = fitted_correction(fabric, shortest_repeat(fabric.layout()), own, weights, float_type)
    found = own if repeats == (1, 1) else encode(fabric, weights, float_type, repeats)
    return replace(found, correction=correction)


@cache
def encoder_session(weights: Weights) -> Any:
    """ONNX Runtime's session of the encoder."""
    # Not needed where latents are at hand, and slow to import.
    onnxruntime = import_extra("onnxruntime", "woven", "Encoding a fabric for the network")
    from loomlight.models.woven.onnx_encoder import encoder_graph

    options = onnxruntime.SessionOptions()
    options.log_severity_level = 3
    return onnxruntime.InferenceSession(
        encoder_graph(weights).SerializeToString(), options, providers=["CPUExecutionProvider"]
    )


def _key(fabric: Fabric, weights: Weights, repeats: tuple[int, int], refined: bool) -> str:
    """SHA-256 of everything that the latents depend on."""
    layout = shortest_repeat(fabric.layout())
    digest = hashlib.sha256(f"{_VERSION} {weights.sha256} {repeats} {refined}\n".encode())
    digest.update(repr(layout.warp_on_top.shape).encode() + np.packbits(layout.warp_on_top).tobytes())
    for family in (layout.warp, layout.weft):
        digest.update(np.asarray(family.spacing, np.float64).tobytes())
        digest.update(np.asarray(family.width, np.float64).tobytes())
        digest.update(repr((float(family.inclination), float(family.twist))).encode())
    digest.update(fabric_parameters(fabric).tobytes())
    appearance = fabric.appearance()
    digest.update(repr((float(appearance.diffuse_blend), float(appearance.optical_depth))).encode())
    return digest.hexdigest()


def _read(
    key: str, picks: int, ends: int, weights: Weights, fibres: Fibres, refined: bool
) -> EncodedFabric | None:
    """What is kept on disk; None where nothing is, or nothing that can be used."""
    try:
        arrays = load_file(cache_folder("woven") / f"{key}.safetensors")
    except (SafetensorError, OSError, ValueError):
        return None
    faces = [arrays.get(side) for side in ("front", "back")]
    last = levels_of(picks, ends)[-1]
    texels = last.first + 1 if weights.table.latent == "field" else 1
    front, back = faces
    if front is None or back is None:
        return None
    for face in (front, back):
        if face.dtype != np.float16 or face.shape != (texels, weights.table.latent_size):
            return None
    correction = arrays.get("correction")
    if (correction is not None) != refined:
        return None
    if correction is not None and (
        correction.dtype != np.float32 or correction.shape != weights.table.corrected_shape
    ):
        return None
    return EncodedFabric(picks, ends, (front, back), fibres, correction)


def _write(key: str, encoded: EncodedFabric) -> None:
    """Keeps latents on disk where that is possible; a full disk costs a run of the encoder next time."""
    if len(encoded.faces[0]) > _LARGEST_KEPT:
        return
    folder = cache_folder("woven")
    file = folder / f"{key}.safetensors"
    if file.exists():
        return
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with replacing(file) as temporary:
            arrays: dict[str, NDArray[Any]] = {"front": encoded.faces[0], "back": encoded.faces[1]}
            if encoded.correction is not None:
                arrays["correction"] = encoded.correction
            save_file(arrays, temporary)
    except (OSError, LoomlightError, SafetensorError):
        return
