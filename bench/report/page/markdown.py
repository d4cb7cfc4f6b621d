"""docs/results.md: the answer, and the sections with tables or figures that are marked as published."""

from report.chapters.section import Part, Section, ShownFigure, ShownTable
from report.plots.drawing import Drawing
from report.tables.table import Table

NOTE = "<!-- Written by `./run report --publish`; do not edit. -->"


def table_markdown(table: Table) -> str:
    """Numbers to the right, texts to the left. Columns that hold nothing are left out."""
    def cell(text: str) -> str:
        return text.replace("|", "\\|")

    kept = [n for n, column in enumerate(table.columns) if any(row.get(column.key) is not None for row in table.rows)]
    is_text = [all(isinstance(row.get(table.columns[n].key), str | None) for row in table.rows) for n in kept]
    lines = ["| " + " | ".join(cell(table.columns[n].title) for n in kept) + " |",
             "|" + "|".join("---" if text else "--:" for text in is_text) + "|"]
    lines += ["| " + " | ".join(cell(cells[n]) for n in kept) + " |" for cells in table.cells()]
    return "\n".join(lines)


def shown_table(part: ShownTable) -> list[str]:
    """Blocks: Markdown inside of <details> needs empty lines around it."""
    if part.folded or part.listing:
        return [f"<details><summary>{part.caption}</summary>", table_markdown(part.table), "</details>"]
    return [part.caption, table_markdown(part.table)]


def figure_markdown(part: ShownFigure, drawing: Drawing) -> str:
    light, dark = (f"images/results_{drawing.name}_{theme}.svg" for theme in ("light", "dark"))
    return (f'<picture><source media="(prefers-color-scheme: dark)" srcset="{dark}">'
            f'<img alt="{part.caption}" src="{light}" width="520"></picture>\n\n*{part.caption}*')


def is_published(section: Section) -> bool:
    return not section.title or section.slug == "limits" or any(
        part.published for part in section.parts if not isinstance(part, str))


def blocks_of(part: Part, drawings: dict[int, Drawing]) -> list[str]:
    if isinstance(part, str):
        return [part] if part else []
    if not part.published:
        return []
    if isinstance(part, ShownTable):
        return shown_table(part)
    return [figure_markdown(part, drawings[id(part)])] if id(part) in drawings else []


def results_markdown(title: str, lead: list[str], warnings: list[str], sections: list[Section],
                     drawings: dict[int, Drawing]) -> str:
    """The sections without a title, which are the answer, come before everything else."""
    answer = [section for section in sections if not section.title]
    kept = [section for section in sections if section.title and is_published(section)]
    left = [section.title for section in sections if section.title and not is_published(section)]
    blocks = [NOTE, f"# {title}"]
    blocks += [block for section in answer for part in section.parts for block in blocks_of(part, drawings)]
    blocks += [f"> {warning}" for warning in warnings] + lead
    for section in kept:
        blocks.append(f"## {section.title}")
        blocks += [block for part in section.parts for block in blocks_of(part, drawings)]
    blocks += ["## The rest", the_rest(left)]
    return "\n\n".join(blocks) + "\n"


def the_rest(titles: list[str]) -> str:
    """What only the page has."""
    text = ("`./run report` writes the page that this is an extract of ([how](report.md)). It has every table and "
            "figure, and each number as CSV and JSON.")
    return text + (f" Only there: {'; '.join(titles)}." if titles else "")
