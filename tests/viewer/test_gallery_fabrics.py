"""Each fabric of the gallery says how it is woven in reality, and has its picture."""

from __future__ import annotations

import pytest
from PIL import Image

from loomlight.fabric.facts import cloth_facts
from loomlight.fabric.read import load_fabric
from loomlight.viewer.session import gallery_files, gallery_pictures


def test_there_are_twenty_eight() -> None:
    assert len(gallery_files()) == 28


@pytest.mark.parametrize("name", sorted(gallery_files()))
def test_a_fabric_has_yarn_count_sett_and_picture(name: str) -> None:
    fabric = load_fabric(gallery_files()[name])
    fields = fabric.fields
    for table in (fields.warp, fields.weft):
        assert table.yarn or fields.yarn
        assert table.count
    assert fields.ends_per_cm
    assert fields.picks_per_cm
    # From organza to heavy blankets: a count in the wrong unit is off by a factor of ten.
    assert 20 <= cloth_facts(fabric).weight <= 600
    with Image.open(gallery_pictures() / f"{name}.webp") as picture:
        assert picture.size == (320, 320)
