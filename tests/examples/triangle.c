/* A triangle, drawn off the screen through OSMesa's functions and written to triangle.ppm. */
#include <GL/osmesa.h>

#include "ppm.h"

#define WIDTH 320
#define HEIGHT 240

static unsigned char pixels[WIDTH * HEIGHT * 4];

int main(void) {
  /* A context has the state, the memory for the picture is the program's own. */
  OSMesaContext context = OSMesaCreateContext(OSMESA_RGBA, NULL);
  if (!context || !OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, WIDTH, HEIGHT)) {
    fprintf(stderr, "triangle: there is no context\n");
    return 1;
  }
  OSMesaPixelStore(OSMESA_Y_UP, 0); /* the top row comes first in memory, as in the file */

  glClearColor(0.1f, 0.1f, 0.2f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  glBegin(GL_TRIANGLES);
  glColor3f(1, 0, 0);
  glVertex3f(-0.8f, -0.8f, 0);
  glColor3f(0, 1, 0);
  glVertex3f(0.8f, -0.8f, 0);
  glColor3f(0, 0, 1);
  glVertex3f(0.0f, 0.8f, 0);
  glEnd();
  glFinish(); /* now the picture is in memory */

  const int written = write_ppm("triangle.ppm", pixels, WIDTH, HEIGHT);
  printf("%s\n", (const char*)glGetString(GL_VERSION));
  OSMesaDestroyContext(context);
  return written ? 0 : 1;
}
