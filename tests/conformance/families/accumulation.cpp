// The accumulation buffer: every operation, whole and in parts, between draws and clears.
#include "conformance/families/common.h"

namespace softgl::test {
namespace {

float random_value(Stage& s) {
  switch (s.random.integer(0, 9)) {
  case 0: return float(s.random.integer(-1, 1));
  case 1: return s.random.real(-3, 3); // beyond 1 numbers wrap around
  case 2:
  case 3: return 1.0f / float(s.random.integer(1, 16));
  case 4:
  case 5: return s.random.real(-1, 1);
  default: return s.random.real(0, 1);
  }
}

void random_clear_value(Stage& s) {
  float v[4];
  for (float& x : v) x = s.random.chance(30) ? float(s.random.integer(-1, 1)) : s.random.real(-1.1f, 1.1f);
  s.gl.ClearAccum(v[0], v[1], v[2], v[3]);
}

void clear(Stage& s) {
  if (s.random.chance(60)) random_clear_value(s);
  s.gl.Clear(s.random.pick({GLbitfield(GL_ACCUM_BUFFER_BIT), GLbitfield(GL_ACCUM_BUFFER_BIT),
                            GLbitfield(GL_ACCUM_BUFFER_BIT | GL_COLOR_BUFFER_BIT),
                            GLbitfield(GL_ACCUM_BUFFER_BIT | GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)}));
}

void random_mask(Stage& s) {
  bool mask[4];
  for (bool& m : mask) m = s.random.chance(60);
  s.gl.ColorMask(mask[0], mask[1], mask[2], mask[3]);
}

void accumulate(Stage& s) {
  const GLenum op = GLenum(s.random.pick({GL_ACCUM, GL_ACCUM, GL_ACCUM, GL_LOAD, GL_LOAD, GL_ADD, GL_MULT}));
  s.gl.Accum(op, random_value(s));
}

/// Makes the numbers visible.
void show(Stage& s) {
  if (s.random.chance(25)) random_mask(s);
  s.gl.Accum(GL_RETURN, s.random.chance(40) ? 1.0f : random_value(s));
  s.gl.ColorMask(1, 1, 1, 1);
}

void random_draw(Stage& s) {
  random_projection(s);
  random_modelview(s);
  random_depth(s, 40);
  s.gl.Disable(GL_BLEND), s.gl.Disable(GL_COLOR_LOGIC_OP);
  if (s.random.chance(30)) random_blending(s);
  PrimitiveOptions options;
  options.mode = random_filled_mode(s);
  random_primitive(s, options);
  s.gl.ColorMask(1, 1, 1, 1);
}

void step(Stage& s) {
  random_scissor(s, 25);
  switch (s.random.integer(0, 9)) {
  case 0: return clear(s);
  case 1:
  case 2: return show(s);
  case 3:
  case 4:
  case 5: return random_draw(s);
  default: return accumulate(s);
  }
}

void draw_accumulation(Stage& s) {
  const Gl& gl = s.gl;
  random_canvas(s);
  backdrop(s);
  gl.Clear(GL_ACCUM_BUFFER_BIT); // OSMesa finds in a new one what its memory held before
  for (int i = s.random.integer(4, 16); i > 0; i--) step(s);
  if (s.random.chance(20)) { // no vertices: where attributes grow, OSMesa's lists go astray
    const GLuint list = gl.GenLists(1);
    gl.NewList(list, s.random.chance(50) ? GLenum(GL_COMPILE) : GLenum(GL_COMPILE_AND_EXECUTE));
    gl.PushAttrib(GL_ACCUM_BUFFER_BIT | GL_SCISSOR_BIT);
    random_scissor(s, 25);
    clear(s);
    accumulate(s);
    gl.PopAttrib();
    gl.Clear(GL_ACCUM_BUFFER_BIT);
    show(s);
    gl.EndList();
    accumulate(s);
    gl.CallList(list);
    gl.DeleteLists(list, 1);
  }
  gl.Disable(GL_SCISSOR_TEST);
  random_draw(s);
  gl.Accum(GL_ACCUM, s.random.real(0.1f, 0.9f));
  if (s.random.chance(25)) random_mask(s);
  gl.Accum(GL_RETURN, s.random.real(0.3f, 1.5f));
  gl.ColorMask(1, 1, 1, 1);
}

SceneRegistration accumulation{
    {.name = "accumulation", .draw = draw_accumulation, .random = true, .accumulation = true}};

} // namespace
} // namespace softgl::test
