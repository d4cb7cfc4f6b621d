"""Cuts: both halves, in one call."""

from __future__ import annotations

from typing import Any, Dict, Generic, Iterator, List, Literal, Optional, TypeVar, Union, overload

import numpy.typing as npt

from . import _arrays, _core
from ._mesh import Mesh
from ._object import Object
from ._planes import Direction, plane
from ._status import Status, status_of

_Side = TypeVar("_Side", covariant=True)


class Cut(Generic[_Side]):
    """What became of a mesh or an object that was cut. Unpacks to what lies on the plane's positive side (where the
    normal points to) and on the negative one: a mesh or None each; with `components` a list each, the largest piece first.

    >>> cut = kerf.cut(kerf.shape("box", 12), origin=(0, 0, 0), normal="x")
    >>> cut
    <kerf.Cut: done, area 1>
    >>> positive, negative = cut
    """

    def __init__(self, status: Status, positive: _Side, negative: _Side, facts: Dict[str, Any]) -> None:
        self._status = status
        self._positive = positive
        self._negative = negative
        self._facts = facts

    @property
    def status(self) -> Status:
        """'done'; 'open_section' if the mesh has holes there; 'missed' if the plane does not go through it;
        'not_separated' if what `only` has chosen does not part it. The last two leave it whole, on the side that it
        lies on, or on the negative one."""
        return self._status

    @property
    def positive(self) -> _Side:
        """What lies where the normal points to."""
        return self._positive

    @property
    def negative(self) -> _Side:
        """What lies on the other side."""
        return self._negative

    @property
    def area(self) -> float:
        """What the section encloses."""
        return float(self._facts["area"])

    @property
    def caps_exceed_section(self) -> bool:
        """A warning: caps overlap, because the section crosses itself, or winds backwards."""
        return bool(self._facts["caps_exceed_section"])

    @property
    def statistics(self) -> Dict[str, Any]:
        """What it has cost: counters that are the same in every run, and 'milliseconds'."""
        return dict(self._facts["statistics"])

    def __iter__(self) -> Iterator[_Side]:
        yield self._positive
        yield self._negative

    def __bool__(self) -> bool:
        """Whether it was cut."""
        return self._status.ok

    def __repr__(self) -> str:
        return f"<kerf.Cut: {self._status}, area {self.area:.6g}>"


@overload
def cut(
    mesh: Mesh,
    *,
    origin: npt.ArrayLike,
    normal: Direction,
    transform: Optional[npt.ArrayLike] = ...,
    cap: bool = ...,
    components: Literal[False] = ...,
    gap: float = ...,
    cap_material: Optional[int] = ...,
    cap_uv_scale: float = ...,
    cap_quality: Literal["fast", "delaunay"] = ...,
    only: Optional[npt.ArrayLike] = ...,
    only_extent: Literal["region", "solid"] = ...,
) -> Cut[Optional[Mesh]]: ...
@overload
def cut(
    mesh: Mesh,
    *,
    origin: npt.ArrayLike,
    normal: Direction,
    transform: Optional[npt.ArrayLike] = ...,
    cap: bool = ...,
    components: Literal[True],
    gap: float = ...,
    cap_material: Optional[int] = ...,
    cap_uv_scale: float = ...,
    cap_quality: Literal["fast", "delaunay"] = ...,
    only: Optional[npt.ArrayLike] = ...,
    only_extent: Literal["region", "solid"] = ...,
) -> Cut[List[Mesh]]: ...
@overload
def cut(
    mesh: Object,
    *,
    origin: npt.ArrayLike,
    normal: Direction,
    transform: Optional[npt.ArrayLike] = ...,
    cap: bool = ...,
    components: Literal[False] = ...,
    gap: float = ...,
    cap_material: Optional[int] = ...,
    cap_uv_scale: float = ...,
    cap_quality: Literal["fast", "delaunay"] = ...,
    only: Optional[npt.ArrayLike] = ...,
    only_extent: Literal["region", "solid"] = ...,
) -> Cut[Optional[Object]]: ...
@overload
def cut(
    mesh: Object,
    *,
    origin: npt.ArrayLike,
    normal: Direction,
    transform: Optional[npt.ArrayLike] = ...,
    cap: bool = ...,
    components: Literal[True],
    gap: float = ...,
    cap_material: Optional[int] = ...,
    cap_uv_scale: float = ...,
    cap_quality: Literal["fast", "delaunay"] = ...,
    only: Optional[npt.ArrayLike] = ...,
    only_extent: Literal["region", "solid"] = ...,
) -> Cut[List[Object]]: ...
@overload
def cut(
    mesh: Union[Mesh, Object],
    *,
    origin: npt.ArrayLike,
    normal: Direction,
    transform: Optional[npt.ArrayLike] = ...,
    cap: bool = ...,
    components: bool,
    gap: float = ...,
    cap_material: Optional[int] = ...,
    cap_uv_scale: float = ...,
    cap_quality: Literal["fast", "delaunay"] = ...,
    only: Optional[npt.ArrayLike] = ...,
    only_extent: Literal["region", "solid"] = ...,
) -> Cut[Any]: ...
def cut(
    mesh: Union[Mesh, Object],
    *,
    origin: npt.ArrayLike,
    normal: Direction,
    transform: Optional[npt.ArrayLike] = None,
    cap: bool = True,
    components: bool = False,
    gap: float = 0.0,
    cap_material: Optional[int] = None,
    cap_uv_scale: float = 1.0,
    cap_quality: Literal["fast", "delaunay"] = "fast",
    only: Optional[npt.ArrayLike] = None,
    only_extent: Literal["region", "solid"] = "region",
) -> Cut[Any]:
    """Cuts a mesh, or an object, by a plane. Both halves are closed, and keep normals, uv, attributes and materials.

    Of a mesh: a copy is cut, in O(n), and the halves are meshes. Of an object (`Mesh.prepare`): the cut costs what its
    section costs, the halves are objects, and the object is gone, unless it was not cut.

    :param origin: a place that the plane goes through, in the mesh's unit
    :param normal: where the positive side lies: three numbers of any length, or 'x', '-z', ...
    :param transform: a 4x4 matrix that places the mesh in the world: then origin and normal are the world's, and the
        sides, too. The halves stay where the mesh is. Any affine map that can be undone
    :param cap: close the section; the halves of an open section stay open there in any case
    :param components: each side as its connected pieces
    :param gap: width of the blade: what lies within half of it on either side is taken away
    :param cap_material: a number of `materials` for caps; None adds one, 'cap'
    :param cap_uv_scale: uv of caps for each unit of length
    :param cap_quality: 'delaunay' for caps without needles, in a build with CGAL
    :param only: a place: only the part of the section that is nearest to it is cut, such as one leg of two
    :param only_extent: what of the section that is: a 'region', an outer loop with its holes, or all of a 'solid'
    :raises ValueError: what these can't be

    >>> top, bottom = kerf.cut(kerf.shape("box", 12), origin=(0, 0, 0.25), normal="z")
    >>> print(top.volume, bottom.volume)
    0.25 0.75
    >>> kerf.cut(kerf.shape("box", 12), origin=(0, 0, 7), normal="z").positive is None
    True
    """
    mesh_origin = origin_of(mesh)
    options = cut_options(
        cap, components, gap, cap_material, cap_uv_scale, cap_quality, only, only_extent, mesh_origin, materials_of(mesh)
    )
    where = plane(origin, normal, transform, mesh_origin)
    # The mesh stays, and what is made of it is cut.
    core = mesh._inside if isinstance(mesh, Object) else _core.prepare(mesh._inside, "linear", 1, 1, 1)
    facts = _core.cut(core, where, options)
    status = status_of(facts["status"])
    if status.ok:
        sides = [[wrapped(mesh, piece) for piece in facts[side]] for side in ("positive", "negative")]
    else:
        # As it was, and where it was.
        is_positive = status == Status.MISSED and facts["is_positive"]
        sides = [[mesh], []] if is_positive else [[], [mesh]]
    if components:
        return Cut(status, sides[0], sides[1], facts)
    positive, negative = (side[0] if side else None for side in sides)
    return Cut(status, positive, negative, facts)


def origin_of(mesh: Union[Mesh, Object]) -> _arrays.Doubles:
    if not isinstance(mesh, (Mesh, Object)):
        raise ValueError(f"a kerf.Mesh or a kerf.Object expected, got {type(mesh).__name__}")
    return mesh._origin


def materials_of(mesh: Union[Mesh, Object]) -> int:
    """How many there are."""
    return len(mesh._inside.materials)


def wrapped(mesh: Union[Mesh, Object], piece: _core.Object) -> Any:
    """A piece as what was cut."""
    if isinstance(mesh, Object):
        return Object(piece, mesh._origin, mesh._input)
    return Mesh._of(piece.mesh(), mesh._origin, mesh._input)


def cut_options(
    cap: bool,
    components: bool,
    gap: float,
    cap_material: Optional[int],
    cap_uv_scale: float,
    cap_quality: str,
    only: Optional[npt.ArrayLike],
    only_extent: str,
    mesh_origin: _arrays.Doubles,
    materials: int,
) -> _core.CutOptions:
    if cap_quality not in ("fast", "delaunay"):
        raise ValueError(f"cap_quality: 'fast' or 'delaunay' expected, got {cap_quality!r}")
    if only_extent not in ("region", "solid"):
        raise ValueError(f"only_extent: 'region' or 'solid' expected, got {only_extent!r}")
    if cap_material is not None:
        _arrays.count("cap_material", cap_material, materials - 1)
    near = None if only is None else tuple(_arrays.point("only", only) - mesh_origin)
    return _core.CutOptions(
        bool(cap),
        bool(components),
        _core.NONE if cap_material is None else int(cap_material),
        _arrays.real("cap_uv_scale", cap_uv_scale),
        _arrays.real("gap", gap),
        cap_quality == "delaunay",
        near,
        only_extent == "solid",
    )
