"""What `plumb map repair, dissolve, simplify, overlay` and `plumb convex decompose` write is a coverage, in exact arithmetic.

    coverage_test.py PROGRAM [ROUNDS]
"""
import glob
import json
import os
import random
import subprocess
import sys
import tempfile

from coverage_judge import flaw, polygons_of

ULP = 2.0**-52


def require(condition, what):
    if not condition:
        sys.exit(what)


def run(program, *arguments):
    result = subprocess.run([program, *arguments, "--quiet"], capture_output=True, text=True)
    require(result.returncode == 0, "%s: exit %d\n%s" % (" ".join(arguments), result.returncode, result.stderr))
    return result.stdout


def square(x, y, side=1.0):
    return [[[x, y], [x + side, y], [x + side, y + side], [x, y + side], [x, y]]]


def check_judge():
    """The judge accepts coverages, and finds each kind of fault."""
    ring = square(0, 0, 8.0) + square(2, 2, 2.0)
    good = {
        "neighbours": [square(0, 0), square(1, 0), square(0, 1)],
        "corners": [square(0, 0), square(1, 1)],
        "a lake": [ring],
        "an island": [ring, square(2.5, 2.5)],
        "a filled lake": [ring, square(2, 2, 2.0)],
        "apart": [square(0, 0), square(4, 4)],
    }
    bad = {
        "overlap": [square(0, 0), square(0.5, 0.5)],
        "equal": [square(0, 0), square(0, 0)],
        "inside": [square(0, 0, 4.0), square(1, 1)],
        "a T": [square(0, 0, 2.0), square(2, 0)],
        "an overlap of half an ulp": [square(0, 0), square(1 - ULP / 2, 0)],
        "inside an island": [ring, square(2.5, 2.5), square(2.6, 2.6, 0.1)],
        "bow-tie": [[[[0, 0], [2, 2], [2, 0], [0, 2.5], [0, 0]]]],
        "inside at a corner": [[[[0, 0], [4, 0], [4, 4], [0, 0]]], [[[0, 0], [3, 1], [3, 2], [0, 0]]]],
    }
    for name, polygons in good.items():
        require(flaw(polygons) == "", "the judge rejects %s: %s" % (name, flaw(polygons)))
    for name, polygons in bad.items():
        require(flaw(polygons) != "", "the judge accepts %s" % name)
    require(flaw([square(0, 0), square(1 + 2 * ULP, 0)]) == "", "the judge rejects a gap")


def coordinate(dice, kind):
    if kind == 0:
        return dice.randint(0, 40) * 0.1
    if kind == 1:
        return 1 + dice.randint(0, 12) * ULP + dice.choice((0, 0, 3, 7))
    if kind == 2:
        return dice.randint(0, 9) + dice.randint(-8, 8) * ULP
    return dice.choice((dice.random(), dice.random() * 1e6, dice.randint(0, 5)))


def write_layer(path, dice, kind):
    features = []
    for i in range(dice.randint(2, 7)):
        ring = [[coordinate(dice, kind), coordinate(dice, kind)] for _ in range(dice.randint(3, 5))]
        geometry = {"type": "Polygon", "coordinates": [ring + ring[:1]]}
        features.append({"type": "Feature", "id": i, "properties": {"parity": i % 2}, "geometry": geometry})
    with open(path, "w") as out:
        json.dump({"type": "FeatureCollection", "features": features}, out)


def require_coverage(text, what):
    polygons = [p for feature in json.loads(text)["features"] for p in polygons_of(feature["geometry"])]
    require(flaw(polygons) == "", "%s: %s\n%s" % (what, flaw(polygons), text))


def check_layers(program, folder, dice, kind):
    paths = [os.path.join(folder, name) for name in ("a.geojson", "b.geojson")]
    for path in paths:
        write_layer(path, dice, kind)
    with open(paths[0]) as text:
        source = text.read()
    for words in (
        ("map", "repair", paths[0]),
        ("map", "repair", paths[0], "--gaps-below", "0"),
        ("map", "dissolve", paths[0], "--by", "parity"),
        ("map", "simplify", paths[0], "--percent", "30"),
        ("map", "simplify", paths[0], "--within", "0.3"),
        ("map", "overlay", *paths),
    ):
        require_coverage(run(program, *words, "--format", "geojson"), " ".join(words) + "\n" + source)


def check_pieces(program, folder, dice, kind):
    """The convex pieces of a set, written one by one, overlap nowhere. Their corners may lie on sides of others."""
    paths = [os.path.join(folder, name) for name in ("a.geojson", "b.geojson", "set.nef2", "pieces", "whole.wkt")]
    for path in paths[:2]:
        write_layer(path, dice, kind)
    run(program, "plane", "symmetric-difference", *paths[:2], "-o", paths[2])
    run(program, "convex", "decompose", paths[2], "--method", dice.choice(("cuts", "diagonals")), "-o", paths[3], "--format", "geojson")
    pieces = sorted(glob.glob(os.path.join(paths[3], "piece_*.geojson")))
    features = []
    for piece in pieces:
        with open(piece) as text:
            geometry = json.load(text)
        geometry = geometry.get("geometry", geometry)
        if geometry["type"] == "Polygon":
            features.append({"type": "Feature", "properties": None, "geometry": geometry})
    # Overlaps are found exactly by `map check`, which the judge of layers above has tested.
    with open(paths[0], "w") as out:
        json.dump({"type": "FeatureCollection", "features": features}, out)
    if features:
        report = subprocess.run([program, "map", "check", paths[0], "--json"], capture_output=True, text=True)
        require(json.loads(report.stdout)["overlaps"] == 0, "convex pieces overlap: " + report.stdout)
    for piece in pieces:
        os.remove(piece)


def main():
    program = os.path.abspath(sys.argv[1])
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 40
    check_judge()
    dice = random.Random(11)
    with tempfile.TemporaryDirectory() as folder:
        for i in range(rounds):
            check_layers(program, folder, dice, i % 4)
            check_pieces(program, folder, dice, i % 4)
    print("%d layers of each command and %d sets of pieces are coverages" % (rounds, rounds))


main()
