"""Draws a sphere of the exported cloth: `pip install wgpu numpy`, then `python sample.py [SIZE]` writes
sample.png.

It needs no loomlight: cloth.wgsl, the buffers and the manifest are everything.
"""

from __future__ import annotations

import json
import os
import struct
import sys
import zlib
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

FOLDER = Path(__file__).resolve().parent


def draw(size: int, radius: float = 12.0, distance: float = 45.0) -> NDArray[np.float32]:
    """Linear RGB [size, size, 3] of a sphere; radius and distance from the eye in millimetres."""
    # Drivers look for a display otherwise, and print complaints where there is none.
    os.environ.setdefault("NODEVICE_SELECT", "1")
    import wgpu
    from wgpu.backends.wgpu_native.extras import set_instance_extras

    with suppress(RuntimeError):  # the program has used wgpu before
        set_instance_extras(backends=["Vulkan", "Metal", "DX12"])
    adapters = [a for a in wgpu.gpu.enumerate_adapters_sync() if a.info["backend_type"] != "OpenGL"]
    device = min(adapters, key=lambda a: a.info["adapter_type"] == "CPU").request_device_sync()
    code = "\n".join((FOLDER / name).read_text(encoding="utf-8") for name in ("cloth.wgsl", "sample.wgsl"))
    module = device.create_shader_module(code=code)
    pipeline = device.create_compute_pipeline(
        layout="auto", compute={"module": module, "entry_point": "draw"}
    )
    storage = wgpu.BufferUsage.STORAGE | wgpu.BufferUsage.COPY_SRC
    manifest = json.loads((FOLDER / "manifest.json").read_text(encoding="utf-8"))
    tables = {
        entry["binding"]: device.create_buffer_with_data(
            data=(FOLDER / entry["file"]).read_bytes(), usage=storage
        )
        for entry in manifest["buffers"]
    }
    view = struct.pack("<IIff", size, size, radius, distance)
    picture = device.create_buffer_with_data(data=view, usage=wgpu.BufferUsage.UNIFORM)
    pixels = device.create_buffer(size=16 * size * size, usage=storage)
    encoder = device.create_command_encoder()
    compute = encoder.begin_compute_pass()
    compute.set_pipeline(pipeline)
    compute.set_bind_group(0, _group(device, pipeline, 0, tables))
    compute.set_bind_group(1, _group(device, pipeline, 1, {0: picture, 1: pixels}))
    compute.dispatch_workgroups(-(-size // 8), -(-size // 8))
    compute.end()
    device.queue.submit([encoder.finish()])
    linear = np.frombuffer(device.queue.read_buffer(pixels), np.float32).reshape(size, size, 4)
    return linear[..., :3].copy()


def _group(device: Any, pipeline: Any, number: int, buffers: dict[int, Any]) -> Any:
    entries = [
        {"binding": binding, "resource": {"buffer": buffer, "offset": 0, "size": buffer.size}}
        for binding, buffer in buffers.items()
    ]
    return device.create_bind_group(layout=pipeline.get_bind_group_layout(number), entries=entries)


def write_png(path: Path, linear: NDArray[np.float32]) -> None:
    """Writes linear RGB as an sRGB picture of 8 bits a channel."""
    value = np.clip(linear, 0, 1)
    encoded = np.where(value <= 0.0031308, 12.92 * value, 1.055 * value ** (1 / 2.4) - 0.055)
    rows = np.rint(255 * encoded).astype(np.uint8)
    height, width = rows.shape[:2]
    lines = b"".join(b"\0" + row.tobytes() for row in rows)
    chunks = (
        (b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)),
        (b"IDAT", zlib.compress(lines)),
        (b"IEND", b""),
    )
    content = b"\x89PNG\r\n\x1a\n"
    for kind, body in chunks:
        content += struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    path.write_bytes(content)


def main() -> None:
    """Writes sample.png beside this file."""
    size = int(sys.argv[1]) if len(sys.argv) > 1 else 512
    write_png(FOLDER / "sample.png", draw(size))


if __name__ == "__main__":
    main()
