#!/usr/bin/env python3
"""Writes the listings that are compiled or configured into a folder, and says in listings.cmake what there is.

    write_listings.py FOLDER

`programs` has a file for each listing in C++, `examples` one for each example of a header, `projects` a folder for each
listing of CMake. `NAME.out` beside a program is what its page says that it prints. Files that are right stay as they
are, so that nothing is compiled again.
"""

import sys
from pathlib import Path

from listings import all_examples, all_listings, headers, pages


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")


def main():
    folder = Path(sys.argv[1])
    names = {"programs": [], "projects": []}
    program = None
    for listing in all_listings():
        if listing.language == "cpp":
            program = listing
            write(folder / f"programs/{listing.name}.cpp", listing.program())
            (folder / f"programs/{listing.name}.out").unlink(missing_ok=True)
            names["programs"].append(listing.name)
        elif listing.language == "cmake":
            write(folder / f"projects/{listing.name}/CMakeLists.txt", listing.text)
            names["projects"].append(listing.name)
        elif listing.note.strip() == ": output":
            write(folder / f"programs/{program.name}.out", listing.text)
    for example in all_examples():
        write(folder / f"examples/{example.name}.inc", f'#line {example.line} "{example.file}"\n{example.text}')
    lines = [f"set(KERF_LISTED_{kind.upper()} {' '.join(found)})" for kind, found in names.items()]
    lines.append("set(KERF_LISTED_FILES\n  " + "\n  ".join(str(path) for path in pages() + headers()) + ")")
    write(folder / "listings.cmake", "\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
