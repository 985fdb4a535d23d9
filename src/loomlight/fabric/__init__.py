"""The fabric file: a draft plus yarn and scattering parameters, validated."""

from loomlight.fabric.fabric import Fabric
from loomlight.fabric.read import fabric_from_text, load_fabric

__all__ = ["Fabric", "fabric_from_text", "load_fabric"]
