"""Messages between the editor's page and Python: drafts, fabrics and the session as JSON, declared once.

`web/fabric/src/messages.ts` is generated from it (`python -m tools.generate.shaders --web`). A drawdown
is base64 of its bits, row by row (a row is a pick) without padding between rows, the first bit highest, 1
where the warp is on top. Colours are linear RGB, lengths millimetres; what a draft does not say is null.
"""

from __future__ import annotations

import base64
from collections.abc import Mapping, Sequence
from typing import Annotated, Any, TypeVar

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel, ConfigDict, Field, ValidationError

from loomlight.core.errors import InputError
from loomlight.core.sentences import speaking_of
from loomlight.fabric.fabric import Fabric, make_fabric
from loomlight.fabric.read import picture_of_artwork, validate_fields
from loomlight.fabric.resolve import MAXIMUM_CROSSINGS
from loomlight.weave.draft import MAXIMUM_THREADS, Draft, LoomPlan, Threads

# Characters of a name; millimetres of a thread.
MAX_NAME = 500
LENGTH_MM = (1e-6, 1e6)
# As many shafts as there may be threads: a derived plan can need one for each.
Number = Annotated[int, Field(ge=0, le=MAXIMUM_THREADS)]
Count = Annotated[int, Field(ge=1, le=MAXIMUM_THREADS)]
Unit = Annotated[float, Field(ge=0, le=1)]
Length = Annotated[float, Field(ge=LENGTH_MM[0], le=LENGTH_MM[1])]
Name = Annotated[str, Field(max_length=MAX_NAME)]
Sets = list[list[Count]]
JsonObject = dict[str, Any]


class Json(BaseModel):
    """Base of what a page sends: unknown keys are passed over, NaN is an error."""

    model_config = ConfigDict(extra="ignore", frozen=True, allow_inf_nan=False)


Kind = TypeVar("Kind", bound=Json)


class ThreadsJson(Json):
    """Linear RGB in [0, 1] and millimetres of each thread; null where the draft does not say."""

    colors: list[tuple[Unit, Unit, Unit]] | None = None
    spacing_mm: list[Length] | None = None
    thickness_mm: list[Length] | None = None
    color_index: Annotated[
        list[Number] | None,
        Field(
            description="Row of the draft's palette; a list of as many colours replaces them in this order."
        ),
    ] = None


class LoomJson(Json):
    """Shafts of each end, shafts of each treadle, treadles and shafts of each pick; numbers from 1."""

    shafts: Number
    treadles: Number = 0
    rising_shed: bool = True
    threading: Sets
    tieup: Sets | None = None
    treadling: Sets | None = None
    liftplan: Sets | None = None


class DraftJson(Json):
    """A draft; `drawdown` is base64 of its bits, row by row without padding, the first bit highest."""

    name: Name = ""
    ends: Count
    picks: Count
    drawdown: str
    warp: ThreadsJson = ThreadsJson()
    weft: ThreadsJson = ThreadsJson()
    loom: LoomJson | None = None


class DrawnJson(Json):
    """A drawdown that [weaves] of an artwork names, a draft's file; `drawdown` as in a draft."""

    name: str
    ends: Count
    picks: Count
    drawdown: str


class ArtworkJson(Json):
    """The picture of a fabric whose colours are weaves, and the drafts' files among these."""

    ends: Count
    rows: Count
    colours: Annotated[list[str], Field(description='"#rrggbb".')]
    runs: Annotated[
        str,
        Field(
            description="Which colour each pixel has, the bottom row first: base64 of runs, a byte of the "
            "colour and the length in groups of 7 bits, the lowest first, all but the last with a high bit."
        ),
    ]
    drafts: list[DrawnJson]


class FabricJson(Json):
    """A fabric: the keys of a fabric file, and the draft that they name, before they colour and repeat it."""

    name: Name = ""
    fields: JsonObject
    draft: DraftJson


class GalleryEntry(FabricJson):
    """A fabric that comes with the editor."""

    id: str
    description: str
    picture: Annotated[str | None, Field(description="A picture of 320 pixels a side, relative to the page.")]


class Session(Json):
    """What a page begins with."""

    version: int
    has_python: Annotated[bool, Field(description="Whether a server answers the page.")]
    token: Annotated[str | None, Field(description="That the page must send to that server.")]
    fabric: FabricJson
    artwork: Annotated[ArtworkJson | None, Field(description="The picture of which the fabric is woven.")]
    gallery: list[GalleryEntry]
    largest_upload: Annotated[int, Field(description="Largest file that the server reads, bytes.")]


class CaptureJson(Json):
    """A fabric that a photograph shows, and how well it is known."""

    fabric: FabricJson
    summary: Annotated[str, Field(description="Weave, setts and kind of yarn in a line.")]
    doubts: Annotated[list[str], Field(description="Sentences on what cannot be relied on.")]
    unfixed: Annotated[
        list[str],
        Field(
            description="Fields that the photograph does not fix, and the kind of yarn does: warp.roughness."
        ),
    ]


class CaptureLine(Json):
    """A line of the answer to a photograph: how far the work is, 0 to 1, and in the last what it came to."""

    share: float
    found: CaptureJson | None = None
    error: Annotated[str | None, Field(description="A sentence, where there is no fabric.")] = None


def draft_json(draft: Draft) -> JsonObject:
    """A draft as JSON; notes and private sections of a WIF are left out."""
    return {
        "name": draft.title,
        "ends": draft.ends,
        "picks": draft.picks,
        "drawdown": base64.b64encode(np.packbits(draft.drawdown).tobytes()).decode(),
        "warp": _threads_json(draft.warp),
        "weft": _threads_json(draft.weft),
        "loom": None if draft.loom is None else _loom_json(draft.loom),
    }


def draft_of_json(values: Mapping[str, Any]) -> Draft:
    """The draft of JSON.

    Raises:
        InputError: values of another type or range, or lists that do not fit the drawdown.
    """
    return draft_of(validated(DraftJson, values))


def draft_of(given: DraftJson) -> Draft:
    """The draft of valid JSON; see `draft_of_json`."""
    return Draft(
        drawdown=_drawdown(given),
        warp=_threads("warp", given.warp, given.ends),
        weft=_threads("weft", given.weft, given.picks),
        title=" ".join(given.name.split()),
        loom=None if given.loom is None else _loom(given.loom, given.ends, given.picks),
    )


def validated(kind: type[Kind], values: Mapping[str, Any]) -> Kind:
    """Values as what a page sends; raises InputError, which names the first fault."""
    try:
        return kind.model_validate(values)
    except ValidationError as error:
        fault = error.errors(include_url=False)[0]
        place = ".".join(str(part) for part in fault["loc"]) or "the request"
        raise InputError(f"{place} cannot be used: {fault['msg']}.") from error


def _threads_json(threads: Threads) -> JsonObject:
    given = {name: getattr(threads, name) for name in ThreadsJson.model_fields}
    return {name: None if values is None else values.tolist() for name, values in given.items()}


def _loom_json(loom: LoomPlan) -> JsonObject:
    sets = {name: _lists(getattr(loom, name)) for name in ("threading", "tieup", "treadling", "liftplan")}
    return {"shafts": loom.shafts, "treadles": loom.treadles, "rising_shed": loom.rising_shed} | sets


def _lists(sets: Sequence[frozenset[int]] | None) -> list[list[int]] | None:
    return None if sets is None else [sorted(numbers) for numbers in sets]


def _drawdown(given: DraftJson) -> NDArray[np.bool_]:
    count = given.ends * given.picks
    if count > MAXIMUM_CROSSINGS:
        # Before a byte is unpacked: no fabric can be made of it.
        raise InputError(
            f"draft has {given.ends} ends and {given.picks} picks, {count:,} crossings: a fabric has at most "
            f"{MAXIMUM_CROSSINGS:,}."
        )
    try:
        packed = np.frombuffer(base64.b64decode(given.drawdown, validate=True), np.uint8)
    except ValueError as error:  # characters that are none of ASCII, too
        raise InputError(f"draft.drawdown is no base64: {error}.") from error
    if packed.size != (count + 7) // 8:
        raise InputError(
            f"draft.drawdown holds {packed.size} bytes, where {given.ends} ends and {given.picks} picks take "
            f"{(count + 7) // 8}."
        )
    return np.unpackbits(packed, count=count).astype(np.bool_).reshape(given.picks, given.ends)


def _threads(family: str, given: ThreadsJson, count: int) -> Threads:
    for name in ThreadsJson.model_fields:
        listed = getattr(given, name)
        if listed is not None and len(listed) != count:
            raise InputError(
                f"draft.{family}.{name} holds {len(listed)} threads, where the draft has {count}."
            )
    return Threads(
        colors=None if given.colors is None else np.array(given.colors, np.float64),
        spacing_mm=None if given.spacing_mm is None else np.array(given.spacing_mm, np.float64),
        thickness_mm=None if given.thickness_mm is None else np.array(given.thickness_mm, np.float64),
        color_index=None if given.color_index is None else np.array(given.color_index, np.intp),
    )


def _loom(given: LoomJson, ends: int, picks: int) -> LoomPlan:
    # How many sets there are, and the largest number of them.
    bounds = {
        "threading": (ends, given.shafts),
        "tieup": (given.treadles, given.shafts),
        "treadling": (picks, given.treadles),
        "liftplan": (picks, given.shafts),
    }
    sets: dict[str, tuple[frozenset[int], ...] | None] = {}
    for name, (length, most) in bounds.items():
        listed: Sets | None = getattr(given, name)
        if listed is not None and (
            len(listed) != length or any(number > most for row in listed for number in row)
        ):
            raise InputError(f"draft.loom.{name} must list {length} sets of numbers from 1 to {most}.")
        sets[name] = None if listed is None else tuple(frozenset(row) for row in listed)
    return LoomPlan(
        threading=sets["threading"] or (),
        shafts=given.shafts,
        treadles=given.treadles,
        **{name: sets[name] for name in ("tieup", "treadling", "liftplan")},
        rising_shed=given.rising_shed,
    )


# ---------------------------------------------------------------------------------------------------- fabrics
# Fabrics as JSON: keys of a fabric file, and the draft that they name before they colour and repeat it.


def fabric_json(fabric: Fabric) -> JsonObject:
    """A fabric as JSON; fields are without defaults."""
    fields = fabric.fields.model_dump(exclude_none=True)
    return {
        "name": fabric.name,
        "fields": {key: value for key, value in fields.items() if value != {}},
        "draft": draft_json(fabric.named_draft),
    }


def artwork_json(fabric: Fabric) -> JsonObject | None:
    """The picture of a fabric whose colours are weaves as JSON, see `ArtworkJson`; None of another fabric.

    None too where the picture is not at hand, or is no more the one that was woven: a `.loom` has none.
    """
    if not fabric.fields.weaves:
        return None
    try:
        picture = picture_of_artwork(fabric.fields, fabric.folder)
    except InputError:
        return None
    if picture.index.shape[1] != fabric.named_draft.ends:
        return None
    drafts = [
        {
            "name": name,
            "ends": drawn.shape[1],
            "picks": drawn.shape[0],
            "drawdown": base64.b64encode(np.packbits(drawn).tobytes()).decode(),
        }
        for name, drawn in picture.drafts.items()
    ]
    rows, ends = picture.index.shape
    runs = base64.b64encode(_runs(picture.index.ravel())).decode()
    return {"ends": ends, "rows": rows, "colours": list(picture.colours), "runs": runs, "drafts": drafts}


def _runs(values: NDArray[np.uint8]) -> bytes:
    """Runs of equal values as `ArtworkJson` has them."""
    first = np.flatnonzero(np.diff(values.astype(np.int16), prepend=-1))
    lengths = np.diff(first, append=len(values))
    # Groups of 7 bits, up to the one above which nothing of the length is left.
    groups = np.stack([lengths >> shift for shift in range(0, 35, 7)], axis=1)
    is_used = np.concatenate([np.ones((len(first), 2), np.bool_), groups[:, 1:] > 0], axis=1)
    coded = np.where(groups < 128, groups, (groups & 127) | 128)
    return np.concatenate([values[first, None], coded], axis=1).astype(np.uint8)[is_used].tobytes()


def fabric_of_json(values: Mapping[str, Any]) -> Fabric:
    """The fabric of JSON; no file is read, whatever paths are among the fields.

    Raises:
        InputError: fields or a draft that make no fabric; the message names the one at fault.
    """
    given = validated(FabricJson, values)
    with speaking_of("the fabric"):
        fields = validate_fields(given.fields)
        draft = draft_of(given.draft)
        return make_fabric(fields, draft, fields.name or given.name or draft.title or "fabric", ".")


# ------------------------------------------------------------------------------------------ openness of yarns
# What a page asks Python about a fabric's yarns: their openness, and joint visibility of light and view.


def openness_json(fabric: Fabric) -> dict[str, list[float]]:
    """Flat lists by name: the tables of `Openness`, joint visibility, and how many layers the cloth has.

    "joint" has the words of `LobeTables.joint`, "planes" one number. All depend on where yarns lie, on
    roughness, optical depth and the diffuse blend alone, whatever the colours are and whether or not the
    fields ask for light between yarns.

    Raises:
        MissingDependencyError: no usable LLVM library.
    """
    from loomlight.core.llvm import llvm_float, require_llvm

    require_llvm()
    from loomlight.models.lobes.model import DEFAULT_GROUPS
    from loomlight.models.lobes.tables import bake_joint
    from loomlight.realtime.words import packed_bytes
    from loomlight.scattering.openness import openness_of
    from loomlight.yarn.stack import cloth_geometry

    appearance = fabric.appearance()
    openness = appearance.openness
    if openness is None:
        roughness = appearance.warp.roughness, appearance.weft.roughness
        openness = openness_of(fabric.layout(), appearance.diffuse_blend, roughness, appearance.optical_depth)
    geometry = cloth_geometry(fabric.layout())
    joint = bake_joint(geometry, appearance.diffuse_blend, DEFAULT_GROUPS, llvm_float())
    lists = {name: part.ravel().tolist() for name, part in openness.all_tables().items()}
    planes = [fabric.layout().depth]
    return lists | {"joint": packed_bytes(joint).tolist(), "planes": planes}
