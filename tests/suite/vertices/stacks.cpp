// Stacks: what they hold, and the errors where they end (2.11.2, 6.1.14).
#include "vertices/chapter.h"
#include "vertices/scenes.h"

namespace softgl::suite {
namespace {

// `least` entries or more; a stack of matrices is the one of the mode.
Test stack_row(const char* name, const char* section, const char* sentence, GLenum depth, GLenum limit,
               int least, GLenum mode = GL_MODELVIEW) {
  return row(name, section, sentence, [=](Script& s) {
    s.MatrixMode(mode), s.PaintInteger(limit, least, 100000, 4, 84), s.PaintStack(depth, limit, 14, 84);
    s.MatrixMode(GL_MODELVIEW), arrow(s);
  });
}

} // namespace

std::vector<Test> vertices_stack_tests() {
  static const char kMatrices[] = "A glPushMatrix too many is GL_STACK_OVERFLOW, a glPopMatrix too many "
                                  "GL_STACK_UNDERFLOW; neither does more.";
  static const char kAttributes[] =
      "A push of attributes too many is GL_STACK_OVERFLOW, a pop too many GL_STACK_UNDERFLOW.";
  return {
      stack_row("stacks.modelview", "2.11.2", kMatrices, GL_MODELVIEW_STACK_DEPTH,
                GL_MAX_MODELVIEW_STACK_DEPTH, 32),
      stack_row("stacks.projection", "2.11.2", kMatrices, GL_PROJECTION_STACK_DEPTH,
                GL_MAX_PROJECTION_STACK_DEPTH, 2, GL_PROJECTION),
      stack_row("stacks.texture", "2.11.2", kMatrices, GL_TEXTURE_STACK_DEPTH, GL_MAX_TEXTURE_STACK_DEPTH, 2,
                GL_TEXTURE),
      stack_row("stacks.attributes", "6.1.14", kAttributes, GL_ATTRIB_STACK_DEPTH, GL_MAX_ATTRIB_STACK_DEPTH,
                16),
      stack_row("stacks.client_attributes", "6.1.14", kAttributes, GL_CLIENT_ATTRIB_STACK_DEPTH,
                GL_MAX_CLIENT_ATTRIB_STACK_DEPTH, 16),
      row("stacks.pixel_store", "6.1.14, table 6.21",
          "GL_CLIENT_PIXEL_STORE_BIT saves the pixel storage modes.",
          [](Script& s) {
            s.PixelStorei(GL_UNPACK_ALIGNMENT, 1), s.PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT),
                s.PixelStorei(GL_UNPACK_LSB_FIRST, 1), s.PixelStorei(GL_UNPACK_ALIGNMENT, 8),
                s.PopClientAttrib();
            const Memory bits{GL_UNSIGNED_BYTE,
                              {255, 0, 254, 1, 240, 3, 224, 7, 192, 15, 128, 31, 255, 255, 1, 255}};
            tint(s, 3), s.RasterPos3f(-0.51, -0.4, 0), s.Bitmap(16, 8, 0, 0, 20, 20, bits);
            s.PushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT), s.PixelStorei(GL_UNPACK_LSB_FIRST, 1),
                s.PopClientAttrib();
            s.Bitmap(16, 8, 0, 0, 0, 0, bits);
          }),
      row("stacks.arrays", "6.1.14, table 6.6",
          "GL_CLIENT_VERTEX_ARRAY_BIT saves the arrays, and which are enabled.",
          [](Script& s) {
            s.EnableClientState(GL_VERTEX_ARRAY), s.EnableClientState(GL_COLOR_ARRAY);
            s.VertexPointer(2, GL_FLOAT, 0, Memory{GL_FLOAT, {-0.8, -0.7, 0.8, -0.6, 0.1, 0.9}});
            s.ColorPointer(3, GL_FLOAT, 0, Memory{GL_FLOAT, {1, 0.2, 0.1, 0.2, 1, 0.3, 0.3, 0.4, 1}});
            s.PushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
            s.VertexPointer(2, GL_SHORT, 0, Memory{GL_SHORT, {0, 0, 1, 0, 0, 1}}),
                s.DisableClientState(GL_COLOR_ARRAY), s.EnableClientState(GL_NORMAL_ARRAY),
                s.PopClientAttrib();
            s.IsEnabled(GL_NORMAL_ARRAY, 0), s.GetFloatv(GL_VERTEX_ARRAY_TYPE, V{double(GL_FLOAT)}),
                s.DrawArrays(GL_TRIANGLES, 0, 3);
          }),
      row("stacks.client_lists", "5.4, 6.1.14",
          "A list does not hold glPushClientAttrib: it takes place at once.",
          [](Script& s) {
            s.NewList(1, GL_COMPILE), s.PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT), arrow(s), s.EndList();
            s.GetFloatv(GL_CLIENT_ATTRIB_STACK_DEPTH, V{1}), s.CallList(1),
                s.GetFloatv(GL_CLIENT_ATTRIB_STACK_DEPTH, V{1}), s.PopClientAttrib();
          }),
  };
}

} // namespace softgl::suite
