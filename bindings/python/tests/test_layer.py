"""Layers of features: reading, repair, ids and properties."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

import plumb


def collection(*rings: list[tuple[float, float]]) -> str:
    features: list[dict[str, Any]] = []
    for i, ring in enumerate(rings):
        polygon = {"type": "Polygon", "coordinates": [[*ring, ring[0]]]}
        features.append(
            {"type": "Feature", "id": i + 7, "properties": {"name": f"f{i}"}, "geometry": polygon}
        )
    return json.dumps({"type": "FeatureCollection", "features": features})


OVERLAPPING = collection(
    [(0, 0), (4, 0), (4, 4), (0, 4)],
    [(3, 0), (8, 0), (8, 4), (3, 4)],
)


def test_an_overlap_goes_to_one_feature(tmp_path: Path) -> None:
    layer = plumb.Layer.parse(OVERLAPPING)
    assert len(layer) == 2
    repaired, report = layer.repaired(rule="first")
    assert report.has_defects and report.emptied == []
    (region,) = report.regions
    assert region["kind"] == "overlap" and region["features"] == [0, 1] and region["owner"] == 0
    assert region["area"] == Fraction(4)
    assert repaired.ids() == [7, 8]
    assert repaired.properties() == [{"name": "f0"}, {"name": "f1"}]
    path = tmp_path / "layer.geojson"
    repaired.write(path)
    assert path.read_text() == repaired.to_geojson()
    again, second = plumb.Layer.read(path).repaired()
    assert not second.has_defects and again.to_geojson() == repaired.to_geojson()


def test_rules_and_gaps() -> None:
    layer = plumb.Layer.parse(OVERLAPPING)
    for rule, owner in [("largest", 1), ("smallest", 0)]:
        assert layer.repaired(rule=rule)[1].regions[0]["owner"] == owner
    with pytest.raises(plumb.Error, match="rule must be"):
        layer.repaired(rule="newest")
    frame = collection(
        [(0, 0), (9, 0), (9, 1), (0, 1)],
        [(0, 1), (1, 1), (1, 8), (9, 8), (9, 9), (0, 9)],
        [(8, 1), (9, 1), (9, 8), (8, 8)],
    )
    wide = plumb.Layer.parse(frame)
    assert [r["kind"] for r in wide.repaired()[1].regions] == ["hole"]
    assert [r["kind"] for r in wide.repaired(gaps_below=100)[1].regions] == ["gap"]


def test_dissolving_overlaying_and_simplifying(tmp_path: Path) -> None:
    layer = plumb.Layer.parse(
        collection([(0, 0), (4, 0), (4, 4), (0, 4)], [(4, 0), (8, 0), (8, 4), (4, 4)])
    )
    assert layer.check().regions == []
    one = layer.dissolved([0, 0])
    assert len(one) == 1 and plumb.Layer.parse(one.to_geojson()).check().regions == []
    strip = plumb.Layer.parse(collection([(2, 1), (6, 1), (6, 2), (2, 2)]))
    both, pairs = layer.overlaid(strip, pairs="both")
    assert pairs == [(0, 0), (1, 0)] and len(both) == 2
    assert layer.overlaid(strip)[1] == [(0, 0), (0, None), (1, 0), (1, None)]
    bumpy = plumb.Layer.parse(collection([(0, 0), (2, 0.01), (4, 0), (4, 4), (0, 4)]))
    assert bumpy.simplified(tolerance=0.1).to_geojson().count("0.01") == 0
    for name in ("a.topojson", "a.wkt", "a.geojson"):
        layer.write(tmp_path / name)
        assert len(plumb.Layer.read(tmp_path / name)) == 2
    with pytest.raises(plumb.Error, match="names no format"):
        layer.write(tmp_path / "a.shp")


def test_errors_have_places() -> None:
    with pytest.raises(plumb.Error) as caught:
        plumb.Layer.parse('{"type": "FeatureCollection",\n "features": [}')
    assert caught.value.line == 2


def test_voronoi_cells_and_faces() -> None:
    sites = [(0.0, 0.0), (4.0, 0.0), (0.0, 4.0), (4.0, 4.0)]
    cells = plumb.Layer.voronoi(sites, (-1, -1), (5, 5))
    features = json.loads(cells.to_geojson())["features"]
    assert len(features) == 4
    assert [-1, -1] in features[0]["geometry"]["coordinates"][0]
    box = plumb.PlaneSet.box((0, 0), (4, 4)).boundary()
    lines = box | plumb.PlaneSet.polyline([(0, 0), (4, 4)])
    assert len(plumb.Layer.of_faces(~lines)) == 2


def test_parts_of_sets_keep_their_features():
    def square(x, name):
        ring = [[x, 0], [x + 4, 0], [x + 4, 4], [x, 4], [x, 0]]
        geometry = {"type": "Polygon", "coordinates": [ring]}
        return {"type": "Feature", "id": name, "properties": {"x": x}, "geometry": geometry}

    def layer(*features):
        text = json.dumps({"type": "FeatureCollection", "features": features})
        return plumb.Layer.parse(text)

    both = layer(square(0, "a")).joined(layer(square(4, "b")))
    parts = both.parts(plumb.PlaneSet.box((2, 2), (6, 6)))
    found = json.loads(parts.to_geojson())["features"]
    assert [f.get("id") for f in found] == ["a", "b", None]
    assert [f["properties"] for f in found] == [{"x": 0}, {"x": 4}, None]
    assert found[0]["geometry"]["coordinates"] == [[[2, 2], [4, 2], [4, 4], [2, 4], [2, 2]]]
