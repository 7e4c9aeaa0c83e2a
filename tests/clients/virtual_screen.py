"""A server for X without a screen: Xvfb on a number of its own choice."""

import os
import subprocess
import sys


class Screen:
    """Gives the value of DISPLAY; the server ends with the block. A folder gets its pixels as a file Xvfb_screen0."""

    def __init__(self, folder=None):
        self.folder = folder

    def __enter__(self):
        read, write = os.pipe()
        command = ["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x1024x24", "-nolisten", "tcp"]
        if self.folder:
            command += ["-fbdir", self.folder]
        self.server = subprocess.Popen(command, pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as answer:
            self.name = ":" + answer.readline().strip()
        if self.name == ":":
            sys.exit("Xvfb does not start")
        return self.name

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()
