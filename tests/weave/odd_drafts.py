"""Weaving information files that are odd where it does not matter, made of one that is not."""

from __future__ import annotations

BASE = """\
[WIF]
Version=1.1
[WEAVING]
Shafts=4
Treadles=4
Rising Shed=true
[TEXT]
Title=Körper
[WARP]
Threads=4
Color=1
[WEFT]
Threads=4
Color=2
[COLOR PALETTE]
Entries=2
Range=0,255
[COLOR TABLE]
1=200,30,30
2=30,30,200
[WARP COLORS]
2=2
[THREADING]
1=1
2=2
3=3
4=4
[TIEUP]
1=1,2
2=2,3
3=3,4
4=1,4
[TREADLING]
1=1
2=2
3=3
4=1,4
"""


def _with(old: str, new: str) -> bytes:
    assert old in BASE
    return BASE.replace(old, new).encode()


_UTF16 = BASE.replace("\n", "\r\n").encode("utf-16-le")
_LIFTS = "[LIFTPLAN]\n1=1,2\n2=2,3\n3=3,4\n4=1,2,4\n"

# Read as BASE is, without a word.
SILENT = {
    "ctrl-z": BASE.encode() + b"\x1a",
    "ctrl-z and what lay behind it on the disk": BASE.encode() + b"\x1a1=4\n2=oops\n\xff\xfe\x00",
    "nuls": BASE.encode() + bytes(300),
    "nuls and ctrl-z": BASE.encode() + b"\r\n\x1a\0\0\0\x1a",
    "ctrl-z on a line of its own amid sections": _with("[TIEUP]", "\x1a\n[TIEUP]"),
    "a nul after each line": BASE.replace("\n", "\0\n").encode(),
    "utf-16-le without a mark": _UTF16,
    "utf-16-be without a mark": BASE.encode("utf-16-be"),
    "utf-16 with a mark and a byte more": b"\xff\xfe" + _UTF16 + b"\x1a",
    "utf-16 filled up with nuls": _UTF16 + bytes(511),
    "utf-16 with notes in Chinese": (BASE + "[NOTES]\n1=" + "布" * 200).encode("utf-16-le"),
    "utf-32": BASE.encode("utf-32-le"),
    "two marks": b"\xef\xbb\xbf\xef\xbb\xbf" + BASE.encode(),
    "windows-1252": BASE.encode("cp1252"),
    "index and rgb": _with("[WARP COLORS]\n2=2", "[WARP COLORS]\n1=1,200,30,30\n2=2, 30, 30, 200\n3=1"),
    "index and rgb by default": _with("Color=1", "Color=1,200,30,30"),
    "colours and lengths of threads that are not there": _with(
        "[WARP COLORS]\n2=2", "[WARP COLORS]\n2=2\n40=99\n[WARP THICKNESS]\n41="
    ),
    "a colour that is missing and unused": _with("2=30,30,200", "2=30,30,200\n5=1,2,3"),
    "keys with zeros and signs": _with("3=3,4", "0003=3,4"),
}
# Read as BASE is, with one warning that holds these words.
WARNED = {
    "tie-up of one shaft a line": (
        _with("1=1,2\n2=2,3\n3=3,4\n4=1,4", "1=1\n1=2\n2=2\n2=3 ; too\n3=3\n3=4\n4=1\n4=4"),
        "[TIEUP] 1 is there twice, as '1' and as '2', and 3 other keys are too; all of them are used.",
    ),
    "treadling of one treadle a line": (
        _with("3=3\n4=1,4\n", "3=3\n4=1\n04=4\n"),
        "[TREADLING] 04 is there twice, as '1' and as '4'; all of them are used.",
    ),
    "tie-up of two sections": (
        _with("4=1,4\n[TREAD", "[TIEUP]\n4=0\n4=1\n4=4\n[TREAD"),
        "[TIEUP] 4 is there 3 times, as '0' and as '4'; all of them are used.",
    ),
    "an unused unit": (_with("Color=1", "Color=1\nUnits=furlongs"), "[WARP] Units=furlongs is no known unit"),
    "an unused colour": (_with("2=30,30,200", "2=30,30,200\n3=blue"), "[COLOR TABLE] 3=blue is not a colour"),
    "an unused colour out of range": (
        _with("2=30,30,200", "2=30,30,200\n3=256,0,0"),
        "[COLOR TABLE] 3=256,0,0 leaves the range 0 to 255",
    ),
    "a default that no thread needs": (
        _with("[WARP COLORS]\n2=2", "[WEFT COLORS]\n1=2\n2=2\n3=2\n4=2\n[WARP COLORS]\n2=2").replace(
            b"Color=2", b"Color=blue"
        ),
        "[WEFT] Color=blue is not in [COLOR TABLE]",
    ),
    "a liftplan beside the treadling": (
        (BASE + _LIFTS.replace("3=3,4", "3=three")).encode(),
        "[LIFTPLAN] 3=three is no list of shafts",
    ),
}
