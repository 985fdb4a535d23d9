"""Frames of cloth on a graphics adapter: rasterise the visible faces, shade visible pixels, map tones."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, TypedDict, Unpack

import numpy as np
from numpy.typing import NDArray

from loomlight.core.errors import InputError
from loomlight.models.registry import REALTIME_MODELS
from loomlight.realtime.bake import FabricBuffers
from loomlight.realtime.device import Adapter, default_adapter, wgpu_module
from loomlight.realtime.materials import (
    Material,
    default_model_of,
    look_of,
    require_realtime_model,
    tables_for,
)
from loomlight.realtime.records import numpy_type
from loomlight.realtime.scene import (
    Camera,
    Cloth,
    Environment,
    EnvironmentTables,
    Light,
    SceneWords,
    light_records,
    vertex_records,
)
from loomlight.realtime.slangc import SHADERS
from loomlight.realtime.words import pack_fabrics

# Of open cloth, from the nearest on; what lies behind is taken for the background.
MAX_LAYERS = 4
# Steps of the R2 sequence along x and y (Roberts 2018).
GOLDEN = (0.7548776662466927, 0.5698402909980532)


class FrameOptions(TypedDict, total=False):
    """Further arguments of `Renderer.render`.

    samples: points of each pixel's footprint that one pass of the model point shades, ≥ 1.
    environment: light from all directions, seen beside the cloth too; None for none.
    environment_samples: directions to it that each pixel takes in one pass.
    shadows: whether cloth casts shadows on cloth.
    background: linear radiance where there is no cloth, and behind holes; by default the environment, else 0.
    ground: a plane where the background takes the shadow of the cloth, as its unit normal, the distance
        along it from the origin, metres, and the share of the first light in what lights it; None for none.
    """

    samples: int
    environment: Environment | None
    environment_samples: int
    shadows: bool
    background: Sequence[float] | None
    ground: Sequence[float] | None


DEFAULT_OPTIONS: FrameOptions = {
    "samples": 4,
    "environment": None,
    "environment_samples": 8,
    "shadows": True,
    "background": None,
    "ground": None,
}


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

    Attributes:
        passes: how many the sums hold; see `accumulate`.
        adapter: the graphics adapter that computes.
        size: width and height of frames, pixels.
        model: a name of `REALTIME_MODELS`.
    """

    def __init__(
        self,
        cloths: Sequence[Cloth],
        size: tuple[int, int] = (512, 512),
        model: str | None = None,
        adapter: Adapter | None = None,
        bake: str = "cpu",
    ) -> None:
        """Bakes and uploads meshes and fabrics.

        Args:
            size: width and height of frames, pixels.
            model: a name of `REALTIME_MODELS`: point samples the footprints of pixels, others average over
                them; by default the model that the first cloth holds, for fabrics lobes.
            bake: where tables of lobes are baked: cpu, or gpu, by the kernels of the page.

        Raises:
            InputError: no cloth, a size out of range, an unknown model or place to bake, or a cloth that the
                model does not take.
            MissingDependencyError: no adapter, wgpu is not installed, or the adapter's limits are too small.
        """
        if not cloths:
            raise InputError("A renderer needs at least one piece of cloth.")
        _require_size(size)
        model = default_model_of(cloths[0].fabric) if model is None else model
        require_realtime_model(model)
        if bake not in ("cpu", "gpu"):
            raise InputError(f'bake = "{bake}" is unknown: use cpu or gpu.')
        self.adapter = default_adapter() if adapter is None else adapter
        self.size = size
        self.model = model
        self._cloths = list(cloths)
        self._face_count = sum(len(cloth.mesh.faces) for cloth in cloths)
        self._resources: dict[str, Any] = {}
        self._bake = bake
        self._environment: tuple[Environment, EnvironmentTables] | None = None
        # What the sums show; no bytes where they are to begin anew.
        self._shown, self.passes = b"", 0
        with self.adapter.guarded():
            self._upload_meshes()
            self._upload_fabrics()
            self._upload_targets()
            self._raster = self._raster_pipeline()

    def set_fabric(self, number: int, fabric: Material) -> None:
        """Another fabric for cloth `number`: tables are rewritten, and no pipeline is compiled."""
        self._cloths[number] = replace(self._cloths[number], fabric=fabric)
        self._upload_fabrics()
        self._shown = b""

    def set_model(self, model: str) -> None:
        """Another model for the next frames; tables are baked, and its shader is compiled at its first frame.

        Raises:
            InputError: an unknown model, or a cloth that it does not take.
        """
        require_realtime_model(model)
        before, self.model = self.model, model
        try:
            self._upload_fabrics()
        except InputError:
            self.model = before
            raise
        self._shown = b""

    def resize(self, size: tuple[int, int]) -> None:
        """Another size, width and height in pixels, for the next frames.

        Raises:
            InputError: a size out of range.
        """
        _require_size(size)
        self.size = size
        with self.adapter.guarded():
            self._upload_targets()
        self._shown = b""

    def render(
        self,
        camera: Camera,
        lights: Sequence[Light],
        *,
        passes: int = 4,
        exposure: float = 0.0,
        **options: Unpack[FrameOptions],
    ) -> Picture:
        """A frame.

        Args:
            passes: raster passes, each through other points of the pixels, ≥ 1: they smooth edges of meshes.
            exposure: stops; colours are multiplied by 2**exposure.
            options: see `FrameOptions`.

        Raises:
            InputError: a value out of range.
            MissingDependencyError: the adapter was lost.
        """
        self._shown = b""
        return self.accumulate(camera, lights, passes=passes, exposure=exposure, **options)

    def accumulate(
        self,
        camera: Camera,
        lights: Sequence[Light],
        *,
        passes: int = 1,
        exposure: float = 0.0,
        **options: Unpack[FrameOptions],
    ) -> Picture:
        """The mean over all passes since something changed: the camera, lights, options or a fabric.

        Called again and again while the camera rests, it converges. Arguments and errors as `render`.
        """
        options = {**DEFAULT_OPTIONS, **options}
        if options["samples"] < 1 or passes < 1:
            raise InputError(f"samples = {options['samples']} and passes = {passes}: both are at least 1.")
        environment = self._environment_tables(options["environment"])
        frame = self._frame_record(camera, len(lights), options, environment)
        records = light_records(lights)
        with self.adapter.guarded():
            self._resources["scene_words"] = self._scene.show(self.adapter, environment, records)
            self._scene.describe(frame)
            self._size_visibilities(frame)
            shown = frame.tobytes() + records.tobytes() + str(id(environment)).encode()
            if shown != self._shown:
                self._shown, self.passes = shown, 0
            for _ in range(passes):
                self._add_pass(frame)
            return self._picture(frame, exposure)

    def _add_pass(self, frame: NDArray[np.void]) -> None:
        # Passes 0 and following of the R2 sequence, about the middle of the pixel.
        jitter = (0.5 + self.passes * np.array(GOLDEN)) % 1 - 0.5
        frame["pass_number"], frame["jitter_x"], frame["jitter_y"] = self.passes, *jitter
        self._store("frame_record", frame)
        self._draw()
        tiles = [-(-side // 8) for side in self.size]
        # A dispatch a submission: software adapters take seconds for all of them.
        layers = MAX_LAYERS if self._is_open and not self._scene.is_flat else 1
        for number in range(layers):
            self._compute("next_layer" if number else "first_layer", tiles)
            if frame["casts_shadows"][0]:
                self._compute("cast_shadows", tiles)
            self._compute(REALTIME_MODELS[self.model].kernel, tiles)
        self._compute("add_background", tiles)
        self.passes += 1

    def _picture(self, frame: NDArray[np.void], exposure: float) -> Picture:
        width, height = self.size
        frame["gain"] = 2.0**exposure / self.passes
        self._store("frame_record", frame)
        self._compute("tone_map", [-(-width * height // 64)])
        pixels = self.adapter.read(self._resources["pixels"], np.uint8, 4 * width * height)
        sums = self.adapter.read(self._resources["radiance"], np.float32, 4 * width * height)
        linear = np.float32(sums / self.passes).reshape(height, width, 4)
        return Picture(linear, pixels.reshape(height, width, 4))

    def _environment_tables(self, environment: Environment | None) -> EnvironmentTables | None:
        """Tables of an environment, kept for the next frame."""
        if environment is None:
            return None
        if self._environment is None or self._environment[0] is not environment:
            self._environment = environment, environment.tables()
        return self._environment[1]

    def _frame_record(
        self, camera: Camera, lights: int, options: FrameOptions, environment: EnvironmentTables | None
    ) -> NDArray[np.void]:
        frame = np.zeros(1, numpy_type("Frame"))
        frame["width"], frame["height"] = self.size
        frame["lights"], frame["samples"], frame["near"] = lights, options["samples"], camera.near
        frame["casts_shadows"] = options["shadows"] and not self._scene.is_flat
        for name, vector in camera.axes(*self.size).items():
            for axis, value in zip("xyz", vector, strict=True):
                frame[f"{name}_{axis}"] = value
        background = options["background"]
        for name, value in zip(("red", "green", "blue"), background or (0.0, 0.0, 0.0), strict=True):
            frame[f"background_{name}"] = value
        ground = options["ground"] or (0.0,) * 5
        for name, value in zip(("x", "y", "z", "offset", "lamp"), ground, strict=True):
            frame[f"ground_{name}"] = value
        if environment is not None and options["environment"] is not None:
            turn = math.radians(options["environment"].turn)
            frame["environment_rows"], frame["environment_columns"] = environment.radiance.shape[:2]
            frame["environment_total"] = environment.total
            frame["environment_sine"], frame["environment_cosine"] = math.sin(turn), math.cos(turn)
            frame["environment_samples"] = options["environment_samples"] if environment.total > 0 else 0
            frame["shows_environment"] = background is None
        return frame

    def _size_visibilities(self, frame: NDArray[np.void]) -> None:
        """A buffer for the visibility of every light sample of every pixel."""
        count = int(frame["lights"][0] + frame["environment_samples"][0]) if frame["casts_shadows"][0] else 1
        size = 4 * math.prod(self.size) * max(count, 1)
        buffer = self._resources.get("visibilities")
        if buffer is None or buffer.size < size:
            self._resources["visibilities"] = self.adapter.empty_storage(size)

    def _upload_meshes(self) -> None:
        vertices = [vertex_records(cloth.mesh) for cloth in self._cloths]
        firsts = np.cumsum([0, *(len(part) for part in vertices)])
        faces = [
            cloth.mesh.faces.astype(np.uint32) + np.uint32(first)
            for cloth, first in zip(self._cloths, firsts[:-1], strict=True)
        ]
        numbers = np.repeat(np.arange(len(faces), dtype=np.uint32), [len(part) for part in faces])
        corners = np.concatenate(faces)
        positions = np.concatenate([cloth.mesh.positions for cloth in self._cloths])
        albedos = [cloth.albedo for cloth in self._cloths]
        self._scene = SceneWords(positions, np.concatenate(vertices), corners, numbers, albedos)

    def _upload_fabrics(self) -> None:
        materials = [cloth.fabric for cloth in self._cloths]
        looks = [look_of(material, self.model) for material in materials]
        uv_size_mm = [cloth.uv_size_mm for cloth in self._cloths]
        if self._bake == "gpu" and REALTIME_MODELS[self.model].bakes_on_adapter:
            yarns = [look for look in looks if look is not None]
            fabrics = FabricBuffers(self.adapter, yarns, uv_size_mm, describe=self._scene.describe_maps)
            self._resources.update(fabrics.buffers)
            self._is_open, self._is_layered = fabrics.is_open, fabrics.packed.is_layered
            return
        models = [tables_for(material, self.model) for material in materials]
        packed = pack_fabrics(looks, uv_size_mm, models)
        self._scene.describe_maps(packed.fabrics)
        self._is_open = bool(packed.fabrics["is_open"].any())
        self._is_layered = packed.is_layered
        for name, values in packed.buffers().items():
            self._store(name, values)

    def _upload_targets(self) -> None:
        wgpu = wgpu_module()
        width, height = self.size
        self._resources["radiance"] = self.adapter.empty_storage(16 * width * height)
        self._resources["pixels"] = self.adapter.empty_storage(4 * width * height)
        self._resources["layers"] = self.adapter.empty_storage(8 * width * height)
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
            depth_stencil={"format": "depth32float", "depth_write_enabled": True, "depth_compare": "greater"},
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
        pipeline = self.adapter.pipeline(wgsl, entry, self._is_layered)
        encoder = self.adapter.device.create_command_encoder()
        compute = encoder.begin_compute_pass()
        compute.set_pipeline(pipeline)
        compute.set_bind_group(0, self.adapter.bindings(pipeline, wgsl, self._resources))
        compute.dispatch_workgroups(*groups)
        compute.end()
        self.adapter.device.queue.submit([encoder.finish()])


def _require_size(size: tuple[int, int]) -> None:
    width, height = size
    if not (1 <= width <= 8192 and 1 <= height <= 8192):
        raise InputError(f"size = {width} × {height} is out of range: 1 to 8192 pixels each way.")


def _wgsl(entry: str) -> str:
    return (SHADERS / "wgsl" / f"{entry}.wgsl").read_text(encoding="utf-8")
