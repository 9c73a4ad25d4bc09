#!/usr/bin/env python3
"""Mending of meshes beside other programs: repair_peer.py [--plumb PROGRAM] [FILE...]

Every mesh is mended by plumb (`plumb solid repair`, with the options that its own message names where the default steps do not
suffice), trimesh, admesh and manifold3d, as far as they are installed. A row says for each whether its result is closed as
plumb reads it (plumb turns a closed mesh that is inside out), and its volume; the true volume of generated meshes is known.
Without FILE, meshes are generated: a ball with a defect of each kind; then come the damaged solids of corpus/solids.

    pip install trimesh manifold3d numpy scipy networkx; apt install admesh

trimesh    process (merges equal vertices), merge_vertices by digits, update_faces(unique and nondegenerate), fix_normals,
           fill_holes (holes of three and four edges)
admesh     its default steps (exact, nearby with its own tolerance, remove unconnected, fill holes, normals), on STL
manifold3d Manifold(Mesh) after merge() of its vertices: takes closed oriented meshes only, does not mend faces
The peers are never a part of the library or of its tests.
"""
import argparse
import json
import math
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile


def ball(depth=3):
    """Vertices and triangles of a subdivided octahedron on the unit sphere."""
    points = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    faces = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    for _ in range(depth):
        middle, finer = {}, []

        def between(a, b, middle=middle):
            key = (min(a, b), max(a, b))
            if key not in middle:
                p = [x + y for x, y in zip(points[a], points[b])]
                length = math.sqrt(sum(x * x for x in p))
                middle[key] = len(points)
                points.append(tuple(x / length for x in p))
            return middle[key]

        for a, b, c in faces:
            ab, bc, ca = between(a, b), between(b, c), between(c, a)
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = finer
    return points, faces


def volume(points, faces):
    total = 0
    for face in faces:
        a = points[face[0]]
        for i in range(2, len(face)):
            b, c = points[face[i - 1]], points[face[i]]
            total += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
                      + a[2] * (b[0] * c[1] - b[1] * c[0]))
    return total / 6


def soup(points, faces, noise, dice):
    """Every corner a point of its own, moved by up to `noise` along each axis."""
    corners = [tuple(x + dice.uniform(-noise, noise) for x in points[v]) for face in faces for v in face]
    return corners, [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(len(faces))]


def generated():
    """Names, points, faces, and the volume that a mended mesh has."""
    dice = random.Random(7)
    points, faces = ball()
    true = volume(points, faces)
    flipped = [f[::-1] if dice.random() < 0.2 else f for f in faces]
    around = [f for f in faces if 40 in f]
    yield "intact", points, faces, true
    yield "20 % of the faces flipped", points, flipped, true
    yield "all faces flipped", points, [f[::-1] for f in faces], true
    yield "corners apart by 1e-8", *soup(points, faces, 1e-8, dice), true
    yield "corners apart by 1e-6", *soup(points, faces, 1e-6, dice), true
    yield "corners apart, 20 % flipped", *soup(points, flipped, 1e-8, dice), true
    yield "a triangle missing", points, faces[1:], true
    yield f"the {len(around)} triangles at a vertex missing", points, [f for f in faces if 40 not in f], None
    yield "half of the faces listed twice", points, faces + faces[::2], true
    yield "every face in both directions", points, faces + [f[::-1] for f in faces], true
    yield "triangles with a repeated corner", points, faces + [(f[0], f[1], f[1]) for f in faces[:50]], true
    hollow = [tuple(x / 2 for x in p) for p in points]
    inner = [tuple(v + len(points) for v in f[::-1]) for f in faces]
    yield "a void inside", points + hollow, faces + inner, true * 7 / 8
    boxes = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    sides = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    split = [t for s in sides for t in ((s[0], s[1], s[2]), (s[0], s[2], s[3]))]
    beside = [(x + 1, y, z) for x, y, z in boxes]
    yield ("two boxes with a common wall", boxes + beside, split + [tuple(v + 8 for v in t) for t in split], 2.0)


# Files of corpus/solids, and their volumes once they are mended.
CORPUS = {"flipped-box.off": 2, "double-sided-box.off": 2, "open-box.off": 2, "last-bits.stl": 1 / 6}


def write_off(path, points, faces):
    with open(path, "w", encoding="ascii") as out:
        out.write(f"OFF\n{len(points)} {len(faces)} 0\n")
        out.writelines(" ".join(map(repr, map(float, p))) + "\n" for p in points)
        out.writelines(f"{len(f)} " + " ".join(map(str, f)) + "\n" for f in faces)


class Judge:
    """Says of a mended mesh what plumb reads."""

    def __init__(self, program):
        self.program = program

    def run(self, *words):
        return subprocess.run([self.program, *words], capture_output=True, text=True, check=False)

    def info(self, path):
        done = self.run("solid", "info", path, "--json")
        if done.returncode != 0:
            return None, done.stderr
        return json.loads(done.stdout)["volume"]["double"], done.stderr

    def verdict(self, path, true):
        if path is None or not os.path.exists(path):
            return "refused"
        found, message = self.info(path)
        if found is None:
            return "nothing inside" if "encloses nothing" in message else "open"
        if found == 0:
            return "nothing inside"
        if true is None or abs(found - true) <= 1e-4 * abs(true):
            return f"{found:.6g}"
        return f"{found:.6g} (wrong)"


def by_plumb(judge, source, folder):
    out = os.path.join(folder, "plumb.off")
    done = judge.run("solid", "repair", source, "-o", out)
    if done.returncode == 0 and judge.info(out)[0] is not None:
        return out, "default"
    hint = re.search(r"; (--(?:(?!; ).)*) mends it", judge.info(source)[1])
    if hint is None:
        return out, "default"
    judge.run("solid", "repair", source, "-o", out, *hint.group(1).split())
    return out, hint.group(1)


def by_trimesh(trimesh, source, folder):
    out = os.path.join(folder, "trimesh.off")
    mesh = trimesh.load(source, force="mesh", process=True)
    mesh.merge_vertices(digits_vertex=7)
    mesh.update_faces(mesh.unique_faces())
    mesh.update_faces(mesh.nondegenerate_faces())
    trimesh.repair.fix_normals(mesh)
    trimesh.repair.fill_holes(mesh)
    mesh.export(out)
    return out


def by_admesh(judge, source, folder):
    stl, out = os.path.join(folder, "in.stl"), os.path.join(folder, "admesh.stl")
    if source.endswith(".stl"):
        shutil.copy(source, stl)
    else:  # A mended copy would not be fair: `--weld 0` and nothing else.
        judge.run("solid", "repair", source, "--weld", "1e-300", "-o", stl)
    subprocess.run(["admesh", stl, f"--write-ascii-stl={out}"], capture_output=True, check=False)
    return out


def by_manifold(manifold3d, numpy, trimesh, source, folder):
    out = os.path.join(folder, "manifold.off")
    mesh = trimesh.load(source, force="mesh", process=False)
    as_mesh = manifold3d.Mesh(vert_properties=numpy.asarray(mesh.vertices, dtype=numpy.float32),
                              tri_verts=numpy.asarray(mesh.faces, dtype=numpy.uint32))
    as_mesh.merge()
    solid = manifold3d.Manifold(as_mesh)
    if solid.status() != manifold3d.Error.NoError:
        return None
    back = solid.to_mesh()
    write_off(out, back.vert_properties[:, :3].tolist(), back.tri_verts.tolist())
    return out


def installed(name):
    try:
        return __import__(name)
    except ImportError:
        return None


def attempt(judge, true, action):
    """The verdict on what a peer makes of a mesh; an exception is a refusal."""
    try:
        return judge.verdict(action(), true)
    except Exception as error:  # pylint: disable=broad-except
        return f"refused ({type(error).__name__})"


def row(judge, name, source, true):
    trimesh, manifold3d, numpy = map(installed, ("trimesh", "manifold3d", "numpy"))
    with tempfile.TemporaryDirectory() as folder:
        out, how = by_plumb(judge, source, folder)
        cells = [name, "?" if true is None else f"{true:.6g}", judge.verdict(out, true), how]
        cells.append(attempt(judge, true, lambda: by_trimesh(trimesh, source, folder)) if trimesh else "-")
        cells.append(attempt(judge, true, lambda: by_admesh(judge, source, folder)) if shutil.which("admesh") else "-")
        cells.append(attempt(judge, true, lambda: by_manifold(manifold3d, numpy, trimesh, source, folder))
                     if manifold3d and trimesh else "-")
    print("| " + " | ".join(cells) + " |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--plumb", default="./plumb", help="the program (default: ./plumb)")
    parser.add_argument("files", nargs="*", metavar="FILE")
    arguments = parser.parse_args()
    judge = Judge(os.path.abspath(arguments.plumb))
    print("| mesh | volume | plumb | its options | trimesh | admesh | manifold3d |")
    print("|---|---|---|---|---|---|---|")
    for path in arguments.files:
        row(judge, os.path.basename(path), path, None)
    if arguments.files:
        return 0
    with tempfile.TemporaryDirectory() as folder:
        for name, points, faces, true in generated():
            path = os.path.join(folder, "in.off")
            write_off(path, points, faces)
            row(judge, name, path, true)
    solids = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../corpus/solids")
    for name, true in CORPUS.items():
        row(judge, name, os.path.join(solids, name), true)
    return 0


if __name__ == "__main__":
    sys.exit(main())
