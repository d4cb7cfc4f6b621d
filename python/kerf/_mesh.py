"""Meshes: arrays in, arrays out."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _arrays, _core, _exchange

if TYPE_CHECKING:
    from ._object import Object


class Material(NamedTuple):
    """How a material looks, for programs that draw or write files."""

    name: str = ""
    #: Red, green, blue and alpha, linear.
    base_colour: Tuple[float, float, float, float] = (1.0, 1.0, 1.0, 1.0)
    #: A file name, or ''.
    base_colour_image: str = ""


class Report(NamedTuple):
    """What a mesh was like as it was given, and what was done about it."""

    #: Counts and measures by their names in kerf::MeshFacts: 'triangles', 'open_edges', 'volume', ...
    facts: Dict[str, Any]
    #: Counts by their names in kerf::Repairs: 'degenerate_triangles', 'flipped_triangles', ...
    repairs: Dict[str, int]
    #: The repairs in a sentence; '' if nothing was repaired.
    repairs_text: str
    #: The longest way that rounding to single precision has moved a vertex, in the mesh's unit.
    rounding: float = 0.0
    #: What was put right in a file besides, and how often.
    notes: Tuple[Tuple[str, int], ...] = ()
    #: How many numbers of attributes are none in single precision (NaN, infinite, too large), and are 0 in the mesh.
    zeroed_attributes: Mapping[str, int] = {}


class VertexOrigin(NamedTuple):
    """How vertices came to be: sums of three vertices of the input, each times its weight."""

    #: (n, 3) numbers of vertices of the input; -1 of a vertex of a cap.
    vertices: npt.NDArray[np.int32]
    #: (n, 3), from 0 to 1; they add up to 1, or are 0 of a vertex of a cap.
    weights: npt.NDArray[np.float32]


#: What vertices and faces came from: positions and indices.
_Input = Tuple[_arrays.Floats, _arrays.Indices]


class Mesh:
    """A triangle mesh that can be cut. It can't be changed.

    Vertices with the same coordinates are one place of the surface, whatever their numbers. What can't be cut is
    repaired: triangles without an area are dropped, edges of more than two triangles divided, shells turned the right
    side out; `report` counts what was done, and no vertex is moved.

    Coordinates are stored in single precision. Vertices in double precision are rounded once, and
    `report.rounding` says by how much. If your mesh lies far from the origin, give an `origin` near it: it is subtracted
    before anything is rounded. Then all arrays of floats hold places relative to the mesh's `origin`, and all
    other numbers, given or received, stay yours.

    Takes O(n log n). Raises ValueError for arrays that are no mesh.

    :param vertices: (n, 3)
    :param faces: (m, 3), counter-clockwise seen from outside
    :param normals: (n, 3), of about length 1; without them smooth ones are made, and edges that turn by more than
        `crease_degrees` stay sharp
    :param uv: (n, 2)
    :param attributes: further numbers of each vertex by their names, (n,) or (n, 1 to 16); a cut interpolates them. They
        are stored in single precision, and what is no number is 0 (`report.zeroed_attributes`)
    :param face_material: (m,) numbers of `materials`
    :param materials: names, or `Material`
    :param origin: three numbers, subtracted from all vertices

    >>> tetrahedron = kerf.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
    ...                         [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
    >>> tetrahedron
    <kerf.Mesh: 4 triangles, 1 x 1 x 1, closed>
    >>> print(f"{tetrahedron.volume:.4f}")
    0.1667
    """

    _inside: _core.Mesh
    _origin: _arrays.Doubles
    _report: Optional[Report]
    _make_report: Optional[Callable[[], Report]]
    _input: Callable[[], _Input]
    _linear: Optional[_core.Object]

    def __init__(
        self,
        vertices: npt.ArrayLike,
        faces: npt.ArrayLike,
        *,
        normals: Optional[npt.ArrayLike] = None,
        uv: Optional[npt.ArrayLike] = None,
        attributes: Optional[Mapping[str, npt.ArrayLike]] = None,
        face_material: Optional[npt.ArrayLike] = None,
        materials: Sequence[Union[str, Material]] = (),
        origin: Optional[npt.ArrayLike] = None,
        crease_degrees: float = 40.0,
    ) -> None:
        moved = None if origin is None else _arrays.point("origin", origin)
        positions, rounding = _arrays.positions(vertices, moved)
        count = len(positions)
        indices = _arrays.indices(faces, count)
        normal_rows = None if normals is None else _arrays.rows("normals", normals, count, 3)
        uv_rows = None if uv is None else _arrays.rows("uv", uv, count, 2)
        streams, zeroed = [], {}
        if not hasattr(attributes or {}, "items"):
            raise ValueError(f"attributes: names and arrays expected, got {type(attributes).__name__}")
        for name, values in (attributes or {}).items():
            floats, zeroed[name] = _arrays.attribute(_arrays.text("attributes", name), values, count)
            streams.append((name, floats))
        core = _core.Mesh.make(
            positions,
            indices,
            normal_rows,
            uv_rows,
            None if face_material is None else _face_material(face_material, len(indices)),
            [look(material) for material in materials or ()],
            streams,
            _arrays.real("crease_degrees", crease_degrees),
        )
        self._set(core, np.zeros(3) if moved is None else np.array(moved), lambda: (positions, indices))
        self._make_report = lambda: Report(
            *_core.Mesh.report(positions, indices, normal_rows, uv_rows),
            rounding=rounding,
            zeroed_attributes={name: number for name, number in zeroed.items() if number > 0},
        )

    def _set(self, core: _core.Mesh, origin: _arrays.Doubles, input_: Callable[[], _Input]) -> None:
        origin.flags.writeable = False
        self._inside = core
        self._origin = origin
        self._report = None
        self._make_report = None
        self._input = input_
        self._linear = None

    @classmethod
    def _of(cls, core: _core.Mesh, origin: _arrays.Doubles, input_: Optional[Callable[[], _Input]]) -> Mesh:
        """A mesh that the library has made. Without an input it is its own."""
        mesh = cls.__new__(cls)
        mesh._set(core, origin, input_ or (lambda: _as_input(core)))
        return mesh

    @property
    def origin(self) -> _arrays.Doubles:
        """What was subtracted from all vertices: (3,)."""
        return self._origin.copy()

    @property
    def vertices(self) -> _arrays.Floats:
        """Positions, (n, 3), relative to `origin`. Like all arrays of a mesh: read-only, not copied, and valid as long
        as you keep it."""
        return self._inside.positions

    @property
    def faces(self) -> _arrays.Indices:
        """Three vertices for each triangle, (m, 3), counter-clockwise seen from outside."""
        return self._inside.indices

    @property
    def normals(self) -> _arrays.Floats:
        """For each vertex, (n, 3), of length 1."""
        return self._inside.normals

    @property
    def uv(self) -> _arrays.Floats:
        """For each vertex, (n, 2)."""
        return self._inside.uvs

    @property
    def attributes(self) -> Dict[str, _arrays.Floats]:
        """The further numbers of each vertex: (n,), or (n, width)."""
        return {name: values[:, 0] if values.shape[1] == 1 else values for name, values in self._inside.streams}

    @property
    def vertex_point(self) -> _arrays.Indices:
        """For each vertex the place on the surface that it is at, (n,): vertices along a seam have the same.

        >>> box = kerf.shape("box", 12)
        >>> len(box.vertices), len(np.unique(box.vertex_point))
        (24, 8)
        """
        return self._inside.points

    @property
    def face_index(self) -> npt.NDArray[np.int32]:
        """For each triangle the face of the input that it is a part of, (m,); -1 of a cap. Pieces, and pieces of pieces,
        name the faces of the mesh that you made.

        >>> top, bottom = kerf.cut(kerf.shape("box", 12), origin=(0, 0, 0), normal="z")
        >>> sorted(set(top.face_index))[:3]
        [-1, 0, 1]
        """
        return self._inside.sources

    @property
    def is_cap(self) -> npt.NDArray[np.bool_]:
        """For each triangle whether it closes a cut, (m,)."""
        return self._inside.is_cap

    @property
    def face_material(self) -> _arrays.Indices:
        """For each triangle its number in `materials`, (m,)."""
        return self._inside.triangle_materials

    @property
    def face_solid(self) -> _arrays.Indices:
        """For each triangle the body that it bounds, (m,): a cavity has the number of its body."""
        return self._inside.solids

    @property
    def materials(self) -> List[Material]:
        """What `face_material` counts."""
        return [Material(*material) for material in self._inside.materials]

    @property
    def vertex_origin(self) -> VertexOrigin:
        """Where each vertex lies in the mesh that you made or read: O(n), found anew at each call. For numbers of vertices
        that Kerf knows nothing of.

        >>> rock = kerf.shape("asteroid", 1000)
        >>> colours = np.random.default_rng(1).random((len(rock.vertices), 3))
        >>> top, bottom = kerf.cut(rock, origin=(0, 0, 0), normal="z")
        >>> origin = top.vertex_origin
        >>> on_surface = origin.vertices[:, 0] >= 0
        >>> top_colours = np.einsum("nk,nkc->nc", origin.weights, colours[origin.vertices])
        >>> bool(np.all(top_colours[on_surface] <= colours.max(axis=0) + 1e-6))
        True
        """
        return VertexOrigin(*self._inside.vertex_origins(*self._input()))

    @property
    def report(self) -> Optional[Report]:
        """What the mesh was like as it was given, measured at the first call: as long as it takes to make the mesh. None of
        a piece."""
        if self._report is None and self._make_report is not None:
            self._report = self._make_report()
        return self._report

    @property
    def is_closed(self) -> bool:
        """Whether the surface has no boundary, so that it bounds solids."""
        return self._inside.is_closed

    @property
    def has_coarse_coordinates(self) -> bool:
        """A warning: single precision moves cut points by a considerable part of the shortest edge. `Mesh(origin=)`
        helps if the mesh lies far from the origin."""
        return self._inside.has_coarse_coordinates

    @property
    def bounds(self) -> _arrays.Doubles:
        """The least and the largest coordinates, (2, 3)."""
        return np.asarray(self._inside.bounds + self._origin)

    @property
    def area(self) -> float:
        """Of the surface. O(n)."""
        corners = self.vertices.astype(np.float64)[self.faces]
        across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        return float(0.5 * np.linalg.norm(across, axis=1).sum())

    @property
    def volume(self) -> float:
        """Of what the surface bounds. Of an open mesh a sum that may mean nothing. O(n) once."""
        return float(self._object().mass["volume"])

    @property
    def centre_mass(self) -> _arrays.Doubles:
        """Of the same, of one density: (3,)."""
        return np.asarray(self._object().mass["centre"] + self._origin)

    @property
    def inertia(self) -> _arrays.Doubles:
        """Of the same, of density 1, about `centre_mass`: (3, 3)."""
        return np.asarray(self._object().mass["inertia"])

    def _object(self) -> _core.Object:
        """The mesh as what can be asked: prepared once, in no time."""
        if self._linear is None:
            self._linear = _core.prepare(self._inside, "linear", 1, 1, 1)
        return self._linear

    def __repr__(self) -> str:
        if self._inside.triangle_count == 0:
            return "<kerf.Mesh: empty>"
        size = " x ".join(f"{length:.4g}" for length in np.diff(self._inside.bounds, axis=0)[0])
        closed = "closed" if self.is_closed else "open"
        return f"<kerf.Mesh: {self._inside.triangle_count} triangles, {size}, {closed}>"

    @staticmethod
    def from_trimesh(mesh: Any, **options: Any) -> Mesh:
        """A mesh of what has `vertices` and `faces`, and may have `visual.uv` and `vertex_attributes`, as a
        trimesh.Trimesh has. `options` are those of `Mesh`."""
        return Mesh(**{**_exchange.from_trimesh(mesh), **options})

    @staticmethod
    def from_pyvista(mesh: Any, **options: Any) -> Mesh:
        """A mesh of what has `points`, `faces` and may have `point_data`, as a pyvista.PolyData of triangles has."""
        return Mesh(**{**_exchange.from_pyvista(mesh), **options})

    def to_trimesh(self) -> Any:
        """A trimesh.Trimesh, with `face_index` and `is_cap` as face attributes. Needs trimesh."""
        return _exchange.to_trimesh(self)

    def to_pyvista(self) -> Any:
        """A pyvista.PolyData with normals, attributes, `face_index` and `is_cap`. Needs PyVista."""
        return _exchange.to_pyvista(self)

    def prepare(
        self,
        *,
        cuts_expected: int = 1000,
        back_end: Optional[str] = None,
        cuts_with_room: int = 1,
        threads: int = 0,
    ) -> Object:
        """The mesh as an object that many cuts and sections can be made of: then each costs what its section costs.

        Takes O(n), some 100 ns a triangle. The mesh stays as it is.

        :param cuts_expected: how many times the object and its pieces will be cut, about; decides on the back end
        :param back_end: 'halfedge', 'linear', or another one of `back_ends()`
        :param cuts_with_room: for how many cuts memory is held ready
        :param threads: 0: as many as the processor has

        >>> rock = kerf.shape("asteroid", 20_000).prepare()
        >>> top, bottom = kerf.cut(rock, origin=(0, 0, 0), normal=(1, 2, 3))
        >>> top.back_end
        'halfedge'
        """
        from ._object import Object

        if back_end is not None and back_end not in _core.back_ends():
            raise ValueError(f"there is no back end '{back_end}': it is one of {', '.join(_core.back_ends())}")
        core = _core.prepare(
            self._inside,
            back_end,
            _arrays.count("cuts_expected", cuts_expected),
            _arrays.count("cuts_with_room", cuts_with_room, 1_000_000),
            _arrays.count("threads", threads),
        )
        return Object(core, self._origin, self._input)


def look(material: Any) -> Tuple[str, Tuple[float, float, float, float], str]:
    """A name, or a Material."""
    if isinstance(material, str):
        material = Material(material)
    if not isinstance(material, tuple) or not 1 <= len(material) <= 3:
        raise ValueError(f"materials: names or kerf.Material expected, got {material!r}")
    name, colour, image = Material(*material)
    numbers = _arrays.numbers("base_colour", colour, "red, green, blue and alpha")
    if numbers.shape != (4,):
        _arrays.refuse("base_colour", "red, green, blue and alpha", numbers)
    red, green, blue, alpha = (float(number) for number in numbers)
    return _arrays.text("materials", name), (red, green, blue, alpha), _arrays.text("base_colour_image", image)


def _face_material(values: npt.ArrayLike, count: int) -> _arrays.Indices:
    expected = f"({count},) numbers of materials"
    array = _arrays.numbers("face_material", values, expected)
    if array.shape != (count,) or array.dtype.kind not in "iu":
        _arrays.refuse("face_material", expected, array)
    if array.size > 0 and not 0 <= array.min() <= array.max() < 2**32 - 1:
        raise ValueError(f"face_material: {expected} expected, got {array.min()} to {array.max()}")
    return np.ascontiguousarray(array, dtype=np.uint32)


def _as_input(core: _core.Mesh) -> _Input:
    """The mesh itself as what it came from, with its triangles where `face_index` says."""
    sources = core.sources
    faces = np.zeros((int(sources.max(initial=-1)) + 1, 3), dtype=np.uint32)
    faces[sources[sources >= 0]] = core.indices[sources >= 0]
    return np.array(core.positions), faces
