"""Fracture: a solid broken into the cells of points, and what holds the pieces together."""

from __future__ import annotations

from typing import Any, Dict, Generic, List, Literal, Optional, Sequence, Tuple, TypeVar, Union, overload

import numpy as np
import numpy.typing as npt

from . import _arrays, _core
from ._cutting import materials_of, origin_of, wrapped
from ._mesh import Mesh
from ._object import Object
from ._planes import Direction, unit

_Whole = TypeVar("_Whole", bound=Union[Mesh, Object])

#: How cells lie.
Pattern = Literal["uniform", "impact", "crack", "grid", "splinters"]

_PATTERNS = ("uniform", "impact", "crack", "grid", "splinters")


class Fracture(Sequence[_Whole]):
    """The pieces of a mesh or an object that was broken, and how they hang together."""

    def __init__(self, pieces: List[_Whole], cells: List[Tuple[int, ...]], facts: Dict[str, Any], origin: _arrays.Doubles) -> None:
        self._pieces = pieces
        self._cells = cells
        self._pairs: _arrays.Indices = _fixed(facts["pairs"])
        self._areas: _arrays.Doubles = _fixed(facts["areas"])
        self._centres: _arrays.Doubles = _fixed(facts["centres"] + origin)
        self._normals: _arrays.Doubles = _fixed(facts["normals"])
        self._sites: _arrays.Doubles = _fixed(facts["sites"] + origin)

    @property
    def cells(self) -> List[Tuple[int, ...]]:
        """For each piece the cells that it consists of: one, unless small pieces were joined."""
        return list(self._cells)

    @property
    def bond_pieces(self) -> _arrays.Indices:
        """For each place where two pieces touch their numbers, the smaller one first; (bonds, 2)."""
        return self._pairs

    @property
    def bond_area(self) -> _arrays.Doubles:
        """For each of them its area."""
        return self._areas

    @property
    def bond_centre(self) -> _arrays.Doubles:
        """For each of them its middle; (bonds, 3)."""
        return self._centres

    @property
    def bond_normal(self) -> _arrays.Doubles:
        """For each of them the direction from the first piece to the second, of length 1; (bonds, 3)."""
        return self._normals

    @property
    def sites(self) -> _arrays.Doubles:
        """The points that all cells belong to; (cells, 3)."""
        return self._sites

    @overload
    def __getitem__(self, i: int) -> _Whole: ...
    @overload
    def __getitem__(self, i: slice) -> List[_Whole]: ...
    def __getitem__(self, i: Union[int, slice]) -> Union[_Whole, List[_Whole]]:
        return self._pieces[i]

    def __len__(self) -> int:
        return len(self._pieces)

    def __repr__(self) -> str:
        return f"<kerf.Fracture: {len(self)} pieces, {len(self._areas)} bonds>"


def fracture(
    mesh: _Whole,
    cells: int = 50,
    *,
    pattern: Pattern = "uniform",
    at: Optional[npt.ArrayLike] = None,
    direction: Direction = "y",
    seed: int = 0,
    sites: Optional[npt.ArrayLike] = None,
    least_volume: float = 0.0,
    material: Optional[int] = None,
    uv_scale: float = 1.0,
) -> Fracture[_Whole]:
    """Breaks a closed mesh, or an object, into the cells of points. What is broken stays as it is.

    :param cells: how many; one that reaches into several parts of the mesh makes several pieces
    :param pattern: 'uniform', 'impact' (smaller near `at`), 'crack' (smaller near a plane through `at`), 'grid', 'splinters'
    :param at: of an impact, on the plane of a crack, in the middle of splinters; None: the middle of the mesh
    :param direction: across the plane of a crack; along splinters
    :param seed: another one, other cells; the same one, the same bytes
    :param sites: points of the cells instead of a pattern; (cells, 3)
    :param least_volume: smaller pieces are joined to the largest of their neighbours
    :param material: a number of `materials` for the inside; None adds one, 'cap'
    :param uv_scale: uv of the inside for each unit of length
    :raises ValueError: what these can't be; a mesh that is open, or passes through itself where pieces would meet

    >>> pieces = kerf.fracture(kerf.shape("box", 12), 8, seed=1)
    >>> pieces
    <kerf.Fracture: 8 pieces, 24 bonds>
    >>> round(sum(piece.volume for piece in pieces), 6)
    1.0
    """
    origin = origin_of(mesh)
    if pattern not in _PATTERNS:
        raise ValueError(f"pattern: one of {', '.join(map(repr, _PATTERNS))} expected, got {pattern!r}")
    _arrays.count("cells", cells, 2**32 - 1)
    _arrays.count("seed", seed, 2**64 - 1)
    if material is not None:
        _arrays.count("material", material, materials_of(mesh) - 1)
    options = _core.FractureOptions(
        _PATTERNS.index(pattern),
        int(cells),
        int(seed),
        None if at is None else tuple(_arrays.point("at", at) - origin),
        tuple(unit("direction", direction)),
        _arrays.real("least_volume", least_volume),
        _core.NONE if material is None else int(material),
        _arrays.real("uv_scale", uv_scale),
    )
    points = None
    if sites is not None:
        expected = "three numbers a row"
        points = _arrays.numbers("sites", sites, expected).astype(np.float64)
        if points.ndim != 2 or points.shape[1] != 3 or len(points) == 0:
            _arrays.refuse("sites", expected, points)
        points = points - origin
    if isinstance(mesh, Object):
        core = mesh._inside
    elif isinstance(mesh, Mesh):
        core = _core.prepare(mesh._inside, "linear", 1, 1, 1)
    facts = _core.fracture(core, options, points)
    pieces = [wrapped(mesh, piece) for piece, _ in facts["pieces"]]
    return Fracture(pieces, [of for _, of in facts["pieces"]], facts, origin)


def _fixed(array: Any) -> Any:
    """The array, which nobody can write to."""
    array.flags.writeable = False
    return array
