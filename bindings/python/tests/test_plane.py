"""Sets of the plane: makers, files and queries beyond the laws."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

import plumb

make = plumb.PlaneSet


def test_makers_agree():
    square = make.polygon([(0, 0), (2, 0), (2, 2), (0, 2)])
    assert square == make.box((0, 0), (2, 2)) == make.polygon([(0, 2), (2, 2), (2, 0), (0, 0)])
    half_planes = [(-1, 0, 0), (0, -1, 0), (1, 0, -2), (0, 1, -2)]
    assert square == make.intersection_of([make.half_plane(line) for line in half_planes])
    assert square.interior() == make.box((0, 0), (2, 2), closed=False)
    assert square.boundary() == make.polyline([(0, 0), (2, 0), (2, 2), (0, 2), (0, 0)])
    ring = make.polygons([[(0, 0), (3, 0), (3, 3), (0, 3)], [(1, 1), (2, 1), (2, 2), (1, 2)]])
    assert ring.area() == 8
    points = np.array([[0, 0], [3, 0], [3, 3], [0, 3], [1, 1], [2, 1], [2, 2], [1, 2]])
    assert make.from_rings(points, [0, 4, 8]) == ring
    with pytest.raises(plumb.Error):
        make.from_rings(points, [0, 9])
    assert make.half_plane((1, 0, 0)) & make.half_plane((-1, 0, 0)) == make.line((1, 0, 0))
    assert make.points([(0, 0), (0, 0)]) == make.point((0, 0))
    assert make.box((1, 1), (0, 0)).is_empty()


def test_exact_coordinates():
    third = make.box((0, 0), (Fraction(1, 3), 1))
    assert third.area() == Fraction(1, 3)
    assert third.contains((Fraction(1, 3), 0)) and not third.contains((1 / 3 + 1e-16, 0))
    lines = make.line((3, 0, -1)) & make.line((0, 7, -1))
    assert lines == make.point((Fraction(1, 3), Fraction(1, 7)))
    hit = third.shoot((-1, Fraction(1, 2)), (1, 0))
    assert hit.point == (0, Fraction(1, 2)) and hit.cell.kind == "edge"


@pytest.mark.parametrize(
    "unbounded",
    [make.half_plane((1, 2, 3)), make.line((0, 1, -5)), make.line((1, 0, -5)), make.whole()],
)
def test_unbounded_sets_have_canonical_bytes(unbounded):
    moved = unbounded.translated((Fraction(1, 3), 2)).translated((Fraction(-1, 3), -2))
    assert moved == unbounded and moved.to_bytes() == unbounded.to_bytes()
    assert make.from_bytes(unbounded.to_bytes()) == unbounded
    assert make.from_bytes(unbounded.to_bytes()).audit() is None
    assert unbounded.area() is None or unbounded.area() == 0


@pytest.mark.parametrize("extension", ["wkt", "geojson", "wkb", "nef2"])
def test_files_come_back(tmp_path, extension):
    set_of_plane = make.box((0, 0), (4, 4)) | make.polyline([(4, 4), (9, 9)]) | make.point((0, 9))
    path = str(tmp_path / f"a.{extension}")
    set_of_plane.write(path)
    assert make.read(path) == set_of_plane


def test_grid_and_losses(tmp_path):
    third = make.box((0, 0), (Fraction(1, 3), 1))
    assert make.from_bytes(third.to_wkt(grid=Fraction(1, 4)).encode()).area() == Fraction(1, 4)
    with pytest.warns(plumb.FileWarning):
        make.half_plane((1, 0, 0)).write(str(tmp_path / "a.wkt"))
    with pytest.raises(plumb.Error):
        third.to_wkt(grid=0)
    with pytest.raises(plumb.Error):
        third.write(str(tmp_path / "a.svg"))


def test_convex_parts():
    corner = make.box((0, 0), (2, 2)) - make.box((1, 1), (3, 3))
    assert not corner.is_convex() and make.box((0, 0), (2, 2)).is_convex()
    parts = corner.decompose()
    assert len(parts) == 2 and make.union_of(parts) == corner


def test_repr_and_views():
    assert repr(make.box((0, 0), (1, 1))) == (
        "<plumb.PlaneSet: 4 vertices, 4 edges, 2 faces (1 marked)>"
    )
    assert make.whole().to_html(title="x").startswith("<!")
    assert make.box((0, 0), (1, 1))._repr_html_().startswith("<iframe")


def test_fewer_corners():
    toothed = plumb.PlaneSet.polygon(
        [(0, 0), (8, 0), (8, 8), (5, 8), (4, Fraction(17, 2)), (3, 8), (0, 8)]
    )
    square = plumb.PlaneSet.box((0, 0), (8, 8))
    assert toothed.simplified(tolerance=0.5) == square
    assert toothed.simplified(tolerance=0.5, within=0.25) == toothed
    assert toothed.simplified(tolerance=0.0) == toothed
    with pytest.raises(plumb.Error):
        toothed.simplified(tolerance=-1.0)
    with pytest.raises(plumb.Error, match="unbounded|bounded"):
        (~toothed).simplified()
