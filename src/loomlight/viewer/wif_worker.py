"""The process that reads drafts for the server; its arguments are those of `limited_worker.serve`."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

from loomlight.viewer.limited_worker import serve


def _read(file: Path, told: Callable[[], list[str]]) -> bytes:
    from loomlight.viewer.messages import draft_json
    from loomlight.weave.load import load_draft

    draft = draft_json(load_draft(file))
    return json.dumps({**draft, "warnings": told()}).encode()


if __name__ == "__main__":
    serve(_read, "draft")
