"""Cloth in real time: frames of meshes on a graphics adapter. One Slang source serves every API."""

from __future__ import annotations

from loomlight.realtime.renderer import Picture, Renderer
from loomlight.realtime.scene import Camera, Cloth, DirectionalLight, Environment, Mesh, PointLight, rectangle

__all__ = [
    "Camera",
    "Cloth",
    "DirectionalLight",
    "Environment",
    "Mesh",
    "Picture",
    "PointLight",
    "Renderer",
    "rectangle",
]
