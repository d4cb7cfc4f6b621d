"""What was let go of is gone."""

import gc
import os

import kerf
import numpy as np

PAGE = os.sysconf("SC_PAGE_SIZE")


def resident_bytes():
    gc.collect()
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * PAGE


def cut_once(mesh, i):
    normal = (np.cos(i), np.sin(i), 0.3)
    cut = kerf.cut(mesh.prepare() if i % 4 == 0 else mesh, origin=(0.1, 0, 0), normal=normal)
    piece = cut.positive
    if isinstance(piece, kerf.Object):
        piece = piece.mesh()
    assert piece.vertices.shape[1] == 3 and piece.attributes["heat"].ndim == 1
    section = kerf.section(mesh, origin=(0.1, 0, 0), normal=normal, attributes=True, fill=True)
    assert section.paths and section.triangles.size
    try:
        kerf.Mesh(mesh.vertices, [[0, 1, 10**6]])
    except ValueError:
        pass


def test_ten_thousand_cuts_leave_nothing_behind():
    rock = kerf.shape("asteroid", 300)
    mesh = kerf.Mesh(rock.vertices, rock.faces, attributes={"heat": rock.vertices[:, 0]})
    sizes = []
    for i in range(10_000):
        cut_once(mesh, i)
        if i % 1000 == 999:
            sizes.append(resident_bytes())
    # A cut that left a piece behind would leave 20 kB: 160 MB in these eight thousand.
    assert sizes[-1] - sizes[1] < 2 * 2**20, sizes
