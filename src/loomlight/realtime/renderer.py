"""Frames of cloth on a graphics adapter: rasterise the visible faces, shade visible pixels, map tones."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.fabric.fabric import Fabric
from loomlight.models.lobes.model import DEFAULT_GROUPS, tables_of
from loomlight.models.lobes.tables import LobeTables
from loomlight.models.woven.model import WovenModel
from loomlight.realtime.device import Adapter, default_adapter, wgpu_module
from loomlight.realtime.fabric_buffers import FabricBuffers
from loomlight.realtime.layout import numpy_type
from loomlight.realtime.scene import Camera, Cloth, Light, light_records, vertex_records
from loomlight.realtime.slangc import SHADERS
from loomlight.realtime.tables import pack_fabrics

# Entry points of the models.
_ENTRIES = {"lobes": "shade_lobes", "point": "shade_points", "woven": "shade_woven"}
_GOLDEN = np.array([0.7548776662466927, 0.5698402909980532])  # of the R2 sequence


@dataclass(frozen=True)
class Picture:
    """A frame.

    Attributes:
        linear: radiance [height, width, 4], linear RGB and the share of the pixel that cloth covers.
        srgb: [height, width, 4], 8 bits a channel, exposed and encoded.
    """

    linear: NDArray[np.float32]
    srgb: NDArray[np.uint8]


class Renderer:
    """Renders meshes of cloth by direct light.

    Cloth does not yet cast shadows on other cloth, and what lies behind holes is the background.

    Attributes:
        adapter: the graphics adapter that computes.
        size: width and height of frames, pixels.
        model: lobes, woven or point.
    """

    def __init__(
        self,
        cloths: Sequence[Cloth],
        size: tuple[int, int] = (512, 512),
        model: str = "lobes",
        adapter: Adapter | None = None,
        bake: str = "cpu",
    ) -> None:
        """Bakes and uploads meshes and fabrics.

        Args:
            size: width and height of frames, pixels.
            model: lobes or woven, which average over the footprints of pixels, or point, which samples them.
            bake: where tables of lobes are baked: cpu, or gpu, where an edit never leaves the adapter.

        Raises:
            InputError: no cloth, a size out of range, or an unknown model or place to bake.
            MissingDependencyError: no adapter, wgpu is not installed, or the adapter's limits are too small.
        """
        width, height = size
        if not cloths:
            raise InputError("A renderer needs at least one piece of cloth.")
        if not (1 <= width <= 8192 and 1 <= height <= 8192):
            raise InputError(f"size = {width} × {height} is out of range: 1 to 8192 pixels each way.")
        if model not in _ENTRIES:
            raise InputError(f'model = "{model}" is unknown here: use {" or ".join(_ENTRIES)}.')
        if bake not in ("cpu", "gpu"):
            raise InputError(f'bake = "{bake}" is unknown: use cpu or gpu.')
        self.adapter = default_adapter() if adapter is None else adapter
        self.size = size
        self.model = model
        self._cloths = list(cloths)
        self._face_count = sum(len(cloth.mesh.faces) for cloth in cloths)
        self._resources: dict[str, Any] = {}
        self._bakes_on_adapter = bake == "gpu" and model == "lobes"
        self._fabric_buffers: FabricBuffers | None = None
        self._upload_meshes()
        self._upload_fabrics()
        self._upload_targets()
        self._raster = self._raster_pipeline()

    def set_fabric(self, number: int, fabric: Fabric) -> None:
        """Another fabric for cloth `number`: tables are rewritten, and no pipeline is compiled."""
        cloth = self._cloths[number]
        self._cloths[number] = Cloth(cloth.mesh, fabric, cloth.uv_size_mm)
        if self._fabric_buffers is None:
            self._upload_fabrics()
        else:
            self._fabric_buffers.set_fabric(number, (fabric.layout(), fabric.appearance()))
            self._resources.update(self._fabric_buffers.buffers)

    def render(
        self,
        camera: Camera,
        lights: Sequence[Light],
        *,
        samples: int = 4,
        passes: int = 4,
        exposure: float = 0.0,
        background: Sequence[float] = (0.0, 0.0, 0.0),
    ) -> Picture:
        """A frame.

        Args:
            samples: points of each pixel's footprint that one pass of the model point shades, ≥ 1.
            passes: raster passes, each through other points of the pixels, ≥ 1: they smooth edges of meshes.
            exposure: stops; colours are multiplied by 2**exposure.
            background: linear radiance where there is no cloth, and behind holes.

        Raises:
            InputError: a value out of range.
        """
        if samples < 1 or passes < 1:
            raise InputError(f"samples = {samples} and passes = {passes}: both are at least 1.")
        self._store("lights", light_records(lights))
        frame = self._frame_record(camera, len(lights), samples, background)
        for number in range(passes):
            # Passes 0 and following of the R2 sequence, about the middle of the pixel.
            jitter = (0.5 + number * _GOLDEN) % 1 - 0.5
            frame["pass_number"], frame["jitter_x"], frame["jitter_y"] = number, *jitter
            frame["gain"] = 2.0**exposure / (number + 1)
            self._store("frames", frame)
            self._draw()
            # A pass a submission: software adapters take seconds for all of them.
            self._compute(_ENTRIES[self.model], [-(-side // 8) for side in self.size])
        width, height = self.size
        self._compute("tone_map", [-(-width * height // 64)])
        pixels = self.adapter.read(self._resources["pixels"], np.uint8, 4 * width * height)
        sums = self.adapter.read(self._resources["radiance"], np.float32, 4 * width * height)
        return Picture(np.float32(sums / passes).reshape(height, width, 4), pixels.reshape(height, width, 4))

    def _frame_record(
        self, camera: Camera, lights: int, samples: int, background: Sequence[float]
    ) -> NDArray[np.void]:
        frame = np.zeros(1, numpy_type("Frame"))
        width, height = self.size
        frame["width"], frame["height"] = width, height
        frame["lights"], frame["samples"], frame["near"] = lights, samples, camera.near
        for name, vector in camera.axes(width, height).items():
            for axis, value in zip("xyz", vector, strict=True):
                frame[f"{name}_{axis}"] = value
        for name, value in zip(("red", "green", "blue"), background, strict=True):
            frame[f"background_{name}"] = value
        return frame

    def _upload_meshes(self) -> None:
        vertices = [vertex_records(cloth.mesh) for cloth in self._cloths]
        firsts = np.cumsum([0, *(len(part) for part in vertices)])
        faces = [
            cloth.mesh.faces.astype(np.uint32) + np.uint32(first)
            for cloth, first in zip(self._cloths, firsts[:-1], strict=True)
        ]
        numbers = np.repeat(np.arange(len(faces), dtype=np.uint32), [len(part) for part in faces])
        self._store("vertices", np.concatenate(vertices))
        self._store("corners", np.concatenate(faces).ravel())
        self._store("face_fabrics", numbers)

    def _upload_fabrics(self) -> None:
        looks = [(cloth.fabric.layout(), cloth.fabric.appearance()) for cloth in self._cloths]
        uv_size_mm = [cloth.uv_size_mm for cloth in self._cloths]
        if self._bakes_on_adapter:
            self._fabric_buffers = FabricBuffers(self.adapter, looks, uv_size_mm)
            self._resources.update(self._fabric_buffers.buffers)
            return
        packed = pack_fabrics(
            looks,
            uv_size_mm,
            [self._baked(cloth.fabric) for cloth in self._cloths],
            [self._encoded(cloth.fabric) for cloth in self._cloths],
        )
        for name, values in packed.buffers().items():
            self._store(name, values)

    def _baked(self, fabric: Fabric) -> LobeTables | None:
        return tables_of(fabric, DEFAULT_GROUPS) if self.model == "lobes" else None

    def _encoded(self, fabric: Fabric) -> WovenModel | None:
        return WovenModel.for_source(fabric) if self.model == "woven" else None

    def _upload_targets(self) -> None:
        wgpu = wgpu_module()
        width, height = self.size
        self._resources["radiance"] = self.adapter.empty_storage(16 * width * height)
        self._resources["pixels"] = self.adapter.empty_storage(4 * width * height)
        attachment = wgpu.TextureUsage.RENDER_ATTACHMENT
        self._faces = self.adapter.device.create_texture(
            size=(width, height, 1), format="r32uint", usage=attachment | wgpu.TextureUsage.TEXTURE_BINDING
        )
        self._depth = self.adapter.device.create_texture(
            size=(width, height, 1), format="depth32float", usage=attachment
        )
        self._resources["visible_faces"] = self._faces.create_view()

    def _store(self, name: str, values: NDArray[Any]) -> None:
        """Rewrites a buffer, or makes a larger one."""
        buffer = self._resources.get(name)
        if buffer is not None and buffer.size >= values.nbytes:
            self.adapter.write(buffer, values)
        else:
            self._resources[name] = self.adapter.storage(values)

    def _raster_pipeline(self) -> Any:
        device = self.adapter.device
        vertex, fragment = (
            device.create_shader_module(code=_wgsl(name)) for name in ("raster_vertex", "raster_fragment")
        )
        return device.create_render_pipeline(
            layout="auto",
            vertex={"module": vertex, "entry_point": "raster_vertex", "buffers": []},
            primitive={"topology": "triangle-list", "cull_mode": "none"},
            # Depth is near / distance: larger is nearer.
            depth_stencil={
                "format": "depth32float",
                "depth_write_enabled": True,
                "depth_compare": "greater",
            },
            fragment={
                "module": fragment,
                "entry_point": "raster_fragment",
                "targets": [{"format": "r32uint"}],
            },
        )

    def _draw(self) -> None:
        device = self.adapter.device
        encoder = device.create_command_encoder()
        target = {
            "view": self._faces.create_view(),
            "load_op": "clear",
            "store_op": "store",
            "clear_value": (0, 0, 0, 0),
        }
        depth = {
            "view": self._depth.create_view(),
            "depth_load_op": "clear",
            "depth_store_op": "discard",
            "depth_clear_value": 0.0,
        }
        raster = encoder.begin_render_pass(color_attachments=[target], depth_stencil_attachment=depth)
        raster.set_pipeline(self._raster)
        raster.set_bind_group(0, self.adapter.bindings(self._raster, _wgsl("raster_vertex"), self._resources))
        raster.draw(3 * self._face_count)
        raster.end()
        device.queue.submit([encoder.finish()])

    def _compute(self, entry: str, groups: Sequence[int]) -> None:
        wgsl = _wgsl(entry)
        pipeline = self.adapter.pipeline(wgsl, entry)
        encoder = self.adapter.device.create_command_encoder()
        compute = encoder.begin_compute_pass()
        compute.set_pipeline(pipeline)
        compute.set_bind_group(0, self.adapter.bindings(pipeline, wgsl, self._resources))
        compute.dispatch_workgroups(*groups)
        compute.end()
        self.adapter.device.queue.submit([encoder.finish()])


def _wgsl(entry: str) -> str:
    return (SHADERS / "wgsl" / f"{entry}.wgsl").read_text(encoding="utf-8")
