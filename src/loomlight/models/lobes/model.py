"""Prefiltered fibre lobes as a multi-scale model: tables of one fabric, no training."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self, final

from loomlight.core.arrays import Mask, Vec3
from loomlight.core.backend import ArrayTypes, array_types
from loomlight.core.fleet import Report
from loomlight.core.footprint import Footprint
from loomlight.core.llvm import llvm_float
from loomlight.core.settings import setting
from loomlight.fabric.fabric import Fabric
from loomlight.models.fabric_model import FilteredFabricModel, fabric_in_loom, fabric_source
from loomlight.models.interface import ShaderTables
from loomlight.models.lobes.bsdf import LobesBsdf
from loomlight.models.lobes.point_sampled import RegimeScale
from loomlight.models.lobes.prefiltered import PrefilteredLobes
from loomlight.models.lobes.tables import LobeTables, bake_tables, given_numbers
from loomlight.models.lobes.visibility import JOINT_FACTORS
from loomlight.models.options import Options
from loomlight.scattering.point import Tint, YarnScattering
from loomlight.sources.kinds import Source
from loomlight.sources.loom_file import LoomFile
from loomlight.yarn.rays import upload_extent
from loomlight.yarn.stack import cloth_geometry

DEFAULT_GROUPS = 12
MAX_GROUPS = 64
# Of one group: 24 for interpolation, 27 for variances, 21 for cosines, 8 for areas, 25 for the density, 15
# for attenuation.
_MULTIPLY_ADDS = 120
# Scene parameters of a family that tables depend on.
_BAKED = ("height_scale", "inclination", "twist")


@dataclass(frozen=True, kw_only=True)
class LobesOptions(Options):
    """Options of `lobes`."""

    title: ClassVar[str] = "option of lobes"

    groups: int = setting(
        DEFAULT_GROUPS,
        "Groups of similar yarn points of each family, on average.",
        low=1,
        high=MAX_GROUPS,
        stored=True,
    )


@final
class LobesModel(FilteredFabricModel):
    """Groups of similar yarn points, with lobes in closed form.

    Edits of heights, inclination or twist bake the tables again; edits of roughness, colours or sheen do not.

    Attributes:
        tables: the baked tables.
        multiply_adds: of one prefiltered query, counted from its formulas.
        bytes_fetched: by one prefiltered query, from tables that depend on position or direction. The
            moments, 48 bytes a group, are the same for all queries of a face and not counted; neither are
            bytes loaded along with those of holes.
    """

    name = "lobes"
    conserves_energy = True
    options_class = LobesOptions
    options: LobesOptions

    def __init__(self, fabric: Fabric, tables: LobeTables, options: LobesOptions | None = None) -> None:
        """A model of baked tables; see `for_source` to bake them."""
        super().__init__(fabric)
        self.tables = tables
        self.options = options or LobesOptions()
        self._geometry = cloth_geometry(fabric.layout())
        self.point_model = YarnScattering(self._geometry, fabric.appearance())
        self._uploaded: dict[type, tuple[PrefilteredLobes, RegimeScale]] = {}
        packs = tables.packs
        self.multiply_adds = _MULTIPLY_ADDS * 4 * packs
        # Nine nodes of the pyramid, four of the view, four of the light; factors of four nodes each.
        self.bytes_fetched = 4 * (9 * (packs + 1) + 4 * (packs + 1) + 4 * 2 * packs + 2 * 4 * JOINT_FACTORS)

    @classmethod
    def for_source(
        cls, source: Source, options: LobesOptions | None = None, report: Report | None = None
    ) -> Self:
        """The model of a fabric; see `find_groups`.

        Raises:
            InputError: no fabric.
        """
        del report
        fabric, options = fabric_source(source, cls.name), options or LobesOptions()
        return cls(fabric, tables_of(fabric, options.groups), options)

    def with_fabric(self, fabric: Fabric, edits: frozenset[str]) -> Self:
        """The model of an edited fabric; tables are kept unless the edit changes the yarns' geometry."""
        if any(name.endswith(_BAKED) for name in edits):
            return self.with_source(fabric)
        return type(self)(fabric, self.tables, self.options)

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
        return cls(fabric, loom.tables(LobeTables), LobesOptions.of_loom(loom))

    def upload(self, types: ArrayTypes) -> None:
        """Uploads all tables to a backend, which otherwise happens at first use."""
        super().upload(types)
        self._geometry.upload(types)
        upload_extent(self._geometry, types)
        self.point_model.parameters(types)
        self.point_model.detail(types)
        self.on_backend(types)

    def at(
        self, view: Vec3, footprint: Footprint, tint: Tint | None = None, active: Mask = True
    ) -> LobesBsdf:
        """The BSDF of footprints for one view each."""
        del active
        lobes, scale = self.on_backend(array_types(view.x))
        regime = scale.of(footprint)
        return LobesBsdf(lobes, self.point_model, self.means, self.irregular, regime, view, footprint, tint)

    def on_backend(self, types: ArrayTypes) -> tuple[PrefilteredLobes, RegimeScale]:
        """The tables and lengths on one backend, uploaded once."""
        if types.Float not in self._uploaded:
            layout, appearance = self.fabric.layout(), self.fabric.appearance()
            roughness = appearance.warp.roughness, appearance.weft.roughness
            self._uploaded[types.Float] = (
                PrefilteredLobes(self.tables, layout.size, roughness, appearance.optical_depth, types),
                RegimeScale(layout, self.tables.base_size, types),
            )
        return self._uploaded[types.Float]

    def shader_tables(self, half: bool = True) -> ShaderTables:
        """The tables, and the lengths that separate the regimes."""
        return ShaderTables(self.tables, given_numbers(self.fabric.layout(), self.tables.base_size))

    def own_facts(self) -> dict[str, str]:
        """The size of what was baked."""
        return {"tables": f"{self.tables.nbytes / 1e3:.3g} kB"}


def tables_of(fabric: Fabric, groups: int) -> LobeTables:
    """Bakes the tables of a fabric with so many groups of each family, 1 to 64, on average."""
    geometry = cloth_geometry(fabric.layout())
    return bake_tables(geometry, fabric.appearance().diffuse_blend, groups, llvm_float())
