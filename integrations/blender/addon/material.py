# SPDX-License-Identifier: GPL-3.0-or-later
"""The material of a folder of maps: a node group whose colours are sockets, and what it needs of an object.

Maps of three densities fade into each other by the width of a pixel on the cloth. The highlight has a node of
its own, as cloth reflects little at grazing angles, where the principled node reflects all; so has light that
comes through.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import bpy

from .nodes import NodeTree, Socket

# Sockets of the group, which the panel shows.
COLOURS = {"warp": "Warp Color", "weft": "Weft Color"}
SHEEN, RELIEF, WIDTH = "Sheen", "Displacement", "Millimetres"
# A property of objects: millimetres that a unit of u and of v are on its surface.
SCALE = "loomlight_mm"
# A property of materials and groups: what they were made of.
MARK = "loomlight"
# A density is gone when a pixel is as wide as a texel of the next one, and alone when it is a third of that.
_FADE = 3.0
# Planes at which lines of sight are looked at, and the least cosine of these with the normal.
_PLANES, _MIN_COSINE = 8, 0.25


class MapsError(Exception):
    """A folder of maps that cannot be used; the message is one sentence."""


def make_material(folder: Path, manifest: dict[str, Any], relief: bool) -> bpy.types.Material:
    """The material of a folder of maps, whose pictures are packed; if it fails, nothing is left behind.

    Args:
        relief: whether yarns displace the surface near by; else their normals do it.

    Raises:
        MapsError: a map is missing or the manifest is not whole.
    """
    made: list[bpy.types.ID] = []
    try:
        return _material(folder, manifest, relief, made)
    except (KeyError, TypeError, ValueError, IndexError, RuntimeError, OSError) as error:
        for block in reversed(made):
            bpy.data.batch_remove([block])
        raise MapsError(f"The maps of the fabric cannot be read: {' '.join(str(error).split())}.") from error


def _material(
    folder: Path, manifest: dict[str, Any], relief: bool, made: list[bpy.types.ID]
) -> bpy.types.Material:
    name = str(manifest["fabric"])
    group = bpy.data.node_groups.new(f"Loomlight {name}", "ShaderNodeTree")
    made.append(group)
    group[MARK] = name
    _Cloth(NodeTree(group), folder, manifest, made).build()
    material = bpy.data.materials.new(name)
    made.append(material)
    material[MARK] = name
    if bpy.app.version < (5, 0):
        material.use_nodes = True
    material.displacement_method = "BOTH" if relief else "BUMP"
    tree = material.node_tree
    tree.nodes.clear()
    node = tree.nodes.new("ShaderNodeGroup")
    node.node_tree, node.name, node.width = group, MARK, 220
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    output.location = (300, 0)
    tree.links.new(node.outputs["BSDF"], output.inputs["Surface"])
    if relief:
        tree.links.new(node.outputs["Displacement"], output.inputs["Displacement"])
    node.inputs[RELIEF].default_value = float(relief)
    return material


def group_node(material: bpy.types.Material | None) -> bpy.types.Node | None:
    """The node of a material that this add-on made; None of others."""
    if material is None or MARK not in material or material.node_tree is None:
        return None
    return material.node_tree.nodes.get(MARK)


class _Cloth:
    """Builds the nodes of a group."""

    def __init__(
        self, tree: NodeTree, folder: Path, manifest: dict[str, Any], made: list[bpy.types.ID]
    ) -> None:
        self._tree, self._folder, self._manifest, self._made = tree, folder, manifest, made
        self._sockets()

    def build(self) -> None:
        """Makes all nodes."""
        tree = self._tree
        self._fades = self._fades_by_distance()
        # Displaced yarns have their normals and their places already where they are near.
        near = tree.math("SUBTRACT", 1.0, self._fades[0])
        displaced = tree.math("MULTIPLY", tree.math("MINIMUM", tree.input(RELIEF), 1.0), near)
        tangent = tree.node("ShaderNodeTangent", direction_type="UV_MAP").outputs["Tangent"]
        self._place_on_surface = self._place = self._place_in_tile()
        heights = self._heights()
        self._place = self._seen_place(tangent, heights, tree.math("SUBTRACT", near, displaced))
        self._places = self._places_in_tiles()
        # 1. Diffuse reflection: a weight times a colour, a family each.
        parts = [self._map(family) for family in COLOURS]
        own = [tree.colour(self._manifest["colors"][family]) for family in COLOURS]
        shown = [tree.input(name) for name in COLOURS.values()]
        base = tree.vector(
            "ADD", *(tree.vector("MULTIPLY", *pair) for pair in zip(parts, shown, strict=True))
        )
        before = tree.vector(
            "ADD", *(tree.vector("MULTIPLY", *pair) for pair in zip(parts, own, strict=True))
        )
        # 2. What comes through is dyed as what comes back is.
        dye = tree.vector("DIVIDE", base, tree.vector("MAXIMUM", before, (1e-4, 1e-4, 1e-4)))
        through = tree.vector("MULTIPLY", self._map("through"), dye)
        # 3. Directions.
        normal = tree.node("ShaderNodeNormalMap")
        tree.feed(normal, Color=self._map("normal"), Strength=tree.math("SUBTRACT", 1.0, displaced))
        normal = normal.outputs["Normal"]
        fibres = tree.separate(self._map("fibres"))
        sine, cosine = (tree.math("MULTIPLY_ADD", fibres[k], 2.0, -1.0) for k in (1, 0))
        # Of half the doubled angle, as a share of a turn.
        turn = tree.math("MULTIPLY", tree.math("ARCTAN2", sine, cosine), 0.25 / 3.141592653589793)
        # 4. Layers.
        surface = tree.separate(self._map("surface"))
        about_mesh, about_yarns = self._diffuse(base), self._diffuse(base)
        tree.link(normal, about_yarns.inputs["Normal"])
        diffuse = tree.mix_shader(float(self._manifest["diffuse_blend"]), about_mesh, about_yarns)
        glossy = tree.node("ShaderNodeBsdfAnisotropic", distribution="GGX")
        tree.feed(
            glossy, Color=self._map("glossy"), Roughness=surface[0], Anisotropy=fibres[2], Rotation=turn
        )
        tree.feed(glossy, Normal=normal, Tangent=tangent)
        translucent = tree.node("ShaderNodeBsdfTranslucent")
        tree.feed(translucent, Color=through, Normal=normal)
        cloth = tree.add(tree.add(diffuse, glossy), translucent)
        # 5. Holes.
        tree.output("BSDF", tree.mix_shader(surface[1], tree.node("ShaderNodeBsdfTransparent"), cloth))
        tree.output("Displacement", self._displacement(heights))
        tree.arrange()

    def _diffuse(self, base: Socket) -> bpy.types.Node:
        """A diffuse layer under the sheen, about the mesh's normal unless another one is plugged in."""
        tree = self._tree
        principled = tree.node("ShaderNodeBsdfPrincipled")
        tree.feed(principled, **{"Base Color": base, "Specular IOR Level": 0.0, "Roughness": 1.0})
        # Blender before 4.4 has smooth diffuse layers alone.
        if "Diffuse Roughness" in principled.inputs:
            tree.feed(principled, **{"Diffuse Roughness": self._blended("diffuse_roughness")})
        tree.feed(principled, **{"Sheen Weight": tree.input(SHEEN)})
        tree.feed(principled, **{"Sheen Roughness": float(self._manifest["sheen"]["roughness"])})
        return principled

    def _sockets(self) -> None:
        for family, name in COLOURS.items():
            self._tree.socket(name, "NodeSocketColor", (*map(float, self._manifest["colors"][family]), 1.0))
        self._tree.socket(SHEEN, "NodeSocketFloat", float(self._manifest["sheen"]["strength"]), 0.0, 1.0)
        self._tree.socket(RELIEF, "NodeSocketFloat", 0.0, 0.0, 4.0)
        self._tree.socket(WIDTH, "NodeSocketFloat", 1000.0, 1e-3, 1e6)
        self._tree.socket("BSDF", "NodeSocketShader", is_input=False)
        self._tree.socket("Displacement", "NodeSocketVector", is_input=False)

    def _place_in_tile(self) -> Socket:
        """Where on the maps a place of the surface is, from uv and the object's scale."""
        tree = self._tree
        scale = tree.node("ShaderNodeAttribute", attribute_type="OBJECT", attribute_name=SCALE).outputs[
            "Vector"
        ]
        # An object that has none is as wide as the group says.
        has_none = tree.math("LESS_THAN", tree.separate(scale)[0], 1e-6)
        width = tree.math("MULTIPLY", has_none, tree.input(WIDTH))
        scale = tree.vector("ADD", scale, tree.combine(width, width, width))
        uv = tree.node("ShaderNodeUVMap").outputs["UV"]
        across, up = self._size(0)
        return tree.vector("MULTIPLY", tree.vector("MULTIPLY", uv, scale), (1 / across, 1 / up, 0.0))

    def _size(self, density: int) -> tuple[float, float]:
        """Width and height of what the maps of a density hold, millimetres."""
        width, height = map(float, self._manifest["densities"][density]["size_mm"])
        return width, height

    def _places_in_tiles(self) -> list[Socket]:
        """The place that is seen on the maps of each density."""
        near, found = self._size(0), [self._place]
        for density in range(1, len(self._manifest["densities"])):
            across, up = (own / other for own, other in zip(near, self._size(density), strict=True))
            found.append(self._tree.vector("MULTIPLY", self._place, (across, up, 0.0)))
        return found

    def _fades_by_distance(self) -> list[Socket]:
        """How far each density has faded into the next, 0 to 1."""
        tree = self._tree
        camera = tree.node("ShaderNodeCameraData").outputs["View Distance"]
        per_unit = tree.driven("Pixel a unit away", _PERSPECTIVE)
        parallel = tree.driven("Pixel of parallel rays", _ORTHOGRAPHIC)
        pixel = tree.math("MULTIPLY_ADD", camera, per_unit, parallel)
        wide = tree.math("LOGARITHM", tree.math("MAXIMUM", pixel, 1e-6), 2.718281828459045)
        texels = [float(density["texel_mm"]) for density in self._manifest["densities"]]
        return [tree.smoothstep(wide, texel / _FADE, texel) for texel in texels[1:]]

    def _map(self, key: str) -> Socket:
        """A map as values, its densities blended."""
        tree = self._tree
        values = []
        for density, place in zip(self._manifest["densities"], self._places, strict=True):
            described = density["maps"][key]
            node = self._image(described["file"], bool(described["is_color"]), place)
            peak = float(described["peak"])
            colour = node.outputs["Color"]
            values.append(colour if peak == 1.0 else tree.vector("MULTIPLY", colour, (peak, peak, peak)))
        found = values[0]
        for value, fade in zip(values[1:], self._fades, strict=True):
            found = tree.mix(fade, found, value)
        return found

    def _image(self, file: str, is_colour: bool, place: Socket) -> bpy.types.Node:
        """A picture at a place on it."""
        node = self._tree.node("ShaderNodeTexImage", image=self._load(file, is_colour), extension="REPEAT")
        self._tree.link(place, node.inputs["Vector"])
        return node

    def _load(self, file: str, is_colour: bool) -> bpy.types.Image:
        """A picture, packed."""
        image = bpy.data.images.load(str(self._folder / file))
        self._made.append(image)
        image.name = f"{self._manifest['fabric']} {Path(file).stem}"
        image.colorspace_settings.name = "sRGB" if is_colour else "Non-Color"
        image.alpha_mode = "NONE"
        image.pack()
        # The path is of a folder that will be gone.
        image.filepath = image.filepath_raw = f"//{Path(file).name}"
        return image

    def _blended(self, key: str) -> Socket:
        """A number that each density has."""
        found: Socket | float = float(self._manifest["densities"][0][key])
        for density, fade in zip(self._manifest["densities"][1:], self._fades, strict=True):
            found = self._tree.mix_number(fade, found, float(density[key]))
        return found

    def _heights(self) -> bpy.types.Image:
        """The picture of heights, 16 bits."""
        return self._load(self._manifest["height"]["file"], False)

    def _height(self, heights: bpy.types.Image, place: Socket) -> Socket:
        """Millimetres above the surface at a place on the maps."""
        low, high = self._range_of_heights()
        node = self._tree.node("ShaderNodeTexImage", image=heights, extension="REPEAT")
        self._tree.link(place, node.inputs["Vector"])
        return self._tree.math("MULTIPLY_ADD", node.outputs["Color"], high - low, low)

    def _range_of_heights(self) -> tuple[float, float]:
        return float(self._manifest["height"]["low_mm"]), float(self._manifest["height"]["high_mm"])

    def _seen_place(self, tangent: Socket, heights: bpy.types.Image, amount: Socket) -> Socket:
        """The place on the maps where the line of sight meets the yarns; on the surface if `amount` is 0.

        A line is looked at where it crosses planes, from the highest to the lowest; between the last one that
        is above the yarns and the first that does not, heights are taken to be straight.
        """
        tree = self._tree
        geometry = tree.node("ShaderNodeNewGeometry")
        normal, view = geometry.outputs["Normal"], geometry.outputs["Incoming"]
        up = tree.vector("CROSS_PRODUCT", normal, tangent)
        along, across, above = (tree.dot(view, axis) for axis in (tangent, up, normal))
        front = tree.math("MULTIPLY", amount, tree.math("SUBTRACT", 1.0, geometry.outputs["Backfacing"]))
        # Steeper lines would be looked at too seldom.
        slope = tree.math("DIVIDE", front, tree.math("MAXIMUM", above, _MIN_COSINE))
        width, height = self._size(0)
        step = tree.combine(
            tree.math("MULTIPLY", along, tree.math("MULTIPLY", slope, 1 / width)),
            tree.math("MULTIPLY", across, tree.math("MULTIPLY", slope, 1 / height)),
            0.0,
        )
        low, high = self._range_of_heights()
        thickness = (high - low) / _PLANES
        found: Socket | float = 0.0
        plane: Socket | float = low
        before: Socket | float = -thickness
        for number in range(_PLANES):
            z = high - thickness * (number + 1)
            place = tree.vector("MULTIPLY_ADD", step, (z, z, z), self._place)
            depth = tree.math("SUBTRACT", self._height(heights, place), z)
            meets = tree.math("GREATER_THAN", depth, 0.0)
            first = tree.math("MULTIPLY", meets, tree.math("SUBTRACT", 1.0, found))
            share = tree.math("DIVIDE", depth, tree.math("SUBTRACT", depth, before))
            here = tree.math("MULTIPLY_ADD", share, thickness, z)
            plane = tree.mix_number(first, plane, here)
            found, before = tree.math("MAXIMUM", found, meets), depth
        shift = tree.vector("SCALE", step)
        tree.link(plane, shift.node.inputs["Scale"])
        return tree.vector("ADD", self._place, shift)

    def _displacement(self, heights: bpy.types.Image) -> Socket:
        """Heights above the surface in units of the scene, as much as the group's socket says."""
        tree = self._tree
        scale = tree.math("MULTIPLY", tree.input(RELIEF), tree.driven("Units a millimetre", _UNITS))
        node = tree.node("ShaderNodeDisplacement")
        tree.feed(node, Height=self._height(heights, self._place_on_surface), Midlevel=0.0, Scale=scale)
        return node.outputs["Displacement"]


# Drivers: an expression, and what its names are of the active scene. Pixels are square; a lens' angle is of
# the picture's longer side.
_PICTURE = {
    "width": "render.resolution_x",
    "height": "render.resolution_y",
    "percent": "render.resolution_percentage",
    "metres": "unit_settings.scale_length",
    "kind": "camera.data.type",
}
_PERSPECTIVE = (
    "0 if kind == 1 else 200000 * metres * tan(angle / 2) / (max(width, height) * percent)",
    _PICTURE | {"angle": "camera.data.angle"},
)
_ORTHOGRAPHIC = (
    "100000 * metres * side / (max(width, height) * percent) if kind == 1 else 0",
    _PICTURE | {"side": "camera.data.ortho_scale"},
)
_UNITS = ("0.001 / metres", {"metres": "unit_settings.scale_length"})
