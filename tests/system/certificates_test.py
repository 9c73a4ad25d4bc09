"""Certificates of the program are proved by tools/verify_certificate.py, and certificates that lie are refused.

    certificates_test.py PROGRAM CHECKER CORPUS
"""
import copy
import json
import os
import subprocess
import sys
import tempfile

PROVED, REFUSED, UNCHECKED = 0, 1, 2


def box(low, high):
    """The points and the faces of a box, faces outwards."""
    points = [(x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]
    return points, [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def turned(mesh):
    return mesh[0], [face[::-1] for face in mesh[1]]


def off(*meshes):
    points, faces = [], []
    for more_points, more_faces in meshes:
        faces += [tuple(v + len(points) for v in face) for face in more_faces]
        points += more_points
    lines = ["OFF", "%d %d 0" % (len(points), len(faces))] + ["%s %s %s" % p for p in points]
    return "\n".join(lines + [" ".join(map(str, (len(face), *face))) for face in faces]) + "\n"


SQUARE = "4 %d\n0 0\n2 0\n2 2\n0 2\n"
FILES = {
    "valid.map": SQUARE % 3 + "1 2 3\n1 3 4\n4 3 2 1\n",
    "open.map": SQUARE % 2 + "1 2 3\n1 3 4\n",
    "duplicate.map": SQUARE % 4 + "1 2 3\n1 2 3\n1 3 4\n4 3 2 1\n",
    "twin.map": "5 2\n0 0\n4 0\n4 4\n0 4\n1 1\n1 5 1 2 3 4\n4 3 2 1\n",
    "crossing.map": "4 2\n0 0\n3 2\n3 0\n0.1 2\n1 2 3 4\n4 3 2 1\n",
    "equal.map": "6 4\n0 0\n1 0\n0 1\n1 0\n2 0\n2 1\n1 2 3\n3 2 1\n4 5 6\n6 5 4\n",
    "overlap.wkt": "MULTIPOLYGON (((0 0, 2 0, 2 2, 0 2, 0 0)), ((1 3, 1 1, 3 1, 3 3, 1 3)))\n",
    "overlap.geojson": '{"type": "MultiPolygon", "coordinates": [[[[0,0],[2,0],[2,2],[0,2],[0,0]]],'
                       '[[[1,1],[3,1],[3,3.5],[1,3],[1,1]]]]}\n',
    "twice.wkt": "MULTIPOLYGON (((0 0, 2 0, 2 2, 0 0)), ((0 0, 2 2, 2 0, 0 0)))\n",
    "small.off": off(box((1, 1, 1), (2, 2, 2))),
    "large.off": off(box((0, 0, 0), (4, 4, 4))),
    "inverted.off": off(turned(box((0, 0, 0), (4, 4, 4)))),
    "hollow.off": off(box((0, 0, 0), (4, 4, 4)), turned(box((1, 1, 1), (3, 3, 3)))),
    "far.off": off(box((5, 0, "1/3"), (6, 1, 1))),
    "cross.off": off(box((0, 1, 1), (3, 2, 2)), box((1, 0, 1), (2, 3, 2))),
    "pair.off": off(box((0, 0, 0), (1, 1, 1)), box((1, 1, 1), (2, 2, 2))),
}
NOT_A, NOT_B = "A is not a subset of B", "B is not a subset of A"
MEET, APART = "A and B meet", "A and B do not meet"

# The command, and what the certificate claims: the kind of a defect, or sentences.
HONEST = [
    ("map check valid.map", []),
    ("map check open.map", ["open"]),
    ("map check open.map --outer infer", []),
    ("map check duplicate.map", ["duplicate"]),
    ("map check twin.map", ["twin"]),
    ("map check crossing.map --outer ignore", ["crossing"]),
    ("map check crossing.map --outer ignore --exact-decimals", ["crossing"]),
    ("map check equal.map", ["crossing"]),
    ("map check equal.map --merge-vertices", []),
    ("map check overlap.wkt", ["crossing"]),
    ("map check overlap.geojson", ["crossing"]),
    ("map check twice.wkt", ["duplicate"]),
    ("map check duplicate.map --max-defects 0", []),
    ("solid compare small.off large.off", [NOT_B, MEET]),
    ("solid compare large.off small.off", [NOT_A, MEET]),
    ("solid compare large.off inverted.off", [MEET]),
    ("solid compare hollow.off large.off", [NOT_B, MEET]),
    ("solid compare hollow.off small.off", [NOT_A, NOT_B]),
    ("solid compare large.off far.off", [NOT_A, NOT_B, APART]),
    ("solid compare large.off cross.off --rule odd", [NOT_A, MEET]),
    ("solid compare large.off far.off --reorient", []),
    ("convex check large.off", []),
    ("convex check hollow.off", ["A is not convex"]),
    ("convex check cross.off", ["A is not convex"]),
    ("convex check pair.off", ["A is not convex"]),
    ("convex check CORPUS/solids/l-block.off", ["A is not convex"]),
    ("convex check CORPUS/solids/square-hole.off", ["A is not convex"]),
    ("convex check CORPUS/polyhedra/test_one.off", ["A is not convex"]),
    ("map check CORPUS/maps/us-counties.map", ["duplicate"]),
]


def names(certificate):
    return [claim.get("defect", claim["claim"]) for claim in certificate["claims"]]


def inputs_of(command):
    return [word for word in command if word.endswith((".map", ".wkt", ".geojson", ".off"))]


class Tester:
    def __init__(self, program, checker, corpus):
        self.program, self.checker, self.corpus = program, checker, corpus
        self.failures = 0

    def expect(self, is_good, what):
        if not is_good:
            self.failures += 1
            print("FAILED: " + what)

    def certify(self, command):
        """Runs a command; returns the certificate and the inputs."""
        words = command.replace("CORPUS", self.corpus).split()
        done = subprocess.run([self.program, *words, "-q", "--certificate", "c.json"], capture_output=True, text=True,
                              check=False)
        self.expect(done.returncode in (0, 1), "%s: exit %d %s" % (command, done.returncode, done.stderr))
        with open("c.json", encoding="utf-8") as file:
            return json.load(file), inputs_of(words)

    def check(self, certificate, inputs, wanted, what):
        with open("lie.json", "w", encoding="utf-8") as file:
            json.dump(certificate, file)
        done = subprocess.run([sys.executable, self.checker, "lie.json", *inputs], capture_output=True, text=True, check=False)
        self.expect(done.returncode == wanted and not done.stderr,
                    "%s: the checker says %d, not %d: %s%s" % (what, done.returncode, wanted, done.stdout, done.stderr))

    def honest(self):
        for command, claims in HONEST:
            certificate, inputs = self.certify(command)
            self.expect(names(certificate) == claims, "%s claims %s" % (command, names(certificate)))
            self.check(certificate, inputs, PROVED if claims else UNCHECKED, command)

    def lie(self, command, what, change, inputs=None, wanted=REFUSED):
        """Changes the certificate of a command and expects that it is refused."""
        certificate, own = self.certify(command)
        lying = copy.deepcopy(certificate)
        change(lying["claims"][0], lying)
        self.expect(lying != certificate or inputs is not None, what + ": nothing was changed")
        self.check(lying, inputs or own, wanted, "lie: " + what)


def put(name, value):
    return lambda claim, _: claim.update({name: value})


def keep(*claims):
    """Keeps the claims of these names only."""
    return lambda _, certificate: certificate.update(
        claims=[c for c in certificate["claims"] if c["claim"] in claims])


def edge(ends, places):
    return {"vertices": list(ends), "points": [list(p) for p in places]}


def lie_about_maps(t):
    crossing = "map check crossing.map --outer ignore"
    bottom, right = edge((1, 2), (("0", "0"), ("2", "0"))), edge((2, 3), (("2", "0"), ("2", "2")))
    for name in ("open", "duplicate"):
        t.lie("map check %s.map" % name, "the defect of another map", lambda *_: None, ["valid.map"])
    t.lie(crossing, "the point is beside the edges", put("point", ["1", "1"]))
    t.lie(crossing, "the edges do not meet at their ends", put("point", ["0", "0"]))
    t.lie(crossing, "one edge twice", lambda claim, _: claim.update(edges=claim["edges"][:1] * 2))
    t.lie(crossing, "a rounded point", lambda claim, _: claim.update(point=[float.hex(1.5), "1"]))
    t.lie(crossing, "an edge that no face has",
          put("edges", [edge((1, 3), (("0", "0"), ("3", "0")))] * 2))
    t.lie("map check open.map", "a common vertex is a crossing",
          lambda claim, _: claim.update(defect="crossing", edges=[bottom, right], point=["2", "0"]), ["valid.map"])
    for name in ("open", "duplicate", "twin"):
        t.lie("map check open.map", "a sound edge is " + name,
              lambda claim, _, name=name: claim.update(defect=name, edges=[bottom]), ["valid.map"])
    t.lie("map check open.map", "a vertex is elsewhere", put("edges", [edge((1, 2), (("0", "0"), ("3", "0")))]))
    t.lie("map check open.map", "a vertex that is not there", put("edges", [edge((1, 9), (("0", "0"), ("2", "0")))]))
    t.lie("map check open.map", "an unknown defect", put("defect", "ugly"))
    t.lie("map check open.map", "no edges", put("edges", []))
    t.lie("map check overlap.wkt", "a point beside", put("point", ["3/2", "2"]))


def lie_about_solids(t):
    inside = "solid compare large.off small.off"
    point = lambda *p: put("point", [str(x) for x in p])
    t.lie(inside, "the point is outside of both", point(9, 9, 9))
    t.lie(inside, "the point is inside both", point("3/2", "3/2", "3/2"))
    t.lie(inside, "the point is on a face of A", point(4, 2, 2))
    t.lie(inside, "the point is on a vertex of A", point(4, 4, 4))
    t.lie(inside, "the point is just outside of A", point("4000000000000000000001/1000000000000000000000", 2, 2))
    t.lie(inside, "the operands are swapped", lambda *_: None, ["small.off", "large.off"])
    t.lie(inside, "the claim is turned", put("claim", NOT_B))
    t.lie(inside, "the claim is that they meet there", put("claim", MEET))
    t.lie(inside, "two coordinates", point(1, 1))
    t.lie(inside, "an unknown claim", put("claim", "A equals B"))
    t.lie(inside, "an unknown rule", put("rule", "any"), wanted=UNCHECKED)
    t.lie("solid compare hollow.off small.off", "a point of the cavity", point("5/2", "5/2", "5/2"))
    t.lie("solid compare large.off cross.off --rule odd", "the middle is inside by another rule",
          lambda claim, _: claim.update(rule="positive", point=["3/2", "3/2", "3/2"]))
    plane = lambda *p: lambda claim, c: (keep(APART)(claim, c), c["claims"][0].update(plane=[str(x) for x in p]))
    for what, numbers in (("on the wrong side", (-1, 0, 0, "9/2")), ("too far", (1, 0, 0, -6)),
                          ("through a vertex", (1, 0, 0, -4)), ("without a normal", (0, 0, 0, 0))):
        t.lie("solid compare large.off far.off", "a plane " + what, plane(*numbers))


def lie_about_convexity(t):
    block = "convex check CORPUS/solids/l-block.off"
    t.lie(block, "the point is not on the segment", put("outside", ["9", "9", "9"]))
    t.lie(block, "the point is an end", lambda claim, _: claim.update(outside=claim["segment"][0]))
    t.lie(block, "an end is outside", lambda claim, _: claim["segment"].__setitem__(0, claim["outside"]))
    t.lie(block, "an inner segment", lambda claim, _: claim.update(
        segment=[["1/4", "1/4", "1/4"], ["3/4", "3/4", "3/4"]], outside=["1/2", "1/2", "1/2"]))
    t.lie(block, "beyond an end", lambda claim, _: claim.update(
        segment=[["1/4", "1/4", "1/4"], ["3/4", "1/4", "1/4"]], outside=["-1/4", "1/4", "1/4"]))
    t.lie("convex check cross.off", "a convex solid", lambda *_: None, ["large.off"])
    t.lie(block, "another version", lambda _, certificate: certificate.update(plumb_certificate=2), wanted=UNCHECKED)
    t.lie(block, "no claims", lambda _, certificate: certificate.update(claims=[]), wanted=UNCHECKED)
    t.lie(block, "an open mesh", lambda *_: None, [t.corpus + "/solids/open-box.off"], UNCHECKED)


def main():
    tester = Tester(*map(os.path.abspath, sys.argv[1:4]))
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for name, text in FILES.items():
            with open(name, "w", encoding="utf-8") as file:
                file.write(text)
        tester.honest()
        lie_about_maps(tester)
        lie_about_solids(tester)
        lie_about_convexity(tester)
    return 1 if tester.failures else 0


if __name__ == "__main__":
    sys.exit(main())
