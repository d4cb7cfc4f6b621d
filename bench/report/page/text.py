"""The tables of the page as text, for a terminal."""

from report.chapters.section import Section, ShownTable
from report.tables.table import Table

GAP = "  "


def table_text(table: Table) -> str:
    """Columns that hold nothing are left out. Texts to the left, numbers to the right."""
    cells = table.cells()
    kept = [n for n, column in enumerate(table.columns) if any(row.get(column.key) is not None for row in table.rows)]
    is_text = {n: any(isinstance(row.get(table.columns[n].key), str) for row in table.rows) for n in kept}
    lines = [[column.title for column in table.columns], *cells]
    widths = {n: max(len(line[n]) for line in lines) for n in kept}
    lines.insert(1, ["-" * widths.get(n, 0) for n in range(len(table.columns))])
    return "\n".join(GAP.join(line[n].ljust(widths[n]) if is_text[n] else line[n].rjust(widths[n])
                              for n in kept).rstrip()
                     for line in lines)


def plain_text(sentence: str) -> str:
    """Without Markdown's marks."""
    return sentence.replace("**", "").replace("*", "").replace("`", "")


def text_page(sections: list[Section], closing: list[str]) -> str:
    """Every table but the mere listings, by section, and then the closing sentences."""
    blocks = []
    for section in sections:
        tables = [part for part in section.parts
                  if isinstance(part, ShownTable) and not part.listing and part.table.rows]
        if tables:
            title = plain_text(section.title)
            blocks.append(f"{title}\n{'=' * len(title)}")
            blocks += [f"{plain_text(part.caption)}\n\n{table_text(part.table)}" for part in tables]
    return "\n\n".join(blocks + [plain_text(sentence) for sentence in closing]) + "\n"
