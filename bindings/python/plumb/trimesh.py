"""Solids from and to trimesh, and Booleans with the signature of trimesh.boolean.

Results keep the colours of faces and vertices, and texture coordinates with their materials. Each
face of a result gets the colours and texture coordinates of the face of an input that contains it.
If these differ between the faces at a vertex, the vertex occurs several times in the result, as in
every mesh of trimesh with seams. Then trimesh does not call the mesh watertight. `visual=False`
leaves colours and texture coordinates out. """

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
import trimesh as _trimesh

from plumb import Material, MeshAttributes, MeshWithAttributes, Solid

__all__ = ["difference", "from_trimesh", "intersection", "register", "to_trimesh", "union"]

_visual: Any = _trimesh.visual  # Without types.
_COLOR = "color"
_TEXTURE = "texcoord_0"


def from_trimesh(mesh: Any, visual: bool = True) -> Solid:
    """Return the solid that a closed trimesh.Trimesh bounds. Its float64 vertices are kept.

    If `visual` is true, the solid keeps its colours, or its texture coordinates and materials.
    """
    attributes = _attributes(mesh) if visual else None
    return Solid.from_mesh(mesh.vertices, mesh.faces, attributes=attributes)


def to_trimesh(solid: Solid, visual: bool = True, materials: Sequence[Any] | None = None) -> Any:
    """Return the boundary of a solid as a trimesh.Trimesh, without any processing.

    If `visual` is true, it has the colours or texture coordinates of the sources of the solid.
    `materials` contains a material of trimesh for each material of all sources, in their order. If
    it is omitted, materials are made from their names and colours.
    """
    if not visual or not solid.sources():
        return _trimesh.Trimesh(*solid.to_mesh(), process=False)
    made = solid.to_mesh_with_attributes()
    if _TEXTURE in made.channels:
        return _textured(made, materials)
    if _COLOR in made.channels:
        return _coloured(made)
    return _trimesh.Trimesh(made.vertices, made.triangles, process=False)


def union(meshes: Iterable[Any], visual: bool = True, **limits: Any) -> Any:
    """Return the union of meshes. Accepts the keywords of plumb's operations."""
    given = list(meshes)
    return _result(Solid.union_of(_solids(given, visual), **limits), given, visual)


def intersection(meshes: Iterable[Any], visual: bool = True, **limits: Any) -> Any:
    """Return the intersection of meshes. Accepts the keywords of plumb's operations."""
    given = list(meshes)
    return _result(Solid.intersection_of(_solids(given, visual), **limits), given, visual)


def difference(meshes: Sequence[Any], visual: bool = True, **limits: Any) -> Any:
    """Return the first mesh minus all others. Accepts the keywords of plumb's operations."""
    first, *others = _solids(meshes, visual)
    rest = first.difference(Solid.union_of(others, **limits), **limits)
    return _result(rest, meshes, visual)


def _boolean(meshes: Sequence[Any], operation: str, **_: Any) -> Any:
    # Users of trimesh.boolean expect watertight meshes, as its other engines give.
    functions = {"union": union, "intersection": intersection, "difference": difference}
    return functions[operation](meshes, visual=False)


def register(name: str = "plumb") -> None:
    """Make plumb an engine of trimesh.boolean: `trimesh.boolean.union(meshes, engine="plumb")`.

    The results have no colours and texture coordinates, like the results of the other engines.
    """
    _trimesh.boolean._engines[name] = _boolean


def _solids(meshes: Iterable[Any], visual: bool) -> list[Solid]:
    return [from_trimesh(mesh, visual) for mesh in meshes]


def _result(solid: Solid, meshes: Iterable[Any], visual: bool) -> Any:
    materials = [material for mesh in meshes for material in _materials(mesh)] if visual else None
    return to_trimesh(solid, visual, materials)


# --- from trimesh --------------------------------------------------------------------------------


def _is_textured(mesh: Any) -> bool:
    return getattr(mesh.visual, "uv", None) is not None


def _materials(mesh: Any) -> list[Any]:
    if not _is_textured(mesh):
        return []
    material = mesh.visual.material
    return list(getattr(material, "materials", None) or [material])


def _attributes(mesh: Any) -> MeshAttributes | None:
    name = str(mesh.metadata.get("name") or mesh.metadata.get("file_name") or "")
    if _is_textured(mesh):
        of_face = getattr(mesh.visual, "face_materials", None)
        if of_face is None:
            of_face = np.zeros(len(mesh.faces), dtype=np.int64)
        return MeshAttributes(
            name=name,
            materials=[_material(material) for material in _materials(mesh)],
            face_material=of_face,
            vertex_channels={_TEXTURE: mesh.visual.uv},
        )
    if not mesh.visual.defined:
        return None
    if mesh.visual.kind == "face":
        colours = np.repeat(mesh.visual.face_colors / 255.0, 3, axis=0)
        return MeshAttributes(name=name, channels={_COLOR: colours})
    return MeshAttributes(name=name, vertex_channels={_COLOR: mesh.visual.vertex_colors / 255.0})


def _material(material: Any) -> Material:
    red, green, blue, opacity = (float(part) / 255.0 for part in material.main_color)
    return Material(str(getattr(material, "name", None) or ""), (red, green, blue, opacity))


# --- to trimesh ----------------------------------------------------------------------------------


def _coloured(made: MeshWithAttributes) -> Any:
    channel = made.channels[_COLOR]
    colours = np.full((len(channel), 4), 255, dtype=np.uint8)
    colours[:, : channel.shape[1]] = np.rint(np.clip(channel, 0, 1) * 255)
    of_face = colours.reshape(-1, 3, 4)
    if (of_face == of_face[:, :1]).all():
        return _trimesh.Trimesh(
            made.vertices, made.triangles, face_colors=of_face[:, 0], process=False
        )
    corner, faces = _split(made, colours)
    return _trimesh.Trimesh(
        made.vertices[made.corners[corner]], faces, vertex_colors=colours[corner], process=False
    )


def _textured(made: MeshWithAttributes, materials: Sequence[Any] | None) -> Any:
    channel = made.channels[_TEXTURE]
    corner, faces = _split(made, channel)
    if materials is None:
        materials = [_material_of(material) for material in made.materials]
    visual = _texture_visual(channel[corner], made.face_material, list(materials))
    return _trimesh.Trimesh(
        made.vertices[made.corners[corner]], faces, visual=visual, process=False
    )


def _texture_visual(uv: Any, of_face: Any, materials: list[Any]) -> Any:
    if of_face is None or not materials:
        return _visual.TextureVisuals(uv=uv)
    # Faces of meshes without materials have one of their own.
    of_face = np.where(of_face < 0, len(materials), of_face)
    materials = [*materials, _visual.material.SimpleMaterial(name="none")]
    used, indices = np.unique(of_face, return_inverse=True)
    if len(used) == 1:
        return _visual.TextureVisuals(uv=uv, material=materials[used[0]])
    several = _visual.material.MultiMaterial([materials[i] for i in used])
    return _visual.TextureVisuals(uv=uv, material=several, face_materials=indices)


def _material_of(material: Material) -> Any:
    color = (0.4, 0.4, 0.4, 1.0) if material.color is None else material.color
    diffuse = np.rint(np.array(color) * 255).astype(np.uint8)
    return _visual.material.SimpleMaterial(diffuse=diffuse, name=material.name)


def _split(made: MeshWithAttributes, values: Any) -> tuple[Any, Any]:
    """Return a corner for each vertex with different values, and the faces over these vertices."""
    keys = np.column_stack([made.corners.astype(np.float64), values])
    _, corner, inverse = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    return corner, inverse.reshape(-1, 3)
