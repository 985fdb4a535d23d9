"""Messages are one printable line, however long the values are that they repeat.

Covers: core/errors.py
"""

from __future__ import annotations

import pytest

from loomlight.core.errors import MAX_MESSAGE, InputError, LoomlightWarning
from loomlight.fabric import fabric_from_text


@pytest.mark.parametrize("kind", [InputError, LoomlightWarning])
def test_long_values_are_shortened_and_control_characters_shown(kind: type[Exception]) -> None:
    said = str(kind(f"file.wif: {'x' * 100_000}\n\x1b[31m is no number: write one."))
    assert len(said) == MAX_MESSAGE
    assert said.isprintable()
    assert said.startswith("file.wif: xxx")
    assert said.endswith("[31m is no number: write one.")
    assert str(kind("short")) == "short"


def test_interreflection_says_what_it_takes() -> None:
    for given, meant in (("7", "true or false"), ("0", "false"), ("1", "true"), ('"off"', "true or false")):
        with pytest.raises(InputError, match=rf"interreflection = {given} cannot be used: write {meant}\."):
            fabric_from_text(f'weave = "plain"\ninterreflection = {given}')
