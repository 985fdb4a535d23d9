"""The verbs of Python, `bake`, `save` and `load`, and what a material resolves to.

Covers: core/images.py, models/material_spec.py
"""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import loomlight
from loomlight.core.images import Picture, read_linear
from loomlight.models.interface import Model
from loomlight.models.material_spec import resolve
from loomlight.models.point import SampledModel


def test_what_is_saved_is_loaded(tmp_path: Path) -> None:
    model = loomlight.bake("twill 3/1", "samples", points=5)
    loomlight.save(model, tmp_path / "x.loom")
    again = loomlight.load(tmp_path / "x.loom")
    assert isinstance(again, SampledModel)
    assert again.options.points == 5

    loomlight.save(again.source, tmp_path / "x.toml")
    fabric = loomlight.load(tmp_path / "x.toml")
    assert isinstance(fabric, loomlight.Fabric)
    loomlight.save(fabric.draft, tmp_path / "x.wif")
    for same in (loomlight.load(tmp_path / "x.wif"), loomlight.load("twill 3/1")):
        assert isinstance(same, loomlight.Fabric)
        assert np.array_equal(same.draft.drawdown, fabric.draft.drawdown)

    picture = np.full((2, 3, 3), 0.5, np.float32)
    loomlight.save(picture, tmp_path / "x.exr")
    assert np.array_equal(read_linear(tmp_path / "x.exr"), picture)


def test_a_suffix_that_does_not_go_with_what_is_saved(tmp_path: Path) -> None:
    fabric = loomlight.load("plain")
    for what, name, right in (
        (fabric, "x.wif", "a fabric is written as .toml."),
        (fabric.draft, "x.toml", "a draft is written as .wif."),
        (loomlight.bake(fabric, "point"), "x.toml", "a model is written as .loom."),
        (np.zeros((1, 1, 3)), "x.webp", "a picture is written as .png or .jpg or .jpeg or .exr."),
        (np.zeros((4, 4)), "x.exr", r"a picture is \[height, width, 1, 3 or 4\], not \[4, 4\]"),
        ([1.0], "x.png", "a list is no model, fabric, draft, map or picture"),
    ):
        with pytest.raises(loomlight.InputError, match=right):
            loomlight.save(what, tmp_path / name)  # type: ignore[arg-type]  # what is refused
    assert list(tmp_path.iterdir()) == []


def test_a_fabric_file_is_saved_elsewhere_than_its_draft(tmp_path: Path) -> None:
    (tmp_path / "there").mkdir()
    draft = loomlight.named_weave("herringbone 2/2 8")
    loomlight.save(draft, tmp_path / "own.wif")
    fabric = loomlight.load(tmp_path / "own.wif")
    assert isinstance(fabric, loomlight.Fabric)
    loomlight.save(fabric, tmp_path / "there" / "own.toml")
    again = loomlight.load(tmp_path / "there" / "own.toml")
    assert isinstance(again, loomlight.Fabric)
    assert np.array_equal(again.draft.drawdown, draft.drawdown)

    loomlight.save(loomlight.bake(fabric, "point"), tmp_path / "own.loom")
    (tmp_path / "own.wif").unlink()
    inside = loomlight.load(tmp_path / "own.loom")
    assert isinstance(inside, Model)
    with pytest.raises(
        loomlight.InputError, match=r"is not in a file of its own: save fabric\.draft as \.wif"
    ):
        loomlight.save(inside.source, tmp_path / "again.toml")  # type: ignore[arg-type]  # its source is a fabric
    assert not (tmp_path / "again.toml").exists()


def test_an_unknown_keyword_names_the_nearest() -> None:
    with pytest.raises(loomlight.InputError, match=r'"grups" is no option of lobes: did you mean groups\?'):
        loomlight.bake("plain", "lobes", grups=4)
    with pytest.raises(loomlight.InputError, match=r'"sp" is no setting of a picture: did you mean spp\?'):
        loomlight.render("plain", sp=4)
    with pytest.raises(loomlight.InputError, match=r'"lobs" does not exist: did you mean lobes\?'):
        loomlight.bake("plain", "lobs")


def test_a_material_resolves_once_to_source_and_model(tmp_path: Path) -> None:
    loomlight.save(loomlight.bake("plain", "samples", points=5), tmp_path / "x.loom")
    held = resolve(tmp_path / "x.loom")
    assert (held.model_name, held.replaces) == ("samples", "")
    assert held.model() is not held.model()
    other = resolve(tmp_path / "x.loom", "point")
    assert (other.model_name, other.replaces, other.held) == ("point", "samples", None)
    assert resolve(held) is held

    model = held.model()
    assert resolve(model).model() is model
    assert resolve(model, "samples", {"points": 7}).model().options.points == 7  # type: ignore[attr-defined]
    assert isinstance(resolve(loomlight.load("plain")).model(), Model)


def test_fabrics_drafts_and_pictures_show_themselves() -> None:
    fabric = loomlight.load("twill 2/2")
    assert isinstance(fabric, loomlight.Fabric)
    shown = Image.open(io.BytesIO(fabric._repr_png_() or b""))
    assert shown.size[0] >= 4 * 8
    assert len(shown.convert("RGB").getcolors() or []) >= 2
    picture = np.full((2, 3, 3), 0.5, np.float32).view(Picture)
    png = picture._repr_png_()
    assert png is not None
    assert Image.open(io.BytesIO(png)).size == (3, 2)
    assert picture[0]._repr_png_() is None
