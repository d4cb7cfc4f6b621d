"""Generated shapes, to try things with."""

from __future__ import annotations

from typing import List

import numpy as np

from . import _arrays, _core
from ._mesh import Mesh


def shape(name: str, triangles: int = 1000, *, seed: int = 1) -> Mesh:
    """A closed shape with about so many triangles, or as many as it needs: one of `shape_names()`.

    >>> kerf.shape("torus", 2000)
    <kerf.Mesh: 2000 triangles, 2.8 x 2.794 x 0.8, closed>
    """
    if name not in shape_names():
        raise ValueError(f"there is no shape '{name}': it is one of {', '.join(shape_names())}")
    triangles = _arrays.count("triangles", triangles, 16_000_000)
    return Mesh._of(_core.shape(name, triangles, _arrays.count("seed", seed)), np.zeros(3), None)


def shape_names() -> List[str]:
    """'asteroid', 'bowl', 'box', ..."""
    return _core.shape_names()
