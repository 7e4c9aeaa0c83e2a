"""Draws hacks of xscreensaver with two libraries of OSMesa's ABI and compares the bytes of a frame.

    xscreensaver_hacks.py --shim libegl_on_osmesa.so --library softgl/libOSMesa.so.8 [HACK...]

Without names all hacks are drawn. A line a hack: its name, then "identical" or how many pixels differ and by how
much at most; "failed" where one of them writes no picture. With --pictures FOLDER each picture stays there as a PNG,
and the absolute difference beside it. Needs Xvfb, and numpy for the pictures.
"""

import argparse
import concurrent.futures
import os
import pathlib
import struct
import subprocess
import tempfile
import zlib

from virtual_screen import Screen

FOLDER = pathlib.Path("/usr/libexec/xscreensaver")
NO_HACKS = {"xscreensaver-gl-visual"}
# No picture of the desktop, a text that does not change.
SETTINGS = """grabDesktopImages: False
grabVideoFrames: False
chooseRandomImages: False
textMode: 1
textLiteral: softgl draws
"""


def hacks():
    """The programs that speak EGL."""
    return [f.name for f in sorted(FOLDER.iterdir()) if f.name not in NO_HACKS and b"eglSwapBuffers" in f.read_bytes()]


def draw(hack, file, environment, arguments, display):
    """The bytes that a hack writes, or nothing."""
    file.unlink(missing_ok=True)
    everything = dict(
        environment,
        PATH=f"{FOLDER}:{os.environ['PATH']}",  # they start helpers that stand beside them
        LD_PRELOAD=f"{arguments.shim} {environment['LIBRARY']}",
        DISPLAY=display,
        HOME=str(file.parent),
        LANG="C",
        EGL_ON_OSMESA_FRAME=str(arguments.frame),
        EGL_ON_OSMESA_FILE=str(file),
    )
    command = [str(FOLDER / hack), "-window", "-geometry", arguments.geometry]
    ours = environment["LIBRARY"] == arguments.library
    for _ in range(2):  # once, under load, a hack wrote no picture with OSMesa; nobody knows why
        with open(file.with_suffix(file.suffix + ".log"), "w") as log:
            try:
                code = subprocess.run(
                    command, env=everything, stdout=log, stderr=log, timeout=arguments.timeout
                ).returncode
            except subprocess.TimeoutExpired:
                code = -1
        if file.exists() or (ours and code < 0):  # a crash or a hang of the tested library is not forgiven
            break
    return file.read_bytes() if file.exists() else b""


def differences(ours, theirs):
    """How many pixels differ, and the greatest difference of a component."""
    pixels = {i // 4 for i in range(8, len(ours)) if ours[i] != theirs[i]}
    return len(pixels), max(abs(a - b) for a, b in zip(ours[8:], theirs[8:]))


def write_png(path, width, rows):
    """Rows of RGB bytes from the top."""

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, len(rows), 8, 2, 0, 0, 0)
    data = zlib.compress(b"".join(b"\0" + row for row in rows))
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", data) + chunk(b"IEND", b""))


def keep_pictures(folder, hack, ours, theirs):
    import numpy

    def image(data):
        width, height = struct.unpack("<ii", data[:8])
        return numpy.frombuffer(data[8:], numpy.uint8).reshape(height, width, 4)[::-1, :, :3].astype(int)

    images = {"softgl": image(ours), "osmesa": image(theirs)}
    if ours != theirs:
        images["difference"] = numpy.minimum(255, 8 * abs(images["softgl"] - images["osmesa"]))
    for name, pixels in images.items():
        write_png(folder / f"{hack}.{name}.png", pixels.shape[1], [r.astype(numpy.uint8).tobytes() for r in pixels])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--shim", required=True)
    parser.add_argument("--library", required=True)
    parser.add_argument("--against", default="libOSMesa.so.8")
    parser.add_argument("--frame", type=int, default=20)
    parser.add_argument("--geometry", default="640x480")
    parser.add_argument("--timeout", type=float, default=60)
    parser.add_argument("--pictures", type=pathlib.Path)
    parser.add_argument("hacks", nargs="*")
    arguments = parser.parse_args()
    sides = {
        "softgl": {"LIBRARY": arguments.library, "SOFTGL_QUADS": "osmesa"},
        "osmesa": {
            "LIBRARY": arguments.against,
            "GALLIUM_OVERRIDE_CPU_CAPS": "sse4.1",
            "MESA_GL_VERSION_OVERRIDE": "1.5",
        },
    }
    for name, value in os.environ.items():
        if name.startswith("SOFTGL_"):
            sides["softgl"][name] = value
    if arguments.pictures:
        arguments.pictures.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as home, Screen() as display, concurrent.futures.ThreadPoolExecutor(2) as two:
        home = pathlib.Path(home)
        (home / ".xscreensaver").write_text(SETTINGS)
        identical = 0
        names = arguments.hacks or hacks()
        for hack in names:
            pair = [
                two.submit(draw, hack, home / f"{hack}.{side}", environment, arguments, display)
                for side, environment in sides.items()
            ]
            ours, theirs = (each.result() for each in pair)
            if not ours or len(ours) != len(theirs):
                print(f"{hack}: failed ({len(ours)} and {len(theirs)} bytes)", flush=True)
                continue
            identical += ours == theirs
            if ours == theirs:
                print(f"{hack}: identical", flush=True)
            else:
                pixels, most = differences(ours, theirs)
                print(f"{hack}: {pixels} pixels differ, by {most} at most", flush=True)
            if arguments.pictures:
                keep_pictures(arguments.pictures, hack, ours, theirs)
        print(f"{identical} of {len(names)} are identical")


main()
