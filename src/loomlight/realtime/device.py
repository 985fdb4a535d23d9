"""The graphics adapter: a wgpu device, buffers, and compute pipelines from WGSL."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import MissingDependencyError
from loomlight.core.extras import import_extra

# Where Linux distributions put the manifest of Mesa's software driver.
_SOFTWARE_DRIVERS = (
    "/usr/share/vulkan/icd.d/lvp_icd.x86_64.json",
    "/usr/share/vulkan/icd.d/lvp_icd.aarch64.json",
    "/usr/share/vulkan/icd.d/lvp_icd.json",
)
NO_ADAPTER = (
    "Real-time rendering needs a graphics adapter with Vulkan, Metal or DX12, and none was found: install a "
    "driver, or the software driver (Debian, Ubuntu: apt install mesa-vulkan-drivers libvulkan1)."
)
# The feature of adapters that tell how long passes take.
TIMESTAMPS = "timestamp-query"
# Storage buffers that the largest shader binds.
STORAGE_BUFFERS = 8
_RAISED_LIMITS = (
    "max-storage-buffer-binding-size",
    "max-buffer-size",
    "max-storage-buffers-per-shader-stage",
)
# The number of the constant of `planes.slang`, by which hosts choose it.
_LAYERED = re.compile(r"@id\((\d+)\) override HAS_LAYERS_\d+ ")
_BINDING = re.compile(r"@binding\((\d+)\) @group\(0\) var(?:<[\w, ]+>)? (\w+?)_\d+ ")


@dataclass
class Adapter:
    """A graphics adapter and its device.

    Attributes:
        name: of the adapter.
        is_software: a CPU computes.
        device: wgpu's.
    """

    name: str
    is_software: bool
    device: Any
    _pipelines: dict[tuple[str, str, bool], Any] = field(default_factory=dict)

    def storage(self, values: NDArray[Any]) -> Any:
        """A storage buffer with these values, at least 16 bytes."""
        data = np.ascontiguousarray(values)
        buffer = self.empty_storage(data.nbytes)
        self.write(buffer, data)
        return buffer

    def empty_storage(self, size: int) -> Any:
        """A storage buffer of at least `size` bytes, all zero."""
        wgpu = wgpu_module()
        usage = wgpu.BufferUsage.STORAGE | wgpu.BufferUsage.COPY_DST | wgpu.BufferUsage.COPY_SRC
        usage |= wgpu.BufferUsage.UNIFORM  # the record of a frame
        self._require("max-storage-buffer-binding-size", size, "bytes in a table")
        return self.device.create_buffer(size=max(16, -(-size // 16) * 16), usage=usage)

    def write(self, buffer: Any, values: NDArray[Any], offset: int = 0) -> None:
        """Overwrites a part of a buffer, from `offset` bytes on."""
        if values.nbytes:
            self.device.queue.write_buffer(buffer, offset, np.ascontiguousarray(values).view(np.uint8))

    def read(self, buffer: Any, kind: type[np.generic], count: int) -> NDArray[Any]:
        """The first `count` elements of a buffer."""
        size = -(-count * np.dtype(kind).itemsize // 4) * 4
        return np.frombuffer(self.device.queue.read_buffer(buffer, 0, size), kind, count).copy()

    def pipeline(self, wgsl: str, entry: str, is_layered: bool = False) -> Any:
        """The compute pipeline of an entry point, compiled once.

        Args:
            is_layered: whether any cloth has layers (`planes.slang`); without, nothing of them is computed.
        """
        declared = _LAYERED.search(wgsl)
        is_layered = is_layered and declared is not None
        if (wgsl, entry, is_layered) not in self._pipelines:
            module = self.device.create_shader_module(code=wgsl)
            constants = {} if declared is None else {declared[1]: int(is_layered)}
            self._pipelines[wgsl, entry, is_layered] = self.device.create_compute_pipeline(
                layout="auto", compute={"module": module, "entry_point": entry, "constants": constants}
            )
        return self._pipelines[wgsl, entry, is_layered]

    def bindings(self, pipeline: Any, wgsl: str, resources: Mapping[str, Any]) -> Any:
        """The bind group that gives a shader's globals the buffers or textures of the same names."""
        entries = []
        for binding, name in _BINDING.findall(wgsl):
            resource = resources[name]
            is_buffer = hasattr(resource, "map_sync")
            entries.append(
                {
                    "binding": int(binding),
                    "resource": {"buffer": resource, "offset": 0, "size": resource.size}
                    if is_buffer
                    else resource,
                }
            )
        return self.device.create_bind_group(layout=pipeline.get_bind_group_layout(0), entries=entries)

    @contextmanager
    def guarded(self) -> Iterator[None]:
        """Raises MissingDependencyError, one sentence, if the device is lost within the block."""
        wgpu = wgpu_module()
        try:
            yield
        except (wgpu.GPUError, RuntimeError) as error:
            if not _tells_of_loss(str(error)):
                raise
            if default_adapter() is self:
                default_adapter.cache_clear()  # the next renderer takes a new device
            raise MissingDependencyError(
                f"The graphics adapter {self.name} was lost, by a reset of its driver or for want of memory: "
                "begin again, with smaller frames if it happens anew."
            ) from error

    def _require(self, limit: str, value: int, what: str) -> None:
        most = self.device.limits[limit]
        if value > most:
            raise MissingDependencyError(
                f"{self.name} takes at most {most} {what}, but {value} are needed: choose a smaller "
                "draft or mesh, or another adapter."
            )


def _tells_of_loss(message: str) -> bool:
    """True of a message of wgpu that its device is gone."""
    words = message.lower()
    return any(
        sign in words for sign in ("lost", "not enough memory", "out of memory", "is invalid", "destroyed")
    )


def wgpu_module() -> Any:
    """wgpu, with Mesa's software driver where the machine names no other.

    Raises:
        MissingDependencyError: it is not installed.
    """
    _name_software_driver()
    if "XDG_RUNTIME_DIR" not in os.environ:
        # Mesa's layer that chooses among devices would look for a display, and complain that there is none.
        os.environ.setdefault("NODEVICE_SELECT", "1")
    return import_extra("wgpu", "realtime", "Real-time rendering")


def _name_software_driver() -> None:
    """Lets the Vulkan loader find lavapipe where nothing is named and it is the only driver installed.

    Other drivers of Mesa print complaints on machines without their hardware.
    """
    if "VK_DRIVER_FILES" in os.environ or "VK_ICD_FILENAMES" in os.environ or Path("/dev/dri").exists():
        return
    if Path("/dev/nvidiactl").exists() or Path("/dev/dxg").exists():
        return
    for manifest in _SOFTWARE_DRIVERS:
        if Path(manifest).is_file():
            os.environ["VK_DRIVER_FILES"] = manifest
            return


def _leave_out_opengl() -> None:
    """Keeps wgpu from trying OpenGL, whose libraries print complaints where there is no display."""
    extras = import_extra("wgpu.backends.wgpu_native.extras", "realtime", "Real-time rendering")
    try:
        extras.set_instance_extras(backends=["Vulkan", "Metal", "DX12"])
    except RuntimeError:  # the program has used wgpu before
        return


@cache
def default_adapter() -> Adapter:
    """The first adapter that is no CPU, else a software adapter.

    Raises:
        MissingDependencyError: wgpu is not installed, or there is no adapter.
    """
    wgpu = wgpu_module()
    _leave_out_opengl()
    found = [a for a in wgpu.gpu.enumerate_adapters_sync() if a.info["backend_type"] != "OpenGL"]
    if not found:
        raise MissingDependencyError(NO_ADAPTER)
    adapter = min(found, key=lambda a: a.info["adapter_type"] == "CPU")
    limits = {name: adapter.limits[name] for name in _RAISED_LIMITS}
    buffers = limits["max-storage-buffers-per-shader-stage"]
    if buffers < STORAGE_BUFFERS:
        raise MissingDependencyError(
            f"{adapter.info['device']} binds at most {buffers} storage buffers to a shader, but "
            f"{STORAGE_BUFFERS} are needed: choose another adapter."
        )
    features = [TIMESTAMPS] if TIMESTAMPS in adapter.features else []
    device = adapter.request_device_sync(required_features=features, required_limits=limits)
    return Adapter(adapter.info["device"], adapter.info["adapter_type"] == "CPU", device)
