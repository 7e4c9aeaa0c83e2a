// Formats and types of images that are drawn (3.6.4), and how they lie in memory (3.6.1).
#include "pixels/chapter.h"
#include "pixels/scenes.h"

namespace softgl::suite {
namespace {

Test format(const char* name, GLenum what, const char* sentence, Need need = {}) {
  return {std::string("pixels.format.") + name,
          "3.6.4, table 3.6",
          sentence,
          "",
          [=](Script& s) { show_alpha(s), draw_image(s, what, GL_UNSIGNED_BYTE); },
          need};
}
Test type(const char* name, GLenum what, GLenum pixels, const char* sentence, Need need = {}) {
  return {std::string("pixels.type.") + name,
          "3.6.4, tables 3.5, 3.8 to 3.11",
          sentence,
          "",
          [=](Script& s) { show_alpha(s), draw_image(s, pixels, what); },
          need};
}
Test index(const char* name, GLenum what, const char* sentence, std::function<void(Script&)> state = {}) {
  return {std::string("pixels.index.") + name, "3.6.5", sentence, "", [=](Script& s) {
            index_maps(s);
            if (state) state(s);
            draw_image(s, GL_COLOR_INDEX, what);
            s.PixelTransferi(GL_INDEX_SHIFT, 0), s.PixelTransferi(GL_INDEX_OFFSET, 0);
          }};
}

// Bits that are indexes, 8 x 8 pixels.
Test bits(const char* name, const char* sentence, std::function<void(Script&)> state) {
  return pixel_test((std::string("index.") + name).c_str(), "3.6.4, 3.6.5", sentence, [=](Script& s) {
    const V maps[4] = {{0.2, 1}, {0.9, 0.4}, {0.3, 0}, {1, 1}};
    for (unsigned c = 0; c < 4; c++) s.PixelMapfv(GL_PIXEL_MAP_I_TO_R + c, 2, maps[c]);
    place(s, 8.3, 8.2), s.PixelZoom(8, 8), s.PixelStorei(GL_UNPACK_ALIGNMENT, 1), state(s);
    Memory memory{GL_UNSIGNED_BYTE, {0xd1, 0x3a, 0x07, 0xc4, 0x91, 0xe8, 0x5b, 0x2c, 0x77, 0x0f, 0xa3, 0x64,
                                     0x1d, 0xf2, 0x88, 0x35, 0x4e, 0xb9, 0x62, 0xc7, 0x13, 0x8c, 0xd6, 0x59}};
    memory.elements.resize(256, 0x99); // for a GL that takes bits for bytes
    s.DrawPixels(8, 8, GL_COLOR_INDEX, GL_BITMAP, memory);
  });
}

// An image in memory with a way of storing it.
Test store(const char* name, const char* sentence, int width, GLenum format, GLenum element, int count,
           std::function<void(Script&)> state, Need need = {}) {
  return pixel_test((std::string("store.") + name).c_str(), "3.6.1, 3.6.4", sentence,
                    [=](Script& s) {
                      place(s, 8.3, 8.2), s.PixelZoom(8, 8), state(s);
                      s.DrawPixels(width, 6, format, element, elements_of(element, count));
                    },
                    need);
}

} // namespace

std::vector<Test> pixel_format_tests() {
  const char* const kRange = "Unsigned integers map their range to [0, 1].";
  const char* const kSigned = "Signed integers map their range to [-1, 1], and are clamped to [0, 1].";
  const char* const kFirst = "The first component has the most significant bits.";
  const char* const kLast = "In a reversed type the first component has the least significant bits.";
  return {
      format("red", GL_RED, "GL_RED draws red; green and blue are 0, alpha is 1."),
      format("green", GL_GREEN, "GL_GREEN draws green."),
      format("blue", GL_BLUE, "GL_BLUE draws blue."),
      format("alpha", GL_ALPHA, "GL_ALPHA draws black with this alpha."),
      format("luminance", GL_LUMINANCE, "GL_LUMINANCE draws gray with the alpha 1."),
      format("luminance_alpha", GL_LUMINANCE_ALPHA, "GL_LUMINANCE_ALPHA draws gray with an alpha."),
      format("rgb", GL_RGB, "GL_RGB draws colors with the alpha 1."),
      format("rgba", GL_RGBA, "GL_RGBA draws colors with alpha."),
      format("bgr", GL_BGR, "GL_BGR begins with blue.", kVersion12),
      format("bgra", GL_BGRA, "GL_BGRA begins with blue and ends with alpha.", kVersion12),
      type("unsigned_short", GL_UNSIGNED_SHORT, GL_RGBA, kRange),
      type("unsigned_int", GL_UNSIGNED_INT, GL_RGBA, kRange),
      type("byte", GL_BYTE, GL_RGBA, kSigned),
      type("short", GL_SHORT, GL_RGBA, kSigned),
      type("int", GL_INT, GL_RGBA, kSigned),
      type("float", GL_FLOAT, GL_RGBA, "Floats are taken as they are, and clamped to [0, 1]."),
      type("3_3_2", GL_UNSIGNED_BYTE_3_3_2, GL_RGB, kFirst, kVersion12),
      type("2_3_3_rev", GL_UNSIGNED_BYTE_2_3_3_REV, GL_RGB, kLast, kVersion12),
      type("5_6_5", GL_UNSIGNED_SHORT_5_6_5, GL_RGB, kFirst, kVersion12),
      type("5_6_5_rev", GL_UNSIGNED_SHORT_5_6_5_REV, GL_RGB, kLast, kVersion12),
      type("4_4_4_4", GL_UNSIGNED_SHORT_4_4_4_4, GL_RGBA, kFirst, kVersion12),
      type("4_4_4_4_rev", GL_UNSIGNED_SHORT_4_4_4_4_REV, GL_RGBA, kLast, kVersion12),
      type("5_5_5_1", GL_UNSIGNED_SHORT_5_5_5_1, GL_RGBA, kFirst, kVersion12),
      type("1_5_5_5_rev", GL_UNSIGNED_SHORT_1_5_5_5_REV, GL_RGBA, kLast, kVersion12),
      type("8_8_8_8", GL_UNSIGNED_INT_8_8_8_8, GL_RGBA, kFirst, kVersion12),
      type("8_8_8_8_rev", GL_UNSIGNED_INT_8_8_8_8_REV, GL_RGBA, kLast, kVersion12),
      type("10_10_10_2", GL_UNSIGNED_INT_10_10_10_2, GL_RGBA, kFirst, kVersion12),
      type("2_10_10_10_rev", GL_UNSIGNED_INT_2_10_10_10_REV, GL_RGBA, kLast, kVersion12),
      type("4_4_4_4_bgra", GL_UNSIGNED_SHORT_4_4_4_4, GL_BGRA,
           "In GL_BGRA the first component of a packed type is blue.", kVersion12),
      type("1_5_5_5_rev_bgra", GL_UNSIGNED_SHORT_1_5_5_5_REV, GL_BGRA,
           "In GL_BGRA the first component of a packed type is blue.", kVersion12),
      bits("bitmap", "Indexes may be the bits of a bitmap, of each byte the most significant one first.",
           [](Script&) {}),
      bits("bitmap_lsb_first", "With GL_UNPACK_LSB_FIRST the least significant bit comes first.",
           [](Script& s) { s.PixelStorei(GL_UNPACK_LSB_FIRST, 1); }),
      bits("bitmap_part", "Bits of a bitmap are skipped one by one.",
           [](Script& s) {
             s.PixelStorei(GL_UNPACK_ROW_LENGTH, 20), s.PixelStorei(GL_UNPACK_SKIP_PIXELS, 5);
           }),
      index("bytes", GL_UNSIGNED_BYTE, "Color indexes become colors by the maps from I to R, G, B and A."),
      index("shorts", GL_UNSIGNED_SHORT, "Indexes may be shorts."),
      index("floats", GL_FLOAT, "Indexes may be floats."),
      index("shifted", GL_UNSIGNED_BYTE, "A positive shift moves the bits of an index to the left.",
            [](Script& s) { s.PixelTransferi(GL_INDEX_SHIFT, 1); }),
      index("shifted_right", GL_UNSIGNED_BYTE, "A negative shift moves the bits of an index to the right.",
            [](Script& s) { s.PixelTransferi(GL_INDEX_SHIFT, -2); }),
      index("offset", GL_UNSIGNED_BYTE, "The offset is added to an index behind the shift.",
            [](Script& s) { s.PixelTransferi(GL_INDEX_SHIFT, 1), s.PixelTransferi(GL_INDEX_OFFSET, 3); }),
  };
}

std::vector<Test> pixel_store_tests() {
  const auto set = [](GLenum name, int value) { return [=](Script& s) { s.PixelStorei(name, value); }; };
  const GLenum bytes = GL_UNSIGNED_BYTE;
  return {
      store("alignment_1", "With an alignment of 1 rows follow each other.", 5, GL_RGB, bytes, 90,
            set(GL_UNPACK_ALIGNMENT, 1)),
      store("alignment_2", "With an alignment of 2 rows begin at even bytes.", 5, GL_RGB, bytes, 96,
            set(GL_UNPACK_ALIGNMENT, 2)),
      store("alignment_4", "The first alignment is 4.", 5, GL_RGB, bytes, 96, [](Script&) {}),
      store("alignment_8", "With an alignment of 8 rows begin at a multiple of 8 bytes.", 5, GL_RED, bytes,
            48, set(GL_UNPACK_ALIGNMENT, 8)),
      store("alignment_of_shorts", "Shorts in rows of 8 bytes.", 3, GL_RED, GL_UNSIGNED_SHORT, 24,
            set(GL_UNPACK_ALIGNMENT, 8)),
      store("row_length", "Rows have GL_UNPACK_ROW_LENGTH pixels in memory.", 5, GL_RGBA, bytes, 192,
            set(GL_UNPACK_ROW_LENGTH, 8)),
      store(
          "skip_pixels", "GL_UNPACK_SKIP_PIXELS pixels of each row are skipped.", 5, GL_RGBA, bytes, 192,
          [](Script& s) { s.PixelStorei(GL_UNPACK_ROW_LENGTH, 8), s.PixelStorei(GL_UNPACK_SKIP_PIXELS, 2); }),
      store("skip_rows", "GL_UNPACK_SKIP_ROWS rows are skipped.", 5, GL_RGBA, bytes, 180,
            set(GL_UNPACK_SKIP_ROWS, 3)),
      store("all", "Row length, skipped rows and pixels, and alignment go together.", 4, GL_RGB, bytes, 250,
            [](Script& s) {
              s.PixelStorei(GL_UNPACK_ROW_LENGTH, 9), s.PixelStorei(GL_UNPACK_SKIP_ROWS, 2);
              s.PixelStorei(GL_UNPACK_SKIP_PIXELS, 3), s.PixelStorei(GL_UNPACK_ALIGNMENT, 8);
            }),
      store("swap_shorts", "GL_UNPACK_SWAP_BYTES turns the two bytes of a short round.", 5, GL_RGB,
            GL_UNSIGNED_SHORT, 96, set(GL_UNPACK_SWAP_BYTES, 1)),
      store("swap_ints", "GL_UNPACK_SWAP_BYTES turns the four bytes of an integer round.", 5, GL_RGB,
            GL_UNSIGNED_INT, 90, set(GL_UNPACK_SWAP_BYTES, 1)),
      store("swap_packed", "GL_UNPACK_SWAP_BYTES turns the bytes of a packed pixel round.", 6, GL_RGB,
            GL_UNSIGNED_SHORT_5_6_5, 36, set(GL_UNPACK_SWAP_BYTES, 1), kVersion12),
      store("swap_not_bytes", "GL_UNPACK_SWAP_BYTES does nothing to bytes.", 5, GL_RGBA, bytes, 120,
            set(GL_UNPACK_SWAP_BYTES, 1)),
      pixel_test("store.at_compile", "5.4", "A list unpacks an image by the state of when it is compiled.",
                 [](Script& s) {
                   place(s, 8.3, 8.2), s.PixelZoom(8, 8), s.PixelStorei(GL_UNPACK_ROW_LENGTH, 8);
                   s.NewList(3, GL_COMPILE),
                       s.DrawPixels(5, 6, GL_RGBA, GL_UNSIGNED_BYTE, elements_of(GL_UNSIGNED_BYTE, 192));
                   s.EndList(), s.PixelStorei(GL_UNPACK_ROW_LENGTH, 0), s.CallList(3);
                 }),
      pixel_test("store.initial", "3.6.1, table 3.1", "Storage has the initial values of the table.",
                 [](Script& s) {
                   const auto is = [&](GLenum name, double value, int at) {
                     s.PaintInteger(name, value, value, 2 + 9 * at, 2);
                   };
                   is(GL_UNPACK_ALIGNMENT, 4, 0), is(GL_UNPACK_ROW_LENGTH, 0, 1),
                       is(GL_UNPACK_SKIP_ROWS, 0, 2);
                   is(GL_UNPACK_SKIP_PIXELS, 0, 3), is(GL_UNPACK_SWAP_BYTES, 0, 4),
                       is(GL_UNPACK_LSB_FIRST, 0, 5);
                   is(GL_PACK_ALIGNMENT, 4, 6), is(GL_PACK_ROW_LENGTH, 0, 7), is(GL_PACK_SWAP_BYTES, 0, 8);
                 }),
  };
}

} // namespace softgl::suite
