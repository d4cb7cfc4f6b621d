"""Pieces of a fracture, judged by NumPy alone."""

import numpy as np
import pytest

import kerf
from measures import is_closed, measures


@pytest.fixture(scope="module")
def rock():
    return kerf.shape("asteroid", 2000, seed=3)


@pytest.mark.parametrize("pattern", ["uniform", "impact", "crack", "grid", "splinters"])
def test_pieces_fill_the_whole(rock, pattern):
    broken = kerf.fracture(rock, 20, pattern=pattern, seed=5, at=(0.1, 0.2, 0.0), direction=(1, 1, 0))
    assert len(broken) >= 12
    assert sum(measures(piece.vertices, piece.faces).volume for piece in broken) == pytest.approx(rock.volume, rel=1e-6)
    for piece in broken:
        assert is_closed(piece.vertices, piece.faces)


def test_bonds_join_pieces(rock):
    broken = kerf.fracture(rock, 12, seed=1)
    pairs = broken.bond_pieces
    assert (pairs[:, 0] < pairs[:, 1]).all() and pairs.max() < len(broken)
    assert len(broken.bond_area) == len(pairs) == len(broken.bond_centre) == len(broken.bond_normal)
    assert np.allclose(np.linalg.norm(broken.bond_normal, axis=1), 1.0)
    # A bond lies half way between the points of its cells.
    sites = np.array([broken.sites[list(cells)[0]] for cells in broken.cells])
    between = sites[pairs[:, 1]] - sites[pairs[:, 0]]
    middle = 0.5 * (sites[pairs[:, 1]] + sites[pairs[:, 0]])
    assert np.allclose(((broken.bond_centre - middle) * between).sum(axis=1), 0.0, atol=1e-5)
    with pytest.raises(ValueError):
        broken.bond_area[0] = 1.0


def test_an_object_stays_and_its_pieces_are_objects(rock):
    whole = rock.prepare()
    broken = kerf.fracture(whole, 5)
    assert isinstance(broken[0], kerf.Object)
    assert whole.volume == pytest.approx(sum(piece.volume for piece in broken))
    assert kerf.cut(broken[0], origin=broken.sites[broken.cells[0][0]], normal="x")


def test_meshes_far_from_the_origin(rock):
    far = np.array([1e7, -2e7, 0.0])
    moved = kerf.Mesh(rock.vertices.astype(np.float64) + far, rock.faces, origin=far)
    broken = kerf.fracture(moved, sites=far + [[0.2, 0, 0], [-0.2, 0, 0]])
    assert len(broken) == 2
    assert abs(broken.bond_centre[0, 0] - far[0]) < 1e-3


def test_the_same_seed_gives_the_same_bytes(rock):
    first, second = (kerf.fracture(rock, 9, seed=4) for _ in range(2))
    for a, b in zip(first, second):
        assert a.vertices.tobytes() == b.vertices.tobytes() and a.faces.tobytes() == b.faces.tobytes()


def test_small_pieces_are_joined(rock):
    broken = kerf.fracture(rock, 40, pattern="impact", least_volume=rock.volume / 30)
    assert all(piece.volume >= rock.volume / 30 for piece in broken)
    assert max(len(cells) for cells in broken.cells) > 1


@pytest.mark.parametrize(
    "arguments, said",
    [
        ({"cells": 0}, "cell"),
        ({"cells": 2.5}, "cells"),
        ({"pattern": "spiral"}, "pattern"),
        ({"at": (0, 1)}, "at"),
        ({"direction": (0, 0, 0)}, "direction"),
        ({"seed": -1}, "seed"),
        ({"sites": [[0, 1]]}, "sites"),
        ({"sites": []}, "sites"),
        ({"least_volume": -1.0}, "volume"),
        ({"material": 7}, "material"),
    ],
)
def test_wrong_arguments_raise(rock, arguments, said):
    with pytest.raises(ValueError, match=said):
        kerf.fracture(rock, **arguments)


def test_open_meshes_are_refused():
    triangle = kerf.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    with pytest.raises(ValueError, match="open"):
        kerf.fracture(triangle)
