#!/usr/bin/python3
"""Turns a page of Markdown, as Git hosts show it, into one that Doxygen reads (FILTER_PATTERNS in docs/Doxyfile).

Pages and their headings get names, and links between pages go by them. Links to the sources of examples lead to their
pages; links to files that are no pages become the name of the file.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
README = ROOT / "README.md"
OTHER_PAGES = (README, ROOT / "examples/README.md")
# Pages that speak of the public interface. Others speak of the library's own classes, some of which have the same names.
OF_THE_INTERFACE = (README, ROOT / "docs/library.md", ROOT / "docs/robustness.md",
                    *(ROOT / "docs/guide").glob("*.md"))
CLASSES = "|".join(name for header in sorted((ROOT / "include/kerf").glob("*.h"))
                   for name in re.findall(r"^(?:struct|class) (?:\[\[nodiscard\]\] )?(?:KERF_API )?(\w+)$",
                                          header.read_text(encoding="utf-8"), re.M))


def is_page(path):
    return path in OTHER_PAGES or (path.suffix == ".md" and path.is_relative_to(ROOT / "docs") and path.exists())


def name_of(path):
    """The name of a page, by its path in the project: "guide_threads" of docs/guide/threads.md."""
    if path == README:
        return "mainpage"
    parts = path.relative_to(ROOT).with_suffix("").parts
    return "_".join(parts[1:] if parts[0] == "docs" else parts).replace("-", "_").lower()


def slug(heading):
    """The name by which Git hosts know a heading."""
    words = re.sub(r"[`*]|\[([^]]*)\]\([^)]*\)", lambda m: m[1] or "", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", words).replace(" ", "-")


def heading(page, marks, text):
    name = name_of(page) + ("" if marks == "#" else "_" + slug(text).replace("-", "_"))
    return f"{marks} {text} {{#{name}}}"


def code(text):
    """Between tags Doxygen reads no Markdown."""
    return re.sub(r"`([^`]*)`", r"<code>\1</code>", text)


def link(page, text, target):
    # Doxygen wants the text on one line.
    text = " ".join(text.split())
    if re.match(r"[a-z]+:", target):
        return f"[{text}]({target})"
    path, _, part = target.partition("#")
    place = (page.parent / path).resolve() if path else page
    if not is_page(place):
        name = str(place.relative_to(ROOT))
        if name.startswith("examples/") and place.suffix == ".cpp":
            example = name.removeprefix("examples/").replace("/", "_2").replace(".", "_8")
            return f'<a href="{example}-example.html">{code(text)}</a>'
        return text if place.name in text else f"{text} (`{name}`)"
    name = name_of(place)
    if part:
        return f"[{text}](@ref {name}_{part.replace('-', '_')})"
    return f"[{text}](@ref {name})"


def with_public_names(text):
    """Public names become links: one that does not exist is an error of Doxygen's."""
    return re.sub(rf"(?<![\[`])`((?:kerf::)?((?:{CLASSES})(?:::\w+)?)(?:\(\))?)`(?!\])",
                  lambda m: f'<tt>@ref kerf::{m[2]} "{m[1]}"</tt>', text)


def prose(page, text):
    """What lies between listings."""
    text = re.sub(r"<!--.*?-->\n?", "", text, flags=re.S)
    if page in OF_THE_INTERFACE:
        text = with_public_names(text)
    # A figure has a caption of its own; the alternative text of another picture becomes one.
    text = re.sub(r'<picture>.*?<img [^>]*src="([^"]*)" width="(\d+)"></picture>',
                  lambda m: f"@image html {Path(m[1]).name} width={m[2]}px", text, flags=re.S)
    text = re.sub(r"^!\[([^]]*)\]\(([^)]*)\)",
                  lambda m: f'@image html {Path(m[2]).name} "{" ".join(m[1].split())}"', text, flags=re.M)
    text = re.sub(r"^(#+) (.*)$", lambda m: heading(page, m[1], m[2]), text, flags=re.M)
    return re.sub(r"(?<!!)\[([^]]*)\]\(([^)@]*)\)", lambda m: link(page, m[1], m[2]), text)


def converted(page):
    pieces = re.split(r"(^```.*?^```$)", page.read_text(encoding="utf-8"), flags=re.M | re.S)
    return "".join(piece if piece.startswith("```") else prose(page, piece) for piece in pieces)


if __name__ == "__main__":
    sys.stdout.write(converted(Path(sys.argv[1]).resolve()))
