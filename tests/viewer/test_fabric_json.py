"""Fabrics there and back as JSON; no path among their fields is read."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.fabric import load_fabric
from loomlight.viewer.messages import fabric_json, fabric_of_json

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


@pytest.mark.parametrize("name", ["wool-houndstooth", "linen"])
def test_fabrics_come_back_as_they_were(name: str) -> None:
    fabric = load_fabric(EXAMPLES / f"{name}.toml")
    back = fabric_of_json(json.loads(json.dumps(fabric_json(fabric))))
    assert back.fields == fabric.fields
    np.testing.assert_array_equal(back.draft.drawdown, fabric.draft.drawdown)
    np.testing.assert_array_equal(
        back.appearance().warp.diffuse_reflect, fabric.appearance().warp.diffuse_reflect
    )


def test_no_path_is_read() -> None:
    fabric = fabric_json(load_fabric("twill 3/1"))
    fabric["fields"] = {"draft": "/etc/passwd"}
    assert fabric_of_json(fabric).draft.ends == 4


def test_faults_name_the_field() -> None:
    fabric = fabric_json(load_fabric("twill 3/1"))
    fabric["fields"]["warp"] = {"roughness": 7}
    with pytest.raises(InputError, match=r"warp\.roughness = 7"):
        fabric_of_json(fabric)
