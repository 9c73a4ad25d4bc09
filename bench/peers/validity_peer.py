#!/usr/bin/env python3
"""Defects of single features beside GEOS: validity_peer.py --plumb PROGRAM [--features N] [--seed S]

A feature has one or two random polygons of one to three random rings on a grid of 10 x 10. `plumb map check` reports crossings,
nestings and overlaps of a feature with itself, and GEOS says whether the multipolygon is valid, and if not, why. A row counts the
features with the same two answers. The answers agree if both find a flaw or none does. Some flaws of GEOS are no defects of a layer:
rings that touch themselves or each other at points, and a common border of polygons of one feature. The exit code is 1 if the
program reports a defect of a feature that is valid.

    pip install shapely
"""
import argparse
import collections
import json
import os
import random
import subprocess
import sys
import tempfile

import shapely
from shapely.geometry import shape


def random_ring(dice):
    def place():
        return dice.randint(0, 6)

    if dice.random() < 0.5:
        x, y, width, height = place(), place(), dice.randint(1, 3), dice.randint(1, 3)
        ring = [[x, y], [x + width, y], [x + width, y + height], [x, y + height]]
        if dice.random() < 0.5:
            ring.reverse()
    else:
        ring = []
        while len(ring) < 3 or len(ring) < 5 and dice.random() < 0.5:
            position = [place(), place()]
            if position not in ring:
                ring.append(position)
    return ring + ring[:1]


def random_feature(number, dice):
    polygons = [[random_ring(dice) for _ in range(dice.choice((1, 1, 2, 2, 3)))] for _ in range(dice.choice((1, 1, 1, 1, 2)))]
    moved = [[[[x + 100 * number, y] for x, y in ring] for ring in rings] for rings in polygons]
    return {"type": "Feature", "id": number, "properties": None, "geometry": {"type": "MultiPolygon", "coordinates": moved}}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--plumb", required=True)
    parser.add_argument("--features", type=int, default=5000)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    dice = random.Random(arguments.seed)
    features = [random_feature(number, dice) for number in range(arguments.features)]
    with tempfile.TemporaryDirectory() as scratch:
        path = os.path.join(scratch, "layer.geojson")
        with open(path, "w") as out:
            json.dump({"type": "FeatureCollection", "features": features}, out)
        command = [arguments.plumb, "map", "check", path, "--json", "--enclosed-only"]
        report = json.loads(subprocess.run(command, capture_output=True, text=True).stdout)
    ours = collections.defaultdict(set)
    for region in report["regions"]:
        if region["kind"] in ("crossing", "nesting", "overlap") and len(region["features"]) == 1:
            ours[region["features"][0]["id"]].add(region["kind"])
    rows = collections.Counter()
    for feature in features:
        geometry = shape(feature["geometry"])
        reason = "valid" if geometry.is_valid else shapely.is_valid_reason(geometry).split("[")[0]
        rows[reason, ", ".join(sorted(ours[feature["id"]])) or "none"] += 1
    print("| GEOS | defects of plumb | features |\n|---|---|---|")
    for (reason, defects), count in sorted(rows.items()):
        print("| %s | %s | %d |" % (reason, defects, count))
    sys.exit(any(reason == "valid" and defects != "none" for reason, defects in rows))


if __name__ == "__main__":
    main()
