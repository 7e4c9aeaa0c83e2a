// Errors (2.5): the wrong command does nothing, and what is drawn behind it shows that.
#include "vertices/chapter.h"
#include "vertices/scenes.h"

namespace softgl::suite {
namespace {

// A triangle with the wrong command between two of its vertices.
void torn_triangle(Script& s, const std::function<void()>& wrong) {
  s.Begin(GL_TRIANGLES), s.Color3f(0.9, 0.5, 0.2), s.Vertex3f(-0.8, -0.7, 0), s.Vertex3f(0.8, -0.6, 0);
  wrong(), s.raises(GL_INVALID_OPERATION);
  s.Vertex3f(0.1, 0.9, 0), s.End();
}

// Nothing of what the matrix commands and the viewport do is done.
void nothing_moved(Script& s) {
  s.GetFloatv(GL_MATRIX_MODE, V{double(GL_MODELVIEW)}),
      s.GetFloatv(GL_MODELVIEW_MATRIX, V{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -5, 1});
  s.GetFloatv(GL_VIEWPORT, V{0, 0, 96, 96}), arrow(s);
}

} // namespace

std::vector<Test> vertices_error_tests() {
  return {
      row("errors.begin_mode", "2.6.1", "glBegin of no primitive is GL_INVALID_ENUM, and begins nothing.",
          [](Script& s) { s.Begin(99), s.raises(GL_INVALID_ENUM), arrow(s); }),
      row("errors.begin_in_begin", "2.6.3", "glBegin between glBegin and glEnd is GL_INVALID_OPERATION.",
          [](Script& s) { torn_triangle(s, [&] { s.Begin(GL_LINES); }); }),
      row("errors.end_alone", "2.6.3", "glEnd without glBegin is GL_INVALID_OPERATION.",
          [](Script& s) {
            s.End(), s.raises(GL_INVALID_OPERATION), arrow(s), s.End(), s.raises(GL_INVALID_OPERATION);
          }),
      row("errors.first_stays", "2.5", "The first error stays until it is asked for.",
          [](Script& s) {
            torn_triangle(s,
                          [&] { s.MatrixMode(GL_PROJECTION), s.raises(GL_INVALID_OPERATION), s.Begin(99); });
            arrow(s);
          }),
      row("errors.matrices_in_begin", "2.6.3",
          "Matrix commands between glBegin and glEnd are GL_INVALID_OPERATION.",
          [](Script& s) {
            torn_triangle(s, [&] { s.MatrixMode(GL_PROJECTION); }),
                torn_triangle(s, [&] { s.LoadIdentity(); });
            torn_triangle(s,
                          [&] {
                            s.LoadMatrixf(V{9, 0, 0, 0, 0, 9, 0, 0, 0, 0, 9, 0, 0, 0, 0, 9});
                          }),
                torn_triangle(s, [&] { s.Translatef(1, 1, 1); });
            torn_triangle(s, [&] { s.Scalef(3, 3, 3); }), torn_triangle(s, [&] { s.Rotatef(50, 1, 0, 0); }),
                torn_triangle(s, [&] { s.PushMatrix(); });
            torn_triangle(s, [&] { s.PopMatrix(); }), torn_triangle(s, [&] { s.Ortho(-1, 1, -1, 1, -1, 1); });
            torn_triangle(s, [&] { s.Frustum(-1, 1, -1, 1, 1, 2); }),
                torn_triangle(s, [&] { s.Viewport(1, 2, 3, 4); });
            torn_triangle(s, [&] { s.DepthRange(0.5, 0.5); }), nothing_moved(s);
          }),
      row("errors.state_in_begin", "2.6.3",
          "Commands that set state between glBegin and glEnd are GL_INVALID_OPERATION.",
          [](Script& s) {
            torn_triangle(s, [&] { s.Enable(GL_LIGHTING); }), torn_triangle(s, [&] { s.Disable(GL_DITHER); }),
                torn_triangle(s, [&] { s.ShadeModel(GL_FLAT); });
            torn_triangle(s, [&] { s.Clear(GL_COLOR_BUFFER_BIT); }),
                torn_triangle(s, [&] { s.PointSize(20); }), torn_triangle(s, [&] { s.CullFace(GL_FRONT); });
            torn_triangle(s, [&] { s.PushAttrib(GL_ALL_ATTRIB_BITS); }),
                torn_triangle(s, [&] { s.NewList(5, GL_COMPILE); });
            torn_triangle(s, [&] { s.RasterPos3f(0, 0, 0); }),
                torn_triangle(s, [&] { s.Rectf(-1, -1, 1, 1); });
            torn_triangle(s, [&] { s.ClipPlane(GL_CLIP_PLANE0, V{0, 0, 0, -1}); });
            s.IsEnabled(GL_LIGHTING, 0), s.GetFloatv(GL_ATTRIB_STACK_DEPTH, V{0}),
                s.GetFloatv(GL_POINT_SIZE, V{1}), arrow(s);
          }),
      row("errors.viewport", "2.11.1", "A viewport of negative size is GL_INVALID_VALUE.",
          [](Script& s) {
            s.Viewport(0, 0, -1, 20), s.raises(GL_INVALID_VALUE), s.Viewport(9, 9, 20, -3),
                s.raises(GL_INVALID_VALUE), nothing_moved(s);
          }),
      row("errors.matrix_mode", "2.11.2", "glMatrixMode of no matrix is GL_INVALID_ENUM.",
          [](Script& s) {
            s.MatrixMode(GL_LIGHTING), s.raises(GL_INVALID_ENUM), s.MatrixMode(0), s.raises(GL_INVALID_ENUM),
                nothing_moved(s);
          }),
      row("errors.frustum", "2.11.2", "glFrustum of no volume is GL_INVALID_VALUE.",
          [](Script& s) {
            s.Frustum(-1, 1, -1, 1, 0, 5), s.raises(GL_INVALID_VALUE), s.Frustum(-1, 1, -1, 1, 1, -5),
                s.raises(GL_INVALID_VALUE);
            s.Frustum(1, 1, -1, 1, 1, 5), s.raises(GL_INVALID_VALUE), s.Frustum(-1, 1, 2, 2, 1, 5),
                s.raises(GL_INVALID_VALUE);
            s.Frustum(-1, 1, -1, 1, 5, 5), s.raises(GL_INVALID_VALUE), nothing_moved(s);
          }),
      row("errors.ortho", "2.11.2", "glOrtho of no volume is GL_INVALID_VALUE.",
          [](Script& s) {
            s.Ortho(1, 1, -1, 1, 0, 5), s.raises(GL_INVALID_VALUE), s.Ortho(-1, 1, 3, 3, 1, 5),
                s.raises(GL_INVALID_VALUE);
            s.Ortho(-1, 1, -1, 1, 5, 5), s.raises(GL_INVALID_VALUE), nothing_moved(s);
          }),
      row("errors.stack_underflow", "2.11.2", "glPopMatrix of the last matrix is GL_STACK_UNDERFLOW.",
          [](Script& s) {
            s.PopMatrix(), s.raises(GL_STACK_UNDERFLOW), s.MatrixMode(GL_PROJECTION), s.PopMatrix(),
                s.raises(GL_STACK_UNDERFLOW), s.MatrixMode(GL_MODELVIEW);
            s.PopAttrib(), s.raises(GL_STACK_UNDERFLOW), nothing_moved(s);
          }),
      row("errors.enable", "6.1.1", "glEnable and glDisable of what does not exist are GL_INVALID_ENUM.",
          [](Script& s) {
            s.Enable(GL_FLAT), s.raises(GL_INVALID_ENUM), s.Disable(GL_PROJECTION), s.raises(GL_INVALID_ENUM);
            s.EnableClientState(GL_LIGHTING), s.raises(GL_INVALID_ENUM), arrow(s);
          }),
      row("errors.clip_plane", "2.12", "glClipPlane of no plane is GL_INVALID_ENUM.",
          [](Script& s) {
            s.Enable(GL_CLIP_PLANE0), s.ClipPlane(GL_LIGHT0, V{0, 0, 0, -1}), s.raises(GL_INVALID_ENUM),
                arrow(s);
          }),
      row("errors.arrays", "2.8", "Array commands with a wrong size, type or stride do nothing.",
          [](Script& s) {
            const Memory wrong{GL_FLOAT, {9, 9, 9, 9, 9, 9, 9, 9, 9}};
            s.EnableClientState(GL_VERTEX_ARRAY);
            s.VertexPointer(3, GL_FLOAT, 0, Memory{GL_FLOAT, {-0.8, -0.7, 0, 0.8, -0.6, 0, 0.1, 0.9, 0}});
            s.VertexPointer(5, GL_FLOAT, 0, wrong), s.raises(GL_INVALID_VALUE),
                s.VertexPointer(1, GL_FLOAT, 0, wrong), s.raises(GL_INVALID_VALUE);

            s.VertexPointer(3, GL_UNSIGNED_BYTE, 0, wrong), s.raises(GL_INVALID_ENUM);
            s.ColorPointer(2, GL_FLOAT, 0, wrong), s.raises(GL_INVALID_VALUE),
                s.NormalPointer(GL_UNSIGNED_SHORT, 0, wrong), s.raises(GL_INVALID_ENUM);
            s.TexCoordPointer(0, GL_FLOAT, 0, wrong), s.raises(GL_INVALID_VALUE),
                s.EdgeFlagPointer(-1, wrong), s.raises(GL_INVALID_VALUE);
            s.InterleavedArrays(GL_FLOAT, 0, wrong), s.raises(GL_INVALID_ENUM),
                s.InterleavedArrays(GL_V3F, -1, wrong), s.raises(GL_INVALID_VALUE);
            tint(s, 3), s.DrawArrays(GL_TRIANGLES, 0, 3);
          }),
      row("errors.stride", "2.8", "A negative stride is GL_INVALID_VALUE, and the array stays what it was.",
          [](Script& s) {
            s.EnableClientState(GL_VERTEX_ARRAY);
            s.VertexPointer(3, GL_FLOAT, 0, Memory{GL_FLOAT, {-0.8, -0.7, 0, 0.8, -0.6, 0, 0.1, 0.9, 0}});
            s.VertexPointer(3, GL_FLOAT, -4, Memory{GL_FLOAT, std::vector<double>(99, 9)}),
                s.raises(GL_INVALID_VALUE);
            s.GetFloatv(GL_VERTEX_ARRAY_STRIDE, V{0}), tint(s, 3), s.DrawArrays(GL_TRIANGLES, 0, 3);
          }),
      row("errors.draw", "2.8", "Drawing commands with a wrong mode, count or type draw nothing.",
          [](Script& s) {
            const Memory indices{GL_UNSIGNED_BYTE, {0, 1, 2}};
            s.EnableClientState(GL_VERTEX_ARRAY);
            s.VertexPointer(3, GL_FLOAT, 0, Memory{GL_FLOAT, {-0.8, -0.7, 0, 0.8, -0.6, 0, 0.1, 0.9, 0}});
            s.DrawArrays(GL_TRIANGLES, 0, -1), s.raises(GL_INVALID_VALUE), s.DrawArrays(77, 0, 3),
                s.raises(GL_INVALID_ENUM);
            s.DrawElements(GL_TRIANGLES, -1, GL_UNSIGNED_BYTE, indices), s.raises(GL_INVALID_VALUE);
            s.DrawElements(GL_TRIANGLES, 3, GL_FLOAT, indices), s.raises(GL_INVALID_ENUM);
            s.DrawElements(77, 3, GL_UNSIGNED_BYTE, indices), s.raises(GL_INVALID_ENUM), arrow(s);
          }),
      row("errors.lists", "5.4", "glNewList of list 0 or in a list, and glEndList without it, are errors.",
          [](Script& s) {
            s.NewList(0, GL_COMPILE), s.raises(GL_INVALID_VALUE), s.EndList(), s.raises(GL_INVALID_OPERATION);
            s.NewList(1, GL_FLAT), s.raises(GL_INVALID_ENUM), s.NewList(1, GL_COMPILE), arrow(s),
                s.NewList(2, GL_COMPILE), s.raises(GL_INVALID_OPERATION);
            s.EndList(), s.CallList(2), s.Translatef(0.2, 0.3, 0), s.CallList(1);
          }),
      row("errors.call_lists", "5.4", "glCallLists of a negative number or another type calls nothing.",
          [](Script& s) {
            s.NewList(1, GL_COMPILE), tint(s, 0), patch(s, 0.6, 0.6, 0.2), s.EndList();
            s.CallLists(-1, GL_UNSIGNED_BYTE, Memory{GL_UNSIGNED_BYTE, {1}}), s.raises(GL_INVALID_VALUE),
                s.CallLists(1, GL_DOUBLE, Memory{GL_DOUBLE, {1}}), s.raises(GL_INVALID_ENUM);
            s.DeleteLists(1, -1), s.raises(GL_INVALID_VALUE), arrow(s);
          }),
      row("errors.in_list", "5.4", "An error of a command in a list comes when the list is called.",
          [](Script& s) {
            s.NewList(1, GL_COMPILE), s.MatrixMode(GL_LIGHTING), arrow(s), s.EndList(), s.CallList(1),
                s.raises(GL_INVALID_ENUM);
            s.NewList(2, GL_COMPILE), arrow(s), s.EndList(), s.CallList(2);
          }),
  };
}

} // namespace softgl::suite
