"""Cuts triangle meshes by planes: both halves, capped, with normals, uv, attributes and materials, in one call.

>>> import kerf
>>> mesh = kerf.shape("torus", 2000)
>>> top, bottom = kerf.cut(mesh, origin=(0, 0, 0), normal="z")
>>> top
<kerf.Mesh: 1204 triangles, 2.8 x 2.794 x 0.4, closed>
>>> section = kerf.section(mesh, origin=(0, 0, 0.1), normal=(0, 1, 1))
>>> print(section.to_svg()[:5])
<?xml

`cut`, `section`, `sections`, `dice` and `fracture` take a `Mesh`, or an `Object`: a mesh that was prepared for many of them
(`Mesh.prepare`). Planes are named by keywords: `origin`, `normal`. Numbers come back as NumPy arrays that are read-only,
not copied, and valid as long as you keep them. What you got wrong raises ValueError; what a mesh and a plane have to do
with one another is a `Status`.
"""

from ._breaking import Fracture, fracture
from ._core import FileError, bits_version
from ._core import version as _version
from ._cutting import Cut, cut
from ._dicing import Dice, Piece, dice
from ._files import read, readable_formats, writable_formats, write
from ._mesh import Material, Mesh, Report, VertexOrigin
from ._object import Object, back_ends
from ._sections import Frame, Path, Polygon, Section, SectionStack, section, sections
from ._shapes import shape, shape_names
from ._status import Status

__version__ = _version()

__all__ = [
    "Cut",
    "Dice",
    "FileError",
    "Fracture",
    "Frame",
    "Material",
    "Mesh",
    "Object",
    "Path",
    "Piece",
    "Polygon",
    "Report",
    "Section",
    "SectionStack",
    "Status",
    "VertexOrigin",
    "back_ends",
    "bits_version",
    "cut",
    "dice",
    "fracture",
    "read",
    "readable_formats",
    "section",
    "sections",
    "shape",
    "shape_names",
    "writable_formats",
    "write",
]
