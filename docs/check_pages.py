#!/usr/bin/python3
"""Looks through the pages that Doxygen has made: no link leads nowhere, and no command of Doxygen stands in a text.

    check_pages.py FOLDER
"""

import html
import re
import sys
from pathlib import Path


def faults_of(page, pages):
    text = page.read_text(encoding="utf-8")
    for target in re.findall(r'<(?:a|img|object)[^>]* (?:href|src|data)="([^"#]+)', text):
        if not re.match(r"[a-z]+:", target) and html.unescape(target) not in pages:
            yield f"leads to {target}, which is not there"
    prose = re.sub(r'<div class="fragment">.*?</div><!-- fragment -->|<code>.*?</code>', "", text, flags=re.S)
    for command in re.findall(r"[@\\](?:ref|(?:sub)?section|(?:end)?code|image|(?:sub)?page|anchor)\b.{0,40}", prose):
        yield f"shows a command: {command}"


def main():
    folder = Path(sys.argv[1])
    pages = {str(path.relative_to(folder)) for path in folder.rglob("*")}
    faults = [f"{name}: {fault}" for name in sorted(pages) if name.endswith(".html") and "/" not in name
              for fault in faults_of(folder / name, pages)]
    print("\n".join(faults), end="\n" if faults else "", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
