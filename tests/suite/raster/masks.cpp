// Which colors are written: color masks, draw buffers and clears (4.2.1 to 4.2.3).
#include "raster/chapter.h"
#include "raster/scenes.h"

namespace softgl::suite {
namespace {

Test masked(const char* name, int mask) {
  return raster_test(std::string("color_mask.") + name, "4.2.2",
                     "Only the components of glColorMask are written, also by clears.", [=](Script& s) {
                       stripes(s), s.ColorMask(mask & 1, mask >> 1 & 1, mask >> 2 & 1, mask >> 3 & 1),
                           crossing_stripes(s);
                       s.Scissor(0, 0, 30, 96), s.Enable(GL_SCISSOR_TEST), s.ClearColor(0.4, 0.6, 0.8, 0.2),
                           s.Clear(GL_COLOR_BUFFER_BIT);
                     });
}

} // namespace

std::vector<Test> raster_mask_tests() {
  return {
      masked("red", 1),
      masked("green", 2),
      masked("blue", 4),
      masked("alpha", 8),
      masked("green_and_alpha", 10),
      masked("nothing", 0),
      raster_test("color_mask.blended", "4.1.8, 4.2.2", "Components that are not written are blended with.",
                  [](Script& s) {
                    stripes(s), s.ColorMask(1, 0, 1, 0), s.BlendFunc(GL_DST_ALPHA, GL_ONE_MINUS_SRC_ALPHA),
                        s.Enable(GL_BLEND), crossing_stripes(s);
                  }),
      raster_test("color_mask.logic", "4.1.10, 4.2.2", "The mask is about logic operations, too.",
                  [](Script& s) {
                    stripes(s), s.ColorMask(0, 1, 1, 0), s.LogicOp(GL_INVERT), s.Enable(GL_COLOR_LOGIC_OP),
                        crossing_stripes(s);
                  }),
      raster_test("color_mask.saved", "6.1.14, table 6.21", "GL_COLOR_BUFFER_BIT brings back the mask.",
                  [](Script& s) {
                    stripes(s), s.ColorMask(1, 0, 0, 1), s.PushAttrib(GL_COLOR_BUFFER_BIT),
                        s.ColorMask(1, 1, 1, 1), s.PopAttrib(), crossing_stripes(s);
                  }),
      raster_test("draw_buffer.none", "4.2.1", "With GL_NONE no colors are written; depths are.",
                  [](Script& s) {
                    s.Enable(GL_DEPTH_TEST), s.PushAttrib(GL_COLOR_BUFFER_BIT), s.DrawBuffer(GL_NONE),
                        tint(s, 0), box(s, 20, 20, 60, 60, 1), s.Clear(GL_COLOR_BUFFER_BIT), s.PopAttrib();
                    mesh(s, -0.9, -0.9, 0.9, 0.9, 4, -1, -1);
                  }),
      raster_test("draw_buffer.all", "4.2.1", "GL_FRONT_AND_BACK is every buffer that there is.",
                  [](Script& s) {
                    s.DrawBuffer(GL_NONE), stripes(s), s.DrawBuffer(GL_FRONT_AND_BACK), crossing_stripes(s);
                  }),
      raster_test("clear.color", "4.2.3", "A clear sets all pixels to the color that was set.",
                  [](Script& s) {
                    stripes(s), s.ClearColor(0.3, 0.6, 0.9, 0.5), s.Clear(GL_COLOR_BUFFER_BIT), arrow(s);
                  }),
      raster_test("clear.color_clamped", "4.2.3", "The color of a clear is clamped to [0, 1].",
                  [](Script& s) { s.ClearColor(2, -1, 0.5, 1), s.Clear(GL_COLOR_BUFFER_BIT), arrow(s); }),
      raster_test(
          "clear.no_operations", "4.2.3",
          "Blending, logic operations, fog and stipples do not matter to clears.",
          [](Script& s) {
            s.Enable(GL_BLEND), s.BlendFunc(GL_ZERO, GL_ONE), s.Enable(GL_COLOR_LOGIC_OP),
                s.LogicOp(GL_CLEAR), s.Enable(GL_FOG),
                s.PolygonStipple(Memory{GL_UNSIGNED_BYTE, std::vector<double>(128, 0)}),
                s.Enable(GL_POLYGON_STIPPLE), s.Enable(GL_DEPTH_TEST), s.DepthFunc(GL_NEVER);
            s.ClearColor(0.9, 0.6, 0.2, 1), s.Clear(GL_COLOR_BUFFER_BIT);
            for (GLenum name : {GL_BLEND, GL_COLOR_LOGIC_OP, GL_FOG, GL_POLYGON_STIPPLE, GL_DEPTH_TEST})
              s.Disable(name);
            arrow(s);
          }),
      raster_test("clear.nothing", "4.2.3", "A clear of no buffer does nothing.",
                  [](Script& s) { stripes(s), s.ClearColor(1, 1, 1, 1), s.Clear(0), arrow(s); }),
      raster_test("clear.saved", "6.1.14, table 6.21", "GL_COLOR_BUFFER_BIT brings back the color of clears.",
                  [](Script& s) {
                    s.ClearColor(0.3, 0.6, 0.9, 0.5), s.PushAttrib(GL_COLOR_BUFFER_BIT),
                        s.ClearColor(0, 0, 0, 0), s.PopAttrib(), s.Clear(GL_COLOR_BUFFER_BIT), arrow(s);
                  }),
  };
}

} // namespace softgl::suite
