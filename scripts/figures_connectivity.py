#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Makes the pictures of docs/methods/polygons_and_solids.md again: figures_connectivity.py [PROGRAM] [FOLDER].

Each shows a source colored by place and a target that has the colors of its partners, as the program matched them."""

import math
import pathlib
import random
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent


def run(program, *arguments):
    subprocess.run([program, *map(str, arguments), "--quiet"], check=True)


def read_off(file):
    words = file.read_text().split()
    n, m = int(words[1]), int(words[2])
    points = [tuple(map(float, words[4 + 3 * i : 7 + 3 * i])) for i in range(n)]
    at = 4 + 3 * n
    return points, [list(map(int, words[at + 4 * t + 1 : at + 4 * t + 4])) for t in range(m)]


def read_medit(file):
    words = file.read_text().split()
    at = words.index("Vertices") + 1
    points = [tuple(map(float, words[at + 1 + 4 * i : at + 4 + 4 * i])) for i in range(int(words[at]))]
    at = words.index("Tetrahedra") + 1
    count = int(words[at])
    return points, [[int(w) - 1 for w in words[at + 1 + 5 * i : at + 5 + 5 * i]] for i in range(count)]


def write_obj(file, points, faces):
    lines = ["v {!r} {!r} {!r}".format(*p) for p in points] + ["f " + " ".join(str(c + 1) for c in f) for f in faces]
    file.write_text("\n".join(lines) + "\n")


def write_medit(file, points, cells):
    lines = ["MeshVersionFormatted 2", "Dimension 3", "Vertices", len(points)]
    lines += ["{!r} {!r} {!r} 0".format(*p) for p in points] + ["Tetrahedra", len(cells)]
    lines += [" ".join(str(i + 1) for i in c) + " 0" for c in cells] + ["End"]
    file.write_text("\n".join(map(str, lines)) + "\n")


def bent(point, curvature=0.9):
    x, y, z = point
    radius = 1 / curvature + y
    return radius * math.sin(curvature * x), radius * math.cos(curvature * x) - 1 / curvature, z


def turned(point, about_y, about_x):
    x, y, z = point
    x, z = x * math.cos(about_y) + z * math.sin(about_y), z * math.cos(about_y) - x * math.sin(about_y)
    return x, y * math.cos(about_x) - z * math.sin(about_x), z * math.cos(about_x) + y * math.sin(about_x)


def colors_by_place(points):
    low = [min(p[k] for p in points) for k in range(3)]
    high = [max(p[k] for p in points) for k in range(3)]
    return [[40 + 200 * (p[k] - low[k]) / (high[k] - low[k] or 1) for k in range(3)] for p in points]


def picture(points, faces, colors, left, width, height):
    """SVG polygons, those behind first, of what faces the viewer."""
    xs, ys = [p[0] for f in faces for p in [points[c] for c in f]], [points[c][1] for f in faces for c in f]
    scale = 0.94 * min(width / (max(xs) - min(xs)), height / (max(ys) - min(ys)))
    drawn = []
    for face in faces:
        a, b, c = (points[i] for i in face[:3])
        u, v = [b[k] - a[k] for k in range(3)], [c[k] - a[k] for k in range(3)]
        normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        length = math.sqrt(sum(x * x for x in normal))
        if length == 0 or normal[2] <= 0:
            continue
        light = 0.55 + 0.45 * (0.3 * normal[0] + 0.5 * normal[1] + 0.8 * normal[2]) / length
        color = [min(255, light * sum(colors[i][k] for i in face) / len(face)) for k in range(3)]
        x = [left + width / 2 + scale * (points[i][0] - (min(xs) + max(xs)) / 2) for i in face]
        y = [height / 2 - scale * (points[i][1] - (min(ys) + max(ys)) / 2) for i in face]
        corners = " ".join(f"{a:.1f},{b:.1f}" for a, b in zip(x, y, strict=True))
        depth = sum(points[i][2] for i in face) / len(face)
        drawn.append((depth, '<path d="M{}Z" fill="#{:02x}{:02x}{:02x}"/>'.format(corners, *map(int, color))))
    return [line for _, line in sorted(drawn)]


def write_picture(file, source, target, width=420, height=420):
    """Each a triple of points as the viewer sees them, faces and colors."""
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {2 * width} {height}">',
        '<rect width="100%" height="100%" fill="#fff"/>',
        '<g stroke="#222" stroke-width=".5" stroke-linejoin="round">',
    ]
    lines += picture(*source, 0, width, height) + picture(*target, width, width, height)
    file.write_text("\n".join(lines) + "\n</g></svg>\n")


def carried(colors, map_file, n_target):
    result = [[255, 255, 255]] * n_target
    for color, image in zip(colors, map_file.read_text().split(), strict=True):
        result[int(image)] = color
    return result


def quads_of(points, triangles):
    points, faces, middle = list(points), [], {}

    def add(*corners):
        points.append(tuple(sum(points[i][k] for i in corners) / len(corners) for k in range(3)))
        return len(points) - 1

    def between(a, b):
        key = min(a, b), max(a, b)
        if key not in middle:
            middle[key] = add(a, b)
        return middle[key]

    for a, b, c in triangles:
        ab, bc, ca, m = between(a, b), between(b, c), between(c, a), add(a, b, c)
        faces += [[a, ab, m, ca], [b, bc, m, ab], [c, ca, m, bc]]
    return points, faces


def draw_quads(program, work, file):
    run(program, "deform", "body", work / "body.off", "--subdivisions", 0)
    points, quads = quads_of(*read_off(work / "body.off"))
    order = list(range(len(points)))
    random.shuffle(order)
    moved = [None] * len(points)
    for i, p in enumerate(points):
        moved[order[i]] = bent(p)
    cut = [t for f in quads for t in ([f[0], f[1], f[2]], [f[0], f[2], f[3]])]
    other = [[order[c] for c in f[k:] + f[:k]] for f in quads for k in [random.randrange(2)]]
    other = [t for f in other for t in (f[:3], [f[0], f[2], f[3]])]
    write_obj(work / "a.obj", points, cut)
    write_obj(work / "b.obj", moved, other)
    run(program, "match", work / "a.obj", work / "b.obj", "--method", "exact", "-o", work / "map.txt")
    colors = colors_by_place(points)

    def is_shown(quad):
        x, y = (sum(points[c][k] for c in quad) / 4 for k in (0, 1))
        return x > -0.16 and y > 0.52

    shown = [k for k, quad in enumerate(quads) for _ in range(2) if is_shown(quad)]
    halves = [2 * k + i % 2 for i, k in enumerate(shown)]
    write_picture(
        file,
        ([turned(p, 0.3, 0.2) for p in points], [cut[k] for k in halves], colors),
        (
            [turned(p, 0.3, 0.2) for p in moved],
            [other[k] for k in halves],
            carried(colors, work / "map.txt", len(moved)),
        ),
    )


def faces_of(cells):
    """The surface of tetrahedra."""
    found = {}
    for a, b, c, d in cells:
        for face in ([b, c, d], [a, d, c], [a, b, d], [a, c, b]):
            key = tuple(sorted(face))
            found[key] = None if key in found else face
    return [face for face in found.values() if face]


def draw_solid(program, work, file):
    run(program, "convert", work / "body.off", work / "a.mesh", "--fill", 26)
    points, cells = read_medit(work / "a.mesh")
    order = list(range(len(points)))
    random.shuffle(order)
    moved = [None] * len(points)
    for i, p in enumerate(points):
        moved[order[i]] = bent(p)
    others = [[order[c] for c in cell] for cell in cells]
    write_medit(work / "b.mesh", moved, others)
    run(program, "match", work / "a.mesh", work / "b.mesh", "--method", "exact", "-o", work / "map.txt")
    middle = sum(p[2] for p in points) / len(points)
    behind = [k for k, cell in enumerate(cells) if sum(points[c][2] for c in cell) / 4 < middle]
    colors = colors_by_place(points)
    write_picture(
        file,
        ([turned(p, 0.45, 0.2) for p in points], faces_of([cells[k] for k in behind]), colors),
        (
            [turned(p, 0.45, 0.2) for p in moved],
            faces_of([others[k] for k in behind]),
            carried(colors, work / "map.txt", len(moved)),
        ),
    )


def draw_plane(program, work, file):
    n, m = 28, 18
    at = lambda x, y: y * (n + 1) + x  # noqa: E731
    points = [(x / n - 0.5, (y - m / 2) / n, 0.0) for y in range(m + 1) for x in range(n + 1)]
    triangles = []
    for y in range(m):
        for x in range(n):
            a, b, c, d = at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)
            inside = ((x - 8) ** 2 + (y - 9) ** 2 > 9) and ((x - 20) ** 2 + (y - 9) ** 2 > 16)
            if inside:
                triangles += [[a, b, c], [a, c, d]] if random.random() < 0.5 else [[a, b, d], [b, c, d]]
    order = list(range(len(points)))
    random.shuffle(order)
    moved = [None] * len(points)
    for i, p in enumerate(points):
        moved[order[i]] = bent(p, 2.2)
    others = [[order[c] for c in t] for t in triangles]
    write_obj(work / "a.obj", points, triangles)
    write_obj(work / "b.obj", moved, others)
    run(program, "match", work / "a.obj", work / "b.obj", "--method", "exact", "-o", work / "map.txt")
    colors = colors_by_place(points)
    colors = [[r, g, 140] for r, g, _ in colors]
    write_picture(
        file, (points, triangles, colors), (moved, others, carried(colors, work / "map.txt", len(moved))), 420, 300
    )


def main():
    program = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/counterpart").resolve()
    images = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else ROOT / "docs/images"
    with tempfile.TemporaryDirectory() as name:
        for kind, draw in (("quads", draw_quads), ("solid", draw_solid), ("plane", draw_plane)):
            random.seed(1)
            draw(program, pathlib.Path(name), images / f"connectivity_{kind}.svg")


if __name__ == "__main__":
    main()
