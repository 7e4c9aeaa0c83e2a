#!/usr/bin/env python3
"""What a picture by many ranks of softgl-mpi costs: the tables of COST.md.

python3 cost_model.py          prints the tables
python3 cost_model.py --check  compares them with COST.md beside this file
python3 cost_model.py --balls G FOLDER   writes the model of G x G x G balls as parts, to measure with
"""
import math
import os
import sys

# Measured on two cores, see COST.md.
PARSE = 570e6  # bytes of OBJ text a second and rank
PREPARE = 1.5e6  # triangles a second and rank: vertices of other ranks, normals, mesh
DRAW = 4e6  # triangles a second and rank
PACK = 110e6  # samples a second that are packed
MERGE = 450e6  # and merged
PNG = 69e6  # pixels a second, at the first rank
TRIANGLE_BYTES = 40  # of OBJ text

# Assumed: a cluster with a network of 100 Gbit/s and a parallel file system.
LATENCY = 2e-6  # seconds a message
NETWORK = 10e9  # bytes a second and rank
FILES = 100e9  # bytes a second of the file system as a whole
STREAM = 1e9  # and to one rank
OPENS = 20e3  # files opened a second, all ranks together
LAUNCH = 0.5, 0.1  # seconds to start ranks: once, and for each doubling

TILES = 128  # the picture is looked at in TILES x TILES tiles
SMALL = 1 << 18  # samples; see exchange_plan.cpp


def prime_factors(number):
    factors = []
    for prime in (7, 5, 3, 2):
        while number % prime == 0:
            factors.append(prime)
            number //= prime
    return factors if number == 1 else []


def plan(ranks, samples):
    """Ranks that take part, and the sizes of groups, as ExchangePlan has them."""
    most = 8 if samples <= SMALL else 2
    active = ranks
    while active > 1 and not prime_factors(active):
        active -= 1
    radices = []
    for factor in prime_factors(active):
        if radices and radices[-1] * factor <= most:
            radices[-1] *= factor
        else:
            radices.append(factor)
    return active, radices


def balls(count):
    """Tiles that each of count^3 balls of a cube covers in the default view, one bit each, row by row."""
    azimuth, elevation = math.radians(35), math.radians(25)
    right = math.cos(azimuth), 0.0, -math.sin(azimuth)
    back = math.sin(azimuth) * math.cos(elevation), math.sin(elevation), math.cos(azimuth) * math.cos(elevation)
    up = (-math.sin(azimuth) * math.sin(elevation), math.cos(elevation), -math.cos(azimuth) * math.sin(elevation))
    half = count / 2
    reach = max(sum(abs(c) for c in axis) * (half - 0.5) + 0.5 for axis in (right, up))
    scale = TILES * 0.49 / reach
    radius = 0.5 * scale
    masks = []
    for z in range(count):
        for y in range(count):
            for x in range(count):
                place = x + 0.5 - half, y + 0.5 - half, z + 0.5 - half
                middle_x = TILES / 2 + scale * sum(a * b for a, b in zip(right, place))
                middle_y = TILES / 2 - scale * sum(a * b for a, b in zip(up, place))
                mask = 0
                for row in range(max(0, int(middle_y - radius)), min(TILES, int(middle_y + radius) + 1)):
                    square = radius * radius - (row + 0.5 - middle_y) ** 2
                    if square <= 0:
                        continue
                    width = math.sqrt(square)
                    first, last = math.ceil(middle_x - width - 0.5), math.floor(middle_x + width - 0.5)
                    first, last = max(first, 0), min(last, TILES - 1)
                    if last >= first:
                        mask |= ((1 << (last - first + 1)) - 1) << (row * TILES + first)
                masks.append(mask)
    return masks


def message_of(mask, first, last, side):
    """Samples and bytes of a message about the tiles from first to last."""
    bits = (mask >> first) & ((1 << (last - first)) - 1)
    tile = side // TILES
    samples = bin(bits).count("1") * tile * tile
    runs = bin(bits & ~(bits << 1)).count("1") * tile
    return samples, 4 + 8 * runs + 12 * samples


def compose(masks, side):
    """Messages and bytes of the rank that sends most, and seconds of all rounds, for masks of ranks."""
    ranks = len(masks)
    active, radices = plan(ranks, side * side)
    sent = [[0, 0] for _ in range(ranks)]
    seconds = 0.0
    all_tiles = TILES * TILES
    slowest = 0.0
    for rank in range(active, ranks):
        samples, size = message_of(masks[rank], 0, all_tiles, side)
        sent[rank][0] += 1
        sent[rank][1] += size
        masks[rank - active] |= masks[rank]
        slowest = max(slowest, LATENCY + size / NETWORK + samples / PACK + samples / MERGE)
    seconds += slowest
    pieces = [(0, all_tiles)] * active
    stride = 1
    for radix in radices:
        slowest, merged = 0.0, list(masks)
        for rank in range(active):
            first, last = pieces[rank]
            own = rank // stride % radix
            cuts = [first + (last - first) * i // radix for i in range(radix + 1)]
            took = out = 0
            for member in range(radix):
                if member == own:
                    continue
                samples, size = message_of(masks[rank], cuts[member], cuts[member + 1], side)
                sent[rank][0] += 1
                sent[rank][1] += size
                out += size
                took += samples
                merged[rank + (member - own) * stride] |= masks[rank]
            slowest = max(slowest, (radix - 1) * LATENCY + out / NETWORK + took / PACK + took / MERGE)
        for rank in range(active):
            first, last = pieces[rank]
            own = rank // stride % radix
            pieces[rank] = first + (last - first) * own // radix, first + (last - first) * (own + 1) // radix
        masks[:] = merged
        seconds += slowest
        stride *= radix
    for rank in range(1, active):
        sent[rank][0] += 1
        sent[rank][1] += 4 * side * side * (pieces[rank][1] - pieces[rank][0]) // all_tiles
    return sent, seconds


def deal(masks, ranks):
    """What each rank covers where it has neighbours of the list."""
    dealt = [0] * ranks
    for i, mask in enumerate(masks):
        dealt[min(ranks - 1, (2 * i + 1) * ranks // (2 * len(masks)))] |= mask
    return dealt


def megabytes(size):
    return f"{size / 1e6:.2f}"


def bytes_table():
    lines = ["| ranks | messages, most of a rank | MB sent, most of a rank | MB sent, all ranks | rounds |",
             "|---:|---:|---:|---:|---:|"]
    small = balls(4)
    for ranks in (1, 2, 4):
        sent, _ = compose(deal(small, ranks), 1024)
        lines.append(f"| {ranks} | {max(m for m, _ in sent)} | {megabytes(max(b for _, b in sent))} | "
                     f"{megabytes(sum(b for _, b in sent))} | {len(plan(ranks, 1 << 20)[1])} |")
    return lines


def seconds_table():
    triangles, side = 1e9, 4096
    lines = ["| ranks | start | files | prepare | draw | compose | gather | PNG | all, s | MB sent, most of a rank | "
             "what binds |",
             "|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---|"]
    parts = balls(22)
    for ranks in (1, 2, 4, 10, 100, 1000, 10000):
        sent, composing = compose(deal(parts, ranks), side)
        text = triangles * TRIANGLE_BYTES
        stages = {
            "start": LAUNCH[0] + LAUNCH[1] * math.log2(ranks),
            "files": max(len(parts) / OPENS, text / min(FILES, STREAM * ranks), text / PARSE / ranks),
            "prepare": triangles / PREPARE / ranks,
            "draw": triangles / DRAW / ranks,
            "compose": composing,
            "gather": 0 if ranks == 1 else ranks * LATENCY + 4 * side * side / NETWORK,
            "PNG": side * side / PNG,
        }
        binds = max(stages, key=stages.get)
        row = " | ".join(f"{seconds:.2f}" for seconds in stages.values())
        lines.append(f"| {ranks} | {row} | {sum(stages.values()):.1f} | {megabytes(max(b for _, b in sent))} | "
                     f"{binds} |")
    return lines


def write_balls(count, folder):
    os.makedirs(folder, exist_ok=True)
    rows, columns = 24, 48
    number = 0
    for z in range(count):
        for y in range(count):
            for x in range(count):
                with open(f"{folder}/{number:05d}.obj", "w", encoding="ascii") as part:
                    for row in range(rows + 1):
                        for column in range(columns):
                            t, p = math.pi * row / rows, 2 * math.pi * column / columns
                            place = (x + 0.5 * math.sin(t) * math.cos(p), y + 0.5 * math.cos(t),
                                     z + 0.5 * math.sin(t) * math.sin(p))
                            part.write("v %.5f %.5f %.5f\n" % place)
                    for row in range(rows):
                        for column in range(columns):
                            a = row * columns + column + 1
                            b = row * columns + (column + 1) % columns + 1
                            part.write(f"f {a} {b} {b + columns} {a + columns}\n")
                number += 1


def main():
    if sys.argv[1:2] == ["--balls"]:
        write_balls(int(sys.argv[2]), sys.argv[3])
        return 0
    tables = "\n".join(bytes_table()) + "\n\n" + "\n".join(seconds_table()) + "\n"
    if sys.argv[1:] != ["--check"]:
        print(tables, end="")
        return 0
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "COST.md"), encoding="utf-8") as page:
        text = page.read()
    missing = [line for line in tables.splitlines() if line and line not in text]
    for line in missing:
        print("COST.md lacks: " + line)
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
