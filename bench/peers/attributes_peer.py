#!/usr/bin/env python3
"""Texture coordinates through a Boolean, beside manifold3d: attributes_peer.py --plumb PROGRAM

Unions and differences of two spheres with random texture coordinates at their vertices. plumb is the
program, which reads and writes PLY. manifold3d gets the same arrays with the coordinates as
properties of vertices. At random points of the faces of each result, the texture coordinates are
compared with those of the source triangle that contains the point, which is found by brute force.
The table has the greatest difference for each library, and what attributes cost: the CPU time with
them divided by that without them, in the median of ROUNDS runs. plumb's time is that of the whole
program, with reading and writing of files.

    pip install numpy manifold3d
"""

import argparse
import pathlib
import resource
import statistics
import subprocess
import tempfile
import time

import manifold3d
import numpy as np

SAMPLES = 2000


def icosphere(depth, centre):
    """Returns the points and the triangles of a sphere."""
    golden = (1 + 5**0.5) / 2
    points = [(-1, golden, 0), (1, golden, 0), (-1, -golden, 0), (1, -golden, 0)]
    points += [(z, x, y) for x, y, z in points] + [(y, z, x) for x, y, z in points]
    points = [np.array(p) / np.linalg.norm(p) for p in points]
    near = [[j for j in range(12) if j != i and np.dot(p, points[j]) > 0.4]
            for i, p in enumerate(points)]
    faces = [(i, j, k) for i in range(12) for j in near[i] for k in near[i]
             if i < j and i < k and k in near[j]
             and np.linalg.det([points[i], points[j], points[k]]) > 0]
    for _ in range(depth):
        middle, finer = {}, []

        def between(a, b, middle=middle):
            key = (min(a, b), max(a, b))
            if key not in middle:
                middle[key] = len(points)
                p = points[a] + points[b]
                points.append(p / np.linalg.norm(p))
            return middle[key]

        for a, b, c in faces:
            x, y, z = between(a, b), between(b, c), between(c, a)
            finer += [(a, x, z), (b, y, x), (c, z, y), (x, y, z)]
        faces = finer
    # Both libraries get the same numbers, so they are rounded to floats.
    return (np.array(points) + centre).astype(np.float32), np.array(faces, np.uint32)


def write_ply(path, points, faces, uv):
    """Writes a text file of PLY."""
    with open(path, "w") as out:
        out.write("ply\nformat ascii 1.0\nelement vertex %d\n" % len(points))
        out.write("".join("property double %s\n" % n for n in ("x", "y", "z", "s", "t")))
        out.write("element face %d\nproperty list uchar int vertex_indices\nend_header\n"
                  % len(faces))
        for row in np.hstack([points, uv]).astype(float):
            out.write(" ".join(repr(float(x)) for x in row) + "\n")
        for face in faces:
            out.write("3 %d %d %d\n" % tuple(face))


def read_ply(path):
    """Returns points, triangles and texture coordinates of a text file of PLY."""
    lines = pathlib.Path(path).read_text().split("\n")
    end = lines.index("end_header")
    header = [line.split() for line in lines[:end]]
    count = {line[1]: int(line[2]) for line in header if line[0] == "element"}
    first_face = next(i for i, line in enumerate(header) if line[:2] == ["element", "face"])
    names = [line[2] for line in header[:first_face] if line[0] == "property"]
    body = lines[end + 1:]
    rows = np.array([line.split() for line in body[:count["vertex"]]], float)
    faces = [list(map(int, line.split()[1:4]))
             for line in body[count["vertex"]:count["vertex"] + count["face"]]]
    column = names.index
    points = rows[:, [column("x"), column("y"), column("z")]]
    return points, np.array(faces), rows[:, [column("s"), column("t")]]


def weights_of(triangles, point):
    """Returns the weights of a point in each triangle, and its distance from their planes."""
    a, b, c = triangles[:, 0], triangles[:, 1], triangles[:, 2]
    normal = np.cross(b - a, c - a)
    square = np.einsum("ij,ij->i", normal, normal)
    v = np.einsum("ij,ij->i", np.cross(point - a, c - a), normal) / square
    w = np.einsum("ij,ij->i", np.cross(b - a, point - a), normal) / square
    off = np.abs(np.einsum("ij,ij->i", point - a, normal)) / np.sqrt(square)
    return np.stack([1 - v - w, v, w], axis=1), off


def greatest_difference(result, sources, seed):
    """Returns the greatest difference between a result and its sources at random points."""
    points, faces, uv = result
    triangles = np.concatenate([p.astype(float)[f] for p, f, _ in sources])
    values = np.concatenate([u[f] for _, f, u in sources])
    random = np.random.default_rng(seed)
    corners = points.astype(float)[faces]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]),
                          axis=1)
    worst = 0
    for face in random.choice(np.flatnonzero(area > 1e-6), SAMPLES):
        weight = random.dirichlet([1, 1, 1])
        at, found = weight @ corners[face], weight @ uv[faces[face]]
        weights, off = weights_of(triangles, at)
        best = np.argmax(weights.min(axis=1).clip(max=0) - 10 * off)
        worst = max(worst, np.abs(weights[best] @ values[best] - found).max())
    return worst


def cpu_of(command):
    """Runs a program and returns its CPU time."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def manifold_of(points, faces, uv):
    """Returns the solid of manifold3d, with properties if `uv` is given."""
    rows = points if uv is None else np.hstack([points, uv.astype(np.float32)])
    mesh = manifold3d.Mesh(vert_properties=np.ascontiguousarray(rows, np.float32), tri_verts=faces)
    return manifold3d.Manifold(mesh)


def run_manifold(operation, a, b, has_uv):
    """Returns the result of manifold3d and its CPU time."""
    start = time.process_time()
    first, second = (manifold_of(p, f, u if has_uv else None) for p, f, u in (a, b))
    result = (first + second if operation == "union" else first - second).to_mesh()
    rows, faces = np.array(result.vert_properties), np.array(result.tri_verts)
    return (rows[:, :3], faces, rows[:, 3:]), time.process_time() - start


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--plumb", required=True, help="the program")
    parser.add_argument("--depth", type=int, default=4, help="20 * 4**DEPTH triangles")
    parser.add_argument("--rounds", type=int, default=5)
    options = parser.parse_args()
    random = np.random.default_rng(1)
    sources = []
    for centre in ((0, 0, 0), (0.53, 0.31, 0.17)):
        points, faces = icosphere(options.depth, np.array(centre))
        uv = random.random((len(points), 2)).astype(np.float32).astype(float)
        sources.append((points, faces, uv))
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        files = [folder / "a.ply", folder / "b.ply"]
        for file, source in zip(files, sources):
            write_ply(file, *source)
        for operation in ("union", "difference"):
            out = folder / "out.ply"
            command = [options.plumb, "solid", operation, *map(str, files), "-o", str(out),
                       "--format", "ply-text"]
            ours, theirs = [], []
            for _ in range(options.rounds):
                without = cpu_of([*command, "--keep", "none"])
                ours.append(cpu_of(command) / without)
                without = run_manifold(operation, *sources, False)[1]
                result, time_with = run_manifold(operation, *sources, True)
                theirs.append(time_with / without)
            print("%-10s greatest difference: plumb %.1e, manifold3d %.1e; cost of attributes: "
                  "plumb %.2f, manifold3d %.2f"
                  % (operation, greatest_difference(read_ply(out), sources, 2),
                     greatest_difference(result, sources, 2), statistics.median(ours),
                     statistics.median(theirs)))


if __name__ == "__main__":
    main()
