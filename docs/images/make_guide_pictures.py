#!/usr/bin/python3
"""Draws the pictures of the guide (docs/guide) again: chain.svg, sides.svg, caps_with_a_hole.svg, buffers.svg.

They are drawn on white, so that they can be read on a dark page, too.
"""

import math
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
INK, RED, GREY = "#1f2328", "#d1242f", "#6e7781"
# Of the positive and of the negative side, and of their caps.
BLUE, ORANGE, BLUE_CAP, ORANGE_CAP = "#dbe9f6", "#f7e3d4", "#7fb2e0", "#eba878"


class Picture:
    def __init__(self, width, height):
        self.size = width, height
        self.parts = []

    def add(self, part):
        self.parts.append("  " + part)

    def polygon(self, points, fill, stroke=INK, width=2, close=True, more=""):
        path = "M" + " L".join(f"{x:.1f} {y:.1f}" for x, y in points) + (" Z" if close else "")
        self.add(f'<path d="{path}" fill="{fill}" stroke="{stroke}" stroke-width="{width}" stroke-linejoin="round"'
                 f'{more}/>')

    def line(self, a, b, stroke=INK, width=2, dashed=False, arrow=False):
        more = (' stroke-dasharray="5 4"' if dashed else "")
        self.add(f'<line x1="{a[0]:.1f}" y1="{a[1]:.1f}" x2="{b[0]:.1f}" y2="{b[1]:.1f}" stroke="{stroke}" '
                 f'stroke-width="{width}"{more}/>')
        if arrow:
            self.head(a, b, stroke)

    def head(self, a, b, fill):
        """An arrow's head at b, which comes from a."""
        angle = math.atan2(b[1] - a[1], b[0] - a[0])
        back = [(b[0] - 11 * math.cos(angle + turn), b[1] - 11 * math.sin(angle + turn)) for turn in (0.42, -0.42)]
        self.polygon([b] + back, fill, fill, 1)

    def box(self, x, y, width, height, fill, stroke=INK, round=0, more=""):
        self.add(f'<rect x="{x}" y="{y}" width="{width}" height="{height}" rx="{round}" fill="{fill}" '
                 f'stroke="{stroke}" stroke-width="2"{more}/>')

    def text(self, x, y, text, fill=INK, anchor="start", size=15, weight="normal", mono=False):
        family = ' font-family="DejaVu Sans Mono, Consolas, monospace"' if mono else ""
        self.add(f'<text x="{x}" y="{y}" fill="{fill}" text-anchor="{anchor}" font-size="{size}" '
                 f'font-weight="{weight}"{family}>{text}</text>')

    def write(self, name):
        width, height = self.size
        head = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" '
                f'height="{height}" font-family="Helvetica, Arial, sans-serif" font-size="15">\n'
                f'  <rect width="{width}" height="{height}" fill="#ffffff"/>\n')
        (FOLDER / name).write_text(head + "\n".join(self.parts) + "\n</svg>\n", encoding="utf-8")


def chain():
    """From a file to pieces, and where they go."""
    p = Picture(850, 250)

    def station(x, y, width, title, note, fill):
        p.box(x, y, width, 54, fill, round=8)
        p.text(x + width / 2, y + 24, title, anchor="middle", weight="bold")
        p.text(x + width / 2, y + 43, note, GREY, "middle", 13)

    def way(a, b, text, dy=-9):
        p.line(a, b, arrow=True)
        p.text((a[0] + b[0]) / 2, (a[1] + b[1]) / 2 + dy, text, anchor="middle", size=12, mono=True)

    station(10, 98, 126, "arrays, a file", "yours", "#ffffff")
    station(225, 98, 92, "Mesh", "repaired", BLUE)
    station(415, 98, 92, "Object", "can be cut", BLUE)
    station(575, 98, 100, "pieces", "Objects, too", ORANGE)
    way((136, 125), (223, 125), "make()")
    p.text(180, 146, "read_mesh()", anchor="middle", size=12, mono=True)
    way((317, 125), (413, 125), "prepare()")
    way((507, 125), (573, 125), "cut()")
    # Again.
    p.add(f'<path d="M625 96 C625 40 461 40 461 86" fill="none" stroke="{INK}" stroke-width="2"/>')
    p.head((461, 70), (461, 96), INK)
    p.text(543, 42, "as often as you like", anchor="middle", size=13)
    ends = ((24, "DrawView", "to the GPU"), (98, "mass, hulls", "to physics"), (172, "Mesh", "to arrays, a file"))
    for y, title, note in ends:
        station(722, y, 113, title, note, "#ffffff")
        p.line((675, 125), (720, y + 27), arrow=True)
    p.text(425, 236, "One preparing is enough: pieces are cut without another.", GREY, "middle", 13)
    p.write("chain.svg")


def sides():
    """The plane's normal and sides; a blade that has a width."""
    p = Picture(850, 290)

    def blob(cx, clip, fill):
        """What of a body lies above or below a height."""
        points = []
        for i in range(120):
            a = 2 * math.pi * i / 120
            r = 92 + 9 * math.sin(3 * a + 0.4) + 5 * math.cos(5 * a)
            points.append((cx + 1.35 * r * math.cos(a), 150 + 0.95 * r * math.sin(a)))
        side, height = clip
        kept = []
        for (ax, ay), (bx, by) in zip(points, points[1:] + points[:1]):
            if (ay <= height) == (side == "above"):
                kept.append((ax, ay))
            if (ay - height) * (by - height) < 0:
                kept.append((ax + (bx - ax) * (height - ay) / (by - ay), height))
        p.polygon(kept, fill)

    blob(200, ("above", 150.01), BLUE)
    blob(200, ("below", 150.01), ORANGE)
    p.line((20, 150), (390, 150), RED, 3)
    p.text(392, 142, "plane", RED, "end")
    p.line((200, 150), (200, 92), RED, 3, arrow=True)
    p.text(210, 112, "normal", RED)
    p.text(192, 128, "positive side", anchor="end")
    p.text(200, 195, "negative side", anchor="middle")
    p.text(200, 280, "points on the plane are positive", GREY, "middle", 13)

    blob(620, ("above", 138), BLUE)
    blob(620, ("below", 162), ORANGE)
    p.line((450, 150), (800, 150), RED, 2, dashed=True)
    p.line((450, 138), (800, 138), GREY, 1)
    p.line((450, 162), (800, 162), GREY, 1)
    p.line((785, 112), (785, 137), INK, 1.5, arrow=True)
    p.line((785, 188), (785, 163), INK, 1.5, arrow=True)
    p.text(800, 108, "gap", anchor="end")
    p.text(620, 280, "a blade of this width: what it touches is gone", GREY, "middle", 13)
    p.write("sides.svg")


def caps_with_a_hole():
    """A pipe and the two caps of its section, and the section with its loops."""
    p = Picture(850, 380)
    n = 16

    def ring(cx, cy, r, flat):
        angles = [2 * math.pi * (i + 0.5) / n for i in range(n)]
        return [(cx + r * math.cos(a), cy - flat * r * math.sin(a)) for a in angles]

    def annulus(cx, cy, flat, fill, inside, width=1):
        outer, inner = ring(cx, cy, 100, flat), ring(cx, cy, 52, flat)
        if inside:
            p.polygon(inner, inside, "none")
        for i in range(n):
            j = (i + 1) % n
            p.polygon([outer[i], outer[j], inner[i]], fill, "#ffffff", width)
            p.polygon([outer[j], inner[j], inner[i]], fill, "#ffffff", width)
        p.polygon(outer, "none", INK, 2)
        p.polygon(inner, "none", INK, 2)

    def wall(cx, top, bottom, flat, fill):
        """The outside of a pipe between two heights, its front half."""
        upper, lower = ring(cx, top, 100, flat), ring(cx, bottom, 100, flat)
        front_low = [q for q in lower if q[1] >= bottom]
        front_high = [q for q in upper if q[1] >= top]
        p.polygon(sorted(front_high) + sorted(front_low)[::-1], fill)

    flat = 0.34
    # The negative piece below, its cap seen from above; the positive piece is lifted off.
    wall(160, 250, 318, flat, ORANGE)
    annulus(160, 250, flat, ORANGE_CAP, "#ffffff")
    p.line((160 + 76, 250), (160 + 76, 196), RED, 2.5, arrow=True)
    # Of the positive piece the lower end is hidden: only its outline shows through.
    wall(160, 52, 128, flat, BLUE)
    annulus(160, 52, flat, BLUE, "#c4d9ee")
    hidden = ring(160, 128, 100, flat)
    p.polygon(hidden, "none", GREY, 1.2, more=' stroke-dasharray="4 3"')
    p.polygon(ring(160, 128, 52, flat), "none", GREY, 1.2, more=' stroke-dasharray="4 3"')
    p.line((160 - 76, 130), (160 - 76, 186), RED, 2.5, arrow=True)
    p.text(275, 80, "positive piece")
    p.text(275, 136, "its cap is below,")
    p.text(275, 155, "and looks down")
    p.text(275, 246, "the cap of the")
    p.text(275, 265, "negative piece")
    p.text(275, 284, "looks up")
    p.text(160, 372, "a pipe, cut across", GREY, "middle", 13)

    annulus(640, 175, 1.0, "#e6efe0", None)
    outer, inner = ring(640, 175, 100, 1.0), ring(640, 175, 52, 1.0)
    for i in range(n):
        j = (i + 1) % n
        p.line(outer[i], inner[i], "#9db58c", 1)
        p.line(outer[j], inner[i], "#9db58c", 1)
    p.polygon(outer, "none", RED, 3)
    p.polygon(inner, "none", "#7d3fb2", 3)
    p.head(outer[3], outer[4], RED)  # counter-clockwise
    p.head(outer[11], outer[12], RED)
    p.head(inner[4], inner[3], "#7d3fb2")  # clockwise
    p.head(inner[12], inner[11], "#7d3fb2")
    p.text(640, 180, "hole", anchor="middle")
    p.text(755, 110, "outer loop", RED)
    p.text(755, 252, "loop around", "#7d3fb2")
    p.text(755, 271, "the hole", "#7d3fb2")
    p.line((752, 247), (676, 211), "#7d3fb2", 1)
    p.line((752, 112), (712, 130), RED, 1)
    p.text(640, 40, "the section, seen from the positive side", anchor="middle")
    p.text(640, 372, "what lies between the loops is covered once", GREY, "middle", 13)
    p.write("caps_with_a_hole.svg")


def buffers():
    """What a cut adds to shared buffers, and what each piece draws."""
    p = Picture(850, 430)
    p.add('<defs><pattern id="new" width="8" height="8" patternTransform="rotate(45)" patternUnits="userSpaceOnUse">'
          '<line x1="0" y1="0" x2="0" y2="8" stroke="#2da44e" stroke-width="2.5"/></pattern></defs>')

    def bar(y, segments, label):
        p.text(128, y + 22, label, anchor="end")
        x = 140
        for width, fill, text in segments:
            p.box(x, y, width, 34, fill)
            if text:
                p.text(x + width / 2, y + 22, text, anchor="middle", size=13)
            x += width

    p.text(15, 30, "before the cut", weight="bold")
    bar(48, [(380, "#eef1f4", "all vertices")], "vertices")
    bar(96, [(150, BLUE, ""), (80, "#eef1f4", "at plane"), (150, ORANGE, "")], "indices")
    p.text(540, 62, "Some triangles lie above the plane")
    p.text(540, 82, "(blue), some below (orange). Those")
    p.text(540, 102, "at the plane are written anew, and")
    p.text(540, 122, "divided where it crosses them.")

    p.text(15, 178, "after it", weight="bold")
    bar(196, [(380, "#eef1f4", "as they were"), (150, "#ffffff", "")], "vertices")
    bar(244, [(150, BLUE, ""), (80, "#ffffff", "unused"), (150, ORANGE, ""),
              (65, BLUE, "parts"), (45, BLUE_CAP, "cap"), (65, ORANGE, "parts"), (45, ORANGE_CAP, "cap")], "indices")
    p.box(520, 196, 150, 34, "url(#new)")
    p.line((520, 186), (520, 292), "#1a7f37", 2.5, dashed=True)
    p.add('<path d="M522 176 H738" fill="none" stroke="#1a7f37" stroke-width="2"/>')
    p.head((700, 176), (740, 176), "#1a7f37")
    p.text(526, 168, "new: only this is uploaded", "#1a7f37", weight="bold")
    p.text(526, 308, "new_vertices_from, new_indices_from", "#1a7f37", size=12, mono=True)

    def piece(y, title, fill, spans):
        p.box(15, y, 113, 34, fill, round=8)
        p.text(71, y + 22, title, anchor="middle")
        for begin, end in spans:
            p.line((begin, y + 17), (end, y + 17), INK, 6)
        p.line((130, y + 17), (140, y + 17), INK, 2)

    piece(330, "piece above", BLUE, [(142, 288), (522, 628)])
    piece(376, "piece below", ORANGE, [(372, 518), (632, 738)])
    p.text(752, 352, "its ranges", GREY, size=13)
    p.text(752, 398, "its ranges", GREY, size=13)
    for x in (140, 290, 370, 520, 630, 740):
        p.line((x, 280), (x, 410), "#d0d7de", 1, dashed=True)
    p.write("buffers.svg")


if __name__ == "__main__":
    chain()
    sides()
    caps_with_a_hole()
    buffers()
