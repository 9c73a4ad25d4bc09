#!/usr/bin/env python3
"""Checks a certificate of plumb (docs/certificates.md) against the files that plumb read.

    verify_certificate.py CERTIFICATE INPUT...

The inputs are those of the command, in the same order: a .map, .wkt or .geojson file for `plumb map check`, .off files for
solids. The program shares no code with plumb and computes with fractions only. It prints what is proved, one line for each
claim. Exit codes: 0 if every claim is proved, 1 if a claim is wrong, 2 if a file cannot be checked, or if nothing is claimed.
"""
import json
import re
import sys
from fractions import Fraction


class Refused(Exception):
    """A claim that does not follow from the inputs."""


class Unreadable(Exception):
    """A file that this program does not read."""


def require(condition, reason):
    if not condition:
        raise Refused(reason)


# ---------------------------------------------------------------- numbers and files


def number(text, exact_decimals):
    """An integer or a fraction is exact; a decimal is the nearest double, unless decimals are exact."""
    if re.fullmatch(r"[+-]?\d+(/\d+)?", text):
        return Fraction(text)
    return Fraction(text) if exact_decimals else Fraction(float(text))


def exact_point(texts, dimension):
    """A point of the certificate: texts "p" or "p/q"."""
    good = isinstance(texts, list) and len(texts) == dimension
    good = good and all(isinstance(t, str) and re.fullmatch(r"-?\d+(/\d+)?", t) for t in texts)
    require(good, "no point of %d exact numbers: %s" % (dimension, texts))
    return tuple(Fraction(t) for t in texts)


def records(text):
    lines = (line.split("#")[0].split() for line in text.lstrip("\ufeff").splitlines())
    return [line for line in lines if line]


def read_map(text, exact):
    """Returns the points, and the cycles of vertex numbers from 1."""
    lines = records(text)
    n, f = int(lines[0][0]), int(lines[0][1])
    points = {i + 1: tuple(number(t, exact) for t in lines[1 + i]) for i in range(n)}
    return points, [[int(t) for t in line] for line in lines[1 + n:1 + n + f]]


def oriented(ring, is_outer):
    """A ring without its repeated last point: outer rings counter-clockwise, holes clockwise."""
    ring = ring[:-1] if ring[0] == ring[-1] else ring
    area = sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(ring, ring[1:] + ring[:1]))
    return ring if (area > 0) == is_outer else ring[::-1]


def read_wkt(text, exact):
    words = set(re.findall(r"[A-Za-z]+", re.sub(r"[eE][+-]?\d", "", text)))
    if words - {"POLYGON", "MULTIPOLYGON", "GEOMETRYCOLLECTION"}:
        raise Unreadable("only POLYGON, MULTIPOLYGON and GEOMETRYCOLLECTION are read")
    rings = []
    for match in re.finditer(r"\(([^()]*)\)", text):
        ring = [tuple(number(t, exact) for t in p.split()[:2]) for p in match[1].split(",")]
        rings.append(oriented(ring, text[:match.start()].rstrip().endswith("(")))
    return rings


def read_geojson(text, exact):
    rings = []

    def visit(thing):
        kind = thing["type"]
        for part in thing.get("features", []) + thing.get("geometries", []):
            visit(part)
        if kind == "Feature" and thing["geometry"]:
            visit(thing["geometry"])
        polygons = {"Polygon": [thing.get("coordinates")], "MultiPolygon": thing.get("coordinates")}.get(kind, [])
        for polygon in polygons:
            for i, ring in enumerate(polygon):
                rings.append(oriented([tuple(number(t, exact) for t in p[:2]) for p in ring], i == 0))

    visit(json.loads(text, parse_float=str, parse_int=str))
    return rings


def read_cycles(path, exact, merges):
    """Returns the point of each vertex, and the cycles of vertices. Merged vertices are named by their points."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    if path.endswith(".map"):
        points, cycles = read_map(text, exact)
        if not merges:
            return points, cycles
        cycles = [[points[v] for v in cycle] for cycle in cycles]
    else:
        cycles = read_wkt(text, exact) if path.endswith(".wkt") else read_geojson(text, exact)
    return {p: p for cycle in cycles for p in cycle}, cycles


def read_off(path, exact):
    """Returns the triangles of an OFF file. Every face must be planar, because another program could divide it otherwise."""
    with open(path, encoding="utf-8") as file:
        lines = records(file.read())
    if lines[0][0] != "OFF":
        raise Unreadable(path + ": only OFF without colours and normals of vertices is read")
    lines = ([lines[0][1:]] if len(lines[0]) > 1 else []) + lines[1:]
    n, f = int(lines[0][0]), int(lines[0][1])
    points = [tuple(number(t, exact) for t in line[:3]) for line in lines[1:1 + n]]
    triangles = []
    for line in lines[1 + n:1 + n + f]:
        corners = [points[int(t)] for t in line[1:1 + int(line[0])]]
        fan = [(corners[0], p, q) for p, q in zip(corners[1:], corners[2:])]
        if any(volume(*base, p) != 0 for base in fan for p in corners):
            raise Unreadable(path + ": a face is not planar")
        triangles += fan
    return triangles


# ---------------------------------------------------------------- maps


def is_between(p, a, b):
    """Whether p lies on the closed segment from a to b of the plane."""
    turn = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
    return turn == 0 and all(min(s, t) <= x <= max(s, t) for x, s, t in zip(p, a, b))


def check_map_defect(claim, paths):
    """A directed edge used twice, an edge without its reverse, a crossing, or an edge used both ways by one cycle."""
    require(len(paths) == 1, "one map is needed")
    merges = claim["merge_vertices"]
    points, cycles = read_cycles(paths[0], claim["exact_decimals"], merges)
    uses = [[(a, b) for a, b in zip(cycle, cycle[1:] + cycle[:1])] for cycle in cycles]
    edges = [claimed_edge(edge, points, merges) for edge in claim["edges"]]
    count = lambda edge: sum(use.count(edge) for use in uses)
    require(edges, "no edges")
    for a, b in edges:
        require(count((a, b)) + count((b, a)) > 0, "no face has the edge")
    defect, first = claim["defect"], edges[0]
    back = (first[1], first[0])
    if defect == "duplicate":
        require(count(first) > 1, "the edge is used once")
        return "the directed edge from %s to %s is used %d times" % (*first, count(first))
    if defect == "open":
        require(count(first) > 0 and count(back) == 0, "the edge has its reverse")
        return "no face uses the reverse of the edge from %s to %s" % first
    if defect == "twin":
        require(any(first in use and back in use for use in uses), "no face uses the edge in both directions")
        return "a face uses the edge from %s to %s in both directions" % first
    require(defect == "crossing" and len(edges) == 2, "an unknown defect")
    p = exact_point(claim["point"], 2)
    common = set(first) & set(edges[1])
    require(len(common) < 2, "the edges are the same")
    require(all(is_between(p, points[a], points[b]) for a, b in edges), "the point is not on both edges")
    require(all(points[v] != p for v in common), "the point is a common vertex")
    return "two edges meet at %s, %s, which is no common vertex" % p


def claimed_edge(edge, points, merges):
    places = [exact_point(p, 2) for p in edge["points"]]
    ends = places if merges else edge["vertices"]
    require(len(ends) == 2 and len(places) == 2, "an edge has two ends")
    require(all(points.get(v) == p for v, p in zip(ends, places)), "a vertex is not in the file")
    return tuple(ends)


# ---------------------------------------------------------------- solids


def minus(p, q):
    return tuple(x - y for x, y in zip(p, q))


def determinant(u, v, w):
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0]))


def volume(a, b, c, p):
    """Six times the signed volume of a tetrahedron."""
    return determinant(minus(a, p), minus(b, p), minus(c, p))


def winding(p, triangles):
    """The winding number of a closed mesh about a point that lies on no triangle: the signed count of crossings of a ray. The
    direction of the ray is changed until the ray meets no edge."""
    boxed = lambda t: all(min(c) <= x <= max(c) for x, *c in zip(p, *t))
    require(not any(boxed(t) and volume(*t, p) == 0 for t in triangles), "the point lies in the plane of a face near it")
    for turn in range(1, 1000):
        ray = (1, Fraction(turn, 1009), Fraction(turn * turn, 2003))
        total = 0
        for a, b, c in triangles:
            if max(a[0], b[0], c[0]) < p[0]:
                continue
            u, v, w = minus(a, p), minus(b, p), minus(c, p)
            sides = (determinant(ray, u, v), determinant(ray, v, w), determinant(ray, w, u))
            if min(sides) < 0 < max(sides):
                continue
            if min(sides) == 0 or max(sides) == 0:
                if sides == (0, 0, 0) and volume(a, b, c, p) == 0 and not is_ahead((a, b, c), p, ray):
                    continue
                break
            side = 1 if sides[0] > 0 else -1
            if determinant(u, v, w) * side > 0:
                total += side
        else:
            return total
    raise Unreadable("no ray avoids all edges")


def is_ahead(triangle, p, ray):
    return any(sum(x * y for x, y in zip(minus(q, p), ray)) >= 0 for q in triangle)


def components(triangles):
    """The sets of triangles that are connected by edges."""
    leader = list(range(len(triangles)))

    def find(i):
        while leader[i] != i:
            leader[i] = i = leader[leader[i]]
        return i

    seen = {}
    for i, t in enumerate(triangles):
        for edge in zip(t, t[1:] + t[:1]):
            leader[find(seen.setdefault(frozenset(edge), i))] = find(i)
    parts = {}
    for i, t in enumerate(triangles):
        parts.setdefault(find(i), []).append(t)
    return list(parts.values())


def read_solid(path, exact):
    """The triangles of a closed mesh. Components of negative volume that no other component encloses are turned."""
    if not path.endswith(".off"):
        raise Unreadable(path + ": solids are read as .off only")
    triangles = read_off(path, exact)
    balance = {}
    for t in triangles:
        for a, b in zip(t, t[1:] + t[:1]):
            balance[a, b] = balance.get((a, b), 0) + 1
            balance[b, a] = balance.get((b, a), 0) - 1
    if any(balance.values()):
        raise Unreadable(path + ": the mesh is not closed")
    parts = components(triangles)
    kept = []
    for part in parts:
        others = [t for other in parts if other is not part for t in other]
        if sum(volume(*t, (0, 0, 0)) for t in part) < 0:
            around = {winding(p, others) > 0 for t in part for p in t}
            if len(around) > 1:
                raise Unreadable(path + ": a component that is inside out lies partly in another one")
            if around == {False}:
                part = [t[::-1] for t in part]
        kept += part
    return kept


def is_inside(p, triangles, rule):
    """Whether a point belongs to the solid; the point must lie on no face."""
    turns = winding(p, triangles)
    return {"positive": turns > 0, "nonzero": turns != 0, "odd": turns % 2 == 1}[rule]


def check_relation(claim, paths):
    """A point that lies in one solid and not in the other, or in both."""
    require(len(paths) == 2, "two solids are needed")
    p = exact_point(claim["point"], 3)
    inside = [is_inside(p, read_solid(path, claim["exact_decimals"]), claim["rule"]) for path in paths]
    wanted = {"A is not a subset of B": [True, False], "B is not a subset of A": [False, True],
              "A and B meet": [True, True]}[claim["claim"]]
    require(inside == wanted, "the point does not lie there")
    return claim["claim"] + ": look at the point %s, %s, %s" % p


def check_separation(claim, paths):
    """A plane that separates the vertices of two solids, and so the solids."""
    require(len(paths) == 2, "two solids are needed")
    *normal, offset = exact_point(claim["plane"], 4)
    for path, side in zip(paths, (-1, 1)):
        for t in read_solid(path, claim["exact_decimals"]):
            for p in t:
                value = sum(x * y for x, y in zip(normal, p)) + offset
                require(value * side > 0, "a vertex lies on the wrong side of the plane")
    return "A and B do not meet: a plane separates them"


def check_not_convex(claim, paths):
    """A segment whose ends lie in the solid, and a point of it that does not."""
    require(len(paths) == 1, "one solid is needed")
    solid = read_solid(paths[0], claim["exact_decimals"])
    a, b = (exact_point(p, 3) for p in claim["segment"])
    p = exact_point(claim["outside"], 3)
    parts = {(x - s) / (t - s) if s != t else None if x == s else 2 for x, s, t in zip(p, a, b)} - {None}
    require(len(parts) == 1 and 0 < min(parts) < 1, "the point is not on the segment")
    for q, wanted in ((a, True), (b, True), (p, False)):
        require(is_inside(q, solid, claim["rule"]) == wanted, "a point does not lie where it should")
    return "A is not convex: a segment between two of its points leaves it at %s, %s, %s" % p


# ---------------------------------------------------------------- the certificate

CHECKS = {
    "map has a defect": check_map_defect,
    "A is not a subset of B": check_relation,
    "B is not a subset of A": check_relation,
    "A and B meet": check_relation,
    "A and B do not meet": check_separation,
    "A is not convex": check_not_convex,
}


def verify(certificate, paths):
    """Returns a sentence for each claim. Throws if a claim does not hold."""
    if certificate.get("plumb_certificate") != 1:
        raise Unreadable("no certificate of version 1")
    if not certificate["claims"]:
        raise Unreadable("nothing is claimed: " + certificate.get("reason", ""))
    for claim in certificate["claims"]:
        require(claim["claim"] in CHECKS, "an unknown claim: %s" % claim["claim"])
    return [CHECKS[claim["claim"]](claim, paths) for claim in certificate["claims"]]


def main():
    if len(sys.argv) < 3:
        print(__doc__.strip())
        return 2
    try:
        with open(sys.argv[1], encoding="utf-8") as file:
            certificate = json.load(file)
        for sentence in verify(certificate, sys.argv[2:]):
            print("proved: " + sentence)
        return 0
    except Refused as refusal:
        print("refused: %s" % refusal)
        return 1
    except (Unreadable, OSError, ValueError, LookupError, TypeError, AttributeError, ArithmeticError) as problem:
        print("not checked: %s" % problem)
        return 2


if __name__ == "__main__":
    sys.exit(main())
