#!/usr/bin/env python3
"""Texture coordinates of real models: textured_models.py --plumb PROGRAM MODEL.glb ...

Subtracts a sphere from every model, and unites the two. The centre of the sphere is a corner of
the model, its radius a quarter of the longest side of the model's box. At random points of those faces of
each result that come from the model, the texture coordinates are compared with those of the model's
triangles that contain the point. These are found by brute force in the file that trimesh reads. The
table has, for each model and operation, the number of these faces, the number of points compared,
the greatest difference of texture coordinates, and the number of points that no triangle of the
model contains. The exit status is 1 if there is such a point or a difference above 1e-9.

    npm pack @webxr-input-profiles/assets
    pip install numpy trimesh pillow scipy
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
import trimesh

SAMPLES = 500
GREATEST = 1e-9


def triangles_of(path):
    """Returns the corners of all triangles of a file, and their texture coordinates."""
    loaded = trimesh.load(path, process=False, force="scene")
    corners, values = [], []
    for node in loaded.graph.nodes_geometry:
        matrix, name = loaded.graph[node]
        mesh = loaded.geometry[name]
        uv = getattr(mesh.visual, "uv", None)
        if uv is None:
            uv = np.full((len(mesh.vertices), 2), np.nan)
        corners.append(trimesh.transform_points(mesh.vertices, matrix)[mesh.faces])
        values.append(np.asarray(uv, float)[mesh.faces])
    return np.concatenate(corners), np.concatenate(values)


def result_of(path):
    """Returns the faces of an OBJ file that have a texture: for each, its corners and their values.

    Faces of the sphere and faces that fill holes have the texture coordinates 0, 0 at all corners.
    """
    points, uv, faces = [], [], []
    for line in pathlib.Path(path).read_text().split("\n"):
        word, *rest = line.split() or [""]
        if word == "v":
            points.append([float(x) for x in rest[:3]])
        elif word == "vt":
            uv.append([float(x) for x in rest[:2]])
        elif word == "f":
            indices = [corner.split("/") for corner in rest]
            values = np.array([uv[int(corner[1]) - 1] for corner in indices])
            if values.any():
                faces.append((np.array([points[int(corner[0]) - 1] for corner in indices]), values))
    return faces


def area_of(polygon):
    """Returns the area of a polygon in a plane."""
    cones = np.cross(polygon - polygon[0], np.roll(polygon, -1, axis=0) - polygon[0])
    return np.linalg.norm(cones.sum(axis=0)) / 2


def weights_in(triangles, point):
    """Returns the weights of a point in each triangle, and its distances from their planes."""
    a, b, c = triangles[:, 0], triangles[:, 1], triangles[:, 2]
    normal = np.cross(b - a, c - a)
    square = np.einsum("ij,ij->i", normal, normal)
    with np.errstate(divide="ignore", invalid="ignore"):
        v = np.einsum("ij,ij->i", np.cross(point - a, c - a), normal) / square
        w = np.einsum("ij,ij->i", np.cross(b - a, point - a), normal) / square
        off = np.abs(np.einsum("ij,ij->i", point - a, normal)) / np.sqrt(square)
    return np.stack([1 - v - w, v, w], axis=1), off


def compare(source, result, size):
    """Returns how many points were compared, the greatest difference, and points without source."""
    source_corners, source_values = source
    random = np.random.default_rng(1)
    area = np.array([area_of(corners) for corners, _ in result])
    compared, worst, without = 0, 0.0, 0
    for face in random.choice(len(result), SAMPLES, p=area / area.sum()):
        # A face is a part of one triangle of the model. So is any point between its corners.
        corners, values = result[face]
        weight = random.dirichlet(np.ones(len(corners)))
        weights, off = weights_in(source_corners, weight @ corners)
        is_in = (weights.min(axis=1) > -1e-9) & (off < 1e-9 * size)
        if not is_in.any():
            without += 1
            continue
        # Faces that lie on each other have several values, one of which the result has.
        found = np.einsum("ij,ijk->ik", weights[is_in], source_values[is_in])
        worst = max(worst, np.abs(found - weight @ values).max(axis=1).min())
        compared += 1
    return compared, worst, without


def run(program, *arguments):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit("%s %s\n%s" % (program, " ".join(map(str, arguments)), done.stderr))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--plumb", required=True, help="the program")
    parser.add_argument("models", nargs="+", metavar="MODEL.glb")
    options = parser.parse_args()
    is_right = True
    print("%-28s %-11s %7s %9s %11s %10s"
          % ("model", "operation", "faces", "compared", "difference", "no source"))
    with tempfile.TemporaryDirectory() as name:
        sphere, moved, out = (pathlib.Path(name) / n for n in ("s.off", "t.off", "out.obj"))
        for model in options.models:
            source = triangles_of(model)
            points = source[0].reshape(-1, 3)
            size = np.ptp(points, axis=0).max()
            centre = points[np.argmax(points @ [1, 0.5, 0.25])]
            run(options.plumb, "solid", "make", "sphere", "--segments", 40, "--radius",
                repr(float(size / 4)), "-o", sphere)
            run(options.plumb, "solid", "transform", sphere, "--translate",
                ",".join(repr(float(x)) for x in centre), "-o", moved)
            for operation in ("union", "difference"):
                run(options.plumb, "solid", operation, model, moved, "--reorient", "--fill-holes",
                    100, "-o", out)
                result = result_of(out)
                compared, worst, without = compare(source, result, size)
                is_right &= without == 0 and worst <= GREATEST
                print("%-28s %-11s %7d %9d %11.1e %10d" % ("/".join(pathlib.Path(model).parts[-2:]),
                                                          operation, len(result), compared, worst,
                                                          without))
    return 0 if is_right else 1


if __name__ == "__main__":
    sys.exit(main())
