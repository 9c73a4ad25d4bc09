#!/usr/bin/env python3
"""Repair and union of layers beside GEOS, mapshaper and Clipper2: coverage_peer.py --plumb PROGRAM --mapshaper PROGRAM FOLDER

FOLDER has the unpacked npm packages us-atlas, world-atlas and swiss-maps as FOLDER/NAME/package, or as FOLDER/NAME. All programs
read the same GeoJSON file, which mapshaper has made of the TopoJSON of the package. Columns of the first table: features
with a geometry, features that are not valid (GEOS), coverage (GEOS, and the exact judge of tests/system), area moved (the sum
of the absolute changes of the areas of features), and the CPU time of the command, reading and writing included. Columns of the
second table: polygons, invalid ones, area, and CPU time. `call` is the CPU time of the call alone, without files.

    npm pack us-atlas world-atlas swiss-maps; npm install mapshaper; pip install 'shapely>=2.2' pyclipr
"""
import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile
import time

import numpy
import shapely
from shapely.geometry import shape

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../tests/system"))
from coverage_judge import flaw, polygons_of  # noqa: E402

LAYERS = (
    ("us-atlas", "counties-10m.json", "counties"),
    ("us-atlas", "states-10m.json", "states"),
    ("world-atlas", "countries-10m.json", "countries"),
    ("world-atlas", "countries-50m.json", "countries"),
    ("swiss-maps", "2024/ch-combined.json", "municipalities"),
)


def child_cpu(command, may_fail=False):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0 and may_fail:
        return None, None
    if done.returncode != 0:
        sys.exit("%s: %s" % (command, done.stderr))
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, done.stdout


def read(path):
    with open(path) as text:
        collection = json.load(text)
    # mapshaper writes features without properties as a GeometryCollection.
    return collection.get("features") or [{"geometry": geometry} for geometry in collection["geometries"]]


def write(path, geometries):
    features = [{"type": "Feature", "properties": None, "geometry": None if g.is_empty else json.loads(shapely.to_geojson(g))}
                for g in geometries]
    with open(path, "w") as out:
        json.dump({"type": "FeatureCollection", "features": features}, out)


def worker(what, source, target):
    """Runs one call of GEOS or Clipper2 between two files, and prints its CPU time."""
    geometries = [shape(f["geometry"]) if f["geometry"] else shapely.Polygon() for f in read(source)]
    if what == "union_all":
        geometries = [g if g.is_valid else g.buffer(0) for g in geometries]  # Else it fails for four of the layers.
    if what == "clipper2":
        import pyclipr

        paths = [numpy.asarray(ring.coords)[:-1] for g in geometries for p in getattr(g, "geoms", [g])
                 for ring in (shapely.geometry.polygon.orient(p).exterior, *shapely.geometry.polygon.orient(p).interiors)]
        clipper = pyclipr.Clipper()
        clipper.scaleFactor = 10**10
        clipper.addPaths(paths, pyclipr.Subject)
        start = time.process_time()
        result = clipper.execute(pyclipr.Union, pyclipr.FillRule.NonZero)
        seconds = time.process_time() - start
        rings = [shapely.Polygon(r) for r in result if len(r) >= 3]
        write(target, [shapely.MultiPolygon(rings)])
    else:
        call = {
            "coverage_clean": lambda: list(shapely.coverage_clean(geometries)),
            "union_all": lambda: [shapely.union_all(geometries)],
            "coverage_union_all": lambda: [shapely.coverage_union_all(geometries)],
        }[what]
        start = time.process_time()
        result = call()
        seconds = time.process_time() - start
        write(target, result)
    print(seconds)


def repair_row(title, program, path, before, seconds, call):
    features = read(path)
    after = [shape(f["geometry"]) if f["geometry"] else None for f in features]
    cells = [cell for cell in after if cell is not None and not cell.is_empty]
    invalid = sum(not cell.is_valid for cell in cells)
    moved = "-"
    if len(after) == len(before):
        moved = "%.3g" % sum(abs((a.area if a else 0) - b.area) for a, b in zip(after, before))
    geos = "yes" if shapely.coverage_is_valid(cells) else "no"
    exact = "no" if flaw([p for f in features for p in polygons_of(f["geometry"])]) else "yes"
    print("| %s | %s | %d | %d | %s | %s | %s | %.2f s | %s |" % (title, program, len(cells), invalid, geos, exact, moved, seconds, call),
          flush=True)


def union_row(title, program, path, seconds, call):
    parts = [p for f in read(path) if f["geometry"] for p in getattr(shape(f["geometry"]), "geoms", [shape(f["geometry"])])]
    rings = program.startswith("Clipper2")
    invalid = "-" if rings else str(sum(not p.is_valid for p in parts))
    area = sum(p.area for p in parts)
    print("| %s | %s | %s | %s | %s | %.2f s | %s |" % (title, program, "-" if rings else len(parts), invalid,
                                                     "-" if rings else "%.9g" % area, seconds, call), flush=True)


def main():
    if len(sys.argv) == 5 and sys.argv[1] == "--worker":
        return worker(*sys.argv[2:])
    parser = argparse.ArgumentParser()
    parser.add_argument("--plumb", required=True)
    parser.add_argument("--mapshaper", required=True)
    parser.add_argument("folder")
    arguments = parser.parse_args()
    me = [sys.executable, os.path.abspath(__file__), "--worker"]
    with tempfile.TemporaryDirectory() as scratch:
        sources = []
        for package, file, layer in LAYERS:
            path = os.path.join(arguments.folder, package, "package", file)
            if not os.path.exists(path):
                path = os.path.join(arguments.folder, package, file)
            source = os.path.join(scratch, "%d.geojson" % len(sources))
            child_cpu([arguments.mapshaper, path, "-target", layer, "-o", source, "format=geojson"])
            title = "%s %s, %s" % (package, os.path.basename(file).replace(".json", ""), layer)
            sources.append((title, source))
        target = os.path.join(scratch, "out.geojson")
        print("| layer | program | features | invalid | coverage (GEOS) | coverage (exact) | area moved | time | call |")
        print("|---|---|---|---|---|---|---|---|---|")
        for title, source in sources:
            before = [shape(f["geometry"]).buffer(0) if f["geometry"] else shapely.Polygon() for f in read(source)]
            seconds, _ = child_cpu([arguments.plumb, "map", "repair", source, "-o", target])
            repair_row(title, "plumb", target, before, seconds, "-")
            seconds, call = child_cpu([*me, "coverage_clean", source, target])
            repair_row(title, "GEOS `coverage_clean`", target, before, seconds, "%.2f s" % float(call))
            seconds, _ = child_cpu([arguments.mapshaper, source, "-clean", "-o", target, "format=geojson"])
            repair_row(title, "mapshaper `-clean`", target, before, seconds, "-")
        print("\n| layer | program | polygons | invalid | area | time | call |")
        print("|---|---|---|---|---|---|---|")
        for title, source in sources:
            seconds, _ = child_cpu([arguments.plumb, "map", "dissolve", source, "-o", target])
            union_row(title, "plumb", target, seconds, "-")
            for what in ("union_all", "coverage_union_all"):
                seconds, call = child_cpu([*me, what, source, target], may_fail=True)
                if seconds is None:
                    print("| %s | GEOS `%s` | fails | | | | |" % (title, what), flush=True)
                    continue
                union_row(title, "GEOS `%s`" % what, target, seconds, "%.2f s" % float(call))
            seconds, call = child_cpu([*me, "clipper2", source, target])
            union_row(title, "Clipper2, rounds to 1e-10", target, seconds, "%.2f s" % float(call))
            seconds, _ = child_cpu([arguments.mapshaper, source, "-dissolve", "-o", target, "format=geojson"])
            union_row(title, "mapshaper `-dissolve`", target, seconds, "-")


main()
