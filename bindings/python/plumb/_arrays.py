"""Converts arrays that the compiled module cannot read in place."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from plumb._errors import Error, ErrorCode


def coordinates(array: Any, columns: int) -> npt.NDArray[np.float64]:
    """Return the same numbers as float64 with `columns` columns; raise if one would change."""
    given = _shaped(np.asarray(array), columns)
    if given.dtype.kind not in "fiu":
        raise TypeError(f"coordinates must be numbers, not {given.dtype}")
    result = np.ascontiguousarray(given, dtype=np.float64)
    if given.dtype != np.float64 and not _is_same(result, given):
        raise Error(
            ErrorCode.NUMBER_OUT_OF_RANGE,
            f"a coordinate of the array of {given.dtype} is not a double",
        )
    return result


def indices(array: Any, columns: int) -> npt.NDArray[np.uint32]:
    """Return the same indices as uint32 with `columns` columns; raise if one would change."""
    given = _shaped(np.asarray(array), columns)
    if given.size == 0:
        return np.ascontiguousarray(given, dtype=np.uint32)
    if given.dtype.kind not in "iu":
        raise TypeError(f"indices must be integers, not {given.dtype}")
    low, high = int(given.min()), int(given.max())
    if low < 0 or high > 0xFFFFFFFF:
        raise Error(ErrorCode.BAD_INDEX, f"{low if low < 0 else high} is not an index")
    return np.ascontiguousarray(given, dtype=np.uint32)


def _shaped(array: npt.NDArray[Any], columns: int) -> npt.NDArray[Any]:
    if columns == 1:
        if array.ndim == 1:
            return array
        raise ValueError(f"an array of one dimension is needed, not of shape {array.shape}")
    if array.size == 0 and array.ndim <= 2:
        return array.reshape(0, columns)
    if array.ndim == 2 and array.shape[1] == columns:
        return array
    raise ValueError(f"an array of shape (n, {columns}) is needed, not {array.shape}")


def _is_same(doubles: npt.NDArray[np.float64], given: npt.NDArray[Any]) -> bool:
    # Integers are compared as integers: NumPy would round both sides to doubles.
    if given.dtype.kind == "f":
        return bool(((doubles == given) | (given != given)).all())
    if given.dtype.itemsize < 8:
        return True
    flat = given.ravel()
    large = np.flatnonzero(np.abs(doubles.ravel()) >= 2.0**53)
    return all(int(doubles.ravel()[i]) == int(flat[i]) for i in large)
