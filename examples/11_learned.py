"""Any surface that repeats: a network learns a height field. Needs loomlight[train], and a minute."""

import os
from pathlib import Path

import loomlight

relief = loomlight.load(Path(__file__).parent / "leather" / "leather.toml")
# So few steps show how it goes; leave them out for a picture worth looking at.
few = {"steps": int(os.environ.get("STEPS", "200")), "resolution": 16}
model = loomlight.bake(relief, "neumip", **few, report=lambda done, total: print(f"{done}/{total}", end="\r"))
loomlight.save(model, "leather.loom")
loomlight.save(loomlight.render("leather.loom", "sphere", size=(120, 90), spp=4), "leather.png")
