// Reading and copying pixels (4.3.2, 4.3.3), and errors of all commands of pixels.
#include "pixels/chapter.h"
#include "pixels/scenes.h"

namespace softgl::suite {
namespace {

// Six by four pixels of colors that vary are read and painted.
Test read(const char* name, const char* sentence, GLenum format, GLenum type, Need need = {}) {
  return pixel_test(
      name, "4.3.2", sentence,
      [=](Script& s) {
        const int elements = 24 * (pixel_type(type).fields > 1 ? 1 : components_of(format));
        varied_sheet(s), s.PixelStorei(GL_PACK_ALIGNMENT, 1);
        s.PaintPixels(40, 30, 6, 4, format, type, elements, 2, 2, 11, 8, false);
      },
      need,
      pixel_type(type).fields > 1 ? "which of two neighboring values of few bits a component becomes" : "");
}
// Depths from near to far.
Test read_depth(const char* name, const char* sentence, GLenum type) {
  return pixel_test(name, "4.3.2", sentence, [=](Script& s) {
    s.Enable(GL_DEPTH_TEST), varied_sheet(s, -12, 3.5), s.PixelStorei(GL_PACK_ALIGNMENT, 1);
    s.PaintPixels(12, 40, 70, 1, GL_DEPTH_COMPONENT, type, 70, 2, 2, 10, 8, false);
  });
}
// Three by three pixels of GL_RGB with a way of storing them.
Test packed(const char* name, const char* sentence, GLenum type, int count,
            std::function<void(Script&)> state, bool swapped = false, Need need = {}) {
  return pixel_test(
      name, "4.3.2, table 4.4", sentence,
      [=](Script& s) {
        varied_sheet(s), state(s), s.PaintPixels(50, 30, 3, 3, GL_RGB, type, count, 2, 2, 11, 8, swapped);
        s.PixelStorei(GL_PACK_ROW_LENGTH, 0), s.PixelStorei(GL_PACK_SKIP_PIXELS, 0);
        s.PixelStorei(GL_PACK_SKIP_ROWS, 0), s.PixelStorei(GL_PACK_SWAP_BYTES, 0);
      },
      need);
}
// A part of the window is copied to the upper right.
Test copied(const char* name, const char* sentence, std::function<void(Script&)> state) {
  return pixel_test(name, "4.3.3", sentence, [=](Script& s) {
    s.Color3f(0.5f, 0.5f, 0.5f), varied_sheet(s), place(s, 50.3, 48.2), state(s),
        s.CopyPixels(40, 10, 20, 16, GL_COLOR);
    s.PixelTransferf(GL_RED_SCALE, 1.0), s.PixelTransferf(GL_BLUE_BIAS, 0.0),
        s.PixelTransferi(GL_MAP_COLOR, 0);
  });
}

// The call raises the error; an image is drawn behind it as if nothing had been.
Test error(const char* name, const char* section, const char* sentence, GLenum raised,
           std::function<void(Script&)> call, Need need = {}) {
  return pixel_test(
      name, section, sentence,
      [=](Script& s) {
        s.Raises(raised), call(s), s.PaintError(0, 0), s.PaintError(0, 10), place(s, 12.3, 20.2),
            s.PixelZoom(7, 8);
        s.DrawPixels(6, 6, GL_RGB, GL_UNSIGNED_BYTE, elements_of(GL_UNSIGNED_BYTE, 120));
      },
      need);
}
const GLenum kEnum = GL_INVALID_ENUM, kValue = GL_INVALID_VALUE, kOperation = GL_INVALID_OPERATION;

} // namespace

std::vector<Test> pixel_read_tests() {
  const GLenum bytes = GL_UNSIGNED_BYTE;
  const char* const kRange = "Components become integers over the whole range.";
  const char* const kFirst = "The first component has the most significant bits.";
  const char* const kLast = "In a reversed type the first component has the least significant bits.";
  const auto set = [](GLenum name, int value) {
    return [=](Script& s) { s.PixelStorei(GL_PACK_ALIGNMENT, 1), s.PixelStorei(name, value); };
  };
  return {
      read("read.red", "GL_RED reads red.", GL_RED, bytes),
      read("read.green", "GL_GREEN reads green.", GL_GREEN, bytes),
      read("read.blue", "GL_BLUE reads blue.", GL_BLUE, bytes),
      read("read.alpha", "GL_ALPHA reads alpha; 1 if the window has none.", GL_ALPHA, bytes),
      read("read.luminance", "A luminance is the sum of red, green and blue, at most 1.", GL_LUMINANCE,
           bytes),
      read("read.luminance_float", "The sum is at most 1 as a float, too.", GL_LUMINANCE, GL_FLOAT),
      read("read.luminance_alpha", "GL_LUMINANCE_ALPHA reads the sum and alpha.", GL_LUMINANCE_ALPHA, bytes),
      read("read.rgb", "GL_RGB reads three components.", GL_RGB, bytes),
      read("read.rgba", "GL_RGBA reads four components.", GL_RGBA, bytes),
      read("read.bgr", "GL_BGR begins with blue.", GL_BGR, bytes, kVersion12),
      read("read.bgra", "GL_BGRA begins with blue.", GL_BGRA, bytes, kVersion12),
      read("read.byte", "Components become signed bytes, from 0 to 127.", GL_RGB, GL_BYTE),
      read("read.unsigned_short", kRange, GL_RGB, GL_UNSIGNED_SHORT),
      read("read.short", "Components become signed shorts.", GL_RGB, GL_SHORT),
      read("read.unsigned_int", kRange, GL_RGB, GL_UNSIGNED_INT),
      read("read.int", "Components become signed integers.", GL_RGB, GL_INT),
      read("read.float", "Components become floats from 0 to 1.", GL_RGBA, GL_FLOAT),
      read("read.3_3_2", kFirst, GL_RGB, GL_UNSIGNED_BYTE_3_3_2, kVersion12),
      read("read.2_3_3_rev", kLast, GL_RGB, GL_UNSIGNED_BYTE_2_3_3_REV, kVersion12),
      read("read.5_6_5", kFirst, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, kVersion12),
      read("read.5_6_5_rev", kLast, GL_RGB, GL_UNSIGNED_SHORT_5_6_5_REV, kVersion12),
      read("read.4_4_4_4", kFirst, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, kVersion12),
      read("read.4_4_4_4_rev", kLast, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4_REV, kVersion12),
      read("read.5_5_5_1", kFirst, GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, kVersion12),
      read("read.1_5_5_5_rev", kLast, GL_BGRA, GL_UNSIGNED_SHORT_1_5_5_5_REV, kVersion12),
      read("read.8_8_8_8", kFirst, GL_RGBA, GL_UNSIGNED_INT_8_8_8_8, kVersion12),
      read("read.8_8_8_8_rev", kLast, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, kVersion12),
      read("read.10_10_10_2", kFirst, GL_RGBA, GL_UNSIGNED_INT_10_10_10_2, kVersion12),
      read("read.2_10_10_10_rev", kLast, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV, kVersion12),
      read_depth("read.depth_float", "Depths become floats.", GL_FLOAT),
      read_depth("read.depth_bytes", "Depths become bytes.", GL_UNSIGNED_BYTE),
      read_depth("read.depth_shorts", "Depths become shorts over the whole range.", GL_UNSIGNED_SHORT),
      read_depth("read.depth_ints", "Depths become integers over the whole range.", GL_UNSIGNED_INT),
      packed("pack.alignment", "Rows begin at multiples of the alignment; what lies between is not touched.",
             bytes, 36, [](Script&) {}),
      packed("pack.alignment_8", "Rows begin at multiples of 8 bytes.", bytes, 48,
             [](Script& s) { s.PixelStorei(GL_PACK_ALIGNMENT, 8); }),
      packed("pack.row_length", "Rows have GL_PACK_ROW_LENGTH pixels; what lies between is not touched.",
             bytes, 42, set(GL_PACK_ROW_LENGTH, 5)),
      packed("pack.skip_rows", "GL_PACK_SKIP_ROWS rows are skipped.", bytes, 45, set(GL_PACK_SKIP_ROWS, 2)),
      packed("pack.skip_pixels", "GL_PACK_SKIP_PIXELS pixels are skipped.", bytes, 39,
             [](Script& s) {
               s.PixelStorei(GL_PACK_ALIGNMENT, 1), s.PixelStorei(GL_PACK_SKIP_PIXELS, 1),
                   s.PixelStorei(GL_PACK_ROW_LENGTH, 4);
             }),
      packed("pack.swap_floats", "GL_PACK_SWAP_BYTES turns the bytes of a float round.", GL_FLOAT, 27,
             set(GL_PACK_SWAP_BYTES, 1), true),
      packed("pack.swap_packed", "GL_PACK_SWAP_BYTES turns the bytes of a packed pixel round.",
             GL_UNSIGNED_SHORT_5_6_5, 9, set(GL_PACK_SWAP_BYTES, 1), true, kVersion12),
      pixel_test("read.transfer", "4.3.2, 3.6.5", "What is read goes through scale, bias and maps.",
                 [](Script& s) {
                   varied_sheet(s), s.PixelTransferf(GL_RED_SCALE, 0.5), s.PixelTransferf(GL_BLUE_BIAS, 0.3);
                   s.PixelStorei(GL_PACK_ALIGNMENT, 1),
                       s.PaintPixels(40, 30, 6, 4, GL_RGB, GL_FLOAT, 72, 2, 2, 11, 8, false);
                   s.PixelTransferf(GL_RED_SCALE, 1.0), s.PixelTransferf(GL_BLUE_BIAS, 0.0);
                 }),
      pixel_test("read.rows_from_below", "4.3.2", "The first row is the lowest.",
                 [](Script& s) {
                   varied_sheet(s), s.PixelStorei(GL_PACK_ALIGNMENT, 1);
                   s.PaintPixels(50, 10, 1, 70, GL_RGB, GL_UNSIGNED_BYTE, 210, 2, 2, 15, 6, false);
                 }),
      pixel_test("read.depth_transfer", "4.3.2, 3.6.5", "Depths that are read have a scale and a bias.",
                 [](Script& s) {
                   s.Enable(GL_DEPTH_TEST), varied_sheet(s, -12, 3.5), s.PixelTransferf(GL_DEPTH_SCALE, 0.5);
                   s.PixelTransferf(GL_DEPTH_BIAS, 0.25),
                       s.PaintPixels(12, 40, 70, 1, GL_DEPTH_COMPONENT, GL_FLOAT, 70, 2, 2, 10, 8, false);
                   s.PixelTransferf(GL_DEPTH_SCALE, 1.0), s.PixelTransferf(GL_DEPTH_BIAS, 0.0);
                 }),

      copied("copy.plain", "glCopyPixels draws a part of the window at the raster position.", [](Script&) {}),
      copied("copy.zoomed", "The zoom enlarges copies.", [](Script& s) { s.PixelZoom(2, 3); }),
      copied("copy.negative_zoom", "A negative zoom turns copies round.",
             [](Script& s) { s.PixelZoom(-1, -2); }),
      copied("copy.overlapping", "The pixels are read before they are drawn.",
             [](Script& s) { place(s, 45.3, 14.2); }),
      copied("copy.transfer", "Copies go through scale and bias.",
             [](Script& s) { s.PixelTransferf(GL_RED_SCALE, 0.5), s.PixelTransferf(GL_BLUE_BIAS, 0.3); }),
      copied("copy.blended", "Copies are blended.",
             [](Script& s) { s.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), s.Enable(GL_BLEND); }),
      copied("copy.alpha_test", "Copies go through the alpha test.",
             [](Script& s) {
               s.PixelTransferf(GL_RED_SCALE, 0.5), s.AlphaFunc(GL_GREATER, 0.3), s.Enable(GL_ALPHA_TEST);
             }),
      pixel_test("copy.depth", "4.3.3", "Copied depths are compared with what is drawn later.",
                 [](Script& s) {
                   s.Enable(GL_DEPTH_TEST), varied_sheet(s, -12, 3), s.Color3f(0.9f, 0.5f, 0.1f),
                       place(s, 52.3, 20.2);
                   s.DepthFunc(GL_ALWAYS), s.CopyPixels(12, 20, 30, 60, GL_DEPTH), s.DepthFunc(GL_LESS),
                       varied_sheet(s, -5.3, -5.1);
                 }),
      pixel_test("copy.invalid_position", "2.13, 4.3.3", "At an invalid raster position nothing is copied.",
                 [](Script& s) {
                   varied_sheet(s), s.RasterPos3f(-3.0f, 0.0f, 0.0f), s.PixelZoom(3, 3),
                       s.CopyPixels(20, 20, 40, 40, GL_COLOR);
                   s.PaintInteger(GL_CURRENT_RASTER_POSITION_VALID, 0, 0, 2, 2);
                 }),
  };
}

std::vector<Test> pixel_error_tests() {
  const Memory image = elements_of(GL_UNSIGNED_BYTE, 120);
  return {
      error("error.width", "3.6.4", "A negative width is GL_INVALID_VALUE.", kValue,
            [=](Script& s) { s.DrawPixels(-1, 4, GL_RGB, GL_UNSIGNED_BYTE, image); }),
      error("error.format", "3.6.4", "An unknown format is GL_INVALID_ENUM.", kEnum,
            [=](Script& s) { s.DrawPixels(4, 4, GL_LINEAR, GL_UNSIGNED_BYTE, image); }),
      error("error.type", "3.6.4", "An unknown type is GL_INVALID_ENUM.", kEnum,
            [=](Script& s) { s.DrawPixels(4, 4, GL_RGB, GL_LINEAR, image); }),
      error("error.bitmap_of_colors", "3.6.4", "GL_BITMAP for anything but indexes is GL_INVALID_ENUM.",
            kEnum, [=](Script& s) { s.DrawPixels(4, 4, GL_RGB, GL_BITMAP, image); }),
      error(
          "error.packed", "3.6.4", "A packed type of another number of components is GL_INVALID_OPERATION.",
          kOperation, [=](Script& s) { s.DrawPixels(4, 4, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5, image); },
          kVersion12),
      error("error.alignment", "3.6.1", "An alignment of 3 is GL_INVALID_VALUE.", kValue,
            [](Script& s) { s.PixelStorei(GL_UNPACK_ALIGNMENT, 3); }),
      error("error.row_length", "3.6.1", "A negative row length is GL_INVALID_VALUE.", kValue,
            [](Script& s) { s.PixelStorei(GL_UNPACK_ROW_LENGTH, -1); }),
      error("error.store", "3.6.1", "An unknown parameter of storage is GL_INVALID_ENUM.", kEnum,
            [](Script& s) { s.PixelStorei(GL_LINEAR, 1); }),
      error("error.transfer", "3.6.3", "An unknown parameter of transfer is GL_INVALID_ENUM.", kEnum,
            [](Script& s) { s.PixelTransferf(GL_LINEAR, 0.5); }),
      error("error.map", "3.6.3", "An unknown map is GL_INVALID_ENUM.", kEnum,
            [](Script& s) {
              s.PixelMapfv(GL_LINEAR, 2, V{0, 1});
            }),
      error("error.map_size", "3.6.3", "A map without entries is GL_INVALID_VALUE.", kValue,
            [](Script& s) {
              s.PixelMapfv(GL_PIXEL_MAP_R_TO_R, 0, V{0, 1});
            }),
      error("error.index_map_size", "3.6.3",
            "A map of indexes whose size is no power of two is GL_INVALID_VALUE.", kValue,
            [](Script& s) {
              s.PixelMapfv(GL_PIXEL_MAP_I_TO_R, 3, V{0, 1, 0.5});
            }),
      error("error.copy_type", "4.3.3", "An unknown kind of copy is GL_INVALID_ENUM.", kEnum,
            [](Script& s) { s.CopyPixels(0, 0, 4, 4, GL_RGB); }),
      error("error.copy_size", "4.3.3", "A negative size of a copy is GL_INVALID_VALUE.", kValue,
            [](Script& s) { s.CopyPixels(0, 0, 4, -4, GL_COLOR); }),
      error("error.bitmap", "3.7", "A negative size of a bitmap is GL_INVALID_VALUE.", kValue,
            [=](Script& s) { s.Bitmap(-8, 8, 0, 0, 5, 5, image); }),
      error("error.read_size", "4.3.2",
            "A negative size of what is read is GL_INVALID_VALUE, and memory stays.", kValue,
            [](Script& s) { s.PaintPixels(0, 0, -1, 4, GL_RGB, GL_UNSIGNED_BYTE, 12, 12, 2, 12, 6, false); }),
      error(
          "error.read_packed", "4.3.2",
          "A packed type of another number of components is GL_INVALID_OPERATION.", kOperation,
          [](Script& s) {
            s.PaintPixels(0, 0, 1, 4, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5, 4, 12, 2, 12, 6, false);
          },
          kVersion12),
      pixel_test("error.inside_begin", "2.6.3",
                 "Commands of pixels between glBegin and glEnd are GL_INVALID_OPERATION.",
                 [=](Script& s) {
                   place(s, 8.3, 8.2), s.PixelZoom(8, 8), s.Begin(GL_TRIANGLES), s.Raises(kOperation),
                       s.DrawPixels(4, 4, GL_RGB, GL_UNSIGNED_BYTE, image);
                   s.Raises(kOperation), s.Bitmap(8, 8, 0, 0, 5, 5, image), s.Raises(kOperation),
                       s.PixelZoom(2, 2);
                   s.Raises(kOperation), s.CopyPixels(0, 0, 4, 4, GL_COLOR), s.End(), s.PaintError(0, 0);
                   s.DrawPixels(6, 6, GL_RGB, GL_UNSIGNED_BYTE, image);
                 }),
  };
}

} // namespace softgl::suite
