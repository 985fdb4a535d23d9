"""The one interface of all models: what a footprint of cloth does to light.

Arguments are Dr.Jit arrays of any backend: `light` and `view` unit vectors (Vector3, z < 0 on the back), and
a `Footprint` in draft millimetres. A light on the other side than the view asks for transmission. Values are
f(light, view)·|cos θ_light|, linear RGB, 1/sr, without delta transmission, which `hole` describes.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import Any, ClassVar, Self, final

import drjit as dr

from loomlight.assets.loom_file import LoomFile
from loomlight.core.backend import array_types
from loomlight.core.footprint import Footprint
from loomlight.fabric.fabric import Fabric
from loomlight.scattering.point import Albedos, DirectionSample
from loomlight.scattering.sheen import sheen_transmittance, sheen_with_transmittance


@dataclass
class Response:
    """What a footprint does to light, free of albedos (chen2024 eq. 7): Float each, on the view's side.

    Attributes:
        diffuse_warp, diffuse_weft, specular_warp, specular_weft: means over the view rays through the
            footprint, holes counted as 0, cosine and shadows included, 1/sr; of reflection or of transmission
            by the side of the light.
        hole: share of the view rays that pass through, 0 to 1.
    """

    diffuse_warp: Any
    diffuse_weft: Any
    specular_warp: Any
    specular_weft: Any
    hole: Any

    @property
    def coverage(self) -> Any:
        """Share of the view rays that meet yarn: 1 − hole."""
        return 1 - self.hole


@dataclass
class FamilyAlbedos:
    """Mean albedos of the threads that a footprint shows, a family each, linear RGB."""

    warp: Albedos
    weft: Albedos


def shade(response: Response, albedos: FamilyAlbedos, transmits: Any) -> Any:
    """f·cos of components and albedos (chen2024 eq. 8): Color3, 1/sr, without sheen.

    Args:
        transmits: Bool, light and view lie on different sides.
    """
    warp, weft = albedos.warp, albedos.weft
    near = (
        warp.diffuse_reflect * response.diffuse_warp
        + weft.diffuse_reflect * response.diffuse_weft
        + warp.specular_reflect * response.specular_warp
        + weft.specular_reflect * response.specular_weft
    )
    far = (
        warp.diffuse_transmit * response.diffuse_warp
        + weft.diffuse_transmit * response.diffuse_weft
        + warp.specular_transmit * response.specular_warp
        + weft.specular_transmit * response.specular_weft
    )
    return dr.select(transmits, far, near)


class Model(ABC):
    """A multi-scale model of one fabric.

    Every model passes `tests/models/test_contract.py`, which holds it to what it claims here.

    Attributes:
        name: as the command line and assets call it.
        filters: whether it averages over the footprint; otherwise it looks at one point of it.
        conserves_energy: whether no footprint sends back more light than arrives, at any direction.
        fabric: what it is a model of.
    """

    name: ClassVar[str]
    filters: ClassVar[bool]
    conserves_energy: ClassVar[bool]
    fabric: Fabric

    @classmethod
    @abstractmethod
    def for_fabric(cls, fabric: Fabric) -> Self:
        """The model baked for a fabric, with its usual settings.

        Raises:
            InputError: a fabric that this model cannot handle; the message says why.
        """

    @abstractmethod
    def to_loom(self) -> LoomFile:
        """What a `.loom` file has to hold, so that `from_loom` gives the same numbers bit for bit."""

    @classmethod
    @abstractmethod
    def from_loom(cls, loom: LoomFile) -> Self:
        """The model that a `.loom` file holds, without baking.

        Raises:
            InputError: another model's file; tensors or settings that are missing or of another kind; made
                with a shared network that is not the installed one.
        """

    @abstractmethod
    def evaluate(self, light: Any, view: Any, footprint: Footprint) -> Response:
        """Components and hole of footprints."""

    @abstractmethod
    def albedos(self, view: Any, footprint: Footprint) -> FamilyAlbedos:
        """Mean albedos of each family over footprints, as the view shows them."""

    @abstractmethod
    def sample(self, view: Any, footprint: Footprint, choice: Any, u: Any) -> DirectionSample:
        """A light direction, straight through the holes in proportion to them.

        Args:
            choice: uniform number in [0, 1) that chooses the lobe.
            u: Vector2 of uniform numbers in [0, 1).
        """

    @abstractmethod
    def pdf(self, light: Any, view: Any, footprint: Footprint) -> Any:
        """Density of `sample` per solid angle, without delta: Float, 1/sr."""

    @final
    def value(self, light: Any, view: Any, footprint: Footprint) -> Any:
        """f·cos with the fabric's albedos and its sheen: Color3, 1/sr."""
        return self.composed(
            self.evaluate(light, view, footprint), self.albedos(view, footprint), light, view
        )

    @final
    def composed(self, response: Response, albedos: FamilyAlbedos, light: Any, view: Any) -> Any:
        """`value` of a response and albedos that are at hand already: Color3, 1/sr."""
        return self._under_sheen(shade(response, albedos, light.z * view.z < 0), light, view)

    @final
    def straight_through(self, view: Any, hole: Any) -> Any:
        """Share of light that passes straight through holes, less what sheen takes: Float."""
        sheen = self.fabric.appearance().sheen
        if sheen.strength <= 0:
            return hole
        return hole * sheen_transmittance(_upright(view, view), sheen.strength, sheen.roughness)

    @final
    def _under_sheen(self, body: Any, light: Any, view: Any) -> Any:
        sheen = self.fabric.appearance().sheen
        if sheen.strength <= 0:
            return body
        # The macro normal alone decides the sheen, so it is the same over any footprint.
        lobe, transmittance = sheen_with_transmittance(
            _upright(light, view), _upright(view, view), sheen.strength, sheen.roughness
        )
        return transmittance * body + lobe


def _upright(direction: Any, view: Any) -> Any:
    """A direction in the frame of the face that `view` sees."""
    types = array_types(direction.x)
    return types.Vector3(direction.x, direction.y, dr.select(view.z < 0, -direction.z, direction.z))
