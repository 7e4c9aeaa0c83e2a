// What extensions do to fragments: stencil tests of two faces, a blend equation for alpha, clamped depths,
// other distances of fog.
#include "conformance/families/common.h"

namespace softgl::test {
namespace {

GLenum random_stencil_operation(Stage& s) {
  return GLenum(s.random.pick(
      {GL_KEEP, GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP}));
}

/// glStencilFunc, glStencilOp and glStencilMask, or the forms that name a face.
void random_stencil_face(Stage& s, GLenum face) {
  const GLenum function = s.random.chance(40) ? GLenum(GL_ALWAYS) : random_compare(s);
  const GLint reference = s.random.integer(0, 3);
  const GLuint mask = s.random.chance(50) ? 255u : GLuint(s.random.integer(1, 3));
  const GLenum fail = random_stencil_operation(s), depth_fail = random_stencil_operation(s),
               pass = random_stencil_operation(s);
  const GLuint writes = s.random.chance(70) ? 255u : GLuint(s.random.integer(0, 7));
  if (face) {
    s.gl.StencilFuncSeparate(face, function, reference, mask);
    s.gl.StencilOpSeparate(face, fail, depth_fail, pass);
    s.gl.StencilMaskSeparate(face, writes);
  } else {
    s.gl.StencilFunc(function, reference, mask);
    s.gl.StencilOp(fail, depth_fail, pass);
    s.gl.StencilMask(writes);
  }
}

void random_stencil_faces(Stage& s) {
  const int way = s.random.integer(0, 3);
  if (way == 0) { // GL_EXT_stencil_two_side
    s.gl.Enable(GL_STENCIL_TEST_TWO_SIDE_EXT);
    s.gl.ActiveStencilFaceEXT(GL_BACK);
    random_stencil_face(s, 0);
    s.gl.ActiveStencilFaceEXT(GL_FRONT);
    random_stencil_face(s, 0);
    return;
  }
  s.gl.Disable(GL_STENCIL_TEST_TWO_SIDE_EXT);
  if (way == 1) { // GL_ATI_separate_stencil
    random_stencil_face(s, 0);
    const GLenum front = random_compare(s), back = random_compare(s);
    const GLint reference = s.random.integer(0, 3);
    s.gl.StencilFuncSeparateATI(front, back, reference, 3);
    return;
  }
  random_stencil_face(s, GL_FRONT);
  random_stencil_face(s, way == 2 ? GL_BACK : GL_FRONT_AND_BACK);
}

void draw_stencil_faces(Stage& s) {
  random_canvas(s);
  s.gl.ClearStencil(s.random.integer(0, 3));
  s.gl.Clear(GL_STENCIL_BUFFER_BIT);
  random_projection(s);
  s.gl.Enable(GL_STENCIL_TEST);
  for (int batch = s.random.integer(2, 5); batch > 0; batch--) {
    random_modelview(s);
    random_depth(s, 50);
    random_culling(s);
    random_stencil_faces(s);
    s.gl.FrontFace(s.random.chance(50) ? GL_CW : GL_CCW);
    if (s.random.chance(20)) random_alpha_test(s);
    PrimitiveOptions options;
    options.mode = s.random.chance(15) ? GLenum(s.random.pick({GL_LINES, GL_POINTS})) : random_filled_mode(s);
    s.gl.PointSize(5);
    random_primitive(s, options);
  }
}

void draw_blend_equations(Stage& s) {
  random_canvas(s);
  backdrop(s);
  for (int batch = s.random.integer(1, 3); batch > 0; batch--) {
    random_projection(s);
    random_modelview(s);
    random_blending(s);
    const auto equation = [&] {
      return GLenum(s.random.pick({GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX}));
    };
    const GLenum rgb = equation(), alpha = equation();
    s.gl.BlendEquationSeparate(rgb, alpha);
    PrimitiveOptions options;
    options.mode = random_filled_mode(s);
    random_primitive(s, options);
  }
}

void draw_depth_clamp(Stage& s) {
  random_canvas(s);
  random_projection(s);
  for (int batch = s.random.integer(2, 4); batch > 0; batch--) {
    random_modelview(s);
    random_depth(s, 90);
    if (s.random.chance(50)) {
      const float first = s.random.real(0, 1), last = s.random.real(0, 1);
      s.gl.DepthRange(double(first), double(last));
    }
    random_culling(s);
    if (s.random.chance(85))
      s.gl.Enable(GL_DEPTH_CLAMP);
    else
      s.gl.Disable(GL_DEPTH_CLAMP);
    PrimitiveOptions options;
    options.mode = s.random.chance(25) ? GLenum(s.random.pick({GL_LINES, GL_POINTS})) : random_filled_mode(s);
    options.spread = s.random.chance(50) ? Spread::Any : Spread::Beyond;
    s.gl.PointSize(4);
    random_primitive(s, options);
  }
}

void draw_fog_distance(Stage& s) {
  random_canvas(s);
  for (int batch = s.random.integer(1, 3); batch > 0; batch--) {
    random_projection(s);
    random_modelview(s);
    random_fog(s);
    s.gl.Fogi(GL_FOG_DISTANCE_MODE_NV,
              s.random.pick({GL_EYE_RADIAL_NV, GL_EYE_RADIAL_NV, GL_EYE_PLANE, GL_EYE_PLANE_ABSOLUTE_NV}));
    PrimitiveOptions options;
    options.mode = s.random.chance(15) ? GLenum(s.random.pick({GL_LINES, GL_POINTS})) : random_filled_mode(s);
    s.gl.PointSize(5);
    random_primitive(s, options);
  }
}

SceneRegistration stencil_faces{{"stencil_faces", draw_stencil_faces, true}},
    blend_equations{{"blend_equations", draw_blend_equations, true}},
    depth_clamp{{"depth_clamp", draw_depth_clamp, true}},
    fog_distance{{"fog_distance", draw_fog_distance, true}};

} // namespace
} // namespace softgl::test
