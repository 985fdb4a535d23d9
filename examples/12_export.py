"""Other programs: a glTF file with textures, and shader code with the tables that it reads."""

from pathlib import Path

import loomlight

fabric = Path(__file__).parent / "linen.toml"
for target in ("gltf", "wgsl"):
    folder = loomlight.export(fabric, target, f"linen-{target}")
    print(target, sorted(file.name for file in folder.rglob("*") if file.is_file()))
