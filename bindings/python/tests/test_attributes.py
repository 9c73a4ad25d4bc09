"""Attributes of meshes stay with solids: unions of boxes against a count of unit squares."""

from __future__ import annotations

import itertools
import logging
import pickle
import time
from fractions import Fraction

import numpy as np
import pytest
from boxes import cells, lists_of_boxes, solid
from hypothesis import given, settings
from hypothesis import strategies as st

import plumb

Arrays = tuple[np.ndarray, np.ndarray]


def box(low: float, high: float) -> Arrays:
    return plumb.Solid.box((low,) * 3, (high,) * 3).to_mesh()


def painted(mesh: Arrays, name: str, first_id: int = 0) -> plumb.Solid:
    """Return the solid of a mesh with a material, ids, and its coordinates as channels."""
    vertices, triangles = mesh
    count = len(triangles)
    attributes = plumb.MeshAttributes(
        name=name,
        materials=[plumb.Material(name, (1.0, 0.5, 0.0, 1.0))],
        face_material=np.zeros(count, dtype=np.int8),
        groups=["even", "odd"],
        face_group=[i % 2 for i in range(count)],
        face_id=np.arange(count, dtype=np.uint64) + first_id,
        channels={"texcoord_0": vertices[triangles][:, :, :2]},
        vertex_channels={"place": vertices},
    )
    return plumb.Solid.from_mesh(vertices, triangles, attributes=attributes)


def squares(a: frozenset, b: frozenset) -> list[int]:
    """Count the unit squares of the boundary of a - b that belong to a, and those of b alone."""
    rest, counts = a - b, [0, 0]
    for cell in rest:
        for axis, step in itertools.product(range(3), (-1, 1)):
            beyond = tuple(x + step * (i == axis) for i, x in enumerate(cell))
            if beyond not in rest:
                counts[0 if beyond not in a else 1] += 1
    return counts


def areas(made: plumb.MeshWithAttributes) -> np.ndarray:
    """Return the areas of triangles that are parallel to two axes."""
    p, q, r = (made.vertices[made.triangles[:, i]] for i in range(3))
    return np.abs(np.cross(q - p, r - p)).sum(axis=1) / 2


@settings(max_examples=30)
@given(
    a=lists_of_boxes(3),
    b=lists_of_boxes(3),
    pieces=st.sampled_from(["same-attributes", "same-face", "apart"]),
)
def test_each_face_has_its_source(a, b, pieces):
    meshes = [solid(a).to_mesh(), solid(b).to_mesh()]
    first, second = painted(meshes[0], "first"), painted(meshes[1], "second", 1000)
    made = (first - second).to_mesh_with_attributes(pieces=pieces)
    found = [areas(made)[made.source == i].sum() for i in range(2)]
    assert found == pytest.approx(squares(cells(a), cells(b)), abs=1e-12)
    assert (np.diff(made.source) >= 0).all() and (made.source >= 0).all()
    assert (made.is_flipped == (made.source == 1)).all()
    used = [i for i in range(2) if (made.source == i).any()]
    for i in used:
        faces = made.source == i
        assert (made.face_material[faces] == i).all()
        assert (made.face_id[faces] == made.source_face[faces] + 1000 * i).all()
        assert (made.face_group[faces] == made.source_face[faces] % 2 + 2 * i).all()
        vertices, triangles = meshes[i]
        corners = vertices[triangles[made.source_face[faces]]]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        offsets = made.vertices[made.triangles[faces]] - corners[:, :1]
        assert (np.einsum("fck,fk->fc", offsets, normals) == 0).all()
    # Weights such as 1/3 are rounded once, and corners of sources have their own numbers.
    places = made.vertices[made.corners]
    assert np.abs(made.channels["place"] - places).max(initial=0) < 1e-14
    assert (made.channels["texcoord_0"] == made.channels["place"][:, :2]).all()


def test_names_materials_and_groups_of_all_sources_follow_each_other():
    united = painted(box(0, 2), "red") | painted(box(1, 3), "blue")
    assert united.sources() == ["red", "blue"]
    made = united.to_mesh_with_attributes()
    assert [m.name for m in made.materials] == ["red", "blue"]
    assert made.materials[0].color == (1.0, 0.5, 0.0, 1.0) and made.materials[0].texture == ""
    assert made.groups == ["even", "odd"] * 2
    assert "2 materials" in repr(made)
    # What came out can go in again: same ids at the same places.
    again = plumb.Solid.from_mesh(made.vertices, made.triangles, attributes=made.attributes)
    assert again == united
    same = again.to_mesh_with_attributes(pieces="apart")
    assert (same.face_id == made.face_id[same.source_face]).all()


def test_polygons_keep_their_corners():
    points = np.array(list(itertools.product((0.0, 1.0), repeat=3)))
    corners = np.array(
        [0, 1, 3, 2, 4, 6, 7, 5, 0, 4, 5, 1, 2, 3, 7, 6, 0, 2, 6, 4, 1, 5, 7, 3], dtype=np.uint32
    )
    begin = np.arange(0, 28, 4)
    attributes = plumb.MeshAttributes(
        face_id=range(6), channels={"place": points[corners], "weight": np.arange(24.0)}
    )
    made = plumb.Solid.from_polygons(
        points, begin, corners, attributes=attributes
    ).to_mesh_with_attributes(polygons=True)
    assert len(made.corners) == 24 and len(made.face_begin) == 7
    assert (made.channels["place"] == made.vertices[made.corners]).all()
    assert sorted(made.channels["weight"][:, 0]) == list(range(24))
    with pytest.raises(ValueError, match="three corners"):
        made.triangles  # noqa: B018


def test_maps_and_floats():
    moved = painted(box(0, 1), "red").translated((Fraction(1, 3), 0, 0))
    made = moved.to_mesh_with_attributes()
    places = made.vertices[made.corners]
    assert np.abs(made.channels["place"] + [1 / 3, 0, 0] - places).max() < 1e-15
    made = moved.to_mesh_with_attributes(floats=True)
    assert (made.vertices == made.vertices.astype(np.float32)).all()
    with pytest.raises(plumb.Error, match="triangles"):
        moved.to_mesh_with_attributes(polygons=True, floats=True)
    with pytest.raises(plumb.Error, match="pieces"):
        moved.to_mesh_with_attributes(pieces="some")
    with pytest.raises(plumb.Error, match="unbounded"):
        (~moved).to_mesh_with_attributes()


def test_solids_without_attributes_have_no_sources():
    plain, traced = plumb.Solid.from_mesh(*box(0, 2)), plumb.Solid.from_mesh(
        *box(1, 3), attributes=plumb.MeshAttributes(name="traced")
    )
    assert plain.sources() == [] and traced.sources() == ["traced"]
    assert plain == plumb.Solid.from_mesh(*box(0, 2), attributes=plumb.MeshAttributes())
    made = (plain | traced).to_mesh_with_attributes()
    assert set(made.source) == {0, -1} and made.source[-1] == -1
    assert (made.source_face[made.source == -1] == -1).all()
    assert made.face_material is made.face_group is made.face_id is None and made.channels == {}
    copy = pickle.loads(pickle.dumps(traced))
    assert copy == traced and copy.sources() == []


@pytest.mark.parametrize(
    ("arguments", "error", "text"),
    [
        ({"face_id": [1] * 11}, plumb.Error, "one entry for each face"),
        ({"face_id": [2**32 - 1] * 12}, plumb.Error, "4294967295"),
        ({"face_id": [-2] * 12}, plumb.Error, "-2"),
        ({"face_id": [0.5] * 12}, TypeError, "integers"),
        ({"face_id": [[0]] * 12}, ValueError, "one dimension"),
        ({"face_material": [0] * 12}, plumb.Error, "no material"),
        ({"face_group": [1] * 12, "groups": ["a"]}, plumb.Error, "no group"),
        ({"channels": {"a": np.zeros((12, 2))}}, plumb.Error, "'a' has 12 rows.*36 corners"),
        ({"vertex_channels": {"a": np.zeros((36, 2))}}, plumb.Error, "36 rows.*8 vertices"),
        ({"channels": {"a": np.full(36, np.nan)}}, plumb.Error, "'a'.*not finite"),
        ({"channels": {"a": ["x"] * 36}}, TypeError, "'a' must have numbers"),
        ({"channels": {"a": 1.0}}, ValueError, "shape"),
        ({"materials": [plumb.Material(color=(0, 0, 2, 1))]}, ValueError, "from 0 to 1"),
        (
            {"channels": {"a": np.zeros(36)}, "vertex_channels": {"a": np.zeros(8)}},
            plumb.Error,
            "same name",
        ),
    ],
)
def test_what_does_not_fit_is_refused(arguments, error, text):
    with pytest.raises(error, match=text):
        plumb.Solid.from_mesh(*box(0, 1), attributes=plumb.MeshAttributes(**arguments))


def test_what_is_no_object_of_attributes_is_refused():
    with pytest.raises(TypeError, match="MeshAttributes, not dict"):
        plumb.Solid.from_mesh(*box(0, 1), attributes={"face_id": [0] * 12})  # type: ignore


def test_files_keep_attributes(tmp_path, caplog):
    united = painted(box(0, 2), "red") - painted(box(1, 3), "blue", 100)
    made = united.to_mesh_with_attributes()
    with caplog.at_level(logging.INFO, logger="plumb"):
        united.write(tmp_path / "a.ply")
    assert "groups" in caplog.text  # PLY has ids, and no groups.
    for keep in ("none", "colours", "ids", "all"):
        read = plumb.Solid.read(tmp_path / "a.ply", keep=keep)
        assert read == united.closure()
        ids = read.to_mesh_with_attributes().face_id
        if keep in ("none", "colours"):
            assert ids is None
        else:
            assert sorted(set(ids)) == sorted(set(made.face_id))
    united.write(tmp_path / "b.obj")
    assert "newmtl blue" in (tmp_path / "b.mtl").read_text()
    read = plumb.Solid.read(tmp_path / "b.obj", keep="all")
    assert read.sources() == [str(tmp_path / "b.obj")]
    again = read.to_mesh_with_attributes()
    assert [m.color for m in again.materials] == [(1.0, 0.5, 0.0, 1.0)] * 2
    with pytest.raises(plumb.Error, match="keep must be"):
        plumb.Solid.read(tmp_path / "b.obj", keep="some")


def test_moved_sources_are_left_soon_when_an_operation_is_stopped():
    vertices, triangles = plumb.Solid.ball(1.0, 7).to_mesh()
    ball = plumb.Solid.from_mesh(vertices, triangles, attributes=plumb.MeshAttributes())
    moved = ball.translated((0.3, 0.2, 0.1))

    def stop(phase: str, done: int, total: int) -> None:
        raise RuntimeError(phase)

    def seconds() -> float:
        start = time.process_time()
        with pytest.raises(RuntimeError):
            moved.to_mesh_with_attributes(progress=stop)
        return time.process_time() - start

    # The time of the processor; one of three attempts has to be in time.
    assert any(seconds() < 0.2 for _ in range(3))


def test_half_spaces_give_their_cuts_attributes() -> None:
    cuts = plumb.MeshAttributes(
        name="saw",
        materials=[plumb.Material("end grain")],
        face_material=[0],
        groups=["cuts"],
        face_group=[0],
        face_id=[77],
    )
    body = painted(box(0, 2), "wood")
    for closed in (True, False):
        half = plumb.Solid.half_space((0, 0, 1, -1), closed, attributes=cuts)
        assert half.sources() == ["saw"]
        made = (body & half).to_mesh_with_attributes()
        is_cut = made.source == 1
        assert areas(made)[is_cut].sum() == 4
        assert (made.vertices[made.triangles[is_cut]][:, :, 2] == 1).all()
        assert (made.face_id[is_cut] == 77).all() and (made.source_face[is_cut] == 0).all()
        assert {made.materials[m].name for m in made.face_material[is_cut]} == {"end grain"}
        assert {made.groups[g] for g in made.face_group[is_cut]} == {"cuts"}
    assert plumb.Solid.half_space((0, 0, 1, -1)).sources() == []
    with pytest.raises(plumb.Error, match="one entry for each face"):
        plumb.Solid.half_space((0, 0, 1, 0), attributes=plumb.MeshAttributes(face_id=[1, 2]))
    with pytest.raises(plumb.Error, match="no channels"):
        plumb.Solid.half_space(
            (0, 0, 1, 0), attributes=plumb.MeshAttributes(channels={"texcoord_0": [[0.0, 0.0]]})
        )


def test_a_repaired_mesh_keeps_its_attributes():
    """Each face has the values of the face of the input with the same corners."""
    vertices, triangles = plumb.Solid.box((0, 0, 0), (1, 2, 3)).to_mesh()
    torn = np.delete(triangles, 4, axis=0)
    torn[2] = torn[2][::-1]
    twice = np.vstack([torn, torn[:1]])
    normals = np.cross(vertices[twice[:, 1]] - vertices[twice[:, 0]],
                       vertices[twice[:, 2]] - vertices[twice[:, 0]])
    mesh = plumb.Mesh.of_triangles(
        vertices,
        twice,
        plumb.MeshAttributes(
            name="box",
            materials=[plumb.Material("wood")],
            face_material=np.zeros(len(twice), dtype=int),
            groups=["even", "odd"],
            face_group=np.arange(len(twice)) % 2,
            face_id=np.arange(len(twice)) + 100,
            channels={"normal": np.repeat(normals, 3, axis=0), "color": np.full((36, 3), 0.5)},
            vertex_channels={"place": vertices},
        ),
    )
    mended, done = mesh.repaired(doubled="drop", fill_holes=3)
    assert mended.check().is_closed and len(done) == 3
    kept = mended.attributes
    assert kept.name == "box" and [m.name for m in kept.materials] == ["wood"]
    before = {frozenset(face): i for i, face in enumerate(twice[:-1])}
    sources = [before.get(frozenset(face), -1) for face in mended.triangles]
    assert sources == [*range(11), -1]
    assert (kept.face_id == np.array([*range(100, 111), -1])).all()
    assert (kept.face_group == np.array([i % 2 for i in range(11)] + [-1])).all()
    assert (kept.face_material == np.array([0] * 11 + [-1])).all()
    old = mended.corners[:33]
    assert (kept.channels["place"][:33] == vertices[old]).all()
    assert (kept.channels["place"][33:] == 0).all() and (kept.channels["color"][33:] == 1).all()
    p, q, r = (vertices[mended.triangles[:11, i]] for i in range(3))
    assert (kept.channels["normal"][:33] == np.repeat(np.cross(q - p, r - p), 3, axis=0)).all()
    plain, _ = plumb.Mesh.of_triangles(vertices, torn).repaired(fill_holes=3)
    assert plain.attributes.face_id is None and not plain.attributes.channels
    bad = plumb.Mesh.of_triangles(vertices, torn, plumb.MeshAttributes(face_id=[1, 2]))
    with pytest.raises(plumb.Error):
        bad.repaired(fill_holes=3)


def test_convex_parts_keep_attributes():
    """The facets of the parts cover each face of the mesh once; faces on cuts have no source."""
    bent = plumb.Solid.box((0, 0, 0), (3, 3, 1)) - plumb.Solid.box((1, 1, -1), (9, 9, 9))
    mesh = bent.to_mesh()
    parts = painted(mesh, "bent", 50).decompose(closed=True)
    covered, bare = np.zeros(len(mesh[1])), 0.0
    for part in parts:
        assert part.sources() == ["bent"]
        made = part.to_mesh_with_attributes()
        cut = made.source == -1
        assert (made.face_id[cut] == -1).all() and (made.face_material[cut] == -1).all()
        assert (made.face_id[~cut] == made.source_face[~cut] + 50).all()
        np.add.at(covered, made.source_face[~cut], areas(made)[~cut])
        bare += areas(made)[cut].sum()
    p, q, r = (mesh[0][mesh[1][:, i]] for i in range(3))
    assert covered == pytest.approx(np.abs(np.cross(q - p, r - p)).sum(axis=1) / 2)
    assert bare == 2 * (len(parts) - 1)
