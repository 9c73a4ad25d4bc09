"""Unions of small integer boxes, and what brute force over unit cells says of them.

A box is given by its corners. The cell (i, j, k) is the open unit cube above this corner; it lies in
a box entirely or not at all, so that a set of cells decides every volume.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable

from hypothesis import strategies as st

import plumb

SIZE = 5

Box = tuple[tuple[int, ...], tuple[int, ...]]


def boxes(dimension: int) -> st.SearchStrategy[Box]:
    """Boxes with corners from 0 to SIZE and an interior."""
    side = st.tuples(st.integers(0, SIZE - 1), st.integers(1, SIZE)).filter(lambda s: s[0] < s[1])
    return st.tuples(*[side] * dimension).map(lambda sides: tuple(zip(*sides, strict=True)))


def lists_of_boxes(dimension: int) -> st.SearchStrategy[list[Box]]:
    return st.lists(boxes(dimension), min_size=1, max_size=3)


def cells(list_of_boxes: Iterable[Box]) -> frozenset[tuple[int, ...]]:
    """Return the unit cells in at least one of the boxes."""
    return frozenset(
        cell
        for low, high in list_of_boxes
        for cell in itertools.product(*map(range, low, high))
    )


def solid(list_of_boxes: Iterable[Box], closed: bool = True) -> plumb.Solid:
    return plumb.Solid.union_of([plumb.Solid.box(*box, closed=closed) for box in list_of_boxes])


def plane_set(list_of_boxes: Iterable[Box], closed: bool = True) -> plumb.PlaneSet:
    return plumb.PlaneSet.union_of(
        [plumb.PlaneSet.box(*box, closed=closed) for box in list_of_boxes]
    )
