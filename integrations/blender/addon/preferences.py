# SPDX-License-Identifier: GPL-3.0-or-later
"""Where loomlight is: a preference of the add-on, else the command that the system finds."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

import bpy


# Blender makes properties of annotations that are calls, which no type checker takes for types.
class NotFoundError(Exception):
    """There is no loomlight; the message says what to do."""


class LoomlightPreferences(bpy.types.AddonPreferences):
    """The add-on's preferences."""

    bl_idname = __package__

    command: bpy.props.StringProperty(  # type: ignore[valid-type]
        name="loomlight",
        description="The program loomlight, or the Python that has it; empty: the one on the path",
        subtype="FILE_PATH",
    )

    def draw(self, context: bpy.types.Context) -> None:
        """Draws the one field, and what is found."""
        self.layout.prop(self, "command")
        try:
            self.layout.label(text=f"Found: {' '.join(command())}", icon="CHECKMARK")
        except NotFoundError as error:
            self.layout.label(text=str(error), icon="ERROR")


def chosen_command() -> str:
    """The path in the preferences; empty where there is none."""
    addon = bpy.context.preferences.addons.get(__package__)
    return bpy.path.abspath(addon.preferences.command).strip() if addon is not None else ""


def command() -> list[str]:
    """The words that start loomlight.

    Raises:
        NotFoundError: nothing is there.
    """
    chosen = chosen_command()
    if not chosen:
        found = shutil.which("loomlight")
        if found is None:
            raise NotFoundError(
                "loomlight is not found: pip install loomlight, and name it in the add-on's preferences."
            )
        return [found]
    if not (os.path.isfile(chosen) and os.access(chosen, os.X_OK)):
        raise NotFoundError(f"{chosen} is no program: name loomlight in the add-on's preferences.")
    return [chosen, "-m", "loomlight"] if Path(chosen).name.lower().startswith("python") else [chosen]


def register() -> None:
    """Registers the preferences."""
    bpy.utils.register_class(LoomlightPreferences)


def unregister() -> None:
    """Takes them away."""
    bpy.utils.unregister_class(LoomlightPreferences)
