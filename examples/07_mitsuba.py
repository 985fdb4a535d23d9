"""Mitsuba: cloth as a BSDF of a scene of your own."""

import mitsuba as mi

mi.set_variant("llvm_ad_rgb")  # or cuda_ad_rgb
import loomlight.mitsuba  # noqa: E402, F401  registers the BSDFs and the integrator

scene = mi.load_dict(
    {
        "type": "scene",
        "integrator": {"type": "footprint_path"},  # hands footprints to the cloth
        "sensor": {
            "type": "perspective",
            "to_world": mi.ScalarTransform4f().look_at([0, -2, 3], [0, 0, 0], [0, 1, 0]),
            "film": {"type": "hdrfilm", "width": 160, "height": 120},
        },
        "light": {"type": "directional", "direction": [1, -0.5, -1], "irradiance": 3.0},
        "cloth": {
            "type": "rectangle",
            # Millimetres per unit of u and of v.
            "bsdf": {"type": "woven_lobes", "weave": "satin 5/2", "uv_size": "20,20"},
        },
    }
)
mi.util.write_bitmap("satin.png", mi.render(scene, spp=4), write_async=False)
