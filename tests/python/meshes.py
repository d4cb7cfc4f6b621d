"""Meshes that several tests cut."""

import kerf


def box():
    """From -1 to 1: eight corners, twelve triangles."""
    unit = kerf.shape("box", 12)
    return kerf.Mesh(2 * unit.vertices, unit.faces, normals=unit.normals)
