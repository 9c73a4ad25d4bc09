#!/usr/bin/env python3
"""Compares the models of a folder as OpenSCAD and plumb evaluate them.

    bench/peers/openscad_examples.py [--plumb PROGRAM] [--only TEXT] [FOLDER]

FOLDER has models (.scad) and the files that they import, in any depth; by default it is that of the examples of
Debian's package openscad. OpenSCAD writes each model as .csg, and as a mesh or, if it is flat, as a drawing.
`plumb solid csg` or `plumb plane csg` evaluates the .csg. Prints a line for each model: CPU seconds of both
programs, the volume or area, and by how much volumes, numbers of parts and boxes differ; or why one program
refuses it. The exit status is 1 if a volume differs by more than 1e-5, a box by more than 1e-5 of its
greatest coordinate, or a number of parts.
"""
import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

EXAMPLES = "/usr/share/openscad/examples"
TOLERANCE = 1e-5  # OpenSCAD writes six digits.


def timed(*command):
    """Runs a command; returns its CPU seconds and the result."""
    before = os.times()
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    after = os.times()
    return after.children_user - before.children_user, result


class Comparison:
    """One model in both programs."""

    def __init__(self, program, source):
        self.program = program
        self.source = source
        self.flat = source.with_suffix(".csg")

    def plumb(self, *words):
        """Returns the CPU seconds and the JSON of plumb, or the message of its error."""
        seconds, run = timed(self.program, *words, "--json", "--quiet")
        if run.returncode == 0:
            return seconds, json.loads(run.stdout), ""
        try:
            return seconds, None, json.loads(run.stderr.splitlines()[-1])["error"]["message"]
        except (ValueError, KeyError, IndexError):
            return seconds, None, run.stderr.strip()

    def openscad(self, extension):
        """Returns the CPU seconds of OpenSCAD, and its output or nothing."""
        output = self.source.with_suffix(extension)
        seconds, _ = timed("openscad", self.source, "-o", output)
        return seconds, output if output.exists() and output.stat().st_size > 0 else None

    def box(self, file):
        _, answer, _ = self.plumb("solid", "components", file)
        boxes = [part["box"] for part in answer["components"]]
        low = [min(box[0][axis] for box in boxes) for axis in range(3)]
        return low + [max(box[1][axis] for box in boxes) for axis in range(3)]

    def difference_of_boxes(self, theirs):
        ours = self.source.with_suffix(".plumb.off")
        timed(self.program, "solid", "csg", self.flat, "--quiet", "-o", ours)
        a, b = self.box(ours), self.box(theirs)
        return max(abs(x - y) for x, y in zip(a, b)) / max(abs(x) for x in b)

    def compare(self):
        """Returns a line about the model, and whether the programs agree."""
        self.openscad(".csg")
        if not self.flat.exists():
            return "OpenSCAD writes no .csg", True
        kind = "solid"
        seconds, ours, message = self.plumb("solid", "csg", self.flat)
        if ours is None and "set of the plane" in message:
            kind = "plane"
            seconds, ours, message = self.plumb("plane", "csg", self.flat)
        if ours is None:
            return "refused: " + message, True
        cpu, theirs = self.openscad(".off" if kind == "solid" else ".dxf")
        if theirs is None:
            return "empty" if ours["empty"] else "OpenSCAD writes nothing", ours["empty"]
        _, other, message = self.plumb(kind, "info", theirs)
        if other is None:
            return "the file of OpenSCAD is refused: " + message, False
        measure = "volume" if kind == "solid" else "area"
        a, b = ours[measure]["double"], other[measure]["double"]
        worst = abs(a - b) / abs(b)
        line = f"{seconds:7.2f} s, OpenSCAD {cpu:7.2f} s; {measure} {a:.9g}, differs by {worst:.1e}"
        if kind == "plane":
            return line, worst <= TOLERANCE
        box = self.difference_of_boxes(theirs)
        parts = ours["marked_volumes"], other["marked_volumes"]
        agree = max(worst, box) <= TOLERANCE and parts[0] == parts[1]
        return f"{line}; box {box:.1e}; parts {parts[0]} and {parts[1]}", agree


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", nargs="?", default=EXAMPLES)
    parser.add_argument("--plumb", default="./plumb")
    parser.add_argument("--only", default="")
    arguments = parser.parse_args()
    wrong = 0
    with tempfile.TemporaryDirectory() as work:
        copy = pathlib.Path(work) / "models"
        shutil.copytree(arguments.folder, copy)
        for source in sorted(copy.rglob("*.scad")):
            name = str(source.relative_to(copy))
            if arguments.only not in name:
                continue
            line, agree = Comparison(os.path.abspath(arguments.plumb), source).compare()
            wrong += not agree
            print(f"{name}: {line}{'' if agree else '  DIFFERS'}", flush=True)
    print(f"{wrong} differ")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
