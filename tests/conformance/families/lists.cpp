// Display lists: nested, with state and matrices, with attributes that the list does not set.
#include "conformance/families/common.h"

namespace softgl::test {

namespace {

// `execute`: without what GL_COMPILE_AND_EXECUTE does differently in OSMesa, see reference/DEVIATIONS.md.
void list_content(Stage& s, GLuint call_below, bool partial_attributes, bool execute, bool partial_scene) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  for (int i = r.integer(1, 4); i > 0; i--) {
    int what = r.integer(0, 9);
    if (execute && (what == 1 || what == 5)) what = 9;
    switch (what) {
    case 0: {
      const Float3 t{r.real(-0.3f, 0.3f), r.real(-0.3f, 0.3f), 0};
      gl.PushMatrix();
      gl.Translatef(t[0], t[1], t[2]);
      gl.Rotatef(r.real(-90, 90), 0, 0, 1);
      if (call_below && r.chance(70)) gl.CallList(GLuint(r.integer(1, int(call_below))));
      gl.PopMatrix();
      break;
    }
    case 1: gl.ShadeModel(r.chance(50) ? GL_FLAT : GL_SMOOTH); break;
    case 2: {
      const Float4 c = r.color();
      gl.Color4fv(c.data());
      break;
    }
    case 3:
      if (call_below) {
        const GLubyte names[3] = {GLubyte(r.integer(1, int(call_below))),
                                  GLubyte(r.integer(1, int(call_below))),
                                  GLubyte(r.integer(1, int(call_below)))};
        gl.CallLists(r.integer(0, 3), GL_UNSIGNED_BYTE, names);
      }
      break;
    case 4: {
      gl.PushAttrib(GL_CURRENT_BIT | GL_LIGHTING_BIT | GL_ENABLE_BIT);
      random_culling(s);
      break;
    }
    case 5: {
      const GLfloat diffuse[4] = {r.real(0, 1), r.real(0, 1), r.real(0, 1), 1};
      gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, diffuse);
      break;
    }
    default: {
      const GLenum mode = r.chance(20)
                              ? GLenum(r.pick({GL_LINES, GL_LINE_LOOP, GL_POINTS}))
                              : GLenum(r.pick({GL_TRIANGLES, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN,
                                               GL_QUADS, GL_QUAD_STRIP, GL_POLYGON}));
      if (execute && mode == GL_QUADS) break;
      if (partial_scene && mode == GL_LINE_LOOP)
        break; // spoils a later primitive whose attributes come late, also of a list that calls this one
      const int count = vertices_of(mode, r.integer(1, 6));
      const std::vector<Float4> p = random_positions(s, mode, count, Spread::View, false);
      // The first vertices take the color and normal that are current when the list is called.
      int late_color = r.integer(0, count), late_normal = r.integer(0, count);
      // Behind another primitive OSMesa loses the one triangle that a fan had before an attribute came:
      // reference/DEVIATIONS.md.
      const auto one_triangle = [&](int k) { return mode == GL_TRIANGLE_FAN && k == 3; };
      if (one_triangle(late_color)) late_color++;
      if (one_triangle(late_normal)) late_normal++;
      // In these modes OSMesa loses vertices when an attribute comes late, or changes their order:
      // reference/DEVIATIONS.md.
      const bool late = partial_attributes && mode != GL_LINE_LOOP && mode != GL_TRIANGLE_STRIP &&
                        mode != GL_QUADS && mode != GL_QUAD_STRIP;
      const int color_from = late ? late_color : 0, normal_from = late ? late_normal : 0;
      if (mode == GL_QUADS) gl.ShadeModel(GL_FLAT);
      gl.Begin(mode);
      for (int k = 0; k < count; k++) {
        if (k >= color_from) {
          const Float4 c = r.color();
          gl.Color4fv(c.data());
        }
        if (k >= normal_from) {
          const Float3 n = r.direction();
          gl.Normal3fv(n.data());
        }
        if (late && r.chance(3) && !one_triangle(k)) gl.Materialf(GL_FRONT, GL_SHININESS, 20);
        gl.Vertex3fv(p[size_t(k)].data());
      }
      gl.End();
    }
    }
  }
}

void draw_lists(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  random_canvas(s);
  random_projection(s);
  rigid_modelview(s);
  random_depth(s, 40);
  if (r.chance(50)) {
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    gl.Enable(GL_NORMALIZE);
    gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    const GLfloat specular[4] = {0.5f, 0.5f, 0.5f, 1};
    gl.Materialfv(GL_FRONT, GL_SPECULAR, specular);
    gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 9);
    if (r.chance(50)) gl.Enable(GL_COLOR_MATERIAL);
  }
  const bool partial = r.chance(60);
  const int lists = r.integer(1, 5);
  for (int i = 1; i <= lists; i++) {
    const bool execute = r.chance(20);
    gl.NewList(GLuint(i), execute ? GL_COMPILE_AND_EXECUTE : GL_COMPILE);
    list_content(s, execute ? 0 : GLuint(i - 1), partial && !execute, execute, partial);
    gl.EndList();
  }
  // A list may leave attribute groups pushed: calls are counted so that the stack cannot overflow.
  for (int i = r.integer(1, 4); i > 0; i--) {
    const Float4 c = r.color();
    const Float3 n = r.direction();
    gl.Color4fv(c.data());
    gl.Normal3fv(n.data());
    if (r.chance(30)) gl.Translatef(0.1f, -0.1f, 0.05f);
    gl.CallList(GLuint(r.integer(1, lists)));
  }
}

SceneRegistration lists{{"lists", draw_lists, true}};

} // namespace
} // namespace softgl::test
