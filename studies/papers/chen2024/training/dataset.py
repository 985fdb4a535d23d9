"""The dataset of a training: fabrics with queries and their truth, generated on demand and cached on disk.

A fabric depends on the seed and its number alone, so a resumed training generates the same dataset.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import drjit as dr
import numpy as np
from numpy.typing import NDArray
from safetensors.numpy import load_file, save_file

from loomlight.aggregate.queries import fabric_scale, query_set
from loomlight.aggregate.slices import FabricSlices
from loomlight.core.backend import array_types, upload, upload_vector
from loomlight.core.files import replacing
from loomlight.fabric.fabric import Fabric
from loomlight.models.neural.encoded_fabric import Fibres, footprints_in_threads
from loomlight.models.neural.encoding import fabric_parameters
from loomlight.models.neural.face_maps import face_maps
from loomlight.models.neural.weights import PARAMETER_RANGES, TRAINING_RANGES
from loomlight.scattering.point import YarnScattering, to_face_frame
from loomlight.yarn.geometry import YarnGeometry
from loomlight.yarn.layout import ClothLayout
from loomlight.yarn.visibility import first_hit
from studies.papers.chen2024.training.config import DataTable
from studies.papers.chen2024.training.random_fabrics import random_fabric
from studies.papers.chen2024.training.weaves import training_draft

# Crossings of the largest repeat with all pairs, and the fewest pairs of a larger repeat.
_FULL_REPEAT = 32
_MIN_PAIRS = 64
# Fraction of fabrics with random layouts, if layouts vary.
_VARIED_FRACTION = 2 / 3
# Arrays of a face in a file, beside its threads.
_ARRAYS = ("maps", "parameters", "fibres", "bundles", "lights", "views", "places", "seen", "truth")


@dataclass(frozen=True, eq=False)
class Face:
    """One face of a fabric with its queries, in the frame of that face: views have z > 0.

    Attributes:
        maps: input of the encoder [7, rows, columns].
        parameters: α of warp and weft, β of warp and weft [4].
        fibres: see `Fibres.face` [2 families, 3].
        bundles: see `Fibres.bundles` [2 families, `BUNDLES`, 4].
        threads: picks and ends of the repeat.
        lights, views: unit vectors [p, 3].
        places: position x and y and side of the footprint [p, m, 3], in threads.
        seen: where the view ray through that position meets yarn, x and y [p, m, 2], in threads.
        truth: components, 1/sr, and hole fraction [p, m, 5].
    """

    maps: NDArray[np.float32]
    parameters: NDArray[np.float32]
    fibres: NDArray[np.float32]
    bundles: NDArray[np.float32]
    threads: tuple[int, int]
    lights: NDArray[np.float32]
    views: NDArray[np.float32]
    places: NDArray[np.float32]
    seen: NDArray[np.float32]
    truth: NDArray[np.float16]

    @property
    def count(self) -> int:
        """Number of queries."""
        return self.places.shape[0] * self.places.shape[1]

    def footprints_of(self, index: NDArray[np.int64]) -> NDArray[np.float32]:
        """Position and side of queries by their numbers [n, 3], in threads."""
        return self.places.reshape(-1, 3)[index]

    def seen_of(self, index: NDArray[np.int64]) -> NDArray[np.float32]:
        """Where the view rays of queries meet yarn [n, 2], in threads."""
        return self.seen.reshape(-1, 2)[index]

    def answers_of(
        self, index: NDArray[np.int64]
    ) -> tuple[NDArray[np.float32], NDArray[np.float32], NDArray[np.float32]]:
        """Lights, views and truths of queries [n, 3], [n, 3], [n, 5]."""
        pair = index // self.places.shape[1]
        return self.lights[pair], self.views[pair], self.truth.reshape(-1, 5)[index].astype(np.float32)


def dataset_fabric(table: DataTable, number: int) -> Fabric:
    """Fabric `number` of the dataset."""
    rng = np.random.default_rng([table.seed, number])
    draft = training_draft(rng, table.weaves)
    varied = table.layouts == "varied" and rng.random() < _VARIED_FRACTION
    return random_fabric(rng, draft, ranges=TRAINING_RANGES if varied else PARAMETER_RANGES)


def dataset_faces(
    table: DataTable, number: int, map_side: int, per_thread: bool, float_type: type
) -> list[Face]:
    """Front and back of fabric `number`.

    Args:
        map_side: texels of the maps, of each side of the repeat or of each thread (`per_thread`).
    """
    fabric = dataset_fabric(table, number)
    layout = fabric.layout()
    geometry = YarnGeometry(layout)
    # The cost of a pair grows with the texels of the repeat, so large repeats have fewer pairs.
    fraction = min(1, _FULL_REPEAT / layout.warp_on_top.size)
    queries = query_set(
        fabric_scale(layout),
        max(_MIN_PAIRS, round(fraction * table.pairs)),
        table.footprints,
        seed=table.seed,
        step=number,
        transmits=True,
        lights=max(_MIN_PAIRS // 4, round(fraction * table.lights)),
        views=max(_MIN_PAIRS // 4, round(fraction * table.views)),
    )
    model = YarnScattering(geometry, fabric.appearance())
    slices = FabricSlices(model, float_type, table.texels_per_thread, shadows="mapped")
    truth = slices.box_means(queries.lights, queries.views, queries.pairs, queries.centres, queries.boxes)
    lights, views = queries.lights[queries.pairs[:, 0]], queries.views[queries.pairs[:, 1]]
    places = footprints_in_threads(layout, queries.centres, queries.sizes)
    seen = seen_in_threads(model, layout, views, queries.centres, float_type)
    faces = []
    picks, ends = layout.warp_on_top.shape
    rows, columns = (map_side * picks, map_side * ends) if per_thread else (map_side, map_side)
    for back in (False, True):
        chosen = (views[:, 2] < 0) == back
        turn = np.array([1, 1, -1 if back else 1])
        faces.append(
            Face(
                maps=face_maps(geometry, back, rows, columns, float_type),
                parameters=fabric_parameters(fabric),
                fibres=Fibres.of(fabric).face(back),
                bundles=Fibres.of(fabric).bundles(back),
                threads=(picks, ends),
                lights=(lights[chosen] * turn).astype(np.float32),
                views=(views[chosen] * turn).astype(np.float32),
                places=places[chosen],
                seen=seen[chosen].astype(np.float32),
                truth=truth[chosen].astype(np.float16),
            )
        )
    return faces


def seen_in_threads(
    model: YarnScattering,
    layout: ClothLayout,
    views: NDArray[Any],
    centres: NDArray[Any],
    float_type: type,
) -> NDArray[np.float64]:
    """Where view rays [p, 3] through points of the plane [p, m, 2], millimetres, meet yarn: in threads.

    Rays that pass through stay where they cross the plane.
    """
    types = array_types(float_type)
    view = upload_vector(types.Vector3, np.repeat(views, centres.shape[1], axis=0).T)
    x, y = (upload(types.Float, centres[..., axis]) for axis in (0, 1))
    back = view.z < 0
    hit = first_hit(model.surface, x, y, to_face_frame(view, back), back, quality=model.quality)
    x, y = dr.select(hit.hole, x, hit.x), dr.select(hit.hole, y, hit.y)
    seen = np.stack([x.numpy(), y.numpy()], -1).reshape(centres.shape).astype(np.float64)
    return seen * (np.array(layout.warp_on_top.shape[::-1]) / layout.size)


def write_faces(path: Path, faces: list[Face]) -> None:
    """Writes both faces of a fabric with their queries."""
    arrays: dict[str, NDArray[Any]] = {}
    for side, face in zip(("front", "back"), faces, strict=True):
        arrays |= {f"{side}.{name}": np.ascontiguousarray(getattr(face, name)) for name in _ARRAYS}
        arrays[f"{side}.threads"] = np.array(face.threads, np.int64)
    with replacing(path) as temporary:
        save_file(arrays, temporary)


def read_faces(path: Path) -> list[Face]:
    """Reads the faces from a file of `write_faces`."""
    arrays = load_file(path)
    faces = []
    for side in ("front", "back"):
        picks, ends = arrays[f"{side}.threads"].tolist()
        faces.append(Face(**{name: arrays[f"{side}.{name}"] for name in _ARRAYS}, threads=(picks, ends)))
    return faces
