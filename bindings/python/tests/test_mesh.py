"""Meshes from files and to files, their check and their repair."""

from __future__ import annotations

import itertools
import logging

import numpy as np
import pytest

import plumb

POINTS = np.array(list(itertools.product((0.0, 1.0), repeat=3)))
SQUARES = [0, 1, 3, 2, 4, 6, 7, 5, 0, 4, 5, 1, 2, 3, 7, 6, 0, 2, 6, 4, 1, 5, 7, 3]


def cube(count: int = 6) -> plumb.Mesh:
    """Return the first squares of a cube."""
    corners = np.array(SQUARES[: 4 * count], dtype=np.uint32)
    begin = np.arange(0, 4 * count + 1, 4, dtype=np.uint32)
    return plumb.Mesh(POINTS, begin, corners)


@pytest.mark.parametrize("name", ["a.off", "a.obj", "a.ply"])
def test_files_hold_polygons(tmp_path, name):
    cube().write(tmp_path / name)
    read = plumb.Mesh.read(tmp_path / name)
    assert (read.vertices == POINTS).all() and read.corners.tolist() == SQUARES
    assert read.face_count == 6 and repr(read) == "<plumb.Mesh: 8 vertices, 6 faces>"
    assert read.solid().volume() == 1 and read.solid().sources() == [str(tmp_path / name)]
    with pytest.raises(ValueError, match="no triangles"):
        read.triangles  # noqa: B018


def test_files_hold_triangles(tmp_path):
    vertices, triangles = plumb.Solid.box((0, 0, 0), (1, 2, 3)).to_mesh()
    mesh = plumb.Mesh.of_triangles(vertices, triangles)
    for name in ("a.stl", "a.glb"):
        mesh.write(tmp_path / name)
        read = plumb.Mesh.read(tmp_path / name)
        assert read.triangles.shape == (12, 3) and read.solid().volume() == 6
    mesh.write(tmp_path / "other", format="off")
    assert (tmp_path / "other").read_text().startswith("OFF")
    with pytest.raises(plumb.Error, match="triangle"):
        cube().write(tmp_path / "a.stl")
    for wrong in ("gltf", "none"):
        with pytest.raises(plumb.Error) as caught:
            mesh.write(tmp_path / "b.off", format=wrong)
        assert caught.value.code == plumb.ErrorCode.UNKNOWN_FORMAT
    with pytest.raises(plumb.Error) as caught:
        plumb.Mesh.read(tmp_path / "none.off")
    assert caught.value.code == plumb.ErrorCode.CANNOT_OPEN
    bad = plumb.Mesh.of_triangles(vertices, triangles + np.uint32(1))
    with pytest.raises(plumb.Error) as caught:
        bad.write(tmp_path / "c.off")
    assert caught.value.code == plumb.ErrorCode.BAD_INDEX and not (tmp_path / "c.off").exists()


def test_files_hold_attributes(tmp_path, caplog):
    attributes = plumb.MeshAttributes(
        materials=[plumb.Material("red", (1, 0, 0, 1)), plumb.Material("blue", (0, 0, 1, 1))],
        face_material=[0, 0, 1, 1, -1, -1],
        face_id=[5, 4, 3, 2, 1, 0],
        vertex_channels={"color": POINTS},
    )
    mesh = plumb.Mesh(*(getattr(cube(), m) for m in ("vertices", "face_begin", "corners")),
                      attributes)
    with caplog.at_level(logging.INFO, logger="plumb"):
        mesh.write(tmp_path / "a.ply")
    assert "material" in caplog.text
    read = plumb.Mesh.read(tmp_path / "a.ply")
    assert list(read.attributes.face_id) == [5, 4, 3, 2, 1, 0]
    colours = read.attributes.channels["color"]
    assert (colours[:, :3] == POINTS[SQUARES]).all()
    plain = plumb.Mesh.read(tmp_path / "a.ply", attributes=False)
    assert plain.attributes.face_id is None and plain.attributes.channels == {}
    mesh.write(tmp_path / "a.obj")
    again = plumb.Mesh.read(tmp_path / "a.obj").attributes
    assert [m.name for m in again.materials] == ["red", "blue"]
    assert list(again.face_material) == [0, 0, 1, 1, -1, -1]


def test_a_mesh_is_checked():
    whole, open_mesh = cube().check(), cube(5).check()
    assert whole.is_closed and whole.borders == whole.holes == [] and whole.crossing_count == 0
    assert not open_mesh.is_closed and [sorted(c) for c in open_mesh.holes] == [[1, 3, 5, 7]]
    # Two tetrahedra cross. In the other mesh a face is there twice, and one has no area.
    points = np.array([[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]])
    faces = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
    odd = plumb.Mesh.of_triangles(points, np.vstack([faces, [[0, 2, 1], [3, 3, 1]]])).check()
    assert (4, 0) in odd.doubled and odd.degenerate == odd.trimmed == [5]
    both = plumb.Mesh.of_triangles(np.vstack([points, points + 1]), np.vstack([faces, faces + 4]))
    report = both.check()
    assert report.is_closed and report.crossing_count == len(report.crossings) > 1
    assert all(f < 4 <= g for f, g in report.crossings)
    assert len(both.check(max_listed=1).crossings) == 1
    assert both.check(max_listed=1).crossing_count == report.crossing_count
    with pytest.raises(plumb.Error):
        both.check(memory_limit=1)


def test_a_mesh_is_mended():
    mended, done = cube(5).repaired(fill_holes=4)
    assert mended.solid().volume() == 1 and mended.face_count == 6
    assert any("hole" in sentence for sentence in done)
    flipped = cube()
    corners = flipped.corners.copy()
    corners[:4] = corners[:4][::-1]
    turned, _ = plumb.Mesh(POINTS, flipped.face_begin, corners).repaired(reorient=True)
    assert turned.check().is_closed
    torn = plumb.Mesh(POINTS[SQUARES] + np.linspace(0, 1e-9, 24)[:, None], flipped.face_begin,
                      np.arange(24, dtype=np.uint32))
    assert not torn.check().is_closed
    assert torn.repaired(weld=1e-8)[0].check().is_closed
    twice = np.tile(flipped.corners, 2)
    doubled = plumb.Mesh(POINTS, np.arange(0, 49, 4, dtype=np.uint32), twice)
    assert doubled.repaired(doubled="drop")[0].face_count == 6
    with pytest.raises(plumb.Error, match="doubled must be"):
        doubled.repaired(doubled="some")  # type: ignore[arg-type]
    with pytest.raises(plumb.Error, match="weld|tolerance"):
        doubled.repaired(weld=-1.0)
