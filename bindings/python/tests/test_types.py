"""The types of the package, as mypy --strict sees them."""

from __future__ import annotations

import pathlib
import subprocess
import sys

import pytest

import plumb

HERE = pathlib.Path(__file__).parent


def test_mypy_accepts_the_example_and_the_package(tmp_path):
    pytest.importorskip("mypy")
    package = pathlib.Path(plumb.__file__).parent
    command = [sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(tmp_path)]
    command += ["--config-file", "", "--ignore-missing-imports"]
    names = ["__init__.py", "_arrays.py", "_attributes.py", "_errors.py", "_core.pyi"]
    targets = [str(HERE / "typed_example.py")]
    if "site-packages" not in str(package):
        targets += [str(package / name) for name in names]
    done = subprocess.run(
        [*command, *targets],
        capture_output=True,
        text=True,
        env={"MYPYPATH": str(package.parent), "PATH": ""},
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr


def test_the_example_runs():
    done = subprocess.run([sys.executable, str(HERE / "typed_example.py")], check=False)
    assert done.returncode == 0
