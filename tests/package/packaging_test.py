"""Man pages and changelogs of packages: what becomes of a program's help, and that equal sources give equal bytes."""

import gzip
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

PROGRAM = r"""#!/bin/sh
case "$1" in
--version) echo "tool 1.2" ;;
cut) printf '%s\n' 'Cut in two' 'Usage: tool cut [OPTIONS] FILE' '' \
    'Positionals:' '  FILE TEXT REQUIRED          A mesh' '' \
    'Options:' '  -h,--help                   Help' '  --long-option X,Y,Z Excludes: --plane' \
    '                              Its explanation' '' 'Ways:' '  .one  with a dot' '    and \ more' \
    'Exit status: 0 done,' '2 wrong use.' 'Last words.' ;;
*) printf '%s\n' 'Tool cuts.' 'Usage: tool SUBCOMMAND' '' 'Options:' '  -h,--help  Help' '' 'Subcommands:' \
    '  cut  Cut in two' ;;
esac
"""


class Folder(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)
        self.environment = dict(os.environ, SOURCE_DATE_EPOCH="86400")

    def run_script(self, name, *arguments):
        return subprocess.run([ROOT / "packaging" / name, *arguments], env=self.environment, capture_output=True,
                              text=True)

    def program(self, text):
        path = self.folder / "tool"
        path.write_text(text)
        path.chmod(0o755)
        return path


class ManPages(Folder):
    def pages(self, *flags):
        done = self.run_script("man_pages.py", self.program(PROGRAM), self.folder / "man", *flags)
        self.assertEqual(done.returncode, 0, done.stderr)
        return {path.name: path.read_bytes() for path in (self.folder / "man").iterdir()}

    def test_a_program_and_its_commands_have_a_page_each(self):
        self.assertEqual(set(self.pages("--subcommands")), {"tool.1.gz", "tool-cut.1.gz"})
        self.assertEqual(set(self.pages()), {"tool.1.gz"})

    def test_a_page_has_all_that_the_help_says(self):
        page = gzip.decompress(self.pages("--subcommands")["tool-cut.1.gz"]).decode()
        for text in ('.TH TOOL-CUT 1 "1970-01-02" "tool 1.2"', "tool\\-cut \\- cut in two", ".B tool cut [OPTIONS] FILE",
                     "FILE TEXT REQUIRED\nA mesh",
                     "\\fB\\-\\-long\\-option\\fR X,Y,Z Excludes: \\fB\\-\\-plane\\fR\nIts explanation",
                     "Ways:\n.RS 2\n.nf\n\\&.one  with a dot\n  and \\e more\n.fi", ".SH NOTES",
                     "Last words.", ".SH EXIT STATUS\n0 done,\n2 wrong use.\n", ".BR tool (1)"):
            self.assertIn(text, page)

    def test_equal_sources_give_equal_pages(self):
        self.assertEqual(self.pages("--subcommands"), self.pages("--subcommands"))

    def test_a_program_that_fails_leaves_the_pages_as_they_are(self):
        before = self.pages()
        for text, reason in (("#!/bin/sh\necho lost >&2\nexit 7\n", "ends with status 7: lost"),
                             ("#!/bin/sh\necho nothing\n", "a help has no line 'Usage: '")):
            done = self.run_script("man_pages.py", self.program(text), self.folder / "man")
            self.assertEqual(done.returncode, 1)
            self.assertIn(reason, done.stderr)
            self.assertEqual(before, {path.name: path.read_bytes() for path in (self.folder / "man").iterdir()})


class Changelogs(Folder):
    def write(self, changelog):
        return self.run_script("changelogs.py", changelog, self.folder / "out", "--version", "1.2-1",
                               "--contact", "Somebody <some@body>")

    def test_both_are_written_with_the_date_of_the_source(self):
        (self.folder / "CHANGELOG.md").write_text("# Changes\n")
        self.assertEqual(self.write(self.folder / "CHANGELOG.md").returncode, 0)
        self.assertEqual(gzip.decompress((self.folder / "out/changelog.gz").read_bytes()), b"# Changes\n")
        entry = gzip.decompress((self.folder / "out/changelog.Debian.gz").read_bytes()).decode()
        self.assertTrue(entry.startswith("kerf (1.2-1) unstable; urgency=medium\n"))
        self.assertTrue(entry.endswith("\n -- Somebody <some@body>  Fri, 02 Jan 1970 00:00:00 +0000\n"), entry)

    def test_a_file_that_is_not_there_is_one_sentence(self):
        done = self.write(self.folder / "none.md")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(len(done.stderr.splitlines()), 1)
        self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    unittest.main()
