"""What plumb writes for another program: OpenSCAD reads the 3MF and DXF files of plumb, and its results have the volumes that
plumb computes; plumb reads the 3MF, DXF and SVG files that OpenSCAD writes. Exits with 77, which ctest counts as skipped, where
OpenSCAD is not installed.

    openscad_test.py PROGRAM
"""
import json
import os
import shutil
import subprocess
import sys
import tempfile

SOLIDS = ("l-block", "square-hole", "two-tetrahedra")
MODEL = "difference() { union() { translate([1.5, 2, 0]) cube(10); translate([5, 5, 5]) sphere(6, $fn = 24); } cylinder(20, r = 2, $fn = 12); }"
PLAN = "difference() { union() { square(10); translate([7, 7]) circle(5, $fn = 32); } translate([2, 2]) square([3.25, 1]); }"
TOLERANCE = 1e-4  # OpenSCAD rounds coordinates of the plane to multiples of 2^-16, and writes six digits.


def run(*words):
    result = subprocess.run(words, capture_output=True, text=True)
    if result.returncode != 0:
        sys.exit("%s: exit %d\n%s" % (" ".join(words), result.returncode, result.stderr))
    return result.stdout


def openscad(folder, source, output):
    model = os.path.join(folder, "model.scad")
    with open(model, "w") as out:
        out.write(source)
    run("openscad", model, "-o", output)


def measure(program, kind, path):
    answer = json.loads(run(program, kind, "info", path, "--json", "--quiet"))
    return float(answer["volume" if kind == "solid" else "area"]["double"])


def require_near(a, b, what):
    if abs(a - b) > TOLERANCE * max(abs(a), abs(b)):
        sys.exit("%s: %r and %r" % (what, a, b))


def check_reading_by_openscad(program, folder):
    for name in SOLIDS:
        written = os.path.join(folder, name + ".3mf")
        run(program, "solid", "closure", "corpus/solids/%s.off" % name, "-o", written)
        copy = os.path.join(folder, name + ".off")
        openscad(folder, 'import("%s");' % written, copy)
        expected = measure(program, "solid", "corpus/solids/%s.off" % name)
        require_near(measure(program, "solid", copy), expected, written)
    for name in ("frame.geojson", "star.wkt"):
        written = os.path.join(folder, name + ".dxf")
        run(program, "plane", "closure", "corpus/plane/" + name, "-o", written)
        copy = os.path.join(folder, name + ".off")
        openscad(folder, 'linear_extrude(1) import("%s");' % written, copy)
        expected = measure(program, "plane", "corpus/plane/" + name)
        require_near(measure(program, "solid", copy), expected, written)


def check_reading_of_openscad(program, folder):
    exact = os.path.join(folder, "exact.off")
    openscad(folder, MODEL, exact)
    copy = os.path.join(folder, "copy.3mf")
    openscad(folder, MODEL, copy)
    require_near(measure(program, "solid", copy), measure(program, "solid", exact), copy)
    openscad(folder, "linear_extrude(1) " + PLAN, exact)
    for extension in (".dxf", ".svg"):
        copy = os.path.join(folder, "plan" + extension)
        openscad(folder, PLAN, copy)
        require_near(measure(program, "plane", copy), measure(program, "solid", exact), copy)


def main():
    if shutil.which("openscad") is None:
        print("no OpenSCAD here")
        sys.exit(77)
    program = os.path.abspath(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder:
        check_reading_by_openscad(program, folder)
        check_reading_of_openscad(program, folder)


main()
