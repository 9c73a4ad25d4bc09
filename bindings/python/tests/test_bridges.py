"""Bridges to trimesh, shapely, GeoPandas and Dask, each skipped where it is not installed.

Shapely and manifold3d are oracles, too: on small integers their coordinates are exact.
"""

from __future__ import annotations

import numpy as np
import pytest
from boxes import lists_of_boxes, plane_set, solid
from hypothesis import given, settings

import plumb


def test_trimesh():
    trimesh = pytest.importorskip("trimesh")
    import plumb.trimesh

    a = trimesh.creation.box(bounds=[(0, 0, 0), (2, 2, 2)])
    b = trimesh.creation.box(bounds=[(1, 1, 1), (3, 3, 3)])
    assert plumb.trimesh.from_trimesh(a) == plumb.Solid.box((0, 0, 0), (2, 2, 2))
    assert plumb.trimesh.union([a, b]).volume == pytest.approx(15)
    assert plumb.trimesh.intersection([a, b], threads=2).volume == pytest.approx(1)
    difference = plumb.trimesh.difference([a, b, b])
    assert difference.is_watertight and difference.volume == pytest.approx(7)
    plumb.trimesh.register()
    for name, volume in (("union", 15), ("intersection", 1), ("difference", 7)):
        result = getattr(trimesh.boolean, name)([a, b], engine="plumb")
        assert result.volume == pytest.approx(volume)


@settings(max_examples=20)
@given(a=lists_of_boxes(2), b=lists_of_boxes(2))
def test_shapely_agrees_on_integers(a, b):
    shapely = pytest.importorskip("shapely")
    import plumb.shapely

    p, q = plane_set(a), plane_set(b)
    s, t = plumb.shapely.to_shapely(p), plumb.shapely.to_shapely(q)
    assert s.is_valid and plumb.shapely.from_shapely(s) == p
    assert shapely.area(s | t) == (p | q).area()
    assert shapely.equals(plumb.shapely.to_shapely((p & q).regularization()),
                          plumb.shapely.to_shapely(plumb.shapely.from_shapely(s & t)
                                                   .regularization()))
    assert shapely.area(s - t) == (p - q).area()


def test_shapely_kinds():
    shapely = pytest.importorskip("shapely")
    import plumb.shapely

    for text in (
        "POINT (1 2)",
        "MULTIPOINT (1 2, 3 4)",
        "LINESTRING (0 0, 1 1, 2 0)",
        "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 2, 2 1, 1 1))",
        "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 0)), ((5 5, 6 5, 6 6, 5 5)))",
        "GEOMETRYCOLLECTION (POINT (9 9), POLYGON ((0 0, 1 0, 1 1, 0 0)))",
        "POLYGON EMPTY",
    ):
        geometry = shapely.from_wkt(text)
        back = plumb.shapely.to_shapely(plumb.shapely.from_shapely(geometry))
        assert shapely.equals(back, geometry), text
    with pytest.warns(plumb.FileWarning, match="unbounded"):
        plumb.shapely.to_shapely(plumb.PlaneSet.half_plane((1, 0, 0)))


def test_geopandas_keeps_attributes():
    geopandas = pytest.importorskip("geopandas")
    shapely = pytest.importorskip("shapely")
    import plumb.shapely

    def frame(shift: float, name: str) -> object:
        cells = [shapely.box(x + shift, 0, x + shift + 2, 2) for x in (0, 2)]
        return geopandas.GeoDataFrame({name: ["a", "b"], "id": [1, 2]}, geometry=cells, crs=3857)

    result = plumb.shapely.overlay(frame(0, "left"), frame(1, "right"))
    assert result.crs == 3857
    rows = sorted(zip(result.left, result.id, result.right, result.id_2, result.area, strict=True))
    assert rows == [("a", 1, "a", 1, 2.0), ("b", 2, "a", 1, 2.0), ("b", 2, "b", 2, 2.0)]


def test_geopandas_repairs_a_coverage():
    geopandas = pytest.importorskip("geopandas")
    shapely = pytest.importorskip("shapely")
    import plumb.shapely

    cells = [shapely.box(0, 0, 4, 4), shapely.box(3, 0, 8, 4)]
    frame = geopandas.GeoDataFrame({"name": ["a", "b"]}, geometry=cells, index=[5, 3], crs=3857)
    repaired, report = plumb.shapely.repair_coverage(frame, rule="first")
    assert [region["kind"] for region in report.regions] == ["overlap"]
    assert list(repaired.index) == [5, 3] and list(repaired.name) == ["a", "b"]
    assert repaired.crs == 3857 and list(repaired.area) == [16.0, 16.0]
    assert shapely.coverage_is_valid(repaired.geometry.values)


@given(a=lists_of_boxes(3), b=lists_of_boxes(3))
@settings(max_examples=20)
def test_manifold_agrees_on_integers(a, b):
    manifold3d = pytest.importorskip("manifold3d")

    def manifold(set_of_space: plumb.Solid) -> object:
        vertices, triangles = set_of_space.to_mesh()
        mesh = manifold3d.Mesh(vertices.astype(np.float32), triangles)
        return manifold3d.Manifold(mesh)

    p, q = solid(a), solid(b)
    m, n = manifold(p), manifold(q)
    if m.status() != manifold3d.Error.NoError or n.status() != manifold3d.Error.NoError:
        return  # Manifold takes no solids that touch themselves.
    assert (m + n).volume() == pytest.approx(float((p | q).volume()), abs=1e-4)
    assert (m ^ n).volume() == pytest.approx(float((p & q).volume()), abs=1e-4)
    assert (m - n).volume() == pytest.approx(float((p - q).volume()), abs=1e-4)


def test_dask_gives_the_bytes_of_one_machine():
    distributed = pytest.importorskip("distributed")
    import plumb.dask

    sets = [plumb.Solid.box((i, i % 3, 0), (i + 2, i % 3 + 2, 1)) for i in range(20)]
    expected = plumb.Solid.union_of(sets).to_bytes()
    with (
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=None, processes=True
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        future = plumb.dask.union_of(client, sets, width=3)
        assert future.result(timeout=60).to_bytes() == expected
        squares = [plumb.PlaneSet.box((i, 0), (i + 2, i)) for i in range(1, 9)]
        united = plumb.dask.union_of(client, squares).result(timeout=60)
        assert united.to_bytes() == plumb.PlaneSet.union_of(squares).to_bytes()
    with pytest.raises(ValueError, match="nothing"):
        plumb.dask.union_of(None, [])
