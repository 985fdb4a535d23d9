"""Scene text of Mitsuba that reads nothing but the files held beside it.

Mitsuba's scenes can name files in many ways: attributes, parameters, other scenes, names of metals. Text that
is kept in a `.loom`, and may come from anyone, is limited to lists of elements, attributes and plugins. What
names a file is `<string name="filename">` alone, and the file must be one that is held.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection
from pathlib import Path, PurePosixPath
from xml.etree import ElementTree

from loomlight.core.errors import InputError
from loomlight.core.files import read_text
from loomlight.core.sentences import closest, shown

# Characters that no name of a file has on all systems: controls, lone surrogates, drives and backslashes.
NO_FILE_CHARACTER = re.compile(r"[\x00-\x1f\x7f\ud800-\udfff\\:]")
_LONGEST_NAME = 200
_DEEPEST = 80
# Characters of a value in which parameters were put.
_LONGEST_VALUE = 1 << 20


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


_TEXTURES = _words(
    "bitmap blackbody checkerboard d65 irregular mesh_attribute rawconstant regular srgb uniform volume"
)
# Plugins by the element that makes them. Those that loomlight registers read fabrics, and are left out.
_PLUGINS = {
    "bsdf": _words(
        "blendbsdf bumpmap circular conductor dielectric diffuse hair mask measured measured_polarized "
        "normalmap null plastic polarizer pplastic principled principledthin retarder roughconductor "
        "roughdielectric roughplastic thindielectric twosided"
    ),
    "emitter": _words(
        "area constant directional directionalarea envmap point projector spot sunsky timed_sunsky"
    ),
    "medium": _words("heterogeneous homogeneous"),
    "phase": _words("blendphase hg isotropic rayleigh sggx tabphase"),
    "shape": _words(
        "bsplinecurve cube cylinder disk ellipsoids ellipsoidsmesh instance linearcurve merge obj ply "
        "rectangle sdfgrid serialized shapegroup sphere"
    ),
    "spectrum": _TEXTURES,
    "texture": _TEXTURES,
    "volume": _words("constvolume gridvolume"),
}
_OBJECT = frozenset(("type", "id", "name", "version"))
_VALUE = frozenset(("name", "id", "value"))
_AXES = frozenset(("x", "y", "z", "value"))
_ATTRIBUTES = {
    **dict.fromkeys(_PLUGINS, _OBJECT),
    **dict.fromkeys(("boolean", "float", "integer", "rgb", "string"), _VALUE),
    **dict.fromkeys(("point", "vector"), _VALUE | _AXES),
    **dict.fromkeys(("scale", "translate"), _AXES),
    "alias": frozenset(("id", "as")),
    "lookat": frozenset(("origin", "target", "up")),
    "matrix": frozenset(("value",)),
    "ref": frozenset(("id", "name")),
    "rotate": _AXES | {"angle"},
    "scene": frozenset(("version",)),
    "spectrum": _OBJECT | {"value"},
    "transform": frozenset(("id", "name")),
}
# Names, of which none is a file's; types are in lists.
_NAMES = frozenset(("as", "id", "name", "type"))
# Numbers, colours (#aa0000), true and false; words such as "fused quartz". Neither can be a path.
_NUMBERS = re.compile(r"[#\dA-Za-z.,:+\s-]*")
_WORDS = re.compile(r"[\w +-]{0,64}", re.ASCII)
_LIST = re.compile(r"[\deE.,+\s-]*", re.ASCII)
# Metals that Mitsuba knows, some of them as "Au_palik" too: it opens a file of each by its name.
_METALS = _words(
    "a-C Ag Al AlAs AlSb Au Be Cr CsI Cu Cu2O CuO d-C Hg HgTe Ir K Li MgO Mo Na Nb Ni none Rh Se Se-e "
    "SiC SnTe Ta Te Te-e ThF4 TiC TiN TiO2 TiO2-e V VC VN W"
)


def parsed_text(text: str) -> ElementTree.Element:
    """The root of a scene's XML, with its parameters (`<default>`) put in.

    Raises:
        InputError: no XML, a DOCTYPE, an included file, or a parameter that it does not define.
    """
    # Entities of a DOCTYPE could grow without bound.
    if "<!DOCTYPE" in text or "<!ENTITY" in text:
        raise InputError("it holds a DOCTYPE, which no Mitsuba file needs: leave it out.")
    try:
        root = ElementTree.fromstring(text)
    except (ElementTree.ParseError, ValueError) as error:
        raise InputError(f"it is no valid XML: {error}.") from error
    for element in root.iter("include"):
        raise InputError(f"it includes {shown(element.get('filename'))}: write all of it into one file.")
    values = {element.get("name", ""): element.get("value", "") for element in root.iter("default")}
    # Longer names first: $size_x begins with $size.
    parameters = sorted(filter(None, values), key=len, reverse=True)
    for element in root.iter():
        for key, value in element.attrib.items():
            for parameter in parameters if "$" in value else ():
                value = value.replace(f"${parameter}", values[parameter])
                if len(value) > _LONGEST_VALUE:
                    raise InputError(f"its parameter {shown(parameter)} makes a value too long.")
            element.set(key, value)
    without(root, ("default",))
    return root


def without(root: ElementTree.Element, tags: Collection[str]) -> None:
    """Removes elements with these tags, and all inside them."""
    for outer in list(root.iter()):
        for element in [child for child in outer if child.tag in tags]:
            outer.remove(element)


def naming_files(root: ElementTree.Element) -> list[ElementTree.Element]:
    """The elements that name a file."""
    return [element for element in root.iter("string") if element.get("name") == "filename"]


def put_spectra_in(root: ElementTree.Element, place: Callable[[str], Path]) -> None:
    """Writes the values of spectra that lie in files into the scene.

    Args:
        place: the path of a file of the scene by its name; may raise InputError.

    Raises:
        InputError: a file that is missing or holds other lines than a wavelength and a value.
    """
    for element in root.iter("spectrum"):
        name = element.attrib.pop("filename", None)
        if name is None:
            continue
        lines = [line.split() for line in read_text(place(name)).splitlines()]
        rows = [words for words in lines if words and not words[0].startswith("#")]
        try:
            element.set("value", ", ".join(f"{float(nm)!r}:{float(value)!r}" for nm, value in rows))
        except ValueError as error:
            raise InputError(
                f"filename = {shown(name)} is no spectrum: each line holds a wavelength in nanometres and a "
                "value."
            ) from error


def require_inside(name: str) -> str:
    """The name; raises InputError unless it is that of a file in a folder or below it, on any system."""
    path = PurePosixPath(name)
    bad = not path.name or path.is_absolute() or ".." in path.parts or name.endswith("/")
    if bad or NO_FILE_CHARACTER.search(name) or len(name.encode()) > _LONGEST_NAME:
        raise InputError(f"filename = {shown(name)} is wrong: files lie in the scene's folder or below it.")
    return name


def require_closed(element: ElementTree.Element, files: Collection[str], depth: int = 0) -> None:
    """Raises InputError if an element could read anything but `files`; the message names what could."""
    tag, kind = element.tag, element.get("type")
    if depth > _DEEPEST:
        raise InputError(f"its elements lie inside one another more than {_DEEPEST} deep.")
    if tag not in _ATTRIBUTES:
        raise InputError(f"<{tag[:40]}> cannot be used in it: {closest(tag, _ATTRIBUTES)}")
    plugins = _PLUGINS.get(tag)
    if plugins and kind not in plugins and not (tag == "spectrum" and kind is None):
        raise InputError(
            f"<{tag} type={shown(kind or '')}> cannot be used in it: {closest(kind or '', sorted(plugins))}"
        )
    for key, value in element.attrib.items():
        if key not in _ATTRIBUTES[tag]:
            raise InputError(f"<{tag}> cannot have the attribute {shown(key)} = {shown(value)}.")
        if "$" in value:
            raise InputError(f"<{tag}> has {key} = {shown(value)}, a parameter that no <default> defines.")
        if key == "value" and tag == "string":
            _require_string(element.get("name", ""), value, files)
        elif key not in _NAMES and not _NUMBERS.fullmatch(value):
            raise InputError(f"<{tag}> has {key} = {shown(value)}: write numbers, a colour, true or false.")
    for child in element:
        require_closed(child, files, depth + 1)


def _require_string(name: str, value: str, files: Collection[str]) -> None:
    if name == "filename":
        if value not in files:
            raise InputError(f"its source names the file {shown(value)}, which it lacks.")
    elif name == "material" and value.removesuffix("_palik") not in _METALS:
        raise InputError(f"material = {shown(value)} is no metal that Mitsuba knows.")
    elif not _WORDS.fullmatch(value) and not _LIST.fullmatch(value):
        raise InputError(f"{shown(name)} = {shown(value)} cannot be used in it: write a word or numbers.")
