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


def slit() -> plumb.Layer:
    """Two squares, and between them a slit that opens to the outside at both ends."""
    west = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]
    east = [(4.0625, 0.0), (8.0, 0.0), (8.0, 4.0), (4.0625, 4.0)]
    text = collection(west, east).replace('"id": 8', '"id": 2')
    return plumb.Layer.parse(text)


def test_the_options_of_a_repair() -> None:
    layer = slit()

    def owner(**options: Any) -> object:
        repaired, report = layer.repaired(gaps_below=0.25, **options)
        (region,) = report.regions
        assert region["kind"] == "gap" and region["open"]
        assert not repaired.check(gaps_below=0.25).has_defects
        return region["owner"]

    assert owner(rule="first") == 0 and owner(rule="lowest-id") == 1
    assert owner(rule="first", ranks=[1, 0]) == 1
    assert owner(preferences=[(1, 0)]) == 1 and owner(preferences=[("f1", "7")]) == 1
    assert owner(preferences=[(0, 1)]) == 0
    assert layer.find("f1") == layer.find("2") == 1
    assert layer.check(gaps_below=0.25).regions[0]["open"]
    assert layer.check(gaps_below=0.25, enclosed_only=True).regions == []
    same, report = layer.repaired(gaps_below=0.25, enclosed_only=True)
    assert report.regions == [] and same.to_geojson() == layer.to_geojson()
    with pytest.raises(plumb.Error, match="no feature has the id or the name"):
        layer.repaired(preferences=[("nobody", 0)])
    with pytest.raises(plumb.Error, match="ranks need the rule 'first'"):
        layer.repaired(rule="largest", ranks=[1, 0])
    wrong: list[dict[str, Any]] = [
        {"rule": "first", "ranks": [1]},
        {"preferences": [(0, 2)]},
    ]
    for options in wrong:
        with pytest.raises(plumb.Error):
            layer.repaired(**options)


def test_simplifications_say_what_has_moved() -> None:
    tooth = [(0.0, 0.0), (8.0, 0.0), (8.0, 8.0), (5.0, 8.0), (4.0, 8.5), (3.0, 8.0), (0.0, 8.0)]
    layer = plumb.Layer.parse(collection(tooth))
    simple, report = layer.simplified_with_report(tolerance=0.5)
    assert simple.to_geojson() == layer.simplified(tolerance=0.5).to_geojson()
    assert (report.corners_before, report.corners_after, report.fixed) == (7, 4, 0)
    assert 0.5 <= report.borders_moved < 1 and report.rounding_moved == 0
    kept, report = layer.simplified_with_report(within=0.25)
    assert report.borders_moved <= 0.25 and "8.5" in kept.to_geojson()
    assert "8.5" in layer.simplified(within=0.25).to_geojson()
    flat, told = plumb.PlaneSet.polygon(tooth).simplified_with_report(tolerance=0.5)
    assert flat == plumb.PlaneSet.box((0, 0), (8, 8))
    assert (told.corners_before, told.corners_after, told.overlaps) == (7, 4, 0)
    assert 0.5 <= told.borders_moved < 1
    overlapping = plumb.Layer.parse(OVERLAPPING)
    assert overlapping.simplified_with_report(tolerance=0)[1].overlaps == 1


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


def test_crossings_and_coordinate_reference_systems(tmp_path: Path) -> None:
    text = json.loads(collection([(0, 0), (2, 2), (2, 0), (0, 2)]))
    text["crs"] = {"type": "name", "properties": {"name": "EPSG:2056"}}
    layer = plumb.Layer.parse(json.dumps(text))
    (region,) = layer.check().regions
    assert region["kind"] == "crossing" and region["features"] == [0]
    assert region["at"] == (1, 1) and region["owner"] is None
    (nesting,) = plumb.Layer.parse(
        '{"type":"Polygon","coordinates":[[[0,0],[4,0],[4,4],[0,0]],[[6,1],[8,1],[8,2],[6,1]]]}'
    ).check().regions
    assert nesting["kind"] == "nesting" and nesting["at"] == (6, 1)
    repaired, report = layer.repaired()
    assert report.has_defects and not repaired.check().has_defects
    overlaid, _ = plumb.Layer.parse(OVERLAPPING).overlaid(repaired)
    for made in (layer, repaired, layer.simplified(kept=1), layer.dissolved([0]), overlaid):
        assert made.crs == "EPSG:2056"
        assert json.loads(made.to_geojson())["crs"] == text["crs"]
    layer.write(tmp_path / "layer.geojson")
    assert plumb.Layer.read(tmp_path / "layer.geojson").crs == "EPSG:2056"
    assert plumb.Layer.parse(OVERLAPPING).crs == ""
