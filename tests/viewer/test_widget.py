"""The widget's Python half, as its frame asks it; without a notebook, but with the real widget.

Covers: viewer/widget.py, viewer/notebook.py, viewer/answers.py
"""

from __future__ import annotations

import gzip
import json
import sys
from typing import Any

import pytest

import loomlight
from loomlight.core.errors import InputError, LoomlightError, MissingDependencyError
from loomlight.fabric.read import load_fabric
from loomlight.viewer.client import client_folder
from loomlight.viewer.messages import fabric_json

pytest.importorskip("anywidget", reason="anywidget is not installed")


class Asked:
    """A widget, and what it sends."""

    def __init__(self, fabric: str, monkeypatch: pytest.MonkeyPatch) -> None:
        try:
            client_folder()
        except LoomlightError as error:
            pytest.skip(str(error))
        self.widget = loomlight.view(fabric)
        self.sent: list[tuple[dict[str, Any], list[bytes]]] = []
        monkeypatch.setattr(
            self.widget, "send", lambda content, buffers=None: self.sent.append((content, buffers or []))
        )

    def ask(self, place: str, body: bytes = b"", view: str = "a") -> tuple[int, bytes]:
        self.widget._answer({"view": view, "ask": 7, "place": place}, [memoryview(body)])
        content, buffers = self.sent[-1]
        assert (content["view"], content["answer"]) == (view, 7)
        return content["status"], buffers[0]


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> Asked:
    return Asked("twill 3/1", monkeypatch)


def test_the_page_comes_as_one_file(asked: Asked) -> None:
    status, page = asked.ask("page")
    text = gzip.decompress(page).decode()
    assert status == 200
    assert 'content="frame"' in text
    assert "<script src" not in text


def test_the_session_holds_the_fabric(asked: Asked) -> None:
    session = json.loads(asked.ask("api/session")[1])
    assert session["fabric"]["fields"]["weave"] == "twill 3/1"
    assert session["has_python"]
    assert {entry["picture"] for entry in session["gallery"]} == {None}


def test_an_edit_of_one_view_is_a_fabric_and_goes_to_the_others(asked: Asked) -> None:
    changes: list[Any] = []
    asked.widget.observe(changes.append, "fabric")
    edited = fabric_json(load_fabric("satin 5/2"))
    edited["fields"]["gap"] = 0.3
    assert asked.ask("api/fabric", json.dumps(edited).encode(), view="b")[0] == 200
    assert isinstance(asked.widget.fabric, loomlight.Fabric)
    assert asked.widget.fabric.fields.gap == 0.3
    assert [change["new"] for change in changes] == [asked.widget.fabric]
    pushed, _ = asked.sent[-2]
    assert pushed["by"] == "b"
    assert pushed["fabric"]["fields"]["weave"] == "satin 5/2"


def test_what_python_sets_goes_to_all_views(asked: Asked) -> None:
    asked.widget.fabric = "houndstooth"
    pushed, _ = asked.sent[-1]
    assert pushed["by"] is None
    assert pushed["fabric"]["fields"]["weave"] == "houndstooth"
    with pytest.raises(InputError, match="no-such"):
        asked.widget.fabric = "no-such"
    assert asked.widget.fabric.fields.weave == "houndstooth"


def test_a_fabric_that_cannot_be_is_answered_in_a_sentence(asked: Asked) -> None:
    edited = fabric_json(load_fabric("twill 3/1"))
    edited["fields"]["gap"] = 7
    status, content = asked.ask("api/fabric", json.dumps(edited).encode())
    assert status == 422
    assert "gap" in json.loads(content)["error"]
    assert asked.widget.fabric.fields.gap is None


def test_python_answers_in_place_of_a_server(asked: Asked) -> None:
    fabric = fabric_json(load_fabric("twill 3/1"))
    status, content = asked.ask("api/save", json.dumps(fabric | {"format": "toml"}).encode())
    assert (status, b"twill 3/1" in content) == (200, True)
    status, content = asked.ask("api/wif?name=draft.wif", b"no draft")
    assert (status, "draft.wif" in json.loads(content)["error"]) == (422, True)


def test_absence_of_anywidget_is_one_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "anywidget", None)
    with pytest.raises(MissingDependencyError, match=r"pip install 'loomlight\[notebook\]'"):
        loomlight.view("twill 3/1")
