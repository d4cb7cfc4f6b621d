#!/usr/bin/python3
"""Draws models/*.obj with their names onto one sheet: contact_sheet.py [PICTURE] [NAME ...].

Needs the Debian packages python3-numpy, python3-pil and fonts-dejavu-core. A z-buffer, the normals of the files and
the light of a soft sky: many distant lights, each with a shadow map. All models take some three minutes.
"""
import math
import os
import sys

import numpy
from PIL import Image, ImageDraw, ImageFont

HERE = os.path.dirname(os.path.abspath(__file__))
TILE = int(os.environ.get("TILE", "400"))  # pixels
SAMPLES = 3  # a pixel's side, for antialiasing
LIGHTS = int(os.environ.get("LIGHTS", "48"))
SHADOW_MAP = 640
BACKGROUND = numpy.array([0.86, 0.88, 0.90])

# Name in the report, file, and the camera's turn about the upright axis and height, in degrees.
MODELS = [
    ("Car", "car", 38, 20), ("Cube", "cube", 30, 24), ("Rook", "rook", 20, 24),
    ("Pedestal", "pedestal", 28, 20), ("Horse", "horse", 60, 14), ("Icosphere", "icosphere", 20, 18),
    ("Bishop", "bishop", 35, 14), ("Cylinder", "cylinder", 20, 24), ("Pawn", "pawn", 20, 16),
    ("Cone", "cone", 20, 18), ("Barrel", "barrel", 20, 26), ("King", "king", 24, 14),
    ("Sphere", "sphere", 20, 18), ("Queen", "queen", 20, 20), ("Monkey", "monkey", 24, 8),
]


def read_obj(path):
    """Positions, normals and colours by triangle corner: (n, 3, 3), (n, 3, 3), (n, 3); and the vertex count."""
    colours, name = {}, None
    with open(os.path.join(HERE, "models", "models.mtl")) as lines:
        for line in lines:
            words = line.split()
            if words[:1] == ["newmtl"]:
                name = words[1]
            elif words[:1] == ["Kd"]:
                colours[name] = [float(w) for w in words[1:]]
    v, vn, p, n, c, corners, colour = [], [], [], [], [], set(), [0.8, 0.8, 0.8]
    with open(path) as lines:
        for line in lines:
            words = line.split()
            if words[0] == "v":
                v.append([float(w) for w in words[1:]])
            elif words[0] == "vn":
                vn.append([float(w) for w in words[1:]])
            elif words[0] == "usemtl":
                colour = colours[words[1]]
            elif words[0] == "f":
                corners.update(words[1:])
                refs = [[int(i) for i in w.split("/")] for w in words[1:]]
                p.append([v[r[0] - 1] for r in refs])
                n.append([vn[r[2] - 1] for r in refs])
                c.append(colour)
    return numpy.array(p), numpy.array(n), numpy.array(c), len(corners)


def rasterise(screen, width, height):
    """Nearest triangle (or -1), depth and barycentric coordinates at each pixel's centre; x, y in pixels, z away."""
    nearest = numpy.full((height, width), numpy.inf)
    which = numpy.full((height, width), -1, dtype=int)
    weights = numpy.zeros((height, width, 2))
    for t, (a, b, c) in enumerate(screen):
        area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        if area == 0:
            continue
        x0, x1 = max(0, math.floor(min(a[0], b[0], c[0]))), min(width, math.ceil(max(a[0], b[0], c[0])) + 1)
        y0, y1 = max(0, math.floor(min(a[1], b[1], c[1]))), min(height, math.ceil(max(a[1], b[1], c[1])) + 1)
        if x0 >= x1 or y0 >= y1:
            continue
        x, y = numpy.arange(x0, x1)[None, :] + 0.5, numpy.arange(y0, y1)[:, None] + 0.5
        wb = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area
        wc = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area
        z = a[2] + wb * (b[2] - a[2]) + wc * (c[2] - a[2])
        region = (slice(y0, y1), slice(x0, x1))
        hit = (wb >= 0) & (wc >= 0) & (wb + wc <= 1) & (z < nearest[region])
        nearest[region][hit] = z[hit]
        which[region][hit] = t
        weights[region][hit] = numpy.stack([wb, wc], -1)[hit]
    return which, nearest, weights


def frame(direction):
    """Rows: right, up and towards `direction`."""
    back = direction / numpy.linalg.norm(direction)
    right = numpy.cross([0, 1, 0], back)
    right /= numpy.linalg.norm(right)
    return numpy.array([right, numpy.cross(back, right), back])


def from_angles(turn, rise):
    turn, rise = math.radians(turn), math.radians(rise)
    return numpy.array([math.sin(turn) * math.cos(rise), math.sin(rise), math.cos(turn) * math.cos(rise)])


def sky(camera_turn):
    """Directions and strengths of the lights: a key light's disc at the upper left and an even sky."""
    lights = []
    key = frame(from_angles(camera_turn - 48, 48))
    number = LIGHTS // 4
    for k in range(number):
        r, phi = 0.22 * math.sqrt((k + 0.5) / number), k * 2.39996
        lights.append((key.T @ numpy.array([r * math.cos(phi), r * math.sin(phi), 1.0]), 0.62 / number))
    number = LIGHTS - number
    for k in range(number):
        rise = math.asin((k + 0.5) / number) if k % 4 else -math.asin((k + 0.5) / number) * 0.5
        lights.append((from_angles(k * 137.508, math.degrees(rise)), (0.85 if k % 4 else 0.35) / number))
    return [(d / numpy.linalg.norm(d), w) for d, w in lights]


def lit(points, normals, triangles, turn):
    """Light that reaches the points, (m,): sum over the lights of cosine and visibility."""
    total = numpy.zeros(len(points))
    radius = numpy.linalg.norm(triangles.reshape(-1, 3), axis=1).max() * 1.02
    scale = SHADOW_MAP / (2 * radius)
    for direction, strength in sky(turn):
        axes = frame(direction)
        turned = triangles @ axes.T
        screen = numpy.stack([(turned[..., 0] + radius) * scale, (turned[..., 1] + radius) * scale, -turned[..., 2]], -1)
        _, depth, _ = rasterise(screen, SHADOW_MAP, SHADOW_MAP)
        cosine = normals @ direction
        place = (points + normals * (2.5 / scale)) @ axes.T
        x, y = ((place[:, 0] + radius) * scale).astype(int), ((place[:, 1] + radius) * scale).astype(int)
        inside = (x >= 0) & (x < SHADOW_MAP) & (y >= 0) & (y < SHADOW_MAP)
        seen = numpy.ones(len(points), dtype=bool)
        seen[inside] = depth[y[inside], x[inside]] > -place[inside, 2] - 0.5 / scale
        total += strength * numpy.clip(cosine, 0, None) * seen
    return total


def draw(name, turn, rise):
    triangles, normals, colours, vertices = read_obj(os.path.join(HERE, "models", name + ".obj"))
    size = TILE * SAMPLES
    axes = frame(from_angles(turn, rise))
    reach = numpy.linalg.norm(triangles.reshape(-1, 3), axis=1).max()
    distance = 6.0 * reach
    turned = triangles @ axes.T
    flat = turned[..., :2] / (distance - turned[..., 2:])
    # The picture of the model fills the tile, whatever its shape.
    low, high = flat.reshape(-1, 2).min(axis=0), flat.reshape(-1, 2).max(axis=0)
    zoom, middle = 0.80 * size / (high - low).max(), (low + high) / 2
    pixel = (flat - middle) * zoom
    screen = numpy.stack([pixel[..., 0] + size / 2, size / 2 - pixel[..., 1], -1 / (distance - turned[..., 2])], -1)
    which, _, weights = rasterise(screen, size, size)

    # Every pixel's ray; the ground lies under the lowest point.
    ys, xs = numpy.mgrid[0:size, 0:size]
    plane = numpy.stack([(xs + 0.5 - size / 2) / zoom + middle[0], (size / 2 - ys - 0.5) / zoom + middle[1]], -1)
    rays = numpy.concatenate([plane, -numpy.ones((size, size, 1))], -1) @ axes
    eye = axes[2] * distance
    ground = triangles[..., 1].min()

    hit = which >= 0
    t = which[hit]
    wb, wc = weights[hit][:, :1], weights[hit][:, 1:]
    # Interpolation in the picture is not that in space; corners divided by their distance are.
    inverse = 1 / (distance - turned[..., 2])[t]
    w = numpy.concatenate([1 - wb - wc, wb, wc], 1) * inverse
    w /= w.sum(axis=1, keepdims=True)
    points = (triangles[t] * w[..., None]).sum(axis=1)
    shading = (normals[t] * w[..., None]).sum(axis=1)
    shading /= numpy.linalg.norm(shading, axis=1, keepdims=True)
    image = numpy.tile(BACKGROUND, (size, size, 1))
    light = lit(points, shading, triangles, turn)
    view = eye - points
    view /= numpy.linalg.norm(view, axis=1, keepdims=True)
    rim = (1 - numpy.clip((shading * view).sum(axis=1), 0, 1)) ** 4
    half = view + from_angles(turn - 48, 48)
    half /= numpy.linalg.norm(half, axis=1, keepdims=True)
    gloss = numpy.clip((shading * half).sum(axis=1), 0, 1) ** 40
    image[hit] = colours[t] * (0.10 + 1.18 * light)[:, None] + (0.06 * rim + 0.10 * gloss)[:, None]

    down = rays[..., 1] < -1e-3
    floor = ~hit & down
    steps = (ground - eye[1]) / rays[floor][:, 1]
    floor_points = eye + rays[floor] * steps[:, None]
    up = numpy.tile([0.0, 1.0, 0.0], (len(floor_points), 1))
    near = numpy.linalg.norm(floor_points - [0, ground, 0], axis=1) < 3 * reach
    shade = numpy.ones(len(floor_points))
    open_sky = sum(s * max(d[1], 0) for d, s in sky(turn))
    shade[near] = lit(floor_points[near], up[near], triangles, turn) / open_sky
    image[floor] = BACKGROUND * (0.35 + 0.65 * shade)[:, None]
    small = image.reshape(TILE, SAMPLES, TILE, SAMPLES, 3).mean(axis=(1, 3))
    encoded = (numpy.clip(small, 0, 1) ** (1 / 1.6) * 255 + 0.5).astype(numpy.uint8)
    return Image.fromarray(encoded), len(triangles), vertices


def main():
    picture = sys.argv[1] if len(sys.argv) > 1 else os.path.join(HERE, "..", "docs", "images", "models.jpg")
    chosen = [m for m in MODELS if len(sys.argv) < 3 or m[1] in sys.argv[2:]]
    columns = min(5, len(chosen))
    caption, gap = 50, 10
    rows = (len(chosen) + columns - 1) // columns
    sheet = Image.new("RGB", (columns * (TILE + gap) + gap, rows * (TILE + caption + gap) + gap), "white")
    pen = ImageDraw.Draw(sheet)
    fonts = "/usr/share/fonts/truetype/dejavu/DejaVuSans"
    large, small = ImageFont.truetype(fonts + "-Bold.ttf", 20), ImageFont.truetype(fonts + ".ttf", 14)
    for k, (title, name, turn, rise) in enumerate(chosen):
        if os.environ.get("TURN"):
            turn = float(os.environ["TURN"])
        tile, faces, vertices = draw(name, turn, rise)
        x, y = gap + k % columns * (TILE + gap), gap + k // columns * (TILE + caption + gap)
        sheet.paste(tile, (x, y))
        pen.text((x + TILE / 2, y + TILE + 14), title, fill="black", font=large, anchor="mm")
        pen.text((x + TILE / 2, y + TILE + 36), f"{faces} faces, {vertices} vertices", fill="#555", font=small, anchor="mm")
    sheet.save(picture, quality=85, subsampling=0, progressive=True, optimize=True)  # the former three: of a JPEG


if __name__ == "__main__":
    main()
