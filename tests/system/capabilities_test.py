#!/usr/bin/env python3
"""docs/capabilities.md names every function of C and every command, and nothing else.

capabilities_test.py ROOT [PROGRAM]
The names of Python are tested by bindings/python/tests/test_capabilities.py, and those of JavaScript by
bindings/js/tests/docs.test.mjs."""
import fnmatch
import pathlib
import re
import subprocess
import sys

root = pathlib.Path(sys.argv[1])
program = sys.argv[2] if len(sys.argv) > 2 else None
CPP, C, COMMAND = 1, 2, 4
failures = 0


def complain(text):
    global failures
    failures += 1
    print(text)


def column(index):
    """Returns the names in a column of all tables."""
    names = []
    for line in (root / "docs/capabilities.md").read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) < 5 or cells[0] in ("Capability", "---"):
            continue
        if not cells[index]:
            complain(f"an empty cell, where a dash should be: {line}")
        names += re.findall(r"`([^`]+)`", cells[index])
    return names


def compare(patterns, existing, what):
    for pattern in patterns:
        if not fnmatch.filter(existing, pattern):
            complain(f"no {what} is called {pattern}")
    for name in sorted(existing):
        if not any(fnmatch.fnmatchcase(name, pattern) for pattern in patterns):
            complain(f"the {what} {name} is in no row")


def commands():
    """Returns the names of all commands, as the help of the program lists them."""

    def listed(*group):
        text = subprocess.run([program, *group, "--help"], capture_output=True, text=True, check=True).stdout
        block = text.split("Commands:\n", 1)[1].split("\n\n", 1)[0]
        return [line.split("  ")[1].strip() for line in block.splitlines() if line.startswith("  ")]

    def name_of(usage):
        words = [word for word in usage.split() if re.fullmatch(r"[a-z][a-z-]*", word)]
        return " ".join(words)

    names = []
    for usage in listed():
        if usage.endswith("..."):
            group = usage.split()[0]
            if "FILE" not in usage:
                names += [name_of(sub) for sub in listed(group)]
                continue
        names.append(name_of(usage))
    return set(names)


header = (root / "bindings/c/include/plumb.h").read_text(encoding="utf-8")
functions = set(re.findall(r"\b(plumb_\w+)\(", re.sub(r"/\*.*?\*/", "", header, flags=re.S)))
if len(functions) < 100:
    complain("plumb.h has hardly any functions")
compare(column(C), functions, "function of C")

public = (root / "cmake/public-headers.txt").read_text(encoding="utf-8")
words = set()
for path in re.findall(r"^plumb/\S+\.h$", public, flags=re.M):
    for folder in ("engine", "predicates"):
        if (root / folder / path).exists():
            words |= set(re.findall(r"\w+", (root / folder / path).read_text(encoding="utf-8")))
for name in column(CPP):
    for part in name.split("::"):
        if part not in words:
            complain(f"no public header has {name}")

if program:
    compare(column(COMMAND), commands(), "command")
print(f"{failures} failed")
sys.exit(1 if failures else 0)
