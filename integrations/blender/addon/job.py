# SPDX-License-Identifier: GPL-3.0-or-later
"""One run of loomlight: a process that is asked from time to time whether it is done."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import tempfile
from pathlib import Path
from typing import Any

# The form of the folder of maps that material.py reads.
FORMAT = 3
_MAX_WORDS = 1 << 16


class JobError(Exception):
    """loomlight did not make the maps; the message is one sentence."""


class Job:
    """A process that writes the folder of maps of a fabric.

    Attributes:
        folder: temporary; `close` removes it.
    """

    def __init__(self, command: list[str], text: str) -> None:
        """Starts `command` for the fabric file `text`.

        Raises:
            JobError: the process cannot be started.
        """
        self.folder = Path(tempfile.mkdtemp(prefix="loomlight-"))
        fabric = self.folder / "fabric.toml"
        fabric.write_text(text, encoding="utf-8")
        self._log = self.folder / "log.txt"
        # Blender's own Python must not be found by another one.
        environment = {key: value for key, value in os.environ.items() if not key.startswith("PYTHON")}
        words = [*command, "export", str(fabric), "--to", "blender", "-o", str(self.folder / "cloth")]
        try:
            with self._log.open("wb") as log:
                self._process = subprocess.Popen(
                    words,
                    stdin=subprocess.DEVNULL,
                    stdout=subprocess.DEVNULL,
                    stderr=log,
                    env=environment | {"NO_COLOR": "1", "COLUMNS": "10000"},
                )
        except OSError as error:
            shutil.rmtree(self.folder, ignore_errors=True)
            raise JobError(f"{command[0]} does not start: {error.strerror or error}.") from error

    def is_done(self) -> bool:
        """Whether the process has ended."""
        return self._process.poll() is not None

    def wait(self) -> None:
        """Waits for the end; for scripts, which have no window that would stand still."""
        self._process.wait()

    def result(self) -> tuple[Path, dict[str, Any]]:
        """The folder of maps and its manifest, of a process that has ended.

        Raises:
            JobError: it failed, or wrote what this add-on cannot read.
        """
        if self._process.returncode != 0:
            raise JobError(self._sentence())
        return self.folder / "cloth", read_manifest(self.folder / "cloth")

    def _sentence(self) -> str:
        """What the process said of its failure."""
        log = self._log.read_bytes()[-_MAX_WORDS:].decode("utf-8", "replace")
        lines = [line.strip() for line in log.splitlines() if line.strip()]
        if any('--to "blender" is unknown' in line for line in lines):
            return "This loomlight is too old for the add-on: pip install --upgrade loomlight."
        said = [line for line in lines if re.match(r"(loomlight: |[Ee]rror)", line)] or lines
        sentence = re.sub(r"^(loomlight: |[Ee]rror: )+", "", said[-1]) if said else "loomlight said nothing."
        return sentence.replace(str(self.folder / "fabric.toml"), "The fabric")

    def close(self) -> None:
        """Ends the process if it runs, and removes the folder."""
        if not self.is_done():
            self._process.terminate()
            try:
                self._process.wait(5)
            except subprocess.TimeoutExpired:
                self._process.kill()
        shutil.rmtree(self.folder, ignore_errors=True)


def read_manifest(folder: Path) -> dict[str, Any]:
    """The manifest of a folder of maps.

    Raises:
        JobError: there is none, or of another form.
    """
    try:
        manifest = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))
        form = manifest["format"]
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise JobError("loomlight wrote no maps that the add-on can read: install both anew.") from error
    if form != FORMAT:
        older = "add-on" if form > FORMAT else "loomlight"
        raise JobError(f"The {older} is too old for the other: install both from one version.")
    return manifest
