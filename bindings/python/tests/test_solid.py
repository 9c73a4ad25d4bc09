"""Solids: numbers, arrays, files, queries and errors."""

from __future__ import annotations

import gc
import logging
from fractions import Fraction

import numpy as np
import pytest

import plumb

TETRAHEDRON = (
    np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float),
    np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]], dtype=np.uint32),
)


def tetrahedron() -> plumb.Solid:
    return plumb.Solid.from_mesh(*TETRAHEDRON)


def test_volume_is_exact():
    assert tetrahedron().volume() == Fraction(1, 6)
    assert isinstance(tetrahedron().volume(), Fraction)
    assert (~tetrahedron()).volume() is None
    third = plumb.Solid.box((0, 0, 0), (Fraction(1, 3), 1, 10**40))
    assert third.volume() == Fraction(10**40, 3)
    assert plumb.Solid.box((0, 0, -(10**40)), (1, 1, 0)).volume() == 10**40


@pytest.mark.parametrize("dtype", [np.int8, np.int64, np.uint16, np.float32, np.float64])
@pytest.mark.parametrize("index", [np.int64, np.uint32, np.uint8])
def test_other_types_of_arrays_are_converted(dtype, index):
    vertices, triangles = TETRAHEDRON
    assert plumb.Solid.from_mesh(vertices.astype(dtype), triangles.astype(index)) == tetrahedron()
    assert plumb.Solid.from_mesh(vertices.tolist(), triangles.tolist()) == tetrahedron()


def test_any_layout_of_memory_is_read():
    vertices, triangles = TETRAHEDRON
    wide = np.zeros((8, 6))
    wide[::2, ::2] = vertices
    assert plumb.Solid.from_mesh(wide[::2, ::2], np.asfortranarray(triangles)) == tetrahedron()


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
def test_coordinates_that_are_not_finite_are_refused(bad):
    vertices, triangles = TETRAHEDRON
    with pytest.raises(plumb.Error) as caught:
        plumb.Solid.from_mesh(np.where(vertices == 1, bad, 0), triangles)
    assert caught.value.code == plumb.ErrorCode.NOT_FINITE
    for call in (
        lambda: plumb.Solid.point((0, 0, bad)),
        lambda: tetrahedron().contains((0, bad, 0)),
        lambda: tetrahedron().contains(np.array([0, bad, 0], dtype=np.float32)),
        lambda: tetrahedron().contains_points([[0, bad, 0]]),
        lambda: tetrahedron().translated([bad] * 3),
    ):
        with pytest.raises(plumb.Error) as caught:
            call()
        assert caught.value.code == plumb.ErrorCode.NOT_FINITE


def test_what_a_conversion_would_change_is_refused():
    vertices, triangles = TETRAHEDRON
    with pytest.raises(TypeError, match="integers"):
        plumb.Solid.from_mesh(vertices, triangles.astype(float))
    with pytest.raises(plumb.Error) as caught:
        plumb.Solid.from_mesh(vertices, triangles.astype(np.int64) - 1)
    assert caught.value.code == plumb.ErrorCode.BAD_INDEX
    with pytest.raises(plumb.Error) as caught:
        plumb.Solid.from_mesh(vertices, triangles.astype(np.int64) + 2**32)
    assert caught.value.code == plumb.ErrorCode.BAD_INDEX
    with pytest.raises(plumb.Error) as caught:
        plumb.Solid.from_mesh(vertices.astype(np.int64) * (2**53 + 1), triangles)
    assert caught.value.code == plumb.ErrorCode.NUMBER_OUT_OF_RANGE
    with pytest.raises(ValueError, match="shape"):
        plumb.Solid.from_mesh(vertices[:, :2], triangles)
    with pytest.raises(TypeError):
        plumb.Solid.from_mesh(np.array([["a", "b", "c"]]), triangles)
    with pytest.raises(TypeError):
        plumb.Solid.point((0, 0, "1"))
    with pytest.raises(TypeError):
        plumb.Solid.point((0, 0))


def test_an_open_mesh_says_where_it_is_open():
    vertices, triangles = TETRAHEDRON
    with pytest.raises(plumb.OpenMesh) as caught:
        plumb.Solid.from_mesh(vertices, triangles[1:])
    assert [sorted(chain) for chain in caught.value.borders] == [[0, 1, 2]]
    faces = plumb.Solid.from_mesh(vertices, triangles[1:], surface=True)
    assert faces.counts()["marked_volumes"] == 0 and not faces.is_empty()


def test_winding_rules():
    vertices, triangles = TETRAHEDRON
    twice = np.vstack([triangles, triangles])
    make = plumb.Solid.from_mesh
    assert make(vertices, twice, rule="evenodd") == plumb.Solid.empty()
    assert make(vertices, twice, rule="nonzero") == tetrahedron()
    assert make(vertices, triangles[:, ::-1]) == tetrahedron()
    assert make(vertices, triangles[:, ::-1], rule="positive").is_empty()
    with pytest.raises(plumb.Error, match="rule"):
        make(vertices, triangles, rule="odd")


def test_arrays_outlive_their_solid():
    solid = plumb.Solid.ball(1.0, 3)
    vertices, triangles = solid.to_mesh()
    kept = vertices[5].copy(), int(triangles.sum())
    view = vertices[5]
    del solid, vertices
    gc.collect()
    plumb.Solid.ball(2.0, 3).to_mesh()
    assert (view == kept[0]).all() and int(triangles.sum()) == kept[1]


def test_nearest_coordinates():
    third = plumb.Solid.box((0, 0, 0), (Fraction(1, 3), 1, 1))
    vertices, _ = third.to_mesh(rounding="nearest")
    assert sorted(set(vertices[:, 0])) == [0, 1 / 3]
    for rounding, code in (("nearest", 301), ("valid", 301)):
        with pytest.raises(plumb.Error) as caught:
            (~third).to_mesh(rounding=rounding)
        assert caught.value.code == code
    with pytest.raises(plumb.Error, match="rounding"):
        third.to_mesh(rounding="up")


def test_rays_and_cells():
    cube = plumb.Solid.box((0, 0, 0), (2, 2, 2))
    hit = cube.shoot((-1, 1, Fraction(1, 3)), (1, 0, 0))
    assert hit.point == (0, 1, Fraction(1, 3))
    assert (hit.cell.kind, hit.cell.is_marked) == ("facet", True)
    assert cube.shoot((-1, 1, 1), (-1, 0, 0)) is None
    assert cube.locate((1, 1, 1)).kind == "volume"
    assert cube.has_on_boundary((0, 1, 1)) and not cube.has_on_boundary((1, 1, 1))
    inside = cube.interior().shoot_to_boundary((1, 1, 1), (0, 0, 1))
    assert inside.point == (1, 1, 2) and not inside.cell.is_marked


@pytest.mark.parametrize("extension", ["off", "obj", "stl", "ply", "nef"])
def test_files_come_back(tmp_path, extension):
    solid = plumb.Solid.box((0, 0, 0), (1, 2, 4)) - plumb.Solid.box((0, 0, 0), (1, 1, 1))
    path = tmp_path / f"a.{extension}"
    closed = solid.closure()
    closed.write(path)
    assert plumb.Solid.read(path) == plumb.Solid.read(str(path)) == closed
    with pytest.raises(TypeError):
        plumb.Solid.read(1)
    assert [p.name for p in tmp_path.iterdir()] == [f"a.{extension}"]


def test_what_a_file_does_not_hold_is_said(tmp_path, caplog):
    dangling = plumb.Solid.box((0, 0, 0), (1, 1, 1)) | plumb.Solid.polyline([(0, 0, 0), (0, 0, 5)])
    with pytest.warns(plumb.FileWarning):
        dangling.write(str(tmp_path / "a.off"))
    with caplog.at_level(logging.INFO, logger="plumb"):
        plumb.Solid.box((0, 0, 0), (1, 1, 1), closed=False).write(str(tmp_path / "b.off"))
    assert caplog.messages
    with pytest.raises(plumb.Error) as caught:
        (~dangling).write(str(tmp_path / "c.off"))
    assert caught.value.code == plumb.ErrorCode.CANNOT_WRITE
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a.off", "b.off"]


def test_errors_of_files_have_a_place(tmp_path):
    path = tmp_path / "a.off"
    path.write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 x 0\n3 0 1 2\n")
    with pytest.raises(plumb.Error) as caught:
        plumb.Solid.read(str(path))
    error = caught.value
    assert (error.code, error.file, error.line) == (plumb.ErrorCode.SYNTAX, str(path), 5)
    assert str(error).startswith(f"{path}:5:")
    with pytest.raises(plumb.Error) as caught:
        plumb.Solid.read(str(tmp_path / "none.off"))
    assert caught.value.code == plumb.ErrorCode.CANNOT_OPEN
    with pytest.raises(plumb.Error) as caught:
        tetrahedron().write(str(tmp_path / "a.xyz"))
    assert caught.value.code == plumb.ErrorCode.UNKNOWN_FORMAT


@pytest.mark.parametrize("kind", [plumb.Solid, plumb.PlaneSet])
@pytest.mark.parametrize("data", [b"", b"plumb-nef3 1\n", b"plumb-nef2 1\n", b"\xff\x00", b"OFF\n9"])
def test_damaged_bytes_are_refused(kind, data):
    with pytest.raises(plumb.Error):
        kind.from_bytes(data)


def test_limits():
    ball = plumb.Solid.ball(1.0, 7)
    other = ball.translated((Fraction(1, 7), Fraction(1, 11), Fraction(1, 13)))
    for limits in ({"timeout": 1e-6}, {"memory_limit": 1000}):
        with pytest.raises(plumb.Error) as caught:
            ball.union(other, **limits)
        assert caught.value.code == plumb.ErrorCode.RESOURCE_LIMIT
        assert f"raise {next(iter(limits))}" in str(caught.value)
    for bad in (0, -1.0, float("nan")):
        with pytest.raises(plumb.Error) as caught:
            ball.union(other, timeout=bad)
        assert caught.value.code == plumb.ErrorCode.BAD_ARGUMENT
    calls = []
    two = ball.union(other, threads=2, progress=lambda *call: calls.append(call))
    assert two == ball | other
    assert calls and all(isinstance(phase, str) and done >= 0 for phase, done, _ in calls)


def test_an_exception_of_the_callback_stops_the_operation():
    ball = plumb.Solid.ball(1.0, 7)

    def stop(phase: str, done: int, total: int) -> None:
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        ball.union(ball.translated((Fraction(1, 7), 0, 0)), progress=stop)


def test_truth_repr_and_views():
    assert not plumb.Solid() and plumb.Solid.point((0, 0, 0))
    assert repr(tetrahedron()) == (
        "<plumb.Solid: 4 vertices, 6 edges, 4 facets, 2 volumes (1 marked)>"
    )
    page = tetrahedron().to_html(title="A <tetrahedron>")
    assert page.startswith("<!") and "<tetrahedron>" not in page
    assert tetrahedron()._repr_html_().startswith("<iframe")
    assert plumb.Solid.half_space((1, 0, 0, 0)).to_html()


def test_other_sets():
    make = plumb.Solid
    square = make.facet([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)])
    assert square.is_subset_of(make.plane((0, 0, 1, 0)))
    assert make.points([(0, 0, 0), (0, 0, 0)]) == make.point((0, 0, 0))
    assert make.half_spaces([(1, 0, 0, 0), (-1, 0, 0, 0)]) == make.plane((1, 0, 0, 0))
    assert make.half_space((1, 0, 0, 0), closed=False) == ~make.half_space((-1, 0, 0, 0))
    assert make.ball(1.0, 0).volume() == Fraction(4, 3)
    with pytest.raises(plumb.Error):
        make.facet([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 1)])


def test_sections_are_those_of_half_spaces():
    cube = plumb.Solid.box((0, 0, 0), (3, 3, 3))
    plane = (1, 2, 3, Fraction(-9, 2))
    closed, opened = (plumb.Solid.half_space(plane, closed=c) for c in (True, False))
    assert cube.section(plane) == cube & closed
    assert cube.section(plane, side="open") == cube & opened
    assert cube.section(plane, side="plane") == cube & plumb.Solid.plane(plane)
    assert cube.section(plane, keep="outside") == cube - closed
    assert cube.section(plane) | cube.section(plane, keep="outside") == cube
    for wrong in ({"side": "left"}, {"keep": "none"}):
        with pytest.raises(plumb.Error, match="must be"):
            cube.section(plane, **wrong)


def test_expressions():
    a, b, c = (plumb.Solid.box((i, 0, 0), (i + 2, 2, 2)) for i in range(3))
    solids = {"A": a, "B": b, "C": c, "unused": a}
    assert plumb.Solid.evaluate("(A + B) * !C", solids) == (a | b) & ~c
    assert plumb.Solid.evaluate("A + B @ C", solids) == a | b.minkowski_sum(c)
    assert plumb.Solid.evaluate("A - B ^ C", {"A": a, "B": b, "C": c}) in (
        (a - b) ^ c,
        a - (b ^ c),
    )
    with pytest.raises(plumb.Error, match="no solid called 'D'"):
        plumb.Solid.evaluate("A + D", solids)
    with pytest.raises(plumb.Error) as caught:
        plumb.Solid.evaluate("A + ", solids)
    assert caught.value.code == plumb.ErrorCode.SYNTAX
