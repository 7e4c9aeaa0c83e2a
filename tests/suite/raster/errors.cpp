// The errors of these commands: what raises one does nothing else (2.5).
#include "raster/chapter.h"
#include "raster/scenes.h"

namespace softgl::suite {
namespace {

// Lines of one color.
void spokes(Script& s) {
  tint(s, 1), s.Begin(GL_LINES);
  for (int i = 0; i < 5; i++)
    pixel_vertex(s, 30.3 + 2 * i, 90.2 - 8 * i), pixel_vertex(s, 90.3, 92.4 - 15 * i);
  s.End();
}

using Calls = std::vector<std::function<void(Script&)>>;

// Each call is wrong; what is drawn behind shows that it has changed nothing.
Test wrong(const char* name, const char* section, const char* sentence, GLenum error, Calls calls,
           Need need = {}, std::function<void(Script&)> before = {}) {
  return raster_test(
      std::string("error.") + name, section, sentence,
      [=](Script& s) {
        if (before) before(s);
        for (size_t i = 0; i < calls.size(); i++)
          s.Raises(error), calls[i](s), s.PaintError(int(8 * (i % 12)), int(8 * (i / 12)));
        s.PointSize(5), s.Enable(GL_DEPTH_TEST), slope(s), spokes(s);
      },
      need);
}

// Each call is wrong while the query 7 counts, which it does not disturb, nor the query 6.
Test wrong_while_counting(const char* name, const char* section, const char* sentence, GLenum error,
                          Calls calls, bool between_vertices = false) {
  return raster_test(
      std::string("error.") + name, section, sentence,
      [=](Script& s) {
        s.BeginQuery(GL_SAMPLES_PASSED, 6), tint(s, 1), box(s, 60, 70, 81, 90), s.EndQuery(GL_SAMPLES_PASSED);
        s.BeginQuery(GL_SAMPLES_PASSED, 7), tint(s, 0), box(s, 20, 20, 53, 61);
        for (const auto& call : calls) {
          if (between_vertices) s.Begin(GL_POINTS);
          call(s), s.raises(error);
          if (between_vertices) s.End();
        }
        box(s, 60, 20, 77, 43), s.EndQuery(GL_SAMPLES_PASSED), s.PaintQuery(7, 32, 0), s.PaintQuery(6, 0, 0);
      },
      kVersion15);
}

} // namespace

std::vector<Test> raster_error_tests() {
  return {
      wrong("point_size", "3.3", "A size of points that is not above 0 is GL_INVALID_VALUE.",
            GL_INVALID_VALUE, {[](Script& s) { s.PointSize(0); }, [](Script& s) { s.PointSize(-3); }}),
      wrong("point_parameter", "3.3", "A size of points below 0 is GL_INVALID_VALUE.", GL_INVALID_VALUE,
            {[](Script& s) { s.PointParameterf(GL_POINT_SIZE_MIN, -1); },
             [](Script& s) { s.PointParameterf(GL_POINT_SIZE_MAX, -0.5); },
             [](Script& s) { s.PointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, -2); }},
            kVersion14),
      wrong("line_width", "3.4", "A width of lines that is not above 0 is GL_INVALID_VALUE.",
            GL_INVALID_VALUE, {[](Script& s) { s.LineWidth(0); }, [](Script& s) { s.LineWidth(-1); }}),
      wrong("polygons", "2.5, 3.5", "An unknown face or mode is GL_INVALID_ENUM.", GL_INVALID_ENUM,
            {[](Script& s) { s.CullFace(GL_FLAT); }, [](Script& s) { s.FrontFace(GL_FLAT); },
             [](Script& s) { s.PolygonMode(GL_FRONT, GL_FLAT); },
             [](Script& s) { s.PolygonMode(GL_FLAT, GL_LINE); }}),
      wrong("scissor", "4.1.2", "A box of a size below 0 is GL_INVALID_VALUE.", GL_INVALID_VALUE,
            {[](Script& s) { s.Scissor(0, 0, -1, 5); }, [](Script& s) { s.Scissor(9, 9, 5, -1); }}, {},
            [](Script& s) { s.Enable(GL_SCISSOR_TEST); }),
      wrong("comparisons", "2.5, 4.1", "An unknown comparison is GL_INVALID_ENUM.", GL_INVALID_ENUM,
            {[](Script& s) { s.AlphaFunc(GL_FLAT, 0.5); }, [](Script& s) { s.DepthFunc(GL_FLAT); },
             [](Script& s) { s.StencilFunc(GL_FLAT, 3, 1); }}),
      wrong("stencil_operations", "2.5, 4.1.5", "An unknown operation is GL_INVALID_ENUM.", GL_INVALID_ENUM,
            {[](Script& s) { s.StencilOp(GL_FLAT, GL_KEEP, GL_KEEP); },
             [](Script& s) { s.StencilOp(GL_KEEP, GL_FLAT, GL_KEEP); },
             [](Script& s) { s.StencilOp(GL_KEEP, GL_KEEP, GL_FLAT); }}),
      wrong(
          "blend_factors", "2.5, 4.1.8", "An unknown factor is GL_INVALID_ENUM.", GL_INVALID_ENUM,
          {[](Script& s) { s.BlendFunc(GL_FLAT, GL_ONE); }, [](Script& s) { s.BlendFunc(GL_ONE, GL_FLAT); }}),
      wrong("blend_separate", "2.5, 4.1.8", "An unknown factor is GL_INVALID_ENUM.", GL_INVALID_ENUM,
            {[](Script& s) { s.BlendFuncSeparate(GL_FLAT, GL_ONE, GL_ONE, GL_ONE); },
             [](Script& s) { s.BlendFuncSeparate(GL_ONE, GL_FLAT, GL_ONE, GL_ONE); },
             [](Script& s) { s.BlendFuncSeparate(GL_ONE, GL_ONE, GL_FLAT, GL_ONE); },
             [](Script& s) { s.BlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_FLAT); }},
            kVersion14),
      wrong("blend_equation", "2.5, 4.1.8", "An unknown blend equation is GL_INVALID_ENUM.", GL_INVALID_ENUM,
            {[](Script& s) { s.BlendEquation(GL_FLAT); }}, kImaging),
      wrong("logic_operation", "2.5, 4.1.10", "An unknown logic operation is GL_INVALID_ENUM.",
            GL_INVALID_ENUM, {[](Script& s) { s.LogicOp(GL_FLAT); }}, {},
            [](Script& s) { s.Enable(GL_COLOR_LOGIC_OP); }),
      wrong("draw_buffer", "2.5, 4.2.1", "An unknown buffer is GL_INVALID_ENUM.", GL_INVALID_ENUM,
            {[](Script& s) { s.DrawBuffer(GL_FLAT); }}),
      wrong("draw_buffer_missing", "4.2.1", "A buffer that the window does not have is GL_INVALID_OPERATION.",
            GL_INVALID_OPERATION, {[](Script& s) { s.DrawBuffer(GL_AUX3); }}),
      wrong("clear", "4.2.3", "Bits that are no buffer's are GL_INVALID_VALUE.", GL_INVALID_VALUE,
            {[](Script& s) { s.Clear(GL_COLOR_BUFFER_BIT | 0x100000); }, [](Script& s) { s.Clear(1); }}),
      wrong("accumulation", "2.5, 4.2.4", "An unknown operation is GL_INVALID_ENUM.", GL_INVALID_ENUM,
            {[](Script& s) { s.Accum(GL_FLAT, 1); }}),
      wrong("fog", "2.5, 3.10", "An unknown parameter, mode or source of fog is GL_INVALID_ENUM.",
            GL_INVALID_ENUM,
            {[](Script& s) { s.Fogi(GL_FLAT, 1); }, [](Script& s) { s.Fogi(GL_FOG_MODE, GL_FLAT); }}, {},
            [](Script& s) { s.Enable(GL_FOG), s.Fogf(GL_FOG_DENSITY, 0.1); }),
      wrong("fog_density", "3.10", "A density below 0 is GL_INVALID_VALUE.", GL_INVALID_VALUE,
            {[](Script& s) { s.Fogf(GL_FOG_DENSITY, -0.25); }}, {},
            [](Script& s) { s.Enable(GL_FOG), s.Fogf(GL_FOG_DENSITY, 0.1); }),
      wrong("fog_source", "2.5, 3.10", "An unknown source of the distance is GL_INVALID_ENUM.",
            GL_INVALID_ENUM, {[](Script& s) { s.Fogi(GL_FOG_COORD_SRC, GL_FLAT); }}, kVersion14),
      wrong("query_begin", "4.1.7", "A query of the name 0 is GL_INVALID_OPERATION.", GL_INVALID_OPERATION,
            {[](Script& s) { s.BeginQuery(GL_SAMPLES_PASSED, 0); }}, kVersion15),
      wrong("query_end", "4.1.7", "The end of a query that was not begun is GL_INVALID_OPERATION.",
            GL_INVALID_OPERATION, {[](Script& s) { s.EndQuery(GL_SAMPLES_PASSED); }}, kVersion15),
      wrong("query_target", "2.5, 4.1.7", "An unknown target is GL_INVALID_ENUM.", GL_INVALID_ENUM,
            {[](Script& s) { s.BeginQuery(GL_FLAT, 4); }, [](Script& s) { s.EndQuery(GL_FLAT); }},
            kVersion15),
      raster_test(
          "error.query_inside", "4.1.7", "Between its begin and end another query is GL_INVALID_OPERATION.",
          [](Script& s) {
            s.BeginQuery(GL_SAMPLES_PASSED, 7), tint(s, 0), box(s, 20, 20, 53, 61),
                s.Raises(GL_INVALID_OPERATION), s.BeginQuery(GL_SAMPLES_PASSED, 8), s.PaintError(0, 0),
                s.Raises(GL_INVALID_OPERATION), s.BeginQuery(GL_SAMPLES_PASSED, 7), s.PaintError(8, 0),
                s.EndQuery(GL_SAMPLES_PASSED), s.PaintQuery(7, 32, 0);
          },
          kVersion15),
      wrong_while_counting("query_result_inside", "6.1.12",
                           "The count of a query that counts is GL_INVALID_OPERATION.", GL_INVALID_OPERATION,
                           {[](Script& s) { s.GetQueryObjectuiv(7, GL_QUERY_RESULT, V{0}); },
                            [](Script& s) { s.GetQueryObjectuiv(7, GL_QUERY_RESULT_AVAILABLE, V{0}); }}),
      wrong_while_counting("query_result_of_none", "6.1.12",
                           "The count of a name that is no query's is GL_INVALID_OPERATION.",
                           GL_INVALID_OPERATION,
                           {[](Script& s) { s.GetQueryObjectuiv(0, GL_QUERY_RESULT, V{0}); },
                            [](Script& s) { s.GetQueryObjectuiv(97, GL_QUERY_RESULT, V{0}); },
                            [](Script& s) { s.GetQueryObjectuiv(97, GL_QUERY_RESULT_AVAILABLE, V{0}); }}),
      wrong_while_counting("query_names", "2.5, 6.1.12", "An unknown target or name is GL_INVALID_ENUM.",
                           GL_INVALID_ENUM,
                           {[](Script& s) { s.GetQueryiv(GL_FLAT, GL_CURRENT_QUERY, V{0}); },
                            [](Script& s) { s.GetQueryiv(GL_SAMPLES_PASSED, GL_QUERY_RESULT, V{0}); },
                            [](Script& s) { s.GetQueryObjectuiv(6, GL_CURRENT_QUERY, V{0}); },
                            [](Script& s) { s.EndQuery(GL_FLAT); }}),
      wrong_while_counting(
          "query_deleted_inside", "4.1.7", "glDeleteQueries while a query counts is GL_INVALID_OPERATION.",
          GL_INVALID_OPERATION,
          {[](Script& s) { s.DeleteQueries(1, V{6}); }, [](Script& s) { s.DeleteQueries(1, V{7}); }}),
      wrong_while_counting(
          "query_inside_begin", "2.6.3, 4.1.7",
          "Commands of queries between glBegin and glEnd are GL_INVALID_OPERATION.", GL_INVALID_OPERATION,
          {[](Script& s) { s.EndQuery(GL_SAMPLES_PASSED); }, [](Script& s) { s.IsQuery(7, 0); },
           [](Script& s) { s.BeginQuery(GL_SAMPLES_PASSED, 9); }},
          true),
      raster_test(
          "error.query_delete", "2.5, 4.1.7", "A negative number of queries to delete is GL_INVALID_VALUE.",
          [](Script& s) {
            s.BeginQuery(GL_SAMPLES_PASSED, 7), tint(s, 0), box(s, 20, 20, 53, 61),
                s.EndQuery(GL_SAMPLES_PASSED);
            s.DeleteQueries(-1, V{7}), s.raises(GL_INVALID_VALUE), s.IsQuery(7, 1), s.PaintQuery(7, 32, 0);
          },
          kVersion15),
      raster_test("error.inside_begin", "2.6.3",
                  "Commands of fragments between glBegin and glEnd are GL_INVALID_OPERATION.",
                  [](Script& s) {
                    const Calls calls = {[](Script& t) { t.PointSize(9); },
                                         [](Script& t) { t.LineWidth(5); },
                                         [](Script& t) { t.LineStipple(3, 0); },
                                         [](Script& t) { t.CullFace(GL_FRONT); },
                                         [](Script& t) { t.PolygonMode(GL_FRONT_AND_BACK, GL_LINE); },
                                         [](Script& t) { t.PolygonOffset(3, 4); },
                                         [](Script& t) { t.Scissor(0, 0, 5, 5); },
                                         [](Script& t) { t.AlphaFunc(GL_NEVER, 0); },
                                         [](Script& t) { t.StencilFunc(GL_NEVER, 0, 0); },
                                         [](Script& t) { t.StencilOp(GL_ZERO, GL_ZERO, GL_ZERO); },
                                         [](Script& t) { t.StencilMask(0); },
                                         [](Script& t) { t.DepthFunc(GL_NEVER); },
                                         [](Script& t) { t.DepthMask(0); },
                                         [](Script& t) { t.BlendFunc(GL_ZERO, GL_ZERO); },
                                         [](Script& t) { t.LogicOp(GL_CLEAR); },
                                         [](Script& t) { t.ColorMask(0, 0, 0, 0); },
                                         [](Script& t) { t.DrawBuffer(GL_NONE); },
                                         [](Script& t) { t.Clear(GL_COLOR_BUFFER_BIT); },
                                         [](Script& t) { t.ClearColor(1, 1, 1, 1); },
                                         [](Script& t) { t.ClearDepth(0); },
                                         [](Script& t) { t.ClearStencil(3); },
                                         [](Script& t) { t.Fogf(GL_FOG_DENSITY, 3); }};
                    for (size_t i = 0; i < calls.size(); i++) {
                      tint(s, int(i)), s.Begin(GL_TRIANGLES), s.Raises(GL_INVALID_OPERATION), calls[i](s);
                      const double x = 6 + 15.0 * double(i % 6), y = 28 + 16.0 * double(i / 6);
                      pixel_vertex(s, x, y), pixel_vertex(s, x + 12.2, y + 1.3),
                          pixel_vertex(s, x + 3.3, y + 13.2);
                      s.End(), s.PaintError(int(8 * (i % 11)), int(8 * (i / 11)));
                    }
                    s.Clear(GL_STENCIL_BUFFER_BIT | GL_DEPTH_BUFFER_BIT), s.LineWidth(1), tint(s, 6),
                        box(s, 6, 22, 90, 25);
                  }),
  };
}

} // namespace softgl::suite
