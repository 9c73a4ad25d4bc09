"""What `plumb plane` and `plumb map overlay, repair, dissolve, simplify` write is valid for another library: shapely (GEOS) reads it
and finds nothing wrong. Exits with 77, which ctest counts as skipped, where shapely is not installed.

    shapely_test.py PROGRAM [PAIRS]
"""
import json
import os
import random
import subprocess
import sys
import tempfile

from coverage_judge import flaw, polygons_of

try:
    import shapely
    from shapely.geometry import shape
    from shapely.validation import explain_validity
except ImportError:
    print("no shapely here")
    sys.exit(77)

ULP = 2.0**-52
OPERATIONS = ("union", "intersection", "difference", "symmetric_difference")
COMMANDS = {"symmetric_difference": "symmetric-difference"}


def coordinate(dice, kind):
    if kind == 0:
        return dice.randint(0, 40) * 0.1
    if kind == 1:
        return 1 + dice.randint(0, 12) * ULP + dice.choice((0, 0, 3, 7))
    if kind == 2:
        return dice.randint(0, 9) + dice.randint(-8, 8) * ULP
    return dice.choice((dice.random(), dice.random() * 1e6, dice.randint(0, 5)))


def polygon(dice, kind):
    points = [(coordinate(dice, kind), coordinate(dice, kind)) for _ in range(dice.randint(3, 7))]
    return "POLYGON ((%s))\n" % ", ".join("%r %r" % p for p in points + points[:1])


def run(program, *arguments):
    result = subprocess.run([program, *arguments, "--quiet"], capture_output=True, text=True)
    if result.returncode != 0:
        sys.exit("%s: exit %d\n%s" % (" ".join(arguments), result.returncode, result.stderr))
    return result.stdout


def require_valid(geometry, what):
    if not geometry.is_valid:
        sys.exit("%s: %s\n%s" % (what, explain_validity(geometry), geometry.wkt))


def check_pair(program, folder, dice):
    kind = dice.randint(0, 3)
    paths = [os.path.join(folder, name) for name in ("a.wkt", "b.wkt")]
    texts = [polygon(dice, kind) for _ in paths]
    for path, text in zip(paths, texts):
        with open(path, "w") as out:
            out.write(text)
    operation = dice.choice(OPERATIONS)
    command = ("plane", COMMANDS.get(operation, operation), *paths)
    what = operation + " of\n" + "".join(texts)
    require_valid(shapely.from_wkt(run(program, *command, "--format", "wkt")), what)
    require_valid(shape(json.loads(run(program, *command, "--format", "geojson"))), what)
    require_valid(shapely.from_wkt(run(program, *command, "--format", "wkt", "--grid", "0.01")), "grid, " + what)


def check_results(program, folder, dice):
    """Whatever a command makes of sets is valid, in each format."""
    kind = dice.choice((0, 2, 3))
    paths = [os.path.join(folder, name) for name in ("a.wkt", "b.wkt", "out.wkb")]
    texts = [polygon(dice, kind) for _ in paths[:2]]
    for path, text in zip(paths, texts):
        with open(path, "w") as out:
            out.write(text)
    a, b, wkb = paths
    for words in (
        ("regularize", a),
        ("boundary", a),
        ("minkowski", a, b),
        ("offset", a, "--by", "0.37", "--segments", "16"),
        ("offset", a, "--by", "-0.11", "--join", "mitre"),
        ("simplify", a, "--percent", "40"),
        ("simplify", a, "--within", "0.4"),
        ("voronoi", a),
        ("arrange", a, b),
    ):
        what = " ".join(words) + " of\n" + "".join(texts)
        is_layer = words[0] in ("voronoi", "arrange")
        if is_layer:
            features = json.loads(run(program, "plane", *words, "--format", "geojson"))["features"]
            for feature in features:
                if feature["geometry"]:  # Else nothing remains of it in doubles.
                    require_valid(shape(feature["geometry"]), what)
            continue
        geometry = shapely.from_wkt(run(program, "plane", *words, "--format", "wkt"))
        require_valid(geometry, what)
        run(program, "plane", *words, "-o", wkb)
        with open(wkb, "rb") as file:
            if shapely.to_wkb(shapely.from_wkb(file.read())) != shapely.to_wkb(geometry):
                sys.exit("WKB and WKT differ: " + what)


def check_overlay(program, dice, folder):
    """Two maps of strips that are turned against each other: the cells are a coverage."""
    paths = []
    for name in ("a.map", "b.map"):
        count = dice.randint(2, 6)
        low = sorted(dice.random() for _ in range(count - 1))
        high = sorted(dice.random() for _ in range(count - 1))
        points = [(0.0, 0.0)] + [(x, 0.0) for x in low] + [(1.0, 0.0)]
        points += [(0.0, 1.0)] + [(x, 1.0) for x in high] + [(1.0, 1.0)]
        if name == "b.map":
            points = [(y, x) for x, y in points]
        top = count + 1
        cycles = [[i, i + 1, top + i + 1, top + i] for i in range(count)]
        if name == "b.map":
            cycles = [cycle[::-1] for cycle in cycles]
        lines = ["%d %d" % (len(points), len(cycles))] + ["%r %r" % p for p in points]
        lines += [" ".join(str(i + 1) for i in c) for c in cycles]
        paths.append(os.path.join(folder, name))
        with open(paths[-1], "w") as out:
            out.write("\n".join(lines) + "\n")
    text = run(program, "map", "overlay", *paths, "--infer-outer", "--format", "geojson")
    cells = [shape(feature["geometry"]) for feature in json.loads(text)["features"]]
    for cell in cells:
        require_valid(cell, "a cell of an overlay")
    if hasattr(shapely, "coverage_is_valid") and not shapely.coverage_is_valid(cells):
        sys.exit("the cells of an overlay are no coverage:\n" + text)


def check_repair(program, dice, folder):
    """Random polygons on each other: the repaired layer is a coverage of the same points."""
    kind = dice.randint(0, 3)
    rings = [[[coordinate(dice, kind), coordinate(dice, kind)] for _ in range(3)] for _ in range(dice.randint(2, 6))]
    features = [{"type": "Feature", "id": i, "properties": None,
                 "geometry": {"type": "Polygon", "coordinates": [ring + ring[:1]]}} for i, ring in enumerate(rings)]
    path = os.path.join(folder, "a.geojson")
    with open(path, "w") as out:
        json.dump({"type": "FeatureCollection", "features": features}, out)
    text = run(program, "map", "repair", path, "--gaps-below", "0", "--format", "geojson")
    cells = [shape(feature["geometry"]) for feature in json.loads(text)["features"] if feature["geometry"]]
    for cell in cells:
        require_valid(cell, "a feature of the repaired layer of " + json.dumps(features))
    # GEOS computes in doubles, and finds edges that do not match where corners differ in the last bits only.
    if kind in (0, 3) and hasattr(shapely, "coverage_is_valid") and not shapely.coverage_is_valid(cells):
        sys.exit("a repaired layer is no coverage:\n" + text)
    polygons = [p for feature in json.loads(text)["features"] for p in polygons_of(feature["geometry"])]
    if wrong := flaw(polygons):
        sys.exit("a repaired layer is no coverage: %s\n%s" % (wrong, text))
    if kind == 3:
        return  # Areas of very different sizes.
    before = shapely.union_all([shape(feature["geometry"]).buffer(0) for feature in features]).area
    after = sum(cell.area for cell in cells)
    if abs(before - after) > 1e-9 + (0 if kind == 0 else 200 * ULP):
        sys.exit("a repaired layer has area %r instead of %r:\n%s" % (after, before, text))


def strips(dice, corners, is_turned):
    """A layer of strips with wobbly borders, whose corners are multiples of 1/1024, so GEOS computes exactly."""
    count = dice.randint(2, 5)
    borders = [[(i * 8 + dice.randint(-3000, 3000) / 1024 * (0 < i < count), j * 40 / corners) for j in range(corners + 1)]
               for i in range(count + 1)]
    features = []
    for i in range(count):
        ring = borders[i] + borders[i + 1][::-1]
        ring = [[y, x] if is_turned else [x, y] for x, y in ring]
        features.append({"type": "Feature", "id": i, "properties": {"parity": i % 2, "n": i},
                         "geometry": {"type": "Polygon", "coordinates": [ring + ring[:1]]}})
    return {"type": "FeatureCollection", "features": features}


def require_coverage(text, what):
    cells = [shape(feature["geometry"]) for feature in json.loads(text)["features"] if feature["geometry"]]
    for cell in cells:
        require_valid(cell, what)
    if hasattr(shapely, "coverage_is_valid") and not shapely.coverage_is_valid(cells):
        sys.exit(what + " is no coverage:\n" + text)
    return sum(cell.area for cell in cells)


def check_layers(program, dice, folder):
    """What dissolving, simplifying and overlaying coverages returns is a coverage, of the same area where nothing moves."""
    paths = [os.path.join(folder, name) for name in ("a.geojson", "b.geojson")]
    layers = [strips(dice, dice.choice((4, 8, 16)), turned) for turned in (False, True)]
    for path, layer in zip(paths, layers):
        with open(path, "w") as out:
            json.dump(layer, out)
    areas = [sum(shape(feature["geometry"]).area for feature in layer["features"]) for layer in layers]
    to_geojson = ("--format", "geojson")
    dissolved = require_coverage(run(program, "map", "dissolve", paths[0], "--by", "parity", *to_geojson), "a dissolved layer")
    if abs(dissolved - areas[0]) > 1e-9:
        sys.exit("a dissolved layer has area %r instead of %r" % (dissolved, areas[0]))
    for amount in (("--percent", "30"), ("--tolerance", "5")):
        require_coverage(run(program, "map", "simplify", paths[0], *amount, *to_geojson), "a simplified layer")
    overlaid = require_coverage(run(program, "map", "overlay", *paths, *to_geojson), "an overlay of layers")
    union = shapely.union_all([shape(feature["geometry"]) for layer in layers for feature in layer["features"]]).area
    if abs(overlaid - union) > 1e-8:
        sys.exit("an overlay of layers has area %r instead of %r" % (overlaid, union))


def main():
    program = os.path.abspath(sys.argv[1])
    pairs = int(sys.argv[2]) if len(sys.argv) > 2 else 120
    dice = random.Random(7)
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(pairs):
            check_pair(program, folder, dice)
        for _ in range(pairs // 4):
            check_results(program, folder, dice)
        for _ in range(pairs // 6):
            check_overlay(program, dice, folder)
        for _ in range(pairs // 2):
            check_repair(program, dice, folder)
        for _ in range(pairs // 3):
            check_layers(program, dice, folder)
    print("%d pairs, %d overlays and %d layers are valid" % (pairs, pairs // 6, pairs // 2 + pairs // 3))


main()
