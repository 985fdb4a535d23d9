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

from loomlight.core.colour_difference import linear_of_xyz_ratio
from loomlight.core.errors import InputError
from loomlight.core.files import require_file

SPECTRUM_SUFFIXES = (".csv", ".cxf", ".xml")
# Wavelengths of the tables, nm.
_WAVELENGTHS = np.arange(380, 781, 10)
# fmt: off
_D65 = np.array((
    49.9755, 54.6482, 82.7549, 91.486, 93.4318, 86.6823, 104.865, 117.008, 117.812, 114.861, 115.923,
    108.811, 109.354, 107.802, 104.79, 107.689, 104.405, 104.046, 100, 96.3342, 95.788, 88.6856, 90.0062,
    89.5991, 87.6987, 83.2886, 83.6992, 80.0268, 80.2146, 82.2778, 78.2842, 69.7213, 71.6091, 74.349,
    61.604, 69.8856, 75.087, 63.5927, 46.4182, 66.8054, 63.3828,
))
_OBSERVER = np.array((
    (
    0.001368, 0.004243, 0.01431, 0.04351, 0.13438, 0.2839, 0.34828, 0.3362, 0.2908, 0.19536, 0.09564,
    0.03201, 0.0049, 0.0093, 0.06327, 0.1655, 0.2904, 0.43345, 0.5945, 0.7621, 0.9163, 1.0263, 1.0622,
    1.0026, 0.85445, 0.6424, 0.4479, 0.2835, 0.1649, 0.0874, 0.04677, 0.0227, 0.011359, 0.00579, 0.002899,
    0.00144, 0.00069, 0.000332, 0.000166, 0.000083, 0.000042,
    ),
    (
    0.000039, 0.00012, 0.000396, 0.00121, 0.004, 0.0116, 0.023, 0.038, 0.06, 0.09098, 0.13902, 0.20802,
    0.323, 0.503, 0.71, 0.862, 0.954, 0.99495, 0.995, 0.952, 0.87, 0.757, 0.631, 0.503, 0.381, 0.265, 0.175,
    0.107, 0.061, 0.032, 0.017, 0.00821, 0.004102, 0.002091, 0.001047, 0.00052, 0.000249, 0.00012, 0.00006,
    0.00003, 0.000015,
    ),
    (
    0.00645, 0.02005, 0.06785, 0.2074, 0.6456, 1.3856, 1.74706, 1.77211, 1.6692, 1.28764, 0.81295, 0.46518,
    0.272, 0.1582, 0.07825, 0.04216, 0.0203, 0.00875, 0.0039, 0.0021, 0.00165, 0.0011, 0.0008, 0.00034,
    0.00019, 0.00005, 0.00002, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    ),
))
# fmt: on
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
