"""The openness of yarns by the kernel `bake_openness`, which pages run, against the one by Dr.Jit's rays.

Both cast the same view rays from the same places. Lights are turned by numbers of up to 12,000 in single
precision, which the two round differently in their last bits, and a ray that grazes an edge may take the
other side: a few thousandths of the rays. Means over a thousand rays or more agree by 0.003 then, and
coefficients by what they make of their terms.

Covers: scattering/openness.py
"""

from __future__ import annotations

import numpy as np
import pytest

from loomlight.fabric import fabric_from_text
from loomlight.realtime.bake import OPENNESS_KERNEL, RAY_RESULTS, declarations_of, module_text
from loomlight.realtime.device import default_adapter
from loomlight.realtime.words import pack_fabrics
from loomlight.scattering.openness import RayShares, openness_of, openness_of_rays, view_rays
from loomlight.yarn.geometry import YarnGeometry

TOLERANCE = 0.003
FABRICS = [
    'weave = "satin 5"\nwarp.roughness = 0.2\nweft.roughness = 0.6',
    'weave = "plain"\ngap = 0.3\ndiffuse_blend = 0.8\noptical_depth = 0.7',
]


def rays_of_kernel(text: str) -> RayShares:
    """What the kernel finds for each ray."""
    fabric = fabric_from_text(text)
    packed = pack_fabrics([(fabric.layout(), fabric.appearance())])
    places, views = view_rays()
    count = views.shape[1]
    size = np.array(fabric.layout().size)[:, None]
    rays = np.concatenate([places * size, views]).T.astype(np.float32)
    steps = np.concatenate([np.array([0, count], np.uint32), rays.ravel().view(np.uint32)])
    adapter = default_adapter()
    resources = {name: adapter.storage(values) for name, values in packed.buffers().items()}
    resources |= {
        "steps": adapter.storage(steps),
        "scratch": adapter.empty_storage(4 * 2 * count * RAY_RESULTS),
    }
    pipeline = adapter.pipeline(module_text(OPENNESS_KERNEL), OPENNESS_KERNEL)
    used = "\n".join(declarations_of(OPENNESS_KERNEL, OPENNESS_KERNEL))
    encoder = adapter.device.create_command_encoder()
    compute = encoder.begin_compute_pass()
    compute.set_pipeline(pipeline)
    compute.set_bind_group(0, adapter.bindings(pipeline, used, resources))
    compute.dispatch_workgroups(-(-2 * count // 64))
    compute.end()
    adapter.device.queue.submit([encoder.finish()])
    words = adapter.read(resources["scratch"], np.uint32, 2 * count * RAY_RESULTS).reshape(-1, RAY_RESULTS)
    bits, numbers = words[:, 0], words.view(np.float32).T.astype(np.float64)
    return RayShares(
        is_warp=(bits & 1) != 0,
        is_yarn=(bits & 2) == 0,
        is_blocked=(bits & 4) != 0,
        meets_warp=(bits & 8) != 0,
        normal_cosines=numbers[1],
        heights=numbers[2],
        halves=numbers[3:5],
        far=numbers[5],
        layers=numbers[6:].reshape(2, 2, -1),
    )


@pytest.mark.slow
@pytest.mark.parametrize("text", FABRICS)
def test_openness_of_the_kernel_is_that_of_rays(text: str) -> None:
    fabric = fabric_from_text(text)
    layout, look = fabric.layout(), fabric.appearance()
    met = rays_of_kernel(text)
    roughness = look.warp.roughness, look.weft.roughness
    wanted = openness_of(layout, look.diffuse_blend, roughness, look.optical_depth)
    found = openness_of_rays(met, YarnGeometry(layout).height_bounds[1], wanted.layers)
    assert found.relief == wanted.relief
    for name in ("interior", "meets", "blocks", "facing", "facing_layer"):
        np.testing.assert_allclose(getattr(found, name), getattr(wanted, name), atol=TOLERANCE, err_msg=name)
    # Coefficients of terms that go together are not unique; what they say of views and points is.
    x, y, z = view_rays()[1]
    cosines, heights = met.normal_cosines, met.heights / found.relief
    seen = met.is_yarn
    terms = np.stack(np.broadcast_arrays(1.0, np.hypot(x, y), (1 - z) ** 2, (1 - z) ** 4, x * x - y * y))
    of_point = np.stack(
        np.broadcast_arrays(1.0, cosines, heights, cosines * cosines, cosines * heights, heights * heights)
    )[:, seen]
    difference = (found.by_view - wanted.by_view) @ terms
    assert np.sqrt((difference**2).mean(axis=-1)).max() < 3 * TOLERANCE
    assert np.sqrt((((found.warp_seen - wanted.warp_seen) @ terms) ** 2).mean()) < TOLERANCE
    for face in (0, 1):
        of_face = of_point[:, (np.flatnonzero(seen) >= x.size) == (face == 1)]
        difference = (found.by_point - wanted.by_point)[face] @ of_face
        assert np.sqrt((difference**2).mean(axis=-1)).max() < 3 * TOLERANCE
