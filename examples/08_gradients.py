"""Gradients: the colour of a warp, found from a picture by gradient descent."""

import drjit as dr
import mitsuba as mi

from loomlight.mitsuba import build_scene, choose_variant, material_bsdf

choose_variant()
# Single yarn points have derivatives of all their parameters, and pictures of few pixels show a colour.
shown = build_scene("flat", material_bsdf("twill 2/2", "point"), size=(8, 6), light="directional")
parameters = mi.traverse(shown.scene)
(key,) = (name for name in parameters.keys() if name.endswith("warp.diffuse_reflect"))  # noqa: SIM118  no dict


def picture(albedo, seed, spp=32):
    """The scene with another albedo of the warp."""
    parameters[key] = albedo
    parameters.update()
    return mi.render(shown.scene, parameters, integrator=shown.integrator, spp=spp, seed=seed)


wanted = dr.detach(picture(mi.Color3f(0.5, 0.1, 0.05), seed=99, spp=512))
optimizer = mi.ad.Adam(lr=0.03)
optimizer["albedo"] = mi.Color3f(0.3, 0.3, 0.3)
for step in range(40):
    loss = dr.mean(dr.square(picture(optimizer["albedo"], step) - wanted), axis=None)
    dr.backward(loss)
    optimizer.step()
    optimizer["albedo"] = dr.clip(optimizer["albedo"], 0.01, 0.9)
print("found", optimizer["albedo"], "of 0.5 0.1 0.05")
