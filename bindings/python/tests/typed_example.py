"""An example that mypy --strict accepts (run by test_types.py)."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import numpy.typing as npt

import plumb


def corner() -> plumb.Solid:
    """Return a cube without a smaller cube at one of its corners."""
    return plumb.Solid.box((0, 0, 0), (2, 2, 2)) - plumb.Solid.box((1, 1, 1), (2, 2, 2))


def volume(solid: plumb.Solid) -> Fraction:
    """Return the volume of a bounded solid."""
    found = solid.volume(threads=2, timeout=60.0)
    if found is None:
        raise ValueError("the solid is unbounded")
    return found


def boundary(solid: plumb.Solid) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.uint32]]:
    """Return the triangles around a solid."""
    vertices, triangles = solid.to_mesh()
    return vertices, triangles


def first_hit(solid: plumb.Solid) -> tuple[Fraction, ...]:
    """Return where a ray enters a solid."""
    hit = solid.shoot((-1, 0.5, Fraction(1, 3)), (1, 0, 0))
    return () if hit is None else hit.point


def defects(cycles: list[list[int]], points: npt.NDArray[np.float64]) -> list[str]:
    """Return what is wrong with a map."""
    report = plumb.Map.from_cycles(points, cycles).check(outer="infer")
    return [defect.hint for defect in report.defects]


def select(surface: plumb.Surface) -> float:
    """Return the area of a part of a surface."""
    division = surface.divide([[0, 1, (2, Fraction(1, 3), 0.25)]], outside=0)
    return division.select("A", rule="nonzero").area


def traced(solid: plumb.Solid) -> npt.NDArray[np.int64]:
    """Return the face of `solid` that each face of its lower half is a part of, or -1."""
    vertices, triangles = solid.to_mesh()
    attributes = plumb.MeshAttributes(name="solid", face_id=range(len(triangles)))
    whole = plumb.Solid.from_mesh(vertices, triangles, attributes=attributes)
    made = (whole & plumb.Solid.half_space((0, 0, 1, -1))).to_mesh_with_attributes()
    return made.source_face


if __name__ == "__main__":
    assert volume(corner()) == 7
    assert -1 in traced(corner())
    assert first_hit(corner()) == (Fraction(0), Fraction(1, 2), Fraction(1, 3))
