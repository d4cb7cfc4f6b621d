"""Mesh files."""

from __future__ import annotations

import errno
import os
from pathlib import Path
from typing import IO, Any, Dict, List, Optional, Tuple, Union

import numpy as np

from . import _core
from ._mesh import Mesh, Report

#: A name of a file, or an open one of bytes.
File = Union[str, "os.PathLike[str]", IO[bytes]]


def read(file: File, *, format: Optional[str] = None) -> Mesh:
    """Reads a mesh file and repairs the mesh: OBJ, PLY, STL, OFF, glTF or GLB, by the extension. `Mesh.report` says what
    was repaired.

    :param format: of an open file: 'stl', ...
    :raises FileNotFoundError: there is no such file
    :raises kerf.FileError: it can't be read, or holds no mesh

    >>> kerf.read("data/models/rook.obj")  # doctest: +SKIP
    <kerf.Mesh: 472 triangles, 1.041 x 2 x 1.041, closed>
    """
    if not hasattr(file, "read"):
        path = os.fspath(file)
        if format is not None and Path(path).suffix.lower() != f".{_known(format)}":
            return _read(_core.read_bytes(Path(path).read_bytes(), _known(format)))
        if not os.path.exists(path):
            raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), path)
        return _read(_core.read_file(path))
    content = file.read()
    if not isinstance(content, bytes):
        raise ValueError("file: one that is open for bytes expected, as by open(name, 'rb')")
    return _read(_core.read_bytes(content, _known(format)))


def _read(answer: Tuple[_core.Mesh, Tuple[Dict[str, Any], Dict[str, int], str], List[Tuple[str, int]]]) -> Mesh:
    core, report, notes = answer
    mesh = Mesh._of(core, np.zeros(3), None)
    mesh._report = Report(*report, notes=tuple(notes))
    return mesh


def write(file: File, mesh: Mesh, *, format: Optional[str] = None) -> None:
    """Writes OBJ, PLY, STL, OFF or GLB, by the extension. The file appears complete or not at all. Coordinates are
    `Mesh.vertices`: relative to the mesh's `origin`. PLY keeps attributes; OBJ and GLB keep materials.

    :param format: of an open file: 'stl', ...
    :raises kerf.FileError: it can't be written

    >>> import io
    >>> file = io.BytesIO()
    >>> kerf.write(file, kerf.shape("box", 12), format="stl")
    >>> len(file.getvalue())
    684
    """
    if not isinstance(mesh, Mesh):
        raise ValueError(f"a kerf.Mesh expected, got {type(mesh).__name__}")
    if not hasattr(file, "write"):
        path = os.fspath(file)
        if format is not None and Path(path).suffix.lower() != f".{_known(format)}":
            raise ValueError(f"format: '{format}' expected as the extension of {path}")
        _core.write_file(mesh._inside, path)
    else:
        file.write(_core.file_bytes(mesh._inside, _known(format)))


def _known(format: Optional[str]) -> str:
    if not isinstance(format, str):
        raise ValueError("format: one of 'obj', 'ply', 'stl', ... expected, for an open file")
    return format.lower().lstrip(".")


def readable_formats() -> List[str]:
    """Extensions of files that `read` knows.

    >>> kerf.readable_formats()
    ['obj', 'ply', 'stl', 'off', 'gltf', 'glb']
    """
    return _core.readable_formats()


def writable_formats() -> List[str]:
    """Extensions of files that `write` knows."""
    return _core.writable_formats()
