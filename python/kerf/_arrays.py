"""Arrays of callers as those that the library takes."""

from __future__ import annotations

from typing import Any, NoReturn, Optional, Tuple

import numpy as np
import numpy.typing as npt

from . import _core

Floats = npt.NDArray[np.float32]
Doubles = npt.NDArray[np.float64]
Indices = npt.NDArray[np.uint32]


def refuse(name: str, expected: str, got: npt.NDArray[Any]) -> NoReturn:
    shape = " x ".join(str(length) for length in got.shape) or "one number"
    raise ValueError(f"{name}: {expected} expected, got {shape} of {got.dtype}")


def numbers(name: str, values: npt.ArrayLike, expected: str) -> npt.NDArray[Any]:
    """An array of real numbers."""
    if isinstance(values, np.ma.MaskedArray) and bool(np.any(values.mask)):
        raise ValueError(f"{name}: {expected} expected, got a masked array: fill it first")
    try:
        array = np.asarray(values)
    except ValueError as fault:
        raise ValueError(f"{name}: {expected} expected: {fault}") from None
    if array.dtype.kind not in "fiu":
        # An empty list has no type of its own.
        if array.size == 0:
            return array.astype(np.float64)
        refuse(name, expected, array)
    return array


def point(name: str, value: npt.ArrayLike) -> Tuple[float, float, float]:
    """Three finite numbers."""
    array = numbers(name, value, "three numbers")
    if array.shape != (3,):
        refuse(name, "three numbers", array)
    x, y, z = (float(number) for number in array)
    if not (np.isfinite(x) and np.isfinite(y) and np.isfinite(z)):
        raise ValueError(f"{name}: three finite numbers expected, got {x}, {y}, {z}")
    return x, y, z


def real(name: str, value: Any) -> float:
    """One number."""
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, float, np.integer, np.floating)):
        raise ValueError(f"{name}: a number expected, got {value!r}")
    try:
        return float(value)
    except OverflowError:
        raise ValueError(f"{name}: a number expected, got one that is too large") from None


def count(name: str, value: Any, most: int = 2**32 - 1) -> int:
    """A whole number from 0 on."""
    number = real(name, value)
    if not 0 <= number <= most or number != int(number):
        raise ValueError(f"{name}: a whole number from 0 to {most} expected, got {value}")
    return int(value)


def text(name: str, value: Any) -> str:
    """A text that C++ can have: UTF-8, without a zero."""
    if not isinstance(value, str) or "\0" in value:
        raise ValueError(f"{name}: a text expected, got {value!r}")
    try:
        value.encode()
    except UnicodeEncodeError:
        raise ValueError(f"{name}: a text of Unicode expected, got {value!r}") from None
    return value


def positions(vertices: npt.ArrayLike, origin: Optional[Tuple[float, float, float]]) -> Tuple[Floats, float]:
    """Vertices as floats, and by how much rounding has moved one at most."""
    expected = "an array (n, 3)"
    array = numbers("vertices", vertices, expected)
    if array.ndim != 2 or array.shape[1] != 3:
        if array.size > 0:
            refuse("vertices", expected, array)
        array = array.reshape(0, 3)
    if array.dtype == np.float32 and origin is None:
        # A copy: the caller's may change, and what the vertices came from is asked for later (vertex_origin).
        return np.array(array, dtype=np.float32, order="C", copy=True), 0.0
    if array.dtype.kind in "iu" and array.size > 0 and max(-int(array.min()), int(array.max())) > 2**53:
        raise ValueError("vertices: whole numbers up to 2^53 expected, as double precision has them")
    exact = np.ascontiguousarray(array, dtype=np.float64)
    return _core.rounded_positions(exact, origin or (0.0, 0.0, 0.0))


def indices(faces: npt.ArrayLike, vertex_count: int) -> Indices:
    """Faces as numbers of vertices."""
    expected = "an array (m, 3) of whole numbers: triangles"
    array = numbers("faces", faces, expected)
    if array.size == 0:
        array = np.zeros((0, 3), dtype=np.int64)
    if array.ndim != 2 or array.shape[1] != 3 or array.dtype.kind not in "iu":
        refuse("faces", expected, array)
    if array.dtype == np.uint32:
        return np.array(array, dtype=np.uint32, order="C", copy=True)
    if array.dtype == np.uint64 and array.max(initial=0) >= 2**63:
        raise ValueError(f"faces: vertex {array.max()} is named, but there are {vertex_count} vertices")
    return _core.checked_indices(np.ascontiguousarray(array, dtype=np.int64), vertex_count)


def rows(name: str, values: npt.ArrayLike, count: int, width: int) -> Floats:
    """One row for each vertex."""
    expected = f"an array ({count}, {width}), a row for each vertex,"
    array = numbers(name, values, expected)
    if array.shape != (count, width):
        refuse(name, expected, array)
    # A copy: the report looks at it later.
    with np.errstate(over="ignore"):
        return np.array(array, dtype=np.float32, order="C", copy=True)


def attribute(name: str, values: npt.ArrayLike, count: int) -> Tuple[Floats, int]:
    """One number, or 1 to 16, for each vertex; and how many are none in single precision."""
    expected = f"an array ({count},) or ({count}, 1 to 16)"
    array = numbers(f"attribute '{name}'", values, expected)
    if array.ndim == 1:
        array = array.reshape(-1, 1)
    if array.ndim != 2 or array.shape[0] != count or not 1 <= array.shape[1] <= 16:
        refuse(f"attribute '{name}'", expected, np.asarray(values))
    with np.errstate(over="ignore"):
        floats = np.ascontiguousarray(array, dtype=np.float32)
    return floats, int(floats.size - np.count_nonzero(np.isfinite(floats)))
