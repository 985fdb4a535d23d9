"""What the base installation imports: optional packages are imported where they are used."""

from __future__ import annotations

import json
import subprocess
import sys

from tests.limits import HANG

# Modules that need a package of an extra when they are loaded, by that package; a folder's name means all in
# it. Whoever imports one of them asks for the package first, by `import_extra` or by `model_class`.
NEED = {
    "llvmlite": [
        "core.simd",
        "exporters.networks",
        "models.networks",
        "models.neural.decoder",
        "models.neural.decoder_kernel",
        "models.neural.encoding",
        "models.neural.latent_table",
        "models.neural.model",
        "models.neural.proposal",
        "models.texture.latent",
        "models.texture.model",
        "models.texture.neumip",
    ],
    "torch": [
        "models.texture.latent_training",
        "models.texture.neumip_training",
        "models.texture.training",
        "training.direction_sampler",
        "training.layers",
        "training.loop",
        "training.parallel",
        "training.soap",
    ],
    "anyio": ["viewer.app", "viewer.photo_capture"],
    "anywidget": ["viewer.widget"],
}

# Loads every module of the package where nothing can be imported but the standard library and what the base
# installation requires; prints which modules could not be, by what they lack.
_PROGRAM = """
import json, pkgutil, re, sys
from importlib import import_module
from importlib.metadata import PackageNotFoundError, packages_distributions, requires

def plain(name):
    return re.sub("[-_.]+", "-", name).lower()

base, waiting = set(), ["loomlight"]
while waiting:
    name = plain(waiting.pop())
    if name in base:
        continue
    base.add(name)
    try:
        lines = requires(name) or ()
    except PackageNotFoundError:  # of another system
        continue
    waiting += [re.match(r"[\\w.-]+", line)[0] for line in lines if "extra ==" not in line]
provided = packages_distributions()
usable = {top for top, names in provided.items() if base & set(map(plain, names))}

class OnlyTheBase:
    def find_spec(self, name, path=None, target=None):
        top = name.partition(".")[0]
        if top in provided and top not in usable:
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)

sys.meta_path.insert(0, OnlyTheBase())
import loomlight

lacking = {}
for module in pkgutil.walk_packages(loomlight.__path__, "loomlight.", onerror=lambda name: None):
    if not module.name.endswith("__main__"):
        try:
            import_module(module.name)
        except ModuleNotFoundError as error:
            top = error.name.partition(".")[0]
            lacking.setdefault(top, []).append(module.name.removeprefix("loomlight."))
print(json.dumps(lacking))
"""


def test_only_these_modules_need_an_extra() -> None:
    done = subprocess.run([sys.executable, "-c", _PROGRAM], capture_output=True, text=True, timeout=HANG)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout) == NEED
