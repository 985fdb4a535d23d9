"""Fabrics as JSON: keys of a fabric file, and the draft that they name before they colour and repeat it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any

from pydantic import Field

from loomlight.core.sentences import speaking_of
from loomlight.fabric.fabric import Fabric, make_fabric
from loomlight.fabric.read import validate_fields
from loomlight.viewer.draft_json import DraftJson, Json, JsonObject, draft_json, draft_of, validated


class FabricJson(Json):
    """A fabric, as a page sends it."""

    name: Annotated[str, Field(max_length=500)] = ""
    fields: JsonObject
    draft: DraftJson


def fabric_json(fabric: Fabric) -> JsonObject:
    """A fabric as JSON; fields are without defaults."""
    fields = fabric.fields.model_dump(exclude_none=True)
    return {
        "name": fabric.name,
        "fields": {key: value for key, value in fields.items() if value != {}},
        "draft": draft_json(fabric.named_draft),
    }


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
