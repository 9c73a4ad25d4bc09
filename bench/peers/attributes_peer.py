#!/usr/bin/env python3
"""Texture coordinates through a Boolean, beside manifold3d: attributes_peer.py --library FILE

Unions and differences of two meshes with random texture coordinates at their vertices: two spheres
of --depth, or two files --pair A.off B.off. FILE is the shared library of the C interface of plumb,
which is called with the arrays that manifold3d gets as properties of vertices, in the same process.
At random points of the faces of each result, the texture coordinates are compared with those of the
source triangle that contains the point, which is found by brute force. A row has the greatest
difference for each library, the CPU time from arrays to arrays without and with texture
coordinates, and the ratio of the two, in the median of ROUNDS runs one after the other. The mesh of
plumb is valid after rounding in both cases.

    pip install numpy manifold3d
"""

import argparse
import ctypes
import statistics
import time

import manifold3d
import numpy as np

SAMPLES = 2000
OPERATIONS = {"union": 14, "difference": 2}  # Constants of plumb_operation in plumb.h.


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


def read_off(path):
    """Returns the points and the triangles of a text file of OFF."""
    with open(path) as file:
        words = file.read().split()
    count, faces = int(words[1]), int(words[2])
    points = np.array(words[4:4 + 3 * count], float).reshape(-1, 3)
    rows = np.array(words[4 + 3 * count:4 + 3 * count + 4 * faces], np.int64).reshape(-1, 4)
    assert (rows[:, 0] == 3).all(), "only triangles"
    return points.astype(np.float32), rows[:, 1:].astype(np.uint32)


class Plumb:
    """The functions of the C interface that unite two meshes."""

    def __init__(self, path):
        self.functions = ctypes.CDLL(path)
        self.functions.plumb_error_text.restype = ctypes.c_char_p
        for name, numbers in (("points", ctypes.c_double), ("corners", ctypes.c_uint32)):
            getattr(self.functions, "plumb_mesh_" + name).restype = ctypes.POINTER(numbers)
        self.functions.plumb_mesh_channel_values.restype = ctypes.POINTER(ctypes.c_double)
        for name in ("point", "face", "corner"):
            getattr(self.functions, "plumb_mesh_%s_count" % name).restype = ctypes.c_size_t

    def call(self, name, *arguments):
        """Calls a function whose last parameter is the error."""
        error = ctypes.c_void_p()
        if getattr(self.functions, name)(*arguments, ctypes.byref(error)) != 0:
            raise RuntimeError(self.functions.plumb_error_text(error).decode())

    def made(self, name, *arguments, after=()):
        """Returns what a function makes; its parameter stands before those in `after`."""
        out = ctypes.c_void_p()
        self.call(name, *arguments, ctypes.byref(out), *after)
        return out

    def solid(self, points, faces, uv):
        """Returns the solid of arrays, with texture coordinates if `uv` is given."""
        size = ctypes.c_size_t
        arrays = (points.ctypes.data_as(ctypes.c_void_p), size(len(points)),
                  faces.ctypes.data_as(ctypes.c_void_p), size(len(faces)))
        if uv is None:
            return self.made("plumb_solid_from_triangles", *arrays, None, after=(None,))
        mesh = self.made("plumb_mesh_from_triangles", *arrays)
        self.call("plumb_mesh_set_channel", mesh, b"texcoord_0", ctypes.c_uint32(2), 1,
                  uv.ctypes.data_as(ctypes.c_void_p), size(len(uv)))
        solid = self.made("plumb_solid_from_mesh", mesh, None, after=(None,))
        self.functions.plumb_mesh_free(mesh)
        return solid

    def run(self, operation, a, b, has_uv):
        """Returns the result and the CPU time."""
        sources = [(p.astype(float), f, u if has_uv else None) for p, f, u in (a, b)]
        start = time.process_time()
        first, second = (self.solid(*source) for source in sources)
        both = self.made("plumb_solid_combine", first, second, OPERATIONS[operation],
                         after=(None,))
        if has_uv:
            mesh = self.made("plumb_solid_to_mesh_with_attributes", both, None,
                             after=(None, None))
        else:
            mesh = self.made("plumb_solid_to_mesh", both, None, after=(None, None))
        seconds = time.process_time() - start
        result = self.arrays(mesh) if has_uv else None
        for solid in (first, second, both):
            self.functions.plumb_solid_free(solid)
        self.functions.plumb_mesh_free(mesh)
        return result, seconds

    def arrays(self, mesh):
        """Returns points, triangles and texture coordinates, all per corner."""
        corners = self.functions.plumb_mesh_corner_count(mesh)
        points = self.functions.plumb_mesh_point_count(mesh)
        copied = np.ctypeslib.as_array
        at = copied(self.functions.plumb_mesh_points(mesh), (points, 3))
        faces = copied(self.functions.plumb_mesh_corners(mesh), (corners,))
        uv = copied(self.functions.plumb_mesh_channel_values(mesh, ctypes.c_size_t(0)), (corners, 2))
        return at[faces], np.arange(corners).reshape(-1, 3), uv.copy()


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
    parser.add_argument("--library", dest="shared_library", required=True, help="the shared library of plumb")
    parser.add_argument("--depth", type=int, nargs="*", default=[3, 4, 5],
                        help="spheres of 20 * 4**DEPTH triangles")
    parser.add_argument("--pair", nargs=2, action="append", default=[], metavar=("A", "B"))
    parser.add_argument("--rounds", type=int, default=9)
    options = parser.parse_args()
    plumb = Plumb(options.shared_library)
    rows = [("spheres", [icosphere(depth, np.array(centre))
                         for centre in ((0, 0, 0), (0.53, 0.31, 0.17))])
            for depth in options.depth]
    rows += [(pair[0], [read_off(path) for path in pair]) for pair in options.pair]
    print("| meshes, triangles of both | operation | greatest difference, plumb and manifold3d "
          "| plumb without, with | ratio | manifold3d without, with | ratio |")
    print("|---|---|---|---|---|---|---|")
    for name, meshes in rows:
        random = np.random.default_rng(1)
        sources = [(points, faces,
                    random.random((len(points), 2)).astype(np.float32).astype(float))
                   for points, faces in meshes]
        for operation in ("union", "difference"):
            measured = {plumb.run: [], run_manifold: []}
            results = {}
            for _ in range(options.rounds + 1):
                for run, pairs in measured.items():
                    without = run(operation, *sources, False)[1]
                    results[run], time_with = run(operation, *sources, True)
                    pairs.append((without, time_with))
            cells = []
            for pairs in measured.values():
                counted = pairs[1:]  # The first round is not counted.
                cells.append("%.4f s, %.4f s" % tuple(map(statistics.median, zip(*counted))))
                cells.append("%.2f" % statistics.median(b / a for a, b in counted))
            worst = [greatest_difference(results[run], sources, 2) for run in measured]
            triangles = sum(len(faces) for _, faces in meshes)
            print("| %s, %s | %s | %.1e, %.1e | %s |"
                  % (name, format(triangles, ","), operation, *worst, " | ".join(cells)))


if __name__ == "__main__":
    main()
