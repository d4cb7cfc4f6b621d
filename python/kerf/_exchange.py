"""Meshes of other packages, which are not imported unless one of theirs is asked for."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any, Dict

import numpy as np

if TYPE_CHECKING:
    from ._mesh import Mesh


def from_trimesh(mesh: Any) -> Dict[str, Any]:
    arguments: Dict[str, Any] = {"vertices": np.asarray(mesh.vertices), "faces": np.asarray(mesh.faces)}
    uv = getattr(getattr(mesh, "visual", None), "uv", None)
    if uv is not None and np.shape(uv) == (len(arguments["vertices"]), 2):
        arguments["uv"] = uv
    arguments["attributes"] = _numbers(getattr(mesh, "vertex_attributes", {}), len(arguments["vertices"]))
    return arguments


def from_pyvista(mesh: Any) -> Dict[str, Any]:
    counted = np.asarray(mesh.faces)
    if counted.size % 4 != 0 or not (counted.reshape(-1, 4)[:, 0] == 3).all():
        raise ValueError("a mesh of triangles expected: call its triangulate() first")
    points = np.asarray(mesh.points)
    attributes = dict(_numbers(getattr(mesh, "point_data", {}), len(points)))
    arguments: Dict[str, Any] = {"vertices": points, "faces": counted.reshape(-1, 4)[:, 1:], "attributes": attributes}
    normals = attributes.pop("Normals", None)
    if normals is not None:
        arguments["normals"] = normals
    return arguments


def _numbers(attributes: Any, count: int) -> Dict[str, Any]:
    """Those that a cut can interpolate."""
    kept = {}
    for name in attributes.keys() if attributes is not None else ():
        values = np.asarray(attributes[name])
        if values.dtype.kind in "fiub" and values.ndim in (1, 2) and len(values) == count:
            if values.ndim == 1 or 1 <= values.shape[1] <= 16:
                kept[str(name)] = values.astype(np.float32)
    return kept


def to_trimesh(mesh: Mesh) -> Any:
    package = _package("trimesh", "to_trimesh")
    made = package.Trimesh(
        vertices=mesh.vertices + mesh.origin,
        faces=np.array(mesh.faces, dtype=np.int64),
        vertex_normals=np.array(mesh.normals),
        vertex_attributes={name: np.array(values) for name, values in mesh.attributes.items()},
        face_attributes={"face_index": np.array(mesh.face_index), "is_cap": np.array(mesh.is_cap)},
        process=False,
    )
    if mesh.uv.any():
        made.visual = package.visual.TextureVisuals(uv=np.array(mesh.uv))
    return made


def to_pyvista(mesh: Mesh) -> Any:
    package = _package("pyvista", "to_pyvista")
    counted = np.full((len(mesh.faces), 4), 3, dtype=np.int64)
    counted[:, 1:] = mesh.faces
    made = package.PolyData(mesh.vertices + mesh.origin, counted.ravel())
    made.point_data["Normals"] = np.array(mesh.normals)
    if mesh.uv.any():
        made.point_data["Texture Coordinates"] = np.array(mesh.uv)
    for name, values in mesh.attributes.items():
        made.point_data[name] = np.array(values)
    made.cell_data["face_index"] = np.array(mesh.face_index)
    made.cell_data["is_cap"] = np.array(mesh.is_cap)
    return made


def _package(name: str, caller: str) -> Any:
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise ImportError(f"{caller}() makes an object of the package {name}, which is not installed") from error
