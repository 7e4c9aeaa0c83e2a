/* A sphere of few triangles that is lit at every pixel: GL_WIN_phong_shading. Writes phong_sphere.ppm. */
#include <GL/osmesa.h>
#include <math.h>
#include <string.h>

#include "ppm.h"

#define SIZE 256
#define SLICES 16
#define STACKS 8

static unsigned char pixels[SIZE * SIZE * 4];

/* On the unit sphere position and normal are the same three numbers. */
static void vertex(int slice, int stack) {
  const double pi = 3.14159265358979323846;
  const double around = 2 * pi * slice / SLICES, up = pi * stack / STACKS - pi / 2;
  const float x = (float)(cos(up) * cos(around)), y = (float)sin(up), z = (float)(cos(up) * sin(around));
  glNormal3f(x, y, z);
  glVertex3f(x, y, z);
}

static void sphere(void) {
  for (int stack = 0; stack < STACKS; ++stack) {
    glBegin(GL_TRIANGLE_STRIP);
    for (int slice = 0; slice <= SLICES; ++slice) {
      vertex(slice, stack);
      vertex(slice, stack + 1);
    }
    glEnd();
  }
}

int main(void) {
  OSMesaContext context = OSMesaCreateContext(OSMESA_RGBA, NULL);
  if (!context || !OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, SIZE, SIZE)) {
    fprintf(stderr, "phong_sphere: there is no context\n");
    return 1;
  }
  if (!strstr((const char*)glGetString(GL_EXTENSIONS), "GL_WIN_phong_shading ")) {
    fprintf(stderr, "phong_sphere: this library lights at vertices only\n");
    return 1;
  }
  OSMesaPixelStore(OSMESA_Y_UP, 0);

  glMatrixMode(GL_PROJECTION);
  glFrustum(-1, 1, -1, 1, 3, 10);
  glMatrixMode(GL_MODELVIEW);
  glTranslatef(0, 0, -4);

  static const float light[4] = {2, 3, 4, 0}; /* a direction: the last number is 0 */
  static const float material[4] = {0.7f, 0.2f, 0.1f, 1}, white[4] = {1, 1, 1, 1};
  glLightfv(GL_LIGHT0, GL_POSITION, light);
  glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, material);
  glMaterialfv(GL_FRONT, GL_SPECULAR, white);
  glMaterialf(GL_FRONT, GL_SHININESS, 60);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glEnable(GL_DEPTH_TEST);
  glShadeModel(GL_PHONG_WIN); /* GL_SMOOTH would light the vertices, and lose the highlight between them */

  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  sphere();
  glFinish();

  const int written = write_ppm("phong_sphere.ppm", pixels, SIZE, SIZE);
  const int right = glGetError() == GL_NO_ERROR;
  OSMesaDestroyContext(context);
  return written && right ? 0 : 1;
}
