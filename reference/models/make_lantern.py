#!/usr/bin/env python3
"""Writes lantern.obj, lantern.mtl and wood.png, the model of README's first command (own work, CC0)."""
import math
import struct
import zlib

lines = ["# softgl's lantern, CC0. Written by make_lantern.py.", "mtllib lantern.mtl"]
count = [0, 0]  # vertices, texture coordinates


def vertex(x, y, z):
    lines.append(f"v {x:.4f} {y:.4f} {z:.4f}".replace("-0.0000", "0.0000"))
    count[0] += 1
    return count[0]


def coordinate(u, v):
    lines.append(f"vt {u:.4f} {v:.4f}")
    count[1] += 1
    return count[1]


def part(name, material, group=None):
    lines.append(f"o {name}")
    lines.append(f"usemtl {material}")
    if group is not None:
        lines.append(f"s {group}")


def face(corners):
    lines.append("f " + " ".join(str(c) for c in corners))


def revolve(profile, sides, turn=0.0, centre=(0, 0)):
    """A surface of revolution about the vertical; profile: (radius, height) from the bottom, radius 0 closes it."""
    rings = []
    for radius, height in profile:
        if radius == 0:
            rings.append([vertex(centre[0], height, centre[1])])
        else:
            angles = [turn + 2 * math.pi * i / sides for i in range(sides)]
            rings.append([vertex(centre[0] + radius * math.sin(a), height, centre[1] + radius * math.cos(a)) for a in angles])
    for low, high in zip(rings, rings[1:]):
        for i in range(sides):
            j = (i + 1) % sides
            corners = [low[i % len(low)], low[j % len(low)], high[j % len(high)], high[i % len(high)]]
            face(list(dict.fromkeys(corners)))


def torus(height, large, small, around, across):
    rings = []
    for i in range(around):
        a = 2 * math.pi * i / around
        ring = []
        for k in range(across):
            b = 2 * math.pi * k / across
            r = large + small * math.cos(b)
            ring.append(vertex(r * math.sin(a), height + r * math.cos(a), small * math.sin(b)))
        rings.append(ring)
    for i in range(around):
        low, high = rings[i], rings[(i + 1) % around]
        for k in range(across):
            face([low[k], low[(k + 1) % across], high[(k + 1) % across], high[k]])


def board(half, low, high, bevel):
    """A wooden board with bevelled corners: two eight-sided faces and a rim."""
    outline = []
    for sx, sz, order in ((1, 1, 0), (1, -1, 1), (-1, -1, 0), (-1, 1, 1)):
        corners = [(sx * half, sz * (half - bevel)), (sx * (half - bevel), sz * half)]
        outline += corners if order == 1 else corners[::-1]
    bottom = [vertex(x, low, z) for x, z in outline]
    top = [vertex(x, high, z) for x, z in outline]
    uv = [coordinate(0.5 + 0.5 * x / half, 0.5 - 0.5 * z / half) for x, z in outline]
    side = [coordinate(u, v) for u, v in ((0, 0), (1, 0), (1, 0.06), (0, 0.06))]
    lines.append("f " + " ".join(f"{t}/{c}" for t, c in zip(top, uv)))
    lines.append("f " + " ".join(f"{b}/{c}" for b, c in zip(bottom[::-1], uv[::-1])))
    for i in range(len(outline)):
        j = (i + 1) % len(outline)
        corners = (bottom[j], bottom[i], top[i], top[j])
        face([f"{c}/{t}" for c, t in zip(corners, side)])


SIDES = 6
HALF = math.radians(8)  # a pane, not a post, faces the three-quarter view


def corner(radius, i):
    a = HALF + 2 * math.pi * i / SIDES
    return radius * math.sin(a), radius * math.cos(a)


part("board", "wood")
board(1.25, -0.14, 0.0, 0.22)

part("base", "brass")
revolve([(0, 0), (0.98, 0), (0.98, 0.06), (0.93, 0.11), (0.80, 0.15), (0.76, 0.22), (0.78, 0.28), (0, 0.28)], 48)

part("posts", "brass")
for i in range(SIDES):
    revolve([(0.045, 0.28), (0.045, 0.36), (0.030, 0.40), (0.030, 1.60), (0.045, 1.64), (0.045, 1.72)], 12, 0, corner(0.70, i))

part("rails", "brass")
for height in (0.50, 1.50):
    for i in range(SIDES):
        (ax, az), (bx, bz) = corner(0.70, i), corner(0.70, i + 1)
        ring = []
        for x, z in ((ax, az), (bx, bz)):
            scale = 0.012 / 0.70
            ring.append([vertex(x * (1 + sx * scale), height + sy * 0.012, z * (1 + sx * scale))
                         for sx, sy in ((1, -1), (1, 1), (-1, 1), (-1, -1))])
        for k in range(4):
            face([ring[0][k], ring[1][k], ring[1][(k + 1) % 4], ring[0][(k + 1) % 4]])

part("candle", "wax")
revolve([(0.24, 0.28), (0.24, 0.90), (0.23, 0.93), (0.19, 0.94), (0.10, 0.905), (0, 0.90)], 32)
part("wick", "soot")
revolve([(0.012, 0.90), (0.010, 0.98), (0, 0.985)], 8)
part("flame", "flame", 1)
revolve([(0, 0.95), (0.045, 0.98), (0.070, 1.03), (0.072, 1.08), (0.058, 1.14), (0.036, 1.20), (0.016, 1.26), (0, 1.31)], 20)

part("ceiling", "brass", "off")
revolve([(0, 1.72), (0.80, 1.72), (0.80, 1.78)], SIDES, HALF)
part("roof", "copper", "off")
curve = []
for k in range(13):
    t = k / 12
    curve.append((1.12 * (1 - t) ** 1.7 + 0.16 * t, 1.72 + 0.05 * (1 - t) ** 6 + 0.78 * t ** 1.25))
rings = [[vertex(r * math.sin(HALF + 2 * math.pi * i / SIDES), y, r * math.cos(HALF + 2 * math.pi * i / SIDES))
          for i in range(SIDES)] for r, y in curve]
for i in range(SIDES):  # each side of the roof is smooth, the ridges between them are not
    lines.append(f"s {10 + i}")
    j = (i + 1) % SIDES
    for low, high in zip(rings, rings[1:]):
        face([low[i], low[j], high[j], high[i]])
part("finial", "brass", 2)
revolve([(0.16, 2.50), (0.20, 2.53), (0.20, 2.56), (0.10, 2.60), (0.08, 2.66), (0.13, 2.71), (0.14, 2.76), (0.10, 2.82), (0.04, 2.86), (0, 2.87)], 32)
part("ring", "brass", 3)
torus(3.09, 0.24, 0.035, 48, 14)

part("panes", "glass", "off")
for i in range(SIDES):
    (ax, az), (bx, bz) = corner(0.70, i), corner(0.70, i + 1)
    face([vertex(ax, 0.28, az), vertex(bx, 0.28, bz), vertex(bx, 1.72, bz), vertex(ax, 1.72, az)])

open("lantern.obj", "w").write("\n".join(lines) + "\n")

open("lantern.mtl", "w").write("""# softgl's lantern, CC0
newmtl wood
Kd 1 1 1
Ks 0.12 0.12 0.12
Ns 20
map_Kd wood.png

newmtl brass
Ka 0.55 0.38 0.12
Kd 0.72 0.50 0.16
Ks 0.75 0.65 0.40
Ns 45

newmtl copper
Ka 0.34 0.14 0.09
Kd 0.62 0.27 0.18
Ks 0.50 0.32 0.24
Ns 28

newmtl wax
Kd 0.92 0.88 0.76
Ke 0.10 0.07 0.02
Ks 0.15 0.15 0.12
Ns 12

newmtl soot
Kd 0.05 0.05 0.05

newmtl flame
Kd 0.30 0.20 0.05
Ke 0.95 0.66 0.16

newmtl glass
Kd 0.75 0.88 0.90
Ks 0.9 0.9 0.9
Ns 90
d 0.18
""")


def noise(x, y):
    n = (x * 374761393 + y * 668265263) & 0xFFFFFFFF
    n = ((n ^ (n >> 13)) * 1274126177) & 0xFFFFFFFF
    return ((n ^ (n >> 16)) & 0xFFFF) / 65535.0


def wood(u, v, size):
    plank = int(v * 5)
    grain = math.sin(40 * (v * 5 - plank) + 3.0 * math.sin(2 * math.pi * (u + 0.37 * plank)) + 7 * plank)
    fibre = noise(int(u * size / 6), int(v * size))
    tone = 0.78 + 0.10 * grain + 0.10 * fibre + 0.06 * math.sin(5 * plank)
    if min(v * 5 - plank, plank + 1 - v * 5) < 0.03:
        tone *= 0.45
    return bytes(int(255 * min(1, tone * c)) for c in (0.66, 0.45, 0.28))


SIZE = 128
rows = b"".join(b"\0" + b"".join(wood((x + 0.5) / SIZE, (y + 0.5) / SIZE, SIZE) for x in range(SIZE)) for y in range(SIZE))


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


open("wood.png", "wb").write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", SIZE, SIZE, 8, 2, 0, 0, 0)) +
                             chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))
