"""Colours of the page and its plots, light and dark, that colour-blind readers can tell apart.

After Okabe and Ito, "Color universal design" (2008), darkened or lightened where the background asks for it. Every
series has a marker and a dash pattern of its own as well, so that no plot depends on colour.
"""

from dataclasses import dataclass

THEMES = ("light", "dark")


@dataclass(frozen=True)
class Colour:
    """`token` is what is drawn with: a colour that stands for nothing else, and is replaced afterwards."""

    name: str
    token: str
    light: str
    dark: str

    def of(self, theme: str) -> str:
        return self.light if theme == "light" else self.dark


def colours(*rows: tuple[str, str, str]) -> dict[str, Colour]:
    return {name: Colour(name, f"#01{number:02x}01", light, dark) for number, (name, light, dark) in enumerate(rows, 1)}


COLOURS = colours(
    ("paper", "#ffffff", "#14171a"),
    ("ink", "#1b1f23", "#e6e8ea"),
    ("muted", "#5a6169", "#a3abb3"),
    ("grid", "#dfe3e7", "#2f353b"),
    ("panel", "#f5f7f8", "#1c2024"),
    ("accent", "#0060a8", "#6cb6f2"),
    ("grey", "#7b7f85", "#9aa0a6"),
    ("purple", "#b0508a", "#dd92bd"),
    ("orange", "#c98500", "#f0b13c"),
    ("blue", "#0072b2", "#5fb3ea"),
    ("vermilion", "#d04a00", "#ff8a4c"),
    ("green", "#00835f", "#2fc79b"),
    ("violet", "#5b4db5", "#a99cf5"),
    ("wrong", "#d04a00", "#ff8a4c"),
    ("right", "#0072b2", "#5fb3ea"),
    ("sky", "#56b4e9", "#a6dcff"),
    ("yellow", "#e8d83a", "#f4e96b"),
)


@dataclass(frozen=True)
class Style:
    """How a series is drawn."""

    colour: str
    marker: str
    dashes: str

    @property
    def token(self) -> str:
        return COLOURS[self.colour].token


STYLES = {
    "baseline/scan": Style("grey", "x", ":"),
    "baseline/two_bucket_hash": Style("purple", "v", "-."),
    "baseline/hash": Style("orange", "s", "--"),
    "baseline/remap": Style("blue", "^", "-"),
    "linear": Style("green", "<", "-"),
    "halfedge/cgal": Style("violet", "h", "--"),
    "halfedge": Style("vermilion", "o", "-"),
    "report": Style("ink", "D", "-"),
    "cgal_clip": Style("green", "P", "--"),
    "cgal_split": Style("violet", "d", "-."),
    "vtk_clip_closed_surface": Style("grey", "*", "--"),
    "section_by_cut": Style("purple", "v", "-."),
    "cgal_slicer": Style("green", "P", "--"),
    "vtk_cutter_loops": Style("grey", "*", "--"),
    "vtk_plane_cutter_loops": Style("orange", "s", ":"),
}


def style_of(name: str) -> Style:
    return STYLES.get(name, Style("muted", ".", "-"))
