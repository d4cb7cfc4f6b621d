"""A finished figure, whatever drew it: SVG text that follows the page's theme, or stands alone in one theme."""

import re
from dataclasses import dataclass

from report.plots.palette import COLOURS


@dataclass(frozen=True)
class Drawing:
    """SVG text in token colours."""

    name: str
    svg: str

    def for_page(self) -> str:
        """In the page's own colours: CSS variables, which change with the theme."""
        text = self.svg
        for colour in COLOURS.values():
            text = text.replace(colour.token, f"var(--{colour.name})")
        return text

    def for_file(self, theme: str) -> str:
        """In the colours of one theme, on its background."""
        text = self.svg
        for colour in COLOURS.values():
            text = text.replace(colour.token, colour.of(theme))
        box = re.search(r'viewBox="0 0 ([\d.]+) ([\d.]+)"', text)
        if not box:
            raise ValueError(f"figure {self.name} has no size")
        paper = f'<rect width="{box.group(1)}" height="{box.group(2)}" fill="{COLOURS["paper"].of(theme)}"/>'
        return re.sub(r"(<svg [^>]*>)", lambda tag: tag.group(1) + paper, text, count=1)
