"""The exceptions of plumb."""

from __future__ import annotations

import enum


class ErrorCode(enum.IntEnum):
    """The reason for an Error: 1xx input, 2xx resources and cancellation, 3xx geometry."""

    CANNOT_OPEN = 100
    CANNOT_WRITE = 101
    NOT_TEXT = 102
    SYNTAX = 103
    NUMBER_OUT_OF_RANGE = 104
    COUNT_MISMATCH = 105
    BAD_INDEX = 106
    DEGENERATE_FACE = 107
    UNKNOWN_FORMAT = 108
    USAGE = 109
    CLOSED_PIPE = 110
    BAD_SHAPE = 111
    RESOURCE_LIMIT = 200
    CANCELLED = 201
    NOT_FINITE = 300
    BAD_ARGUMENT = 301


class Error(Exception):
    """Bad input, an exceeded limit, or cancellation.

    `str()` returns "FILE:LINE:COLUMN: message", where unknown parts of the position are omitted.
    """

    code: ErrorCode
    """The reason."""
    message: str
    """The message without the position."""
    file: str
    """The file, or "" if the error is not about a file."""
    line: int
    """The line, counted from 1; 0 if unknown."""
    column: int
    """The column in bytes, counted from 1; 0 if unknown."""

    def __init__(
        self,
        code: int,
        message: str,
        file: str = "",
        line: int = 0,
        column: int = 0,
        text: str | None = None,
    ) -> None:
        super().__init__(code, message, file, line, column, text)
        self.code = ErrorCode(code)
        self.message = message
        self.file = file
        self.line = line
        self.column = column
        self._text = message if text is None else text

    def __str__(self) -> str:
        return self._text


class OpenMesh(Error):
    """A mesh that should bound a solid is not closed."""

    borders: list[list[int]] = []
    """Closed chains of vertices along which faces are missing or flipped."""
    holes: list[list[int]] = []
    """Chains along which faces are missing after the faces `flipped` were flipped."""
    flipped: list[int] = []
    """Faces that are not oriented like their neighbours."""
    one_sided: list[int] = []
    """For each connected set of faces that has only one side, the face with the least index."""


class BrokenInvariant(Exception):
    """A bug in plumb: one of its own invariants does not hold."""


class FileWarning(UserWarning):
    """A file and a set differ: one of them contains data that the other cannot represent."""
