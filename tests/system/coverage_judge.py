"""Whether polygons are a coverage, decided in exact arithmetic: they are valid, and meet in common edges and vertices only.

GEOS computes in doubles, and finds edges that do not match where corners differ in the last bits only. Here coordinates are
multiplied by a power of two that makes all of them integers. Polygons are a coverage if and only if
  1. edges meet only in common ends,
  2. no directed edge occurs twice; outer rings run counter-clockwise and holes clockwise, so a polygon is on the left of its edges,
  3. around each vertex, edges with a polygon on one side only take turns: one leaves, the next one arrives,
  4. the face below the least vertex of each connected part of these edges is covered by no polygon if the lowest edge there
     leaves the vertex, and by one polygon if it arrives. A vertical ray counts how many polygons cover the face.
From 1 to 3 it follows that the number of polygons that cover a face is b or b + 1, for a number b of each connected part; 4 says
that b is 0.
"""
from collections import defaultdict
from fractions import Fraction
from functools import cmp_to_key


def area2(ring):
    return sum(p[0] * q[1] - q[0] * p[1] for p, q in zip(ring, ring[1:] + ring[:1]))


def turn(a, b, c):
    value = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    return (value > 0) - (value < 0)


def scaled(polygons):
    """The polygons with integer coordinates, and the factor."""
    exact = {x: Fraction(x) for rings in polygons for ring in rings for position in ring for x in position[:2]}
    factor = max((x.denominator for x in exact.values()), default=1)  # Denominators are powers of two.
    whole = {x: int(value * factor) for x, value in exact.items()}
    return [[[(whole[p[0]], whole[p[1]]) for p in ring] for ring in rings] for rings in polygons], factor


def directed_edges(polygons):
    """The edges of all rings, with the polygon on the left, whichever way the file lists the rings."""
    for rings in polygons:
        for number, ring in enumerate(rings):
            points = list(ring)
            if points[0] != points[-1]:
                raise ValueError("a ring that is not closed")
            points.pop()
            if len(points) < 3 or area2(points) == 0:
                raise ValueError("a ring without area")
            if (area2(points) > 0) != (number == 0):
                points.reverse()
            yield from zip(points, points[1:] + points[:1])


def meet_wrongly(a, b, c, d):
    """Whether the segments ab and cd, which are different, have a common point that is not an end of both."""
    common = {a, b} & {c, d}
    if len(common) == 1:
        (v,) = common
        u, w = (a if b == v else b), (c if d == v else d)
        return turn(v, u, w) == 0 and (u[0] - v[0]) * (w[0] - v[0]) + (u[1] - v[1]) * (w[1] - v[1]) > 0
    t = (turn(a, b, c), turn(a, b, d), turn(c, d, a), turn(c, d, b))
    if t[0] == t[1] == 0:
        first, second = sorted((sorted((a, b)), sorted((c, d))))
        return second[0] <= first[1]
    return t[0] * t[1] <= 0 and t[2] * t[3] <= 0


def crossing(edges):
    """Two edges that meet wrongly, found by a grid of about one cell an edge; None if there are none."""
    low = [min(p[i] for e in edges for p in e) for i in (0, 1)]
    high = [max(p[i] for e in edges for p in e) for i in (0, 1)]
    side = max(1, int(len(edges) ** 0.5))
    step = [(high[i] - low[i]) // side + 1 for i in (0, 1)]
    cells = defaultdict(list)
    for number, (p, q) in enumerate(edges):
        span = [range((min(p[i], q[i]) - low[i]) // step[i], (max(p[i], q[i]) - low[i]) // step[i] + 1) for i in (0, 1)]
        for x in span[0]:
            for y in span[1]:
                cells[x, y].append(number)
    for numbers in cells.values():
        for k, i in enumerate(numbers):
            for j in numbers[:k]:
                if meet_wrongly(*edges[i], *edges[j]):
                    return edges[i], edges[j]
    return None


def by_angle(v):
    """A key that sorts points counter-clockwise around v, beginning to the right."""

    def half(p):
        return 0 if (p[1] - v[1], p[0] - v[0]) > (0, 0) else 1

    return cmp_to_key(lambda p, q: half(p) - half(q) or -turn(v, p, q))


def parts_of(edges):
    """The vertices of each connected part of the edges."""
    beside = defaultdict(set)
    for p, q in edges:
        beside[p].add(q)
        beside[q].add(p)
    left = set(beside)
    while left:
        part, stack = [], [left.pop()]
        while stack:
            part.append(stack.pop())
            new = beside[part[-1]] & left
            left -= new
            stack.extend(new)
        yield part


class Columns:
    """Edges by their abscissas."""

    def __init__(self, edges):
        xs = [p[0] for e in edges for p in e] or [0]
        self.low, side = min(xs), max(1, int(len(xs) ** 0.5))
        self.step = (max(xs) - self.low) // side + 1
        self.cells = defaultdict(list)
        for e in edges:
            first, last = sorted((e[0][0], e[1][0]))
            for i in range((first - self.low) // self.step, (last - self.low) // self.step + 1):
                self.cells[i].append(e)

    def edges_at(self, x):
        return self.cells[(x - self.low) // self.step]


def flaw(polygons):
    """An empty text if the polygons, as lists of rings of positions, are a coverage; else what is wrong."""
    polygons, factor = scaled(polygons)

    def told(*points):
        return [[float(Fraction(x, factor)) for x in p] for p in points]

    try:
        directed = list(directed_edges(polygons))
    except ValueError as error:
        return str(error)
    if not directed:
        return ""
    if len(set(directed)) != len(directed):
        return "a directed edge occurs twice"
    directed = set(directed)
    edges = sorted({tuple(sorted(e)) for e in directed})
    if pair := crossing(edges):
        return "edges meet: %s" % (told(*pair[0], *pair[1]),)
    single = {e for e in directed if e[::-1] not in directed}
    around = defaultdict(list)
    for p, q in single:
        around[p].append((q, True))
        around[q].append((p, False))
    for v, neighbours in around.items():
        neighbours.sort(key=lambda n: by_angle(v)(n[0]))
        if any(a[1] == b[1] for a, b in zip(neighbours, neighbours[1:] + neighbours[:1])):
            return "polygons overlap at %s" % (told(v),)
    columns = Columns(single)
    for part in parts_of(single):
        v = min(part)
        lowest = min(around[v], key=cmp_to_key(lambda n, m: -turn(v, n[0], m[0])))
        # A ray goes down from the vertex, a little to its right.
        covered = 0
        for (px, py), (qx, qy) in columns.edges_at(v[0]):
            if (px <= v[0]) != (qx <= v[0]):
                side = turn((px, py), (qx, qy), v) * (1 if px < qx else -1)
                if side > 0:
                    covered += 1 if px < qx else -1
        if covered != (0 if lowest[1] else 1):
            return "polygons overlap around %s" % (told(v),)
    return ""


def polygons_of(geometry):
    """The polygons of a GeoJSON geometry."""
    if geometry is None:
        return []
    if geometry["type"] == "GeometryCollection":
        return [p for part in geometry["geometries"] for p in polygons_of(part)]
    return {"Polygon": lambda c: [c], "MultiPolygon": lambda c: c}[geometry["type"]](geometry["coordinates"])
