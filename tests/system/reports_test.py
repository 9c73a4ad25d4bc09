"""Reports of users of other programs, tried on plumb: each row has the command and what a right answer must have.

    reports_test.py PROGRAM FOLDER

FOLDER is corpus/reports; each report has a folder with its inputs. A row names the exit code and pieces of the output that must be
there. Pieces are exact results (volumes, areas) or the words that tell a user what is wrong and what to do.
"""
import json
import math
import os
import subprocess
import sys
import tempfile

SIXTH = "volume 1/6\n"


class Row:
    def __init__(self, folder, command, code=0, says=(), never=()):
        self.folder, self.command, self.code = folder, command.split(), code
        self.says = (says,) if isinstance(says, str) else says
        self.never = (never,) if isinstance(never, str) else never


def info(folder, *names, says=SIXTH):
    return [Row(folder, "solid info " + name, says=says) for name in names]


ROWS = [
    # A spike collapses when crossings are rounded: a valid polygon, and --strict refuses.
    Row("01-plane-strict-misses-spikes", "plane union a.wkt b.wkt --strict", 2, "rounding to doubles changed the shape"),
    Row("01-plane-strict-misses-spikes", "plane union a.wkt b.wkt -o OUT.wkt", 0, "changed the shape"),
    Row("01-plane-strict-misses-spikes", "plane info OUT.wkt", 0, ("7 vertices, 7 edges, 2 faces", "area 9/2")),
    Row("01-plane-strict-misses-spikes", "plane regularize OUT.wkt --strict", 0, "POLYGON", "warning"),
    # Floats of binary STL lose a hole and a plate: told, and --strict refuses.
    Row("02-stl-binary-strict-silent-loss", "solid difference block.off hole.off -o OUT.stl --format stl-binary --strict", 2,
        "closed gaps or holes"),
    Row("02-stl-binary-strict-silent-loss", "solid difference block.off hole.off -o OUT.stl --format stl-binary", 0,
        "closed gaps or holes"),
    Row("02-stl-binary-strict-silent-loss", "solid info OUT.stl", 0, "volume 1000\n", "OUT.stl:"),
    Row("02-stl-binary-strict-silent-loss", "solid regularize plate.off -o OUT.stl --format stl-binary --strict", 2,
        "removed parts"),
    # Triangle strips of PLY are geometry.
    *info("03-ply-tristrips-silently-empty", "strips.ply"),
    Row("03-ply-tristrips-silently-empty", "solid difference box.off strips.ply --json", 0, '"exact":"161/6"'),
    # Instances of glTF are geometry.
    *info("04-gltf-instances-silently-lost", "inst.gltf", says="volume 1/3\n"),
    # A closed mesh with a face turned round: named, with a way on; the fewer faces are turned.
    Row("05-closed-but-flipped-called-open", "solid info flip1.off", 2, ("1 face is flipped: 0", "--reorient")),
    Row("05-closed-but-flipped-called-open", "solid info flip1.off --reorient", 0, "volume 1\n"),
    Row("05-closed-but-flipped-called-open", "solid info listed.off --reorient", 0, "volume 8\n"),
    Row("05-closed-but-flipped-called-open", "surface cells scene.json", 0, ("2 cells", "flip1.off: 2 faces flipped")),
    # An overlap of two regions of a map is named as such.
    Row("07-map-overlap-told-as-missing-outer", "map check overlap.map", 1, "regions 1 and 2 overlap between vertices 2 and 4",
        "missing outer boundary"),
    # A hole may touch its shell.
    *[Row("08-map-hole-touching-shell", "map check " + name, 0, "", "superposed")
      for name in ("touch.map", "jts.map", "one-cycle.map")],
    # Every face in both directions: no inside.
    Row("09-double-sided-mesh-silently-empty", "solid info box2.off", 2, ("encloses nothing", "--one-side")),
    Row("09-double-sided-mesh-silently-empty", "solid difference big.off box2.off", 2, "encloses nothing"),
    Row("09-double-sided-mesh-silently-empty", "solid info box2.off --one-side", 0, "volume 1\n"),
    # Colours that are not numbers are passed over.
    *info("10-obj-nan-colour-refused", "nancolor.obj", "ply.ply"),
    # Corners that differ in the last bit: refused, with a way on.
    Row("11-stl-last-bit-noise-open", "solid info ulp.stl", 2, "--weld 1e-06 mends it"),
    Row("11-stl-last-bit-noise-open", "solid info ulp.stl --weld 1e-6", 0, SIXTH),
    # Text STL as exporters write it; a facet cut in half is refused.
    *info("12-stl-text-two-words-no-end", "endsolid.stl", "noend.stl"),
    Row("12-stl-text-two-words-no-end", "solid info cut.stl", 2, "cut.stl:22:2: expected endfacet"),
    # Binary STL with wrong lengths.
    *info("13-stl-binary-odd-lengths", "more.stl", "solid-tail.stl", "tail.stl"),
    *info("14-obj-empty-slots", "slashes.obj"),
    *info("15-degenerate-face-refuses-file", "deg.obj", "deg.off"),
    *info("16-obj-statements", "first.obj", "glued.obj", "negative.obj", "ok.obj"),
    *info("17-off-lines-and-heads", "coff.off", "colour.off", "lines.off"),
    *info("18-ply-odd-files", "binbig.ply", "bincr.ply", "bincrlf.ply", "binlittle_tail.ply", "oneline.ply", "ushortlist.ply",
          "vertexindexes.ply"),
    *info("19-gltf-sparse-quantised-draco", "draco_fallback.gltf", "matreq.gltf", "quant.gltf", "sparse.gltf", "xmpreq.gltf"),
    Row("19-gltf-sparse-quantised-draco", "solid info nobv.gltf", 2, "zeros"),
    Row("19-gltf-sparse-quantised-draco", "solid info draco_nofallback.gltf", 2, "Draco"),
    # Dialects of WKT. A LINEARRING is read as the polygon that it bounds; this is told.
    *[Row("20-wkt-dialects", "plane info " + name, 0, "area 6\n") for name in ("empty.wkt", "ewkt3d.wkt", "semi.wkt", "srid.wkt")],
    Row("20-wkt-dialects", "plane info ring.wkt", 0, ("area 6\n", "a LINEARRING is read as the polygon that it bounds")),
    Row("20-wkt-dialects", "plane info curve.wkt", 2, "curves are not read"),
    # GeoJSON: NaN in a property, a feature a line.
    Row("21-geojson-sequences-nan", "plane info nan.geojson", 0, "area 6\n"),
    Row("21-geojson-sequences-nan", "plane info seq.geojson", 0, "area 12\n"),
    # A sliver that rounds to nothing is left out.
    Row("26-plane-output-invalid-with-warning", "plane difference a.geojson b.geojson", 0, ("EMPTY", "1 face was left out")),
    Row("26-plane-output-invalid-with-warning", "plane difference a.geojson b.geojson --strict", 2, "--strict"),
    # Drawings as Inkscape and Illustrator write them: hidden layers, entities, percentages, Latin-1.
    *[Row("28-svg-hidden-and-declared", "plane info " + name, 0, "area 6\n")
      for name in ("hidden.svg", "entities.svg", "percent.svg", "latin.svg")],
    # A file of another kind than its extension says, or of a kind that is not read: what it is, and what to do.
    *[Row("29-other-kinds-of-files", command, 2, says) for command, says in (
        ("solid info utf16.obj", "utf16.obj: this is text in UTF-16; save it as UTF-8"),
        ("solid info gz.stl", "gz.stl: this is a file packed by gzip; unpack it first"),
        ("solid info x.step", "this is a STEP model"),
        ("solid info dae.obj", "this is a COLLADA file"),
        ("solid info stl.obj", "this is STL; give the file the extension .stl"),
        ("solid info lfs.obj", "git lfs pull"),
        ("plane info shapefile.geojson", "this is a shapefile; GDAL converts it"),
        ("map check shapefile.geojson", "this is a shapefile; GDAL converts it"),
        ("plane info csv.wkt", "this is a table with geometries"),
        ("plane info topo.geojson", "this is TopoJSON"),
        ("plane info html.geojson", "this is a web page"),
        ("plane info dwg.dxf", "this is a DWG drawing"),
        ("plane info utf16.wkt", "this is text in UTF-16"),
        ("plane info a.kml", "this is a KML file"))],
    # Comments in Latin-1, padding at the end, lines that end with CR.
    *info("30-text-of-any-origin", "latin1.obj", "latin1.off", "ctrlz.obj", "nul.obj", "nul.off", "version.ply"),
    Row("30-text-of-any-origin", "plane info cr.wkt", 0, "area 6\n"),
    # Binary STL without its last two bytes, which mean nothing, and one of another order of bytes.
    Row("31-stl-short-and-big-endian", "solid info short.stl", 0, SIXTH),
    Row("31-stl-short-and-big-endian", "solid info big.stl", 2, "big.stl: at byte 80: the file has its numbers in big-endian order"),
    # Polygons of curves that are all straight.
    *[Row("32-wkt-straight-curves", "plane info " + name, 0, "area 6\n") for name in ("straight.wkt", "surface.wkt")],
    *[Row("32-wkt-straight-curves", "plane info " + name, 2, "curves are not read") for name in ("arc.wkt", "compound.wkt")],
    # Words and characters that JSON does not have, where nothing depends on them.
    *[Row("33-not-json-in-texts", command, 0, ("0 overlaps", "not JSON, replaced"))
      for command in ("map check words.geojson", "map check bytes.geojson", "map check nan.topojson")],
    Row("33-not-json-in-texts", "map dissolve words.geojson -o OUT.geojson", 0, "such as NaN by null"),
    Row("33-not-json-in-texts", "map check OUT.geojson", 0, "1 feature", "not JSON"),
    Row("33-not-json-in-texts", "plane info words.geojson", 0, "area 6\n"),
    *info("33-not-json-in-texts", "extras.gltf"),
    # Comments and names of several lines in text STL; triangles of nothing but NaN.
    *info("34-stl-comments-and-nan", "comment.stl", "header.stl", "nosolid.stl", "nanface.stl", "nantext.stl"),
    Row("34-stl-comments-and-nan", "solid info tail.stl", 2, "tail.stl:31:1: expected solid, found 'some'"),
    Row("34-stl-comments-and-nan", "solid info nanface.stl -q", 0, "triangles without a finite coordinate"),
    Row("34-stl-comments-and-nan", "solid info nancorner.stl", 2, "nancorner.stl:33:14: expected a number, found 'nan'"),
    # What moves vertices in glTF and is not followed is told, also with -q.
    *info("35-gltf-shape-elsewhere", "dot.gltf", "outside.gltf"),
    Row("35-gltf-shape-elsewhere", "solid info morph.gltf -q", 0, "geometry that was not read: morph targets, which move vertices"),
    Row("35-gltf-shape-elsewhere", "solid info skin.gltf -q", 0, "geometry that was not read: skins, which move vertices"),
    Row("35-gltf-shape-elsewhere", "solid info rtc.gltf -q", 0, "CESIUM_RTC (the model is not moved to its place)"),
    Row("35-gltf-shape-elsewhere", "solid info outside.gltf", 0, "nodes that are not in the scene"),
    # PLY with integers of 64 bits, and with faces in an element that is not read.
    *info("36-ply-integers-and-fans", "int64.ply", "binary.ply"),
    Row("36-ply-integers-and-fans", "solid info fans.ply -q", 0, "geometry that was not read: elements 'trifans'"),
    # Notations that are not read: what is wrong, and what to do.
    *[Row("37-notations-that-are-not-read", command, 2, says) for command, says in (
        ("solid info comma.obj", "comma.obj:2:3: expected a number, found '1,0'; decimals have a point"),
        ("solid info zero.obj", "OBJ counts from 1"),
        ("solid info fortran.stl", "exponents begin with e"),
        ("plane info hex.wkt", "this is WKB; give the file the extension .wkb"),
        ("plane info box.wkt", "a box is no geometry of WKT; write it as a POLYGON"),
        ("plane info osm.json", "this is OpenStreetMap data as JSON"),
        ("plane info gml.gml", "this is a GML file"))],
    Row("37-notations-that-are-not-read", "plane info mysql.wkt", 0, "area 6\n"),
    # A closed shell that is listed twice.
    Row("38-shell-listed-twice", "solid repair twice.off -o OUT.off", 0, ("4 faces, closed", "dropped: 4, 5, 6, 7")),
    Row("38-shell-listed-twice", "solid info OUT.off", 0, SIXTH, "merged"),
    # Illustrator puts its drawing into a switch.
    Row("39-svg-switch-of-illustrator", "plane info illustrator.svg", 0, "area 6\n", "left out"),
    # A set that is empty although the file has contents: told, also with -q.
    *[Row("40-empty-for-a-reason", "plane info " + name + " -q", 0, "warning: the file has no point, line or polygon")
      for name in ("place.geojson", "region.dxf")],
    Row("40-empty-for-a-reason", "plane info twice.wkt -q", 0, "warning: the rings of the file enclose nothing"),
    Row("40-empty-for-a-reason", "plane info empty.wkt -q", 0, "area 0\n", "warning"),
    # A binary file that nothing tells to be STL is not read as STL.
    Row("41-binary-of-unknown-kind", "solid info sphere.ctm", 2, "this is an OpenCTM file"),
    Row("41-binary-of-unknown-kind", "solid info buffer.bin", 2, "a binary file of a kind that is not known"),
    # A border that crosses itself is no gap.
    Row("42-map-border-crosses-itself", "map check bowtie.map", 1, "mend the crossing of edges 1-2 and 3-4 first",
        "in the coverage"),
    # A filled polygon of DXF is an area.
    Row("43-solid-of-dxf", "plane info solid.dxf -q", 0, "area 6\n", "warning"),
    # Rings whose last position is not the first one again: an edge closes them, which is told.
    *[Row("49-ring-without-its-last-position", "plane info " + name, 0, ("area 6\n", "closed by an edge"))
      for name in ("open.wkt", "open.geojson")],
    Row("49-ring-without-its-last-position", "map check open.geojson", 0, ("1 feature, 0 overlaps", "closed by an edge")),
    # Illustrator states fill rules and hides elements by style sheets.
    Row("50-svg-style-sheet", "plane info classes.svg", 0, "area 9\n", "style sheet"),
    # A model without volume: told, also with -q.
    Row("44-empty-model", "solid csg flat.csg -q -o OUT.off", 0, "warning: the model is empty"),
    # Extrusions of OpenSCAD that name a drawing themselves.
    Row("45-extrusion-names-a-drawing", "solid csg linear.csg -o OUT.off", 0, "", ("passed over", "empty")),
    Row("45-extrusion-names-a-drawing", "solid info OUT.off", 0, "volume 168\n"),
    # Numbers that are not finite, as OpenSCAD writes them; a polyhedron with flipped faces in a Minkowski sum.
    Row("46-openscad-odd-numbers-and-faces", "solid csg notfinite.csg -q -o OUT.off", 0, ("1:1: cube: a number is not finite",
        "$fn is not finite")),
    Row("46-openscad-odd-numbers-and-faces", "solid info OUT.off", 0, "volume 1\n"),
    Row("46-openscad-odd-numbers-and-faces", "solid csg minkowski.csg -o OUT.off", 0, "4 faces are oriented opposite"),
    Row("46-openscad-odd-numbers-and-faces", "solid info OUT.off", 0, "volume 37603/6\n"),
    # AMF as SolidWorks, Slic3r and OpenSCAD write it.
    *info("47-amf", "solidworks.amf", "modifier.amf", "openscad.amf"),
    Row("47-amf", "solid info modifier.amf -q", 0, "geometry that was not read: modifier volumes"),
    Row("47-amf", "solid info inch.amf", 0, ("volume 2048383/750", "the unit is the inch")),
    Row("47-amf", "solid info cycle.amf", 2, "constellation 1 contains itself"),
    # Texts of OpenSCAD in all directions; only the message depends on whether there are fonts.
    Row("48-text-directions", "plane csg unknown.csg", 2, "unknown.csg:1:1: the direction of text() is 'up'"),
    Row("45-extrusion-names-a-drawing", "solid csg rotate.csg -o OUT.off", 0, "", ("passed over", "empty")),
]


def run(program, command, folder):
    return subprocess.run([program, *command], cwd=folder, capture_output=True, text=True, timeout=120)


def check_row(program, root, row, scratch):
    command = [part.replace("OUT", os.path.join(scratch, "OUT")) for part in row.command]
    done = run(program, command, os.path.join(root, row.folder))
    text = done.stdout + done.stderr
    wrong = ["expected exit %d, found %d" % (row.code, done.returncode)] if done.returncode != row.code else []
    wrong += ["expected %r" % piece for piece in row.says if piece not in text]
    wrong += ["unexpected %r" % piece for piece in row.never if piece in text]
    return ["%s: plumb %s: %s\n%s" % (row.folder, " ".join(row.command), what, text) for what in wrong]


# Report 06: a cube is united with 24 copies of itself, each turned further, each step through a file.

CUBE = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


def write_turned_cube(path, k):
    c, s, d, t = math.cos(0.13 * k), math.sin(0.13 * k), math.cos(0.17 * k), math.sin(0.17 * k)
    with open(path, "w") as out:
        out.write("OFF\n8 6 0\n")
        for i in range(8):
            x, y, z = (i & 1) * 2 - 1, (i >> 1 & 1) * 2 - 1, (i >> 2) * 2 - 1
            x, y = c * x - s * y, s * x + c * y
            y, z = d * y - t * z, t * y + d * z
            out.write("%r %r %r\n" % (x, y, z))
        for f in CUBE:
            out.write("4 %d %d %d %d\n" % f)


def facts_after_chain(program, scratch, extension, options, steps=24):
    """Returns what `solid info` says of the last file; its notes are errors, since each file must be valid."""
    current = os.path.join(scratch, "cube.off")
    write_turned_cube(current, 0)
    for k in range(1, steps + 1):
        cube, result = os.path.join(scratch, "turned.off"), os.path.join(scratch, "step%d.%s" % (k, extension))
        write_turned_cube(cube, k)
        done = run(program, ["solid", "union", current, cube, "-o", result, *options], scratch)
        if done.returncode != 0 or ("step%d." % k) in done.stderr.replace(result + ": warning: rounding damaged", ""):
            raise AssertionError("06: step %d of %s: exit %d, %s" % (k, extension, done.returncode, done.stderr))
        current = result
    done = run(program, ["solid", "info", current, "--json"], scratch)
    if done.stderr:
        raise AssertionError("06: the last file of %s: %s" % (extension, done.stderr))
    return json.loads(done.stdout)


def check_chain(program, scratch):
    exact = facts_after_chain(program, scratch, "nef", [])
    wrong = []
    for extension, options, digits in (("off", [], 12), ("stl", ["--format", "stl-binary"], 6)):
        facts = facts_after_chain(program, scratch, extension, options)
        if facts["vertices"] > exact["vertices"] or facts["facets"] > 2 * exact["vertices"]:
            wrong.append("06: %s has %d vertices and %d facets, the exact chain has %d vertices" %
                         (extension, facts["vertices"], facts["facets"], exact["vertices"]))
        if abs(facts["volume"]["double"] / exact["volume"]["double"] - 1) > 10.0 ** -digits:
            wrong.append("06: %s has another volume: %r" % (extension, facts["volume"]["double"]))
    return wrong


def main():
    program, root = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    wrong = []
    with tempfile.TemporaryDirectory() as scratch:
        for row in ROWS:
            wrong += check_row(program, root, row, scratch)
        try:
            wrong += check_chain(program, scratch)
        except AssertionError as error:
            wrong.append(str(error))
    listed = {row.folder for row in ROWS}
    wrong += ["%s: no row" % folder for folder in sorted(os.listdir(root)) if folder not in listed]
    for what in wrong:
        print(what)
    print("%d rows, %d wrong" % (len(ROWS) + 1, len(wrong)))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
