"""Draws in hidden windows of GLFW, whose contexts are OSMesa's (GLFW_OSMESA_CONTEXT_API).

    glfw_client.py FILE

Two windows share objects; one of them changes its size. What glReadPixels gives of each frame goes to the file: width,
height (int32), then the rows of RGBA bytes. GLFW loads libOSMesa.so.8. Needs Xvfb.
"""

import ctypes
import os
import struct
import sys

from virtual_screen import Screen

VISIBLE, CONTEXT_CREATION_API, OSMESA_CONTEXT_API = 0x00020004, 0x0002200B, 0x00036003
TRIANGLES, QUADS, COMPILE, DEPTH_TEST, TEXTURE_2D = 4, 7, 0x1300, 0x0B71, 0x0DE1
RGBA, UNSIGNED_BYTE, TEXTURE_MIN_FILTER, LINEAR = 0x1908, 0x1401, 0x2801, 0x2601
COLOR_AND_DEPTH = 0x4100
F, U, I, P = ctypes.c_float, ctypes.c_uint, ctypes.c_int, ctypes.c_void_p
COMMANDS = {
    "Clear": [U], "ClearColor": [F] * 4, "Begin": [U], "End": [], "Color3f": [F] * 3, "TexCoord2f": [F] * 2,
    "Vertex3f": [F] * 3, "Rotatef": [F] * 4, "Enable": [U], "NewList": [U, U], "EndList": [], "CallList": [U],
    "Viewport": [I] * 4, "TexImage2D": [U, I, I, I, I, I, U, U, P], "TexParameteri": [U, U, I], "BindTexture": [U, U],
    "ReadPixels": [I, I, I, I, U, U, P],
}


class Glfw:
    def __init__(self):
        self.library = ctypes.CDLL("libglfw.so.3")
        self.library.glfwCreateWindow.restype = self.library.glfwGetProcAddress.restype = P
        if not self.library.glfwInit():
            sys.exit("GLFW does not start")
        self.library.glfwWindowHint(VISIBLE, 0)
        self.library.glfwWindowHint(CONTEXT_CREATION_API, OSMESA_CONTEXT_API)

    def window(self, width, height, share=None):
        window = self.library.glfwCreateWindow(width, height, b"softgl", None, P(share))
        if not window:
            sys.exit("GLFW has no window with OSMesa")
        return window

    def make_current(self, window):
        self.library.glfwMakeContextCurrent(P(window))

    def resize(self, window, width, height):
        self.library.glfwSetWindowSize(P(window), width, height)
        self.library.glfwPollEvents()

    def swap(self, window):
        self.library.glfwSwapBuffers(P(window))

    def commands(self):
        class Gl:
            pass

        for name, arguments in COMMANDS.items():
            address = self.library.glfwGetProcAddress(b"gl" + name.encode())
            setattr(Gl, name, staticmethod(ctypes.CFUNCTYPE(None, *arguments)(address)))
        return Gl


def make_objects(gl):
    texels = bytes((x * 16, y * 16, (x ^ y) * 16, 255)[i] for y in range(16) for x in range(16) for i in range(4))
    gl.BindTexture(TEXTURE_2D, 3)
    gl.TexParameteri(TEXTURE_2D, TEXTURE_MIN_FILTER, LINEAR)
    gl.TexImage2D(TEXTURE_2D, 0, RGBA, 16, 16, 0, RGBA, UNSIGNED_BYTE, texels)
    gl.NewList(1, COMPILE)
    gl.Begin(QUADS)
    for s, t in ((0, 0), (1, 0), (1, 1), (0, 1)):
        gl.TexCoord2f(s, t)
        gl.Vertex3f(s - 0.4, t - 0.7, 0.3 * s)
    gl.End()
    gl.EndList()


def draw(gl, width, height, frame, file):
    gl.Viewport(0, 0, width, height)
    gl.ClearColor(0.1, 0.2, 0.3, 1)
    gl.Clear(COLOR_AND_DEPTH)
    gl.Enable(DEPTH_TEST)
    gl.Enable(TEXTURE_2D)
    gl.BindTexture(TEXTURE_2D, 3)
    gl.Rotatef(20 * frame, 0.3, 0.2, 1)
    gl.CallList(1)
    gl.BindTexture(TEXTURE_2D, 0)
    gl.Begin(TRIANGLES)
    for x, y in ((-1, -1), (1, -1), (0, 1)):
        gl.Color3f(x * 0.5 + 0.5, y * 0.5 + 0.5, 0.5)
        gl.Vertex3f(0.7 * x, 0.8 * y, 0.1 * x)
    gl.End()
    gl.Color3f(1, 1, 1)
    pixels = ctypes.create_string_buffer(width * height * 4)
    gl.ReadPixels(0, 0, width, height, RGBA, UNSIGNED_BYTE, pixels)
    file.write(struct.pack("<ii", width, height) + pixels.raw)


def main():
    with Screen() as display, open(sys.argv[1], "wb") as file:
        os.environ["DISPLAY"] = display
        glfw = Glfw()
        first = glfw.window(320, 240)
        second = glfw.window(100, 150, first)
        glfw.make_current(first)
        gl = glfw.commands()
        make_objects(gl)
        for frame in range(4):
            glfw.make_current(first)
            width, height = 320 - 31 * frame, 240 + 17 * frame
            if frame:
                glfw.resize(first, width, height)
                glfw.make_current(first)
            draw(gl, width, height, frame, file)
            glfw.swap(first)
            glfw.make_current(second)
            draw(gl, 100, 150, frame, file)
            glfw.swap(second)
        glfw.library.glfwTerminate()


main()
