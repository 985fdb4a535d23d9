"""Settings declared as fields of a dataclass: what they are checked by, and what is read from texts.

Covers: core/sentences.py
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import pytest

from loomlight.core.errors import InputError
from loomlight.core.settings import Settings, declared, default_text, documented, same_setting, setting


@documented
@dataclass(frozen=True, kw_only=True)
class Loom(Settings):
    """A loom."""

    title: ClassVar[str] = "setting of a loom"

    shafts: int = setting(8, "Shafts.", low=2, high=32, stored=True)
    speed: float | None = setting(None, "Picks a second.", low=0.1, otherwise="by hand")
    kind: str = setting("dobby", "What lifts them.", choices=("dobby", "jacquard"))
    warped: bool = setting(False, "Whether there is a warp.")
    reed: tuple[float, float] = setting((0.0, 1.0), "From and to, mm.", low=-9, high=9)
    notes: Mapping[str, Any] = setting(dict, "For people.", expected="a dictionary")


@dataclass(frozen=True, kw_only=True)
class Sampler(Settings):
    shafts: int = same_setting(Loom, "shafts", high=4, default=4)


@pytest.mark.parametrize(
    ("values", "says"),
    [
        ({"shafts": 1}, "shafts = 1 is wrong: give a whole number from 2 to 32."),
        ({"shafts": 2.5}, "shafts = 2.5 is wrong"),
        ({"shafts": True}, "shafts = true is wrong"),
        ({"speed": math.nan}, "speed = nan is wrong: give a number from 0.1."),
        ({"speed": math.inf}, "speed = inf is wrong"),
        ({"kind": "doby"}, 'kind = "doby" does not exist: did you mean dobby?'),
        ({"kind": None}, "kind = None does not exist"),
        ({"warped": 1}, "warped = 1 is wrong: give true or false."),
        ({"reed": (1, 2, 3)}, "reed = (1, 2, 3) is wrong: give"),
        ({"reed": (0, 10)}, "reed = (0, 10) is wrong"),
        ({"reed": 3}, "reed = 3 is wrong"),
        ({"notes": []}, "notes = [] is wrong: give a dictionary."),
        ({"shaft": 4}, '"shaft" is no setting of a loom: did you mean shafts?'),
    ],
)
def test_a_value_that_cannot_be_is_one_sentence(values: dict[str, Any], says: str) -> None:
    with pytest.raises(InputError) as caught:
        Loom.of(values)
    assert says in str(caught.value)


def test_bounds_are_values_and_defaults_are_checked() -> None:
    assert Loom(shafts=2, speed=0.1, reed=[-9, 9]).changed(shafts=32).shafts == 32  # type: ignore[arg-type]
    assert Loom().stored() == {"shafts": 8}
    assert Loom(kind="jacquard", shafts=8).chosen() == {"kind": "jacquard"}


@pytest.mark.parametrize(
    ("name", "text", "value"), [("shafts", "4", 4), ("speed", "1e1", 10.0), ("warped", "true", True)]
)
def test_values_are_read_from_texts(name: str, text: str, value: object) -> None:
    read = declared(Loom)[name].value_of(text)
    assert (read, type(read)) == (value, type(value))
    with pytest.raises(InputError, match=f'{name} = "yes" is wrong'):
        declared(Loom)[name].value_of("yes")


def test_a_declaration_is_used_again_with_changes() -> None:
    assert Sampler().shafts == 4
    with pytest.raises(InputError, match="from 2 to 4"):
        Sampler(shafts=8)
    assert declared(Sampler)["shafts"].help == "Shafts."


def test_declarations_are_documentation() -> None:
    assert "    shafts: Shafts. By default 8.\n" in (Loom.__doc__ or "")
    assert [default_text(each) for each in declared(Loom).values()] == [
        "8",
        "by hand",
        "dobby",
        "false",
        "0,1",
        "",
    ]
