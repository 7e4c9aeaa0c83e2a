// Display lists of vertices and matrices (5.4).
#include "vertices/chapter.h"
#include "vertices/scenes.h"

namespace softgl::suite {

namespace {

// Lists of these names, each of which draws a square of its own place and color.
void define_squares(Script& s, const V& names) {
  for (size_t i = 0; i < names.size(); i++)
    s.NewList(names[i], GL_COMPILE), tint(s, int(i)),
        patch(s, -0.75 + 0.5 * double(i), 0.5 - 0.3 * double(i), 0.2), s.EndList();
}

// glCallLists of three offsets of the type, which lead to the lists of these names.
Test offsets_row(const char* name, const char* sentence, GLenum type, double base, Memory offsets, V names) {
  return row(name, "5.4", sentence,
             [=](Script& s) { define_squares(s, names), s.ListBase(base), s.CallLists(3, type, offsets); });
}

} // namespace

std::vector<Test> vertices_list_tests() {
  return {
      row("lists.compile", "5.4", "GL_COMPILE draws nothing before the list is called.",
          [](Script& s) {
            s.NewList(1, GL_COMPILE), tint(s, 0), patch(s, 0.6, 0.6, 0.3), s.EndList(), arrow(s),
                s.NewList(2, GL_COMPILE), s.Translatef(-0.6, -0.5, 0), arrow(s), s.EndList(), s.CallList(2);
          }),
      row("lists.compile_and_execute", "5.4",
          "GL_COMPILE_AND_EXECUTE draws at once, and again when the list is called.",
          [](Script& s) {
            s.NewList(1, GL_COMPILE_AND_EXECUTE), s.Translatef(0.4, 0.3, 0), arrow(s), s.EndList(),
                s.Translatef(-1, -1, 0), s.CallList(1);
          }),
      row("lists.primitive_in_parts", "5.4", "The vertices of one primitive may come from several lists.",
          [](Script& s) {
            s.NewList(1, GL_COMPILE), tint(s, 0), s.Vertex3f(-0.8, -0.7, 0), tint(s, 1),
                s.Vertex3f(0.8, -0.6, 0), s.EndList();
            s.NewList(2, GL_COMPILE), tint(s, 2), s.Vertex3f(0.1, 0.9, 0), s.EndList();
            s.Begin(GL_TRIANGLES), s.CallList(1), s.CallList(2), s.End();
          }),
      row("lists.begin_in_list", "5.4", "A list may hold glBegin without its glEnd.",
          [](Script& s) {
            tint(s, 3), s.NewList(1, GL_COMPILE), s.Begin(GL_TRIANGLES), s.EndList();
            s.CallList(1), s.Vertex3f(-0.8, -0.7, 0), s.Vertex3f(0.8, -0.6, 0), s.Vertex3f(0.1, 0.9, 0),
                s.End();
          }),
      row("lists.begin_and_color", "5.4, 2.7",
          "A color behind the glBegin of a list is that of the vertices behind the list.",
          [](Script& s) {
            s.NewList(1, GL_COMPILE), s.Begin(GL_TRIANGLES), tint(s, 3), s.EndList();
            s.CallList(1), s.Vertex3f(-0.8, -0.7, 0), s.Vertex3f(0.8, -0.6, 0), s.Vertex3f(0.1, 0.9, 0),
                s.End();
          }),
      row("lists.nested", "5.4", "A list calls other lists as they are when it is called.",
          [](Script& s) {
            s.NewList(1, GL_COMPILE), arrow(s), s.EndList(), s.NewList(2, GL_COMPILE), s.CallList(1),
                s.Translatef(0.5, 0.5, 0), s.CallList(1), s.EndList();
            s.NewList(1, GL_COMPILE), tint(s, 4), patch(s, 0, 0, 0.2), s.EndList(),
                s.Translatef(-0.3, -0.3, 0), s.CallList(2);
          }),
      row("lists.color_leaves", "5.4", "What a list makes current stays current.",
          [](Script& s) {
            tint(s, 0), s.NewList(1, GL_COMPILE), tint(s, 1), s.EndList(), patch(s, -0.5, 0, 0.3),
                s.CallList(1), patch(s, 0.5, 0, 0.3);
          }),
      row("lists.color_enters", "5.4", "A list takes the color that is current when it is called.",
          [](Script& s) {
            s.NewList(1, GL_COMPILE), patch(s, 0, 0, 0.3), s.EndList(), s.Translatef(-0.5, 0, 0), tint(s, 1),
                s.CallList(1), s.Translatef(1, 0, 0), tint(s, 4), s.CallList(1);
          }),
      row("lists.matrix", "5.4",
          "Matrix commands of a list multiply the matrix that is there when it is called.",
          [](Script& s) {
            s.NewList(1, GL_COMPILE), s.Rotatef(40, 0, 0, 1), s.Translatef(0.45, 0, 0), s.EndList(),
                s.Scalef(0.6, 0.6, 1);
            for (int i = 0; i < 3; i++) s.CallList(1), arrow(s);
          }),
      row("lists.undefined", "5.4", "A list that is not defined does nothing.",
          [](Script& s) { s.CallList(77), arrow(s), s.CallList(78); }),
      row("lists.replaced", "5.4", "A list is replaced when its new definition ends.",
          [](Script& s) {
            s.NewList(1, GL_COMPILE), tint(s, 0), patch(s, -0.5, 0, 0.3), s.EndList();
            s.NewList(1, GL_COMPILE), tint(s, 1), patch(s, 0.5, 0, 0.3), s.EndList(), s.CallList(1);
          }),
      row("lists.deleted", "5.4", "A list that is deleted does nothing.",
          [](Script& s) {
            for (int i = 1; i <= 3; i++)
              s.NewList(i, GL_COMPILE), tint(s, i), patch(s, -1.1 + 0.55 * i, 0, 0.2), s.EndList();
            s.DeleteLists(2, 1);
            for (int i = 1; i <= 3; i++) s.CallList(i);
          }),
      row("lists.deleted_range", "5.4", "glDeleteLists deletes as many lists as it says.",
          [](Script& s) {
            define_squares(s, {5, 6, 7, 8}), s.DeleteLists(6, 2);
            for (int i = 5; i <= 8; i++) s.CallList(i);
          }),
      row("lists.nested_deep", "5.4", "Lists may be nested 64 deep at least.",
          [](Script& s) {
            for (int i = 1; i < 64; i++) s.NewList(i, GL_COMPILE), s.CallList(i + 1), s.EndList();
            s.NewList(64, GL_COMPILE), arrow(s), s.EndList(), s.CallList(1);
          }),
      offsets_row("lists.offsets_b", "Offsets may be signed bytes, which may be negative.", GL_BYTE, 300,
                  Memory{GL_BYTE, {-100, 127, 5}}, {200, 427, 305}),
      offsets_row("lists.offsets_ub", "Offsets may be unsigned bytes.", GL_UNSIGNED_BYTE, 1,
                  Memory{GL_UNSIGNED_BYTE, {200, 7, 255}}, {201, 8, 256}),
      offsets_row("lists.offsets_s", "Offsets may be signed shorts, which may be negative.", GL_SHORT, 1000,
                  Memory{GL_SHORT, {-900, 3000, 5}}, {100, 4000, 1005}),
      offsets_row("lists.offsets_us", "Offsets may be unsigned shorts.", GL_UNSIGNED_SHORT, 2,
                  Memory{GL_UNSIGNED_SHORT, {60000, 7, 300}}, {60002, 9, 302}),
      offsets_row("lists.offsets_i", "Offsets may be integers, which may be negative.", GL_INT, 100000,
                  Memory{GL_INT, {-90000, 70000, 5}}, {10000, 170000, 100005}),
      offsets_row("lists.offsets_ui", "Offsets may be unsigned integers.", GL_UNSIGNED_INT, 3,
                  Memory{GL_UNSIGNED_INT, {3000000000.0, 7, 70000}}, {3000000003.0, 10, 70003}),
      offsets_row("lists.offsets_f", "Offsets may be floats.", GL_FLOAT, 4, Memory{GL_FLOAT, {70000, 7, 300}},
                  {70004, 11, 304}),
      offsets_row("lists.offsets_2_bytes", "GL_2_BYTES has two bytes an offset, the greater one first.",
                  GL_2_BYTES, 1, Memory{GL_UNSIGNED_BYTE, {1, 44, 0, 7, 200, 3}}, {301, 8, 51204}),
      offsets_row("lists.offsets_3_bytes", "GL_3_BYTES has three bytes an offset, the greatest first.",
                  GL_3_BYTES, 1, Memory{GL_UNSIGNED_BYTE, {1, 0, 44, 0, 2, 7, 0, 0, 9}}, {65581, 520, 10}),
      offsets_row("lists.offsets_4_bytes", "GL_4_BYTES has four bytes an offset, the greatest first.",
                  GL_4_BYTES, 1, Memory{GL_UNSIGNED_BYTE, {1, 0, 0, 44, 0, 0, 2, 7, 0, 0, 0, 9}},
                  {16777261, 520, 10}),
      row("lists.offsets_undefined", "5.4", "glCallLists skips lists that are not defined.",
          [](Script& s) {
            define_squares(s, {3, 5}),
                s.CallLists(5, GL_UNSIGNED_BYTE, Memory{GL_UNSIGNED_BYTE, {9, 3, 4, 5, 200}});
          }),
      row("lists.base", "5.4", "glListBase is added to the offsets of glCallLists, and not to glCallList.",
          [](Script& s) {
            define_squares(s, {1, 2, 101, 102}), s.GetFloatv(GL_LIST_BASE, V{0}), s.ListBase(100),
                s.GetFloatv(GL_LIST_BASE, V{100});
            s.CallLists(1, GL_UNSIGNED_BYTE, Memory{GL_UNSIGNED_BYTE, {2}}), s.CallList(1);
          }),
      row("lists.base_when_called", "5.4", "glCallLists of a list takes the base of when the list is called.",
          [](Script& s) {
            define_squares(s, {11, 12, 21, 22}), s.ListBase(10), s.NewList(1, GL_COMPILE),
                s.CallLists(2, GL_UNSIGNED_BYTE, Memory{GL_UNSIGNED_BYTE, {1, 2}}), s.EndList();
            s.ListBase(20), s.CallList(1);
          }),
      row("lists.base_in_list", "5.4", "A list holds glListBase, which leaves it.",
          [](Script& s) {
            define_squares(s, {1, 11, 2, 12}), s.NewList(5, GL_COMPILE), s.ListBase(10), s.EndList();
            s.CallLists(1, GL_UNSIGNED_BYTE, Memory{GL_UNSIGNED_BYTE, {1}}), s.CallList(5),
                s.CallLists(1, GL_UNSIGNED_BYTE, Memory{GL_UNSIGNED_BYTE, {2}});
          }),
      row("lists.base_saved", "6.1.14, table 6.30", "GL_LIST_BIT saves the list base.",
          [](Script& s) {
            define_squares(s, {1, 11, 2, 12}), s.ListBase(10), s.PushAttrib(GL_LIST_BIT), s.ListBase(0),
                s.PopAttrib(), s.CallLists(2, GL_UNSIGNED_BYTE, Memory{GL_UNSIGNED_BYTE, {1, 2}});
          }),
      row("lists.offsets_between", "5.4", "glCallLists between glBegin and glEnd brings vertices.",
          [](Script& s) {
            const double corners[3][2] = {{-0.8, -0.7}, {0.8, -0.6}, {0.1, 0.9}};
            for (int i = 0; i < 3; i++)
              s.NewList(i + 1, GL_COMPILE), tint(s, i), s.Vertex2f(corners[i][0], corners[i][1]), s.EndList();
            s.Begin(GL_TRIANGLES), s.CallLists(3, GL_SHORT, Memory{GL_SHORT, {3, 1, 2}}), s.End();
          }),
      row("lists.many_vertices", "5.4", "A list holds as many vertices as it gets.",
          [](Script& s) {
            s.NewList(1, GL_COMPILE), mesh(s, -0.9, -0.9, 0.9, 0.9, 24), s.EndList(), s.CallList(1);
          }),
      row("lists.attributes", "5.4, 6.1.14", "A list may hold glPushAttrib and glPopAttrib.",
          [](Script& s) {
            tint(s, 2), s.NewList(1, GL_COMPILE), s.PushAttrib(GL_CURRENT_BIT), tint(s, 3),
                patch(s, -0.5, 0, 0.3), s.PopAttrib(), s.EndList();
            s.CallList(1), patch(s, 0.5, 0, 0.3);
          }),
  };
}

} // namespace softgl::suite
