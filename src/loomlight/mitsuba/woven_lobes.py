"""`woven_lobes`: prefiltered fibre lobes as a Mitsuba BSDF, for any distance, one sample a pixel, untrained.

It averages over the footprint that `footprint_path` hands it.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

from loomlight.aggregate.footprint_albedos import FootprintAlbedos
from loomlight.assets.loom_file import is_loom, read_loom
from loomlight.core.footprint import Footprint
from loomlight.fabric.fabric import Fabric
from loomlight.mitsuba.fabric_props import whole_number_of_props
from loomlight.mitsuba.footprint_bsdf import SeenCloth, footprint_bsdf_class
from loomlight.models.interface import FamilyAlbedos, Response
from loomlight.models.lobes.model import DEFAULT_GROUPS, MOST_GROUPS, LobesModel, tables_of
from loomlight.models.lobes.proposal import Shares
from loomlight.models.lobes.tables import LobeTables, tables_of_loom
from loomlight.scattering.point import DirectionSample


def woven_lobes_class() -> type:
    """The BSDF's class in the current variant, for `mi.register_bsdf`."""
    base: Any = footprint_bsdf_class()

    class WovenLobes(base):
        """Woven cloth over footprints, by lobes of groups of like yarn points.

        Parameters beside those of `FootprintBsdf`:
            groups: of each family on average, 1 to 64; 8. A `.loom` that was baked for this model is used as
                it is where nothing in the scene changes its fabric and `groups` is not given.

        Scene parameters are those of `FootprintBsdf`. A change of heights, inclination or twist bakes tables
        anew, one of roughness, colours or sheen does not.
        """

        baked_parameters = ("height_scale", "inclination", "twist")
        symbolic = True

        def __init__(self, props: Any) -> None:
            super().__init__(props)
            self._groups = whole_number_of_props(props, "groups", f"one from 1 to {MOST_GROUPS}")
            self.finish()

        def bake(self) -> None:
            """Measures the tables, or reads them from the material that the fabric lies in."""
            found = _in_material(self.fabric) if self._groups is None else None
            groups = DEFAULT_GROUPS if self._groups is None else self._groups
            self._tables = found or tables_of(self.fabric, groups)

        def assembled(self) -> LobesModel:
            """The model of the tables baked last."""
            return LobesModel(self.fabric, self._tables)

        def seen_cloth(self, albedos: FamilyAlbedos, view: Any, footprint: Footprint) -> SeenCloth:
            """The footprint's lobes."""
            return _SeenLobes(self.model, albedos, view, footprint)

        def mean_albedos(self, means: FootprintAlbedos, view: Any, footprint: Footprint) -> FamilyAlbedos:
            """Close up those of the yarn that the middle ray meets."""
            return self.model.albedos_from(means, view, footprint)

        def hole(self, view: Any, footprint: Footprint) -> Any:
            """Share of the view rays that pass through footprints: Float."""
            return self.model.hole(view, footprint)

        def to_string(self) -> str:
            """The fabric, and the size of what was baked of it."""
            return str(self.described(tables=f"{self._tables.nbytes / 1e3:.3g} kB"))

    return WovenLobes


@dataclass
class _SeenLobes:
    """A `SeenCloth` of lobes; how directions are drawn is worked out once, and where it is asked for."""

    model: LobesModel
    albedos: FamilyAlbedos
    view: Any
    footprint: Footprint

    @cached_property
    def _shares(self) -> Shares:
        return self.model.shares(self.albedos, self.view, self.footprint)

    def response(self, light: Any, lit: Any = True) -> Response:
        return self.model.evaluate(light, self.view, self.footprint, lit)

    def pdf(self, light: Any) -> Any:
        return self.response_and_pdf(light)[1]

    def response_and_pdf(self, light: Any) -> tuple[Response, Any]:
        return self.model.response_and_pdf(self._shares, light, self.view, self.footprint)

    def sample(self, choice: Any, u: Any) -> DirectionSample:
        return self.model.sample_with(self.albedos, self._shares, self.view, self.footprint, choice, u)

    def respond_and_sample(self, light: Any, choice: Any, u: Any) -> tuple[Response, Any, DirectionSample]:
        return self.model.respond_and_sample(
            self.albedos, self._shares, light, self.view, self.footprint, choice, u
        )


def _in_material(fabric: Fabric) -> LobeTables | None:
    """The tables in the `.loom` that a fabric was read from; None where it holds none for this one."""
    if not is_loom(fabric.folder):
        return None
    loom = read_loom(fabric.folder)
    if loom.model != LobesModel.name or loom.fabric.to_toml() != fabric.to_toml():
        return None
    return tables_of_loom(loom)
