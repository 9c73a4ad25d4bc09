"""Attributes of meshes, and their conversion for the compiled module."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from plumb._errors import Error, ErrorCode

_NONE = 0xFFFFFFFF  # The value of -1 in the compiled module.


@dataclasses.dataclass(frozen=True)
class Material:
    """A material that faces of a mesh refer to."""

    name: str = ""
    """The name of the material."""
    color: tuple[float, float, float, float] | None = None
    """Red, green, blue and opacity, each from 0 to 1."""
    texture: str = ""
    """The name of the texture file."""


@dataclasses.dataclass(frozen=True, eq=False)
class MeshAttributes:
    """The attributes of the faces and corners of a mesh. All members can be left out.

    An array for faces has one integer for each face; -1 means that the face has no material, group
    or id. A channel assigns a few numbers to each corner of each face, or to each vertex. Files use
    the names "color" (3 or 4 numbers from 0 to 1), "normal" (3), "texcoord_0", "texcoord_1" and so
    on (2).
    """

    name: str = ""
    """The name of the mesh, which `Solid.sources()` lists."""
    materials: Sequence[Material] = ()
    """The materials that faces refer to."""
    face_material: npt.ArrayLike | None = None
    """The index of the material of each face, or -1."""
    groups: Sequence[str] = ()
    """The names of the groups that faces refer to."""
    face_group: npt.ArrayLike | None = None
    """The index of the group of each face, or -1."""
    face_id: npt.ArrayLike | None = None
    """An id for each face, from 0 to 2**32 - 2, or -1."""
    channels: Mapping[str, npt.ArrayLike] = dataclasses.field(default_factory=dict)
    """The numbers of each channel that assigns numbers to corners: float64 (corners, width), in the
    order of the corners of all faces. For triangles, (faces, 3, width) is accepted, too."""
    vertex_channels: Mapping[str, npt.ArrayLike] = dataclasses.field(default_factory=dict)
    """The numbers of each channel that assigns numbers to vertices: float64 (vertices, width)."""


@dataclasses.dataclass(frozen=True, eq=False)
class MeshWithAttributes:
    """The boundary of a solid, with the attributes of the meshes from which the solid was made.

    Faces are sorted by `source`. Faces without a source come last.
    """

    vertices: npt.NDArray[np.float64]
    """The vertices (n, 3)."""
    face_begin: npt.NDArray[np.uint32]
    """The index in `corners` at which the corners of each face begin: (faces + 1,)."""
    corners: npt.NDArray[np.uint32]
    """The corners of all faces, indices of vertices: (k,)."""
    source: npt.NDArray[np.int64]
    """For each face, the index in `Solid.sources()` of the mesh from which it was made, or -1."""
    source_face: npt.NDArray[np.int64]
    """For each face, the face of this mesh, or -1."""
    is_flipped: npt.NDArray[np.bool_]
    """For each face, whether it and its source face have opposite orientations."""
    materials: list[Material]
    """The materials of all sources."""
    face_material: npt.NDArray[np.int64] | None
    """For each face, the index of its material, or -1; None if no source has materials."""
    groups: list[str]
    """The groups of all sources."""
    face_group: npt.NDArray[np.int64] | None
    """For each face, the index of its group, or -1; None if no source has groups."""
    face_id: npt.NDArray[np.int64] | None
    """For each face, the id of its source face, or -1; None if no source has ids."""
    channels: dict[str, npt.NDArray[np.float64]]
    """The numbers (k, width) of each channel, by the names of channels."""

    def __repr__(self) -> str:
        return (
            f"<plumb.MeshWithAttributes: {len(self.vertices)} vertices, "
            f"{len(self.source)} faces, {len(self.materials)} materials, "
            f"channels {list(self.channels)}>"
        )

    @property
    def triangles(self) -> npt.NDArray[np.uint32]:
        """The corners as triangles (m, 3). Raise ValueError if a face has more corners."""
        if len(self.corners) != 3 * (len(self.face_begin) - 1):
            raise ValueError("the mesh has faces of more than three corners")
        return self.corners.reshape(-1, 3)

    @property
    def attributes(self) -> MeshAttributes:
        """The attributes of this mesh, for `Solid.from_mesh()` or `Solid.from_polygons()`."""
        return MeshAttributes(
            materials=self.materials,
            face_material=self.face_material,
            groups=self.groups,
            face_group=self.face_group,
            face_id=self.face_id,
            channels=self.channels,
        )


def prepared(attributes: Any) -> tuple[Any, ...]:
    """Return the attributes as arrays that the compiled module reads."""
    if not isinstance(attributes, MeshAttributes):
        raise TypeError(f"attributes must be plumb.MeshAttributes, not {type(attributes).__name__}")
    return (
        attributes.name,
        [_material(material) for material in attributes.materials],
        list(attributes.groups),
        _face_values("face_material", attributes.face_material),
        _face_values("face_group", attributes.face_group),
        _face_values("face_id", attributes.face_id),
        [_channel(name, array) for name, array in attributes.channels.items()],
        [_channel(name, array) for name, array in attributes.vertex_channels.items()],
    )


def made(
    arrays: tuple[Any, Any, Any, Any, Any, Any], parts: tuple[Any, Any, Any, Any]
) -> MeshWithAttributes:
    """Return the mesh of the arrays of the compiled module."""
    vertices, face_begin, corners, source, source_face, is_flipped = arrays
    return MeshWithAttributes(
        vertices=vertices,
        face_begin=face_begin,
        corners=corners,
        source=_signed(source),
        source_face=_signed(source_face),
        is_flipped=is_flipped,
        **_members(*parts),
    )


def attributes_made(*parts: Any) -> MeshAttributes:
    """Return the attributes of the arrays of the compiled module."""
    return MeshAttributes(**_members(*parts))


def _members(
    materials: list[tuple[str, tuple[float, float, float, float] | None, str]],
    groups: list[str],
    face_values: tuple[Any, Any, Any],
    channels: list[tuple[str, int, Any]],
) -> dict[str, Any]:
    face_material, face_group, face_id = (_signed(v) if len(v) else None for v in face_values)
    return {
        "materials": [Material(*material) for material in materials],
        "face_material": face_material,
        "groups": groups,
        "face_group": face_group,
        "face_id": face_id,
        "channels": {name: values.reshape(-1, width) for name, width, values in channels},
    }


def _material(material: Material) -> tuple[str, list[float] | None, str]:
    color = None if material.color is None else [float(part) for part in material.color]
    if color is not None and (len(color) != 4 or not all(0 <= part <= 1 for part in color)):
        raise ValueError("the color of a material has four numbers from 0 to 1")
    return material.name, color, material.texture


def _face_values(name: str, array: Any) -> npt.NDArray[np.uint32] | None:
    if array is None:
        return None
    given = np.asarray(array)
    if given.ndim != 1:
        raise ValueError(f"{name} must have one dimension, not the shape {given.shape}")
    if given.size == 0:
        return np.zeros(0, dtype=np.uint32)
    if given.dtype.kind not in "iu":
        raise TypeError(f"{name} must be integers, not {given.dtype}")
    low, high = int(given.min()), int(given.max())
    if low < -1 or high >= _NONE:
        value = low if low < -1 else high
        raise Error(ErrorCode.BAD_INDEX, f"{name} has {value}, which is neither -1 nor an index")
    return np.where(given == -1, _NONE, given).astype(np.uint32)


def _channel(name: str, array: Any) -> tuple[str, npt.NDArray[np.float64]]:
    given = np.asarray(array)
    if given.dtype.kind not in "fiu":
        raise TypeError(f"the channel '{name}' must have numbers, not {given.dtype}")
    if given.ndim not in (1, 2, 3) or given.size == 0 and given.ndim == 1:
        raise ValueError(f"the channel '{name}' cannot have the shape {given.shape}")
    rows = given.reshape(-1, 1 if given.ndim == 1 else given.shape[-1])
    numbers = np.ascontiguousarray(rows, dtype=np.float64)
    if not np.isfinite(numbers).all():
        raise Error(ErrorCode.NOT_FINITE, f"the channel '{name}' has a number that is not finite")
    return name, numbers


def _signed(values: npt.NDArray[np.uint32]) -> npt.NDArray[np.int64]:
    result = values.astype(np.int64)
    result[result == _NONE] = -1
    return result
