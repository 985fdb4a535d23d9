"""Validators of other people's: Khronos' of glTF files, which scripts/setup.sh installs."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.limits import HANG

_VALIDATE = """
const validator = require('gltf-validator');
const content = new Uint8Array(require('fs').readFileSync(process.argv[1]));
validator.validateBytes(content).then(report => console.log(JSON.stringify(report.issues)));
"""


def khronos_issues(file: Path) -> dict[str, Any]:
    """Numbers of errors and warnings of a .glb file, and messages; skips without the validator."""
    if shutil.which("node") is None:
        pytest.skip("node is not installed")
    search = os.environ | {"NODE_PATH": str(Path(sys.prefix) / "node_modules")}
    done = subprocess.run(
        ["node", "-e", _VALIDATE, str(file)], capture_output=True, text=True, timeout=HANG, env=search
    )
    if "Cannot find module" in done.stderr:
        pytest.skip("npm install gltf-validator is missing")
    issues: dict[str, Any] = json.loads(done.stdout)
    return issues
