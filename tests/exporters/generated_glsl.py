"""GLSL that MaterialX generates of a document, run at single texels: f·cos of one light.

The text is made a compute shader: uniforms become constants, reads of textures take a texel given with the
query, the light is given too, and the surface is the plane z = 0 with its tangent along x.
"""

from __future__ import annotations

import re
import tempfile
from pathlib import Path

import MaterialX
import numpy as np
from MaterialX import PyMaterialXGenGlsl, PyMaterialXGenShader
from numpy.typing import NDArray
from PIL import Image

from loomlight.realtime.device import default_adapter
from loomlight.realtime.slangc import compile_shader

Numbers = NDArray[np.float64]

_HEAD = """
const int STRIDE = %d;
const int COUNT = %d;
layout(binding = 0) readonly buffer Queries { vec4 queries[STRIDE * COUNT]; };
layout(binding = 1) buffer Answers { vec4 answers[COUNT]; };
#define fwidth(x) (0.0 * (x))
int query;
const bool u_refractionTwoSided = false;
vec4 texelOf(int picture) { return queries[query * STRIDE + 2 + picture]; }
struct VertexData
{
    vec3 normalWorld; vec3 tangentWorld; vec2 texcoord_0; vec3 bitangentWorld; vec3 positionWorld;
};
VertexData vd;
vec4 out1;
"""
_MAIN = """
layout(local_size_x = 64) in;
void main()
{
    query = int(gl_GlobalInvocationID.x);
    if (query >= COUNT) return;
    vd.normalWorld = vec3(0, 0, 1);
    vd.tangentWorld = vec3(1, 0, 0);
    vd.bitangentWorld = vec3(0, 1, 0);
    u_viewPosition = 1e3 * queries[query * STRIDE + 1].xyz;
    u_numActiveLightSources = 1;
    shade();
    answers[query] = out1;
}
"""


def glsl_of(document: Path) -> str:
    """The fragment shader that MaterialX generates of a document's only material."""
    read = MaterialX.createDocument()
    MaterialX.readFromXmlFile(read, str(document))
    library = MaterialX.createDocument()
    MaterialX.loadLibraries(
        MaterialX.getDefaultDataLibraryFolders(), MaterialX.getDefaultDataSearchPath(), library
    )
    read.setDataLibrary(library)
    generator = PyMaterialXGenGlsl.GlslShaderGenerator.create()
    colours = PyMaterialXGenShader.DefaultColorManagementSystem.create(generator.getTarget())
    colours.loadLibrary(library)
    generator.setColorManagementSystem(colours)
    context = PyMaterialXGenShader.GenContext(generator)
    context.registerSourceCodeSearchPath(MaterialX.getDefaultDataSearchPath())
    options = context.getOptions()
    options.hwMaxActiveLightSources = 1
    options.targetColorSpaceOverride = "lin_rec709"
    none = PyMaterialXGenShader.HwSpecularEnvironmentMethod.SPECULAR_ENVIRONMENT_NONE
    options.hwSpecularEnvironmentMethod = none
    generator.registerTypeDefs(read)
    (material,) = read.getMaterialNodes()
    shader = generator.generate("cloth", material, context)
    return shader.getSourceCode(PyMaterialXGenShader.PIXEL_STAGE)


def compute_shader(glsl: str, pictures: list[str], count: int) -> str:
    """The fragment shader as a compute shader over queries."""
    text = re.sub(r"^in VertexData\n\{.*?\} vd;$", "", glsl, flags=re.MULTILINE | re.DOTALL)
    text = re.sub(r"^out vec4 out1;$", "", text, flags=re.MULTILINE)
    _, _, text = text.partition("\n")
    # Reads of a picture: its texel, whatever the coordinates.
    for name in set(re.findall(r"^uniform sampler2D (\w+);$", text, flags=re.MULTILINE)):
        picture = re.sub(r"^image_(\w+?)(?:_(?:color3|vector3|vector4))?_file$", r"\1", name)
        text = text.replace(f"uniform sampler2D {name};", f"const int {name} = {pictures.index(picture)};")
    text = re.sub(r"(void mx_image_\w+\()sampler2D tex_sampler", r"\1int tex_sampler", text)
    text = re.sub(r"texture\(tex_sampler, uv\)", "texelOf(tex_sampler)", text)
    text = re.sub(r"^uniform (surfaceshader|displacementshader|LightData)\b", r"\1", text, flags=re.MULTILINE)
    text = re.sub(r"^uniform ", "", text, flags=re.MULTILINE)
    light = "void sampleLightSource(LightData light, vec3 position, out lightshader result)\n{"
    given = "result.intensity = vec3(1.0); result.direction = queries[query * STRIDE].xyz; return;"
    text = text.replace(light, f"{light}\n    {given}")
    text = text.replace("void main()", "void shade()")
    return "#version 450\n" + _HEAD % (2 + len(pictures), count) + text + _MAIN


def answers(
    document: Path, row: NDArray[np.int64], column: NDArray[np.int64], light: Numbers, view: Numbers
) -> Numbers:
    """f·cos [n, 3] at texels of a document's pictures, rows from the lower edge, times their opacity."""
    pictures = sorted((document.parent / "textures").glob("*.png"))
    count = len(row)
    queries = np.ones((count, 2 + len(pictures), 4), np.float32)
    queries[:, 0, :3], queries[:, 1, :3] = light, view
    for number, picture in enumerate(pictures):
        pixels = np.asarray(Image.open(picture), np.float32)[::-1] / 255
        queries[:, 2 + number, : pixels.shape[-1]] = pixels[row, column]
    text = compute_shader(glsl_of(document), [picture.stem for picture in pictures], count)
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder, "cloth.comp")
        source.write_text(text, encoding="utf-8")
        options = ("-lang", "glsl", "-stage", "compute", "-O0", "-skip-spirv-validation")
        code = compile_shader(source, "spirv", ["main"], options)
    adapter = default_adapter()
    given, found = adapter.storage(queries), adapter.empty_storage(16 * count)
    device = adapter.device
    pipeline = device.create_compute_pipeline(
        layout="auto", compute={"module": device.create_shader_module(code=code), "entry_point": "main"}
    )
    entries = [
        {"binding": number, "resource": {"buffer": buffer, "offset": 0, "size": buffer.size}}
        for number, buffer in enumerate((given, found))
    ]
    encoder = device.create_command_encoder()
    work = encoder.begin_compute_pass()
    work.set_pipeline(pipeline)
    work.set_bind_group(
        0, device.create_bind_group(layout=pipeline.get_bind_group_layout(0), entries=entries)
    )
    work.dispatch_workgroups(-(-count // 64))
    work.end()
    device.queue.submit([encoder.finish()])
    return adapter.read(found, np.float32, 4 * count).reshape(count, 4)[:, :3].astype(np.float64)
