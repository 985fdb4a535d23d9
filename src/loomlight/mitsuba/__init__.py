"""Cloth in Mitsuba 3: plugins, the footprint integrator, meshes and scenes.

Importing this package registers its plugins in every supported variant (`llvm_ad_rgb`, `cuda_ad_rgb`), now or
as soon as one is set; it never sets one.
"""

from __future__ import annotations

from loomlight.core.picture_settings import Placement, RenderSettings, Worn
from loomlight.mesh.cloth_mesh import ClothMesh, uv_size
from loomlight.mesh.reading import read_mesh
from loomlight.mitsuba.lights import LIGHTS
from loomlight.mitsuba.meshes import to_shape
from loomlight.mitsuba.plugins import material_bsdf, register_plugins
from loomlight.mitsuba.rendering import render
from loomlight.mitsuba.scenes import SCENES, ClothScene, build_scene
from loomlight.mitsuba.variants import SUPPORTED_VARIANTS, choose_variant

__all__ = [
    "LIGHTS",
    "SCENES",
    "SUPPORTED_VARIANTS",
    "ClothMesh",
    "ClothScene",
    "Placement",
    "RenderSettings",
    "Worn",
    "build_scene",
    "choose_variant",
    "material_bsdf",
    "read_mesh",
    "render",
    "to_shape",
    "uv_size",
]

register_plugins()
