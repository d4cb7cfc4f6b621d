"""Types: those of the package hold, users see them, and the stub of the C++ module names what it has."""

import ast
import os
import pathlib
import subprocess
import sys

import kerf
import pytest

PACKAGE = pathlib.Path(kerf.__file__).parent


def run_mypy(folder, *arguments):
    pytest.importorskip("mypy")
    return subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", *arguments], cwd=folder, capture_output=True, text=True, check=False
    )


def test_the_package_is_typed(tmp_path):
    assert (PACKAGE / "py.typed").exists()
    found = run_mypy(tmp_path, "-p", "kerf")
    assert found.returncode == 0, found.stdout


def test_users_see_the_types(tmp_path):
    (tmp_path / "user.py").write_text(
        "import kerf\n"
        "mesh = kerf.Mesh([[0, 0, 0]], [[0, 0, 0]])\n"
        "one, other = kerf.cut(mesh, origin=(0, 0, 0), normal='x')\n"
        "reveal_type(one)\n"
        "many, _ = kerf.cut(mesh.prepare(), origin=(0, 0, 0), normal='x', components=True)\n"
        "reveal_type(many)\n"
        "reveal_type(kerf.section(mesh, origin=(0, 0, 0), normal='x').loops)\n"
        "flag: bool = True\n"
        "kerf.cut(mesh, origin=(0, 0, 0), normal='x', components=flag)\n"
        "reveal_type(kerf.dice(mesh, x=[0])[0].mesh)\n"
        "kerf.cut(mesh, (0, 0, 0), 'x')\n"
    )
    lines = run_mypy(tmp_path, "user.py").stdout.splitlines()
    assert "Union[kerf._mesh.Mesh, None]" in lines[0]
    assert "list[kerf._object.Object]" in lines[1]
    assert "ndarray" in lines[2] and "list" in lines[2]
    assert "kerf._mesh.Mesh" in lines[3]
    assert any("user.py:11: error" in line for line in lines[4:])
    assert not any("user.py:9" in line for line in lines)


def members(body):
    return {
        node.name for node in body if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and node.name != "__init__"
    } | {node.target.id for node in body if isinstance(node, ast.AnnAssign)}


def test_the_stub_names_what_the_module_has():
    stub = ast.parse((PACKAGE / "_core.pyi").read_text())
    public = {name for name in dir(kerf._core) if not name.startswith("_")}
    assert {name for name in members(stub.body) if not name.startswith("_")} == public
    for node in stub.body:
        if isinstance(node, ast.ClassDef) and node.name != "FileError":
            found = {name for name in vars(getattr(kerf._core, node.name)) if not name.startswith("_")}
            assert members(node.body) == found, node.name


def test_nothing_is_left_out_of_the_public_names():
    public = {name for name in vars(kerf) if not name.startswith("_")}
    assert public == set(kerf.__all__)
    assert os.path.isfile(PACKAGE / "_core.pyi")
