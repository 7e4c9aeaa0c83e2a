// Images of stencil values, drawn and copied (3.6.4, 3.6.5, 4.3.1, 4.3.3). What they leave in the buffer is
// seen by colors.
#include "pixels/chapter.h"
#include "pixels/scenes.h"
#include "raster/scenes.h"

namespace softgl::suite {
namespace {

// A color for each value but 0.
void show_stencil(Script& s, const std::vector<int>& others) {
  s.Disable(GL_DEPTH_TEST), s.Disable(GL_SCISSOR_TEST), s.Disable(GL_ALPHA_TEST), s.Enable(GL_STENCIL_TEST);
  s.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP), s.StencilMask(255);
  const auto show = [&](int value, int color) {
    s.StencilFunc(GL_EQUAL, value, 255), tint(s, color), box(s, 4, 4, 94, 92);
  };
  for (int value = 1; value < 16; value++) show(value, value);
  for (int value : others) show(value, value);
}

// What is set up, then an image, then what it has left.
Test stencils(const char* name, const char* section, const char* sentence, std::function<void(Script&)> draw,
              std::initializer_list<int> others = {}) {
  const std::vector<int> values(others);
  return pixel_test((std::string("stencil.") + name).c_str(), section, sentence, [=](Script& s) {
    s.ClearStencil(0), s.Clear(GL_STENCIL_BUFFER_BIT);
    draw(s);
    show_stencil(s, values);
  });
}

void draw_stencils(Script& s, GLenum type = GL_UNSIGNED_BYTE) { draw_image(s, GL_STENCIL_INDEX, type); }

Test typed(const char* name, GLenum type) {
  return stencils(name, "3.6.4, table 3.5",
                  "The indexes of an image of stencil values have any type but the packed ones.",
                  [=](Script& s) { draw_stencils(s, type); });
}

// The same transfer for images and for copies, undone behind it.
void shifted(Script& s, int shift, int offset) {
  s.PixelTransferi(GL_INDEX_SHIFT, shift), s.PixelTransferi(GL_INDEX_OFFSET, offset);
}
void mapped(Script& s) {
  Memory map{GL_FLOAT, {}};
  for (int i = 0; i < 16; i++) map.elements.push_back((i * 5 + 3) % 16);
  s.PixelMapfv(GL_PIXEL_MAP_S_TO_S, 16, map), s.PixelTransferi(GL_MAP_STENCIL, 1);
}
void copy_stencils(Script& s) {
  place(s, 50.3, 46.2), s.PixelZoom(1, 1), s.CopyPixels(8, 8, 32, 32, GL_STENCIL);
}

} // namespace

std::vector<Test> pixel_stencil_tests() {
  return {
      typed("unsigned_byte", GL_UNSIGNED_BYTE),
      typed("byte", GL_BYTE),
      typed("unsigned_short", GL_UNSIGNED_SHORT),
      typed("short", GL_SHORT),
      typed("unsigned_int", GL_UNSIGNED_INT),
      typed("int", GL_INT),
      typed("float", GL_FLOAT),
      stencils("without_the_test", "4.3.1", "Stencil values are stored whatever the stencil test is.",
               [](Script& s) {
                 s.Enable(GL_STENCIL_TEST), s.StencilFunc(GL_NEVER, 0, 255),
                     s.StencilOp(GL_INVERT, GL_INVERT, GL_INVERT);
                 draw_stencils(s);
               }),
      stencils("without_depths", "4.3.1",
               "Stencil values are stored whatever the depth test is, and leave depths and colors.",
               [](Script& s) {
                 s.Enable(GL_DEPTH_TEST), s.DepthFunc(GL_NEVER), draw_stencils(s), s.DepthFunc(GL_LESS);
                 tint(s, 5), box(s, 60, 4, 94, 92, 0.5);
               }),
      stencils("without_alpha", "4.3.1", "Stencil values are stored whatever the alpha test is.",
               [](Script& s) { s.Enable(GL_ALPHA_TEST), s.AlphaFunc(GL_NEVER, 0), draw_stencils(s); }),
      stencils("without_masks", "4.3.1, 4.2.2",
               "The masks of colors and depths do not matter to stencil values.",
               [](Script& s) {
                 s.ColorMask(0, 0, 0, 0), s.DepthMask(0), draw_stencils(s), s.ColorMask(1, 1, 1, 1),
                     s.DepthMask(1);
               }),
      stencils("write_mask", "4.3.1, 4.2.2", "Only the bits of glStencilMask are written.",
               [](Script& s) {
                 s.ClearStencil(9), s.Clear(GL_STENCIL_BUFFER_BIT), s.StencilMask(6), draw_stencils(s);
               }),
      stencils("scissor", "4.3.1, 4.1.2", "Stencil values outside of the scissor box stay.",
               [](Script& s) { s.Enable(GL_SCISSOR_TEST), s.Scissor(20, 14, 31, 37), draw_stencils(s); }),
      stencils("zoom", "3.6.4", "Images of stencil values are zoomed as others are.",
               [](Script& s) {
                 place(s, 80, 12), s.PixelZoom(-4.4, 6), s.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
                 s.DrawPixels(12, 12, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE,
                              elements_of(GL_UNSIGNED_BYTE, 144, true));
               }),
      stencils("high_bits", "3.6.5", "An index loses the bits that the stencil buffer has not.",
               [](Script& s) { shifted(s, 0, 0x3300), draw_stencils(s, GL_UNSIGNED_INT), shifted(s, 0, 0); }),
      stencils("shift", "3.6.5", "Stencil values are shifted, and the offset is added.",
               [](Script& s) { shifted(s, 1, 3), draw_stencils(s), shifted(s, 0, 0); },
               {17, 19, 21, 23, 25, 27, 29, 31, 33}),
      stencils("shift_right", "3.6.5", "A negative shift is one to the right.",
               [](Script& s) { shifted(s, -2, 1), draw_stencils(s), shifted(s, 0, 0); }),
      stencils("map", "3.6.5", "With GL_MAP_STENCIL stencil values are looked up.",
               [](Script& s) { mapped(s), draw_stencils(s), s.PixelTransferi(GL_MAP_STENCIL, 0); }),
      stencils("map_off", "3.6.5", "GL_MAP_COLOR does not matter to stencil values.",
               [](Script& s) {
                 mapped(s), s.PixelTransferi(GL_MAP_STENCIL, 0), s.PixelTransferi(GL_MAP_COLOR, 1),
                     draw_stencils(s);
                 s.PixelTransferi(GL_MAP_COLOR, 0);
               }),
      stencils("copy", "4.3.3", "glCopyPixels copies stencil values.",
               [](Script& s) { draw_stencils(s), copy_stencils(s); }),
      stencils("copy_zoomed", "4.3.3", "A copy of stencil values is zoomed.",
               [](Script& s) {
                 draw_stencils(s), place(s, 40, 20), s.PixelZoom(1.6, 2.4),
                     s.CopyPixels(8, 8, 30, 24, GL_STENCIL);
               }),
      stencils("copy_transferred", "4.3.3, 3.6.5", "A copy of stencil values is shifted and looked up.",
               [](Script& s) {
                 draw_stencils(s), mapped(s), shifted(s, 0, 1), copy_stencils(s), shifted(s, 0, 0),
                     s.PixelTransferi(GL_MAP_STENCIL, 0);
               }),
      stencils("copy_masked", "4.3.3, 4.2.2", "A copy of stencil values obeys mask and scissor box.",
               [](Script& s) {
                 draw_stencils(s), s.StencilMask(5), s.Enable(GL_SCISSOR_TEST), s.Scissor(55, 50, 20, 21),
                     copy_stencils(s);
               }),
  };
}

} // namespace softgl::suite
