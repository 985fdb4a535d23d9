"""examples/materials is what its generator makes."""

from __future__ import annotations

from pathlib import Path

from examples.makers.materials import main
from studies.papers.zeltner2024.layered_materials import LAYERED

EXAMPLES = Path(__file__).resolve().parents[2] / "examples" / "materials"


def test_the_examples_are_the_generators(tmp_path: Path) -> None:
    main(tmp_path)
    for name in LAYERED:
        made, kept = ({file.name for file in (folder / name).iterdir()} for folder in (tmp_path, EXAMPLES))
        assert made == kept
        for file in made:
            # Pixels of PNGs differ in the last bit between versions of FFTs: their texts do not.
            if not file.endswith(".png"):
                assert (tmp_path / name / file).read_text() == (EXAMPLES / name / file).read_text()
