"""Colours of the exported cloth: `pip install onnxruntime numpy`, then `python colour.py` prints some.

It needs no loomlight: decoder.onnx, the tensors and the manifest are everything.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import onnxruntime
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.floating[Any]]
FOLDER = Path(__file__).resolve().parent
_KINDS = {"F16": np.float16, "F32": np.float32, "U8": np.uint8}


class Cloth:
    """The cloth of a folder; frames and units are those of README.md."""

    def __init__(self, folder: str | Path = FOLDER) -> None:
        self.manifest = json.loads((Path(folder) / "manifest.json").read_text(encoding="utf-8"))
        files = (Path(folder) / f"{name}.safetensors" for name in ("latents", "cloth"))
        self.tensors = {name: values for file in files for name, values in tensors_of(file).items()}
        self.decoder = onnxruntime.InferenceSession(
            Path(folder) / "decoder.onnx", providers=["CPUExecutionProvider"]
        )

    def value(self, centre: ArrayLike, side: ArrayLike, light: ArrayLike, view: ArrayLike) -> Floats:
        """f·|cos θ_light| of square footprints [n, 3], linear RGB, 1/sr.

        Args:
            centre: places on the cloth [n, 2], millimetres.
            side: of the footprints [n], millimetres, along x and y.
            light, view: unit vectors [n, 3] away from the cloth; z of a view is negative behind it.
        """
        place, lights, views = (np.atleast_2d(np.asarray(rows, np.float64)) for rows in (centre, light, view))
        sides = np.broadcast_to(np.asarray(side, np.float64), len(place))
        found = np.empty((len(place), 3))
        for face, name in enumerate(("front", "back")):
            rows = np.flatnonzero((views[:, 2] < 0) == bool(face))
            if rows.size:
                found[rows] = self._of_face(face, name, place[rows], sides[rows], lights[rows], views[rows])
        return found

    def _of_face(
        self, face: int, name: str, place: Floats, side: Floats, light: Floats, view: Floats
    ) -> Floats:
        turned = np.array([1, 1, -1 if face else 1])
        light, view = light * turned, view * turned
        components, hole = self._decoded(name, place, side, light, view)
        albedos = self._mean_albedos(face, place, side)
        passes = (light[:, 2] < 0)[:, None]
        # Diffuse warp, diffuse weft, specular warp, specular weft; reflected and transmitted.
        diffuse, specular = (
            [
                sum(
                    components[:, family + 2 * kind, None] * albedos[family][:, 2 * kind + far]
                    for family in (0, 1)
                )
                for far in (0, 1)
            ]
            for kind in (0, 1)
        )
        rise, kept = self._towards_grazing(light, view)
        specular[0] = specular[0] + rise * components[:, 2:].sum(axis=1, keepdims=True)
        body = np.where(passes, diffuse[1], diffuse[0])
        body = body + self._between_yarns(face, components, hole, albedos, light, view)
        body = kept * body + np.where(passes, specular[1], specular[0])
        return self._under_sheen(body, components, hole, light, view)

    def _towards_grazing(self, light: Floats, view: Floats) -> tuple[Floats, Floats]:
        """What albedos of highlights gain, and the share of diffuse light that is left [n, 1]."""
        cosine = np.sqrt(np.clip(0.5 + 0.5 * (light * view).sum(axis=1, keepdims=True), 0, 1))
        of_light, of_view = (
            1 - self.manifest["grazing_loss"] * (1 - np.abs(each[:, 2:])) ** 4 for each in (light, view)
        )
        return self.manifest["grazing_gain"] * (1 - cosine) ** 5, of_light * of_view

    def _decoded(
        self, name: str, place: Floats, side: Floats, light: Floats, view: Floats
    ) -> tuple[Floats, Floats]:
        """Components [n, 4] and holes [n]."""
        width, height = self.manifest["repeat_mm"]
        # Latents have the weave's own repeat, which colours may make longer.
        picks, ends = self.tensors["warp_on_top"].shape
        per_mm = np.array([ends / width, picks / height])
        pitch = self.manifest["mean_pitch_mm"]
        # Footprints of more than two threads are read at four places, each half as wide.
        is_large = side > 2 * pitch
        step = np.where(is_large, side / 4, 0)
        tap = np.where(is_large, side / 2, side) / pitch
        centre = place * per_mm
        spread = 12 * (step[:, None] * per_mm) ** 2 + tap[:, None] ** 2
        size = np.sqrt(np.sqrt(spread[:, 0] * spread[:, 1]))
        centre = self._seen(name, centre, size, view, per_mm)
        latent = np.mean(
            [
                self._latents(name, centre + step[:, None] * per_mm * [i, j], tap)
                for i in (-1, 1)
                for j in (-1, 1)
            ],
            axis=0,
        )
        logarithm = np.clip(np.log(64 * size) / np.log(5120), 0, 1)
        inputs = {
            "latent": latent,
            "coordinates": np.column_stack([centre - np.floor(centre), logarithm]),
            "light": light,
            "view": view,
            "fibres": self.tensors[f"{name}.fibres"],
            "bundles": self.tensors[f"{name}.bundles"],
            "correction": self.tensors["correction"],
        }
        components, hole = self.decoder.run(
            None, {key: np.ascontiguousarray(each, np.float32) for key, each in inputs.items()}
        )
        return components, hole

    def _seen(self, name: str, centre: Floats, size: Floats, view: Floats, per_mm: Floats) -> Floats:
        """Places [n, 2] in threads, of small footprints moved along the view to where it meets yarn."""
        heights = self.tensors[f"{name}.heights"].astype(float)
        rows, columns = heights.shape
        slope = view[:, :2] / np.maximum(view[:, 2:], 1e-4) * per_mm
        levels = np.linspace(heights.max(), heights[heights > -1e3].min(), 129)
        met, above = np.full(len(centre), np.nan), np.zeros(len(centre))
        for level in levels:
            column, row = np.floor(16 * (centre + level * slope)).astype(int).T
            depth = heights[row % rows, column % columns] - level
            # Between the last level above the yarn and the first below it.
            share = np.clip(depth / np.maximum(depth + above, 1e-9), 0, 1)
            first = np.isnan(met) & (depth >= 0)
            met = np.where(first, level + share * (levels[0] - levels[1]), met)
            above = np.maximum(-depth, 0)
        # Rays that pass through stay where they cross the plane.
        near = 1 - np.clip(np.log(np.maximum(size, 1e-6) / 0.25) / np.log(8), 0, 1)
        return centre + (near * np.nan_to_num(met))[:, None] * slope

    def _latents(self, name: str, centre: Floats, size: Floats) -> Floats:
        """Latents [n, 64] at places [n, 2] of a side [n], in threads: two levels, bilinearly each."""
        levels, latents = self.manifest["levels"], self.tensors[f"{name}.latents"].astype(np.float32)
        position = np.clip(np.log2(np.maximum(size, 1e-6)) + 3, 0, len(levels) - 1)
        lower = np.minimum(position.astype(int), len(levels) - 2)
        found = np.zeros((len(centre), latents.shape[1]))
        for number, level in enumerate(levels):
            weight = np.where(lower == number, 1 - position + lower, 0.0)
            weight = np.where(lower + 1 == number, position - lower, weight)
            # Texels of running means over several threads stand around their upper corners.
            is_running = number >= 4 and level["per_thread"]
            texel = centre * level["per_thread"] - (1.0 if is_running else 0.5)
            first = np.floor(texel)
            share = texel - first
            for i in (0, 1):
                for j in (0, 1):
                    column = (first[:, 0].astype(int) + i) % level["columns"]
                    row = (first[:, 1].astype(int) + j) % level["rows"]
                    across = share[:, 0] if i else 1 - share[:, 0]
                    along = share[:, 1] if j else 1 - share[:, 1]
                    index = level["first"] + row * level["columns"] + column
                    found += (weight * across * along)[:, None] * latents[index]
        return found

    def _mean_albedos(self, face: int, place: Floats, side: Floats) -> tuple[Floats, Floats]:
        """Means [n, 4, 3] over the threads of warp and weft that a footprint shows."""
        width, height = self.manifest["repeat_mm"]
        on_top = self.tensors["warp_on_top"].astype(float)
        shown = 1 - on_top if face else on_top
        pitches = [width / on_top.shape[1], height / on_top.shape[0]]
        sides = [np.maximum(side, pitch / 64) for pitch in pitches]
        (ends, end_cells), (picks, pick_cells) = (
            [
                _overlaps(self.tensors[f"{family}.{kind}"], place[:, axis], sides[axis], period)
                for kind in ("edges", "cells")
            ]
            for axis, (family, period) in enumerate((("warp", width), ("weft", height)))
        )
        gaps = [each - threads.sum(axis=1) for each, threads in zip(sides, (ends, picks), strict=True)]
        # Threads that are hidden count a little, or where none is to be seen there would be no mean.
        warp = ends * (gaps[1][:, None] + picks @ shown) + 2.0**-12 * end_cells * sides[1][:, None]
        weft = picks * (gaps[0][:, None] + ends @ (1 - shown).T) + 2.0**-12 * pick_cells * sides[0][:, None]
        return self._mean("warp", warp), self._mean("weft", weft)

    def _mean(self, family: str, weights: Floats) -> Floats:
        shares = weights / weights.sum(axis=1, keepdims=True)
        return np.einsum("nt,tac->nac", shares, self.tensors[f"{family}.albedos"])

    def _between_yarns(
        self,
        face: int,
        components: Floats,
        hole: Floats,
        albedos: tuple[Floats, Floats],
        light: Floats,
        view: Floats,
    ) -> Floats:
        """Light that yarns scatter to one another [n, 3], 1/sr; 0 of cloth without."""
        if "between.by_view" not in self.tensors:
            return np.zeros((len(view), 3))
        x, y, z = view.T
        low = (1 - z) ** 2
        terms = np.stack([np.ones(len(z)), np.hypot(x, y), low, low * low, x * x - y * y])
        shares = np.clip(self.tensors["between.by_view"][face] @ terms, 0, 1)  # [family, 3, n]
        warp_seen = np.clip(self.tensors["between.warp_seen"][face] @ terms, 0, 1)
        amounts = [components[:, family] / np.maximum(1 - shares[family, 0], 0.1) for family in (0, 1)]
        of_warp = (2e-3 * warp_seen + amounts[0]) / (amounts[0] + amounts[1] + 2e-3)
        of_warp_cloth, of_weft_cloth, leaked, beyond, beyond_leaked = self.tensors["between.radiance"][face]
        reflected = transmitted = np.zeros((len(view), 3))
        for family, part in ((0, of_warp), (1, 1 - of_warp)):
            near, far, to_warp = (shares[family] * part * (1 - hole))[:, :, None]
            to_warp = shares[family, 2][:, None]
            turned, through = self.tensors["between.layers"][family]
            back = albedos[family][:, 0] + turned * albedos[family][:, 2]
            passed = far * (albedos[family][:, 1] + through * albedos[family][:, 3])
            met = near * (to_warp * of_warp_cloth + (1 - to_warp) * of_weft_cloth)
            reflected = reflected + back * met + passed * beyond_leaked
            transmitted = transmitted + passed * beyond + back * near * leaked
        passes = (light[:, 2] < 0)[:, None]
        return np.where(passes, transmitted, reflected) * np.abs(light[:, 2:]) / np.pi

    def _under_sheen(
        self, body: Floats, components: Floats, hole: Floats, light: Floats, view: Floats
    ) -> Floats:
        strength = self.manifest["sheen_strength"]
        if strength == 0:
            return body
        cosine = np.clip(view[:, 2], 0.01, 1)
        power = (2 * np.sqrt(cosine) - 1)[:, None] ** np.arange(6)
        scale, shear, exponent = (
            power[:, : len(each)] @ each
            for each in (self.tensors[f"sheen.{name}"] for name in ("scale", "shear", "reflectance"))
        )
        scale, shear = np.clip(scale, 0.01, 1), np.clip((1 - cosine) * shear, -0.25, 0)
        weight = strength * 0.8 / (1 + np.exp(np.clip(-exponent, -60, 60)))
        level = np.hypot(view[:, 0], view[:, 1])
        azimuth = np.where(level[:, None] > 1e-6, view[:, :2] / np.maximum(level, 1e-12)[:, None], [1.0, 0.0])
        towards = (light[:, :2] * azimuth).sum(axis=1)
        across = light[:, 1] * azimuth[:, 0] - light[:, 0] * azimuth[:, 1]
        squared = (scale * towards + shear * light[:, 2]) ** 2 + (scale * across) ** 2 + light[:, 2] ** 2
        lobe = np.where(light[:, 2] > 0, scale**2 * light[:, 2] / (np.pi * np.maximum(squared**2, 1e-20)), 0)
        # The share of the views that light reaches, by the diffuse components.
        blend, cos_light = self.manifest["diffuse_blend"], np.maximum(np.abs(light[:, 2]), 1e-3)
        together = (light[:, :2] * view[:, :2]).sum(axis=1)
        together = together / np.sqrt(np.maximum((light[:, :2] ** 2).sum(axis=1), 1e-6))
        facing = (0.166 + 0.597 * cos_light) * (1 + 0.216 * together)
        lit = np.pi * components[:, :2].sum(axis=1) / (cos_light * (1 - blend) + facing * blend)
        lit = np.minimum(lit, 1 - hole) + hole
        return (1 - weight)[:, None] * body + (lit * weight * lobe)[:, None]


def _overlaps(bounds: Floats, centre: Floats, side: Floats, period: float) -> Floats:
    """Millimetres [n, threads] that intervals [threads, 2], repeated, share with others of a side [n]."""
    low, length = bounds[:, 0].astype(float), (bounds[:, 1] - bounds[:, 0]).astype(float)

    def before(place: Floats) -> Floats:
        turns = np.floor((place[:, None] - low) / period)
        return turns * length + np.clip(place[:, None] - low - turns * period, 0, length)

    return before(centre + side / 2) - before(centre - side / 2)


def tensors_of(file: Path) -> dict[str, Floats]:
    """The arrays of a .safetensors file: the length of a JSON header, the header, and the numbers."""
    content = file.read_bytes()
    start = 8 + int.from_bytes(content[:8], "little")
    header = json.loads(content[8:start])
    header.pop("__metadata__", None)
    found = {}
    for name, entry in header.items():
        first, last = (start + offset for offset in entry["data_offsets"])
        found[name] = np.frombuffer(content[first:last], _KINDS[entry["dtype"]]).reshape(entry["shape"])
    return found


def main() -> None:
    """Prints the colour of a middling footprint for a light that goes round the cloth."""
    cloth = Cloth()
    angle = np.linspace(0, 2 * np.pi, 8, endpoint=False)
    light = np.stack([0.6 * np.cos(angle), 0.6 * np.sin(angle), np.full(8, 0.8)], axis=1)
    view = np.tile([0.0, 0.6, 0.8], (8, 1))
    colours = cloth.value(np.zeros((8, 2)), np.full(8, 10.0), light, view)
    for turn, colour in zip(np.degrees(angle), colours, strict=True):
        print(f"light from {turn:3.0f}°: {np.array2string(np.pi * colour, precision=4)}")


if __name__ == "__main__":
    main()
