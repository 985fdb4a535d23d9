"""Sources whose queries need a renderer: tiles and height fields are path traced, materials evaluated."""

from __future__ import annotations

from loomlight.mitsuba.heightfield_btf import HeightfieldBtf
from loomlight.mitsuba.material_queries import MaterialReflectance
from loomlight.mitsuba.tile_btf import TileBtf
from loomlight.models.latent.queries import REFLECTANCES
from loomlight.models.neumip.btf import BTFS


def register_query_sources() -> None:
    """Lets trainings ask Mitsuba about the sources that it knows."""
    BTFS.register("heightfield", HeightfieldBtf)
    BTFS.register("tile", TileBtf)
    REFLECTANCES.register("material", MaterialReflectance)
