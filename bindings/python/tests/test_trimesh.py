"""Colours and texture coordinates of trimesh stay with meshes through operations."""

from __future__ import annotations

import numpy as np
import pytest

import plumb

trimesh = pytest.importorskip("trimesh")
import plumb.trimesh as bridge  # noqa: E402

RED, BLUE = [255, 0, 0, 255], [0, 0, 255, 128]


def box(low: float, high: float):
    return trimesh.creation.box(bounds=[(low,) * 3, (high,) * 3])


def painted(low: float, high: float, colour: list[int]):
    mesh = box(low, high)
    mesh.visual.face_colors = colour
    return mesh


def textured(low: float, high: float, name: str):
    mesh = box(low, high)
    material = trimesh.visual.material.SimpleMaterial(diffuse=[10, 20, 30, 255], name=name)
    mesh.visual = trimesh.visual.TextureVisuals(uv=mesh.vertices[:, :2] / 4, material=material)
    return mesh


def test_colours_of_faces():
    mesh = bridge.difference([painted(0, 2, RED), painted(1, 3, BLUE)])
    assert mesh.is_watertight and mesh.volume == pytest.approx(7)
    assert mesh.visual.kind == "face"
    middles = mesh.triangles_center
    # The second box lends the three squares of the notch, in the planes x, y, z = 1.
    of_notch = ((middles == 1).any(axis=1)) & (middles >= 1).all(axis=1)
    assert of_notch.any() and not of_notch.all()
    assert (mesh.visual.face_colors[of_notch] == BLUE).all()
    assert (mesh.visual.face_colors[~of_notch] == RED).all()
    assert mesh.area_faces[of_notch].sum() == pytest.approx(3)


def test_a_mesh_without_colours_is_white():
    mesh = bridge.union([painted(0, 2, RED), box(1, 3)])
    colours = {tuple(colour) for colour in mesh.visual.face_colors.tolist()}
    assert colours == {tuple(RED), (255, 255, 255, 255)}
    plain = bridge.union([box(0, 2), box(1, 3)])
    assert not plain.visual.defined and plain.is_watertight


def test_colours_of_vertices_are_interpolated():
    first, second = box(0, 2), box(1, 3)
    for mesh, shift in ((first, 0), (second, 1)):
        colours = np.full((8, 4), 255, dtype=np.uint8)
        colours[:, :3] = (mesh.vertices - shift) * 100
        mesh.visual.vertex_colors = colours
    mesh = bridge.difference([first, second])
    assert mesh.visual.kind == "vertex" and mesh.volume == pytest.approx(7)
    colours = mesh.visual.vertex_colors[:, :3].astype(int)
    of_first = np.abs(colours - mesh.vertices * 100).max(axis=1) <= 0.5 + 1e-9
    of_second = np.abs(colours - (mesh.vertices - 1) * 100).max(axis=1) <= 0.5 + 1e-9
    assert (of_first | of_second).all() and of_first.any() and of_second.any()
    assert (of_first[mesh.faces].all(axis=1) | of_second[mesh.faces].all(axis=1)).all()
    merged = trimesh.Trimesh(mesh.vertices, mesh.faces, process=False)
    merged.merge_vertices()
    assert merged.is_watertight


def test_texture_coordinates_and_materials():
    first, second = textured(0, 2, "wood"), textured(1, 3, "steel")
    mesh = bridge.union([first, second])
    assert np.abs(mesh.visual.uv * 4 - mesh.vertices[:, :2]).max() < 1e-14
    assert mesh.volume == pytest.approx(15)
    assert mesh.visual.material.materials[0] is first.visual.material
    steel = mesh.visual.face_materials == 1
    assert (mesh.triangles[steel].max(axis=(1, 2)) > 1).all() and steel.any()
    assert (mesh.triangles[~steel].min(axis=(1, 2)) < 2).all() and (~steel).any()
    # One material stays as it is, and a solid without its mesh has the names and colours.
    alone = bridge.union([first])
    assert alone.visual.material is first.visual.material
    again = bridge.to_trimesh(bridge.from_trimesh(first))
    assert again.visual.material.name == "wood"
    assert list(again.visual.material.diffuse) == [10, 20, 30, 255]
    mixed = bridge.union([first, box(1, 3)])
    assert mixed.visual.material.materials[1].name == "none"


def test_visuals_can_be_left_out():
    meshes = [painted(0, 2, RED), textured(1, 3, "steel")]
    assert not bridge.intersection(meshes, visual=False).visual.defined
    assert bridge.from_trimesh(meshes[0], visual=False).sources() == []
    solid = bridge.from_trimesh(meshes[0])
    assert solid == plumb.Solid.box((0, 0, 0), (2, 2, 2)) and solid.sources() == [""]
    assert not bridge.to_trimesh(solid, visual=False).visual.defined
    bridge.register()
    united = trimesh.boolean.union(meshes, engine="plumb")
    assert united.is_watertight and not united.visual.defined
