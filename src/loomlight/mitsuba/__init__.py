"""Cloth in Mitsuba 3: plugins, the footprint integrator, meshes and scenes.

Importing this package registers its plugins in every supported variant (`llvm_ad_rgb`, `cuda_ad_rgb`), now or
as soon as one is set; it never sets one.
"""

from __future__ import annotations

from loomlight.mitsuba.plugins import follow_variants
from loomlight.mitsuba.variants import choose_variant

__all__ = ["choose_variant"]

follow_variants()
