#!/usr/bin/env python3
"""How pages for Git hosts become pages of the site (docs/for_doxygen.py), and what is found in bad ones
(docs/check_pages.py). `./run docs` makes the whole site."""

import re
import sys
import tempfile
import unittest
from pathlib import Path

from listings import ROOT

sys.path.insert(0, str(ROOT / "docs"))
import check_pages
import for_doxygen

PAGE = ROOT / "docs/guide/threads.md"


def converted(text, page=PAGE):
    return for_doxygen.prose(page, text)


class ForDoxygen(unittest.TestCase):
    def test_a_page_and_its_headings_have_names(self):
        self.assertEqual("# Threads {#guide_threads}\n## Two `or` more {#guide_threads_two_or_more}\n",
                         converted("# Threads\n## Two `or` more\n"))

    def test_the_readme_is_the_first_page(self):
        self.assertEqual("# Kerf {#mainpage}\n", converted("# Kerf\n", ROOT / "README.md"))

    def test_a_link_goes_by_the_name_of_its_page(self):
        self.assertEqual("[it](@ref robustness_kinds_of_input)", converted("[it](../robustness.md#kinds-of-input)"))

    def test_a_link_text_stands_on_one_line(self):
        """Or Doxygen takes the rest of the page for the text of the link."""
        self.assertEqual("the [back end](@ref guide_drawing) does", converted("the [back\nend](drawing.md) does"))

    def test_a_file_that_is_no_page_is_named(self):
        self.assertEqual("the rules (`.clang-tidy`)", converted("[the rules](../../.clang-tidy)"))
        self.assertEqual("`kerf/cut.h`", converted("[`kerf/cut.h`](../../include/kerf/cut.h)"))

    def test_the_source_of_an_example_has_a_page(self):
        self.assertEqual('<a href="arrays_2main_8cpp-example.html">arrays</a>',
                         converted("[arrays](../../examples/arrays/main.cpp)"))

    def test_public_names_are_links(self):
        self.assertEqual('<tt>@ref kerf::Object::draw "Object::draw()"</tt> and `draw()`',
                         converted("`Object::draw()` and `draw()`"))

    def test_names_of_the_library_itself_are_none(self):
        text = "`Plane::signed_distance()`"
        self.assertEqual(text, converted(text, ROOT / "docs/cutting-rules.md"))

    def test_a_picture_has_a_caption(self):
        self.assertEqual('@image html sides.svg "Two sides"', converted("![Two\nsides](../images/sides.svg)"))

    def test_listings_stay_as_they_are(self):
        page = next(path for path in (ROOT / "docs/guide").glob("*.md") if "```cpp" in path.read_text())
        program = re.search(r"^```cpp\n.*?^```$", page.read_text(), re.M | re.S)[0]
        self.assertIn(program, for_doxygen.converted(page))


class Tree(unittest.TestCase):
    def test_each_page_has_its_place(self):
        places = re.findall(r"@subpage (\w+)", (ROOT / "docs/navigation.dox").read_text())
        pages = [*(ROOT / "docs").glob("**/*.md"), ROOT / "examples/README.md"]
        self.assertEqual(sorted(for_doxygen.name_of(page) for page in pages), sorted(places))

    def test_each_example_has_its_place(self):
        shown = re.findall(r"@example (\w+)/", (ROOT / "docs/navigation.dox").read_text())
        self.assertEqual(sorted(path.parent.name for path in ROOT.glob("examples/*/CMakeLists.txt")), sorted(shown))


class CheckPages(unittest.TestCase):
    def faults(self, text):
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder) / "page.html"
            page.write_text(text)
            return list(check_pages.faults_of(page, {"page.html", "other.html"}))

    def test_a_link_that_leads_nowhere_is_found(self):
        self.assertEqual([], self.faults('<a class="el" href="other.html#part">x</a><a href="https://x.org">x</a>'))
        self.assertEqual(1, len(self.faults('<a class="el" href="gone.html">x</a>')))

    def test_a_command_in_a_text_is_found(self):
        self.assertEqual([], self.faults("<code>@ref x</code> write to me@reference.org"))
        self.assertEqual(1, len(self.faults("<p>see @ref x</p>")))


if __name__ == "__main__":
    unittest.main()
