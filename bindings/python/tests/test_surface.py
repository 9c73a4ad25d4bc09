"""Surfaces: geodesics and cells."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

import plumb


def cube_surface() -> plumb.Surface:
    return plumb.Surface.from_mesh(*plumb.Solid.box((0, 0, 0), (1, 1, 1)).to_mesh())


def sphere() -> plumb.Surface:
    return plumb.Surface.from_mesh(*plumb.Solid.ball(1.0, 3).to_mesh())


def test_geodesics_on_a_cube():
    vertices, _ = plumb.Solid.box((0, 0, 0), (1, 1, 1)).to_mesh()
    surface = cube_surface()
    start = int(np.flatnonzero((vertices == 0).all(axis=1))[0])
    end = int(np.flatnonzero((vertices == 1).all(axis=1))[0])
    path = surface.geodesic(start, end)
    # The shortest path unfolds two faces into a rectangle of sides 1 and 2.
    assert path.length == pytest.approx(5**0.5)
    assert (path.points[0] == 0).all() and (path.points[-1] == 1).all()
    assert len(path.faces) == len(path.points) - 1
    assert surface.geodesic(end, start).length == path.length
    assert surface.geodesic(start, start).length == 0


def test_shortest_paths():
    # H. E. Dudeney's spider and fly: the shortest way unfolds five of the six walls.
    vertices, triangles = plumb.Solid.box((0, 0, 0), (30, 12, 12)).to_mesh()
    surface = plumb.Surface.from_mesh(vertices, triangles)

    def spot(point):
        for face, (a, b, c) in enumerate(vertices[triangles]):
            normal = np.cross(b - a, c - a)
            if (point - a) @ normal == 0:
                u = np.cross(point - a, c - a) @ normal / (normal @ normal)
                v = np.cross(b - a, point - a) @ normal / (normal @ normal)
                if u >= 0 and v >= 0 and u + v <= 1:
                    return face, u, v

    spider, fly = spot(np.array([0, 6, 11])), spot(np.array([30, 6, 1]))
    assert surface.geodesic(spider, fly, shortest=True).length == pytest.approx(40, rel=1e-12)
    assert surface.geodesic(spider, fly).length >= 40 - 1e-12


def test_points_of_faces_are_exact():
    vertices, triangles = plumb.Solid.box((0, 0, 0), (1, 1, 1)).to_mesh()
    surface = plumb.Surface.from_mesh(vertices, triangles)
    middle = surface.geodesic((0, Fraction(1, 3), Fraction(1, 3)), 0).points[0]
    assert middle == pytest.approx(vertices[triangles[0]].mean(axis=0))
    second = surface.geodesic((0, 1, 0), 0).points[0]
    assert (second == vertices[triangles[0][1]]).all()
    for bad in [(0, 2, 0), (99, 0, 0), 99, -1, 0.5]:
        with pytest.raises((plumb.Error, TypeError)):
            surface.geodesic(bad, 0)


def test_flipped_faces_keep_their_weights():
    vertices, triangles = plumb.Solid.box((0, 0, 0), (1, 1, 1)).to_mesh()
    turned = triangles.copy()
    turned[3] = turned[3][::-1]
    surface = plumb.Surface.from_mesh(vertices, turned)
    start = surface.geodesic((3, Fraction(1, 2), Fraction(1, 4)), 0).points[0]
    a, b, c = vertices[turned[3]]
    assert start == pytest.approx(a / 4 + b / 2 + c / 4)


def test_a_closed_polygon_divides_a_sphere():
    surface = sphere()
    division = surface.divide([[0, 10, 20]], outside=50)
    assert division.cell_count == 2 and division.separates(0)
    areas = [division.area(c) for c in range(2)]
    points, triangles, cells = division.to_mesh()
    a, b, c = (points[triangles[:, i]] for i in range(3))
    doubled = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    for cell in range(2):
        assert doubled[cells == cell].sum() / 2 == pytest.approx(areas[cell])
    inside, outside = division.select("A", rule="nonzero"), division.select("!A", rule="nonzero")
    assert (inside.cells ^ outside.cells).all()
    assert inside.area + outside.area == pytest.approx(sum(areas))
    assert len(inside.borders) == 1 and inside.borders[0].shape[1] == 3
    (marked,) = np.flatnonzero(inside.cells)
    assert division.labels(int(marked))[0][0] == 0
    with pytest.raises(plumb.Error):
        division.select("B")
    with pytest.raises(plumb.Error):
        division.area(2)


def test_files_and_views(tmp_path):
    division = sphere().divide([[0, 10, 20]])
    for extension in ("obj", "ply"):
        division.write(str(tmp_path / f"a.{extension}"))
        assert (tmp_path / f"a.{extension}").stat().st_size > 0
    with pytest.raises(plumb.Error):
        division.write(str(tmp_path / "a.off"))
    assert division.to_html().startswith("<!")
    (tmp_path / "ball.off").unlink(missing_ok=True)
    plumb.Solid.ball(1.0, 1).write(str(tmp_path / "ball.off"))
    scene = tmp_path / "scene.json"
    scene.write_text('{"model": "ball.off", "points": [[0, 0, 0], [5, "1/3", "1/3"], [9, 0, 1]],'
                     ' "polygons": [[0, 1, 2]]}')
    assert plumb.SurfaceDivision.read(str(scene)).counts()["triangles"] == 32


def test_errors_of_meshes():
    with pytest.raises(plumb.Error) as caught:
        plumb.Surface.from_mesh(np.zeros((3, 3)), [[0, 1, 1]])
    assert caught.value.code == plumb.ErrorCode.DEGENERATE_FACE
    two = plumb.Solid.union_of([plumb.Solid.ball(1.0, 1), plumb.Solid.ball(1.0, 1).translated((9, 0, 0))])
    vertices, triangles = two.to_mesh()
    surface = plumb.Surface.from_mesh(vertices, triangles)
    assert surface.component_count == 2
    left, right = int(vertices[:, 0].argmin()), int(vertices[:, 0].argmax())
    assert surface.geodesic(left, right) is None
    with pytest.raises(plumb.Error):
        surface.divide([[left, right]])
