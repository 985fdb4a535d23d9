"""Fabrics of a stored data set as a training draws from them: read when a step first needs them.

A material is read whole once, and of its queries those that the training takes are kept: the same for a seed,
whichever process reads them and however the store was made. All views of a store are in front of the cloth,
so a material is one face.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, overload

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.fabric.fabric import Fabric
from loomlight.models.neural.architecture import FIELD_MAP, VECTOR_MAP, NetworkTable
from loomlight.models.neural.encoded_fabric import Fibres, footprints_in_threads
from loomlight.models.neural.encoding import fabric_parameters
from loomlight.models.neural.face_maps import face_maps
from loomlight.models.neural.learned_truth import moved_since
from loomlight.scattering.point import YarnScattering
from loomlight.yarn.geometry import YarnGeometry
from studies.papers.chen2024.dataset_store import QueryStore, StoredMaterial
from studies.papers.chen2024.materials import MATERIALS, paper_material
from studies.papers.chen2024.queries import MaterialQueries, material_queries, slice_means
from studies.papers.chen2024.training.config import TrainingConfig
from studies.papers.chen2024.training.dataset import seen_in_threads

# Keys of the random numbers that choose queries among all of a material, and of those that are held out.
_CHOICE = 13
_HELD_OUT_SEED, _HELD_OUT_QUERIES = 1, 4096


@dataclass(frozen=True, eq=False)
class QueriedFace:
    """The front of a fabric with some of the queries of all pairs over all footprints.

    Attributes:
        maps, parameters, fibres, bundles, threads: as of `dataset.Face`.
        queries: directions and footprints.
        places: position x and y and side of each footprint [m, 3], in threads.
        numbers: of the queries that are used [q]: a pair's number times m plus the footprint's.
        components: of these [q, 4], 1/sr.
        holes: of each view over each footprint [v, m].
        seen: where view rays through the footprints meet yarn [v, m, 2], in threads; None if nothing asks.
    """

    maps: NDArray[np.float32]
    parameters: NDArray[np.float32]
    fibres: NDArray[np.float32]
    bundles: NDArray[np.float32]
    threads: tuple[int, int]
    queries: MaterialQueries
    places: NDArray[np.float32]
    numbers: NDArray[np.uint32]
    components: NDArray[np.float16]
    holes: NDArray[np.float16]
    seen: NDArray[np.float32] | None

    @property
    def count(self) -> int:
        """Number of queries."""
        return len(self.numbers)

    def footprints_of(self, index: NDArray[np.int64]) -> NDArray[np.float32]:
        """Position and side of queries by their numbers [n, 3], in threads."""
        return self.places[self.numbers[index] % len(self.places)]

    def seen_of(self, index: NDArray[np.int64]) -> NDArray[np.float32]:
        """Where the view rays of queries meet yarn [n, 2], in threads."""
        assert self.seen is not None
        pair, footprint = np.divmod(self.numbers[index], len(self.places))
        return self.seen[self.queries.pairs[pair, 1], footprint]

    def answers_of(
        self, index: NDArray[np.int64]
    ) -> tuple[NDArray[np.float32], NDArray[np.float32], NDArray[np.float32]]:
        """Lights, views and truths of queries [n, 3], [n, 3], [n, 5]."""
        pair, footprint = np.divmod(self.numbers[index], len(self.places))
        light, view = self.queries.pairs[pair].T
        holes = self.holes[view, footprint][:, None]
        truth = np.concatenate([self.components[index], holes], 1).astype(np.float32)
        return self.queries.lights[light], self.queries.views[view], truth


class StoredFaces(Sequence[QueriedFace]):
    """The faces of a store that a configuration asks for, in the order of their materials.

    Attributes:
        store: that they are read from.
    """

    def __init__(self, config: TrainingConfig, now: list[float], float_type: type) -> None:
        """
        Args:
            now: `truth_numbers` of this version.
            float_type: the Dr.Jit Float type to compute maps with.

        Raises:
            InputError: no store, another one than the configuration says, or one that is not complete.
            MissingDependencyError: zarr is not installed.
        """
        data = config.data
        self._config, self._float_type = config, float_type
        self._faces: dict[int, QueriedFace] = {}
        if not Path(data.store).is_dir():
            raise InputError(
                f'[data] store = "{data.store}" is no folder below {Path.cwd()}, where the command runs: '
                f"make it with `python -m studies.papers.chen2024.data -o {data.store}`."
            )
        self.store = QueryStore(data.store)
        settings = self.store.settings
        if settings.seed != data.seed:
            raise InputError(
                f"[data] seed = {data.seed}, and {data.store} has the materials of seed {settings.seed}: "
                f"write seed = {settings.seed}, or name another store."
            )
        if (data.weaves, data.layouts) != ("paper", "paper"):
            raise InputError(
                f'[data] weaves = "{data.weaves}" and layouts = "{data.layouts}" are not those of a store, '
                'which are the paper\'s: write "paper" for both.'
            )
        if data.fabrics > len(MATERIALS):
            raise InputError(f"[data] fabrics = {data.fabrics}: a store has {len(MATERIALS)} at most.")
        if moved_since(self.store.attributes["made_with"], now) is not None:
            raise InputError(
                f"{data.store} has materials of yarns that this version computes otherwise: make a new store."
            )
        self.numbers = [k * len(MATERIALS) // data.fabrics for k in range(data.fabrics)]
        missing = sorted(set(self.numbers) - set(self.store.numbers))
        if missing:
            raise InputError(
                f"{data.store} lacks {len(missing)} of the {data.fabrics} materials that [data] fabrics asks "
                f"for, the first {missing[0]}: `python -m studies.papers.chen2024.data -o {data.store} "
                f"--queries {settings.queries} --seed {settings.seed}` adds what is missing."
            )

    def __len__(self) -> int:
        return len(self.numbers)

    @overload
    def __getitem__(self, index: int) -> QueriedFace: ...
    @overload
    def __getitem__(self, index: slice) -> list[QueriedFace]: ...
    def __getitem__(self, index: int | slice) -> QueriedFace | list[QueriedFace]:
        """
        Raises:
            InputError: the material is damaged.
        """
        if isinstance(index, slice):
            return [self[k] for k in range(len(self))[index]]
        if index not in self._faces:
            self._faces[index] = self._read(range(len(self))[index])
        return self._faces[index]

    def _read(self, index: int) -> QueriedFace:
        number, data = self.numbers[index], self._config.data
        material = self.store.material(number)
        count = material.queries.count
        wanted = min(count, max(1, data.store_queries // data.fabrics))
        # One in each of as many equal runs of queries: all of them where all are wanted.
        jitter = np.random.default_rng([data.seed, _CHOICE, number]).random(wanted)
        chosen = ((np.arange(wanted) + jitter) * (count / wanted)).astype(np.uint32)
        fabric = paper_material(number, data.seed)
        return _face(fabric, material, np.minimum(chosen, count - 1), self._config.network, self._float_type)


def held_out_faces(network: NetworkTable, seed: int, float_type: type) -> list[QueriedFace]:
    """A few queries of a material of each of the paper's weaves, of parameters that no training has."""
    faces = []
    for weave in dict.fromkeys(material.weave for material in MATERIALS):
        numbers = [number for number, material in enumerate(MATERIALS) if material.weave == weave]
        number, other = numbers[len(numbers) // 2], seed + _HELD_OUT_SEED
        fabric = paper_material(number, other)
        queries = material_queries(number, other, _HELD_OUT_QUERIES)
        truth = slice_means(fabric, queries, float_type)
        _, first = np.unique(queries.pairs[:, 1], return_index=True)
        components, holes = truth[..., :4].astype(np.float16), truth[first, :, 4].astype(np.float16)
        material = StoredMaterial(number, queries, components, holes)
        faces.append(_face(fabric, material, np.arange(queries.count, dtype=np.uint32), network, float_type))
    return faces


def _face(
    fabric: Fabric,
    material: StoredMaterial,
    chosen: NDArray[np.uint32],
    network: NetworkTable,
    float_type: type,
) -> QueriedFace:
    layout, queries = fabric.layout(), material.queries
    geometry = YarnGeometry(layout)
    picks, ends = layout.warp_on_top.shape
    field = network.latent == "field"
    rows, columns = (FIELD_MAP * picks, FIELD_MAP * ends) if field else (VECTOR_MAP, VECTOR_MAP)
    seen = None
    if network.parallax:
        model = YarnScattering(geometry, fabric.appearance())
        views: NDArray[Any] = queries.views.astype(np.float64)
        centres = np.broadcast_to(queries.centres, (len(views), *queries.centres.shape))
        seen = seen_in_threads(model, layout, views, centres, float_type).astype(np.float32)
    return QueriedFace(
        maps=face_maps(geometry, False, rows, columns, float_type),
        parameters=fabric_parameters(fabric),
        fibres=Fibres.of(fabric).face(False),
        bundles=Fibres.of(fabric).bundles(False),
        threads=(picks, ends),
        queries=queries,
        places=footprints_in_threads(
            layout, queries.centres.astype(np.float64), queries.sizes.astype(np.float64)
        ),
        numbers=chosen,
        components=material.components.reshape(-1, material.components.shape[-1])[chosen],
        holes=material.holes,
        seen=seen,
    )
