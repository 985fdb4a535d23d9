# SPDX-License-Identifier: GPL-3.0-or-later
"""Woven cloth from weave drafts: a panel that asks loomlight for maps, and makes a material of them.

`loomlight` runs as a process of its own, so that nothing needs to be installed in Blender's Python.
"""

from __future__ import annotations

from . import operators, panels, pictures, preferences, settings

_MODULES = (preferences, settings, operators, panels)


def register() -> None:
    """Adds the panel, its settings and operators."""
    for module in _MODULES:
        module.register()


def unregister() -> None:
    """Takes all of it away again; a process that runs is ended."""
    for module in reversed(_MODULES):
        module.unregister()
    pictures.forget()
