#!/usr/bin/env python3
"""Two cubes, united through the C interface with ctypes: cubes.py LIBPLUMB_C. Nothing is installed, nothing compiled."""
import ctypes
import sys
from ctypes import byref, c_char_p, c_size_t, c_void_p

plumb = ctypes.CDLL(sys.argv[1])
for name in ("plumb_error_text", "plumb_numbers_exact", "plumb_version"):
    getattr(plumb, name).restype = c_char_p


def call(name, *arguments):
    """Calls a function whose last parameter is the error. Raises its text."""
    error = c_void_p()
    if getattr(plumb, name)(*arguments, byref(error)) != 0:
        text = plumb.plumb_error_text(error).decode()
        plumb.plumb_error_free(error)
        raise RuntimeError(text)


class Solid:
    """A handle that is released with its object."""

    def __init__(self, handle):
        self.handle = handle

    def __del__(self):
        plumb.plumb_solid_free(self.handle)

    @classmethod
    def from_triangles(cls, xyz, triangles):
        handle = c_void_p()
        points = (ctypes.c_double * len(xyz))(*xyz)
        corners = (ctypes.c_uint32 * len(triangles))(*triangles)
        call("plumb_solid_from_triangles", points, c_size_t(len(xyz) // 3), corners, c_size_t(len(triangles) // 3),
             None, byref(handle), None)
        return cls(handle)

    def __add__(self, other):
        handle = c_void_p()
        call("plumb_solid_union", self.handle, other.handle, byref(handle), None)
        return Solid(handle)

    def volume(self):
        numbers = c_void_p()
        call("plumb_solid_volume", self.handle, byref(numbers), None)
        text = plumb.plumb_numbers_exact(numbers, c_size_t(0)).decode()
        plumb.plumb_numbers_free(numbers)
        return text


def cube(low):
    xyz = [low + ((i >> axis) & 1) for i in range(8) for axis in range(3)]
    return Solid.from_triangles(xyz, [0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                      2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5])


print("plumb", plumb.plumb_version().decode(), "from Python: volume", (cube(0.0) + cube(0.25)).volume())
try:
    Solid.from_triangles([0.0, 0.0, float("nan")], [])
except RuntimeError as error:
    print("refused:", error)
