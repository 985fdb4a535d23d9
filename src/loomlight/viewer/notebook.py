"""`view`: a fabric as a widget of a notebook."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from loomlight.core.extras import import_extra
from loomlight.fabric.fabric import Fabric

if TYPE_CHECKING:
    from loomlight.viewer.widget import ClothWidget


def view(fabric: Fabric | str | os.PathLike[str] | None = None, *, height: int = 620) -> ClothWidget:
    """The live editor of a fabric as a widget of Jupyter, whose `fabric` is the one that the page shows.

    Args:
        fabric: or a path or name, see `fabric_of_path`; None for a fabric of the gallery.
        height: of the widget, pixels.

    Raises:
        InputError: no such fabric.
        MissingDependencyError: anywidget is missing, or the page is not built and cannot be.
    """
    import_extra("anywidget", "notebook", "A widget")
    from loomlight.viewer.widget import ClothWidget

    return ClothWidget(fabric, height)
