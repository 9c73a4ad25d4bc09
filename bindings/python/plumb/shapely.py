"""Sets of the plane from and to shapely's geometries and GeoDataFrames."""

from __future__ import annotations

import json
import warnings
from collections.abc import Iterable
from typing import Any

import shapely as _shapely

from plumb import FileWarning, Layer, LayerReport, PlaneSet

__all__ = [
    "from_geoseries",
    "from_shapely",
    "overlay",
    "repair_coverage",
    "to_geoseries",
    "to_shapely",
]


def from_shapely(geometry: Any) -> PlaneSet:
    """Return the exact closed set of a geometry. Polygons enclose points by the even-odd rule."""
    return PlaneSet.from_bytes(_shapely.to_wkb(_shapely.force_2d(geometry), flavor="iso"))


def to_shapely(set: PlaneSet) -> Any:
    """Return the bounded parts of the closure of a set as a valid geometry.

    Coordinates are rounded. A FileWarning reports unbounded parts, which are left out.
    Losses by rounding are not reported.
    """
    if not set.is_bounded():
        warnings.warn("unbounded parts of the set are left out", FileWarning, stacklevel=2)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", FileWarning)
        text = set.to_wkt()
    geometry = _shapely.from_wkt(text)
    if geometry.geom_type == "GeometryCollection" and len(geometry.geoms) == 1:
        return geometry.geoms[0]
    return geometry


def from_geoseries(geometries: Iterable[Any]) -> list[PlaneSet]:
    """Return the set of each geometry of a GeoSeries or of any other iterable."""
    return [from_shapely(geometry) for geometry in geometries]


def to_geoseries(sets: Iterable[PlaneSet], **options: Any) -> Any:
    """Return a geopandas.GeoSeries. Options such as `index` and `crs` are passed to it."""
    import geopandas

    return geopandas.GeoSeries([to_shapely(set) for set in sets], **options)


def overlay(first: Any, second: Any) -> Any:
    """Return the intersections of the rows of two GeoDataFrames, with the attributes of both.

    Attributes of the second frame whose names occur in both get the suffix "_2". Pairs of rows
    whose intersection has no interior are left out.
    """
    import geopandas
    import pandas

    lefts = from_geoseries(first.geometry)
    rights = from_geoseries(second.geometry)
    tree = _shapely.STRtree(second.geometry.values)
    pairs = tree.query(first.geometry.values)
    found, cells = [], []
    for i, j in sorted(zip(*pairs.tolist(), strict=True)):
        cell = (lefts[i] & rights[j]).regularization()
        if cell:
            found.append((i, j))
            cells.append(cell)
    left = first.drop(columns=first.geometry.name).iloc[[i for i, _ in found]]
    right = second.drop(columns=second.geometry.name).iloc[[j for _, j in found]]
    right = right.rename(columns={name: f"{name}_2" for name in right if name in left.columns})
    table = pandas.concat([left.reset_index(drop=True), right.reset_index(drop=True)], axis=1)
    return geopandas.GeoDataFrame(table, geometry=to_geoseries(cells), crs=first.crs)


def repair_coverage(frame: Any, **options: Any) -> tuple[Any, LayerReport]:
    """Return a GeoDataFrame without overlaps and gaps, and a report on the changes.

    Accepts the options of Layer.repaired(). Rows keep their order and their attributes. If
    other rows get the whole area of a row, the geometry of this row is None.
    """
    features = [
        {"type": "Feature", "geometry": _shapely.geometry.mapping(geometry)}
        for geometry in frame.geometry
    ]
    text = json.dumps({"type": "FeatureCollection", "features": features})
    layer, report = Layer.parse(text).repaired(**options)
    shapes = [
        feature["geometry"] and _shapely.geometry.shape(feature["geometry"])
        for feature in json.loads(layer.to_geojson())["features"]
    ]
    return frame.set_geometry(shapes, crs=frame.crs), report
