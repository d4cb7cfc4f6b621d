#!/usr/bin/env python3
"""Holds every #include of src/ against the table in docs/architecture.md."""

import re
import subprocess
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
SOURCE = ROOT / "src"


def table():
    """The rooms by folder, and the rooms that each may include."""
    rows = re.findall(r"^\| `(src/[^`]+)` \|[^|]*\|([^|]*)\|$", (ROOT / "docs" / "architecture.md").read_text(), re.M)
    folders = {Path(folder).name: folder for folder, _ in rows}
    return {folder: [folders[name.strip()] for name in names.split(",") if name.strip()] for folder, names in rows}


def files():
    return sorted(path for path in SOURCE.rglob("*") if path.suffix in {".h", ".cpp"})


def includes(text):
    """What a file includes of the project, as paths from the project's folder."""
    names = re.findall(r'^\s*#\s*include "([^"]+)"', text, re.M)
    return ["src/" + name if (SOURCE / name).exists() else name for name in names]


def room_of(path, rooms):
    """The innermost room that a path lies in, or None."""
    found = [room for room in rooms if path.startswith(room + "/")]
    return max(found, key=len, default=None)


def wrong_arrows(path, text, rooms):
    """Includes that the table does not allow to the file `path`."""
    room = room_of(path, rooms)
    return [f"{path} includes {name}" for name in includes(text)
            if room_of(name, rooms) not in [room, *rooms[room]]]


GEOMETRIC = re.compile(r"\bglm::(cross|distance|dot|length|normalize)\(")  # of glm/geometric.hpp


def reads(path, name, seen):
    """Whether a file includes `name`, itself or by others of the project. `seen` keeps those that were looked into."""
    if path in seen:
        return False
    seen.add(path)
    for included in re.findall(r'^\s*#\s*include [<"]([^">]+)[">]', path.read_text(), re.M):
        if included == name:
            return True
        for folder in (path.parent, SOURCE, ROOT, ROOT / "tests", ROOT / "include"):
            if (folder / included).is_file() and reads(folder / included, name, seen):
                return True
    return False


def unused_permissions(rooms, used):
    """Permissions of the table that no include needs; `used` holds pairs of rooms: who includes whom."""
    return [f"{room} may include {below}, and no file does" for room, may in rooms.items() for below in may
            if (room, below) not in used]


class Architecture(unittest.TestCase):
    def test_the_table_has_rooms_that_exist(self):
        for room in table():
            self.assertTrue((ROOT / room).is_dir(), room)

    def test_each_file_is_in_a_room(self):
        rooms = table()
        self.assertEqual([], [str(path) for path in files() if room_of(str(path.relative_to(ROOT)), rooms) is None])

    def test_no_arrow_runs_back_up(self):
        """The rows stand in an order: what a room may include stands above it."""
        seen = []
        for room, below in table().items():
            self.assertEqual([], [name for name in below if name not in seen], room)
            seen.append(room)

    def test_files_include_what_their_room_may(self):
        rooms = table()
        wrong = []
        for path in files():
            wrong += wrong_arrows(str(path.relative_to(ROOT)), path.read_text(), rooms)
        self.assertGreater(len(files()), 100)
        self.assertEqual([], wrong)

    def test_each_permission_is_needed(self):
        rooms = table()
        used = set()
        for path in files():
            room = room_of(str(path.relative_to(ROOT)), rooms)
            used |= {(room, room_of(name, rooms)) for name in includes(path.read_text())}
        self.assertEqual([], unused_permissions(rooms, used))
        self.assertEqual(["a may include b, and no file does"], unused_permissions({"a": ["b"], "b": []}, {("b", "a")}))

    def test_a_wrong_include_would_be_found(self):
        rooms = table()
        upwards = wrong_arrows("src/common/mesh/plane.h", '#include "common/cutting/cut.h"\n', rooms)
        self.assertEqual(["src/common/mesh/plane.h includes src/common/cutting/cut.h"], upwards)
        other_back_end = wrong_arrows("src/baseline/fan.h", '#include "halfedge/halfedge.h"\n', rooms)
        self.assertEqual(1, len(other_back_end))
        program = wrong_arrows("src/common/io/mesh_file.h", '#include "tools/text.h"\n', rooms)
        self.assertEqual(1, len(program))

    def test_programs_see_what_other_programs_see(self):
        """The public interface, the report's back ends, and helpers that know nothing of meshes."""
        allowed = ("src/baseline/report_back_ends.h", "src/common/support/", "src/common/files/", "src/command_line/")
        looked_at, wrong = 0, []
        for folder in ("tools", "viewer", "bench"):
            for path in sorted((ROOT / folder).rglob("*")):
                if path.suffix not in {".h", ".cpp"}:
                    continue
                looked_at += 1
                wrong += [f"{path.relative_to(ROOT)} includes {name}" for name in includes(path.read_text())
                          if name.startswith("src/") and not name.startswith(allowed)]
        self.assertGreater(looked_at, 200)
        self.assertEqual([], wrong)

    def test_programs_link_the_components_that_they_include(self):
        """A library that leaves one out links only where another library brings it along."""
        looked_at, wrong = 0, []
        for folder in ("tools", "viewer", "bench", "tests"):
            for path in sorted((ROOT / folder).rglob("*")):
                if path.suffix not in {".h", ".cpp"}:
                    continue
                component = set(re.findall(r"#include <kerf/(io|shapes|proxy)\.h>", path.read_text()))
                looked_at += bool(component)
                build = next(above / "CMakeLists.txt" for above in path.parents if (above / "CMakeLists.txt").exists())
                wrong += [f"{path.relative_to(ROOT)} includes kerf/{name}.h, and {build.relative_to(ROOT)} does not link it"
                          for name in sorted(component) if not re.search(rf"kerf::({name}|kerf)\b", build.read_text())]
        self.assertGreater(looked_at, 20)
        self.assertEqual([], wrong)

    def test_files_include_what_they_call_of_glm(self):
        """Builds that precompile headers or join files find it anyway; those that do neither, as the fuzzers', do not."""
        looked_at, wrong = 0, []
        for folder in ("src", "viewer", "tools", "bench", "tests"):
            for path in sorted((ROOT / folder).rglob("*")):
                if path.suffix in {".h", ".cpp"} and GEOMETRIC.search(path.read_text()):
                    looked_at += 1
                    if not reads(path, "glm/geometric.hpp", set()):
                        wrong.append(str(path.relative_to(ROOT)))
        self.assertGreater(looked_at, 60)
        self.assertEqual([], wrong)

    def test_irregular_sections_are_behind_one_door(self):
        """What only they need has one header for the rest of the back end."""
        folder, door = "src/halfedge/cut/irregular/", "src/halfedge/cut/irregular/irregular.h"
        inner = [f"{path} includes {name}" for path in files() for name in includes(path.read_text())
                 if name.startswith(folder) and name != door
                 and not str(path.relative_to(ROOT)).startswith(folder)]
        self.assertEqual([], inner)
        self.assertTrue((ROOT / door).exists())
        self.assertGreater(len(list((ROOT / folder).glob("*.h"))), 1)

    def test_bullet_is_in_the_rooms_of_proxies_only(self):
        named = subprocess.run(["grep", "-rlE", r"#include <(bt|Bullet|LinearMath)", SOURCE], capture_output=True, text=True)
        self.assertEqual({"src/common/proxy", "src/baseline/report_proxy"},
                         {room_of(str(Path(name).relative_to(ROOT)), table()) for name in named.stdout.split()})

    def test_sanitizers_leave_out_what_exists(self):
        """A file or function that was renamed would be checked again, or another one not at all."""
        text = (ROOT / "cmake/sanitize-ignore.txt").read_text()
        places = [path for path in re.findall(r"^src:\*/(.+)$", text, re.M)]
        missing = [path for path in places if not (ROOT / "src" / path).exists() and not (ROOT / path.removesuffix("/*")).is_dir()]
        self.assertEqual([], missing)
        # Names as they are mangled: "*ProperHash*", "*3mixEmm".
        functions = re.findall(r"^fun:\*\d*([A-Za-z]+?)(?:Emm|\*)$", text, re.M)
        sources = "".join(path.read_text() for path in files())
        self.assertEqual([], [name for name in functions if not re.search(rf"\b{name}\b", sources)])
        self.assertTrue(places and functions)

    def test_cgal_is_in_one_file(self):
        named = subprocess.run(["grep", "-rl", "#include <CGAL", SOURCE], capture_output=True, text=True)
        self.assertEqual(1, len(named.stdout.split()), named.stdout)


if __name__ == "__main__":
    unittest.main()
