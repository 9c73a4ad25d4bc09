"""Solids from and to trimesh, and Booleans with the signature of trimesh.boolean."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import trimesh as _trimesh

from plumb import Solid

__all__ = ["difference", "from_trimesh", "intersection", "register", "to_trimesh", "union"]


def from_trimesh(mesh: Any) -> Solid:
    """Return the solid that a closed trimesh.Trimesh bounds. Its float64 vertices are kept."""
    return Solid.from_mesh(mesh.vertices, mesh.faces)


def to_trimesh(solid: Solid) -> Any:
    """Return the boundary of a solid as a trimesh.Trimesh, without any processing."""
    vertices, triangles = solid.to_mesh()
    return _trimesh.Trimesh(vertices, triangles, process=False)


def union(meshes: Iterable[Any], **limits: Any) -> Any:
    """Return the union of meshes. Keywords are those of plumb's operations."""
    return to_trimesh(Solid.union_of([from_trimesh(m) for m in meshes], **limits))


def intersection(meshes: Iterable[Any], **limits: Any) -> Any:
    """Return the intersection of meshes. Keywords are those of plumb's operations."""
    return to_trimesh(Solid.intersection_of([from_trimesh(m) for m in meshes], **limits))


def difference(meshes: Sequence[Any], **limits: Any) -> Any:
    """Return the first mesh without the others. Keywords are those of plumb's operations."""
    first, *others = [from_trimesh(m) for m in meshes]
    return to_trimesh(first.difference(Solid.union_of(others, **limits), **limits))


def _boolean(meshes: Sequence[Any], operation: str, **_: Any) -> Any:
    return {"union": union, "intersection": intersection, "difference": difference}[operation](
        meshes
    )


def register(name: str = "plumb") -> None:
    """Make plumb an engine of trimesh.boolean: `trimesh.boolean.union(meshes, engine="plumb")`."""
    _trimesh.boolean._engines[name] = _boolean
