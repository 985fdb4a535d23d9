"""A fabric: a draft with yarns, written in TOML, whose fields are checked one by one."""

import loomlight

fabric = loomlight.fabric_from_text(
    """
    weave = "twill 2/2"
    ends_per_cm = 24
    picks_per_cm = 22
    yarn = "wool"           # also cotton, linen, silk, viscose …: docs/yarns.md

    [warp]
    color = "8 #2b2b2b, 8 #b9a988"

    [weft]
    color = "#b9a988"
    """
)
width, height = fabric.repeat_mm
print(f"one repeat is {width:.2f} by {height:.2f} mm")

try:
    loomlight.fabric_from_text('weave = "twill 2/2"\ngap = 2')
except loomlight.InputError as error:
    print("refused:", error)

loomlight.save(fabric, "stripes.toml")
