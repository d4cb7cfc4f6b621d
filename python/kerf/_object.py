"""Prepared objects: what many cuts and sections are made of."""

from __future__ import annotations

from typing import Any, Callable, List, Tuple, Union

import numpy as np

from . import _arrays, _core
from ._mesh import Material, Mesh, look

_Input = Tuple[_arrays.Floats, _arrays.Indices]


class Object:
    """A mesh that was prepared (`Mesh.prepare`), or a piece of one. A cut of it costs what its section costs, and
    consumes it: the pieces take its place, and a further use raises ValueError. Cut a `copy()` to keep it.

    Several threads may use one: who reads does not wait for who reads.
    """

    def __init__(self, core: _core.Object, origin: _arrays.Doubles, input_: Callable[[], _Input]) -> None:
        self._inside = core
        self._origin = origin
        self._input = input_

    @property
    def origin(self) -> _arrays.Doubles:
        """That of the mesh: (3,)."""
        return self._origin.copy()

    @property
    def is_gone(self) -> bool:
        """Whether it was cut, and its pieces took its place."""
        return self._inside.is_gone

    @property
    def triangle_count(self) -> int:
        """With caps."""
        return self._inside.triangle_count

    @property
    def bounds(self) -> _arrays.Doubles:
        """The least and the largest coordinates, (2, 3)."""
        return np.asarray(self._inside.bounds + self._origin)

    @property
    def volume(self) -> float:
        """O(log n) with the half-edge back end, O(n) with the linear one."""
        return float(self._inside.mass["volume"])

    @property
    def centre_mass(self) -> _arrays.Doubles:
        """(3,)"""
        return np.asarray(self._inside.mass["centre"] + self._origin)

    @property
    def inertia(self) -> _arrays.Doubles:
        """Of density 1, about `centre_mass`: (3, 3)."""
        return np.asarray(self._inside.mass["inertia"])

    @property
    def back_end(self) -> str:
        """The name of the way to cut: one of `back_ends()`."""
        return self._inside.back_end

    @property
    def materials(self) -> List[Material]:
        """Those of the mesh, and of caps."""
        return [Material(*material) for material in self._inside.materials]

    def add_material(self, material: Union[str, Material]) -> int:
        """Adds a material and returns its number: a `cap_material` of later cuts."""
        return self._inside.add_material(*look(material))

    def mesh(self) -> Mesh:
        """A compact copy of the triangles. O(n)."""
        return Mesh._of(self._inside.mesh(), self._origin, self._input)

    def copy(self) -> Object:
        """An object that shares nothing with this one: a copy of memory, not a `prepare`. O(n)."""
        return Object(self._inside.clone(), self._origin, self._input)

    def __copy__(self) -> Object:
        return self.copy()

    def __deepcopy__(self, _: Any) -> Object:
        return self.copy()

    def __repr__(self) -> str:
        if self.is_gone:
            return "<kerf.Object: was cut>"
        size = " x ".join(f"{length:.4g}" for length in np.diff(self._inside.bounds, axis=0)[0])
        return f"<kerf.Object: {self.triangle_count} triangles, {size}, {self.back_end}>"


def back_ends() -> List[str]:
    """The ways to cut that this build has, the best for many cuts first.

    >>> kerf.back_ends()
    ['halfedge', 'linear']
    """
    return _core.back_ends()
