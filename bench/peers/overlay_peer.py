#!/usr/bin/env python3
"""Overlays of layers that nearly coincide, judged by GEOS: overlay_peer.py --plumb PROGRAM FOLDER

FOLDER has the unpacked npm package swiss-maps 4.7.0 as FOLDER/swiss-maps/package, as FOLDER/swiss-maps-VERSION/package, or as
FOLDER/swiss-maps. The program overlays municipalities with districts and with cantons, some of which are of another year. A row
says for each result: its features, which are pairs of a feature of each layer; pairs that are not valid, and pairs of these pairs
whose interiors meet, both by GEOS; whether the result is a coverage, by GEOS and by the exact judge of tests/system; and the CPU
time of the command, reading and writing included. The exit code is 1 if a result is no coverage.

    npm pack swiss-maps@4.7.0; pip install shapely
"""
import argparse
import json
import os
import sys
import tempfile

import shapely
from shapely.geometry import shape

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../tests/system"))
from coverage_judge import flaw, polygons_of  # noqa: E402
from layer_peer import cpu  # noqa: E402

FILE = "ch-combined.json"
PAIRS = [(year, layer) for year in ("2024", "2010", "2021-04") for layer in ("districts", "cantons")]
INTERIORS_MEET = "T********"


def package_folder(folder):
    for entry in sorted(os.listdir(folder)):
        if entry == "swiss-maps" or entry.startswith("swiss-maps-"):
            for path in (os.path.join(folder, entry, "package"), os.path.join(folder, entry)):
                if os.path.exists(os.path.join(path, "2024", FILE)):
                    return path
    sys.exit("%s has no package swiss-maps" % folder)


def overlaps_of(cells):
    """Returns the number of pairs of cells whose interiors meet. GEOS relates valid cells only."""
    a, b = shapely.STRtree(cells).query(cells, predicate="intersects")
    return sum(shapely.relate_pattern(cells[i], cells[j], INTERIORS_MEET) for i, j in zip(a, b) if i < j)


def row(plumb, package, year, layer, out):
    first, second = os.path.join(package, year, FILE), os.path.join(package, "2024", FILE)
    seconds = cpu([plumb, "map", "overlay", first, second, "--object", "municipalities", "--object-b", layer, "-o", out])
    with open(out) as text:
        features = json.load(text)["features"]
    cells = [shape(f["geometry"]) for f in features if f["geometry"]]
    invalid = sum(not cell.is_valid for cell in cells)
    overlaps = "-" if invalid else str(overlaps_of(cells))
    geos = bool(shapely.coverage_is_valid(cells))
    exact = not flaw([p for f in features for p in polygons_of(f["geometry"])])
    words = {True: "yes", False: "no"}
    print("| municipalities %s, %s 2024 | %d | %d | %s | %s, %s | %.2f s |" % (
        year, layer, len(features), invalid, overlaps, words[geos], words[exact], seconds), flush=True)
    return geos and exact and overlaps == "0"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--plumb", required=True)
    parser.add_argument("folder")
    arguments = parser.parse_args()
    package = package_folder(arguments.folder)
    print("| layers | pairs | invalid | overlaps | coverage | time |\n|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as scratch:
        out = os.path.join(scratch, "overlay.geojson")
        good = [row(arguments.plumb, package, year, layer, out) for year, layer in PAIRS]
    sys.exit(0 if all(good) else 1)


if __name__ == "__main__":
    main()
