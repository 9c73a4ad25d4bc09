"""What plumb writes for another program: OpenSCAD reads the 3MF and DXF files of plumb, and its results have the volumes that
plumb computes; plumb reads the 3MF, DXF and SVG files that OpenSCAD writes, and its models, some of which are its own examples, have
the same volumes, boxes and numbers of parts in both programs. Exits with 77, which ctest counts as skipped, where
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
EXAMPLES = "/usr/share/openscad/examples/Old"
QUICK_EXAMPLES = ("002", "003", "004", "005", "007", "008", "009", "010", "011", "012", "013", "014", "016", "017")
# Fields of heights, text and image, and a drawing with an open chain, arcs, a block and a hatch.
FIELD = "# a field\n1 2 3\n4 -5 6\n\n7 8\n1e0 .5 2 3\n"
IMAGE = bytes.fromhex(
    "89504e470d0a1a0a0000000d4948445200000003000000020802000000"
    "1216f14d0000001849444154789c63f8cfc0c000c15c227227528cfeffff0f003c190795efc2c6d80000000049454e44ae426082")
VECTORS = """<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="20mm" viewBox="0 0 80 40">
<rect x="2" y="4" width="30" height="20"/><path d="M40 8 l20 0 l-9 20 z"/></svg>"""
DRAWING = """0 SECTION 2 BLOCKS 0 BLOCK 2 part 10 0 20 0 0 LINE 10 1 20 1 11 3 21 1 0 LINE 10 3 20 1 11 1 21 2
0 LINE 10 1 20 2 11 1 21 1 0 ENDBLK 0 ENDSEC 0 SECTION 2 ENTITIES 0 LINE 8 a 10 0 20 0 11 8 21 0 0 LINE 8 a 10 8 20 0 11 8 21 5
0 CIRCLE 8 a 10 20 20 0 40 3 0 ARC 8 a 10 30 20 0 40 4 50 30 51 200
0 HATCH 8 a 91 1 92 2 72 0 73 1 93 3 10 50 20 0 10 60 20 0 10 60 20 9 0 INSERT 8 a 2 part 10 40 20 3 50 90 0 ENDSEC 0 EOF"""
MODELS = (
    'surface("field.dat", center = true);',
    'surface("field.dat", invert = true);',
    'surface("image.png");',
    'surface("image.png", center = true, invert = true);',
    'linear_extrude(2) import("plan.dxf");',
    'linear_extrude(2) import("plan.dxf", layer = "a", scale = 2.5, origin = [3, 4], $fn = 7);',
    'linear_extrude(file = "plan.dxf", layer = "a", height = 3, scale = 2, origin = [3, 4], $fn = 7);',
    'rotate_extrude(file = "plan.dxf", layer = "a", $fn = 9);',
    'difference() { cube(9); for (i = [0 : 3]) translate([2 * i, 1, 1]) rotate([0, 10 * i, 0]) cylinder(r = 1, h = 20, $fn = 9); }',
    'hull() { polyhedron([[0, 0, 0], [4, 0, 0], [0, 4, 0]], [[0, 1, 2]]); translate([0, 0, 3]) cube(1); }',
    'linear_extrude(5, twist = 500, scale = [3, 1]) translate([1, 0]) square([3, 2]);',
    'linear_extrude(5, scale = [0, 2]) circle(5);',
    'multmatrix([[1, 0, 0, 2], [0, 1, 0, 4], [0, 0, 1, 6], [0.1, 0, 0, 2]]) cube(2);',
    'linear_extrude(2) polygon([[0, 0], [4, 0], [4, 4]], paths = []);',
    'linear_extrude(2) import("plan.svg", center = true);',
)
# Strings without ligatures: `text()` of plumb has none.
TEXTS = (
    'text("plumb", font = "Liberation Sans")',
    'text("AVA To 3.14", font = "DejaVu Sans", size = 20, halign = "center", valign = "center")',
    'text("Exact Nef", font = "DejaVu Serif:style=Bold", size = 7, spacing = 1.3, halign = "right", valign = "top", $fn = 40)',
    'text("gjpq QWERTY", font = "Liberation Serif", valign = "bottom", $fn = 3)',
    'text("aWfj", font = "Liberation Sans", direction = "rtl", halign = "right")',
    'text("plumb", font = "Liberation Sans", direction = "ttb", halign = "center", valign = "center")',
    'text("plumb", font = "DejaVu Sans", direction = "btt", size = 7, spacing = 1.2, halign = "right", valign = "top")',
    'text("\u00c4\u00f6\u00df \u0416", font = "Liberation Sans:style=Italic", size = 12.5)',
)
TEXT_TOLERANCE = 1e-3  # OpenSCAD loads outlines at a resolution of 1 / 2170 of the em.
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


def require_near(a, b, what, tolerance=TOLERANCE):
    if abs(a - b) > tolerance * max(abs(a), abs(b)):
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


def facts_of(program, *words):
    """Returns the volume, the number of parts, and the box of a solid."""
    answer = json.loads(run(program, "solid", *words, "--json", "--quiet"))
    return float(answer["volume"]["double"]), answer["marked_volumes"]


def box_of(program, path):
    parts = json.loads(run(program, "solid", "components", path, "--json", "--quiet"))["components"]
    low = [min(part["box"][0][axis] for part in parts) for axis in range(3)]
    return low + [max(part["box"][1][axis] for part in parts) for axis in range(3)]


def check_model(program, source, work, name, tolerance=TOLERANCE):
    """Evaluates a file of OpenSCAD with both programs. OpenSCAD writes six digits."""
    flat, theirs, ours = (os.path.join(work, "model" + extension) for extension in (".csg", ".theirs.off", ".ours.off"))
    run("openscad", source, "-o", flat)
    run("openscad", source, "-o", theirs)
    run(program, "solid", "csg", flat, "--quiet", "-o", ours)
    volume, parts = facts_of(program, "csg", flat)
    expected, expected_parts = facts_of(program, "info", theirs)
    require_near(volume, expected, name, tolerance)
    if parts != expected_parts:
        sys.exit("%s: %d parts, OpenSCAD has %d" % (name, parts, expected_parts))
    mine, other = box_of(program, ours), box_of(program, theirs)
    if any(abs(a - b) > tolerance * max(abs(x) for x in other) for a, b in zip(mine, other)):
        sys.exit("%s: boxes %r and %r" % (name, mine, other))


def check_models(program, folder):
    with open(os.path.join(folder, "field.dat"), "w") as out:
        out.write(FIELD)
    with open(os.path.join(folder, "image.png"), "wb") as out:
        out.write(IMAGE)
    with open(os.path.join(folder, "plan.dxf"), "w") as out:
        out.write("\n".join(DRAWING.split()) + "\n")
    with open(os.path.join(folder, "plan.svg"), "w") as out:
        out.write(VECTORS)
    source = os.path.join(folder, "model.scad")
    for model in MODELS:
        with open(source, "w") as out:
            out.write(model)
        check_model(program, source, folder, model)
    if not os.path.isdir(EXAMPLES):
        return
    copies = os.path.join(folder, "examples")
    shutil.copytree(EXAMPLES, copies)
    for number in QUICK_EXAMPLES:
        name = "example%s.scad" % number
        check_model(program, os.path.join(copies, name), copies, name)


def has_font(text):
    """Whether the font of a text is installed. Each program chooses a font of its own instead of one that is missing."""
    family = text.split('font = "')[1].split('"')[0].split(":")[0]
    return family in subprocess.run(("fc-list", family), capture_output=True, text=True).stdout


def check_texts(program, folder):
    """Compares texts in fonts that are installed, unless plumb was built without FreeType."""
    if shutil.which("fc-list") is None:
        return
    source = os.path.join(folder, "model.scad")
    for index, text in enumerate(TEXTS):
        with open(source, "w") as out:
            out.write("linear_extrude(2) %s;" % text)
        if index == 0:
            answer = subprocess.run((program, "solid", "csg", source, "--quiet"), capture_output=True, text=True)
            if "plumb was built without" in answer.stderr:
                print("no FreeType here, so no text is compared")
                return
        if has_font(text):
            check_model(program, source, folder, text, TEXT_TOLERANCE)


def main():
    if shutil.which("openscad") is None:
        print("no OpenSCAD here")
        sys.exit(77)
    program = os.path.abspath(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder:
        check_reading_by_openscad(program, folder)
        check_reading_of_openscad(program, folder)
        check_models(program, folder)
        check_texts(program, folder)


main()
