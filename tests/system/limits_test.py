"""Every command of the program, on inputs too large for the limits it is given: exit code 3, a message that says which option
to raise, nothing written. The time that a limit is passed by is printed; only much too late fails, as machines are busy.

    limits_test.py PROGRAM
"""
import json
import math
import os
import random
import resource
import subprocess
import sys
import tempfile

SECONDS = 0.002
MEGABYTES = 1
LATEST = 0.3  # CPU time after the limit; the program itself waits a tenth of a second for a checkpoint


def star(count, seed):
    numbers = random.Random(seed)
    corners = []
    for i in range(count):
        turn = 2 * math.pi * (i + 0.9 * numbers.random()) / count
        radius = 0.5 + 0.5 * numbers.random()
        corners.append("%.17g %.17g" % (radius * math.cos(turn), radius * math.sin(turn)))
    return "POLYGON ((%s))\n" % ", ".join(corners + corners[:1])


def torus(around, shift):
    points, faces = [], []
    across = around // 2
    for i in range(around):
        for j in range(across):
            a, b = 2 * math.pi * i / around, 2 * math.pi * j / across
            r = 2 + math.cos(b)
            points.append((r * math.cos(a) + shift, r * math.sin(a) + shift, math.sin(b) + shift))
            c = [p % around * across + q % across for p, q in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))]
            faces += [(c[0], c[1], c[2]), (c[0], c[2], c[3])]
    return points, faces


def off(points, faces):
    lines = ["OFF", "%d %d 0" % (len(points), len(faces))]
    lines += ["%.17g %.17g %.17g" % p for p in points] + ["3 %d %d %d" % f for f in faces]
    return "\n".join(lines) + "\n"


def grid_map(side):
    at = lambda i, j: i * (side + 1) + j + 1
    points = ["%d %d" % (i, j) for i in range(side + 1) for j in range(side + 1)]
    faces = ["%d %d %d %d" % (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1))
             for i in range(side) for j in range(side)]
    outside = [at(0, j) for j in range(side)] + [at(i, side) for i in range(side)]
    outside += [at(side, j) for j in range(side, 0, -1)] + [at(i, 0) for i in range(side, 0, -1)]
    faces.append(" ".join(map(str, outside)))
    return "%d %d\n%s\n" % (len(points), len(faces), "\n".join(points + faces))


def half_spaces(count):
    numbers = random.Random(1)
    lines = []
    for _ in range(count):
        n = [numbers.randrange(-9999, 9999) for _ in range(3)]
        lines.append("%d %d %d -%d closed" % (*n, 1 + int(math.sqrt(sum(x * x for x in n)))))
    return "\n".join(lines) + "\n"


def scene(faces):
    corner = lambda f, k: "[%d, %g, %g]" % (f, (0.5, 0.25, 0.25)[k], (0.25, 0.5, 0.25)[k])
    points = [corner(f, k) for f in range(faces) for k in range(3)]
    polygons = ["[%d, %d, %d]" % (3 * f, 3 * f + 1, 3 * f + 2) for f in range(faces)]
    return '{"model": "torus.off", "points": [%s], "polygons": [%s]}' % (", ".join(points), ", ".join(polygons))


def model(count, dimension):
    part = "cube([3, 3, 3]);" if dimension == 3 else "square([3, 3]);"
    move = "multmatrix([[0.8, -0.6, 0, %d], [0.6, 0.8, 0, %d], [0, 0, 1, 0.%d], [0, 0, 0, 1]])"
    return "\n".join(move % (i % 60 * 2, i // 60 * 2, i) + " { " + part + " }" for i in range(count))


def layer(count):
    """Squares that overlap their neighbours."""
    square = lambda x, y: [[x, y], [x + 1.25, y], [x + 1.25, y + 1.25], [x, y + 1.25], [x, y]]
    return json.dumps({"type": "FeatureCollection", "features": [
        {"type": "Feature", "geometry": {"type": "Polygon", "coordinates": [square(i % count, i // count)]}}
        for i in range(count * count)]})


def write_inputs():
    mesh = torus(240, 0)
    files = {"a.wkt": star(60000, 1), "b.wkt": star(60000, 2), "torus.off": off(*mesh),
             "moved.off": off(*torus(240, 0.3)), "a.map": grid_map(150), "b.map": grid_map(151),
             "h.txt": half_spaces(60000), "s.json": scene(len(mesh[1])), "m.csg": model(6000, 3), "p.csg": model(20000, 2),
             "l.geojson": layer(120)}
    for name, text in files.items():
        with open(name, "w") as out:
            out.write(text)


COMMANDS = """
map check a.map
map overlay a.map b.map -o OUT.svg
map check l.geojson
map overlay l.geojson l.geojson -o OUT.geojson
map repair l.geojson -o OUT.geojson
map dissolve l.geojson -o OUT.topojson
map simplify l.geojson --percent 10 -o OUT.geojson
plane union a.wkt b.wkt -o OUT.nef2
plane intersection a.wkt b.wkt -o OUT.wkt
plane difference a.wkt b.wkt -o OUT.svg
plane symmetric-difference a.wkt b.wkt -o OUT.geojson
plane complement a.wkt -o OUT.nef2
plane interior a.wkt -o OUT.nef2
plane closure a.wkt -o OUT.nef2
plane boundary a.wkt -o OUT.nef2
plane regularize a.wkt -o OUT.nef2
plane simplify a.wkt --percent 10 -o OUT.wkt
plane csg p.csg -o OUT.wkt
plane info a.wkt
plane locate a.wkt 0 0
solid union torus.off moved.off -o OUT.off
solid intersection torus.off moved.off -o OUT.nef
solid difference torus.off moved.off -o OUT.obj
solid symmetric-difference torus.off moved.off -o OUT.nef
solid eval A+B A=torus.off B=moved.off -o OUT.nef
solid complement torus.off -o OUT.nef
solid interior torus.off -o OUT.nef
solid closure torus.off -o OUT.nef
solid boundary torus.off -o OUT.nef
solid regularize torus.off -o OUT.nef
solid section torus.off --plane 1,2,3,0 --side closed -o OUT.nef
solid halfspaces h.txt -o OUT.nef
solid csg m.csg -o OUT.nef
solid info torus.off
solid locate torus.off 0 0 0
solid compare torus.off moved.off
solid repair torus.off -o OUT.off
convex check torus.off
convex decompose torus.off -o OUT
convex report torus.off
convex minkowski torus.off moved.off -o OUT.nef
surface cells s.json
surface boolean s.json --op A -o OUT.obj
surface draw s.json --what labels -o OUT.svg
view torus.off -o OUT.svg
audit a.map
""".split("\n")


def run(program, command, limit):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([program, *command.split(), *limit], capture_output=True, text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return done.returncode, done.stderr.strip(), seconds


# Meshes of 3 GB that a limit of 1 GB refuses. They take no space on the disk.
GIGABYTE = 1 << 30
HUGE_SIZE = 3 * GIGABYTE
HUGE_HEADS = {
    "huge.off": b"OFF\n60000000 120000000 0\n",
    "huge.ply": (b"ply\nformat binary_little_endian 1.0\nelement vertex 80000000\nproperty float x\n"
                 b"property float y\nproperty float z\nelement face 160000000\n"
                 b"property list uchar int vertex_indices\nend_header\n"),
    "huge.stl": bytes(80) + (64424507).to_bytes(4, "little"),
}


def limit_address_space():
    resource.setrlimit(resource.RLIMIT_AS, (GIGABYTE, GIGABYTE))


def has_figures(program, name, options, prepare):
    """Whether a huge mesh is refused, and the message tells its size and the limit, in bytes."""
    done = subprocess.run([program, "solid", "info", name, *options], capture_output=True, text=True, check=False,
                          preexec_fn=prepare)
    message = done.stderr
    is_good = (done.returncode == 3 and all(f" {n} bytes" in message for n in (HUGE_SIZE + 1, GIGABYTE))
               and "raise --limit-memory" in message)
    print("%-4s %-60s %s" % ("" if is_good else "BAD", name + " " + " ".join(options), message.strip()[:120]))
    return is_good


def refuse_huge_meshes(program):
    failures = []
    for name, head in HUGE_HEADS.items():
        with open(name, "wb") as file:
            file.write(head)
            file.truncate(HUGE_SIZE)
        for options, prepare in ((["--limit-memory", "1024"], None), ([], limit_address_space)):
            if not has_figures(program, name, options, prepare):
                failures.append(name)
        os.remove(name)
    return failures


def main():
    program = os.path.abspath(sys.argv[1])
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        write_inputs()
        inputs = set(os.listdir("."))
        for command in filter(None, COMMANDS):
            for option, limit in (("--limit-seconds", SECONDS), ("--limit-memory", MEGABYTES)):
                code, message, seconds = run(program, command, [option, str(limit)])
                left = set(os.listdir(".")) - inputs
                late = seconds - SECONDS if option == "--limit-seconds" else 0
                is_good = code == 3 and "raise " + option in message and not left and late < LATEST
                print("%-4s %-60s %-15s %.2f s: %d, %s" % ("" if is_good else "BAD", command, option, seconds, code,
                                                          message[:120]))
                if not is_good:
                    failures.append(command)
        failures += refuse_huge_meshes(program)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
