"""Maps: checks, regions, half-edges and overlays."""

from __future__ import annotations

import json
from fractions import Fraction

import numpy as np
import pytest

import plumb

GRID = 3


def grid_map(shift: float = 0.0) -> plumb.Map:
    """A grid of GRID x GRID unit squares, and the boundary around it."""
    side = GRID + 1
    points = [(x + shift, y + shift) for y in range(side) for x in range(side)]
    cycles = [
        [y * side + x, y * side + x + 1, (y + 1) * side + x + 1, (y + 1) * side + x]
        for y in range(GRID)
        for x in range(GRID)
    ]
    around = [0, *range(1, side), *range(2 * side - 1, side * side, side)]
    around += [*range(side * side - 2, side * side - side - 1, -1)]
    around += [*range(side * side - 2 * side, 0, -side)]
    return plumb.Map.from_cycles(points, [*cycles, around[::-1]])


def test_valid_map():
    report = grid_map().check()
    assert report.is_valid and report.verdict == "valid" and report.defects == []
    assert len(report.regions) == GRID * GRID + 1
    assert report.regions[0].outer is None and report.regions[0].holes == [GRID * GRID]
    assert report.select(range(1, GRID * GRID + 1)) == plumb.PlaneSet.box((0, 0), (GRID, GRID))
    assert report.select([1]).area() == 1
    with pytest.raises(plumb.Error):
        report.select([99])


def test_half_edges_satisfy_eulers_formula_and_their_links():
    report = grid_map().check()
    dcel = report.dcel()
    origin, following, face = dcel["origin"], dcel["next"], dcel["face"]
    half_edges = np.arange(len(origin))
    assert (origin[following] == origin[half_edges ^ 1]).all()
    assert (face[following] == face).all()
    assert sorted(following) == half_edges.tolist()
    vertices, edges, faces = len(set(origin)), len(origin) // 2, len(set(face))
    assert vertices - edges + faces == 2
    begin, corners = report.map.cycles()
    assert (origin[dcel["halfedge_of_corner"]] == corners).all()


def test_defects_name_their_place():
    crossing = plumb.Map.from_cycles(
        [[0, 0], [3, 3], [3, 0], [0, 1]], [[0, 1, 2, 3], [3, 2, 1, 0]]
    ).check()
    assert not crossing.is_valid and crossing.counts["crossing"] == 1
    (defect,) = [d for d in crossing.defects if d.kind == "crossing"]
    assert defect.point == (Fraction(3, 4), Fraction(3, 4)) and defect.hint
    assert sorted(map(sorted, defect.edges)) == [[0, 1], [2, 3]]
    with pytest.raises(plumb.Error) as caught:
        crossing.dcel()
    assert caught.value.code == plumb.ErrorCode.BAD_ARGUMENT
    with pytest.raises(plumb.Error) as caught:
        plumb.Map.from_cycles([[0, 0]], [[0, 1, 2]]).check()
    assert caught.value.code == plumb.ErrorCode.BAD_INDEX


def test_outer_rules_and_merging():
    square = [[0, 0], [1, 0], [1, 1], [0, 1]]
    alone = plumb.Map.from_cycles(square, [[0, 1, 2, 3]])
    assert alone.check().verdict == "open"
    assert alone.check(outer="infer").is_valid and alone.check(outer="ignore").is_valid
    twice = plumb.Map.from_cycles(square + square, [[0, 1, 2, 3], [7, 6, 5, 4]])
    assert not twice.check().is_valid and twice.check(merge_vertices=True).is_valid
    with pytest.raises(plumb.Error, match="outer"):
        alone.check(outer="none")


def test_overlay_adds_up():
    first, second = grid_map().check(), grid_map(0.5).check()
    overlay = plumb.overlay(first, second)
    assert overlay.add_up()
    assert sum(overlay.first_areas) == sum(overlay.second_areas) == GRID * GRID
    quarter = [
        area
        for area, (a, b) in zip(overlay.areas, overlay.origins.tolist(), strict=True)
        if a and b
    ]
    assert quarter == [Fraction(1, 4)] * (2 * GRID - 1) ** 2
    common = first.select(range(1, 10)) & second.select(range(1, 10))
    assert common.area() == sum(quarter)


def test_files_and_texts(tmp_path):
    path = str(tmp_path / "a.map")
    grid_map().write(path)
    again = plumb.Map.read(path)
    assert (again.points() == grid_map().points()).all()
    assert again.vertex_count == (GRID + 1) ** 2 and again.cycle_count == GRID * GRID + 1
    begin, corners = again.cycles()
    copied = plumb.Map.from_arrays(again.points(), begin, corners)
    report = copied.check()
    assert json.loads(report.to_json())["verdict"] == "valid"
    assert report.to_text() and json.loads(report.to_geojson())["features"] == []
    assert report._repr_html_().startswith("<iframe")
    assert repr(report) == "<plumb.MapReport: valid, 24 edges, 10 regions>"
