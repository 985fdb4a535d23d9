#!/usr/bin/env bash
# Makes the virtual environment and sees to LLVM and a software Vulkan driver; called by make, safe to call again.
set -euo pipefail
python=$1 venv=$2

as_root() { if [ "$(id -u)" = 0 ]; then "$@"; else sudo -n "$@"; fi; }
may_install() { command -v apt-get >/dev/null && { [ "$(id -u)" = 0 ] || sudo -n true 2>/dev/null; }; }
apt_install() { # one name at a time: whichever the distribution has
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq "$1" >/dev/null 2>&1
}

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
"$venv/bin/python" -m pip install --quiet --disable-pip-version-check -c constraints.txt -e '.[dev]'

if ! "$venv/bin/python" -m loomlight.core.llvm >/dev/null 2>&1; then
  if may_install; then
    as_root apt-get update -qq || true
    apt_install libllvm19 || apt_install libllvm18 || apt_install libllvm17t64 || true
  fi
fi
"$venv/bin/python" -m loomlight.core.llvm

# What the tests of real-time rendering need: a software Vulkan driver, and validators of shaders.
if may_install && ! { ls /usr/share/vulkan/icd.d/lvp_icd.*json && command -v glslangValidator && command -v spirv-val && command -v g++; } >/dev/null 2>&1; then
  as_root apt-get update -qq || true
  for package in libvulkan1 mesa-vulkan-drivers glslang-tools spirv-tools g++; do apt_install "$package" || true; done
fi

# Khronos' validator of glTF files, for a test that is left out without it.
if command -v npm >/dev/null 2>&1 && [ ! -d "$venv/node_modules/gltf-validator" ]; then
  npm install --silent --no-fund --no-audit --prefix "$venv" gltf-validator@2.0.0-dev.3.10 >/dev/null 2>&1 || true
fi
