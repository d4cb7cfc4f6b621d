"""Cuts, judged by NumPy."""

import kerf
import numpy as np
import pytest
from measures import half, is_closed, measures

# Closed meshes of different kinds: convex, with a hole through them, with concave sections, of a file.
MESHES = {
    "asteroid": lambda root: kerf.shape("asteroid", 2000),
    "torus": lambda root: kerf.shape("torus", 1000),
    "bowl": lambda root: kerf.shape("bowl", 1000),
    "rook": lambda root: kerf.read(root / "data/models/rook.obj"),
    "barrel": lambda root: kerf.read(root / "data/models/barrel.obj"),
}
CUTS = 20


def random_plane(mesh, random):
    """One that is likely to go through the mesh."""
    low, high = mesh.bounds
    return low + (high - low) * random.uniform(0.2, 0.8, 3), random.normal(size=3)


@pytest.mark.parametrize("prepared", [False, True], ids=["mesh", "object"])
@pytest.mark.parametrize("name", MESHES)
def test_both_halves_of_random_cuts_are_what_numpy_says(name, prepared, root, random):
    mesh = MESHES[name](root)
    size = np.diff(mesh.bounds, axis=0).max()
    whole = measures(mesh.vertices, mesh.faces)
    assert mesh.volume == pytest.approx(whole.volume, rel=1e-6)
    assert mesh.area == pytest.approx(whole.area, rel=1e-6)
    cut_through = 0
    for _ in range(CUTS):
        origin, normal = random_plane(mesh, random)
        cut = kerf.cut(mesh.prepare() if prepared else mesh, origin=origin, normal=normal)
        if not cut:
            assert cut.status == "missed"
            continue
        cut_through += 1
        for piece, towards in zip(cut, (normal, -normal)):
            expected = half(mesh.vertices, mesh.faces, origin, towards)
            piece_mesh = piece.mesh() if prepared else piece
            found = measures(piece_mesh.vertices, piece_mesh.faces)
            assert is_closed(piece_mesh.vertices, piece_mesh.faces)
            assert piece_mesh.is_closed
            assert found.volume == pytest.approx(expected.measures.volume, abs=2e-6 * size**3)
            assert piece.volume == pytest.approx(expected.measures.volume, abs=2e-6 * size**3)
            assert found.area == pytest.approx(expected.measures.area, abs=1e-5 * size**2)
            assert cut.area == pytest.approx(abs(expected.cap_area), abs=1e-5 * size**2)
            if expected.measures.volume > 1e-3 * size**3:
                np.testing.assert_allclose(found.centroid, expected.measures.centroid, atol=1e-4 * size)
                np.testing.assert_allclose(piece.centre_mass, expected.measures.centroid, atol=1e-4 * size)
    assert cut_through >= CUTS // 2


def test_real_meshes_are_cut_as_numpy_says(real_meshes, random):
    for name in ("spot.obj", "bob.obj"):
        mesh = kerf.read(real_meshes / name)
        size = np.diff(mesh.bounds, axis=0).max()
        for _ in range(3):
            origin, normal = random_plane(mesh, random)
            for piece, towards in zip(kerf.cut(mesh, origin=origin, normal=normal), (normal, -normal)):
                expected = half(mesh.vertices, mesh.faces, origin, towards)
                assert is_closed(piece.vertices, piece.faces)
                assert piece.volume == pytest.approx(expected.measures.volume, abs=2e-6 * size**3)


def test_attributes_are_interpolated_along_the_cut(rock, random):
    # What is linear in space is found exactly by linear interpolation, whatever the plane.
    towards = random.normal(size=(3, 4)).astype(np.float32)
    values = rock.vertices @ towards
    heat = values[:, 0]
    mesh = kerf.Mesh(rock.vertices, rock.faces, attributes={"values": values, "heat": heat}, uv=values[:, 1:3])
    for piece in kerf.cut(mesh, origin=(0.1, 0, 0), normal=(1, 2, 3)):
        expected = piece.vertices @ towards
        # Caps have the attributes of their outline, and uv of their own.
        np.testing.assert_allclose(piece.attributes["values"], expected, atol=1e-5)
        np.testing.assert_allclose(piece.attributes["heat"], expected[:, 0], atol=1e-5)
        surface = np.unique(piece.faces[~piece.is_cap])
        np.testing.assert_allclose(piece.uv[surface], expected[surface, 1:3], atol=1e-5)


def test_every_vertex_says_where_it_comes_from(rock):
    piece = kerf.cut(rock, origin=(0.1, 0, 0), normal=(1, 2, 3)).positive
    piece = kerf.cut(piece, origin=(0, 0.1, 0), normal=(0, 1, -1)).positive
    origin = piece.vertex_origin
    surface = np.unique(piece.faces[~piece.is_cap])
    assert (origin.vertices[surface, 0] >= 0).all()
    places = np.einsum("nk,nkc->nc", origin.weights, rock.vertices[origin.vertices])
    np.testing.assert_allclose(places[surface], piece.vertices[surface], atol=1e-6)


def test_every_triangle_says_which_face_it_is_a_part_of(rock):
    top = kerf.cut(rock, origin=(0.1, 0, 0), normal=(1, 2, 3)).positive
    again = kerf.cut(top, origin=(0, 0.1, 0), normal=(0, 1, -1)).positive
    assert ((again.face_index == -1) == again.is_cap).all()
    kept = again.faces[~again.is_cap]
    source = rock.vertices[rock.faces[again.face_index[~again.is_cap]]].astype(np.float64)
    normal = np.cross(source[:, 1] - source[:, 0], source[:, 2] - source[:, 0])
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    away = np.einsum("nkc,nc->nk", again.vertices[kept] - source[:, :1], normal)
    assert np.abs(away).max() < 1e-6


def test_a_plane_that_misses_leaves_all_on_its_side(box):
    cut = kerf.cut(box, origin=(0, 0, 5), normal="z")
    assert (cut.status, bool(cut)) == ("missed", False)
    assert cut.positive is None and cut.negative is box
    assert kerf.cut(box, origin=(0, 0, 5), normal="-z").positive is box
    object_ = box.prepare()
    assert kerf.cut(object_, origin=(0, 0, 5), normal="z").negative is object_
    assert not object_.is_gone and object_.triangle_count == 12
    assert kerf.cut(box, origin=(0, 0, 5), normal="z", components=True).negative == [box]


def test_an_object_that_was_cut_is_gone(box):
    object_ = box.prepare()
    kept = object_.copy()
    assert kerf.cut(object_, origin=(0, 0, 0), normal="z")
    assert object_.is_gone and repr(object_) == "<kerf.Object: was cut>"
    for use in (
        lambda: object_.mesh(),
        lambda: object_.volume,
        lambda: kerf.cut(object_, origin=(0, 0, 0), normal="z"),
        lambda: kerf.section(object_, origin=(0, 0, 0), normal="z"),
    ):
        with pytest.raises(ValueError, match="was cut"):
            use()
    assert kept.triangle_count == 12


def test_open_meshes_stay_open_and_say_so(box):
    lidless = kerf.Mesh(box.vertices, box.faces[box.normals[box.faces[:, 0], 2] < 0.5])
    cut = kerf.cut(lidless, origin=(0, 0, 0), normal="x")
    assert cut.status == kerf.Status.OPEN_SECTION and cut
    assert not cut.positive.is_closed


def test_components_are_lists(box):
    two = kerf.Mesh(
        np.concatenate([box.vertices, box.vertices + [5, 0, 0]]), np.concatenate([box.faces, box.faces + 24])
    )
    positive, negative = kerf.cut(two, origin=(0, 0, 0.5), normal="z", components=True)
    assert [piece.volume for piece in positive] == pytest.approx([2, 2])
    assert [piece.volume for piece in negative] == pytest.approx([6, 6])


def test_a_gap_takes_away_what_lies_in_it(box):
    positive, negative = kerf.cut(box, origin=(0, 0, 0), normal="z", gap=0.5)
    assert positive.volume == pytest.approx(4 * 0.75) and negative.volume == pytest.approx(4 * 0.75)


def test_only_cuts_one_of_two_legs(box):
    comb = kerf.Mesh(
        np.concatenate([box.vertices, box.vertices + [5, 0, 0]]), np.concatenate([box.faces, box.faces + 24])
    )
    cut = kerf.cut(comb, origin=(0, 0, 0), normal="z", only=(5, 0, 0))
    assert cut.positive.volume == pytest.approx(4)
    assert cut.negative.volume == pytest.approx(12)


def test_no_cap_leaves_a_hole(box):
    top = kerf.cut(box, origin=(0, 0, 0), normal="z", cap=False).positive
    assert not top.is_closed and not top.is_cap.any()


def test_caps_have_the_material_that_is_asked_for(box):
    mesh = kerf.Mesh(box.vertices, box.faces, materials=["rind", kerf.Material("flesh", (1, 0, 0, 1))])
    top = kerf.cut(mesh, origin=(0, 0, 0), normal="z", cap_material=1).positive
    assert [material.name for material in top.materials][:2] == ["rind", "flesh"]
    assert set(top.face_material[top.is_cap]) == {1} and set(top.face_material[~top.is_cap]) == {0}
    added = kerf.cut(mesh, origin=(0, 0, 0), normal="z").positive
    assert added.materials[added.face_material[added.is_cap][0]].name == "cap"


def test_a_transform_places_the_mesh_in_the_world(box, random):
    placed = np.eye(4)
    placed[:3, :3] = random.normal(size=(3, 3))
    placed[:3, 3] = (10, 20, 30)
    in_world = kerf.Mesh(box.vertices @ placed[:3, :3].T + placed[:3, 3], box.faces)
    origin, normal = (10.1, 20, 30), random.normal(size=3)
    here = kerf.cut(box, origin=origin, normal=normal, transform=placed)
    there = kerf.cut(in_world, origin=origin, normal=normal)
    scale = abs(np.linalg.det(placed[:3, :3]))
    for a, b in zip(here, there):
        assert a.volume * scale == pytest.approx(b.volume, rel=1e-4)
    section = kerf.section(box, origin=origin, normal=normal, transform=placed)
    for points in section.loops:
        away = (points @ placed[:3, :3].T + placed[:3, 3] - origin) @ (normal / np.linalg.norm(normal))
        assert np.abs(away).max() < 1e-5


def test_dice_fill_the_whole(rock):
    pieces = kerf.dice(rock, x=[-0.3, 0.4], y=[0.1], planes=[((1, 1, 1), [0.2])])
    assert pieces.status == "done"
    assert sum(piece.mesh.volume for piece in pieces) == pytest.approx(rock.volume, rel=1e-6)
    for mesh, cell in pieces:
        assert is_closed(mesh.vertices, mesh.faces)
        low, high = mesh.bounds[:, 0]
        edges = [-np.inf, -0.3, 0.4, np.inf]
        assert edges[cell[0]] - 1e-6 <= low and high <= edges[cell[0] + 1] + 1e-6
    objects = kerf.dice(rock.prepare(), x=[-0.3, 0.4], y=[0.1], planes=[((1, 1, 1), [0.2])])
    assert [piece.cell for piece in objects] == [piece.cell for piece in pieces]
    assert isinstance(objects[0].mesh, kerf.Object)
