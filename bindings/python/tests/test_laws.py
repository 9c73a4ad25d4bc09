"""Laws of sets, and volumes beside brute force over unit cells."""

from __future__ import annotations

import copy
import pickle
from fractions import Fraction

import numpy as np
import pytest
from boxes import SIZE, cells, lists_of_boxes, plane_set, solid
from hypothesis import given
from hypothesis import strategies as st

import plumb

KINDS = [
    pytest.param(3, solid, plumb.Solid, "volume", id="solid"),
    pytest.param(2, plane_set, plumb.PlaneSet, "area", id="plane"),
]


@pytest.mark.parametrize(("dimension", "make", "kind", "measure"), KINDS)
@given(data=st.data())
def test_measures_are_those_of_the_unit_cells(dimension, make, kind, measure, data):
    a, b = (data.draw(lists_of_boxes(dimension)) for _ in "ab")
    p, q = make(a), make(b)
    in_a, in_b = cells(a), cells(b)
    for set_of_plumb, set_of_cells in [
        (p | q, in_a | in_b),
        (p & q, in_a & in_b),
        (p - q, in_a - in_b),
        (p ^ q, in_a ^ in_b),
    ]:
        assert getattr(set_of_plumb, measure)() == len(set_of_cells)
        assert set_of_plumb.audit() is None


@pytest.mark.parametrize(("dimension", "make", "kind", "measure"), KINDS)
@given(data=st.data())
def test_laws_of_sets(dimension, make, kind, measure, data):
    p, q = (make(data.draw(lists_of_boxes(dimension)), data.draw(st.booleans())) for _ in "ab")
    assert ~(p | q) == ~p & ~q
    assert ~(p & q) == ~p | ~q
    assert p | q == q | p == p + q == kind.union_of([p, q])
    assert p & q == q & p == p * q == kind.intersection_of([q, p])
    assert p - q == p & ~q == p.difference(q)
    assert p ^ q == (p - q) | (q - p) == p.symmetric_difference(q)
    assert (p & q).is_subset_of(p) and p.is_subset_of(p | q)
    assert ~~p == p and p | ~p == kind.whole() and p & ~p == kind.empty()
    assert p.closure() == p.interior() | p.boundary()
    total, common = getattr(p | q, measure)(), getattr(p & q, measure)()
    assert total + common == getattr(p, measure)() + getattr(q, measure)()


@pytest.mark.parametrize(("dimension", "make", "kind", "measure"), KINDS)
@given(data=st.data())
def test_equal_sets_have_equal_bytes_and_hashes(dimension, make, kind, measure, data):
    a, b = (data.draw(lists_of_boxes(dimension)) for _ in "ab")
    there, back = make(a + b), make(b) | make(a)
    assert there == back
    assert there.to_bytes() == back.to_bytes()
    assert hash(there) == hash(back)
    outside = ~there
    for value in (there, outside):
        assert pickle.loads(pickle.dumps(value)) == value
        assert kind.from_bytes(value.to_bytes()) == value
        assert copy.copy(value) == copy.deepcopy(value) == value
    assert there != outside and there != 1


@pytest.mark.parametrize(("dimension", "make", "kind", "measure"), KINDS)
@given(data=st.data())
def test_points_lie_where_the_boxes_say(dimension, make, kind, measure, data):
    a = data.draw(lists_of_boxes(dimension))
    closed = data.draw(st.booleans())
    number = st.integers(-1, 2 * SIZE + 1).map(lambda n: n / 2)
    points = data.draw(st.lists(st.tuples(*[number] * dimension), min_size=1, max_size=10))

    def is_inside(point):
        def lies(x, low, high):
            return low <= x <= high if closed else low < x < high

        return any(all(map(lies, point, low, high)) for low, high in a)

    union = make(a, closed)
    expected = [is_inside(point) for point in points]
    assert union.contains_points(np.array(points)).tolist() == expected
    assert [union.contains([Fraction(x) for x in point]) for point in points] == expected
    assert [union.locate(point).is_marked for point in points] == expected


@given(a=lists_of_boxes(3), by=st.tuples(*[st.fractions(max_denominator=7)] * 3))
def test_moves_keep_the_volume(a, by):
    set_of_boxes = solid(a)
    moved = set_of_boxes.translated(by)
    assert moved.volume() == set_of_boxes.volume()
    assert moved.translated([-x for x in by]) == set_of_boxes
    swapped = set_of_boxes.transformed([(0, 2, 0, 0), (1, 0, 0, 0), (0, 0, Fraction(1, 3), 0)])
    assert swapped.volume() == set_of_boxes.volume() * Fraction(2, 3)


@given(a=lists_of_boxes(3))
def test_parts_are_convex_and_make_up_the_set(a):
    set_of_boxes = solid(a)
    parts = set_of_boxes.decompose()
    assert plumb.Solid.union_of(parts) == set_of_boxes
    assert sum(part.volume() for part in parts) == set_of_boxes.volume()
    assert all(part.closure().is_convex() for part in parts)
    assert (len(parts) <= 1) == (not set_of_boxes.reflex_edges()) or len(parts) > 1


@given(a=st.lists(lists_of_boxes(3), min_size=1, max_size=1), size=st.integers(1, 3))
def test_sums_with_a_box_grow_every_box(a, size):
    boxes_of_set = a[0]
    grown = [(low, tuple(x + size for x in high)) for low, high in boxes_of_set]
    cube = plumb.Solid.box((0, 0, 0), (size,) * 3)
    total = solid(boxes_of_set).minkowski_sum(cube)
    assert total == solid(grown)
    assert solid(boxes_of_set).is_subset_of(total.minkowski_erosion(cube))


@given(a=lists_of_boxes(3))
def test_meshes_come_back_as_the_same_solid(a):
    set_of_boxes = solid(a)
    vertices, triangles = set_of_boxes.to_mesh()
    assert plumb.Solid.from_mesh(vertices, triangles) == set_of_boxes
    points, begin, corners, facets = set_of_boxes.to_polygons()
    assert plumb.Solid.from_polygons(points, begin, corners) == set_of_boxes
    assert len(facets) == len(begin) - 1
