"""Clustered control variates as a model: tables of a fabric, and a few of its texels (zhu2024)."""

from __future__ import annotations

from copy import copy
from dataclasses import dataclass, replace
from typing import ClassVar, Self, final

from loomlight.core.arrays import Mask, UInt, Vec3
from loomlight.core.backend import ArrayTypes, array_types
from loomlight.core.fleet import Report
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import llvm_float
from loomlight.core.settings import setting
from loomlight.fabric.fabric import Fabric
from loomlight.models.clustered.bsdf import ClusteredBsdf, DeviceTables
from loomlight.models.clustered.tables import DEFAULT_TEXELS, ClusterTables, bake_tables
from loomlight.models.fabric_model import FilteredFabricModel, appearance_of, fabric_in_loom, plane_source
from loomlight.models.interface import ShaderTables, Values
from loomlight.models.options import Options
from loomlight.models.random_numbers import hashed
from loomlight.scattering.appearance import Appearance
from loomlight.scattering.point import Tint, YarnScattering
from loomlight.sources.kinds import Source
from loomlight.sources.loom_file import LoomFile
from loomlight.yarn.geometry import YarnGeometry

DEFAULT_CLUSTERS, MAX_CLUSTERS = 8, 64
DEFAULT_RANK, MAX_RANK = 4, 16
DEFAULT_SAMPLES, MAX_SAMPLES = 2, 8
MIN_TEXELS, MAX_TEXELS = 16, 1024
# Scene parameters of a family that tables depend on.
_BAKED = ("height_scale", "inclination", "twist", "roughness")


@dataclass(frozen=True, kw_only=True)
class ClusteredOptions(Options):
    """Options of `clustered`."""

    title: ClassVar[str] = "option of clustered"

    clusters: int = setting(
        DEFAULT_CLUSTERS,
        "Clusters of texels of each face, a multiple of 4.",
        low=4,
        high=MAX_CLUSTERS,
        fits=lambda count: count % 4 == 0,
        expected=f"a multiple of 4 from 4 to {MAX_CLUSTERS}",
    )
    rank: int = setting(
        DEFAULT_RANK, "Principal components of a cluster's fibre densities.", low=0, high=MAX_RANK
    )
    texels: int = setting(
        DEFAULT_TEXELS,
        "Texels along the longer side of the repeat; at least 6 across the finest thread are used all the "
        "same.",
        low=MIN_TEXELS,
        high=MAX_TEXELS,
        stored=True,
    )
    samples: int = setting(
        DEFAULT_SAMPLES,
        "Texels of a footprint that the residual is estimated from; 0 leaves the base alone, which is biased "
        "and without noise.",
        low=0,
        high=MAX_SAMPLES,
        stored=True,
    )


@final
class ClusteredModel(FilteredFabricModel):
    """A base term from summed-area tables, and a residual from `samples` texels of the footprint (zhu2024).

    Values are unbiased estimates of the mean over the footprint of the model's own surface, a map of texels,
    and single ones may be negative. Edits of roughness and of the yarns' shape bake the tables again; edits
    of colours or sheen do not.

    Attributes:
        tables: the baked tables.
        controlled: False estimates everything from the texels, as a comparison.
    """

    name = "clustered"
    conserves_energy = False
    estimates = True
    options_class = ClusteredOptions
    options: ClusteredOptions

    def __init__(
        self, fabric: Fabric, tables: ClusterTables, options: ClusteredOptions | None = None
    ) -> None:
        """A model of baked tables; see `for_source` to bake them."""
        super().__init__(fabric)
        self.tables, self.options = tables, options or ClusteredOptions()
        self.controlled = True
        self._geometry = YarnGeometry(fabric.layout())
        self._uploaded: dict[type, DeviceTables] = {}
        self._use(fabric.appearance())

    def _use(self, appearance: Appearance) -> None:
        self.point_model = YarnScattering(self._geometry, appearance)

    @classmethod
    def for_source(
        cls, source: Source, options: ClusteredOptions | None = None, report: Report | None = None
    ) -> Self:
        """The model of a fabric.

        Raises:
            InputError: no fabric, or one whose repeat is too large.
        """
        del report
        fabric, chosen = plane_source(source, cls.name), options or ClusteredOptions()
        appearance = fabric.appearance()
        roughness = appearance.warp.roughness, appearance.weft.roughness
        geometry = YarnGeometry(fabric.layout())
        tables = bake_tables(geometry, roughness, chosen.clusters, chosen.rank, llvm_float(), chosen.texels)
        return cls(fabric, tables, chosen)

    def without_control(self) -> Self:
        """The same surface estimated from the texels alone: what control variates are compared with."""
        model = copy(self)
        model.controlled = False
        return model

    def with_samples(self, count: int) -> Self:
        """The same tables, and residuals of so many texels, 0 to `MAX_SAMPLES`."""
        model = copy(self)
        model.options = replace(self.options, samples=count)
        return model

    def with_fabric(self, fabric: Fabric, edits: frozenset[str]) -> Self:
        """The model of an edited fabric; tables are kept if the edit changes the sheen alone."""
        if any(name.endswith(_BAKED) and not name.startswith("sheen.") for name in edits):
            return self.with_source(fabric)
        return type(self)(fabric, self.tables, self.options)

    def updated(self, values: Values, changed: frozenset[str]) -> Self:
        """The model after an edit; texels have the edited albedos of their threads too."""
        model = super().updated(values, changed)
        if model is not self:
            model._use(appearance_of(model.fabric, values))
        return model

    def to_loom(self) -> LoomFile:
        """The tables."""
        return LoomFile(
            model=self.name,
            source=self.fabric,
            tensors=self.tables.arrays(),
            settings={**self.options.stored(), **self.tables.settings()},
        )

    @classmethod
    def from_loom(cls, loom: LoomFile) -> Self:
        """The model of the tables in a file.

        Raises:
            InputError: another model's file, tables of another version, or that do not belong together.
        """
        fabric = fabric_in_loom(loom, cls.name)
        tables = loom.tables(ClusterTables)
        return cls(fabric, tables, ClusteredOptions.of_loom(loom, clusters=tables.clusters, rank=tables.rank))

    def upload(self, types: ArrayTypes) -> None:
        """Uploads all tables to a backend, which otherwise happens at first use."""
        super().upload(types)
        self.point_model.parameters(types)
        self.on_backend(types)

    def at(
        self,
        view: Vec3,
        footprint: Footprint,
        tint: Tint | None = None,
        active: Mask = True,
        seed: UInt | None = None,
    ) -> ClusteredBsdf:
        """The BSDF of footprints for one view each.

        Args:
            seed: random numbers of the residual, UInt32; None hashes views and footprints, which is right
                where each sample of a pixel has a ray of its own.
        """
        types = array_types(view.x)
        tables = self.on_backend(types)
        if seed is None:
            seed = hashed(view, footprint, tables.size)
        return ClusteredBsdf(
            tables,
            self.point_model,
            self.means,
            self.irregular,
            self.options.samples,
            self.controlled,
            seed,
            view,
            footprint,
            tint,
            active,
        )

    def on_backend(self, types: ArrayTypes) -> DeviceTables:
        """The tables on one backend, uploaded once."""
        if types.Float not in self._uploaded:
            appearance = self.fabric.appearance()
            self._uploaded[types.Float] = DeviceTables(
                self.tables, self._geometry.size, appearance.diffuse_blend, appearance.optical_depth, types
            )
        return self._uploaded[types.Float]

    def shader_tables(self, half: bool = True) -> ShaderTables:
        """The tables, and where texels lie."""
        width, height = self.fabric.repeat_mm
        tables = self.tables
        numbers = {
            "texel_width": width / tables.columns,
            "texel_height": height / tables.rows,
            "samples": self.options.samples,
        }
        return ShaderTables(tables, numbers)

    def own_facts(self) -> dict[str, str]:
        """The size of what was baked."""
        return {
            "tables": f"{self.tables.nbytes / 1e6:.3g} MB",
            "on a device": f"{self.tables.device_bytes / 1e6:.3g} MB",
            "samples": str(self.options.samples),
        }
