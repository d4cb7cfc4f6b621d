"""What NumPy says of triangles, and of what a plane leaves of them. Shares nothing with the library: it is the judge."""

from typing import NamedTuple

import numpy as np


class Measures(NamedTuple):
    area: float
    volume: float
    centroid: np.ndarray


def measures(vertices, faces):
    """Of a closed surface: its area, and volume and centroid of what it bounds."""
    corners = np.asarray(vertices, dtype=np.float64)[faces]
    reference = corners.reshape(-1, 3).mean(axis=0)
    return _measures(corners, reference)


def _measures(corners, reference):
    a, b, c = (corners[:, i] - reference for i in range(3))
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    volumes = np.einsum("ni,ni->n", a, np.cross(b, c)) / 6
    volume = volumes.sum()
    moment = (volumes[:, None] * (a + b + c) / 4).sum(axis=0)
    centroid = reference + (moment / volume if volume else np.zeros(3))
    return Measures(0.5 * np.linalg.norm(across, axis=1).sum(), volume, centroid)


def is_closed(vertices, faces):
    """Whether the triangles at each edge run along it as often one way as the other. Vertices at one place are one."""
    _, places = np.unique(np.asarray(vertices), axis=0, return_inverse=True)
    corners = places.reshape(-1)[np.asarray(faces, dtype=np.int64)]
    edges = np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]])
    edges = edges[edges[:, 0] != edges[:, 1]]
    low, high = edges.min(axis=1), edges.max(axis=1)
    names, which = np.unique(np.stack([low, high], axis=1), axis=0, return_inverse=True)
    balance = np.zeros(len(names), dtype=np.int64)
    np.add.at(balance, which.reshape(-1), np.where(edges[:, 0] == low, 1, -1))
    return not balance.any()


def clipped(vertices, faces, origin, normal):
    """The triangles where (p - origin) . normal >= 0, cut where the plane goes through: corners (m, 3, 3)."""
    corners = np.asarray(vertices, dtype=np.float64)[faces]
    distance = (corners - origin) @ normal
    kept = []
    for triangle, at in zip(corners, distance):
        inside = at >= 0
        if inside.all():
            kept.append(triangle)
        elif inside.any():
            outline = []
            for i in range(3):
                j = (i + 1) % 3
                if inside[i]:
                    outline.append(triangle[i])
                if inside[i] != inside[j]:
                    outline.append(triangle[i] + at[i] / (at[i] - at[j]) * (triangle[j] - triangle[i]))
            kept += [[outline[0], outline[i], outline[i + 1]] for i in range(1, len(outline) - 1)]
    return np.array(kept).reshape(-1, 3, 3)


class Half(NamedTuple):
    measures: Measures
    cap_area: float


def half(vertices, faces, origin, normal):
    """What lies on the side of the normal, closed: seen from a point of the plane, its cap has no volume and no moment,
    and its area is what the rest lacks to be a closed surface."""
    origin = np.asarray(origin, dtype=np.float64)
    normal = np.asarray(normal, dtype=np.float64) / np.linalg.norm(normal)
    corners = clipped(vertices, faces, origin, normal)
    surface = _measures(corners, origin)
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    cap_area = float(0.5 * across.sum(axis=0) @ normal)
    return Half(Measures(surface.area + cap_area, surface.volume, surface.centroid), cap_area)
