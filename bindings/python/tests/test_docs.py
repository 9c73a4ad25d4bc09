"""Every example of docs/python.md and README.md runs, and everything public has a docstring."""

from __future__ import annotations

import inspect
import pathlib
import re

import pytest

import plumb

ROOT = pathlib.Path(__file__).parents[3]
PAGES = [ROOT / "docs" / "python.md", ROOT / "README.md"]


def examples() -> list[object]:
    found: list[object] = []
    for page in PAGES:
        text = page.read_text() if page.exists() else ""
        blocks = re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
        found += [pytest.param(b, id=f"{page.stem}-{i}") for i, b in enumerate(blocks)]
    return found


@pytest.mark.parametrize("block", examples())
def test_example(block, tmp_path, monkeypatch):
    for module in re.findall(r"^(?:import|from) (trimesh|shapely|geopandas|distributed)", block,
                             re.MULTILINE):
        pytest.importorskip(module)
    monkeypatch.chdir(tmp_path)
    exec(compile(block, "example", "exec"), {"__name__": "example"})


def test_everything_public_has_a_docstring():
    for name in plumb.__all__:
        value = getattr(plumb, name)
        if name == "__version__":
            continue
        assert inspect.getdoc(value), name
        members = vars(value) if inspect.isclass(value) else {}
        for member, thing in members.items():
            if not member.startswith("_") and callable(thing):
                assert inspect.getdoc(thing), f"{name}.{member}"
