"""What comes in, and what comes out: arrays."""

import gc
import io

import kerf
import numpy as np
import pytest
from meshes import box as make_box

ARRAYS = ("vertices", "faces", "normals", "uv", "vertex_point", "face_index", "is_cap", "face_material", "face_solid")


def test_views_are_read_only_and_not_copied(rock):
    for name in ARRAYS:
        array = getattr(rock, name)
        assert not array.flags.writeable and not array.flags.owndata, name
        again = getattr(rock, name)
        assert array.__array_interface__["data"][0] == again.__array_interface__["data"][0], name
        with pytest.raises(ValueError):
            array[0] = 0


def test_views_outlive_what_they_show():
    def views():
        mesh = kerf.shape("asteroid", 3000)
        mesh = kerf.Mesh(mesh.vertices, mesh.faces, attributes={"height": mesh.vertices[:, 2]})
        piece = kerf.cut(mesh, origin=(0, 0, 0), normal="z").positive
        section = kerf.section(mesh.prepare(), origin=(0, 0, 0), normal="x", fill=True, attributes=True)
        found = {name: getattr(piece, name) for name in ARRAYS}
        found.update(piece.attributes)
        path = section.paths[0]
        found.update(points=path.points, sources=path.face_index, ends=path.end_normals, triangles=section.triangles)
        found.update(path.end_attributes)
        found["stack"] = kerf.sections(mesh, normal="z", heights=[0, 0.1])[1].loops[0]
        found["origin"] = piece.vertex_origin.weights
        return found, {name: np.array(array) for name, array in found.items()}

    found, copies = views()
    gc.collect()
    # Memory that was let go of would be written to by these.
    others = [kerf.cut(kerf.shape("asteroid", 3000, seed=i), origin=(0, 0, 0), normal="x") for i in range(20)]
    assert others
    for name, array in found.items():
        np.testing.assert_array_equal(array, copies[name], err_msg=name)


@pytest.mark.parametrize("vertex_type", ["f2", "f4", "f8", ">f8", "i8"])
@pytest.mark.parametrize("face_type", ["u4", "i4", "i8", "u8", "u1"])
def test_types_that_hold_the_numbers_are_taken(vertex_type, face_type):
    box = make_box()
    mesh = kerf.Mesh(box.vertices.astype(vertex_type), box.faces.astype(face_type))
    assert mesh.volume == 8 and mesh.vertices.dtype == np.float32 and mesh.faces.dtype == np.uint32


def test_lists_and_strided_arrays_are_taken(box):
    assert kerf.Mesh(box.vertices.tolist(), box.faces.tolist()).volume == 8
    assert kerf.Mesh(np.asfortranarray(box.vertices), np.asfortranarray(box.faces)).volume == 8
    padded = np.zeros((len(box.vertices), 7), dtype=np.float32)
    padded[:, 2:5] = box.vertices
    assert kerf.Mesh(padded[:, 2:5], box.faces[::-1]).volume == 8


def test_the_report_says_how_far_rounding_moves_vertices(box):
    assert kerf.Mesh(box.vertices, box.faces).report.rounding == 0
    vertices = box.vertices.astype(np.float64) / 3
    mesh = kerf.Mesh(vertices, box.faces)
    moved = np.linalg.norm(vertices - vertices.astype(np.float32), axis=1).max()
    assert mesh.report.rounding == pytest.approx(moved) and moved > 0


def test_far_meshes_are_moved_before_they_are_rounded(random):
    rock = kerf.shape("asteroid", 2000)
    far = np.array([4.5e5, 5.4e6, 123.456])
    vertices = rock.vertices.astype(np.float64) + far
    coarse = kerf.Mesh(vertices, rock.faces)
    assert coarse.has_coarse_coordinates and coarse.report.rounding > 0.01
    mesh = kerf.Mesh(vertices, rock.faces, origin=far)
    assert not mesh.has_coarse_coordinates and mesh.report.rounding < 1e-6
    np.testing.assert_allclose(mesh.bounds, rock.bounds + far, rtol=1e-12, atol=1e-6)
    np.testing.assert_allclose(mesh.centre_mass, rock.centre_mass + far, atol=1e-6)

    # Planes are the caller's, and so are all answers in double precision.
    normal = random.normal(size=3)
    here, there = (kerf.cut(m, origin=o, normal=normal) for m, o in ((rock, (0.1, 0, 0)), (mesh, far + (0.1, 0, 0))))
    for a, b in zip(here, there):
        assert a.volume == pytest.approx(b.volume, rel=1e-5)
        np.testing.assert_allclose(a.centre_mass + far, b.centre_mass, atol=1e-5)
        np.testing.assert_array_equal(b.origin, far)
    section = kerf.section(mesh, origin=far + (0.1, 0, 0), normal=normal)
    assert section.area == pytest.approx(here.area, rel=1e-5)
    places = section.loops[0] + section.origin
    away = (places - far - (0.1, 0, 0)) @ (normal / np.linalg.norm(normal))
    assert np.abs(away).max() < 1e-6
    np.testing.assert_allclose(section.frame.to_3d(section.polygons()[0].outer), places, atol=1e-6)
    stack = kerf.sections(mesh, origin=far, normal="z", heights=[0.1])
    assert stack[0].area == pytest.approx(kerf.section(rock, origin=(0, 0, 0.1), normal="z").area, rel=1e-5)
    pieces = kerf.dice(mesh, x=[far[0]])
    assert sum(piece.mesh.volume for piece in pieces) == pytest.approx(rock.volume, rel=1e-5)
    shift = np.eye(4)
    shift[:3, 3] = -far
    back = kerf.cut(mesh, origin=(0.1, 0, 0), normal=normal, transform=shift)
    assert back.positive.volume == pytest.approx(here.positive.volume, rel=1e-5)


def test_what_was_given_may_change_afterwards(box):
    vertices, faces = np.array(box.vertices), np.array(box.faces)
    mesh = kerf.Mesh(vertices, faces)
    vertices[:] = 0
    faces[:] = 0
    assert mesh.volume == 8
    assert (mesh.vertex_origin.weights.sum(axis=1) == 1).all()


def test_attributes_that_are_no_numbers_are_counted(box):
    heat = np.arange(24.0)
    heat[:3] = np.nan, np.inf, 1e39
    mesh = kerf.Mesh(box.vertices, box.faces, attributes={"heat": heat, "fine": np.arange(24)})
    assert mesh.report.zeroed_attributes == {"heat": 3}
    assert not mesh.attributes["heat"][:3].any()


def test_the_report_is_of_what_was_given(box):
    uv, normals = np.full((24, 2), np.nan, dtype=np.float32), np.array(box.normals)
    mesh = kerf.Mesh(box.vertices, box.faces, uv=uv, normals=normals)
    uv[:], normals[:] = 0, np.nan
    assert mesh.report.repairs["replaced_attributes"] == 24


def test_the_origin_stays(box):
    mesh = kerf.Mesh(box.vertices, box.faces, origin=(0, 0, 0.5))
    mesh.origin[:] = 100
    assert mesh.bounds[1, 2] == 1 and kerf.cut(mesh, origin=(0, 0, 0), normal="z").positive.origin[2] == 0.5


def test_repairs_are_reported(box):
    faces = np.concatenate([box.faces, box.faces[:1], [[0, 0, 1]]])
    report = kerf.Mesh(box.vertices, faces).report
    assert report.facts["triangles"] == 14
    assert report.repairs["degenerate_triangles"] == 1 and report.repairs["duplicate_triangles"] == 1
    assert "dropped" in report.repairs_text
    assert kerf.cut(box, origin=(0, 0, 0), normal="z").positive.report is None


BOX = make_box()


@pytest.mark.parametrize(
    "make, sentence",
    [
        (lambda: kerf.Mesh(BOX.vertices[:, :2], BOX.faces), r"vertices: an array \(n, 3\) expected, got 24 x 2"),
        (lambda: kerf.Mesh(BOX.vertices, BOX.faces[:, :2]), r"faces: an array \(m, 3\)"),
        (lambda: kerf.Mesh(BOX.vertices, BOX.faces.astype(float)), r"whole numbers"),
        (lambda: kerf.Mesh(BOX.vertices, [[0, 1, -1]]), r"row 0 names vertex -1, but there are 24 vertices"),
        (lambda: kerf.Mesh(BOX.vertices, [[0, 1, 24]]), r"row 0 names vertex 24"),
        (lambda: kerf.Mesh(BOX.vertices, np.array([[0, 1, 24]], dtype=np.uint32)), r"24"),
        (lambda: kerf.Mesh(BOX.vertices, np.array([[0, 1, 2**63]], dtype=np.uint64)), r"9223372036854775808"),
        (lambda: kerf.Mesh([], []), r"no positions"),
        (lambda: kerf.Mesh(BOX.vertices * np.nan, BOX.faces), r"finite"),
        (lambda: kerf.Mesh(BOX.vertices.astype(float) * 1e300, BOX.faces), r"finite"),
        (lambda: kerf.Mesh(["a"], BOX.faces), r"vertices"),
        (lambda: kerf.Mesh(BOX.vertices * 1j, BOX.faces), r"vertices: .* complex64"),
        (lambda: kerf.Mesh(BOX.vertices, BOX.faces, normals=BOX.normals[1:]), r"normals: .*\(24, 3\)"),
        (lambda: kerf.Mesh(BOX.vertices, BOX.faces, uv=BOX.normals), r"uv: .*\(24, 2\)"),
        (lambda: kerf.Mesh(BOX.vertices, BOX.faces, attributes={"heat": [1, 2]}), r"attribute 'heat'"),
        (lambda: kerf.Mesh(BOX.vertices, BOX.faces, face_material=[0]), r"face_material"),
        (lambda: kerf.Mesh(BOX.vertices, BOX.faces, face_material=[-1] * 12), r"face_material"),
        (lambda: kerf.Mesh(BOX.vertices, BOX.faces, origin=(0, 0)), r"origin: three numbers"),
        (lambda: kerf.cut(BOX, origin=(0, 0, 0), normal="w"), r"normal: 'x', '-x'"),
        (lambda: kerf.cut(BOX, origin=(0, 0, 0), normal=""), r"normal"),
        (lambda: kerf.cut(BOX, origin=(0, 0, 0), normal=(0, 0, 0)), r"normal: a direction"),
        (lambda: kerf.cut(BOX, origin=(0, 0, np.inf), normal="z"), r"origin: three finite numbers"),
        (lambda: kerf.cut(BOX, origin=(0, 0, 0), normal="z", gap=-1), r"gap"),
        (lambda: kerf.cut(BOX, origin=(0, 0, 0), normal="z", transform=np.zeros((4, 4))), r"transform"),
        (lambda: kerf.cut(BOX, origin=(0, 0, 0), normal="z", transform=np.eye(3)), r"transform: a 4x4 matrix"),
        (lambda: kerf.cut(BOX, origin=(0, 0, 0), normal="z", cap_quality="best"), r"cap_quality"),
        (lambda: kerf.cut(BOX, origin=(0, 0, 0), normal="z", only=(0, 0, 0), gap=1), r"."),
        (lambda: kerf.cut("box", origin=(0, 0, 0), normal="z"), r"a kerf.Mesh or a kerf.Object expected, got str"),
        (lambda: kerf.sections(BOX, normal="z", heights=[np.nan]), r"heights: finite"),
        (lambda: kerf.dice(BOX, x=[[1, 2]]), r"heights"),
        (lambda: kerf.shape("teapot"), r"teapot"),
        (lambda: BOX.prepare(back_end="magic"), r"magic"),
        (lambda: BOX.prepare(threads=-1), r"threads"),
        (lambda: kerf.section(BOX, origin=(0, 0, 0), normal="z", up=(0, 0, 0)), r"up"),
        (lambda: kerf.Mesh(BOX.vertices, BOX.faces, attributes={1: BOX.normals}), r"attributes: a text"),
        (lambda: kerf.Mesh(BOX.vertices, BOX.faces, attributes={"\ud800": BOX.normals}), r"attributes: a text"),
        (lambda: kerf.Mesh(BOX.vertices, BOX.faces, attributes={"a\0b": BOX.normals}), r"attributes: a text"),
        (lambda: kerf.Mesh(BOX.vertices, BOX.faces, attributes=[1, 2]), r"attributes: names and arrays"),
        (lambda: kerf.Mesh(BOX.vertices, BOX.faces, materials=[3]), r"materials: names"),
        (lambda: kerf.Mesh(BOX.vertices, BOX.faces, materials=[kerf.Material("a", (1, 2))]), r"base_colour"),
        (lambda: kerf.Mesh(BOX.vertices, BOX.faces, crease_degrees="a"), r"crease_degrees: a number"),
        (lambda: kerf.Mesh(np.ma.masked_greater(BOX.vertices, 0), BOX.faces), r"masked"),
        (lambda: kerf.Mesh(np.full((3, 3), 2**62 + 1), [[0, 1, 2]]), r"2\^53"),
        (lambda: kerf.Mesh([[0, 0], [1]], BOX.faces), r"vertices"),
        (lambda: kerf.cut(BOX, origin=(0, 0, 0), normal="z", cap_material=5), r"cap_material"),
        (lambda: kerf.cut(BOX, origin=(0, 0, 0), normal="z", cap_material="a"), r"cap_material"),
        (lambda: kerf.cut(BOX, origin=(0, 0, 0), normal="z", gap="1"), r"gap: a number"),
        (lambda: kerf.sections(BOX, normal="z", heights=[0], threads=-1), r"threads"),
        (lambda: kerf.sections(BOX, normal="z", heights=[0], threads=1.5), r"threads"),
        (lambda: kerf.dice(BOX, planes=3), r"planes"),
        (lambda: kerf.dice(BOX, planes=[1]), r"planes"),
        (lambda: kerf.shape("torus", "a"), r"triangles"),
        (lambda: kerf.shape("torus", 10**12), r"triangles"),
        (lambda: kerf.section(BOX, origin=(0, 0, 0), normal="z").to_svg(unit=None), r"unit"),
        (lambda: BOX.prepare(cuts_with_room=2**31), r"cuts_with_room"),
        (lambda: BOX.prepare().add_material(3), r"materials: names"),
        (lambda: kerf.read(io.StringIO("solid"), format="stl"), r"open for bytes"),
        (lambda: kerf.read(io.BytesIO(b""), format=3), r"format"),
    ],
)
def test_misuse_raises_value_error_with_a_sentence(make, sentence):
    with pytest.raises(ValueError, match=sentence):
        make()


def test_planes_are_named():
    with pytest.raises(TypeError):
        kerf.cut(BOX, (0, 0, 0), "z")
    with pytest.raises(TypeError):
        kerf.section(BOX, (0, 0, 0), "z")


def test_status_words_are_those_of_the_library():
    assert [status.value.replace("_", " ") for status in kerf.Status] == kerf._core.status_names()
    assert kerf.Status.MISSED == "missed" and str(kerf.Status.MISSED) == "missed"


def test_reprs_tell_something(box):
    assert repr(box) == "<kerf.Mesh: 12 triangles, 2 x 2 x 2, closed>"
    assert repr(box.prepare()) == "<kerf.Object: 12 triangles, 2 x 2 x 2, halfedge>"
    assert repr(kerf.cut(box, origin=(0, 0, 0), normal="z")) == "<kerf.Cut: done, area 4>"
    assert repr(kerf.section(box, origin=(0, 0, 0), normal="z")) == "<kerf.Section: done, 1 loop, area 4>"
    assert repr(kerf.section(box, origin=(0, 0, 9), normal="z")) == "<kerf.Section: missed>"
    assert repr(kerf.dice(box, x=[0])) == "<kerf.Dice: done, 2 pieces>"
