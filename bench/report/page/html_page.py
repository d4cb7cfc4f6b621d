"""One page without any other file: sections as HTML, figures as SVG in the page's colours."""

import html
import re

from report.chapters.section import Section, ShownFigure, ShownTable
from report.plots.drawing import Drawing
from report.plots.palette import COLOURS, THEMES
from report.tables.numbers import count
from report.tables.table import Table

CODE = re.compile(r"`([^`]+)`")
STRONG = re.compile(r"\*\*(.+?)\*\*")
EMPHASIS = re.compile(r"\*([^*]+)\*")

BROAD = 5  # columns that a narrow screen has no room for

STYLE = """
:root { color-scheme: light dark; --font: system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif; LIGHT }
@media (prefers-color-scheme: dark) { :root { DARK } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink); font: 16px/1.6 var(--font); }
main, header { max-width: 72rem; margin: 0 auto; padding: 0 1.1rem; }
header { padding-top: 2.6rem; }
h1 { font-size: clamp(1.6rem, 5vw, 2.3rem); line-height: 1.2; margin: 0 0 .5rem; letter-spacing: -.01em; }
h2 { font-size: 1.35rem; line-height: 1.3; margin: 3.2rem 0 .6rem; padding-top: .8rem; border-top: 1px solid var(--grid); }
p { max-width: 46rem; margin: .7rem 0; overflow-wrap: break-word; }
.lead { color: var(--muted); }
.warning { border-left: 3px solid var(--wrong); padding-left: .8rem; }
a { color: var(--accent); }
code { font: .92em ui-monospace, "DejaVu Sans Mono", monospace; background: var(--panel); padding: .05em .3em; border-radius: 3px; }
nav { display: flex; flex-wrap: wrap; gap: .25rem 1rem; margin: 1.2rem 0 0; font-size: .92rem; }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 27rem), 1fr)); gap: 1.2rem 2rem; margin: 1.1rem 0;
           align-items: start; }
figure { margin: 0; min-width: 0; }
figure.wide { max-width: 34rem; }
.figures > figure { max-width: 30rem; }
figure svg { display: block; width: 100%; height: auto; }
figcaption, .caption { font-size: .88rem; line-height: 1.45; color: var(--muted); margin: .35rem 0 .4rem; max-width: 46rem; }
.hint { display: none; }
@media (max-width: 48rem) { .hint { display: block; font-size: .82rem; color: var(--muted); margin: 0 0 .2rem; } }
.scroll { background: linear-gradient(to left, var(--paper) 30%, transparent) right / 2.5rem 100% no-repeat local,
          linear-gradient(to left, color-mix(in srgb, var(--ink) 28%, transparent), transparent) right / 1rem 100% no-repeat scroll;
          overflow-x: auto; max-width: 100%; margin: 0 0 1.3rem; border-top: 1px solid var(--grid); border-bottom: 1px solid var(--grid); }
table { border-collapse: collapse; font-size: .87rem; font-variant-numeric: tabular-nums; }
th, td { padding: .28rem .7rem; text-align: right; white-space: nowrap; }
th { font-weight: 600; vertical-align: bottom; white-space: normal; min-width: 4rem; line-height: 1.3; border-bottom: 1px solid var(--grid); }
th:first-child, td:first-child { text-align: left; position: sticky; left: 0; background: var(--paper); padding-left: 0; }
th.text, td.text { text-align: left; }
tbody tr:nth-child(even) td { background: color-mix(in srgb, var(--muted) 7%, transparent); }
tbody tr:nth-child(even) td:first-child { background: var(--panel); }
.tall { max-height: 28rem; overflow: auto; }
.tall thead th { position: sticky; top: 0; background: var(--paper); z-index: 1; }
details { margin: .9rem 0; } summary { cursor: pointer; color: var(--accent); font-size: .92rem; }
footer { margin: 4rem 0 2rem; color: var(--muted); font-size: .88rem; }
"""


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
        rows.append("<tr>" + "".join(f'<td class="text">{html.escape(cell)}</td>' if is_text else f"<td>{html.escape(cell)}</td>"
                                     for cell, is_text in zip(cells, texts)) + "</tr>")
    return f'<table data-table="{table.name}"><thead><tr>{head}</tr></thead><tbody>{"".join(rows)}</tbody></table>'


def rows_text(number: int) -> str:
    return f"{count(number)} row{'' if number == 1 else 's'}"


def shown_table(part: ShownTable) -> str:
    link = f'<a href="csv/{part.table.name}.csv">CSV</a>'
    caption = f'<p class="caption">{inline(part.caption)} {link}</p>'
    if part.folded:
        return (f'<details><summary>{inline(part.caption)} {rows_text(len(part.table.rows))}</summary><p class="caption">{link}</p>'
                f'<div class="scroll tall">{table_html(part.table)}</div></details>')
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


def page_html(title: str, lead: list[str], warnings: list[str], sections: list[Section], drawings: dict[int, Drawing]) -> str:
    """`drawings` by id() of the ShownFigure."""
    style = STYLE.replace("LIGHT", variables(THEMES[0])).replace("DARK", variables(THEMES[1]))
    links = "".join(f'<a href="#{section.slug}">{inline(section.title)}</a>' for section in sections)
    top = "".join(f'<p class="lead">{inline(text)}</p>' for text in lead)
    top += "".join(f'<p class="warning">{inline(text)}</p>' for text in warnings)
    body = "\n".join(section_html(section, drawings) for section in sections)
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
<footer>Made by <code>./run report</code>. Every number is in <a href="results.json">results.json</a> and in the CSV files beside
this page.</footer>
</main>
</body>
</html>
"""
