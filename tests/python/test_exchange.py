"""Meshes of other packages, by what they look like. (Debian has neither trimesh nor PyVista: these are their shapes.)"""

import sys
import types

import kerf
import numpy as np
import pytest


class Trimesh:
    """What trimesh.Trimesh has and takes of it."""

    def __init__(self, vertices, faces, vertex_normals=None, vertex_attributes=None, face_attributes=None, process=True):
        assert vertices.dtype == np.float64 and faces.dtype == np.int64 and not process
        self.vertices, self.faces, self.vertex_normals = vertices, faces, vertex_normals
        self.vertex_attributes, self.face_attributes = vertex_attributes or {}, face_attributes or {}
        self.visual = types.SimpleNamespace()


class PolyData:
    """What pyvista.PolyData has and takes of it."""

    def __init__(self, points, faces):
        self.points, self.faces = points, faces
        self.point_data, self.cell_data = {}, {}


@pytest.fixture
def other_packages(monkeypatch):
    textures = types.SimpleNamespace(TextureVisuals=lambda uv: types.SimpleNamespace(uv=uv))
    monkeypatch.setitem(sys.modules, "trimesh", types.SimpleNamespace(Trimesh=Trimesh, visual=textures))
    monkeypatch.setitem(sys.modules, "pyvista", types.SimpleNamespace(PolyData=PolyData))


def painted(rock):
    return kerf.Mesh(
        rock.vertices, rock.faces, uv=rock.vertices[:, :2], attributes={"heat": rock.vertices[:, 0], "c": rock.normals}
    )


def test_to_trimesh_and_back(other_packages, rock):
    mesh = painted(rock)
    theirs = kerf.cut(mesh, origin=(0, 0, 0), normal="z").positive.to_trimesh()
    assert theirs.face_attributes["is_cap"].any() and theirs.face_attributes["face_index"].min() == -1
    ours = kerf.Mesh.from_trimesh(theirs)
    assert set(ours.attributes) == {"heat", "c"} and ours.uv.any()
    assert ours.volume == pytest.approx(kerf.cut(mesh, origin=(0, 0, 0), normal="z").positive.volume)


def test_to_pyvista_and_back(other_packages, rock):
    theirs = painted(rock).to_pyvista()
    assert theirs.faces.reshape(-1, 4)[:, 0].tolist() == [3] * len(rock.faces)
    ours = kerf.Mesh.from_pyvista(theirs)
    assert "heat" in ours.attributes and ours.volume == pytest.approx(rock.volume)
    np.testing.assert_allclose(ours.normals, painted(rock).normals, atol=1e-6)
    quads = PolyData(rock.vertices, np.array([4, 0, 1, 2, 3]))
    with pytest.raises(ValueError, match="triangulate"):
        kerf.Mesh.from_pyvista(quads)


def test_far_meshes_are_where_they_were(other_packages, rock):
    far = (1e6, 0, 0)
    mesh = kerf.Mesh(rock.vertices.astype(float) + far, rock.faces, origin=far)
    np.testing.assert_allclose(mesh.to_trimesh().vertices.mean(axis=0)[0], 1e6, atol=1)
    theirs = mesh.to_trimesh()
    assert kerf.Mesh.from_trimesh(theirs, origin=far).volume == pytest.approx(rock.volume, rel=1e-5)


@pytest.mark.parametrize("name", ["trimesh", "pyvista"])
def test_without_the_package_a_sentence(monkeypatch, box, name):
    monkeypatch.setitem(sys.modules, name, None)
    with pytest.raises(ImportError, match=f"package {name}, which is not installed"):
        getattr(box, f"to_{name}")()


def test_kerf_imports_neither():
    import subprocess

    subprocess.run(
        [sys.executable, "-c", "import kerf, sys; assert not {'trimesh', 'pyvista', 'vtk'} & set(sys.modules)"],
        check=True,
    )
