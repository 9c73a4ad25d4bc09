#!/usr/bin/env python3
"""The union of pairs of meshes in plumb's Python module beside manifold3d, and beside plumb in C++.

    python bench/peers/python_peer.py [PAIR...] [--rounds N] [--cpp SPACE_PEER] [--json FILE]

CPU time, user and system, from arrays of vertices and triangles to such arrays, of this process:
both libraries in turn, N rounds, and one before that is not counted; the median and the range of
the ratio. plumb has one thread, and rounds to the nearest doubles as space_peer.cpp does. The last
column is its time with a mesh that is valid after rounding (to_mesh()). manifold3d has the threads
that it takes, and float32 vertices, to which it rounds. The pairs are those of space_peer.cpp. The
answer is the volume of the union, to 1e-4 of it.

--cpp measures the same unions in C++ (`SPACE_PEER --run plumb-warm`), and says how much longer
calls of Python take. The last row has the microseconds of a call with empty sets, which does
nothing but be called, and of the union of two cubes.

    pip install . numpy manifold3d
"""

import argparse
import json
import math
import pathlib
import statistics
import subprocess
import tempfile
import time

import numpy as np
import plumb

ROOT = pathlib.Path(__file__).parents[2]
TOLERANCE = 1e-4


def icosphere(depth, centre):
    """A sphere of 20 * 4**depth triangles around `centre`."""
    golden = (1 + math.sqrt(5)) / 2
    points = [(-1, golden, 0), (1, golden, 0), (-1, -golden, 0), (1, -golden, 0)]
    points += [(z, x, y) for x, y, z in points] + [(y, z, x) for x, y, z in points]
    points = [np.array(p) / math.hypot(*p) for p in points]
    # The faces of the convex hull of the twelve points are the triples of nearest neighbours.
    near = [
        [j for j, q in enumerate(points) if j != i and np.dot(p, q) > 0.4]
        for i, p in enumerate(points)
    ]
    faces = [
        (i, j, k)
        for i in range(12)
        for j in near[i]
        for k in near[i]
        if i < j and i < k and k in near[j]
        and np.linalg.det([points[i], points[j], points[k]]) > 0
    ]
    for _ in range(depth):
        middle, finer = {}, []

        def between(a, b, middle=middle):
            key = (min(a, b), max(a, b))
            if key not in middle:
                p = points[a] + points[b]
                middle[key] = len(points)
                points.append(p / np.linalg.norm(p))
            return middle[key]

        for a, b, c in faces:
            ab, bc, ca = between(a, b), between(b, c), between(c, a)
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = finer
    return np.array(points) + centre, np.array(faces, dtype=np.uint32)


def grid_cube(n, low):
    """A cube of width n whose faces are grids of squares, each in two triangles."""
    corners, faces = {}, []

    def vertex(p):
        return corners.setdefault(tuple(p), len(corners))

    for axis in range(3):
        u, v = np.eye(3, dtype=int)[(axis + 1) % 3], np.eye(3, dtype=int)[(axis + 2) % 3]
        for side in (0, n):
            start = side * np.eye(3, dtype=int)[axis]
            for i in range(n):
                for j in range(n):
                    p = start + i * u + j * v
                    a, b, c, d = (vertex(q) for q in (p, p + u, p + u + v, p + v))
                    square = [(a, b, c), (a, c, d)]
                    faces += square if side else [t[::-1] for t in square]
    return np.array(list(corners), dtype=float) + low, np.array(faces, dtype=np.uint32)


def bunny():
    words = (ROOT / "corpus/solids/bunny.off").read_text().split()
    points, faces = int(words[1]), int(words[2])
    vertices = np.array(words[4 : 4 + 3 * points], dtype=float).reshape(-1, 3)
    rows = np.array(words[4 + 3 * points : 4 + 3 * points + 4 * faces], dtype=np.uint32)
    return vertices, np.ascontiguousarray(rows.reshape(-1, 4)[:, 1:])


def turned(mesh, angle):
    vertices, triangles = mesh
    c, s = math.cos(angle), math.sin(angle)
    return vertices @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]), triangles


def itself_moved(mesh):
    vertices, triangles = mesh
    step = np.ptp(vertices[:, 0]) / 7
    return mesh, (vertices + np.array([step, step / 2, step / 3]), triangles)


def spheres(depth):
    return icosphere(depth, (0, 0, 0)), icosphere(depth, (0.3, 0.2, 0.1))


PAIRS = {
    "ico1280": lambda: spheres(3),
    "ico5120": lambda: spheres(4),
    "ico20480": lambda: spheres(5),
    "bunny": lambda: itself_moved(bunny()),
    "cubes19200": lambda: (grid_cube(40, (0, 0, 0)), grid_cube(40, (3.25, 2.5, 0))),
    "ico5120-turned": lambda: (
        icosphere(4, (0, 0, 0)),
        turned(icosphere(4, (0, 0, 0)), 1e-12),
    ),
    "ico20480-twice": lambda: (icosphere(5, (0.1, 0.2, 0.3)),) * 2,
}


def volume(mesh):
    a, b, c = (mesh[0].astype(float)[mesh[1][:, i]] for i in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


def in_plumb(a, b, rounding="nearest"):
    both = plumb.Solid.from_mesh(*a, rule="positive") | plumb.Solid.from_mesh(*b, rule="positive")
    return both.to_mesh(rounding=rounding)


def in_manifold(a, b):
    import manifold3d

    def solid(mesh):
        return manifold3d.Manifold(manifold3d.Mesh(*mesh))

    made = (solid(a) + solid(b)).to_mesh()
    return made.vert_properties[:, :3], made.tri_verts


def timed(function, *arguments):
    start = time.process_time()
    mesh = function(*arguments)
    return time.process_time() - start, mesh


def off_file(path, mesh):
    vertices, triangles = mesh
    lines = ["OFF", f"{len(vertices)} {len(triangles)} 0"]
    lines += [" ".join(map(repr, row)) for row in vertices.tolist()]
    lines += [f"3 {i} {j} {k}" for i, j, k in triangles.tolist()]
    path.write_text("\n".join(lines) + "\n")


def in_cpp(program, a, b, rounds):
    with tempfile.TemporaryDirectory() as folder:
        files = [pathlib.Path(folder) / name for name in ("a.off", "b.off")]
        for path, mesh in zip(files, (a, b), strict=True):
            off_file(path, mesh)
        command = [program, "--run", "plumb-warm", *map(str, files)]
        return [
            float(subprocess.check_output(command, text=True).split()[0]) for _ in range(rounds)
        ]


def compare(name, rounds, cpp):
    a, b = PAIRS[name]()
    single = [(np.ascontiguousarray(v, dtype=np.float32), t) for v, t in (a, b)]
    ours, theirs, valid = [], [], []
    for round_ in range(rounds + 1):
        our_time, our_mesh = timed(in_plumb, a, b)
        their_time, their_mesh = timed(in_manifold, *single)
        if round_ == 0:
            expected, other = volume(our_mesh), volume(their_mesh)
            if abs(expected - other) > TOLERANCE * abs(expected):
                raise SystemExit(f"{name}: the volumes {expected} and {other} differ")
            continue
        ours.append(our_time)
        theirs.append(their_time)
        valid.append(timed(in_plumb, a, b, "valid")[0])
    ratios = [x / y for x, y in zip(ours, theirs, strict=True)]
    row = {
        "pair": name,
        "plumb": statistics.median(ours),
        "manifold3d": statistics.median(theirs),
        "ratio": statistics.median(ratios),
        "least": min(ratios),
        "greatest": max(ratios),
        "valid": statistics.median(valid),
    }
    if cpp:
        row["cpp"] = statistics.median(in_cpp(cpp, a, b, rounds))
    return row


def call_overhead(calls=20000):
    """Microseconds of a call that does nothing, and of the union of two cubes."""
    empty = plumb.Solid()
    cubes = plumb.Solid.box((0, 0, 0), (2, 2, 2)), plumb.Solid.box((1, 1, 1), (3, 3, 3))

    def each(a, b):
        start = time.process_time()
        for _ in range(calls):
            a | b
        return (time.process_time() - start) / calls * 1e6

    return each(empty, empty), each(*cubes)


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("pairs", nargs="*", metavar="PAIR", help=", ".join(PAIRS))
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--cpp", help="the program space_peer")
    parser.add_argument("--json", type=pathlib.Path)
    arguments = parser.parse_args()
    plumb.keep_freed_memory()
    rows = []
    for name in arguments.pairs or PAIRS:
        row = compare(name, arguments.rounds, arguments.cpp)
        rows.append(row)
        text = (
            f"{name:16} plumb {row['plumb']:.4f} s, manifold3d {row['manifold3d']:.4f} s, "
            f"ratio {row['ratio']:.2f} ({row['least']:.2f} .. {row['greatest']:.2f}), "
            f"valid {row['valid']:.4f} s"
        )
        if "cpp" in row:
            text += f", beside C++ {row['plumb'] / row['cpp']:.3f}"
        print(text)
    nothing, cubes = call_overhead()
    print(f"a call           {nothing:.1f} us; the union of two cubes {cubes:.1f} us")
    if arguments.json:
        arguments.json.write_text(json.dumps({"pairs": rows, "call_us": nothing}, indent=1))


if __name__ == "__main__":
    main()
