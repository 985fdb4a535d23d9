"""The page of instructions that stands beside exported shader code."""

from __future__ import annotations

import tomllib
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from loomlight.models.registry import REALTIME_MODELS

_FOLDER = Path(__file__).parent / "languages"


def shader_instructions(
    name: str,
    model: str,
    language: str,
    code: Sequence[str],
    buffers: Sequence[dict[str, Any]],
    repeat_mm: tuple[float, float],
) -> str:
    """The text of README.md.

    Args:
        code: names of the files of code.
        buffers: as the manifest describes them.
        repeat_mm: size of the draft's repeat.
    """
    with (_FOLDER / "languages.toml").open("rb") as file:
        of_language = tomllib.load(file)[language]
    rows = [
        f"| `{b['file']}` | {of_language['binding'].format(n=b['binding'])} | {_element(b)} | {b['bytes']} |"
        for b in buffers
    ]
    width, height = repeat_mm
    use = of_language["use"].format(model=model)
    files = ", ".join(f"`{file}`" for file in code)
    return (
        (_FOLDER / "instructions.md")
        .read_text(encoding="utf-8")
        .format(
            name=name,
            model=model,
            use=use,
            files=files,
            signature=of_language["signature"],
            computes=REALTIME_MODELS[model].computes,
            width=width,
            height=height,
            rows="\n".join(rows),
            cost=REALTIME_MODELS[model].cost,
        )
    )


def _element(buffer: dict[str, Any]) -> str:
    kind = buffer["element"]
    return "32-bit words" if kind == "uint" else f"`{kind}`, {buffer['stride']} bytes"
