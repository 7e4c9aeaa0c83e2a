/* softgl's own functions: the picture is the same whatever the number of threads. */
#include <GL/osmesa.h>
#include <softgl/softgl.h>
#include <softgl/version.h>
#include <stdio.h>

#define SIZE 512

static unsigned char pixels[SIZE * SIZE * 4];

/* Draws a hundred fans of triangles and gives the hash of the picture. */
static uint64_t draw(int threads) {
  softgl_set_threads(threads);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (int i = 0; i < 100; ++i) {
    glLoadIdentity();
    glRotatef((float)(7 * i), 0, 0, 1);
    glTranslatef(0.006f * (float)i, 0, 0);
    glBegin(GL_TRIANGLE_FAN);
    for (int corner = 0; corner < 5; ++corner) {
      glColor3ub((GLubyte)(40 * corner), (GLubyte)(2 * i), 120);
      glVertex3f(corner % 2 ? 0.2f : 0.0f, 0.1f * (float)corner, 0.01f * (float)i - 0.5f);
    }
    glEnd();
  }
  return softgl_frame_hash(); /* finishes the picture first */
}

int main(void) {
  OSMesaContext context = OSMesaCreateContext(OSMESA_RGBA, NULL);
  if (!context || !OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, SIZE, SIZE)) {
    fprintf(stderr, "threads: there is no context\n");
    return 1;
  }
  glEnable(GL_DEPTH_TEST);
  const uint64_t alone = draw(1), together = draw(4);
  printf("softgl %s, compiled against %d.%d, instruction set %s: %016llx\n", softgl_version(),
         SOFTGL_VERSION_MAJOR, SOFTGL_VERSION_MINOR, softgl_isa(), (unsigned long long)alone);
  OSMesaDestroyContext(context);
  return alone == together ? 0 : 1;
}
