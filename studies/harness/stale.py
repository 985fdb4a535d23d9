"""Which records are older than what they stand on."""

from __future__ import annotations

from pathlib import Path

from studies.harness.catalogue import catalogue, find_study
from studies.harness.probes import PROBES, moved, probed
from studies.harness.record import Record, records


def stale(folder: Path) -> dict[str, str]:
    """Why a record is old, by the name of its study; the others are not in it.

    Raises:
        InputError: a file that is no record.
    """
    found = records(folder)
    now = probed(name for record in found.values() for name in record.stands_on if name in PROBES)
    reasons = {name: _reason(record, now) for name, record in found.items()}
    return {name: reason for name, reason in reasons.items() if reason}


def _reason(record: Record, now: dict[str, list[float]]) -> str:
    if record.study not in catalogue():
        return "no study has this name"
    wanted = find_study(record.study).stands_on
    missing = [name for name in wanted if name not in record.stands_on]
    parts = [f"made before records kept {', '.join(missing)}"] if missing else []
    for name, before in record.stands_on.items():
        most = moved(name, before, now.get(name, []))
        if most is not None:
            much = "" if most == float("inf") else f", by up to {100 * most:.2g} %"
            says = PROBES[name].says if name in PROBES else name
            parts.append(f"{says} changed{much}")
    return "; ".join(parts)
