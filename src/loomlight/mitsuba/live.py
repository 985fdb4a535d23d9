"""A picture that is taken again and again while the scene is edited: traced once, then only launched.

Tracing a path tracer through a BSDF of cloth takes Python 50 ms, whatever the size of the picture. Dr.Jit's
frozen functions keep what was launched, and launch it again with whatever the scene's arrays hold by then.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.core.frozen import frozen, gc_paused, leaves
from loomlight.mitsuba.bsdf import SceneTraits, model_bsdfs
from loomlight.mitsuba.path import footprint_integrator, with_settings
from loomlight.mitsuba.variants import in_turn


class LivePicture:
    """Pictures of one scene from one camera, of the same size and with the same samples a pixel.

    Edits of the scene's parameters show in the next picture. Where they change which arrays there are, or
    which are of one size, that picture is traced anew. Scenes with networks are traced every time.
    """

    @in_turn
    def __init__(
        self, scene: mi.Scene, *, spp: int = 1, sensor: int = 0, integrator: Any = None, records: bool = True
    ) -> None:
        """Takes the first pictures, which compile the kernels.

        Args:
            scene: a Mitsuba scene; what it is made of may be edited, the scene itself stays.
            spp: samples a pixel, ≥ 1.
            sensor: the index of the camera.
            integrator: by default the scene's own if it is a `footprint_path`, otherwise a new one.
            records: launches are recorded and repeated, which saves 40 ms a picture.

        Raises:
            InputError: spp < 1.
        """
        if spp < 1:
            raise InputError(f"spp = {spp} is too small: a pixel needs at least 1 sample.")
        self._scene = scene
        self._integrator = integrator or footprint_integrator(scene)
        # Not a bound method: what refers to itself is freed by the garbage collector, whenever that runs.
        self._rendered = _renderer(sensor, spp)
        enabled = records and SceneTraits.of(scene).symbolic
        self._launch = frozen(self._rendered, enabled=enabled)
        # Once without freezing: whatever is uploaded when it is first used must be there beforehand.
        dr.eval(self._rendered(scene, self._integrator, mi.UInt32(0), []))
        for seed in range(2):
            self.take(seed)

    @in_turn
    def take(self, seed: int = 0) -> NDArray[np.float32]:
        """The picture as the scene is now: linear [height, width, channels of the film].

        Args:
            seed: any 32-bit number.
        """
        try:
            with gc_paused():
                shown = self._launch(self._scene, self._integrator, mi.UInt32(seed), _held())
            return np.array(shown, dtype=np.float32)
        except RuntimeError:
            # A cloth that was never traced, of whichever scene, has arrays to upload: that is done here.
            return np.array(self._rendered(self._scene, self._integrator, seed, []), dtype=np.float32)


def _renderer(camera: int, samples: int) -> Callable[[Any, Any, Any, list[Any]], Any]:
    """Renders a scene by an integrator; frozen functions look at what else its cloths hold."""

    def rendered(scene: mi.Scene, integrator: Any, seed: Any, held: list[Any]) -> Any:
        del held
        with with_settings(integrator, skip_film=True):
            return mi.render(scene, sensor=camera, integrator=integrator, spp=samples, seed=seed)

    return rendered


def _held() -> list[tuple[list[Any], tuple[float, ...]]]:
    """Arrays of every cloth that there is, which Dr.Jit does not find by itself, and its literals."""
    return [(leaves(cloth), cloth.literals) for cloth in model_bsdfs()]
