"""The listings of the documentation: those of the pages, and the examples in the comments of the public headers.

A listing of a page begins with a fence that names its language. A comment before it may say more:

    <!-- listing stands in:          the listing is a part of a program: this one, with the listing in place of "..."
    int main()
    {
    ...
    }
    -->
    <!-- listing: output -->         what the program above prints

An example of a header is what is indented by four columns in a comment, after an empty line of it.
"""

import re
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FENCE = re.compile(r"(?:^<!-- listing(?P<note>(?:(?!-->).)*)-->\n)?"
                   r"^(?P<fence>```+)(?P<language>[^\n]*)\n(?P<text>(?:[^\n]*\n)*?)(?P=fence)$", re.M | re.S)


@dataclass(frozen=True)
class Listing:
    file: Path      # page or header
    line: int       # of the listing's first line
    number: int     # among those of the file and language
    language: str   # "" if the fence names none
    note: str       # what the comment before it says
    text: str

    @property
    def name(self):
        """For files and tests: "guide_threads_1"."""
        words = self.file.relative_to(ROOT).with_suffix("").parts
        words = words[1:] if words[0] in ("docs", "include") else words
        return "_".join(words).replace("-", "_").lower() + f"_{self.number}"

    def __str__(self):
        return f"{self.file.relative_to(ROOT)}:{self.line}"

    def program(self):
        """The whole program that a listing in C++ is, or is a part of."""
        own = f'#line {self.line} "{self.file}"\n{self.text}'
        note = self.note.removeprefix(" stands in:\n")
        if note == self.note:
            return own
        before, dots, after = note.partition("...\n")
        if not dots or after.find("...\n") >= 0:
            raise ValueError(f"{self}: what the listing stands in needs one line of three points")
        return before + own + after


def pages():
    """All Markdown of the project."""
    patterns = ("*.md", "docs/**/*.md", "examples/**/*.md", "data/**/*.md")
    return sorted(path for pattern in patterns for path in ROOT.glob(pattern))


def headers():
    return sorted((ROOT / "include/kerf").glob("*.h"))


def listings_of(page, text):
    found, numbers = [], {}
    for match in FENCE.finditer(text):
        language = match["language"].strip()
        numbers[language] = numbers.get(language, 0) + 1
        line = text.count("\n", 0, match.start("text")) + 1
        found.append(Listing(page, line, numbers[language], language, match["note"] or "", match["text"]))
    return found


def examples_of(header, text):
    lines = text.splitlines()
    found, i = [], 0
    while i < len(lines):
        if lines[i].strip() != "///":
            i += 1
            continue
        begin = i = i + 1
        while i < len(lines) and re.match(r"\s*///     |\s*///$", lines[i]):
            i += 1
        code = [re.sub(r"^\s*///( {5})?", "", line) for line in lines[begin:i]]
        if "".join(code):
            found.append(Listing(header, begin + 1, len(found) + 1, "cpp", "", "\n".join(code).strip() + "\n"))
    return found


def all_listings():
    return [listing for page in pages() for listing in listings_of(page, page.read_text(encoding="utf-8"))]


def all_examples():
    return [example for header in headers() for example in examples_of(header, header.read_text(encoding="utf-8"))]
