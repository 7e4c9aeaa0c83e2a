// Vertex arrays (2.8).
#include <cmath>
#include <cstring>

#include "lighting/scenes.h"
#include "vertices/chapter.h"
#include "vertices/scenes.h"

namespace softgl::suite {
namespace {

constexpr Need kRangeElements{12, "GL_EXT_draw_range_elements"};

const std::vector<double> kPositions = {-0.9, -0.8, 0, -0.5, 0.7,  0, -0.1, -0.6, 0,
                                        0.2,  0.8,  0, 0.5,  -0.7, 0, 0.9,  0.75, 0};
const std::vector<double> kColors = {1, 0.2, 0.1, 1, 0.2, 1,   0.3, 1, 0.3, 0.4, 1,   1,
                                     1, 0.9, 0.2, 1, 0.9, 0.3, 1,   1, 0.2, 0.9, 0.9, 1};

void set_positions(Script& s) {
  s.EnableClientState(GL_VERTEX_ARRAY), s.VertexPointer(3, GL_FLOAT, 0, Memory{GL_FLOAT, kPositions});
}
void set_colors(Script& s) {
  s.EnableClientState(GL_COLOR_ARRAY), s.ColorPointer(4, GL_FLOAT, 0, Memory{GL_FLOAT, kColors});
}

// The first `take` of every `of` numbers, times `scale`, and `padding` zeros behind each.
std::vector<double> spread(const std::vector<double>& from, size_t of, size_t take, double scale,
                           size_t padding = 0) {
  std::vector<double> to;
  for (size_t i = 0; i < from.size(); i += of) {
    for (size_t j = 0; j < take; j++)
      to.push_back(scale == 1 ? from[i + j] : std::trunc(from[i + j] * scale));
    to.insert(to.end(), padding, 99);
  }
  return to;
}

Test positions_row(const char* name, const char* sentence, int size, GLenum type, int stride, Memory memory,
                   double scale) {
  return row(name, "2.8", sentence, [=](Script& s) {
    s.Scalef(1 / scale, 1 / scale, 1), s.EnableClientState(GL_VERTEX_ARRAY);
    s.VertexPointer(size, type, stride, memory), set_colors(s);
    s.DrawArrays(GL_TRIANGLE_STRIP, 0, 6);
  });
}
Test colors_row(const char* name, const char* sentence, int size, GLenum type, int stride, Memory memory) {
  return row(name, "2.8, table 2.4", sentence, [=](Script& s) {
    set_positions(s), s.EnableClientState(GL_COLOR_ARRAY), s.ColorPointer(size, type, stride, memory);
    s.DrawArrays(GL_TRIANGLE_STRIP, 0, 6);
  });
}
Test elements_row(const char* name, const char* sentence, GLenum type) {
  return row(name, "2.8", sentence, [=](Script& s) {
    set_positions(s), set_colors(s);
    s.DrawElements(GL_TRIANGLES, 9, type, Memory{type, {5, 3, 4, 0, 2, 1, 1, 2, 4}});
  });
}

struct Interleaved {
  GLenum format;
  int texture, color, normal, vertex; // components; color 1: four unsigned bytes
};

// The elements of the format as bytes, with `padding` bytes behind each.
Memory interleaved(const Interleaved& f, size_t padding) {
  Memory memory{GL_UNSIGNED_BYTE, {}};
  const auto put = [&](double number) {
    const float real = float(number);
    uint8_t bytes[4];
    std::memcpy(bytes, &real, 4);
    memory.elements.insert(memory.elements.end(), bytes, bytes + 4);
  };
  for (size_t i = 0; i < 6; i++) {
    for (int c = 0; c < f.texture; c++) put(0.25);
    if (f.color == 1)
      for (size_t c = 0; c < 4; c++) memory.elements.push_back(std::trunc(255 * kColors[4 * i + c]));
    else
      for (size_t c = 0; c < size_t(f.color); c++) put(kColors[4 * i + c]);
    for (int c = 0; c < f.normal; c++) put(c == 2 ? 0.6 : c == int(i % 2) ? 0.8 : 0);
    const double w = f.vertex == 4 ? 2 : 1;
    for (size_t c = 0; c < size_t(f.vertex); c++) put(c == 3 ? w : kPositions[3 * i + c] * w);
    memory.elements.insert(memory.elements.end(), padding, 99);
  }
  return memory;
}
Test interleaved_row(const char* name, const Interleaved& f, int stride = 0, size_t padding = 0) {
  static const char kSentence[] = "glInterleavedArrays finds each value where table 2.5 says.";
  return row(name, "2.8, table 2.5", kSentence, [=](Script& s) {
    tint(s, 3);
    if (f.normal) diffuse_scene(s, {1, 0.5, 1, 0});
    if (f.normal && f.color) s.ColorMaterial(GL_FRONT, GL_DIFFUSE), s.Enable(GL_COLOR_MATERIAL);
    // What the format does not have is switched off.
    s.EnableClientState(GL_COLOR_ARRAY), s.EnableClientState(GL_NORMAL_ARRAY),
        s.EnableClientState(GL_EDGE_FLAG_ARRAY);
    s.InterleavedArrays(f.format, stride, interleaved(f, padding));
    s.DrawArrays(GL_TRIANGLE_STRIP, 0, 6);
  });
}

} // namespace

std::vector<Test> vertices_array_tests() {
  return {
      row("arrays.draw_arrays", "2.8", "glDrawArrays draws `count` elements from `first` on.",
          [](Script& s) {
            set_positions(s), set_colors(s), s.DrawArrays(GL_TRIANGLES, 1, 3), s.DrawArrays(GL_LINES, 4, 2);
          }),
      row("arrays.array_element", "2.8", "glArrayElement takes one element of all arrays that are enabled.",
          [](Script& s) {
            set_positions(s), set_colors(s), s.Begin(GL_TRIANGLES);
            for (int i : {0, 2, 1, 3, 4, 5}) s.ArrayElement(i);
            s.End();
          }),
      row("arrays.element_mixed", "2.8", "A color between two glArrayElement is as good as that of an array.",
          [](Script& s) {
            set_positions(s), s.Begin(GL_TRIANGLE_STRIP);
            for (int i = 0; i < 6; i++) tint(s, i), s.ArrayElement(i);
            s.End();
          }),
      elements_row("arrays.elements_byte", "glDrawElements takes indices of unsigned bytes.",
                   GL_UNSIGNED_BYTE),
      elements_row("arrays.elements_short", "glDrawElements takes indices of unsigned shorts.",
                   GL_UNSIGNED_SHORT),
      elements_row("arrays.elements_int", "glDrawElements takes indices of unsigned integers.",
                   GL_UNSIGNED_INT),
      row(
          "arrays.range_elements", "2.8", "glDrawRangeElements draws what glDrawElements draws.",
          [](Script& s) {
            set_positions(s), set_colors(s);
            s.DrawRangeElements(GL_TRIANGLES, 1, 5, 6, GL_UNSIGNED_SHORT,
                                Memory{GL_UNSIGNED_SHORT, {5, 3, 4, 1, 2, 4}});
          },
          kRangeElements),
      row("arrays.color_disabled", "2.8", "Without its array, the current color is used.",
          [](Script& s) {
            set_positions(s), set_colors(s), s.DisableClientState(GL_COLOR_ARRAY), tint(s, 4);
            s.DrawArrays(GL_TRIANGLES, 0, 6);
          }),
      row("arrays.vertex_disabled", "2.8", "Without the vertex array nothing is drawn.",
          [](Script& s) {
            set_positions(s), set_colors(s), s.DisableClientState(GL_VERTEX_ARRAY),
                s.DrawArrays(GL_TRIANGLES, 0, 3);
            s.EnableClientState(GL_VERTEX_ARRAY), s.DrawArrays(GL_TRIANGLES, 3, 3);
          }),
      positions_row("arrays.vertex_2f", "Positions of two floats have z = 0 and w = 1.", 2, GL_FLOAT, 0,
                    Memory{GL_FLOAT, spread(kPositions, 3, 2, 1)}, 1),
      positions_row("arrays.vertex_2s", "Positions may be shorts, which are not scaled.", 2, GL_SHORT, 0,
                    Memory{GL_SHORT, spread(kPositions, 3, 2, 30)}, 30),
      positions_row("arrays.vertex_3i", "Positions may be integers, which are not scaled.", 3, GL_INT, 0,
                    Memory{GL_INT, spread(kPositions, 3, 3, 30)}, 30),
      positions_row("arrays.vertex_3d", "Positions may be doubles.", 3, GL_DOUBLE, 0,
                    Memory{GL_DOUBLE, spread(kPositions, 3, 3, 1)}, 1),
      positions_row("arrays.vertex_stride", "The stride is the distance of two elements in bytes.", 2,
                    GL_FLOAT, 20, Memory{GL_FLOAT, spread(kPositions, 3, 2, 1, 3)}, 1),
      positions_row("arrays.vertex_stride_tight", "A stride may be the size of an element.", 3, GL_FLOAT, 12,
                    Memory{GL_FLOAT, kPositions}, 1),
      colors_row("arrays.color_3f", "Colors of three components have alpha 1.", 3, GL_FLOAT, 0,
                 Memory{GL_FLOAT, spread(kColors, 4, 3, 1)}),
      colors_row("arrays.color_ub", "Colors of unsigned bytes are c / 255.", 4, GL_UNSIGNED_BYTE, 0,
                 Memory{GL_UNSIGNED_BYTE, spread(kColors, 4, 4, 255)}),
      colors_row("arrays.color_b_stride", "Colors of signed bytes are (2c + 1) / 255.", 3, GL_BYTE, 4,
                 Memory{GL_BYTE, spread(kColors, 4, 3, 127, 1)}),
      colors_row("arrays.color_s", "Colors of signed shorts are (2c + 1) / 65535.", 3, GL_SHORT, 0,
                 Memory{GL_SHORT, spread(kColors, 4, 3, 32767)}),
      colors_row("arrays.color_us", "Colors of unsigned shorts are c / 65535.", 4, GL_UNSIGNED_SHORT, 0,
                 Memory{GL_UNSIGNED_SHORT, spread(kColors, 4, 4, 65535)}),
      colors_row("arrays.color_ui", "Colors of unsigned integers are c / (2^32 - 1).", 4, GL_UNSIGNED_INT, 0,
                 Memory{GL_UNSIGNED_INT, spread(kColors, 4, 4, 4294967295.0)}),
      colors_row("arrays.color_i", "Colors of signed integers are (2c + 1) / (2^32 - 1).", 3, GL_INT, 0,
                 Memory{GL_INT, spread(kColors, 4, 3, 2147483647.0)}),
      colors_row("arrays.color_d", "Colors of doubles are taken as they are.", 4, GL_DOUBLE, 0,
                 Memory{GL_DOUBLE, kColors}),
      row("arrays.color_alpha", "2.8", "The fourth component of a color array is alpha.",
          [](Script& s) {
            std::vector<double> colors = kColors;
            for (size_t i = 0; i < 6; i++) colors[4 * i + 3] = 0.2 + 0.15 * double(i);
            s.Enable(GL_BLEND), s.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), set_positions(s);
            s.EnableClientState(GL_COLOR_ARRAY), s.ColorPointer(4, GL_FLOAT, 0, Memory{GL_FLOAT, colors});
            s.DrawArrays(GL_TRIANGLE_STRIP, 0, 6);
          }),
      row("arrays.normal_b", "2.8, table 2.4", "Normals of signed bytes are (2c + 1) / 255.",
          [](Script& s) {
            diffuse_scene(s, {1, 0.5, 1, 0}), set_positions(s), s.EnableClientState(GL_NORMAL_ARRAY);
            s.NormalPointer(
                GL_BYTE, 3,
                Memory{GL_BYTE, {0, 0, 127, 127, 0, 0, 0, 90, 90, 0, 0, 80, 70, 20, 70, 0, 0, 127}});
            s.DrawArrays(GL_TRIANGLE_STRIP, 0, 6);
          }),
      row("arrays.edge_flags", "2.8", "The array of edge flags gives each vertex its flag.",
          [](Script& s) {
            s.PolygonMode(GL_FRONT_AND_BACK, GL_LINE), tint(s, 3);
            s.EnableClientState(GL_VERTEX_ARRAY), s.EnableClientState(GL_EDGE_FLAG_ARRAY);
            s.VertexPointer(2, GL_FLOAT, 0,
                            Memory{GL_FLOAT, {-0.9, -0.8, 0.2, -0.9, 0.9, 0.1, 0.3, 0.9, -0.7, 0.6}});
            s.EdgeFlagPointer(0, Memory{GL_UNSIGNED_BYTE, {1, 0, 1, 1, 0}});
            s.DrawArrays(GL_POLYGON, 0, 5);
          }),
      interleaved_row("arrays.interleaved_v2f", {GL_V2F, 0, 0, 0, 2}),
      interleaved_row("arrays.interleaved_v3f_stride", {GL_V3F, 0, 0, 0, 3}, 20, 8),
      interleaved_row("arrays.interleaved_c4ub_v2f", {GL_C4UB_V2F, 0, 1, 0, 2}),
      interleaved_row("arrays.interleaved_c4ub_v3f_stride", {GL_C4UB_V3F, 0, 1, 0, 3}, 24, 8),
      interleaved_row("arrays.interleaved_c3f_v3f", {GL_C3F_V3F, 0, 3, 0, 3}),
      interleaved_row("arrays.interleaved_n3f_v3f", {GL_N3F_V3F, 0, 0, 3, 3}),
      interleaved_row("arrays.interleaved_c4f_n3f_v3f", {GL_C4F_N3F_V3F, 0, 4, 3, 3}),
      interleaved_row("arrays.interleaved_t2f_v3f", {GL_T2F_V3F, 2, 0, 0, 3}),
      interleaved_row("arrays.interleaved_t4f_v4f", {GL_T4F_V4F, 4, 0, 0, 4}),
      interleaved_row("arrays.interleaved_t2f_c4ub_v3f", {GL_T2F_C4UB_V3F, 2, 1, 0, 3}),
      interleaved_row("arrays.interleaved_t2f_c3f_v3f", {GL_T2F_C3F_V3F, 2, 3, 0, 3}),
      interleaved_row("arrays.interleaved_t2f_n3f_v3f", {GL_T2F_N3F_V3F, 2, 0, 3, 3}),
      interleaved_row("arrays.interleaved_t2f_c4f_n3f_v3f", {GL_T2F_C4F_N3F_V3F, 2, 4, 3, 3}),
      interleaved_row("arrays.interleaved_t4f_c4f_n3f_v4f", {GL_T4F_C4F_N3F_V4F, 4, 4, 3, 4}),
      row("arrays.element_color_stays", "2.8", "The color of a glArrayElement is current behind it.",
          [](Script& s) {
            set_positions(s), set_colors(s), s.Begin(GL_POINTS), s.ArrayElement(2), s.End();
            s.DisableClientState(GL_COLOR_ARRAY), patch(s, 0, 0, 0.5);
          }),
      row("arrays.list_holds_elements", "2.8, 5.4",
          "A list holds the elements as they are when it is compiled.",
          [](Script& s) {
            set_positions(s), set_colors(s), s.NewList(5, GL_COMPILE), s.DrawArrays(GL_TRIANGLE_STRIP, 0, 6),
                s.EndList();
            s.VertexPointer(3, GL_FLOAT, 0, Memory{GL_FLOAT, std::vector<double>(18, 0.3)});
            s.DisableClientState(GL_COLOR_ARRAY), s.CallList(5);
          }),
      row("arrays.queried", "table 6.6", "Sizes, types and strides of arrays can be asked for.",
          [](Script& s) {
            s.GetFloatv(GL_VERTEX_ARRAY_SIZE, V{4}), s.GetFloatv(GL_VERTEX_ARRAY_TYPE, V{double(GL_FLOAT)});
            s.IsEnabled(GL_VERTEX_ARRAY, 0), s.EnableClientState(GL_VERTEX_ARRAY),
                s.IsEnabled(GL_VERTEX_ARRAY, 1);
            s.VertexPointer(2, GL_SHORT, 12, Memory{GL_SHORT, {1, 2, 3, 4, 5, 6}});
            s.GetFloatv(GL_VERTEX_ARRAY_SIZE, V{2}), s.GetFloatv(GL_VERTEX_ARRAY_TYPE, V{double(GL_SHORT)});
            s.GetFloatv(GL_VERTEX_ARRAY_STRIDE, V{12}), s.IsEnabled(GL_COLOR_ARRAY, 0);
            s.ColorPointer(3, GL_UNSIGNED_BYTE, 4, Memory{GL_UNSIGNED_BYTE, {1, 2, 3, 4}});
            s.GetFloatv(GL_COLOR_ARRAY_SIZE, V{3}), s.GetFloatv(GL_COLOR_ARRAY_STRIDE, V{4});
          }),
  };
}

} // namespace softgl::suite
