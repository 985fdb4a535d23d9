"""Generated files of the web client are in step with Python.

Covers: realtime/web_constants.py, realtime/web_fabric.py
"""

from loomlight.realtime.web_constants import web_files


def test_generated_files_are_in_step() -> None:
    for path, text in web_files().items():
        assert path.read_text(encoding="utf-8") == text, (
            f"{path.name}: python -m loomlight.realtime.build --web"
        )
