"""Many cuts at once: pieces by the layers that they lie in."""

from __future__ import annotations

from typing import Any, Dict, Generic, Iterable, Iterator, List, Literal, Optional, Sequence, Tuple, TypeVar, Union, overload

import numpy as np
import numpy.typing as npt

from . import _arrays, _core
from ._cutting import cut_options, materials_of, origin_of, wrapped
from ._mesh import Mesh
from ._object import Object
from ._planes import Direction, unit
from ._status import Status, status_of


_Whole = TypeVar("_Whole", bound=Union[Mesh, Object])


class Piece(Generic[_Whole]):
    """A piece, and where it lies. Unpacks to the two."""

    def __init__(self, mesh: _Whole, cell: Tuple[int, ...]) -> None:
        #: A mesh or an object, as what was diced.
        self.mesh = mesh
        #: For each direction of planes the number of its layer, 0 below the lowest.
        self.cell = cell

    def __iter__(self) -> Iterator[Any]:
        yield self.mesh
        yield self.cell

    def __repr__(self) -> str:
        return f"<kerf.Piece {self.cell}: {self.mesh!r}>"


class Dice(Sequence[Piece[_Whole]]):
    """The pieces of a mesh or an object, in the order of their cells."""

    def __init__(self, pieces: List[Piece[_Whole]], facts: Dict[str, Any]) -> None:
        self._pieces = pieces
        self._facts = facts

    @property
    def status(self) -> Status:
        """'done', or 'open_section' if the mesh has holes at a cut."""
        return status_of(self._facts["status"])

    @property
    def empty_cells(self) -> int:
        """In which nothing lies."""
        return int(self._facts["empty_cells"])

    @property
    def caps_exceed_section(self) -> bool:
        """A warning, as that of a cut."""
        return bool(self._facts["caps_exceed_section"])

    @property
    def statistics(self) -> Dict[str, Any]:
        """What all cuts have cost."""
        return dict(self._facts["statistics"])

    @overload
    def __getitem__(self, i: int) -> Piece[_Whole]: ...
    @overload
    def __getitem__(self, i: slice) -> List[Piece[_Whole]]: ...
    def __getitem__(self, i: Union[int, slice]) -> Union[Piece[_Whole], List[Piece[_Whole]]]:
        return self._pieces[i]

    def __len__(self) -> int:
        return len(self._pieces)

    def __repr__(self) -> str:
        return f"<kerf.Dice: {self.status}, {len(self)} pieces>"


def dice(
    mesh: _Whole,
    *,
    x: npt.ArrayLike = (),
    y: npt.ArrayLike = (),
    z: npt.ArrayLike = (),
    planes: Iterable[Tuple[Direction, npt.ArrayLike]] = (),
    gap: float = 0.0,
    cap: bool = True,
    components: bool = False,
    cap_material: Optional[int] = None,
    cap_uv_scale: float = 1.0,
    cap_quality: Literal["fast", "delaunay"] = "fast",
) -> Dice[_Whole]:
    """Cuts a mesh, or an object, which is gone then, by many planes.

    :param x: where planes across the x axis lie; in any order
    :param y: the same of the y axis
    :param z: the same of the z axis
    :param planes: further ones: a direction, and signed distances along it from the origin of space
    :param gap: width of the blade
    :raises ValueError: what these can't be; the rest as of `cut`

    >>> pieces = kerf.dice(kerf.shape("box", 12), x=[-0.25, 0.25], z=[0])
    >>> [piece.cell for piece in pieces]
    [(0, 0), (0, 1), (1, 0), (1, 1), (2, 0), (2, 1)]
    >>> sum(piece.mesh.volume for piece in pieces)
    1.0
    """
    mesh_origin = origin_of(mesh)
    options = cut_options(
        cap, components, gap, cap_material, cap_uv_scale, cap_quality, None, "region", mesh_origin, materials_of(mesh)
    )
    layers = []
    wanted: List[Tuple[Direction, npt.ArrayLike]] = [(axis, heights) for axis, heights in (("x", x), ("y", y), ("z", z)) if np.size(heights) > 0]
    try:
        wanted += [(normal, heights) for normal, heights in planes]
    except TypeError:
        raise ValueError("planes: pairs of a direction and heights expected") from None
    for normal, heights in wanted:
        direction = unit("planes", normal)
        layers.append((tuple(direction), list(heights_of(heights) - direction @ mesh_origin)))
    if isinstance(mesh, Object):
        core = mesh._inside
    elif isinstance(mesh, Mesh):
        core = _core.prepare(mesh._inside, None, _core.cuts_expected(layers), 1, 0)
    facts = _core.dice(core, layers, options)
    return Dice([Piece(wrapped(mesh, piece), cell) for piece, cell in facts["pieces"]], facts)


def heights_of(values: npt.ArrayLike) -> _arrays.Doubles:
    """Finite numbers in a row; one number is a row of one."""
    expected = "a row of numbers"
    heights: _arrays.Doubles = np.atleast_1d(_arrays.numbers("heights", values, expected)).astype(np.float64)
    if heights.ndim != 1:
        _arrays.refuse("heights", expected, heights)
    if not np.isfinite(heights).all():
        raise ValueError("heights: finite numbers expected")
    return heights
