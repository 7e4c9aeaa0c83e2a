// Display lists of vertices and matrices (5.4).
#include "vertices/chapter.h"
#include "vertices/scenes.h"

namespace softgl::suite {

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
