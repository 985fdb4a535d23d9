"""Records that the host writes and shaders read, field by field, and where buffers are bound.

From these descriptions come the Slang structs (`slang_structs`) and the NumPy types (`numpy_type`). Every
field takes four bytes, so that all shading languages and NumPy agree on offsets without padding.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from loomlight.models.registry import REALTIME_MODELS
from loomlight.scattering import detail

# (name, type, meaning); a type is float, uint, or the name of a record above.
Fields = Sequence[tuple[str, str, str]]


def _vector(name: str, meaning: str, axes: Sequence[str] = ("x", "y", "z")) -> Fields:
    """Numbers of a vector or a colour, NAME_x … or x …; the meaning stands at the first."""
    names = [f"{name}_{axis}" if name else axis for axis in axes]
    return [(field, "float", "" if number else meaning) for number, field in enumerate(names)]


_PLANE, _COLOUR = ("x", "y"), ("red", "green", "blue")

FAMILY: Fields = (
    ("is_alike", "uint", "1 where all threads are alike: arithmetic instead of tables"),
    ("count", "float", "threads in the repeat"),
    ("inverse_count", "float", "1/count"),
    ("half_inverse_count", "float", "0.5/count"),
    ("size", "float", "of a cell of threads that are alike"),
    ("inverse_size", "float", "1/size"),
    ("half_width", "float", "of threads that are alike"),
    ("start", "float", "of the first cell"),
    ("period", "float", "size of the repeat across the family"),
    ("inverse_period", "float", "1/period"),
    ("bins", "float", "entries of the table of first threads"),
    ("first_thread_table", "uint", "the first thread that meets each bin, a word each"),
    ("place_table", "uint", "lower, upper, centre, half width of each thread, four words each"),
    ("bend_table", "uint", "sin U, tan(U/2), arc, edge drop of each thread; one row where they are alike"),
    ("height_scale", "float", "β"),
    ("twist_sine", "float", "sin ψ"),
    ("twist_cosine", "float", "cos ψ"),
    ("level", "float", "height of one level of a cell's maximum, before β"),
    ("roughness", "float", "α"),
    ("layer_turned", "float", "share of light from all around that a fibre layer of albedo 1 sends back"),
    ("layer_through", "float", "share that it scatters through"),
    ("albedo_table", "uint", "four albedos of each thread, twelve words each"),
    ("albedo_stride", "uint", "words from one thread's albedos to the next; 0 where they are alike"),
    ("before", "uint", "visible widths and cells of all threads before each [n + 1, 2]"),
    ("visible_total", "float", "visible widths of all threads"),
    ("smallest_box", "float", "least width of a box across the family"),
    ("quantities", "uint", "1 and the principal coordinates of albedos; 1 where threads are alike"),
    ("colour_mean", "uint", "mean of the twelve albedos over the threads"),
    ("cloth_mean", "uint", "the same over what the front of the cloth shows of its layers"),
    ("colour_axes", "uint", "albedos that a principal coordinate of 1 adds [quantities − 1, 12]"),
    ("colour_threads", "uint", "quantities of each thread, and integrals before it [n + 1, 3, quantities]"),
    ("colour_areas", "uint", "summed areas of crossings with the family on top [m + 1, n + 1, quantities]"),
    ("area_unit", "float", "square millimetres that the integer 1 of these integrals stands for"),
    ("crossing_area", "float", "mean visible area of a crossing"),
    (
        "irregular_table",
        "uint",
        "integrals of how yarns vary along themselves [rows, samples, 4] (`IrregularTable`)",
    ),
    *_vector("irregular", "what the integer 1 of these stands for", ("thickness", "cover", "tone", "nep")),
    ("cover", "float", "mean share of a cell that the yarn covers"),
    *_vector("nep", "albedo of neps", _COLOUR),
    *((name, "float", meaning) for name, meaning in detail.FAMILY_NUMBERS.items()),
)

FABRIC: Fields = (
    ("warp", "uint", "index of the record of the warp, threads along y"),
    ("weft", "uint", "index of the record of the weft, threads along x"),
    ("lobes", "Lobes", "tables of the model lobes"),
    ("neural", "Neural", "latents of the model neural"),
    ("neumip", "Neumip", "textures of the model neumip"),
    ("run_words", "uint", "words of warp and weft at each crossing [picks, ends, 2]"),
    ("ends", "uint", "threads of the warp in the repeat"),
    ("max_heights", "uint", "max-height pyramid [⌈picks / 2⌉, ⌈ends / 2⌉, 4]"),
    ("max_height_columns", "uint", "⌈ends / 2⌉"),
    ("height_low", "float", "no thread is lower"),
    ("height_high", "float", "no thread is higher"),
    ("lift", "float", "distance of a ray's origin above the surface"),
    ("threads_per_x", "float", "1 / the finest cell along x"),
    ("threads_per_y", "float", "1 / the finest cell along y"),
    ("per_relief", "float", "1 / (height_high − height_low)"),
    ("diffuse_blend", "float", "w, weight of the yarn normal in the diffuse term"),
    ("optical_depth", "float", "Tρ of the fibre layer"),
    ("grazing_gain", "float", "what albedos of highlights gain at grazing"),
    ("grazing_loss", "float", "what diffuse light loses there, 0 to 1"),
    ("sheen_strength", "float", "C, 0 to 1"),
    ("sheen_roughness", "float", "0 to 1"),
    ("fibre_noise", "float", "spread of the specular strength from fibre to fibre, 0 to 1"),
    ("colour_noise", "float", "spread of the albedo from thread to thread, 0 to 1"),
    ("seed", "uint", "of the noise"),
    ("layer_bound", "float", "κ of the energy bound"),
    ("fibre_size", "float", "width of a cell of fibre noise"),
    ("is_irregular", "uint", "1 where yarns vary along themselves"),
    ("warp_on_top", "float", "share of the crossings"),
    ("has_detail", "uint", "1 where yarns show plies, fibres, slubs or hairs close up"),
    ("uv_width", "float", "millimetres per unit of u"),
    ("uv_height", "float", "millimetres per unit of v"),
    ("is_open", "uint", "1 where light passes through holes"),
    (
        "openness",
        "uint",
        "first word of the numbers of light between yarns (`Openness`); 2³² − 1: none",
    ),
    ("albedo_map", "uint", "first texel, in scene_words, of a map that diffuse albedos are multiplied by"),
    (
        "albedo_map_levels",
        "uint",
        "of that map, each half as wide as the one before, down to 1; 0 for no map",
    ),
    ("has_yarns", "uint", "1 where the yarns are here too: records of families, run words, heights"),
    ("mean_hole", "float", "share of light that passes straight through, on average"),
    ("latent", "Latent", "latents of the model latent"),
    ("clustered", "Clustered", "tables of the model clustered"),
    ("planes", "uint", "layers of cloth that lie upon one another; 0 where one plane is all there is"),
    ("plane_records", "uint", "their records (`Plane`)"),
    ("plane_axes", "uint", "index of two records of families: all threads of the draft, without gaps"),
    ("stacks", "uint", "orders of the planes"),
    (
        "plane_orders",
        "uint",
        "number and level of the planes from the front, and from the back [stacks, 2, planes, 2]",
    ),
    (
        "regions",
        "uint",
        "the stack at each crossing of the draft, a byte each [picks, ends]; where there are several",
    ),
    (
        "plane_shares",
        "uint",
        "what faces show of planes (`Seen.numbers`) [stacks, planes, 2, 2, 72]",
    ),
    ("is_coloured", "uint", "1 where mean albedos depend on the place"),
)

# A layer of cloth, among the words.
PLANE: Fields = (
    ("warp", "uint", "index of the record of its ends"),
    ("weft", "uint", "index of the record of its picks"),
    ("run_words", "uint", "as those of a fabric, of its threads"),
    ("ends", "uint", "its threads of the warp"),
    ("end_numbers", "uint", "of each, its number in the draft"),
    ("pick_numbers", "uint", "the same of its threads of the weft"),
    ("max_heights", "uint", "max-height pyramid"),
    ("max_height_columns", "uint", "⌈ends / 2⌉"),
    ("height_low", "float", "no thread of it is lower, from its plane"),
    ("height_high", "float", "no thread is higher"),
    ("front_level", "float", "highest of its planes where it is the first from the front; NOWHERE_FIRST"),
    ("back_level", "float", "the same from the back"),
    *_vector("start", "where its first cells begin in the draft", _PLANE),
    *_vector("fine", "its finest cells", _PLANE),
)

LIGHT: Fields = (
    ("is_point", "uint", "1 for a point light, 0 for a directional one"),
    *_vector("", "position, or unit direction towards the light"),
    *_vector("", "intensity, W/sr, or irradiance, W/m²", _COLOUR),
)

FRAME: Fields = (
    ("width", "uint", "pixels"),
    ("height", "uint", "pixels"),
    ("lights", "uint", "number of lights"),
    ("samples", "uint", "points of a pixel's footprint that are shaded in one pass"),
    ("pass_number", "uint", "of this pass, from 0: chooses the points"),
    (
        "environment_samples",
        "uint",
        "directions to the environment that a pixel takes in one pass; 0 for none",
    ),
    ("environment_columns", "uint", "texels of the environment around the vertical; 0 for no environment"),
    ("environment_rows", "uint", "and from the top to the bottom"),
    ("environment_table", "uint", "where it begins in scene_words; see environment.slang"),
    ("environment_total", "float", "integral of its mean of red, green and blue over the sphere"),
    ("environment_sine", "float", "of its turn about the vertical, +y"),
    ("environment_cosine", "float", ""),
    ("shows_environment", "uint", "1 where it shows beside the cloth in place of the background"),
    ("casts_shadows", "uint", "1 where cloth shadows cloth"),
    ("leaves", "uint", "of the bounding volume hierarchy, a power of 2"),
    ("leaf_faces", "uint", "where the faces of the leaves begin in scene_words"),
    ("corners", "uint", "where the vertices of the faces do, three a face"),
    ("face_fabrics", "uint", "and the fabric of each face"),
    ("vertices", "uint", "and the records of vertices"),
    ("light_records", "uint", "and those of lights"),
    ("ray_offset", "float", "rays leave surfaces by so much"),
    ("jitter_x", "float", "of the raster pass within the pixel, −0.5 to 0.5 pixels"),
    ("jitter_y", "float", ""),
    ("gain", "float", "2^exposure / passes so far"),
    *_vector("origin", "of the camera"),
    *_vector("right", "half the width of the picture at distance 1 from the camera, to its right"),
    *_vector("up", "half its height, upwards"),
    *_vector("forward", "unit vector"),
    ("near", "float", "nearest distance that is drawn"),
    *_vector("background", "linear radiance where there is no cloth", _COLOUR),
    *_vector("ground", "unit normal of a plane that takes the cloth's shadow; 0 for none"),
    ("ground_offset", "float", "of the plane along its normal"),
    ("ground_lamp", "float", "share of the first light in what lights it"),
)

LAYER: Fields = (
    ("face", "uint", "number of the face that a pixel sees, from 1; 0 for none"),
    ("share", "float", "of the light that comes through all layers before"),
)

VERTEX: Fields = (
    *_vector("", "position"),
    *_vector("normal", "unit normal"),
    ("u", "float", "uv"),
    ("v", "float", ""),
)

SURFACE_HIT: Fields = (
    *_vector("place", "where it lies"),
    ("flags", "uint", "bits of `bake.slang`: family, hole, passing, group"),
    *_vector("normal", "unit normal, in the frame of the face"),
    *_vector("tangent", "unit fibre direction"),
    ("shown_share", "float", "part of its thread that is on this face around"),
)

BAKE: Fields = (
    ("fabric", "uint", "index of the fabric whose tables of lobes are baked"),
    ("per_family", "uint", "groups of each family, on average"),
    ("packs", "uint", "packs of four groups; even"),
    ("max_clusters", "uint", "most clusters of a family"),
    ("rays", "uint", "view rays, and shadow rays, of each face and node"),
    ("ends", "float", "threads of the warp in the repeat"),
    ("picks", "float", "threads of the weft"),
    ("spacing_x", "float", "width of the repeat / ends"),
    ("spacing_y", "float", "height of the repeat / picks"),
    ("columns", "uint", "nodes of the coverage pyramid's first level"),
    ("rows", "uint", ""),
    ("face_nodes", "uint", "nodes of all levels of a face"),
    ("texels_across", "uint", "texels of a cell around a node"),
    ("texels_along", "uint", ""),
    ("texel_x", "float", "width of a texel"),
    ("texel_y", "float", "height of a texel"),
    ("far_weight", "float", "of nodes one and a half spacings away in a level made from the one below"),
    ("moments_table", "uint", "where the fabric's table of moments begins"),
    ("record_warp_packs", "uint", "word of the buffer of fabrics where the record has its two warp_packs"),
    ("record_hole_weights", "uint", "and its two hole_weights"),
    ("facts", "uint", "where in `scratch`: counts of samples and groups"),
    ("gaps", "uint", "positions in gaps, two numbers each"),
    ("gap_nulls", "uint", "whether rays through gaps pass [nodes, MAX_GAP_RAYS]"),
    ("lit", "uint", "bits of each shadow ray [2 faces, nodes, rays]"),
    ("lists", "uint", "samples of each family, and gaps [5, MAX_SAMPLES_OF_FACE]"),
    ("points", "uint", "points that are clustered [4, CLUSTERED_SAMPLES, FEATURES]"),
    ("clusters", "uint", "clusters of the last split [4, max_clusters, 1 + FEATURES + pairs of them]"),
    ("cluster_means", "uint", "means of k clusters [4, max_clusters, max_clusters, FEATURES]"),
    ("cluster_errors", "uint", "squared errors of k clusters [4, max_clusters]"),
    ("centroids", "uint", "of groups [2 faces, groups, FEATURES]"),
    ("view_sums", "uint", "[2 faces, nodes, groups, VIEW_SUMS]"),
    ("light_sums", "uint", "[2 faces, nodes, groups, LIGHT_SUMS]"),
    ("group_moments", "uint", "[2 faces, groups, MOMENTS]"),
    ("areas", "uint", "projected areas [2 faces, nodes, groups + 1]"),
    ("area_scales", "uint", "largest of them [2 faces, groups + 1]"),
    ("stand_ins", "uint", "whose counts a group has, by byte [2 faces, 4·(packs + 1)]"),
    ("row_totals", "uint", "counts of a row of the first level [rows, 4·(packs + 1)]"),
    ("row_largest", "uint", "largest means of a row [rows, 4·(packs + 1)]"),
    ("coverage_means", "uint", "of the whole repeat [2 faces, 4·(packs + 1)]"),
    ("coverage_scales", "uint", "that a byte of 255 stands for [2 faces, 4·(packs + 1)]"),
    ("hole_bytes", "uint", "a word a node [2 faces, face_nodes]"),
)

# A query of an exported library, `queries.slang`.
QUERY: Fields = (
    ("fabric", "uint", "index of the fabric"),
    *_vector("centre", "of the footprint in draft coordinates, millimetres", _PLANE),
    ("dx_x", "float", "edges of the footprint: steps to the next pixels, millimetres"),
    ("dx_y", "float", ""),
    ("dy_x", "float", ""),
    ("dy_y", "float", ""),
    *_vector("light", "unit vector towards the light, in the frame of the cloth"),
    *_vector("view", "unit vector towards the eye"),
    (
        "seed",
        "uint",
        "0 asks for the value; else the random number of an unbiased estimate, where the model has one, or "
        "the part of what guides denoisers of latent, 1 or 2",
    ),
)


def _of_models() -> dict[str, Fields]:
    """Records of models by name, as their tables declare them."""
    found: dict[str, Fields] = {}
    for shaders in REALTIME_MODELS.values():
        declared = shaders.declared_tables()
        if declared is not None:
            found[declared.record.capitalize()] = declared.record_fields()
    return found


RECORDS: dict[str, Fields] = {
    "Family": FAMILY,
    **_of_models(),
    "Fabric": FABRIC,
    "Plane": PLANE,
    "Light": LIGHT,
    "Frame": FRAME,
    "Vertex": VERTEX,
    "SurfaceHit": SURFACE_HIT,
    "Bake": BAKE,
    "Layer": LAYER,
    "Query": QUERY,
}

# Buffers of group 0 by name: type of an element, whether shaders write it. Their order is their binding.
BUFFERS: dict[str, tuple[str, bool]] = {
    "fabrics": ("Fabric", False),
    "families": ("Family", False),
    "words": ("uint", False),
    "packed_numbers": ("uint4", False),  # networks and latents: eight halves or four singles an element
    "scene_words": ("uint", False),  # hierarchy, meshes, albedo maps, environment, lights: `scene.py`
    "layers": ("Layer", True),  # what each pixel sees of the layer that is shaded
    "visibilities": ("float", True),  # share of each light that reaches each pixel [light, pixel]
    "radiance": ("float4", True),  # sums over passes, and the share of cloth
    "pixels": ("uint", True),  # sRGB, 8 bits a channel
}
# Beside them: what the raster pass saw, and the record of the frame, a uniform. No shader has more than eight
# storage buffers, which is what every adapter of WebGPU binds.
VISIBILITY_BINDING = len(BUFFERS)
FRAME_BINDING = VISIBILITY_BINDING + 1
# Records among the words of a scene, and among those of fabrics.
_SCENE_RECORDS = ("Light", "Vertex")
_WORD_RECORDS = ("Plane",)
# Buffers of the kernels that bake, behind those. `tables` is the buffer of words as kernels write it, and
# `record_words` that of fabrics; `texel_counters` is `texel_counts` while threads add to it.
BAKE_BUFFERS: dict[str, tuple[str, bool]] = {
    "bakes": ("Bake", False),
    "steps": ("uint", False),
    "hits": ("SurfaceHit", True),
    "scratch": ("uint", True),
    "texel_counters": ("Atomic<uint>", True),
    "texel_counts": ("uint", False),
    "coverage_pyramid": ("float4", True),
    "tables": ("uint", True),
    "record_words": ("uint", True),
}
_FIRST_BAKE_BINDING = FRAME_BINDING + 1

_NUMPY = {"float": np.float32, "uint": np.uint32}


def numpy_type(record: str) -> np.dtype[np.void]:
    """The NumPy type of a record, as it lies in a buffer."""
    return np.dtype([(name, _NUMPY.get(kind) or numpy_type(kind)) for name, kind, _ in RECORDS[record]])


def offset_of(record: str, field: str) -> int:
    """Bytes from the beginning of a record to a field."""
    fields = numpy_type(record).fields
    assert fields is not None  # of every structured type
    return int(fields[field][1])


def slang_structs() -> str:
    """Slang structs of all records, and declarations of all buffers."""
    lines: list[str] = []
    for record, fields in RECORDS.items():
        lines += [f"struct {record}", "{"]
        for name, kind, meaning in fields:
            lines.append(f"    {kind} {name};" + (f" // {meaning}" if meaning else ""))
        lines += ["};", ""]
    bindings = [*enumerate(BUFFERS.items()), *enumerate(BAKE_BUFFERS.items(), _FIRST_BAKE_BINDING)]
    for binding, (name, (kind, writable)) in bindings:
        access = "RWStructuredBuffer" if writable else "StructuredBuffer"
        lines.append(f"[[vk::binding({binding}, 0)]] {access}<{kind}> {name};")
    binding = list(BUFFERS).index("packed_numbers")
    lines.append(f"static const uint PACKED_NUMBERS_BINDING = {binding}u;")
    lines.append(f"[[vk::binding({VISIBILITY_BINDING}, 0)]] Texture2D<uint> visible_faces;")
    lines.append(f"[[vk::binding({FRAME_BINDING}, 0)]] ConstantBuffer<Frame> frame_record;")
    for record in _SCENE_RECORDS:
        lines += _reader(record, f"scene_{record.lower()}", "scene_words")
    for record in _WORD_RECORDS:
        lines += _reader(record, f"{record.lower()}_at", "words")
    return "\n".join(lines) + "\n"


def _reader(record: str, function: str, buffer: str) -> list[str]:
    """A Slang function that reads a record from the words of a buffer, of which it begins at `first`."""
    fields = RECORDS[record]
    lines = ["", f"static const uint {record.upper()}_WORDS = {len(fields)}u;", ""]
    lines += [f"{record} {function}(uint first)", "{", f"    {record} record;"]
    for number, (name, kind, _) in enumerate(fields):
        word = f"{buffer}[first + {number}u]"
        lines.append(f"    record.{name} = {word if kind == 'uint' else f'asfloat({word})'};")
    return [*lines, "    return record;", "}"]
