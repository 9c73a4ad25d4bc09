#!/usr/bin/env python3
"""Every function of plumb.h is called by the tests, and is all that a shared library shows.

every_function.py HEADER TEST [NM LIBRARY]"""
import re
import subprocess
import sys


def functions_of(path):
    text = open(path, encoding="utf-8").read()
    return set(re.findall(r"\b(plumb_\w+)\(", re.sub(r"/\*.*?\*/", "", text, flags=re.S)))


def complain(names, what):
    for name in sorted(names):
        print(f"{what}: {name}")
    return bool(names)


header, test, *library = sys.argv[1:]
declared = functions_of(header)
print(f"{len(declared)} functions")
is_bad = len(declared) < 100 or complain(declared - functions_of(test), "not called")
if library:
    lines = subprocess.run([library[0], "--dynamic", "--defined-only", library[1]], text=True, stdout=subprocess.PIPE, check=True).stdout
    shown = {line.split()[-1] for line in lines.splitlines()}
    is_bad |= complain(declared - shown, "not exported")
    is_bad |= complain(shown - declared, "not declared")
sys.exit(1 if is_bad else 0)
