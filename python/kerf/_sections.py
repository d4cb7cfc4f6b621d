"""Sections: what a plane meets of a mesh that stays as it is."""

from __future__ import annotations

import os
from typing import Any, Dict, Iterator, List, Literal, NamedTuple, Optional, Sequence, Tuple, Union, overload

import numpy as np
import numpy.typing as npt

from . import _arrays, _core
from ._cutting import origin_of
from ._dicing import heights_of
from ._mesh import Mesh
from ._object import Object
from ._planes import Direction, direction, plane, unit
from ._status import Status, status_of


class Path(NamedTuple):
    """A closed loop of a section, or a chain that ends at holes of the mesh. Seen from the plane's positive side an outer
    loop runs counter-clockwise, and a hole clockwise."""

    #: (k, 3), relative to the mesh's `origin`. The last point of a loop is not the first one again.
    points: _arrays.Floats
    #: (k,), of a chain (k - 1,): for each edge the face of the mesh that it lies in; -1 in a cap.
    face_index: npt.NDArray[np.int32]
    #: For each edge the material of that face.
    material: _arrays.Indices
    #: With `attributes`: the surface's normals at both ends of each edge, (2 k, 3).
    end_normals: _arrays.Floats
    #: With `attributes`: the same of uv, (2 k, 2).
    end_uv: _arrays.Floats
    #: With `attributes`: the same of the mesh's attributes by their names, (2 k, width).
    end_attributes: Dict[str, _arrays.Floats]
    #: Enclosed; negative of a hole, 0 of a chain.
    area: float
    length: float
    #: The number of the smallest loop around it, or -1.
    parent: int
    #: The number of the body that it bounds.
    solid: int
    is_closed: bool


class Polygon(NamedTuple):
    """An area in the plane: an outer loop, and loops that are left out of it, in two dimensions."""

    outer: _arrays.Doubles
    holes: List[_arrays.Doubles]


class Frame(NamedTuple):
    """Coordinates in the plane: seen from its positive side, x points to the right if y points upwards."""

    #: The place of the plane that is nearest to the origin of space.
    origin: _arrays.Doubles
    x: _arrays.Doubles
    y: _arrays.Doubles
    normal: _arrays.Doubles

    def to_2d(self, points: npt.ArrayLike) -> _arrays.Doubles:
        """Places of space, (k, 3), in the plane: (k, 2)."""
        away = np.asarray(points, dtype=np.float64) - self.origin
        return np.stack([away @ self.x, away @ self.y], axis=-1)

    def to_3d(self, places: npt.ArrayLike) -> _arrays.Doubles:
        """Places of the plane, (k, 2), in space: (k, 3)."""
        flat = np.asarray(places, dtype=np.float64)
        return np.asarray(self.origin + flat[..., :1] * self.x + flat[..., 1:] * self.y)


class Section:
    """What a plane meets of a mesh. False if that is nothing.

    >>> section = kerf.section(kerf.shape("torus", 2000), origin=(0, 0, 0), normal="z")
    >>> section
    <kerf.Section: done, 2 loops, area 5.013>
    >>> [round(loop.area, 3) for loop in section.paths]
    [-1.128, 6.141]
    >>> [len(polygon.holes) for polygon in section.polygons()]
    [1]
    """

    def __init__(self, core: _core.Section, origin: _arrays.Doubles) -> None:
        self._inside = core
        self._origin = origin
        self._paths: Optional[List[Path]] = None

    @property
    def status(self) -> Status:
        """'done', 'missed', or 'open_section' if the mesh has holes there."""
        return status_of(self._inside.status)

    @property
    def origin(self) -> _arrays.Doubles:
        """That of the mesh, (3,): points are relative to it."""
        return self._origin.copy()

    @property
    def paths(self) -> List[Path]:
        """Loops and chains."""
        if self._paths is None:
            self._paths = [Path(**self._inside.path(i)) for i in range(self._inside.path_count)]
        return list(self._paths)

    @property
    def loops(self) -> List[_arrays.Floats]:
        """The points of each closed loop, (k, 3), relative to `origin`."""
        return [path.points for path in self.paths if path.is_closed]

    @property
    def chains(self) -> List[_arrays.Floats]:
        """The same of those that are not closed."""
        return [path.points for path in self.paths if not path.is_closed]

    @property
    def face_index(self) -> npt.NDArray[np.int32]:
        """For each edge of all paths the face of the mesh that it lies in; -1 in a cap."""
        parts = [path.face_index for path in self.paths]
        return np.concatenate(parts) if parts else np.zeros(0, dtype=np.int32)

    @property
    def area(self) -> float:
        """Enclosed by all loops, holes taken away."""
        return self._inside.area

    @property
    def length(self) -> float:
        """Of all loops and chains."""
        return self._inside.length

    @property
    def centroid(self) -> _arrays.Doubles:
        """Centre of the enclosed area; of the outline, if nothing is enclosed: (3,)."""
        return np.asarray(self._inside.centroid + self._origin)

    @property
    def bounds(self) -> _arrays.Doubles:
        """The least and the largest coordinates, (2, 3)."""
        return np.asarray(self._inside.bounds + self._origin)

    @property
    def frame(self) -> Frame:
        """Coordinates in the plane."""
        frame = Frame(**self._inside.frame)
        # The library's frame is about the mesh's origin; this one is about the origin of space.
        height = frame.normal @ (frame.origin + self._origin)
        return frame._replace(origin=height * frame.normal)

    def polygons(self) -> List[Polygon]:
        """Areas with their holes, in coordinates of `frame`. An island in a hole is an area of its own. Needs `nesting`."""
        frame = self.frame
        paths = self.paths
        depth: List[int] = []
        polygons: Dict[int, Polygon] = {}
        flat = [frame.to_2d(path.points + self._origin) for path in paths]
        for i in _outside_in(paths, depth):
            path = paths[i]
            if depth[i] % 2 == 0:
                polygons[i] = Polygon(flat[i], [])
            else:
                polygons[path.parent].holes.append(flat[i])
        return [polygons[i] for i in sorted(polygons)]

    @property
    def points(self) -> _arrays.Floats:
        """What `triangles` counts, (k, 3), relative to `origin`: the points of all paths, and where loops cross."""
        return self._inside.points

    @property
    def triangles(self) -> _arrays.Indices:
        """With `fill`: what closes the section, (m, 3) numbers of `points`, counter-clockwise seen from the positive side."""
        return self._inside.triangles

    @property
    def fill_exceeds_section(self) -> bool:
        """A warning: triangles overlap, because the section crosses itself, or winds backwards."""
        return self._inside.fill_exceeds_section

    @property
    def statistics(self) -> Dict[str, Any]:
        """What it has cost: counters that are the same in every run, and 'milliseconds'."""
        return self._inside.statistics

    def write(self, file: Union[str, "os.PathLike[str]"], *, unit: str = "mm") -> None:
        """Writes the outline at true scale: SVG, DXF or OBJ, by the extension.

        :param unit: of the mesh: 'mm', 'cm', 'm', 'in' or 'ft'
        :raises kerf.FileError: it can't be written
        """
        self._inside.write(os.fspath(file), _arrays.text("unit", unit))

    def to_svg(self, *, unit: str = "mm") -> str:
        """The same as a text.

        >>> kerf.section(kerf.shape("box", 12), origin=(0, 0, 0), normal="z").to_svg()[:5]
        '<?xml'
        """
        return self._inside.bytes("svg", _arrays.text("unit", unit)).decode()

    def _repr_svg_(self) -> Optional[str]:
        """For notebooks."""
        return self.to_svg() if self else None

    def __bool__(self) -> bool:
        return self._inside.path_count > 0

    def __repr__(self) -> str:
        if not self:
            return f"<kerf.Section: {self.status}>"
        loops = sum(path.is_closed for path in self.paths)
        chains = self._inside.path_count - loops
        also = f", {chains} chain{'s' * (chains != 1)}" if chains else ""
        return f"<kerf.Section: {self.status}, {loops} loop{'s' * (loops != 1)}{also}, area {self.area:.4g}>"


def _outside_in(paths: List[Path], depth: List[int]) -> Iterator[int]:
    """Closed loops, each after the one that it lies in; fills `depth`."""
    depth[:] = [-1] * len(paths)
    for start in range(len(paths)):
        around = []
        i = start
        while i >= 0 and depth[i] < 0 and paths[i].is_closed:
            around.append(i)
            i = paths[i].parent
        for inner in reversed(around):
            parent = paths[inner].parent
            depth[inner] = 0 if parent < 0 else depth[parent] + 1
            yield inner


class SectionStack(Sequence[Section]):
    """Sections by parallel planes, in the order of the heights that were asked for."""

    def __init__(self, core: _core.SectionStack, origin: _arrays.Doubles) -> None:
        self._inside = core
        self._origin = origin

    @overload
    def __getitem__(self, i: int) -> Section: ...
    @overload
    def __getitem__(self, i: slice) -> List[Section]: ...
    def __getitem__(self, i: Union[int, slice]) -> Union[Section, List[Section]]:
        if isinstance(i, slice):
            return [self[j] for j in range(*i.indices(len(self)))]
        number = i + len(self) if i < 0 else i
        if not 0 <= number < len(self):
            raise IndexError(f"section {i} of {len(self)}")
        return Section(self._inside.section(number), self._origin)

    def __len__(self) -> int:
        return self._inside.count

    def write(self, file: Union[str, "os.PathLike[str]"], *, unit: str = "mm") -> None:
        """Writes all outlines into one drawing: SVG with a group for each, DXF with each at its height, or OBJ."""
        self._inside.write(os.fspath(file), _arrays.text("unit", unit))

    def to_svg(self, *, unit: str = "mm") -> str:
        """The same as a text."""
        return self._inside.bytes("svg", _arrays.text("unit", unit)).decode()

    def __repr__(self) -> str:
        return f"<kerf.SectionStack: {len(self)} sections>"


def section(
    mesh: Union[Mesh, Object],
    *,
    origin: npt.ArrayLike,
    normal: Direction,
    transform: Optional[npt.ArrayLike] = None,
    nesting: bool = True,
    fill: bool = False,
    fill_quality: Literal["fast", "delaunay"] = "fast",
    attributes: bool = False,
    up: Optional[Direction] = None,
) -> Section:
    """What a plane meets of a mesh or an object, which stays as it is. Any number of threads may ask one at once.

    Of an object it costs what the section costs; of a mesh O(n).

    :param origin: a place that the plane goes through
    :param normal: where the positive side lies: three numbers of any length, or 'x', '-z', ...
    :param transform: as of `cut`; the section stays where the mesh is
    :param nesting: find for each loop the one that it lies in
    :param fill: also the triangles that close the section
    :param attributes: also normals, uv and attributes along the outline
    :param up: what points upwards in `Section.frame`, as far as it lies in the plane

    >>> kerf.section(kerf.shape("box", 12), origin=(0, 0, 0), normal="x").area
    1.0
    >>> bool(kerf.section(kerf.shape("box", 12), origin=(9, 0, 0), normal="x"))
    False
    """
    mesh_origin = origin_of(mesh)
    options = _options(nesting, fill, fill_quality, attributes, up)
    where = plane(origin, normal, transform, mesh_origin)
    return Section(_core.section(_asked(mesh), where, options), mesh_origin)


def sections(
    mesh: Union[Mesh, Object],
    *,
    normal: Direction,
    heights: npt.ArrayLike,
    origin: npt.ArrayLike = (0.0, 0.0, 0.0),
    nesting: bool = True,
    fill: bool = False,
    fill_quality: Literal["fast", "delaunay"] = "fast",
    attributes: bool = False,
    up: Optional[Direction] = None,
    threads: int = 0,
) -> SectionStack:
    """What parallel planes meet of a mesh or an object: those across `normal` at some distances from `origin`.

    :param heights: signed distances along the normal, in any order
    :param threads: 0: as many as the processor has; the sections are the same

    >>> stack = kerf.sections(kerf.shape("box", 12), normal="z", heights=[-0.25, 0, 5])
    >>> [section.area for section in stack]
    [1.0, 1.0, 0.0]
    """
    mesh_origin = origin_of(mesh)
    options = _options(nesting, fill, fill_quality, attributes, up)
    along = unit("normal", normal)
    offset = along @ (np.array(_arrays.point("origin", origin)) - mesh_origin)
    distances = list(heights_of(heights) + offset)
    if isinstance(mesh, Object):
        core = mesh._inside
    elif _core.sooner_for_sections(mesh._inside, tuple(along), distances):
        core = _core.prepare(mesh._inside, "halfedge", len(distances), 1, 0)
    else:
        core = mesh._object()
    threads = _arrays.count("threads", threads)
    return SectionStack(_core.sections(core, tuple(along), distances, options, threads), mesh_origin)


def _asked(mesh: Union[Mesh, Object]) -> _core.Object:
    return mesh._inside if isinstance(mesh, Object) else mesh._object()


def _options(
    nesting: bool, fill: bool, fill_quality: str, attributes: bool, up: Optional[Direction]
) -> _core.SectionOptions:
    if fill_quality not in ("fast", "delaunay"):
        raise ValueError(f"fill_quality: 'fast' or 'delaunay' expected, got {fill_quality!r}")
    upwards: Optional[Tuple[float, float, float]] = None if up is None else direction("up", up)
    return _core.SectionOptions(bool(nesting), bool(fill), fill_quality == "delaunay", bool(attributes), upwards)
