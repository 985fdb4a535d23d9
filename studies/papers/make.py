"""`make`: makes a figure of a paper and writes it with every number and its provenance."""

from __future__ import annotations

import json
import os
import re
from pathlib import Path
from typing import Any

from loomlight.core.errors import InputError
from loomlight.core.files import discarding_empty
from loomlight.core.images import write_pixels
from loomlight.core.provenance import provenance
from loomlight.evaluation.compare import prepared_folder
from loomlight.evaluation.table import write_json
from loomlight.models.registry import require_model_name
from studies.papers.catalogue import find_item
from studies.papers.figure import Evidence, Item
from studies.papers.setting import NEURAL, Setting

_SCHEMA = 1
_KIND = "loomlight reproduce"  # the name of the command when the schema was made


def make(
    name: str,
    folder: str | os.PathLike[str],
    setting: Setting | None = None,
    command: str = "papers",
) -> Evidence:
    """Makes a figure and writes `folder`/NAME.png, its single pictures in pictures/, and table.json.

    What table.json says of other figures stays; the folder is made where there is none.

    Args:
        name: one of `CATALOGUE`, such as "chen2024/fig4".
        setting: sizes, samples and weights.
        command: recorded in table.json.

    Raises:
        InputError: an unknown name or model, weights that cannot be used, or a folder that cannot be written.
    """
    item = find_item(name)
    chosen = setting or Setting(samples=item.samples, model=item.model or NEURAL)
    if item.model is None:
        chosen.network()
    else:
        require_model_name(chosen.model)
    with discarding_empty(folder):
        target = prepared_folder(folder)
        earlier = _earlier(target / "table.json")
        evidence = item.make(chosen)
        for title, pixels in evidence.pictures.items():
            write_pixels(target / "pictures" / f"{item.stem}-{_file_name(title)}.png", pixels)
        write_pixels(target / f"{item.stem}.png", evidence.sheet)
        entry = _entry(item, evidence, chosen, command)
        content = {"schema": _SCHEMA, "kind": _KIND, "figures": {**earlier, item.name: entry}}
        write_json(target / "table.json", content)
        return evidence


def _entry(item: Item, evidence: Evidence, setting: Setting, command: str) -> dict[str, Any]:
    entry = {
        "shows": item.shows,
        **provenance(command, Path(__file__).parent),
        "size": list(setting.size),
        "reference_samples": setting.samples,
    }
    if item.model is None:
        network = setting.network()
        entry["weights"] = {
            "file": "the package's" if setting.weights is None else setting.weights.name,
            "sha256": network.sha256,
            "trained": network.trained,
        }
    else:
        environment = setting.environment
        entry["model"] = setting.model
        entry["environment"] = "the studio" if environment is None else environment.name
    return {**entry, "tables": [table.to_dict() for table in evidence.tables]}


def _earlier(path: Path) -> dict[str, Any]:
    """The entries of figures made before."""
    if not path.exists():
        return {}
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        content = None
    if not isinstance(content, dict) or content.get("kind") != _KIND or content.get("schema") != _SCHEMA:
        raise InputError(f"{path} was not written by `python -m studies.papers`; give another folder.")
    return dict(content["figures"])


def _file_name(text: str) -> str:
    return re.sub(r"[^a-z0-9]+", "-", text.lower().replace("×", "x").replace("/", "-")).strip("-")
