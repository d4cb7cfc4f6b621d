"""Meshes to cut: five of the report's models, and shapes."""

import pathlib

import kerf
import numpy as np
import pytest
from meshes import box as make_box

ROOT = pathlib.Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def root():
    return ROOT


@pytest.fixture(scope="session")
def real_meshes():
    folder = ROOT.parent / "shared" / "meshes"
    if not folder.is_dir():
        pytest.skip("the folder of real meshes is not here")
    return folder


@pytest.fixture
def box():
    return make_box()


@pytest.fixture
def rock():
    return kerf.shape("asteroid", 5000)


@pytest.fixture
def random():
    return np.random.default_rng(7)
