#!/usr/bin/env python3
"""Simplifying of layers beside mapshaper: layer_peer.py --plumb PROGRAM --mapshaper PROGRAM FOLDER

FOLDER has the unpacked npm packages us-atlas, world-atlas and swiss-maps as FOLDER/NAME/package. Each layer is first repaired by
plumb, so both programs start from the same coverage, and then simplified by both to 10 percent of its corners. A row says for each result: features with a geometry, their polygons, invalid features and whether
the features are a coverage (shapely, GEOS), by how much areas of features differ from the input (sum of the absolute
differences), corners, and CPU time of the command.

    npm pack us-atlas world-atlas swiss-maps; npm install mapshaper; pip install shapely
"""
import argparse
import json
import os
import resource
import subprocess
import tempfile

import shapely
from shapely.geometry import shape

LAYERS = (
    ("us-atlas", "us-atlas/package/counties-10m.json", "counties"),
    ("us-atlas", "us-atlas/package/states-10m.json", "states"),
    ("world-atlas", "world-atlas/package/countries-10m.json", "countries"),
    ("world-atlas", "world-atlas/package/countries-50m.json", "countries"),
    ("swiss-maps", "swiss-maps/package/2024/ch-combined.json", "municipalities"),
)


def cpu(command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def features(path):
    with open(path) as text:
        return [shape(f["geometry"]) if f["geometry"] else None for f in json.load(text)["features"]]


def judged(name, path, before, seconds):
    after = features(path)
    cells = [cell for cell in after if cell is not None]
    invalid = sum(not cell.is_valid for cell in cells)
    # A feature that is lost altogether shifts the others, so areas are only compared if none is.
    moved = "-"
    if len(after) == len(before):
        moved = "%.4g" % sum(abs((a.area if a else 0) - (b.area if b else 0)) for a, b in zip(after, before))
    coverage = "yes" if shapely.coverage_is_valid(cells) else "no"
    corners = sum(shapely.get_num_coordinates(cell) for cell in cells)
    polygons = sum(shapely.get_num_geometries(cell) for cell in cells)
    return "| %s | %d | %d | %d | %s | %s | %d | %.2f s |" % (name, len(cells), polygons, invalid, coverage, moved, corners, seconds)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--plumb", required=True)
    parser.add_argument("--mapshaper", required=True)
    parser.add_argument("folder")
    arguments = parser.parse_args()
    print("| layer | program | features | polygons | invalid | coverage | area moved | corners | time |")
    print("|---|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as scratch:
        whole, ours, theirs = (os.path.join(scratch, name) for name in ("in.geojson", "a.geojson", "b.geojson"))
        for package, file, layer in LAYERS:
            path = os.path.join(arguments.folder, file)
            subprocess.run([arguments.plumb, "map", "repair", path, "--object", layer, "-o", whole], check=True, capture_output=True)
            before = features(whole)
            seconds = cpu([arguments.plumb, "map", "simplify", whole, "--percent", "10", "-o", ours])
            title = "%s %s" % (package, os.path.basename(file).replace(".json", "") + ", " + layer)
            print("| %s %s" % (title, judged("| plumb", ours, before, seconds)[1:].strip()))
            seconds = cpu([arguments.mapshaper, whole, "-simplify", "10%", "visvalingam", "planar", "keep-shapes", "-o", theirs,
                           "format=geojson"])
            print("| %s %s" % (title, judged("| mapshaper", theirs, before, seconds)[1:].strip()), flush=True)


if __name__ == "__main__":
    main()
