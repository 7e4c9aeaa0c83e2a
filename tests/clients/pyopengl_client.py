"""pyopengl_client.py SCENE FILE: draws a scene with PyOpenGL and GLU into an OSMesa context and writes width, height (int32),
the rows of RGBA components as floats, and the rows of depths. LD_LIBRARY_PATH says which libOSMesa.so draws.
pyopengl_client.py --list prints the names of the scenes."""
import os
import struct
import sys

os.environ["PYOPENGL_PLATFORM"] = "osmesa"
from OpenGL import GL, GLU, osmesa  # noqa: E402  the platform must be known before
from OpenGL.arrays import ArrayDatatype  # noqa: E402

WIDTH, HEIGHT = 240, 180


def look():
    GL.glMatrixMode(GL.GL_PROJECTION)
    GLU.gluPerspective(45, WIDTH / HEIGHT, 1, 20)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GLU.gluLookAt(3, 2.5, 5, 0, 0, 0, 0, 1, 0)
    GL.glEnable(GL.GL_DEPTH_TEST)


def light():
    GL.glEnable(GL.GL_LIGHTING)
    GL.glEnable(GL.GL_LIGHT0)
    GL.glEnable(GL.GL_NORMALIZE)
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_POSITION, (2, 4, 5, 0))
    GL.glMaterialfv(GL.GL_FRONT_AND_BACK, GL.GL_DIFFUSE, (0.8, 0.5, 0.2, 1))
    GL.glMaterialfv(GL.GL_FRONT_AND_BACK, GL.GL_SPECULAR, (0.6, 0.6, 0.6, 1))
    GL.glMaterialf(GL.GL_FRONT_AND_BACK, GL.GL_SHININESS, 30)


def checkered_texture():
    texels = bytearray()
    for y in range(60):
        for x in range(100):
            texels += bytes((255, 255, 255) if (x // 10 + y // 10) % 2 else (x * 2, 40, y * 4))
    GL.glBindTexture(GL.GL_TEXTURE_2D, GL.glGenTextures(1))
    GL.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1)
    # Neither size is a power of two: GLU scales the image.
    GLU.gluBuild2DMipmaps(GL.GL_TEXTURE_2D, GL.GL_RGB, 100, 60, GL.GL_RGB, GL.GL_UNSIGNED_BYTE, bytes(texels))
    GL.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MIN_FILTER, GL.GL_LINEAR_MIPMAP_LINEAR)
    GL.glEnable(GL.GL_TEXTURE_2D)


def quadrics():
    """One of each quadric, in each style of drawing."""
    look()
    light()
    for column, style in enumerate((GLU.GLU_FILL, GLU.GLU_LINE, GLU.GLU_SILHOUETTE, GLU.GLU_POINT)):
        quadric = GLU.gluNewQuadric()
        GLU.gluQuadricDrawStyle(quadric, style)
        GLU.gluQuadricNormals(quadric, GLU.GLU_FLAT if column == 1 else GLU.GLU_SMOOTH)
        GL.glPushMatrix()
        GL.glTranslatef(column * 1.1 - 1.6, 1, 0)
        GLU.gluSphere(quadric, 0.5, 16, 12)
        GL.glTranslatef(0, -1, 0)
        GLU.gluCylinder(quadric, 0.4, 0.2, 0.7, 12, 3)
        GL.glTranslatef(0, -1, 0)
        GLU.gluPartialDisk(quadric, 0.1, 0.5, 14, 3, 20, 250)
        GL.glPopMatrix()
        GLU.gluDeleteQuadric(quadric)


def textured_list():
    """A textured sphere from a display list, drawn three times."""
    look()
    light()
    checkered_texture()
    quadric = GLU.gluNewQuadric()
    GLU.gluQuadricTexture(quadric, GL.GL_TRUE)
    name = GL.glGenLists(1)
    GL.glNewList(name, GL.GL_COMPILE)
    GLU.gluSphere(quadric, 0.9, 24, 18)
    GL.glEndList()
    for x in (-1.6, 0, 1.6):
        GL.glPushMatrix()
        GL.glTranslatef(x, 0.3 * x, -x)
        GL.glRotatef(60 * x, 1, 1, 0)
        GL.glCallList(name)
        GL.glPopMatrix()


def nurbs():
    """A surface of GLU's NURBS, which goes through the evaluators."""
    look()
    light()
    GL.glEnable(GL.GL_AUTO_NORMAL)
    points = [[(s - 1.5, 1.5 if 0 < s < 3 and 0 < t < 3 else -0.6, t - 1.5) for t in range(4)] for s in range(4)]
    knots = (0, 0, 0, 0, 1, 1, 1, 1)
    surface = GLU.gluNewNurbsRenderer()
    GLU.gluNurbsProperty(surface, GLU.GLU_SAMPLING_TOLERANCE, 25)
    GLU.gluNurbsProperty(surface, GLU.GLU_DISPLAY_MODE, GLU.GLU_FILL)
    GLU.gluBeginSurface(surface)
    GLU.gluNurbsSurface(surface, knots, knots, points, GL.GL_MAP2_VERTEX_3)
    GLU.gluEndSurface(surface)


def tessellation():
    """A star with a hole, cut into triangles by GLU."""
    look()
    star = [(0, 1.6), (0.4, 0.5), (1.5, 0.5), (0.6, -0.2), (1, -1.3), (0, -0.6), (-1, -1.3), (-0.6, -0.2), (-1.5, 0.5), (-0.4, 0.5)]
    hole = [(0.2, 0.2), (0.2, -0.2), (-0.2, -0.2), (-0.2, 0.2)]
    tess = GLU.gluNewTess()
    GLU.gluTessCallback(tess, GLU.GLU_TESS_BEGIN, GL.glBegin)
    GLU.gluTessCallback(tess, GLU.GLU_TESS_END, GL.glEnd)

    def vertex(v):
        GL.glColor3f(0.5 + v[0] / 3, 0.5 + v[1] / 3, 0.7)
        GL.glVertex3f(*v)

    GLU.gluTessCallback(tess, GLU.GLU_TESS_VERTEX, vertex)
    GLU.gluTessBeginPolygon(tess, None)
    for contour in (star, hole):
        GLU.gluTessBeginContour(tess)
        for x, y in contour:
            GLU.gluTessVertex(tess, (x, y, 0), (x, y, 0))
        GLU.gluTessEndContour(tess)
    GLU.gluTessEndPolygon(tess)


def arrays():
    """Vertex arrays that PyOpenGL makes of Python's sequences, and quadrilaterals."""
    look()
    GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
    GL.glEnableClientState(GL.GL_COLOR_ARRAY)
    corners = [(x, y, z) for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)]
    faces = [0, 1, 3, 2, 4, 6, 7, 5, 0, 4, 5, 1, 2, 3, 7, 6, 0, 2, 6, 4, 1, 5, 7, 3]
    GL.glVertexPointerf(corners)
    GL.glColorPointerf([((x + 1) / 2, (y + 1) / 2, (z + 1) / 2) for x, y, z in corners])
    GL.glDrawElementsui(GL.GL_QUADS, faces)


SCENES = {f.__name__: f for f in (quadrics, textured_list, nurbs, tessellation, arrays)}
TYPES = {"ubyte": GL.GL_UNSIGNED_BYTE, "ushort": GL.GL_UNSIGNED_SHORT, "float": GL.GL_FLOAT}


def main():
    if sys.argv[1:] == ["--list"]:
        print("\n".join(SCENES))
        return
    scene, kind, path = sys.argv[1:]
    context = osmesa.OSMesaCreateContextExt(osmesa.OSMESA_RGBA, 24, 8, 0, None)
    buffer = ArrayDatatype.zeros((HEIGHT, WIDTH, 4), TYPES[kind])
    if not osmesa.OSMesaMakeCurrent(context, buffer, TYPES[kind], WIDTH, HEIGHT):
        sys.exit("no context")
    GL.glClearColor(0.1, 0.1, 0.2, 1)
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
    SCENES[scene]()
    GL.glFinish()
    with open(path, "wb") as out:
        out.write(struct.pack("<ii", WIDTH, HEIGHT))
        out.write(GL.glReadPixels(0, 0, WIDTH, HEIGHT, GL.GL_RGBA, GL.GL_FLOAT).tobytes())
        out.write(GL.glReadPixels(0, 0, WIDTH, HEIGHT, GL.GL_DEPTH_COMPONENT, GL.GL_FLOAT).tobytes())


main()
