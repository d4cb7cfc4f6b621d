"""SVG text made shorter, without a difference that can be seen."""

import itertools
import re

# Attributes that hold coordinates, and numbers in them that are finer than a hundredth of a point.
COORDINATES = re.compile(r' (?:d|x|y|x1|y1|x2|y2|points|transform)="[^"]*"')
FINE = re.compile(r"-?\d+\.\d{3,}")
PATH = re.compile(r'<path (d="[^"]*")( [^>]*?)/>')
PATHS = re.compile(f"(?:{PATH.pattern}){{3,}}")


def shortened(svg: str) -> str:
    """matplotlib writes six digits of a coordinate, and the style of each of a thousand triangles."""
    return grouped_paths(re.sub(r">\s+<", "><", rounded_coordinates(svg)))


def rounded_coordinates(svg: str) -> str:
    """To a hundredth of a point."""
    def rounded(number: re.Match[str]) -> str:
        return f"{round(float(number.group()), 2):g}"

    return COORDINATES.sub(lambda attribute: FINE.sub(rounded, attribute.group()), svg)


def grouped_paths(svg: str) -> str:
    """Paths that follow one another in one style share it."""
    def grouped(run: re.Match[str]) -> str:
        out = []
        for style, paths in itertools.groupby(PATH.findall(run.group()), key=lambda path: path[1]):
            shapes = [f"<path {shape}/>" for shape, _ in paths]
            out.append(f"<g{style}>{''.join(shapes)}</g>" if len(shapes) > 1 else shapes[0].replace("/>", f"{style}/>"))
        return "".join(out)

    return PATHS.sub(grouped, svg)
