"""Libraries for engines: they compile by compilers of their languages, compute what the models do, and draw.

Decoders and materials are in tests/exporters.

Covers: exporters/shaders.py, exporters/languages/sample.py
"""

from __future__ import annotations

import json
import runpy
from collections.abc import Callable, Iterator
from functools import cache, partial
from pathlib import Path
from unittest.mock import patch

import numpy as np
import pytest

from loomlight.core.images import read_picture
from loomlight.core.llvm import require_llvm
from loomlight.exporters import export, shaders
from loomlight.exporters.shaders import LANGUAGES, library, spirv_library
from loomlight.fabric import fabric_from_text
from loomlight.models.interface import Model
from loomlight.models.neural.model import NeuralModel, NeuralOptions
from loomlight.models.registry import REALTIME_MODELS, make_model
from loomlight.realtime.device import default_adapter
from loomlight.realtime.materials import Material
from loomlight.realtime.records import numpy_type
from loomlight.realtime.slangc import compile_shader
from studies.instruments.counted_library import CountedLibrary, queries_of
from tests.helpers.arrays import vectors
from tests.helpers.commands import run_compiler
from tests.helpers.parity import share_beyond
from tests.helpers.shader_cases import bsdf_of, footprint_rows, layered_fabric
from tests.helpers.untrained import random_latent, random_neumip, small_clustered, with_samples
from tests.marks import slow_among

require_llvm()
pytestmark = pytest.mark.usefixtures("graphics")
# Of yarns that wander, and vary along themselves.
FABRIC = fabric_from_text(
    'weave = "twill 2/1"\nends_per_cm = 14\npicks_per_cm = 11\n[warp]\ncolor = "#2a4680"\nwidth_mm = 0.5\n'
    "slub = 0.5\nmass_cv = 0.2\nshade = 0.3\n[weft]\nneps = 9\n[sheen]\nstrength = 0.3\n"
)
Exported = Callable[[str, str], Path]
MODELS = tuple(REALTIME_MODELS)
# A compiler takes seconds of each; what all share is in the smallest.
QUICK = slow_among(MODELS, {*MODELS} - {"point"})


@cache
def material_of(model: str) -> Material:
    """What is exported of a model: trained ones have random numbers."""
    if model == "neural":
        return NeuralModel.for_source(FABRIC, NeuralOptions(refined=False))
    if model == "clustered":
        return with_samples(small_clustered(1), 0)
    if model == "neumip":
        return random_neumip(half=True)
    return random_latent() if model == "latent" else FABRIC


@pytest.fixture(scope="module")
def exported(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Exported]:
    """Gives the folder of a language and a model, exported once; tables are baked once for all languages."""
    made = tmp_path_factory.mktemp("exports")

    @cache
    def folder_of(language: str, model: str) -> Path:
        folder = made / f"{language}-{model}"
        export(material_of(model), language, folder, model)
        return folder

    with patch.object(shaders, "tables_for", cache(shaders.tables_for)):
        yield folder_of


@pytest.mark.parametrize("model", QUICK)
def test_glslang_compiles_glsl_and_hlsl(exported: Exported, model: str, tmp_path: Path) -> None:
    out = tmp_path / "out.spv"
    kernel = "cloth_queries"
    run_compiler(
        "glslangValidator", "-V", "-S", "comp", "-o", out, f"{kernel}.glsl", cwd=exported("glsl", model)
    )
    options = ("-D", "-V", "-S", "comp", "-e", kernel, "-o", out)
    run_compiler("glslangValidator", *options, f"{kernel}.hlsl", cwd=exported("hlsl", model))


@pytest.mark.parametrize("model", QUICK)
def test_naga_compiles_wgsl_with_kernel_and_sample(exported: Exported, model: str) -> None:
    folder = exported("wgsl", model)
    for name in ("cloth_queries.wgsl", "sample.wgsl"):
        code = "\n".join((folder / file).read_text(encoding="utf-8") for file in ("cloth.wgsl", name))
        assert default_adapter().device.create_shader_module(code=code) is not None


@pytest.mark.parametrize("model", QUICK)
def test_exported_modules_need_no_other_file(exported: Exported, model: str) -> None:
    """slangc finds them in the folder of the file first."""
    folder = exported("slang", model)
    assert len(compile_shader(folder / f"cloth_{model}.slang", "wgsl", [f"{model}_queries"])) > 10_000
    assert {file.suffix for file in folder.iterdir()} == {".slang", ".bin", ".json", ".md", ".h"}


@pytest.mark.slow
@pytest.mark.parametrize("language", ["cuda", "metal", "spirv"])
def test_languages_without_a_compiler_here_are_exported(exported: Exported, language: str) -> None:
    folder = exported(language, "point")
    kernels = [file for suffix in ("cu", "metal", "spv") for file in folder.glob(f"*.{suffix}")]
    assert max(file.stat().st_size for file in kernels) > 10_000


def test_header_compiles_as_c(exported: Exported, tmp_path: Path) -> None:
    """Offsets of all fields are asserted in it."""
    for language, standard in (("c", "c11"), ("c++", "c++17")):
        source = tmp_path / f"host.{language[0]}"
        source.write_text('#include "cloth.h"\n')
        compiler = "gcc" if language == "c" else "g++"
        header = exported("hlsl", "lobes")
        run_compiler(
            compiler, f"-std={standard}", "-x", language, "-fsyntax-only", "-I", header, source, cwd=tmp_path
        )


@pytest.mark.parametrize("model", QUICK)
def test_cuda_text_computes_what_the_model_computes(model: str) -> None:
    """On a CPU: the export's prelude stands in for CUDA there. Bars as for WGSL, see docs/realtime.md."""
    material, rows = material_of(model), footprint_rows(2000, 3)
    library = CountedLibrary(material, model)
    found, counts = library.answers(queries_of(*rows.values()))
    at = bsdf_of(material if isinstance(material, Model) else make_model(model, material), rows)
    value = np.array(at.value(vectors(rows["light"]))).T
    through = np.array(at.null_transmission)
    # Rays of a few queries meet another edge, as rounding decides there; g++ rounds unlike LLVM.
    assert share_beyond(found[:, :3], value) <= 2e-3
    assert share_beyond(found[:, 3], through) <= 2e-3
    assert 500 < counts.operations < (20_000 if model != "neural" else 250_000)
    assert 0 < counts.loaded_bytes < 20 * counts.operations


@pytest.mark.slow
@pytest.mark.parametrize("model", ["lobes", "point"])
def test_cloth_in_layers_is_shown_with_its_planes(model: str) -> None:
    """Layers change places, and holes of the front show what lies behind; the bars are those of frames."""
    fabric, rows = layered_fabric("pattern-double-weave"), footprint_rows(2000, 3)
    found, _ = CountedLibrary(fabric, model).answers(queries_of(*rows.values()))
    at = bsdf_of(make_model(model, fabric), rows)
    value = np.array(at.value(vectors(rows["light"]))).T
    assert share_beyond(found[:, :3], value) <= 3e-3
    assert share_beyond(found[:, 3], np.array(at.null_transmission)) <= 3e-3


@pytest.mark.parametrize("language", slow_among([*LANGUAGES, "spirv"], {*LANGUAGES, "spirv"} - {"cuda"}))
def test_code_knows_layers_where_the_cloth_has_some(language: str, tmp_path: Path) -> None:
    code = (spirv_library if language == "spirv" else partial(library, language))("point")
    other = (spirv_library if language == "spirv" else partial(library, language))("point", True)
    assert code != other
    if language == "spirv":
        for number, words in enumerate((code, other)):
            (tmp_path / f"{number}.spv").write_bytes(words)
            run_compiler("spirv-val", "--target-env", "vulkan1.1", f"{number}.spv", cwd=tmp_path)


@pytest.mark.slow
def test_estimates_of_clustered_are_unbiased() -> None:
    """Means of exported estimates of a few footprints, against those of texels alone in Python."""
    model, count, seeds = small_clustered(1), 6, 4000
    rng = np.random.default_rng(6)
    few = footprint_rows(count, 3, seed=6)
    # Along the threads the footprint of the model is the pixel's.
    side, zero = np.float32(10 ** rng.uniform(-1, 0.5, count)), np.zeros(count, np.float32)
    few |= {"dx": np.stack([side, zero], axis=-1), "dy": np.stack([zero, 0.7 * side], axis=-1)}
    rows = {name: np.repeat(part, seeds, axis=0) for name, part in few.items()}
    asked = queries_of(*rows.values())
    asked["seed"] = rng.integers(1, 2**32, len(asked), dtype=np.uint32)
    library = CountedLibrary(model, "clustered", estimates=True)
    found = library.answers(asked)[0].reshape(count, seeds, 4)
    at = bsdf_of(
        model.without_control(), rows | {"seed": rng.integers(0, 2**32, len(asked), dtype=np.uint32)}
    )
    exact = np.array(at.value(vectors(rows["light"]))).T.reshape(count, seeds, 3)
    error = np.sqrt(exact.var(axis=1) + found[..., :3].var(axis=1)) / np.sqrt(seeds)
    # Where texels hardly differ, g++ and LLVM round differently.
    error = np.maximum(error, 1e-4 * exact.mean(axis=1) + 1e-7)
    z = (found[..., :3].mean(axis=1) - exact.mean(axis=1)) / error
    assert np.abs(z).max() < 4  # of 18, three times in 1000


@pytest.mark.slow
def test_libraries_have_no_kernel() -> None:
    for language in LANGUAGES:
        text = library(language, "point")
        assert "cloth_value(" in text
        assert "queries" not in text
        assert "cloth_estimate(" in library(language, "clustered")
        assert "cloth_auxiliary(" in library(language, "latent")


def test_manifest_describes_the_buffers(exported: Exported) -> None:
    folder = exported("hlsl", "lobes")
    manifest = json.loads((folder / "manifest.json").read_text())
    for entry in manifest["buffers"]:
        assert (folder / entry["file"]).stat().st_size == entry["bytes"]
    kind = numpy_type("Family")
    for field in manifest["records"]["Family"]:
        assert kind.fields is not None
        assert kind.fields[field["name"]][1] == field["offset"]
    readme = (folder / "README.md").read_text()
    assert "register(t2)" in readme
    assert "operations" in readme


@pytest.mark.slow
def test_the_sample_draws_a_sphere(exported: Exported, tmp_path: Path) -> None:
    """With the model point, whose shader the software driver compiles in half the time."""
    sample = runpy.run_path(str(exported("wgsl", "point") / "sample.py"))
    linear = sample["draw"](24)
    assert np.isfinite(linear).all()
    corner, middle = linear[0, 0], linear[8:16, 8:16]
    assert corner == pytest.approx([0.02] * 3)
    # The warp is blue, the weft nearly white.
    assert middle[..., 2].mean() > 1.05 * middle[..., 0].mean() > 0.005
    assert middle.std() > 0.005
    sample["write_png"](tmp_path / "sphere.png", linear)
    assert read_picture(tmp_path / "sphere.png").shape[:2] == (24, 24)
