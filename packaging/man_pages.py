#!/usr/bin/python3
"""Writes the man pages of a program from what it says of itself (--help, --version), so that they can't differ from it.

The date is that of the source (SOURCE_DATE_EPOCH in the environment), so that equal sources give equal pages.
Exit status: 0 all pages are written, 1 none is.
"""

import argparse
import datetime
import gzip
import os
import re
import subprocess
import sys
from pathlib import Path

TABLES = ("Positionals:", "Options:", "Subcommands:")


class Failed(Exception):
    """One sentence."""


class Help:
    """What a program prints for --help, in its parts."""

    def __init__(self, text):
        lines = text.rstrip().splitlines()
        usage = next((i for i, line in enumerate(lines) if line.startswith("Usage: ")), None)
        if usage is None:
            raise Failed("a help has no line 'Usage: '")
        self.description = " ".join(lines[:usage]).strip()
        self.usage = lines[usage].removeprefix("Usage: ")
        self.tables = {}
        rest = usage + 1
        while rest < len(lines):
            if not lines[rest]:
                rest += 1
            elif lines[rest] in TABLES:
                heading, rest = lines[rest], rest + 1
                rows = self.tables[heading] = []
                while rest < len(lines) and lines[rest].startswith("  "):
                    add_to_table(rows, lines[rest])
                    rest += 1
            else:
                break
        self.footer = lines[rest:]


def add_to_table(rows, line):
    """A row begins two columns in; its explanation stands two columns behind it, or below, farther in."""
    if line.startswith("   "):
        rows[-1][1] = f"{rows[-1][1]} {line.strip()}".strip()
    else:
        name, _, explanation = line.strip().partition("  ")
        rows.append([name, explanation.strip()])


def escaped(text):
    """As roff writes it: minus signs that can be copied, no line that looks like a request."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return re.sub(r"^([.'])", r"\\&\1", text, flags=re.M)


def bold_options(name):
    """-h,--help INT: what is typed is bold."""
    return re.sub(r"(?<![\w\\-])((?:\\-)+[a-z][\w\\-]*)", r"\\fB\1\\fR", escaped(name))


def paragraphs(lines):
    """Text is filled; lines that are farther in stand as they are."""
    out, inside = [], False
    for line in lines:
        if line.startswith("  ") != inside:
            out.append(".fi\n.RE" if inside else ".RS 2\n.nf")
            inside = not inside
        out.append(escaped(line.removeprefix("  ")) or ".PP")
    if inside:
        out.append(".fi\n.RE")
    return "\n".join(out)


def exit_status(footer):
    """The footer's sentence on the exit status, and the rest of it."""
    begin = next((i for i, line in enumerate(footer) if line.startswith("Exit status: ")), None)
    if begin is None:
        return [], footer
    end = begin + 1
    while end < len(footer) and footer[end] and not footer[end - 1].endswith("."):
        end += 1
    sentence = [footer[begin].removeprefix("Exit status: ")] + footer[begin + 1:end]
    return sentence, footer[:begin] + footer[end:]


def page(name, version, said, see_also):
    epoch = os.environ.get("SOURCE_DATE_EPOCH")
    date = datetime.datetime.fromtimestamp(int(epoch), datetime.timezone.utc).date().isoformat() if epoch else ""
    what = said.description.split(". ")[0].rstrip(".")
    what = what.removeprefix("Kerf ")
    out = [f'.TH {name.upper()} 1 "{date}" "{version}" "User Commands"', ".SH NAME",
           f"{escaped(name)} \\- {escaped(what[0].lower() + what[1:])}", ".SH SYNOPSIS", f".B {escaped(said.usage)}",
           ".SH DESCRIPTION", escaped(said.description.rstrip(".") + ".")]
    status, footer = exit_status(said.footer)
    for heading, title in (("Positionals:", "ARGUMENTS"), ("Options:", "OPTIONS"), ("Subcommands:", "COMMANDS")):
        rows = said.tables.get(heading, [])
        if rows:
            out.append(f".SH {title}")
        for row, explanation in rows:
            head = f"\\fB{escaped(f'{name}-{row}')}\\fR(1)" if title == "COMMANDS" else bold_options(row)
            out += [".TP", head, escaped(explanation) or "\\&"]
    if any(footer):
        out += [".SH NOTES", paragraphs(footer)]
    if status:
        out += [".SH EXIT STATUS", paragraphs(status)]
    if see_also:
        out += [".SH SEE ALSO", ",\n".join(f".BR {escaped(other)} (1)" for other in see_also).replace(",\n", " ,\n")]
    return re.sub(r"(\.PP\n)+(?=\.SH|\.PP)", "", "\n".join(out)) + "\n"


def ask(*command):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True,
                          env=dict(os.environ, LC_ALL="C.UTF-8"))
    if done.returncode != 0:
        line = " ".join(str(part) for part in command)
        raise Failed(f"{line} ends with status {done.returncode}: {done.stderr.strip()}")
    return done.stdout


def pages(program, with_subcommands):
    """The text of each page, by its name."""
    name, version = program.name, ask(program, "--version").strip()
    said = Help(ask(program, "--help"))
    commands = [row for row, _ in said.tables.get("Subcommands:", [])] if with_subcommands else []
    texts = {name: page(name, version, said, [f"{name}-{command}" for command in commands])}
    for command in commands:
        texts[f"{name}-{command}"] = page(f"{name}-{command}", version, Help(ask(program, command, "--help")), [name])
    return texts


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path)
    parser.add_argument("folder", type=Path, help="where the pages go, compressed; others there are removed")
    parser.add_argument("--subcommands", action="store_true", help="a page for each of its commands, too")
    arguments = parser.parse_args()
    try:
        texts = pages(arguments.program.resolve(), arguments.subcommands)
        arguments.folder.mkdir(parents=True, exist_ok=True)
        for old in arguments.folder.glob("*"):
            old.unlink()
        # The page of the program comes last: with it, all are there.
        for name, text in reversed(texts.items()):
            (arguments.folder / f"{name}.1.gz").write_bytes(gzip.compress(text.encode(), 9, mtime=0))
    except (Failed, OSError, ValueError) as failure:
        print(f"man_pages.py: {failure}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
