"""Exact geometry: sets of plane, sphere and space, planar maps, convex parts and surfaces.

========================  =====================================  ============================
Python                    C++                                    what it is
========================  =====================================  ============================
Solid                     Nef3                                   a set of space
PlaneSet                  Nef2                                   a set of the plane
SphereSet                 NefSphere                              a set of directions
Map, MapReport            Map, MapReport (check_map)             a planar map and its check
overlay, MapOverlay       overlay_maps, MapOverlay               two maps on each other
Layer, LayerReport        Layer, LayerReport (repair_layer)      features, and their repair
Surface, SurfaceDivision  SurfaceMesh, SurfaceDivision           polygons on a surface
Mesh, MeshReport          PolygonMesh, MeshReport                polygons, and what is in them
MeshAttributes, Material  MeshAttributes, MeshMaterial           what belongs to faces
MeshWithAttributes        MeshWithAttributes                     a mesh and its attributes
read_csg, parse_csg       read_csg, evaluate                     models of OpenSCAD
Error, ErrorCode          Error, ErrorCode                       what goes wrong
========================  =====================================  ============================

Operators of sets: `a | b` and `a + b` unite, `a & b` and `a * b` intersect, `a - b`, `a ^ b`, `~a`.
"""

from plumb._attributes import Material, MeshAttributes, MeshWithAttributes
from plumb._core import (
    VERSION,
    Cell,
    Distance,
    Flaw,
    Geodesic,
    Layer,
    LayerReport,
    Map,
    MapDefect,
    MapOverlay,
    MapRegion,
    MapReport,
    PlaneSet,
    RayHit,
    SimplifyReport,
    Solid,
    SphereSet,
    Surface,
    SurfaceDivision,
    SurfaceRegion,
    keep_freed_memory,
    overlay,
    parse_csg,
    read_csg,
)
from plumb._errors import BrokenInvariant, Error, ErrorCode, FileWarning, OpenMesh
from plumb._mesh import Mesh, MeshReport

for _class in (
    BrokenInvariant,
    Error,
    ErrorCode,
    FileWarning,
    Material,
    Mesh,
    MeshAttributes,
    MeshReport,
    MeshWithAttributes,
    OpenMesh,
):
    _class.__module__ = "plumb"
del _class

__version__ = VERSION

__all__ = [
    "BrokenInvariant",
    "Cell",
    "Distance",
    "Error",
    "ErrorCode",
    "FileWarning",
    "Flaw",
    "Geodesic",
    "Layer",
    "LayerReport",
    "Map",
    "MapDefect",
    "MapOverlay",
    "MapRegion",
    "MapReport",
    "Material",
    "Mesh",
    "MeshAttributes",
    "MeshReport",
    "MeshWithAttributes",
    "OpenMesh",
    "PlaneSet",
    "RayHit",
    "SimplifyReport",
    "Solid",
    "SphereSet",
    "Surface",
    "SurfaceDivision",
    "SurfaceRegion",
    "__version__",
    "keep_freed_memory",
    "overlay",
    "parse_csg",
    "read_csg",
]
