"""Planes, as callers write them."""

from __future__ import annotations

from typing import Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _arrays, _core

#: A direction: three numbers of any length but 0, or 'x', 'y', 'z', '+x', '-x', ...
Direction = Union[str, npt.ArrayLike]

_AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}


def direction(name: str, value: Direction) -> Tuple[float, float, float]:
    """Three numbers of any length but 0."""
    if isinstance(value, str):
        axis = _AXES.get(value[-1:].lower())
        if axis is None or value[:-1] not in ("", "+", "-"):
            raise ValueError(f"{name}: 'x', '-x', 'y', '-y', 'z', '-z' or three numbers expected, got '{value}'")
        sign = -1.0 if value.startswith("-") else 1.0
        return sign * axis[0], sign * axis[1], sign * axis[2]
    x, y, z = _arrays.point(name, value)
    if x == y == z == 0.0:
        raise ValueError(f"{name}: a direction expected, got 0, 0, 0")
    return x, y, z


def unit(name: str, value: Direction) -> _arrays.Doubles:
    """The same of length 1."""
    vector = np.array(direction(name, value))
    # Divided first: the square of a long one is infinite.
    vector /= np.abs(vector).max()
    return np.asarray(vector / np.linalg.norm(vector))


def plane(
    origin: npt.ArrayLike, normal: Direction, transform: Optional[npt.ArrayLike], mesh_origin: _arrays.Doubles
) -> _core.Plane:
    """The plane as the library's mesh sees it, which lies about `mesh_origin`, where `transform` places it."""
    place = np.array(_arrays.point("origin", origin))
    towards = direction("normal", normal)
    if transform is None:
        return _core.Plane(tuple(place - mesh_origin), towards)
    matrix = _arrays.numbers("transform", transform, "a 4x4 matrix")
    if matrix.shape != (4, 4):
        _arrays.refuse("transform", "a 4x4 matrix", matrix)
    moved = np.eye(4)
    moved[:3, 3] = mesh_origin
    return _core.Plane(tuple(place), towards).to_local(matrix.astype(np.float64) @ moved)
