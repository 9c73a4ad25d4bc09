"""Unions of many sets on a cluster of dask.distributed."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeVar

from plumb import PlaneSet, Solid

__all__ = ["union_of"]

Set = TypeVar("Set", Solid, PlaneSet)


def _unite(sets: list[Set]) -> Set:
    return type(sets[0]).union_of(sets)


def union_of(client: Any, sets: Sequence[Set], width: int = 8) -> Any:
    """Return a future of the union of `sets`, reduced in a tree of `width` branches at each node.

    The union is associative and exact. So the result is the same as on one machine, byte for byte
    in canonical form (`to_bytes()`). Raise ValueError if there are no sets.
    """
    if not sets:
        raise ValueError("there is nothing to unite")
    if width < 2:
        raise ValueError("a node of the tree needs two branches")
    level = list(client.scatter(list(sets)))
    while True:
        level = [
            client.submit(_unite, level[i : i + width], pure=False)
            for i in range(0, len(level), width)
        ]
        if len(level) == 1:
            return level[0]
