"""Files, by name and open."""

import io

import kerf
import numpy as np
import pytest


@pytest.mark.parametrize("format", kerf.writable_formats())
def test_what_is_written_reads_back(format, tmp_path, rock):
    kerf.write(tmp_path / f"rock.{format}", rock)
    again = kerf.read(str(tmp_path / f"rock.{format}"))
    assert len(again.faces) == len(rock.faces)
    assert again.volume == pytest.approx(rock.volume, rel=1e-6)
    file = io.BytesIO()
    kerf.write(file, rock, format=format)
    file.seek(0)
    assert kerf.read(file, format=format).volume == pytest.approx(rock.volume, rel=1e-6)


def test_ply_keeps_attributes(tmp_path, rock):
    mesh = kerf.Mesh(rock.vertices, rock.faces, attributes={"heat": rock.vertices[:, 0]})
    kerf.write(tmp_path / "rock.ply", mesh)
    again = kerf.read(tmp_path / "rock.ply")
    np.testing.assert_allclose(again.attributes["heat"], again.vertices[:, 0])


def test_pieces_of_a_file_say_which_of_its_vertices_they_come_from(root):
    rook = kerf.read(root / "data/models/rook.obj")
    piece = kerf.cut(rook, origin=rook.centre_mass, normal=(1, 2, 3)).positive
    origin = piece.vertex_origin
    surface = np.unique(piece.faces[~piece.is_cap])
    places = np.einsum("nk,nkc->nc", origin.weights, rook.vertices[origin.vertices])
    np.testing.assert_allclose(places[surface], piece.vertices[surface], atol=1e-6)


def test_faults_name_the_file(tmp_path, box):
    with pytest.raises(FileNotFoundError, match="nowhere.obj"):
        kerf.read(tmp_path / "nowhere.obj")
    (tmp_path / "bad.stl").write_bytes(b"solid nonsense")
    with pytest.raises(kerf.FileError, match="bad.stl"):
        kerf.read(tmp_path / "bad.stl")
    with pytest.raises(OSError):
        kerf.read(tmp_path / "bad.stl")
    with pytest.raises(kerf.FileError, match="out.xyz"):
        kerf.write(tmp_path / "out.xyz", box)
    with pytest.raises(kerf.FileError):
        kerf.write(tmp_path / "no" / "folder.obj", box)
    with pytest.raises(ValueError, match="format"):
        kerf.write(io.BytesIO(), box)
    assert not list(tmp_path.glob("out*"))


def test_the_report_of_a_file(tmp_path, box):
    lines = [f"v {x} {y} {z}" for x, y, z in box.vertices] + [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in box.faces]
    (tmp_path / "box.obj").write_text("\n".join([*lines, "f 1 1 2"]))
    report = kerf.read(tmp_path / "box.obj").report
    assert report.repairs["degenerate_triangles"] == 1
