"""Colours of measured reflectances: CIE 1931 2° observer under D65 (CIE 15:2018), as linear RGB.

Spectrophotometers write CSV, two columns of nanometres and reflectance, or CxF3 (ISO 17972-1), an XML file
of objects. The tables have steps of 10 nm, as textile laboratories measure; reflectances are interpolated
linearly in between, and the ends go on flat to 380 and 780 nm.
"""

from __future__ import annotations

import csv
import os
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
from numpy.typing import ArrayLike, NDArray

from loomlight.core.colour import linear_of_xyz_ratio
from loomlight.core.errors import InputError
from loomlight.core.files import require_file

SPECTRUM_SUFFIXES = (".csv", ".cxf", ".xml")
# Wavelengths in nm, the illuminant, and the observer [3, n].
_TABLE = np.loadtxt(Path(__file__).with_name("cie1931.csv"), delimiter=",", skiprows=1).T
_WAVELENGTHS, _D65, _OBSERVER = _TABLE[0], _TABLE[1], _TABLE[2:]
# Wavelengths that a measurement has to span, nm.
_NEEDED = 430, 680
# Larger values are percentages: no reflectance of cloth is above 2, fluorescence included.
_MAX_SHARE = 2.0
_MAX_BYTES = 10_000_000


def is_spectrum(value: object) -> bool:
    """Whether a colour is written as the file of a measurement, "navy.csv" or "book.cxf#navy"."""
    return isinstance(value, str) and Path(_parted(value)[0]).suffix.lower() in SPECTRUM_SUFFIXES


def linear_of_reflectance(wavelengths_nm: ArrayLike, reflectance: ArrayLike) -> NDArray[np.float64]:
    """Linear RGB [3] of reflectances [n] at rising wavelengths [n]; components may lie outside 0 to 1."""
    measured = np.interp(_WAVELENGTHS, np.asarray(wavelengths_nm), np.asarray(reflectance, np.float64))
    weights = _OBSERVER * _D65
    return linear_of_xyz_ratio(weights @ measured / weights.sum(axis=1))


def read_spectrum(value: str, folder: str | os.PathLike[str], field: str) -> NDArray[np.float64]:
    """Linear RGB [3] of a measurement's file; components may lie outside 0 to 1.

    Args:
        value: path relative to `folder`; the name of one of several objects of a CxF file follows a "#".
        field: what messages name.

    Raises:
        InputError: no such file or object, or no spectrum of visible light.
    """
    name, wanted = _parted(value)
    path = Path(folder, name)
    require_file(path)
    if path.stat().st_size > _MAX_BYTES:
        raise InputError(
            f"{field}: {path} has more than {_MAX_BYTES // 1_000_000} MB, which no spectrum has."
        )
    is_csv = path.suffix.lower() == ".csv"
    wavelengths, reflectance = _of_csv(path, field) if is_csv else _of_cxf(path, wanted, field)
    if reflectance.max() > _MAX_SHARE:
        reflectance = reflectance / 100
    if not (np.isfinite(reflectance).all() and (reflectance >= 0).all() and (reflectance <= 2).all()):
        raise InputError(f"{field}: {path} holds values that are no reflectances: 0 to 1, or 0 to 100 %.")
    if not (np.diff(wavelengths) > 0).all() or wavelengths[0] > _NEEDED[0] or wavelengths[-1] < _NEEDED[1]:
        raise InputError(
            f"{field}: {path} measures {wavelengths[0]:g} to {wavelengths[-1]:g} nm: a colour needs rising "
            f"wavelengths from {_NEEDED[0]} nm or less to {_NEEDED[1]} nm or more."
        )
    return linear_of_reflectance(wavelengths, reflectance)


def _parted(value: str) -> tuple[str, str]:
    name, _, wanted = value.partition("#")
    return name.strip(), wanted.strip()


def _of_csv(path: Path, field: str) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Columns of wavelengths and reflectances; rows that do not begin with a number are headings."""
    try:
        text = path.read_text(encoding="utf-8-sig")
        separator = ";" if ";" in text else "\t" if "\t" in text else ","
        rows = [row for row in csv.reader(text.splitlines(), delimiter=separator) if len(row) >= 2]
    except (UnicodeDecodeError, csv.Error) as error:
        raise InputError(f"{field}: {path} is no text of comma-separated values.") from error
    decimal = "," if separator == ";" else "."
    found = [
        [_number(part, decimal) for part in row[:2]] for row in rows if _number(row[0], decimal) is not None
    ]
    if len(found) < 2 or any(part is None for row in found for part in row):
        raise InputError(
            f"{field}: {path} holds no spectrum: write rows of a wavelength in nm and a reflectance."
        )
    table = np.array(found, np.float64)
    return table[:, 0], table[:, 1]


def _number(text: str, decimal: str) -> float | None:
    try:
        return float(text.strip().replace(decimal, ".").rstrip("%"))
    except ValueError:
        return None


def _of_cxf(path: Path, wanted: str, field: str) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The reflectance spectrum of one object of a CxF3 file."""
    try:
        root = ElementTree.parse(path).getroot()
    except ElementTree.ParseError as error:
        raise InputError(f"{field}: {path} is no XML, which CxF files are.") from error
    spectra = {
        parent.get("Name") or parent.get("Id") or "": element
        for parent in _named(root, "Object")
        for element in _named(parent, "ReflectanceSpectrum")
    }
    if wanted and wanted not in spectra:
        known = ", ".join(list(spectra)[:5]) or "none"
        raise InputError(f'{field}: {path} holds no object "{wanted}" with a spectrum: it has {known}.')
    if not spectra or (not wanted and len(spectra) > 1):
        known = "none" if not spectra else ", ".join(list(spectra)[:5])
        raise InputError(
            f'{field}: {path} must hold one spectrum, or a name follows the file, "book.cxf#navy": it has '
            f"{known}."
        )
    element = spectra[wanted] if wanted else next(iter(spectra.values()))
    specifications = {part.get("Id"): part for part in _named(root, "ColorSpecification")}
    specification = specifications.get(element.get("ColorSpecification"))
    ranges = [] if specification is None else _named(specification, "WavelengthRange")
    start = element.get("StartWL") or (ranges[0].get("StartWL") if ranges else None)
    step = ranges[0].get("Increment") if ranges else None
    try:
        values = np.array([float(part) for part in (element.text or "").split()], np.float64)
        first, increment = float(start or "nan"), float(step or "10")
    except ValueError as error:
        raise InputError(f"{field}: {path} holds a spectrum that is not made of numbers.") from error
    if len(values) < 2 or not np.isfinite(first) or not increment > 0:
        raise InputError(f"{field}: {path} holds a spectrum without values, StartWL or Increment.")
    return np.asarray(first + increment * np.arange(len(values)), np.float64), values


def _named(root: ElementTree.Element, name: str) -> list[ElementTree.Element]:
    """Elements of a local name, in whatever namespace."""
    return [element for element in root.iter() if str(element.tag).rpartition("}")[2] == name]
