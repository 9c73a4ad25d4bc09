"""Primitives, hulls, extrusions, slices, offsets and models of OpenSCAD."""

from __future__ import annotations

import math
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import plumb

small = st.integers(-5, 5)
points3 = st.lists(st.tuples(small, small, small), min_size=1, max_size=12)


def box(size: tuple[int, int, int]) -> plumb.Solid:
    return plumb.Solid.box((0, 0, 0), size)


def test_primitives_have_the_volumes_of_their_polyhedra() -> None:
    chords = 32
    area = chords / 2 * math.sin(2 * math.pi / chords)
    cylinder = plumb.Solid.cylinder(3, 2, chords=chords)
    assert float(cylinder.volume() or 0) == pytest.approx(3 * 4 * area)
    cone = plumb.Solid.cylinder(3, 2, 0, chords=chords)
    assert float(cone.volume() or 0) == pytest.approx(4 * area)
    ball = plumb.Solid.sphere(1, 64)
    assert ball.is_convex()
    assert float(ball.volume() or 0) == pytest.approx(4 / 3 * math.pi, rel=0.01)
    torus = plumb.Solid.torus(4, 1)
    assert torus.genus() == 1
    assert float(torus.volume() or 0) == pytest.approx(2 * math.pi**2 * 4, rel=0.05)


@given(points3)
def test_a_hull_contains_its_points_and_is_the_hull_of_itself(
    points: list[tuple[int, int, int]],
) -> None:
    hull = plumb.Solid.hull(np.array(points, dtype=float))
    assert hull == plumb.Solid.points(points).convex_hull()
    assert hull.is_convex() and hull.is_closed()
    assert hull.contains_points(np.array(points, dtype=float)).all()
    assert hull.convex_hull() == hull


def test_hulls_of_several_sets() -> None:
    a = box((1, 1, 1))
    assert plumb.Solid.hull_of([a, a.translated((2, 0, 0))]) == box((3, 1, 1))
    square = plumb.PlaneSet.box((0, 0), (1, 1))
    other = square.translated((0, 4))
    assert plumb.PlaneSet.hull_of([square, other]) == plumb.PlaneSet.box((0, 0), (1, 5))
    corners = np.array([[0, 0], [1, 0], [1, 5], [0, 5]], dtype=float)
    assert (square | other).convex_hull() == plumb.PlaneSet.hull(corners)


def test_parts_and_boxes() -> None:
    a = box((1, 1, 1))
    both = a | a.translated((Fraction(7, 3), 0, 0))
    parts = both.components()
    assert len(parts) == 2 and plumb.Solid.union_of(parts) == both
    assert both.bounding_box() == ((0, 0, 0), (Fraction(10, 3), 1, 1))
    assert plumb.Solid().bounding_box() is None
    assert (~a).genus() is None


def test_distances_and_offsets() -> None:
    a = box((1, 1, 1))
    b = a.translated((3, 0, Fraction(1, 3)))
    apart = a.distance(b)
    assert apart.squared == 4 and apart.length == 2.0
    p, q = apart.points
    assert p[0] == 1 and q[0] == 3 and p[1:] == q[1:]
    cell, other_cell = apart.cells
    assert (cell, other_cell) != (None, None) and cell.kind in {"vertex", "edge", "facet"}
    assert a.locate(p).index == cell.index and b.locate(q).kind == other_cell.kind
    assert a.offset(2).distance(b).squared == 0
    assert a.offset(0.25, rounds=0).offset(-0.25, rounds=0) == a
    square = plumb.PlaneSet.box((0, 0), (1, 1))
    assert square.distance(square.translated((4, 5))).squared == 25
    with pytest.raises(plumb.Error):
        a.distance(plumb.Solid())


def test_slices_are_the_outlines_of_extrusions() -> None:
    ring = plumb.PlaneSet.box((0, 0), (4, 4)) - plumb.PlaneSet.box((1, 1), (2, 2))
    closed = ring.closure()
    solid = ring.extruded(2)
    assert solid.slice(Fraction(1, 3)) == closed
    assert solid.slices([0, 1, 2, 3]) == [closed, closed, closed, plumb.PlaneSet()]
    assert solid.shadow() == closed
    assert solid.volume() == 2 * (ring.area() or 0)
    turned = plumb.PlaneSet.box((1, 0), (2, 1)).revolved(steps=4)
    assert turned.volume() == 2 * (2**2 - 1**2)
    with pytest.raises(plumb.Error):
        plumb.PlaneSet.box((-1, 0), (2, 1)).revolved()


def test_maps_of_space() -> None:
    a = box((1, 2, 3))
    assert a.rotated((0, 0, 1), 90) == plumb.Solid.box((-2, 0, 0), (0, 1, 3))
    assert a.rotated((1, 2, 3), 40).volume() == 6  # The matrix is exactly orthogonal.
    assert a.scaled((2, 1, Fraction(1, 3))) == box((2, 2, 1))
    assert a.mirrored((1, 0, 0)) == plumb.Solid.box((-1, 0, 0), (0, 2, 3))
    assert a.resized((2, 0, 0)) == box((2, 2, 3))
    assert a.resized((2, 0, 0), (False, True, True)) == box((2, 4, 6))


def test_offsets_and_sums_of_the_plane() -> None:
    square = plumb.PlaneSet.box((0, 0), (2, 2))
    grown = plumb.PlaneSet.box((-1, -1), (3, 3))
    assert square.offset(1, join="mitre") == grown
    assert grown.offset(-1) == square
    assert square.minkowski_sum(plumb.PlaneSet.box((-1, -1), (1, 1))) == grown
    area = float(square.offset(1, circle_segments=64).area() or 0)
    assert area == pytest.approx(4 + 8 + math.pi, rel=0.01)
    with pytest.raises(plumb.Error, match="join must be"):
        square.offset(1, join="pointed")


def test_models_of_openscad(tmp_path: Path) -> None:
    text = "difference() { cube(size = [4, 4, 2], center = false); cylinder(h = 9, r = 1, $fn = 4); }"
    model = plumb.parse_csg(text)
    assert isinstance(model, plumb.Solid)
    cut = plumb.Solid.box((0, 0, 0), (4, 4, 2)) - plumb.Solid.cylinder(9, 1, chords=4)
    assert model == cut.regularization()
    path = tmp_path / "model.csg"
    path.write_text(text)
    assert plumb.read_csg(path) == model
    assert plumb.parse_csg("square(size = [2, 3]);") == plumb.PlaneSet.box((0, 0), (2, 3))
    assert plumb.parse_csg("group();") is None
    with pytest.raises(plumb.Error) as caught:
        plumb.parse_csg("cube(size = 1);\nfrob();")
    assert (caught.value.line, caught.value.column) == (2, 1)
    path.write_text('import(file = "model.off");')
    with pytest.raises(plumb.Error):
        plumb.read_csg(path)


def test_colours_of_models_of_openscad() -> None:
    text = (
        "difference() { color([1, 0, 0, 1]) { cube(size = 2); } "
        "color([0, 0, 1, 0.5]) { cube(size = 1); } }"
    )
    model = plumb.parse_csg(text)
    assert isinstance(model, plumb.Solid)
    made = model.to_mesh_with_attributes()
    assert made.face_material is not None
    of_notch = (made.vertices[made.triangles].max(axis=(1, 2)) <= 1) & (
        made.vertices[made.triangles] == 1
    ).all(axis=1).any(axis=1)
    colours = [made.materials[i].color for i in made.face_material]
    assert {c for c, inner in zip(colours, of_notch, strict=True) if inner} == {(0, 0, 1, 0.5)}
    assert {c for c, inner in zip(colours, of_notch, strict=True) if not inner} == {(1, 0, 0, 1)}


def test_triangulations() -> None:
    ring = plumb.PlaneSet.box((0, 0), (3, 3)) - plumb.PlaneSet.box((1, 1), (2, 2))
    points, triangles = ring.triangulated()
    assert points.shape == (8, 2) and triangles.shape == (8, 3)
    a, b, c = (points[triangles[:, i]] for i in range(3))
    areas = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
    assert (areas > 0).all() and areas.sum() / 2 == 8
    square = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.5, 0.5]])
    assert len(plumb.PlaneSet.delaunay(square)) == 4
