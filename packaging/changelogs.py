#!/usr/bin/python3
"""Writes the changelogs of a Debian package: changelog.gz, which is CHANGELOG.md, and changelog.Debian.gz.

The date is that of the source (SOURCE_DATE_EPOCH in the environment), so that equal sources give equal packages.
Exit status: 0 both are written, 1 a file cannot be read or written.
"""

import argparse
import datetime
import email.utils
import gzip
import os
import sys
from pathlib import Path


def debian_changelog(version, contact, seconds):
    date = email.utils.format_datetime(datetime.datetime.fromtimestamp(seconds, datetime.timezone.utc))
    return (f"kerf ({version}) unstable; urgency=medium\n\n"
            "  * Packages of this release; changelog.gz beside this file has what changed.\n\n"
            f" -- {contact}  {date}\n")


def write_compressed(path, text):
    """Whole or not at all; without the name and time of a file."""
    unfinished = path.with_suffix(".unfinished")
    unfinished.write_bytes(gzip.compress(text.encode(), 9, mtime=0))
    unfinished.replace(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("changelog", type=Path, help="CHANGELOG.md")
    parser.add_argument("folder", type=Path, help="where both go")
    parser.add_argument("--version", required=True, help="of the package")
    parser.add_argument("--contact", required=True, help="who answers for it: NAME <MAIL>")
    arguments = parser.parse_args()
    try:
        text = arguments.changelog.read_text()
        seconds = int(os.environ.get("SOURCE_DATE_EPOCH", arguments.changelog.stat().st_mtime))
        arguments.folder.mkdir(parents=True, exist_ok=True)
        write_compressed(arguments.folder / "changelog.gz", text)
        write_compressed(arguments.folder / "changelog.Debian.gz",
                         debian_changelog(arguments.version, arguments.contact, seconds))
    except (OSError, ValueError) as error:
        print(f"changelogs.py: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
