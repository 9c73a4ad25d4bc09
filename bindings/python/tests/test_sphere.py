"""Sets of directions."""

from __future__ import annotations

import itertools
import pickle

import pytest
from hypothesis import given
from hypothesis import strategies as st

import plumb

make = plumb.SphereSet
vectors = st.tuples(*[st.integers(-3, 3)] * 3).filter(any)


@given(normals=st.lists(vectors, min_size=1, max_size=4), closed=st.booleans(), probe=vectors)
def test_convex_regions_contain_what_their_normals_say(normals, closed, probe):
    region = make.convex(normals, closed=closed)
    sides = [sum(x * y for x, y in zip(normal, probe, strict=True)) for normal in normals]
    assert region.contains(probe) == all(s >= 0 if closed else s > 0 for s in sides)
    assert region.contains([2 * x for x in probe]) == region.contains(probe)
    assert region.audit() is None
    assert ~~region == region and hash(~~region) == hash(region)
    assert ~region == make.union_of([~make.half_sphere(n, closed=closed) for n in normals])


def test_regions_arcs_and_points():
    octant = make.polygon([(1, 0, 0), (0, 1, 0), (0, 0, 1)])
    assert octant == make.convex([(1, 0, 0), (0, 1, 0), (0, 0, 1)])
    assert octant.counts() == {"points": 3, "arcs": 3, "faces": 2, "marked_faces": 1}
    arc = make.arc((1, 0, 0), (0, 1, 0))
    assert arc.is_subset_of(make.circle((0, 0, 1))) and arc.is_subset_of(octant.boundary())
    assert make.points([(1, 0, 0), (2, 0, 0)]) == make.point((1, 0, 0))
    octants = [
        make.convex([(x, 0, 0), (0, y, 0), (0, 0, z)])
        for x, y, z in itertools.product((1, -1), repeat=3)
    ]
    assert make.union_of(octants) == make.whole()
    hit = octant.shoot((-1, 1, 1), (1, 1, 1))
    assert hit.cell.kind == "arc" and hit.point[0] == 0 and hit.point[1] == hit.point[2]


def test_errors():
    with pytest.raises(plumb.Error) as caught:
        make.half_sphere((0, 0, 0))
    assert caught.value.code == plumb.ErrorCode.BAD_ARGUMENT
    with pytest.raises(TypeError):
        pickle.dumps(make.whole())
