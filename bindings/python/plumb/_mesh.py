"""Meshes of polygons as arrays. They can be read, written, checked and repaired."""

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
    """A report on the defects of a mesh. Faces and vertices are indices of the mesh."""

    crossing_count: int
    """The number of pairs of faces that meet outside common corners and edges.

    It is 0 if the mesh is open.
    """
    crossings: list[tuple[int, int]]
    """The first of these pairs."""
    borders: list[list[int]]
    """Closed chains of vertices along which faces are missing or flipped."""
    holes: list[list[int]]
    """Chains along which faces are missing after the faces `flipped` were flipped."""
    degenerate: list[int]
    """Faces without area."""
    trimmed: list[int]
    """Faces with repeated corners or spikes."""
    not_planar: list[int]
    """Faces that are not planar."""
    not_simple: list[int]
    """Faces that are not simple polygons."""
    doubled: list[tuple[int, int]]
    """Pairs of faces with the same boundary."""
    flipped: list[int]
    """Faces that are not oriented like their neighbours."""
    one_sided: list[int]
    """For each component that has only one side, such as a Moebius strip, one of its faces."""
    inside_out: list[int]
    """For each component of negative volume, one of its faces."""

    @property
    def is_closed(self) -> bool:
        """Whether the mesh has no borders, so that it bounds a solid."""
        return not self.borders


@dataclasses.dataclass(frozen=True, eq=False)
class Mesh:
    """A mesh of polygons over shared vertices. It need not be closed.

    All methods accept the keywords of every operation: threads, timeout, memory_limit, progress.
    """

    vertices: npt.NDArray[np.float64]
    """The vertices (n, 3)."""
    face_begin: npt.NDArray[np.uint32]
    """The index in `corners` at which the corners of each face begin: (faces + 1,)."""
    corners: npt.NDArray[np.uint32]
    """The corners of all faces, indices of vertices: (k,)."""
    attributes: MeshAttributes = dataclasses.field(default_factory=MeshAttributes)
    """The attributes of faces and corners."""

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
        """Write a file with those attributes that its format can represent.

        `format` is off, off-exact, obj, stl, stl-binary, ply, ply-text, glb or 3mf; by default, the
        extension determines it. STL, GLB and 3MF need triangles. If writing fails, no incomplete
        file remains. A message to the logger "plumb" names attributes that are left out.
        """
        remark = _core.write_mesh_arrays(
            path, self.vertices, self.face_begin, self.corners, self.attributes, format
        )
        if remark:
            _LOGGER.info("%s: %s", path, remark)

    def check(self, max_listed: int = 1000, **limits: Any) -> MeshReport:
        """Return a report: whether the mesh is closed, and its defects."""
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
        """Return the repaired mesh, and sentences that describe the repairs.

        Faces keep their material, group, id and the numbers at their corners. Faces that were
        added in holes have none. Channels of vertices become channels of corners.

        weld: points whose distance is at most this value are merged. doubled: whether faces with
        the same corners as an earlier face are kept or dropped. reorient: whether faces that are
        not oriented like their neighbours are flipped. fill_holes: holes with at most this number
        of edges are filled. fill_holes_below: holes whose bounding box has a diagonal of at most
        this length are filled, too.
        """
        arrays, kept, done = _core.repair_mesh_arrays(
            self.vertices,
            self.face_begin,
            self.corners,
            self.attributes,
            weld,
            doubled,
            reorient,
            fill_holes,
            fill_holes_below,
            **limits,
        )
        return Mesh(*arrays, dataclasses.replace(kept, name=self.attributes.name)), done

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
