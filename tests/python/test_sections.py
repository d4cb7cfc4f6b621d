"""Sections: loops, nesting, stacks, drawings."""

import xml.etree.ElementTree

import kerf
import numpy as np
import pytest


def shoelace(points):
    x, y = points.T
    return 0.5 * (x @ np.roll(y, -1) - y @ np.roll(x, -1))


def test_polygons_with_holes_have_the_sections_area(random):
    for name in ("torus", "bowl", "menger_sponge", "nested_spheres"):
        mesh = kerf.shape(name, 3000)
        low, high = mesh.bounds
        for _ in range(10):
            origin, normal = low + (high - low) * random.uniform(0.2, 0.8, 3), random.normal(size=3)
            section = kerf.section(mesh, origin=origin, normal=normal)
            area = 0.0
            for outer, holes in section.polygons():
                assert shoelace(outer) > 0
                assert all(shoelace(hole) < 0 for hole in holes)
                area += shoelace(outer) + sum(shoelace(hole) for hole in holes)
            assert area == pytest.approx(section.area, abs=1e-6)
            cut = kerf.cut(mesh, origin=origin, normal=normal)
            assert section.area == cut.area


def test_loops_lie_in_the_plane_and_on_their_faces(rock, random):
    normal = random.normal(size=3)
    normal /= np.linalg.norm(normal)
    section = kerf.section(rock, origin=(0.1, 0, 0), normal=normal)
    for path in section.paths:
        assert np.abs((path.points - [0.1, 0, 0]) @ normal).max() < 1e-6
        corners = rock.vertices[rock.faces[path.face_index]].astype(np.float64)
        across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        across /= np.linalg.norm(across, axis=1)[:, None]
        for ends in (path.points, np.roll(path.points, -1, axis=0)):
            assert np.abs(np.einsum("nk,nk->n", ends - corners[:, 0], across)).max() < 1e-6
        assert path.length == pytest.approx(
            np.linalg.norm(path.points - np.roll(path.points, -1, axis=0), axis=1).sum(), rel=1e-6
        )


def test_triangles_fill_the_section():
    torus = kerf.shape("torus", 3000)
    section = kerf.section(torus, origin=(0, 0, 0.05), normal="z", fill=True)
    corners = section.points[section.triangles].astype(np.float64)
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert 0.5 * across[:, 2].sum() == pytest.approx(section.area, rel=1e-6)
    assert len(kerf.section(torus, origin=(0, 0, 0.05), normal="z").triangles) == 0


def test_attributes_along_the_outline(rock):
    mesh = kerf.Mesh(rock.vertices, rock.faces, attributes={"place": rock.vertices})
    path = kerf.section(mesh, origin=(0.1, 0, 0), normal="x", attributes=True).paths[0]
    ends = np.stack([path.points, np.roll(path.points, -1, axis=0)], axis=1).reshape(-1, 3)
    np.testing.assert_allclose(path.end_attributes["place"], ends, atol=1e-6)
    np.testing.assert_allclose(np.linalg.norm(path.end_normals, axis=1), 1, atol=1e-5)


def test_a_stack_is_what_single_sections_are(rock):
    heights = [0.3, -0.2, 0.0, 9.0]
    for asked in (rock, rock.prepare()):
        stack = kerf.sections(asked, origin=(0, 0, 0.05), normal=(0, 0, 2), heights=heights)
        assert len(stack) == 4 and not stack[3] and stack[-1].status == "missed"
        for height, section in zip(heights, stack):
            single = kerf.section(rock, origin=(0, 0, 0.05 + height), normal="z")
            assert section.area == pytest.approx(single.area, rel=1e-6)
            assert [len(loop) for loop in section.loops] == [len(loop) for loop in single.loops]
        assert len(stack[1:3]) == 2
        with pytest.raises(IndexError):
            stack[4]


def test_many_heights_of_a_mesh_that_was_not_prepared(rock):
    heights = np.linspace(*rock.bounds[:, 2], 500)
    areas = [section.area for section in kerf.sections(rock, normal="z", heights=heights)]
    assert np.trapz(areas, heights) == pytest.approx(rock.volume, rel=1e-3)


def test_open_meshes_have_chains(box):
    lidless = kerf.Mesh(box.vertices, box.faces[box.normals[box.faces[:, 0], 2] < 0.5])
    section = kerf.section(lidless, origin=(0, 0, 0), normal="x")
    assert section.status == "open_section" and len(section.chains) == 1 and not section.loops
    assert "1 chain" in repr(section)
    path = section.paths[0]
    assert len(path.face_index) == len(path.points) - 1 and not path.is_closed


def test_drawings(tmp_path, box):
    section = kerf.section(box, origin=(0, 0, 0), normal="z")
    root = xml.etree.ElementTree.fromstring(section.to_svg(unit="cm"))
    assert root.get("width").endswith("mm") and float(root.get("width")[:-2]) >= 20
    for name in ("a.svg", "a.dxf", "a.obj"):
        section.write(tmp_path / name)
        assert (tmp_path / name).stat().st_size > 100
    kerf.sections(box, normal="z", heights=[0, 0.5]).write(tmp_path / "stack.svg")
    assert (tmp_path / "stack.svg").read_text().count("<g") >= 2
    with pytest.raises(kerf.FileError, match="a.png"):
        section.write(tmp_path / "a.png")
    with pytest.raises(ValueError, match="unit"):
        section.to_svg(unit="parsec")
    assert section._repr_svg_() == section.to_svg()
    assert kerf.section(box, origin=(0, 0, 9), normal="z")._repr_svg_() is None


def test_up_turns_the_frame(box):
    frame = kerf.section(box, origin=(0, 0, 0), normal="z", up="x").frame
    np.testing.assert_allclose(frame.y, [1, 0, 0])
    np.testing.assert_allclose(np.cross(frame.x, frame.y), frame.normal, atol=1e-12)
