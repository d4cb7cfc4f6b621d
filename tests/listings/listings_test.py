#!/usr/bin/env python3
"""What the documentation says is so: languages, commands and their options, JSON, links. (Listings in C++ and CMake are
programs and projects of their own: CMakeLists.txt.)

    listings_test.py [PROGRAM ...]    the command line programs that are built: kerf, kerf-viewer
"""

import functools
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import listings
from listings import ROOT, all_examples, all_listings, pages

sys.path.append(str(ROOT / "tests/package"))
from debs import PACKAGES

PROGRAMS = {Path(path).name: Path(path) for path in sys.argv[1:] if Path(path).exists()}
# Languages, and who tests their listings. Drawings are `text`, and so is what a program prints.
TESTED = {"cpp": "CMakeLists.txt", "cmake": "configure_project.py", "sh": "Commands", "json": "Json",
          "text": "Languages", "bash": "Scripts", "python": "../python/test_listings.py"}
# Who takes the options of a task of ./run, if `./run help` does not name them.
SCRIPTS = {"soak": "tests/soak/soak.py", "world": "tests/world/world.py", "fuzz": "tests/fuzz/run_fuzz.py",
           "compare-speed": "bench/compare", "package-matrix": "tests/package/package_matrix.py"}
# Commands that are run as they stand: they take a second at most.
QUICK = {"cut", "info", "section", "dice", "fracture", "shape", "compare", "convert", "repair"}


@functools.cache
def output_of(*command, **options):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=100, **options)
    return done.stdout + done.stderr


def commands_of(text):
    """Commands as lists of words; of a pipe only the first one."""
    for line in text.replace("\\\n", " ").splitlines():
        words = shlex.split(line, comments=True)
        ends = [i for i, word in enumerate(words) if word in ("|", ">", "&&")]
        if "&&" in words:
            yield from commands_of(line.split("&&", 1)[1])
        words = words[: ends[0]] if ends else words
        if words:
            yield words


def help_of_run():
    """What `./run help` says of each task."""
    found, task = {}, None
    for line in output_of(ROOT / "run", "help").splitlines():
        if match := re.match(r"  ([a-z][a-z-]*)(?: |$)", line):
            task = match[1]
        if task:
            found[task] = found.get(task, "") + line + "\n"
    return found


TASKS = help_of_run()
BUILD_OPTIONS = set(re.findall(r"^option\((KERF_\w+)", (ROOT / "CMakeLists.txt").read_text(), re.M)) | {"KERF_SANITIZE"}


class Extraction(unittest.TestCase):
    """What listings.py reads of a page and of a header."""

    PAGE, HEADER = ROOT / "docs/page.md", ROOT / "include/kerf/header.h"  # there are none

    def test_a_listing_has_its_language_and_its_line(self):
        text = "# Page\n\n```sh\n./run help\n```\n\n```cpp\nint i;\n\nint j;\n```\n"
        found = listings.listings_of(self.PAGE, text)
        self.assertEqual([("sh", 4, "./run help\n"), ("cpp", 8, "int i;\n\nint j;\n")],
                         [(listing.language, listing.line, listing.text) for listing in found])

    def test_a_part_of_a_program_stands_where_its_page_says(self):
        text = "<!-- listing stands in:\nint main()\n{\n...\n}\n-->\n```cpp\nreturn 0;\n```\n"
        [listing] = listings.listings_of(self.PAGE, text)
        self.assertRegex(listing.program(), r'^int main\(\)\n{\n#line 8 ".*page.md"\nreturn 0;\n}\n$')

    def test_a_part_without_a_place_is_an_error(self):
        text = "<!-- listing stands in:\nint main() {}\n-->\n```cpp\nreturn 0;\n```\n"
        [listing] = listings.listings_of(self.PAGE, text)
        self.assertRaises(ValueError, listing.program)

    def test_an_example_of_a_header_keeps_its_indentation(self):
        text = "/// Of a loop.\n///\n///     for (;;)\n///         break;\n/// @param i\n///          a number\n"
        [example] = listings.examples_of(self.HEADER, text)
        self.assertEqual(("for (;;)\n    break;\n", 3), (example.text, example.line))


class Languages(unittest.TestCase):
    def test_each_listing_is_in_a_language_that_is_tested(self):
        wrong = [f"{listing}: {listing.language or 'no language'}" for listing in all_listings()
                 if listing.language not in TESTED]
        self.assertEqual([], wrong)

    def test_no_command_hides_in_an_indented_block(self):
        """Which nobody would test."""
        wrong = []
        for page in pages():
            text = listings.FENCE.sub("", page.read_text(encoding="utf-8"))
            wrong += [f"{page.name}: {line}" for line in re.findall(r"(?:^|\n\n)    (\S.*)", text)
                      if re.match(r"(\./run|kerf|cmake|g\+\+|#include)\b", line)]
        self.assertEqual([], wrong)

    def test_output_follows_a_program(self):
        last = None
        for listing in all_listings():
            if listing.note.strip() == ": output":
                self.assertEqual(("cpp", "text"), (last.language, listing.language), str(listing))
                self.assertEqual(last.file, listing.file, str(listing))
            last = listing

    def test_notes_are_known(self):
        known = (": output", "stands in:")
        self.assertEqual([], [str(listing) for listing in all_listings()
                              if listing.note and not listing.note.strip().startswith(known)])

    def test_each_example_of_a_header_is_tested(self):
        text = (ROOT / "tests/listings/header_examples_test.cpp").read_text()
        included = re.findall(r'#include "examples/(\w+)\.inc"', text)
        self.assertEqual([example.name for example in all_examples()], included)
        self.assertGreater(len(included), 3)


class Commands(unittest.TestCase):
    def check_options(self, words, help_text, where):
        for word in words:
            if match := re.match(r"--?[a-z][\w-]*", word):
                known = re.search(rf"(?<![\w-]){re.escape(match[0])}(?![\w-])", help_text)
                self.assertTrue(known, f"{where}: {match[0]} is no option")

    def check_run(self, words, where):
        """./run TASK ..."""
        self.assertTrue(words[1] in TASKS, f"{where}: ./run has no task {words[1]}")
        task, rest = words[1], words[2:]
        if task in QUICK:
            return self.check_kerf(words[1:], where)
        if task == "play":
            return self.check_program("kerf-viewer", rest, where)
        text = TASKS[task]
        if task in SCRIPTS:
            text += output_of(ROOT / SCRIPTS[task], "--help")
        if task == "report":
            text += output_of("/usr/bin/python3", "-B", "-m", "report", "--help", cwd=ROOT / "bench")
        if task not in ("test", "soak-asan", "soak-tsan"):  # what is ctest's
            self.check_options(rest, text, where)
        if task == "check":
            self.assertEqual([], [stage for stage in rest if not (ROOT / ".ci/stages" / stage).exists()], where)
        return None

    def check_kerf(self, words, where):
        """kerf COMMAND ...: run in a folder that has the project's data. What goes to /tmp goes there, too."""
        self.assertIn(words[0], QUICK, where)
        if "kerf" not in PROGRAMS:
            return
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "data").symlink_to(ROOT / "data")
            words = [re.sub(r"^/tmp/", folder + "/", word) for word in words]
            done = subprocess.run([PROGRAMS["kerf"], *words], cwd=folder, capture_output=True, text=True, timeout=100)
            self.assertEqual(0, done.returncode, f"{where}: {' '.join(words)}\n{done.stderr}")

    def check_program(self, name, words, where):
        if name in PROGRAMS:
            self.check_options(words, output_of(PROGRAMS[name], "--help"), where)

    def check_cmake(self, words, where):
        for option in re.findall(r"-D(KERF_\w+)", " ".join(words)):
            self.assertIn(option, BUILD_OPTIONS, where)

    def check(self, words, where):
        name = Path(words[0]).name
        if words[0] == "./run":
            self.check_run(words, where)
        elif name == "kerf":
            self.check_kerf(words[1:], where)
        elif name == "kerf-viewer":
            self.check_program(name, words[1:], where)
        elif name == "cmake":
            self.check_cmake(words[1:], where)
        elif words[:2] == ["apt-get", "install"]:
            for word in words[2:]:
                self.assertIn(word, [f"./build/debs/{package}_*.deb" for package in PACKAGES], where)
        elif not words[0].startswith("/") and (ROOT / words[0]).is_file():
            self.check_options(words[1:], output_of(ROOT / words[0], "--help"), where)
        else:
            # Programs that the page has shown how to make, the compiler (tests/package runs it), and what ./run python does.
            self.assertRegex(words[0], r"^(g\+\+|build[\w-]*/\w+|/usr/bin/python3|venv/bin/pip)$", f"{where}: nobody tests this command")

    def test_commands_exist_and_have_these_options(self):
        checked = 0
        for listing in all_listings():
            if listing.language == "sh":
                for words in commands_of(listing.text):
                    with self.subTest(str(listing), command=" ".join(words)):
                        self.check(words, str(listing))
                    checked += 1
        self.assertGreater(checked, 10)

    def test_tasks_that_sentences_name_exist(self):
        wrong = []
        for page in pages():
            for task in re.findall(r"`\./run ([a-z][a-z-]*)", page.read_text(encoding="utf-8")):
                if task not in TASKS:
                    wrong.append(f"{page.name}: ./run {task}")
        self.assertEqual([], wrong)

    def test_options_of_the_build_that_sentences_name_exist(self):
        wrong = []
        for page in pages():
            text = page.read_text(encoding="utf-8")
            for option in re.findall(r"(?:-D(?=KERF)|`(?=KERF_BUILD))(KERF_[A-Z_]+)\b=", text):
                if option not in BUILD_OPTIONS:
                    wrong.append(f"{page.name}: {option}")
        self.assertEqual([], wrong)


class Scripts(unittest.TestCase):
    """Listings for bash are run as a whole, in a folder that has what they speak of; twice, because they say that this is
    harmless."""

    @unittest.skipUnless("kerf" in PROGRAMS, "kerf is not built")
    def test_they_run_twice(self):
        scripts = [listing for listing in all_listings() if listing.language == "bash"]
        self.assertGreater(len(scripts), 3)
        kerf = PROGRAMS["kerf"].resolve()
        for script in scripts:
            missing = [name for name in ("parallel", "jq") if name in script.text and not shutil.which(name)]
            if missing:
                print(f"{script}: {', '.join(missing)} is not here", file=sys.stderr)
                continue
            with self.subTest(str(script)), tempfile.TemporaryDirectory() as folder:
                for name in ("parts", "cuts", "sections", "out"):
                    (Path(folder) / name).mkdir()
                for i, shape in enumerate(("box", "torus", "asteroid", "icosphere")):
                    for path in [f"parts/{shape} {i}.stl"] + ["part.stl"] * (i == 0):
                        subprocess.run([kerf, "shape", shape, "-o", path], cwd=folder, check=True, capture_output=True)
                environment = dict(os.environ, PATH=f"{kerf.parent}:{os.environ['PATH']}", SLURM_ARRAY_TASK_ID="1",
                                   HOME=folder)
                seen = []
                for _ in range(2):
                    done = subprocess.run(["bash", "-euo", "pipefail", "-c", script.text], cwd=folder, env=environment,
                                          capture_output=True, text=True, timeout=100)
                    self.assertEqual(0, done.returncode, done.stdout + done.stderr)
                    seen.append({str(path.relative_to(folder)): path.read_bytes()
                                 for path in Path(folder).rglob("*") if path.suffix in (".ply", ".svg", ".jsonl")})
                    self.assertTrue(seen[0])
                self.assertEqual(seen[0], seen[1])


class Json(unittest.TestCase):
    def test_it_is_json(self):
        for listing in all_listings():
            if listing.language == "json":
                with self.subTest(str(listing)):
                    json.loads(listing.text)


class Links(unittest.TestCase):
    def anchors(self, page):
        text = listings.FENCE.sub("", page.read_text(encoding="utf-8"))
        headings = [re.sub(r"`|\[([^]]*)\]\([^)]*\)", r"\1", line) for line in re.findall(r"^#+ (.*)$", text, re.M)]
        return {re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-") for heading in headings}

    def test_links_and_pictures_lead_somewhere(self):
        wrong, checked = [], 0
        for page in pages():
            text = listings.FENCE.sub("", page.read_text(encoding="utf-8"))
            targets = re.findall(r"\]\(([^)\s]+)\)", text) + re.findall(r'(?:src|srcset|href)="([^"]+)"', text)
            for target in targets:
                if re.match(r"[a-z]+:", target):
                    continue
                checked += 1
                path, _, anchor = target.partition("#")
                place = (page.parent / path) if path else page
                if not place.exists():
                    wrong.append(f"{page.name}: {target}")
                elif anchor and place.suffix == ".md" and anchor not in self.anchors(place):
                    wrong.append(f"{page.name}: {target}")
        self.assertEqual([], wrong)
        self.assertGreater(checked, 50)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
