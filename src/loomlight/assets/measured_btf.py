"""Measured BTFs as sources: pictures of a flat sample under many lights and views.

A BTF file's description is TOML:

    btf = "carpet01_resampled_W400xH400_L151xV151.btf"    # UBO 2014, or a ZIP of UBO 2003
    size_mm = [100.0, 100.0]     # of what the pictures show, which is repeated
    cosine_included = true       # the default: pixels are radiance under a lamp, not over its cosine
    gain = 1.0                   # pixels are multiplied by it; 1 is a white diffuser

Measurements are large and often not free to pass on: a `.loom` names the file and its SHA-256 instead of
holding it. Only baking again needs the file, beside the `.loom`.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path, PurePath
from typing import Annotated, Any, ClassVar

from numpy.typing import NDArray
from pydantic import BaseModel, ConfigDict, Field

from loomlight.assets.btf_files import BtfPictures, read_btf
from loomlight.assets.toml_source import Lengths, SizedSource, SourceFields, has_field, read_fields
from loomlight.core.errors import InputError
from loomlight.core.files import require_file
from loomlight.core.sentences import shown, speaking_of

_FIELD = "btf"

_Gain = Annotated[float, Field(gt=0, le=1e6)]


class _Record(BaseModel):
    """The header of a measured BTF in a `.loom` file."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, allow_inf_nan=False)

    name: str
    file: str
    sha256: Annotated[str, Field(pattern="^[0-9a-f]{64}$")]
    size_mm: Lengths
    cosine_included: bool
    gain: _Gain


class _File(SourceFields):
    """The fields of a BTF's description."""

    noun = "a BTF"
    expected: ClassVar[Mapping[str, str]] = {
        "btf": "the name of a .btf or .zip in quotes",
        "size_mm": "two lengths above 0, such as [100.0, 100.0]",
        "cosine_included": "true or false",
        "gain": "a number above 0, such as 1.0",
    }

    btf: str
    size_mm: Lengths
    cosine_included: bool = True
    gain: _Gain = 1.0


@dataclass(frozen=True, eq=False)
class MeasuredBtf(SizedSource):
    """Pictures of a sample, in a file of their own.

    Attributes:
        name: in messages.
        path: of the file.
        sha256: of the file, hexadecimal.
        size_mm: width and height of what the pictures show, millimetres.
        cosine_included: whether pixels hold the cosine of the light.
        gain: that pixels are multiplied by.
    """

    name: str
    path: Path
    sha256: str
    size_mm: tuple[float, float]
    cosine_included: bool
    gain: float

    def pictures(self) -> BtfPictures:
        """The pictures.

        Raises:
            InputError: the file is missing, damaged, or another one than was described.
        """
        require_file(self.path)
        if _sha256(self.path) != self.sha256:
            raise InputError(f"{self.path} is another file than the one that {self.name} was made from.")
        return read_btf(self.path)


def is_btf_description(path: str | os.PathLike[str]) -> bool:
    """Whether a path is a TOML file that names a BTF."""
    return has_field(path, _FIELD)


def load_measured_btf(path: str | os.PathLike[str]) -> MeasuredBtf:
    """The measured BTF of a description; its pictures are read when they are asked for.

    Raises:
        InputError: no such file, an unknown field, or a value that cannot be; it is named.
    """
    file = Path(path)
    with speaking_of(str(file)):
        fields = read_fields(file, _File)
        held = file.parent / fields.btf
        with speaking_of(f"btf = {shown(fields.btf)}"):
            require_file(held)
        width, height = fields.size_mm
        return MeasuredBtf(
            fields.name or file.stem,
            held,
            _sha256(held),
            (width, height),
            fields.cosine_included,
            fields.gain,
        )


def _sha256(path: Path) -> str:
    try:
        with path.open("rb") as stream:
            return hashlib.file_digest(stream, "sha256").hexdigest()
    except OSError as error:
        raise InputError(f"{path} cannot be read: {error.strerror or error}.") from error


def measured_btf_record(source: MeasuredBtf) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """The record of a measured BTF, as JSON; it has no tensors."""
    record = _Record(
        name=source.name,
        file=source.path.name,
        sha256=source.sha256,
        size_mm=list(source.size_mm),
        cosine_included=source.cosine_included,
        gain=source.gain,
    )
    return record.model_dump(), {}


def measured_btf_from_record(
    record: Mapping[str, Any], tensors: Mapping[str, NDArray[Any]], folder: str
) -> MeasuredBtf:
    """The measured BTF of a record, whose file lies in `folder` if it is anywhere.

    Raises:
        ValidationError: another record than `measured_btf_record` makes.
    """
    del tensors
    header = _Record.model_validate(record)
    width, height = header.size_mm
    file = Path(folder) / PurePath(header.file).name
    return MeasuredBtf(header.name, file, header.sha256, (width, height), header.cosine_included, header.gain)
