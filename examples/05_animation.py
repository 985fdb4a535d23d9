"""An animation: the camera comes closer, and kernels are compiled once for all frames."""

from pathlib import Path

import loomlight
from loomlight.mitsuba import build_scene, choose_variant, material_bsdf, render

choose_variant()  # llvm_ad_rgb, unless another supported variant is set
cloth = material_bsdf(Path(__file__).parent / "silk-satin.toml")
shown = build_scene("drape", cloth, size=(160, 120))
for frame in range(4):
    # From the whole drape to twelve times closer, towards the middle of the cloth.
    shown.look_from(shown.view.closer(12 ** (frame / 3), shown.point))
    picture = render(shown.scene, spp=4, seed=frame, integrator=shown.integrator)
    loomlight.save(picture, f"frame-{frame}.png")
