"""docs/capabilities.md names every public method and function of the module."""

from __future__ import annotations

import fnmatch
import pathlib
import re

import plumb

TABLES = pathlib.Path(__file__).resolve().parents[3] / "docs" / "capabilities.md"
PYTHON = 3


def named() -> list[str]:
    names: list[str] = []
    for line in TABLES.read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) >= 5:
            names += re.findall(r"`([^`]+)`", cells[PYTHON])
    return names


def existing() -> set[str]:
    names: set[str] = set()
    for name in plumb.__all__:
        thing = getattr(plumb, name)
        if name.startswith("__"):
            continue
        is_class = isinstance(thing, type) and not issubclass(thing, Exception)
        if is_class and thing.__module__ == "plumb._core":
            names |= {f"{name}.{member}" for member in dir(thing) if not member.startswith("_")}
        else:
            names.add(name)
    return names


def test_every_row_exists_and_everything_has_a_row() -> None:
    patterns, names = named(), existing()
    assert len(names) > 100
    missing = [pattern for pattern in patterns if not fnmatch.filter(names, pattern)]
    assert missing == []
    in_no_row = [
        name
        for name in sorted(names)
        if not any(fnmatch.fnmatchcase(name, pattern) for pattern in patterns)
    ]
    assert in_no_row == []
