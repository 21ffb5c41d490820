#!/usr/bin/env python3
"""Makes the scenes and probes in this folder; standard library only. Run it to remake them: python3 data/generate.py

knot.ply      a (2,3) torus knot over a round floor; binary PLY with normals, one component grey
courtyard.obj a small coloured courtyard, open above: walls, steps, a column; OBJ with MTL, hard edges, quads
cornell.json  a room of white, red and green walls, open at the front, with two boxes (one mesh, placed twice)
              and a panel of light under the ceiling; cornell_*.obj with cornell.mtl
sky.hdr       a clear sky with a small bright sun over brown ground, 256 x 128 latitude-longitude, RGBE
studio.hdr    three soft coloured boxes in a dark room, 128 x 64
"""
import json
import math
import os
import struct

HERE = os.path.dirname(os.path.abspath(__file__))


def path(name):
    return os.path.join(HERE, name)


def normalized(v):
    s = math.sqrt(sum(c * c for c in v))
    return tuple(c / s for c in v)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def write_ply(name, positions, normals, triangles):
    with open(path(name), "wb") as f:
        f.write(("ply\nformat binary_little_endian 1.0\ncomment made by data/generate.py\n"
                 f"element vertex {len(positions)}\nproperty float x\nproperty float y\nproperty float z\n"
                 "property float nx\nproperty float ny\nproperty float nz\n"
                 f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n").encode())
        for p, n in zip(positions, normals):
            f.write(struct.pack("<6f", *p, *n))
        for t in triangles:
            f.write(struct.pack("<B3i", 3, *t))


def knot():
    """A tube of radius 0.24 along the (2,3) torus knot, standing on a round floor of radius 3."""
    along, around, tube = 280, 20, 0.24

    def centre(i):
        t = 2 * math.pi * i / along
        r = 1 + 0.45 * math.cos(3 * t)
        return (r * math.cos(2 * t), 0.45 * math.sin(3 * t) * 1.1, r * math.sin(2 * t))

    positions, normals, triangles = [], [], []
    for i in range(along):
        a, b = centre(i - 1), centre(i + 1)
        tangent = normalized([b[k] - a[k] for k in range(3)])
        outward = normalized(cross(tangent, cross((centre(i)[0], 0.0, centre(i)[2]), tangent)))
        side = cross(tangent, outward)
        for j in range(around):
            c, s = math.cos(2 * math.pi * j / around), math.sin(2 * math.pi * j / around)
            n = normalized([outward[k] * c + side[k] * s for k in range(3)])
            positions.append([centre(i)[k] + tube * n[k] for k in range(3)])
            normals.append(n)
    for i in range(along):
        for j in range(around):
            a, b = i * around + j, i * around + (j + 1) % around
            c, d = (i + 1) % along * around + j, (i + 1) % along * around + (j + 1) % around
            triangles += [(a, b, c), (b, d, c)]
    # Outward orientation: the first triangle's normal agrees with its vertex normal.
    p = [positions[v] for v in triangles[0]]
    n = cross([p[1][k] - p[0][k] for k in range(3)], [p[2][k] - p[0][k] for k in range(3)])
    if sum(n[k] * normals[triangles[0][0]][k] for k in range(3)) < 0:
        triangles = [(a, c, b) for a, b, c in triangles]

    floor = min(p[1] for p in positions) - 0.02
    rings, sectors, first = 40, 96, len(positions)
    positions.append([0.0, floor, 0.0])
    normals.append((0.0, 1.0, 0.0))
    for r in range(1, rings + 1):
        radius = 3.0 * r / rings
        for s in range(sectors):
            t = 2 * math.pi * s / sectors
            positions.append([radius * math.cos(t), floor, radius * math.sin(t)])
            normals.append((0.0, 1.0, 0.0))
    for s in range(sectors):
        triangles.append((first, first + 1 + (s + 1) % sectors, first + 1 + s))
    for r in range(rings - 1):
        for s in range(sectors):
            a, b = first + 1 + r * sectors + s, first + 1 + r * sectors + (s + 1) % sectors
            c, d = a + sectors, b + sectors
            triangles += [(a, b, c), (b, d, c)]
    write_ply("knot.ply", positions, normals, triangles)


class Obj:
    """Quads cut into a grid; every patch keeps its own vertices, so edges stay hard without normals."""

    def __init__(self):
        self.vertices, self.lines, self.index = [], [], {}

    def vertex(self, p):
        key = tuple(round(c, 6) for c in p)
        if key not in self.index:
            self.index[key] = len(self.vertices) + 1
            self.vertices.append(key)
        return self.index[key]

    def material(self, name):
        self.lines.append(f"usemtl {name}")

    def patch(self, origin, u, v, cells_u, cells_v, skip=lambda middle: False):
        """The parallelogram origin + s u + t v without the cells whose middle is to be skipped; its normal is u x v."""
        at = lambda s, t: self.vertex([origin[k] + u[k] * s / cells_u + v[k] * t / cells_v for k in range(3)])
        for s in range(cells_u):
            for t in range(cells_v):
                if skip([origin[k] + u[k] * (s + 0.5) / cells_u + v[k] * (t + 0.5) / cells_v for k in range(3)]):
                    continue
                self.lines.append(f"f {at(s, t)} {at(s + 1, t)} {at(s + 1, t + 1)} {at(s, t + 1)}")

    def box(self, low, high, cell, bottom=False):
        d = [h - l for l, h in zip(low, high)]
        n = [max(1, round(c / cell)) for c in d]
        x, y, z = (d[0], 0, 0), (0, d[1], 0), (0, 0, d[2])
        neg = lambda a: tuple(-c for c in a)
        self.patch((low[0], high[1], high[2]), x, neg(z), n[0], n[2])          # top
        self.patch((low[0], low[1], high[2]), x, y, n[0], n[1])                # front
        self.patch((high[0], low[1], low[2]), neg(x), y, n[0], n[1])           # back
        self.patch((high[0], low[1], high[2]), neg(z), y, n[2], n[1])          # right
        self.patch((low[0], low[1], low[2]), z, y, n[2], n[1])                 # left
        if bottom:
            self.patch((low[0], low[1], low[2]), x, z, n[0], n[2])

    def write(self, name, library):
        with open(path(name), "w") as f:
            f.write(f"# made by data/generate.py\nmtllib {library}\n")
            for p in self.vertices:
                f.write("v " + " ".join(f"{c:g}" for c in p) + "\n")
            f.write("\n".join(self.lines) + "\n")


def courtyard():
    scene = Obj()
    scene.material("paving")
    # The paving meets the column: a square of 8 x 8 cells gives way to rings around it.
    sides, radius, height, rings = 32, 0.28, 1.6, 6
    middle, half, cell = (1.0, 0.25), 0.5, 0.125
    inside = lambda c, m: abs(c - m) < half
    scene.patch((-2, 0, 2), (4, 0, 0), (0, 0, -4), 32, 32,
                skip=lambda p: inside(p[0], middle[0]) and inside(p[2], middle[1]))
    square = [(half, -half + cell * k) for k in range(8)] + [(half - cell * k, half) for k in range(8)]
    square += [(-x, -z) for x, z in square]  # counter-clockwise seen from below, as the column's ring runs

    def ring(k, r, y):
        """Ring r of the paving: 0 on the column, `rings` on the square's border."""
        x, z = square[k % sides]
        s = radius / math.hypot(x, z)
        s += (1 - s) * r / rings
        return (middle[0] + s * x, y, middle[1] + s * z)

    for k in range(sides):
        for r in range(rings):
            q = [ring(k, r, 0), ring(k + 1, r, 0), ring(k + 1, r + 1, 0), ring(k, r + 1, 0)]
            scene.lines.append("f " + " ".join(str(scene.vertex(p)) for p in q))
    scene.material("red_wall")
    scene.patch((-2, 0, 2), (0, 0, -4), (0, 2, 0), 24, 12)      # left, facing +x
    scene.material("blue_wall")
    scene.patch((2, 0, -2), (0, 0, 4), (0, 2, 0), 24, 12)       # right, facing -x
    scene.material("plaster")
    scene.patch((-2, 0, -2), (4, 0, 0), (0, 2, 0), 24, 12)      # back, facing +z
    scene.material("stone")
    for i in range(3):
        scene.box((-2, 0.2 * i, -2), (0.25, 0.2 * (i + 1), -0.75 - 0.25 * i), 0.125)
    for k in range(sides):
        for j in range(12):
            y0, y1 = height * j / 12, height * (j + 1) / 12
            q = [ring(k + 1, 0, y0), ring(k, 0, y0), ring(k, 0, y1), ring(k + 1, 0, y1)]
            scene.lines.append("f " + " ".join(str(scene.vertex(p)) for p in q))
    scene.lines.append("f " + " ".join(str(scene.vertex(ring(-k, 0, height))) for k in range(sides)))  # the column's flat top
    scene.write("courtyard.obj", "courtyard.mtl")
    write_mtl("courtyard.mtl", (("paving", (0.55, 0.52, 0.48)), ("red_wall", (0.63, 0.11, 0.08)),
                                ("blue_wall", (0.12, 0.22, 0.55)), ("plaster", (0.75, 0.73, 0.68)),
                                ("stone", (0.6, 0.6, 0.6))))


def write_mtl(name, materials):
    with open(path(name), "w") as f:
        f.write("# made by data/generate.py\n")
        for material, kd in materials:
            f.write(f"newmtl {material}\nKd {kd[0]} {kd[1]} {kd[2]}\n")


def cornell():
    """Two units wide, high and deep, standing on y = 0 around the y axis; the front, towards +z, is open."""
    room, cells = Obj(), 28
    room.material("white")
    room.patch((-1, 0, 1), (2, 0, 0), (0, 0, -2), cells, cells)    # floor
    room.patch((-1, 2, -1), (2, 0, 0), (0, 0, 2), cells, cells)    # ceiling
    room.patch((-1, 0, -1), (2, 0, 0), (0, 2, 0), cells, cells)    # back
    room.material("red")
    room.patch((-1, 0, 1), (0, 0, -2), (0, 2, 0), cells, cells)    # left, facing +x
    room.material("green")
    room.patch((1, 0, -1), (0, 0, 2), (0, 2, 0), cells, cells)     # right, facing -x
    room.write("cornell_room.obj", "cornell.mtl")
    box = Obj()
    box.material("white")
    box.box((-0.5, 0, -0.5), (0.5, 1, 0.5), 1 / 12)
    box.write("cornell_box.obj", "cornell.mtl")
    panel = Obj()
    panel.material("lamp")
    panel.patch((-0.5, 0, -0.5), (1, 0, 0), (0, 0, 1), 8, 8)       # facing down
    panel.write("cornell_panel.obj", "cornell.mtl")
    write_mtl("cornell.mtl", (("white", (0.73, 0.73, 0.73)), ("red", (0.63, 0.06, 0.05)), ("green", (0.14, 0.45, 0.09)),
                              ("lamp", (0.78, 0.78, 0.78))))
    turned = lambda degrees: {"axis": [0, 1, 0], "degrees": degrees}
    objects = [
        {"name": "room", "file": "cornell_room.obj"},
        {"name": "tall-box", "file": "cornell_box.obj",
         "transform": {"scale": [0.56, 1.2, 0.56], "rotate": turned(18), "translate": [-0.34, 0, -0.32]}},
        {"name": "short-box", "file": "cornell_box.obj",
         "transform": {"scale": [0.56, 0.58, 0.56], "rotate": turned(-17), "translate": [0.36, 0, 0.34]}},
        {"name": "panel", "file": "cornell_panel.obj",
         "transform": {"scale": [0.6, 1, 0.5], "translate": [0, 1.98, 0]},
         "material": {"emission": [17, 12, 5]}}]
    with open(path("cornell.json"), "w") as f:
        rows = ",\n".join("    " + json.dumps(entry) for entry in objects)
        f.write('{\n  "$schema": "../docs/scene.schema.json",\n  "objects": [\n' + rows + "\n  ]\n}\n")


def write_hdr(name, width, height, radiance):
    """Latitude-longitude RGBE, rows run-length encoded as plain literal runs. radiance(direction) -> (r, g, b)."""
    def rgbe(c):
        m = max(c)
        if m < 1e-32:
            return (0, 0, 0, 0)
        f, e = math.frexp(m)
        s = f * 256.0 / m
        return tuple(int(x * s) for x in c) + (e + 128,)

    with open(path(name), "wb") as f:
        f.write(b"#?RADIANCE\n# made by data/generate.py\nFORMAT=32-bit_rle_rgbe\n\n")
        f.write(f"-Y {height} +X {width}\n".encode())
        for y in range(height):
            row = []
            for x in range(width):
                # The mapping of docs/conventions.md: the centre shows +z, the upper edge +y, +x lies to the left.
                theta, phi = math.pi * (y + 0.5) / height, math.pi * (1 - 2 * (x + 0.5) / width)
                s = math.sin(theta)
                row.append(rgbe(radiance((s * math.sin(phi), math.cos(theta), s * math.cos(phi)))))
            f.write(bytes((2, 2, width >> 8, width & 255)))
            for channel in range(4):
                values, x = [p[channel] for p in row], 0
                while x < width:
                    run = 1
                    while x + run < width and run < 127 and values[x + run] == values[x]:
                        run += 1
                    if run >= 4:
                        f.write(bytes((128 + run, values[x])))
                        x += run
                        continue
                    start = x
                    while x < width and x - start < 128:
                        if x + 3 < width and values[x] == values[x + 1] == values[x + 2] == values[x + 3]:
                            break
                        x += 1
                    f.write(bytes([x - start] + values[start:x]))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def sky():
    sun = normalized((0.55, 0.62, 0.56))

    def radiance(d):
        if d[1] < 0:
            g = 0.09 + 0.05 * -d[1]
            return (1.25 * g, 1.0 * g, 0.72 * g)
        horizon = (1 - d[1]) ** 3
        c = [0.16 + 0.55 * horizon, 0.32 + 0.50 * horizon, 0.78 + 0.28 * horizon]
        cosine = dot(d, sun)
        glow = 0.9 * math.exp(-(1 - cosine) * 14)
        c = [c[0] + 1.2 * glow, c[1] + glow, c[2] + 0.7 * glow]
        if cosine > math.cos(math.radians(2.2)):  # larger than the real sun, so that 256 x 128 pixels hold it
            c = [c[0] + 620, c[1] + 560, c[2] + 450]
        return c

    write_hdr("sky.hdr", 256, 128, radiance)


def studio():
    boxes = ((normalized((-1, 0.5, 0.7)), 0.45, (9, 5.5, 2.2)), (normalized((1, 0.3, 0.2)), 0.4, (1.2, 3.0, 8.0)),
             (normalized((0.1, 1, -0.3)), 0.55, (3.5, 3.5, 3.5)))

    def radiance(d):
        c = [0.035, 0.035, 0.04]
        for axis, size, colour in boxes:
            x = math.acos(max(-1.0, min(1.0, dot(d, axis)))) / size
            w = max(0.0, min(1.0, (1.15 - x) / 0.3))
            w = w * w * (3 - 2 * w)
            c = [a + w * b for a, b in zip(c, colour)]
        return c

    write_hdr("studio.hdr", 128, 64, radiance)


if __name__ == "__main__":
    knot()
    courtyard()
    cornell()
    sky()
    studio()
