"""Colours of measured reflectances, in CSV and CxF3."""

from pathlib import Path

import numpy as np
import pytest

from loomlight.core.errors import InputError
from loomlight.core.spectra import is_spectrum, linear_of_reflectance, read_spectrum

WAVELENGTHS = np.arange(380, 731, 10)
# A dye that absorbs around 600 nm: a blue.
BLUE = 0.6 - 0.5 * np.exp(-(((WAVELENGTHS - 600) / 70.0) ** 2))

CXF = """<?xml version="1.0"?>
<cc:CxF xmlns:cc="http://colorexchangeformat.com/CxF3-core"><cc:Resources><cc:ObjectCollection>
{objects}
</cc:ObjectCollection><cc:ColorSpecificationCollection><cc:ColorSpecification Id="d8"><cc:MeasurementSpec>
<cc:WavelengthRange StartWL="380" Increment="10"/></cc:MeasurementSpec></cc:ColorSpecification>
</cc:ColorSpecificationCollection></cc:Resources></cc:CxF>"""
OBJECT = """<cc:Object Name="{name}" Id="{name}"><cc:ColorValues>
<cc:ReflectanceSpectrum ColorSpecification="d8" StartWL="380">{values}</cc:ReflectanceSpectrum>
</cc:ColorValues></cc:Object>"""


def cxf(**spectra: np.ndarray) -> str:
    return CXF.format(
        objects="".join(
            OBJECT.format(name=name, values=" ".join(map(str, values))) for name, values in spectra.items()
        )
    )


def test_grey_is_grey_and_brightness_is_linear() -> None:
    assert linear_of_reflectance([380, 730], [0.18, 0.18]) == pytest.approx([0.18] * 3, abs=1e-6)
    red, green, blue = linear_of_reflectance(WAVELENGTHS, BLUE)
    assert blue > green > red
    assert linear_of_reflectance(WAVELENGTHS, 0.5 * BLUE) == pytest.approx(np.array([red, green, blue]) / 2)


@pytest.mark.parametrize(
    ("separator", "decimal", "scale"), [(",", ".", 1), (";", ",", 100), ("\t", ".", 100)]
)
def test_csv_is_read_as_programs_write_it(tmp_path: Path, separator: str, decimal: str, scale: float) -> None:
    rows = [
        f"{w}{separator}{scale * r:.6f}".replace(".", decimal) for w, r in zip(WAVELENGTHS, BLUE, strict=True)
    ]
    (tmp_path / "blue.csv").write_text("\n".join([f"nm{separator}R", *rows]))
    expected = linear_of_reflectance(WAVELENGTHS, BLUE)
    # Six digits are written.
    assert read_spectrum("blue.csv", tmp_path, "warp.color") == pytest.approx(expected, abs=1e-5)


def test_cxf_is_read_by_the_name_of_an_object(tmp_path: Path) -> None:
    (tmp_path / "book.cxf").write_text(cxf(blue=BLUE, grey=np.full(len(BLUE), 0.3)))
    assert is_spectrum("book.cxf#grey")
    assert not is_spectrum("#203040")
    assert read_spectrum("book.cxf#grey", tmp_path, "warp.color") == pytest.approx([0.3] * 3, abs=1e-6)
    expected = linear_of_reflectance(WAVELENGTHS, BLUE)
    assert read_spectrum("book.cxf#blue", tmp_path, "warp.color") == pytest.approx(expected)


@pytest.mark.parametrize(
    ("name", "text", "sentence"),
    [
        ("a.csv", "nm,R\n", "holds no spectrum"),
        ("a.csv", "400,0.1\n500,0.2\n", "measures 400 to 500 nm"),
        ("a.csv", "700,0.1\n400,0.2\n", "measures 700 to 400 nm"),
        ("a.csv", "400,0.1\n700,-0.2\n", "no reflectances"),
        ("a.cxf", "no xml", "is no XML"),
        ("a.cxf", cxf(), "it has none"),
        ("a.cxf", cxf(one=BLUE, two=BLUE), "it has one, two"),
        ("a.cxf#three", cxf(one=BLUE), 'no object "three"'),
    ],
)
def test_faults_are_one_sentence(tmp_path: Path, name: str, text: str, sentence: str) -> None:
    (tmp_path / name.partition("#")[0]).write_text(text)
    with pytest.raises(InputError, match=r"weft\.color") as fault:
        read_spectrum(name, tmp_path, "weft.color")
    assert sentence in str(fault.value)
