"""Meshes of polygons as arrays: from files and to files, checked and mended."""

from __future__ import annotations

import dataclasses
import logging
import os
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from plumb import _arrays, _core
from plumb._attributes import MeshAttributes

_LOGGER = logging.getLogger("plumb")


@dataclasses.dataclass(frozen=True)
class MeshReport:
    """What is in a mesh. Faces and vertices are indices of the mesh."""

    crossing_count: int
    """How many pairs of faces meet outside common corners and edges; 0 if the mesh is open."""
    crossings: list[tuple[int, int]]
    """The first of these pairs."""
    borders: list[list[int]]
    """Closed chains of vertices along which faces are missing or flipped."""
    holes: list[list[int]]
    """Chains along which faces are missing after `flipped` have been turned."""
    degenerate: list[int]
    """Faces without area."""
    trimmed: list[int]
    """Faces with repeated corners or spikes."""
    not_planar: list[int]
    """Faces that are not planar."""
    not_simple: list[int]
    """Faces that are no simple polygons."""
    doubled: list[tuple[int, int]]
    """Pairs of a face and an earlier one with the same boundary."""
    flipped: list[int]
    """Faces that disagree with their neighbours."""
    one_sided: list[int]
    """A face of each component that has one side only."""
    inside_out: list[int]
    """A face of each component of negative volume."""

    @property
    def is_closed(self) -> bool:
        """Whether the mesh has no borders, so that it bounds a solid."""
        return not self.borders


@dataclasses.dataclass(frozen=True, eq=False)
class Mesh:
    """A mesh of polygons over shared vertices. It need not be closed.

    Keywords of its methods are those of every operation: threads, timeout, memory_limit, progress.
    """

    vertices: npt.NDArray[np.float64]
    """The vertices (n, 3)."""
    face_begin: npt.NDArray[np.uint32]
    """Where the corners of each face begin in `corners`: (faces + 1,)."""
    corners: npt.NDArray[np.uint32]
    """The corners of all faces, indices of vertices: (k,)."""
    attributes: MeshAttributes = dataclasses.field(default_factory=MeshAttributes)
    """What belongs to faces and corners."""

    @staticmethod
    def of_triangles(
        vertices: npt.ArrayLike,
        triangles: npt.ArrayLike,
        attributes: MeshAttributes | None = None,
    ) -> Mesh:
        """Return the mesh of triangles (m, 3)."""
        corners = _arrays.indices(triangles, 3).ravel()
        return Mesh(
            _arrays.coordinates(vertices, 3),
            np.arange(0, len(corners) + 1, 3, dtype=np.uint32),
            corners,
            attributes or MeshAttributes(),
        )

    @staticmethod
    def read(
        path: str | os.PathLike[str],
        exact_decimals: bool = False,
        attributes: bool = True,
        **limits: Any,
    ) -> Mesh:
        """Read OFF, OBJ, STL, PLY, glTF or 3MF as the file lists it, with its attributes."""
        arrays, read = _core.read_mesh_arrays(path, exact_decimals, attributes, **limits)
        return Mesh(*arrays, dataclasses.replace(read, name=os.fspath(path)))

    def write(self, path: str | os.PathLike[str], format: str | None = None) -> None:
        """Write a file with those attributes that its format holds.

        The extension or `format` chooses: off, off-exact, obj, stl, stl-binary, ply, ply-text, glb
        or 3mf. STL, GLB and 3MF need triangles. The file is complete or absent. Attributes that it
        does not hold are named in a remark to the logger "plumb".
        """
        remark = _core.write_mesh_arrays(
            path, self.vertices, self.face_begin, self.corners, self.attributes, format
        )
        if remark:
            _LOGGER.info("%s: %s", path, remark)

    def check(self, max_listed: int = 1000, **limits: Any) -> MeshReport:
        """Return what is in the mesh: is it closed, and what is wrong with it?"""
        count, lists, doubled, crossings, borders, holes = _core.check_mesh_arrays(
            self.vertices, self.face_begin, self.corners, max_listed, **limits
        )
        names = "degenerate trimmed not_planar not_simple flipped one_sided inside_out".split()
        faces = {name: values.tolist() for name, values in zip(names, lists, strict=True)}
        return MeshReport(count, crossings, borders, holes, doubled=doubled, **faces)

    def repaired(
        self,
        weld: float = 0.0,
        doubled: Literal["keep", "drop-if-better", "drop"] = "keep",
        reorient: bool = False,
        fill_holes: int = 0,
        fill_holes_below: float = 0.0,
        **limits: Any,
    ) -> tuple[Mesh, list[str]]:
        """Return the mended mesh without attributes, and sentences on what was done.

        weld: points at most this far apart become one. doubled: what happens to faces that have
        the corners of an earlier face. reorient: faces that disagree are turned. fill_holes: holes
        of at most so many edges are filled, and with fill_holes_below those of at most this
        diameter.
        """
        arrays, done = _core.repair_mesh_arrays(
            self.vertices,
            self.face_begin,
            self.corners,
            weld,
            doubled,
            reorient,
            fill_holes,
            fill_holes_below,
            **limits,
        )
        return Mesh(*arrays), done

    def solid(
        self, rule: str | None = None, surface: bool = False, **limits: Any
    ) -> _core.Solid:
        """Return the solid that the mesh bounds, with its attributes; see Solid.from_mesh()."""
        return _core.Solid.from_polygons(
            self.vertices,
            self.face_begin,
            self.corners,
            rule,
            surface,
            self.attributes,
            **limits,
        )

    @property
    def face_count(self) -> int:
        """The number of faces."""
        return len(self.face_begin) - 1

    @property
    def triangles(self) -> npt.NDArray[np.uint32]:
        """The corners as triangles (m, 3). Raise ValueError if a face has other corners."""
        if not (np.diff(self.face_begin.astype(np.int64)) == 3).all():
            raise ValueError("the mesh has faces that are no triangles")
        return self.corners.reshape(-1, 3)

    def __repr__(self) -> str:
        return f"<plumb.Mesh: {len(self.vertices)} vertices, {self.face_count} faces>"
