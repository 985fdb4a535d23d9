"""What the figures show the fabrics on: the pieces of the image test, framed as the paper's figures are."""

from __future__ import annotations

from loomlight.mitsuba import cloth_shapes
from loomlight.mitsuba.measured_scenes import MeasuredShot

_ABOVE = (0.35, 0.55, 1.0)

# Near enough to see the weave, far enough for it to alias.
DRAPE = MeasuredShot((cloth_shapes.drape,), _ABOVE, (-0.6, 0.75, 0.6), yarns=2.5, zoom=2.2)
# Some folds turn towards the light, which stands to the side and behind, and others away from it.
BACKLIT = MeasuredShot((cloth_shapes.curtain,), (0.25, 0.1, 1.0), (-1.0, 0.3, -0.55), yarns=2.5, zoom=1.15)
CLOSE = MeasuredShot((cloth_shapes.drape,), _ABOVE, (-0.6, 0.75, 0.6), yarns=0.15, zoom=3.0)
CYLINDER = MeasuredShot((cloth_shapes.cylinder,), (0.0, 0.0, 1.0), (-0.3, 0.6, 0.8), yarns=2.0, zoom=1.2)
BALL = MeasuredShot((cloth_shapes.sphere,), (0.0, 0.0, 1.0), (-0.45, 0.6, 0.75), yarns=2.0)
