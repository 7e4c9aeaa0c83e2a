#include "scene/background.h"

#include <algorithm>

#include "image/srgb.h"
#include "scene/gl_functions.h"

namespace softgl::cli {
namespace {

void set_color(const uint8_t* rgb, bool linear) {
  float color[3];
  for (int c = 0; c < 3; ++c) color[c] = linear ? from_srgb(float(rgb[c]) / 255) : float(rgb[c]) / 255;
  glColor3fv(color);
}

// The middle of the picture, as much as has the frame's shape.
void draw_picture(const Picture& picture, int width, int height, bool linear) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, linear ? GL_SRGB8 : GL_RGB8, picture.width, picture.height, 0, GL_RGB,
               GL_UNSIGNED_BYTE, picture.pixels.data());
  glEnable(GL_TEXTURE_2D);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  glMatrixMode(GL_TEXTURE);
  glLoadIdentity();
  const double frame = double(width) / height, shape = double(picture.width) / picture.height;
  const double x = std::min(1.0, frame / shape) / 2, y = std::min(1.0, shape / frame) / 2;
  const double corners[4][4] = {
      {.5 - x, .5 + y, -1, -1}, {.5 + x, .5 + y, 1, -1}, {.5 + x, .5 - y, 1, 1}, {.5 - x, .5 - y, -1, 1}};
  glBegin(GL_TRIANGLE_FAN);
  for (const auto& corner : corners) {
    glTexCoord2d(corner[0], corner[1]);
    glVertex2d(corner[2], corner[3]);
  }
  glEnd();
  glDeleteTextures(1, &texture);
}

} // namespace

void draw_background(const Background& background, int width, int height, bool linear) {
  if (background.transparent || !(background.below || background.picture)) return;
  glPushAttrib(GL_ALL_ATTRIB_BITS);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_LIGHTING);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
  glShadeModel(GL_SMOOTH);
  for (const GLenum matrix : {GL_PROJECTION, GL_MODELVIEW}) {
    glMatrixMode(matrix);
    glLoadIdentity();
  }
  if (background.picture) {
    draw_picture(*background.picture, width, height, linear);
  } else {
    glBegin(GL_TRIANGLE_FAN);
    set_color(background.below->data(), linear);
    glVertex2f(-1, -1);
    glVertex2f(1, -1);
    set_color(background.color, linear);
    glVertex2f(1, 1);
    glVertex2f(-1, 1);
    glEnd();
  }
  glPopAttrib();
}

} // namespace softgl::cli
