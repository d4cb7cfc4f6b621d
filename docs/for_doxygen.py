#!/usr/bin/python3
"""Turns a page of Markdown, as Git hosts show it, into one that Doxygen reads (FILTER_PATTERNS in docs/Doxyfile).

Pages and their headings get names, and links between pages go by them. Links to files that are no pages become the name
of the file.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
README = ROOT / "README.md"
OTHER_PAGES = (README, ROOT / "examples/README.md")


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
    name = name_of(page)
    return f"{marks} {text} {{#{name}}}" if marks == "#" else f"{marks} {text} {{#{name}_{slug(text).replace('-', '_')}}}"


def link(page, text, target):
    if re.match(r"[a-z]+:", target):
        return f"[{text}]({target})"
    path, _, part = target.partition("#")
    place = (page.parent / path).resolve() if path else page
    if not is_page(place):
        name = str(place.relative_to(ROOT))
        return f"`{name}`" if name in text else f"{text} (`{name}`)"
    name = name_of(place)
    if part:
        return f"[{text}](@ref {name}_{part.replace('-', '_')})"
    return f"[{text}](@ref {name})"


def picture(page, alternative, target):
    """A caption in place of the alternative text: Doxygen has no other."""
    name = Path(target).name
    return f'@image html {name} "{alternative}"'.replace("\n", " ")


def prose(page, text):
    """What lies between listings."""
    text = re.sub(r"<!--.*?-->\n?", "", text, flags=re.S)
    text = re.sub(r'<picture>.*?<img alt="([^"]*)" src="([^"]*)"[^>]*></picture>',
                  lambda m: picture(page, m[1], m[2]), text, flags=re.S)
    text = re.sub(r"^!\[([^]]*)\]\(([^)]*)\)", lambda m: picture(page, m[1], m[2]), text, flags=re.M)
    text = re.sub(r"^(#+) (.*)$", lambda m: heading(page, m[1], m[2]), text, flags=re.M)
    return re.sub(r"(?<!!)\[([^]]*)\]\(([^)@]*)\)", lambda m: link(page, m[1], m[2]), text)


def converted(page):
    pieces = re.split(r"(^```.*?^```$)", page.read_text(encoding="utf-8"), flags=re.M | re.S)
    return "".join(piece if piece.startswith("```") else prose(page, piece) for piece in pieces)


if __name__ == "__main__":
    sys.stdout.write(converted(Path(sys.argv[1]).resolve()))
