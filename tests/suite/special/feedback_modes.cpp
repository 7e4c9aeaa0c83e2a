// Feedback behind culling and the modes of polygons (5.3, 3.5.1, 3.5.4).
#include "special/chapter.h"
#include "special/scenes.h"

namespace softgl::suite {
namespace {

Test fed_polygon_row(const char* name, const char* sentence, std::function<void(Script&)> body,
                     const char* section = "5.3") {
  return special_test(std::string("feedback.") + name, section, sentence, std::move(body));
}

// A front face on the left, a back face on the right, a line and a point.
void faces(Script& s) {
  s.Begin(GL_TRIANGLES), corner(s, 0, 10.2, 12.3), corner(s, 1, 44.1, 15.2), corner(s, 2, 28.4, 80.3),
      corner(s, 3, 52.2, 12.3), corner(s, 4, 68.4, 80.3), corner(s, 5, 86.1, 15.2), s.End();
  s.Begin(GL_LINES), corner(s, 6, 20.2, 90.3), corner(s, 1, 70.6, 85.2), s.End(), dot(s, 49.2, 47.3);
}

Test culled(const char* name, const char* sentence, GLenum face, GLenum front = GL_CCW) {
  return fed_polygon_row(
      name, sentence,
      [=](Script& s) {
        s.CullFace(face), s.FrontFace(front), s.Enable(GL_CULL_FACE),
            fed_back(s, GL_3D_COLOR, [&] { faces(s); });
      },
      "5.3, 3.5.1");
}

Test mode_row(const char* name, const char* sentence, std::function<void(Script&)> state) {
  return fed_polygon_row(
      name, sentence,
      [=](Script& s) {
        state(s), fed_back(
                      s, GL_3D_COLOR, [&] { faces(s); }, FedOrder::AnyOrder);
      },
      "5.3, 3.5.4");
}

void flagged_quad(Script& s) {
  s.Begin(GL_QUADS);
  for (int i = 0; i < 4; i++)
    s.EdgeFlag(int(i != 1)),
        corner(s, i, i == 1 || i == 2 ? 80.2 - i : 14.3 + i, i > 1 ? 75.4 + i : 20.1 + 2 * i);
  s.End();
}

Test offset_row(const char* name, GLenum mode, GLenum offset) {
  return fed_polygon_row(name, "The offset of polygons is not added to the depths.", [=](Script& s) {
    s.PolygonMode(GL_FRONT_AND_BACK, mode), s.PolygonOffset(4, 1000), s.Enable(offset);
    fed_back(
        s, GL_3D, [&] { shape(s, 40, 40), slope(s); }, FedOrder::AnyOrder);
  });
}

} // namespace

std::vector<Test> special_feedback_mode_tests() {
  return {
      culled("cull_back", "Back faces that are culled are not given.", GL_BACK),
      culled("cull_front", "Front faces that are culled are not given.", GL_FRONT),
      culled("cull_clockwise", "Which face is culled depends on glFrontFace.", GL_BACK, GL_CW),
      culled("cull_both", "If both faces are culled, points and lines are left.", GL_FRONT_AND_BACK),
      mode_row("mode_line", "A polygon that is drawn as lines is given as lines.",
               [](Script& s) { s.PolygonMode(GL_FRONT_AND_BACK, GL_LINE); }),
      mode_row("mode_point", "A polygon that is drawn as points is given as points.",
               [](Script& s) { s.PolygonMode(GL_FRONT_AND_BACK, GL_POINT); }),
      mode_row("mode_of_faces", "Each face has its own mode.",
               [](Script& s) { s.PolygonMode(GL_FRONT, GL_LINE), s.PolygonMode(GL_BACK, GL_POINT); }),
      mode_row("mode_of_back", "The other face stays a polygon.",
               [](Script& s) { s.PolygonMode(GL_BACK, GL_LINE); }),
      mode_row("mode_and_culling", "A face that is culled gives no lines.",
               [](Script& s) {
                 s.PolygonMode(GL_FRONT_AND_BACK, GL_LINE), s.CullFace(GL_FRONT), s.Enable(GL_CULL_FACE);
               }),
      fed_polygon_row(
          "edge_flags_lines", "Edges that are no boundaries are not given.",
          [](Script& s) {
            s.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
            fed_back(
                s, GL_3D_COLOR, [&] { flagged_quad(s); }, FedOrder::AnyOrder);
          },
          "5.3, 2.6.2, 3.5.4"),
      fed_polygon_row(
          "edge_flags_points", "Corners where no boundary begins are not given as points.",
          [](Script& s) {
            s.PolygonMode(GL_FRONT_AND_BACK, GL_POINT);
            fed_back(
                s, GL_3D_COLOR, [&] { flagged_quad(s); }, FedOrder::AnyOrder);
          },
          "5.3, 2.6.2, 3.5.4"),
      fed_polygon_row(
          "cut_edges", "The edge along a cut is given as a line.",
          [](Script& s) {
            s.PolygonMode(GL_FRONT_AND_BACK, GL_LINE), s.ClipPlane(GL_CLIP_PLANE0, V{-1, -0.3, 0, 0.2}),
                s.Enable(GL_CLIP_PLANE0);
            fed_back(
                s, GL_3D_COLOR, [&] { shape(s, 58, 41); }, FedOrder::AnyOrder);
          },
          "5.3, 2.12, 3.5.4"),
      fed_polygon_row(
          "quad_edges", "The lines of a quadrilateral are its four edges.",
          [](Script& s) {
            s.PolygonMode(GL_FRONT_AND_BACK, GL_LINE),
                fed_back(
                    s, GL_2D, [&] { box(s, 12, 20, 71, 66); }, FedOrder::AnyOrder);
          },
          "5.3, 3.5.4"),
      offset_row("offset_fill", GL_FILL, GL_POLYGON_OFFSET_FILL),
      offset_row("offset_line", GL_LINE, GL_POLYGON_OFFSET_LINE),
      offset_row("offset_point", GL_POINT, GL_POLYGON_OFFSET_POINT),
  };
}

} // namespace softgl::suite
