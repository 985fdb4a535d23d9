# SPDX-License-Identifier: GPL-3.0-or-later
"""A node tree that is built by calls: a formula is written as one, and each call makes its node."""

from __future__ import annotations

import math
from typing import Any

import bpy

Socket = bpy.types.NodeSocket
Value = Socket | float | tuple[float, float, float]
# Steps between columns and rows of nodes that are laid out.
_COLUMN, _ROW, _ROWS = 240, 190, 12


class NodeTree:
    """A node group and its nodes."""

    def __init__(self, tree: bpy.types.NodeTree) -> None:
        self._tree = tree
        self._inputs: bpy.types.Node | None = None
        self._outputs: bpy.types.Node | None = None

    # ----------------------------------------------------------------------------------- the group's sockets

    def socket(
        self,
        name: str,
        kind: str,
        default: Any = None,
        low: float | None = None,
        high: float | None = None,
        *,
        is_input: bool = True,
    ) -> None:
        """Adds a socket to the group's outside."""
        made = self._tree.interface.new_socket(
            name, in_out="INPUT" if is_input else "OUTPUT", socket_type=kind
        )
        if default is not None:
            made.default_value = default
        if low is not None and high is not None:
            made.min_value, made.max_value = low, high

    def input(self, name: str) -> Socket:
        """What is plugged into a socket of the group."""
        if self._inputs is None:
            self._inputs = self.node("NodeGroupInput")
        return self._inputs.outputs[name]

    def output(self, name: str, value: Socket) -> None:
        """Gives a value out of the group."""
        if self._outputs is None:
            self._outputs = self.node("NodeGroupOutput")
        self.link(value, self._outputs.inputs[name])

    # ------------------------------------------------------------------------------------------------- nodes

    def node(self, kind: str, **properties: Any) -> bpy.types.Node:
        """A node with its properties."""
        made = self._tree.nodes.new(kind)
        for name, value in properties.items():
            setattr(made, name, value)
        return made

    def link(self, value: Value, to: Socket) -> None:
        """Plugs a value in: a socket, or a constant."""
        if isinstance(value, Socket):
            self._tree.links.new(value, to)
        else:
            to.default_value = value

    def feed(self, node: bpy.types.Node, **values: Value) -> None:
        """Plugs values into sockets of a node by their names."""
        for name, value in values.items():
            self.link(value, node.inputs[name])

    def math(self, operation: str, *values: Value) -> Socket:
        """A number."""
        made = self.node("ShaderNodeMath", operation=operation)
        for value, to in zip(values, made.inputs, strict=False):
            self.link(value, to)
        return made.outputs[0]

    def vector(self, operation: str, *values: Value) -> Socket:
        """Three numbers."""
        made = self.node("ShaderNodeVectorMath", operation=operation)
        for value, to in zip(values, made.inputs, strict=False):
            self.link(value, to)
        return made.outputs[0]

    def mix(self, factor: Value, one: Value, other: Value) -> Socket:
        """`one` where the factor is 0, `other` where it is 1; three numbers each."""
        made = self.node("ShaderNodeMix", data_type="VECTOR")
        named = {socket.identifier: socket for socket in made.inputs}
        for name, value in {"Factor_Float": factor, "A_Vector": one, "B_Vector": other}.items():
            self.link(value, named[name])
        return next(socket for socket in made.outputs if socket.identifier == "Result_Vector")

    def mix_number(self, factor: Value, one: Value, other: Value) -> Socket:
        """`one` where the factor is 0, `other` where it is 1."""
        made = self.node("ShaderNodeMix", data_type="FLOAT")
        named = {socket.identifier: socket for socket in made.inputs}
        for name, value in {"Factor_Float": factor, "A_Float": one, "B_Float": other}.items():
            self.link(value, named[name])
        return next(socket for socket in made.outputs if socket.identifier == "Result_Float")

    def dot(self, one: Value, other: Value) -> Socket:
        """The dot product of two vectors."""
        made = self.node("ShaderNodeVectorMath", operation="DOT_PRODUCT")
        for value, to in zip((one, other), made.inputs, strict=False):
            self.link(value, to)
        return made.outputs["Value"]

    def colour(self, rgb: list[float]) -> Socket:
        """A constant colour, linear."""
        made = self.node("ShaderNodeCombineXYZ")
        for value, to in zip(rgb, made.inputs, strict=True):
            to.default_value = float(value)
        return made.outputs[0]

    def combine(self, *values: Value) -> Socket:
        """Three numbers as a vector."""
        made = self.node("ShaderNodeCombineXYZ")
        for value, to in zip(values, made.inputs, strict=True):
            self.link(value, to)
        return made.outputs[0]

    def separate(self, value: Socket) -> list[Socket]:
        """The three numbers of a vector."""
        made = self.node("ShaderNodeSeparateXYZ")
        self.link(value, made.inputs[0])
        return list(made.outputs)

    def add(self, one: bpy.types.Node | Socket, other: bpy.types.Node | Socket) -> Socket:
        """The sum of two shaders."""
        made = self.node("ShaderNodeAddShader")
        for part, to in zip((one, other), made.inputs, strict=True):
            self.link(part if isinstance(part, Socket) else part.outputs[0], to)
        return made.outputs[0]

    def mix_shader(
        self, factor: Value, one: bpy.types.Node | Socket, other: bpy.types.Node | Socket
    ) -> Socket:
        """`one` where the factor is 0, `other` where it is 1, of shaders."""
        made = self.node("ShaderNodeMixShader")
        self.link(factor, made.inputs[0])
        for part, to in zip((one, other), list(made.inputs)[1:], strict=True):
            self.link(part if isinstance(part, Socket) else part.outputs[0], to)
        return made.outputs[0]

    def smoothstep(self, logarithm: Socket, low: float, high: float) -> Socket:
        """0 below `low`, 1 above `high`, of a number whose natural logarithm is given."""
        made = self.node("ShaderNodeMapRange", interpolation_type="SMOOTHSTEP")
        self.feed(made, **{"Value": logarithm, "From Min": math.log(low), "From Max": math.log(high)})
        return made.outputs[0]

    def driven(self, name: str, driver: tuple[str, dict[str, str]]) -> Socket:
        """A number that follows properties of the active scene: an expression, and its names."""
        expression, names = driver
        made = self.node("ShaderNodeValue", name=name, label=name)
        curve = self._tree.driver_add(f'nodes["{name}"].outputs[0].default_value')
        curve.driver.type = "SCRIPTED"
        for variable, path in names.items():
            added = curve.driver.variables.new()
            added.name, added.type = variable, "CONTEXT_PROP"
            added.targets[0].context_property = "ACTIVE_SCENE"
            added.targets[0].data_path = path
        curve.driver.expression = expression
        return made.outputs[0]

    def arrange(self) -> None:
        """Lays the nodes out in columns, in the order in which they were made."""
        for number, node in enumerate(self._tree.nodes):
            node.location = (_COLUMN * (number // _ROWS), -_ROW * (number % _ROWS))
