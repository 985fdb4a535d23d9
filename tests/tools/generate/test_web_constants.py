"""Generated files of the web client are in step with Python.

Covers: tools/generate/shaders/web_fabric.py, tools/generate/shaders/web_messages.py
"""

from tools.generate.shaders.web_constants import web_files


def test_generated_files_are_in_step() -> None:
    for path, text in web_files().items():
        assert path.read_text(encoding="utf-8") == text, (
            f"{path.name}: python -m tools.generate.shaders --web"
        )
