#!/usr/bin/env python3
"""Models of OpenSCAD in `plumb solid csg` and in manifold3d: CPU time of each model and in all.

    bench/peers/csg_manifold.py [--plumb PROGRAM] [--only TEXT] [--rounds N] FOLDER

FOLDER has models (.csg) and a table expected.tsv (csg_models.py). The time of plumb is that of the
whole program: it starts, reads the model, makes the leaves, evaluates them exactly and writes the
result exactly (.nef). The time of manifold3d begins with arrays of vertices (doubles) and triangles
of the leaves, and ends with such arrays of the result. The operations in between are one
batch_boolean() for each node of the model that has several children.

A leaf is a subtree without union, difference and intersection of solids, such as a primitive, an
extrusion or a hull. plumb makes the leaves that manifold3d takes, which is part of plumb's time
only. The column `sets` is the part of plumb's time that it spends in sets from meshes and in
Booleans (--timings), which is what manifold3d does. Both run on one core, in turn, N rounds; the
times are the least of the rounds. The last column is the relative difference of the volume of
manifold3d from the expected one.

    pip install numpy manifold3d
"""
import argparse
import csv
import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile
import time

import manifold3d
import numpy as np

GROUPS = {"group", "union", "render", "color", "multmatrix"}
BOOLEANS = {"difference", "intersection"}
FLAT = {"square", "circle", "polygon", "text", "projection"}
TOKEN = re.compile(r'"(?:[^"\\]|\\.)*"|[(){};]|[^"(){};]+')


class Node:
    """A node of a model, with the text from which it was read."""

    def __init__(self, name):
        self.name, self.arguments, self.children, self.text = name, "", [], ""


def read_model(text):
    """Returns the root of a model, a group."""
    root = Node("group")
    stack, starts, depth = [root], [0], 0
    for token in TOKEN.finditer(text):
        word = token.group()
        if depth > 0:
            depth += (word == "(") - (word == ")")
            stack[-1].arguments += word if depth else ""
        elif word == "(":
            depth = 1
        elif word in "};":
            if word == "}" or stack[-1].text is None:
                node = stack.pop()
                node.text = text[starts.pop():token.end()]
                stack[-1].children.append(node)
        elif word != "{" and word.strip():
            stack.append(Node(word.strip()))
            stack[-1].text = None
            starts.append(token.start() + len(word) - len(word.lstrip()))
        if word == "{" and not depth:
            stack[-1].text = ""
    return root


def is_flat(node):
    """Returns whether a node is a set of the plane; None for a group without geometry."""
    if node.name in FLAT:
        return True
    if node.name in GROUPS | BOOLEANS | {"hull", "minkowski", "resize", "offset"}:
        kinds = [kind for kind in map(is_flat, node.children) if kind is not None]
        return kinds[0] if kinds else None
    return False


class Leaves:
    """Meshes of leaves, which plumb makes. Equal leaves are made once."""

    def __init__(self, program, folder):
        self.program, self.folder, self.known = program, folder, {}

    def mesh_of(self, node):
        """Returns the vertices and the triangles of a leaf."""
        key = " ".join(node.text.split())
        if key not in self.known:
            model, mesh = self.folder / "leaf.csg", self.folder / "leaf.off"
            model.write_text(node.text, encoding="utf-8")
            subprocess.run([self.program, "solid", "csg", model, "--quiet", "--triangles",
                            "--keep", "none", "-o", mesh], check=True)
            words = mesh.read_text(encoding="ascii").split()
            vertices, faces = int(words[1]), int(words[2])
            numbers = np.array(words[4:4 + 3 * vertices], dtype=float).reshape(-1, 3)
            rows = words[4 + 3 * vertices:4 + 3 * vertices + 4 * faces]
            self.known[key] = (numbers, np.array(rows, dtype=np.uint64).reshape(-1, 4)[:, 1:])
        return self.known[key]


def expression_of(node, matrix, leaves):
    """Returns a mesh (a leaf), or an operation with its operands; None if there is no geometry."""
    if node.name == "multmatrix":
        matrix = matrix @ np.array(re.findall(r"[-+.\deE]+", node.arguments),
                                   dtype=float).reshape(4, 4)
    if node.name not in GROUPS | BOOLEANS:
        vertices, triangles = leaves.mesh_of(node)
        if len(triangles) == 0:
            return []
        moved = vertices @ matrix[:3, :3].T + matrix[:3, 3]
        if np.linalg.det(matrix[:3, :3]) < 0:
            triangles = triangles[:, ::-1]
        return np.ascontiguousarray(moved), np.ascontiguousarray(triangles)
    children = [child for child in node.children
                if node.name in BOOLEANS or is_flat(child) is False]
    operands = [expression_of(child, matrix, leaves) if is_flat(child) is False else None
                for child in children]
    if node.name in BOOLEANS:
        if not operands or operands[0] is None:
            return None
        if node.name == "difference":
            operands = [operand for operand in operands if operand is not None]
    else:
        operands = [operand for operand in operands if operand is not None]
    if not operands:
        return None
    kind = node.name if node.name in BOOLEANS else "union"
    return operands[0] if len(operands) == 1 else [kind, *operands]


def evaluate(expression):
    """Returns the solid of an expression in manifold3d."""
    if isinstance(expression, tuple):
        solid = manifold3d.Manifold(manifold3d.Mesh64(*expression))
        if solid.status() != manifold3d.Error.NoError:
            raise ValueError(str(solid.status()))
        return solid
    if not expression:
        return manifold3d.Manifold()
    operation = {"union": manifold3d.OpType.Add, "difference": manifold3d.OpType.Subtract,
                 "intersection": manifold3d.OpType.Intersect}[expression[0]]
    return manifold3d.Manifold.batch_boolean([evaluate(e) for e in expression[1:]], operation)


def time_of_manifold(expression):
    """Returns the CPU seconds of manifold3d, and the volume."""
    before = time.process_time()
    solid = evaluate(expression)
    solid.to_mesh64()
    return time.process_time() - before, solid.volume()


def time_of_plumb(program, model):
    """Returns the CPU seconds of the program, and those of sets from meshes and of Booleans."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run = subprocess.run([program, "solid", "csg", model, "--timings", "--format", "nef", "-o",
                          os.devnull], check=True, capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    phases = re.findall(r"^  (?:set from mesh|Boolean) +([0-9.]+) ", run.stderr, re.MULTILINE)
    return (after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime,
            sum(map(float, phases)))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--plumb", default="./plumb")
    parser.add_argument("--only", default="")
    parser.add_argument("--rounds", type=int, default=3)
    arguments = parser.parse_args()
    sys.setrecursionlimit(100000)
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    lines = (arguments.folder / "expected.tsv").read_text(encoding="utf-8").splitlines()
    start = next(i for i, line in enumerate(lines) if line.startswith("model\t"))
    ours, sets_of_ours, theirs, slowest = 0.0, 0.0, 0.0, 0.0
    print("   plumb     sets  manifold   ratio  model, difference of the volume of manifold3d")
    for row in csv.DictReader(lines[start:], delimiter="\t"):
        if arguments.only not in row["model"]:
            continue
        path = arguments.folder / (row["model"] + ".csg")
        with tempfile.TemporaryDirectory() as folder:
            expression = expression_of(read_model(path.read_text(encoding="utf-8")), np.eye(4),
                                       Leaves(arguments.plumb, pathlib.Path(folder)))
        rounds = [(*time_of_plumb(arguments.plumb, path), *time_of_manifold(expression or []))
                  for _ in range(arguments.rounds)]
        plumb, sets, manifold, _ = map(min, zip(*rounds, strict=True))
        volume, expected = rounds[0][3], float(row["volume"])
        ours, sets_of_ours, theirs = ours + plumb, sets_of_ours + sets, theirs + manifold
        slowest = max(slowest, plumb)
        print(f"{plumb:8.3f} {sets:8.3f}  {manifold:8.3f}  {plumb / max(manifold, 1e-4):6.2f}  "
              f"{row['model']}  {(volume - expected) / expected:.1e}", flush=True)
    print(f"{ours:8.3f} {sets_of_ours:8.3f}  {theirs:8.3f}  {ours / theirs:6.2f}  in all; the "
          f"slowest of plumb {slowest:.3f}")


if __name__ == "__main__":
    main()
