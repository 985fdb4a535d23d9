"""Your own mesh: clothed at true scale, lit by a panorama, the weave turned on the bias."""

from pathlib import Path

import loomlight
from loomlight.mitsuba import Placement

EXAMPLES = Path(__file__).parent

picture = loomlight.render(
    EXAMPLES / "denim.toml",
    mesh=EXAMPLES / "cushion.obj",  # or .ply, .gltf, .glb; it needs uv
    environment=EXAMPLES / "room.exr",
    placement=Placement(turn=45.0),  # degrees
    size=(320, 240),
    spp=4,
)
loomlight.save(picture, "cushion.png")
