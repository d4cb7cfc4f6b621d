"""One page without any other file: sections as HTML, figures as SVG in the page's colours."""

import html
import re

from report.chapters.section import Section, ShownFigure, ShownTable
from report.page.style import STYLE
from report.plots.drawing import Drawing
from report.plots.palette import COLOURS, THEMES
from report.tables.numbers import count
from report.tables.table import Table

CODE = re.compile(r"`([^`]+)`")
STRONG = re.compile(r"\*\*(.+?)\*\*")
EMPHASIS = re.compile(r"\*([^*]+)\*")

BROAD = 5  # columns that a narrow screen has no room for


def inline(text: str) -> str:
    """Sentences in Markdown's way as HTML."""
    text = CODE.sub(r"<code>\1</code>", html.escape(text, quote=False))
    return EMPHASIS.sub(r"<em>\1</em>", STRONG.sub(r"<strong>\1</strong>", text))


def variables(theme: str) -> str:
    return " ".join(f"--{colour.name}: {colour.of(theme)};" for colour in COLOURS.values())


def table_html(table: Table) -> str:
    """Cells carry nothing but what is shown; data-table names the CSV that has the values in full."""
    texts = [any(isinstance(row.get(column.key), str) for row in table.rows) for column in table.columns]
    head = "".join(f'<th{" class=text" if is_text else ""}>{html.escape(column.title)}</th>'
                   for column, is_text in zip(table.columns, texts))
    rows = []
    for cells in table.cells():
        rows.append("<tr>" + "".join(f'<td class="text">{html.escape(cell)}</td>' if is_text
                                     else f"<td>{html.escape(cell)}</td>"
                                     for cell, is_text in zip(cells, texts)) + "</tr>")
    return f'<table data-table="{table.name}"><thead><tr>{head}</tr></thead><tbody>{"".join(rows)}</tbody></table>'


def rows_text(number: int) -> str:
    return f"{count(number)} row{'' if number == 1 else 's'}"


def shown_table(part: ShownTable) -> str:
    link = f'<a href="csv/{part.table.name}.csv">CSV</a>'
    if part.folded or part.listing:
        summary = f"{inline(part.caption)} {rows_text(len(part.table.rows))}"
        return (f'<details><summary>{summary}</summary><p class="caption">{link}</p>'
                f'<div class="scroll tall">{table_html(part.table)}</div></details>')
    caption = f'<p class="caption">{inline(part.caption)} {link}</p>'
    hint = '<p class="hint">More columns to the right →</p>' if len(part.table.columns) >= BROAD else ""
    return f'{caption}{hint}<div class="scroll">{table_html(part.table)}</div>'


def shown_figure(part: ShownFigure, drawing: Drawing) -> str:
    label = html.escape(part.caption)
    svg = drawing.for_page().replace("<svg ", f'<svg role="img" aria-label="{label}" ', 1)
    wide = ' class="wide"' if part.wide else ""
    return f'<figure id="figure-{drawing.name}"{wide}>{svg}<figcaption>{inline(part.caption)}</figcaption></figure>'


def section_html(section: Section, drawings: dict[int, Drawing]) -> str:
    """Figures that follow one another, with nothing but their tables between, stand side by side above those."""
    out = [f'<section id="{section.slug}"><h2>{inline(section.title)}</h2>']
    figures: list[str] = []
    tables: list[str] = []

    def flush() -> None:
        if figures:
            out.append('<div class="figures">' + "".join(figures) + "</div>")
        out.extend(tables)
        figures.clear()
        tables.clear()

    for part in section.parts:
        if isinstance(part, str):
            flush()
            if part:
                out.append(f"<p>{inline(part)}</p>")
        elif isinstance(part, ShownTable):
            tables.append(shown_table(part))
        elif id(part) in drawings and part.wide:
            flush()
            out.append(shown_figure(part, drawings[id(part)]))
        elif id(part) in drawings:
            figures.append(shown_figure(part, drawings[id(part)]))
    flush()
    out.append("</section>")
    return "\n".join(out)


def answer_html(section: Section, drawings: dict[int, Drawing]) -> str:
    """The sentences beside the figure, or above it on a narrow screen."""
    sentences = "".join(f"<p>{inline(part)}</p>" for part in section.parts if isinstance(part, str))
    figures = "".join(shown_figure(part, drawings[id(part)]) for part in section.parts
                      if isinstance(part, ShownFigure) and id(part) in drawings)
    return f'<div class="answer" id="{section.slug}"><div>{sentences}</div>{figures}</div>'


def page_html(title: str, lead: list[str], warnings: list[str], sections: list[Section],
              drawings: dict[int, Drawing]) -> str:
    """`drawings` by id() of the ShownFigure. A section without a title is the answer, and opens the page."""
    style = STYLE.replace("LIGHT", variables(THEMES[0])).replace("DARK", variables(THEMES[1]))
    titled = [section for section in sections if section.title]
    links = "".join(f'<a href="#{section.slug}">{inline(section.title)}</a>' for section in titled)
    top = "".join(answer_html(section, drawings) for section in sections if not section.title)
    top += "".join(f'<p class="warning">{inline(text)}</p>' for text in warnings)
    top += "".join(f'<p class="lead">{inline(text)}</p>' for text in lead)
    body = "\n".join(section_html(section, drawings) for section in titled)
    return f"""<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{html.escape(title)}</title>
<link rel="icon" href="data:,">
<style>{style}</style>
</head>
<body>
<header><h1>{inline(title)}</h1>{top}<nav>{links}</nav></header>
<main>
{body}
<footer>Made by <code>./run report</code>. Every number is in <a href="results.json">results.json</a> and in the CSV
files beside this page.</footer>
</main>
</body>
</html>
"""
