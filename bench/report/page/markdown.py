"""docs/results.md: the sections' sentences, and the tables and figures marked as published."""

from report.chapters.section import Section, ShownFigure, ShownTable
from report.plots.drawing import Drawing
from report.tables.table import Table


def table_markdown(table: Table) -> str:
    """Numbers to the right, texts to the left."""
    def cell(text: str) -> str:
        return text.replace("|", "\\|")

    is_text = [all(isinstance(row.get(column.key), str | None) for row in table.rows) for column in table.columns]
    lines = ["| " + " | ".join(cell(column.title) for column in table.columns) + " |",
             "|" + "|".join("---" if text else "--:" for text in is_text) + "|"]
    lines += ["| " + " | ".join(cell(text) for text in cells) + " |" for cells in table.cells()]
    return "\n".join(lines)


def figure_markdown(part: ShownFigure, drawing: Drawing) -> str:
    light, dark = (f"images/results_{drawing.name}_{theme}.svg" for theme in ("light", "dark"))
    return (f'<picture><source media="(prefers-color-scheme: dark)" srcset="{dark}">'
            f'<img alt="{part.caption}" src="{light}" width="520"></picture>\n\n*{part.caption}*')


def results_markdown(title: str, lead: list[str], warnings: list[str], sections: list[Section],
                     drawings: dict[int, Drawing]) -> str:
    blocks = [f"# {title}", "*Written by `./run report --publish`; do not edit. The page that it makes has more: every table, every "
              "figure, and each number as CSV.*"] + lead + [f"> {warning}" for warning in warnings]
    for section in sections:
        kept = [part for part in section.parts if isinstance(part, str) or part.published]
        if not kept:
            continue
        blocks.append(f"## {section.title}")
        for part in kept:
            if isinstance(part, str):
                blocks += [part] if part else []
            elif isinstance(part, ShownTable):
                blocks += [part.caption, table_markdown(part.table)]
            elif id(part) in drawings:
                blocks.append(figure_markdown(part, drawings[id(part)]))
    return "\n\n".join(blocks) + "\n"
