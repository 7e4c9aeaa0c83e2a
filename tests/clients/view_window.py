"""Looks at the window of softgl view on a screen of Xvfb.

    view_window.py SOFTGL MODEL FOLDER

Draws the model in the window, and finds the picture that is saved on Xvfb's screen (a file of the format XWD, which Xvfb keeps
up to date). The model is a file that may be touched: its change ends the script. Leaves FOLDER/screen.ppm.
"""

import os
import struct
import subprocess
import sys
import time

from virtual_screen import Screen


def screen_rows(path):
    """Rows of RGB bytes."""
    with open(path, "rb") as file:
        data = file.read()
    header = struct.unpack(">25I", data[:100])
    size, width, height, bits, line, colors = (header[i] for i in (0, 4, 5, 11, 12, 19))
    if bits != 32 or header[7] != 0:  # blue, green, red and nothing
        sys.exit(f"the screen has pixels of {bits} bits")
    start, rows = size + 12 * colors, []
    for y in range(height):
        row = data[start + y * line : start + y * line + 4 * width]
        rgb = bytearray(3 * width)
        rgb[0::3], rgb[1::3], rgb[2::3] = row[2::4], row[1::4], row[0::4]
        rows.append(bytes(rgb))
    return rows


def picture_rows(path):
    with open(path, "rb") as file:
        data = file.read()
    _, size, _, pixels = data.split(b"\n", 3)
    width = int(size.split()[0])
    return [pixels[i : i + 3 * width] for i in range(0, len(pixels), 3 * width)]


def is_on(screen, picture):
    at = next((row.find(picture[0]) for row in screen if picture[0] in row), -1)
    tops = [y for y, row in enumerate(screen) if at >= 0 and row[at : at + len(picture[0])] == picture[0]]
    return any([row[at : at + len(picture[0])] for row in screen[y : y + len(picture)]] == picture for y in tops)


def main():
    program, model, folder = sys.argv[1:]
    script, picture, ready = (os.path.join(folder, name) for name in ("screen.txt", "saved.ppm", "ready.ppm"))
    with open(script, "w") as file:  # key 0 does nothing but to hide the message
        file.write(f"key p\ndrag left 60 20\nsave {picture}\nkey 0\nshot {ready}\nwait reload\n")
    with Screen(folder) as name:
        environment = dict(os.environ, DISPLAY=name, SDL_VIDEODRIVER="x11")
        command = [program, "view", model, "--size", "400x300", "--script", script]
        with subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL) as view:
            while not os.path.exists(ready) and view.poll() is None:
                time.sleep(0.02)
            rows = screen_rows(os.path.join(folder, "Xvfb_screen0"))
            os.utime(model)
            code = view.wait()
    with open(os.path.join(folder, "screen.ppm"), "wb") as file:
        file.write(b"P6\n%d %d\n255\n" % (len(rows[0]) // 3, len(rows)) + b"".join(rows))
    if code != 0:
        sys.exit(f"softgl view ends with {code}")
    if not is_on(rows, picture_rows(picture)):
        sys.exit("the screen shows something else")
    print("the screen shows the picture")


main()
