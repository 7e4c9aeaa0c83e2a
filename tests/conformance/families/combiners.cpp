// Chains of texture environments with color sum and fog behind them, drawn to floats: OSMesa's compiler
// decides over the whole chain in which order it adds, and of that 8 bits show next to nothing.
#include "conformance/families/common.h"
#include "conformance/families/environments.h"

namespace softgl::test {

void random_environment(Stage& s, int units, bool all_on) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  const Float4 c = r.color();
  gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, c.data());
  gl.TexEnvi(
      GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE,
      r.pick({GL_MODULATE, GL_MODULATE, GL_REPLACE, GL_DECAL, GL_BLEND, GL_ADD, GL_COMBINE, GL_COMBINE}));
  gl.TexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB,
             r.pick({GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT, GL_DOT3_RGB,
                     GL_DOT3_RGBA}));
  gl.TexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA,
             r.pick({GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT}));
  auto source = [&]() -> GLint {
    return units > 1 && r.chance(25) ? GLint(GL_TEXTURE0) + r.integer(0, units - 1)
                                     : r.pick({GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS});
  };
  for (int i = 0; i < 3; i++) {
    const GLint rgb = source();
    gl.TexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB + GLenum(i), rgb);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_ALPHA + GLenum(i), source());
    GLint operand = r.pick({GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA});
    // 1 minus the color of a unit that is off: reference/DEVIATIONS.md.
    if (!all_on && rgb >= GL_TEXTURE0 && rgb <= GL_TEXTURE7 && operand == GL_ONE_MINUS_SRC_COLOR)
      operand = GL_SRC_COLOR;
    gl.TexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_RGB + GLenum(i), operand);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_ALPHA + GLenum(i), r.pick({GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA}));
  }
  gl.TexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, r.pick({1.0f, 1.0f, 2.0f, 4.0f}));
  gl.TexEnvf(GL_TEXTURE_ENV, GL_ALPHA_SCALE, r.pick({1.0f, 1.0f, 2.0f, 4.0f}));
}

namespace {

constexpr int kUnits = 5;

void some_texture(Stage& s) {
  Random& r = s.random;
  GLuint name = 0;
  s.gl.GenTextures(1, &name);
  s.gl.BindTexture(GL_TEXTURE_2D, name);
  std::vector<uint8_t> texels(8 * 8 * 4);
  for (uint8_t& t : texels) t = uint8_t(r.bits() >> 40);
  const GLint format =
      r.pick({GL_RGBA8, GL_RGBA8, GL_RGB8, GL_LUMINANCE8, GL_LUMINANCE8_ALPHA8, GL_ALPHA8, GL_INTENSITY8});
  s.gl.TexImage2D(GL_TEXTURE_2D, 0, format, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  s.gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
}

/// Fewer scales than anything would choose: what is scaled is clamped, and the chain begins anew.
void chain(Stage& s) {
  Random& r = s.random;
  const int units = r.integer(1, kUnits);
  const bool gaps = r.chance(20);
  for (int u = 0; u < kUnits; ++u) {
    s.gl.ActiveTexture(GLenum(GL_TEXTURE0 + u));
    if (u < units && !(gaps && r.chance(40)))
      s.gl.Enable(GL_TEXTURE_2D);
    else
      s.gl.Disable(GL_TEXTURE_2D);
    random_environment(s, units, !gaps);
    for (GLenum scale : {GL_RGB_SCALE, GL_ALPHA_SCALE})
      if (r.chance(60)) s.gl.TexEnvf(GL_TEXTURE_ENV, scale, 1);
  }
  s.gl.ActiveTexture(GL_TEXTURE0);
}

void corner(Stage& s, float x, float y) {
  Random& r = s.random;
  const Float4 color = r.color(), secondary = r.color();
  s.gl.Color4fv(color.data());
  s.gl.SecondaryColor3fv(secondary.data());
  for (int u = 0; u < kUnits; ++u) {
    const Float2 t{r.real(-1, 2), r.real(-1, 2)};
    s.gl.MultiTexCoord2fv(GLenum(GL_TEXTURE0 + u), t.data());
  }
  s.gl.Vertex3f(x, y, r.real(-0.9f, 0.9f));
}

void draw_combiners(Stage& s) {
  s.gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (int u = 0; u < kUnits; ++u) {
    s.gl.ActiveTexture(GLenum(GL_TEXTURE0 + u));
    some_texture(s);
  }
  for (int cell = 0; cell < 6; ++cell) {
    chain(s);
    if (s.random.chance(40))
      s.gl.Enable(GL_COLOR_SUM);
    else
      s.gl.Disable(GL_COLOR_SUM);
    if (s.random.chance(30))
      random_fog(s);
    else
      s.gl.Disable(GL_FOG);
    const float x = float(cell % 3) * 0.66f - 1, y = float(cell / 3) - 1;
    s.gl.Begin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 4; ++i) corner(s, x + (i & 1 ? 0.6f : 0), y + (i & 2 ? 0.9f : 0));
    s.gl.End();
  }
}

SceneRegistration combiners{{.name = "combiners", .draw = draw_combiners, .random = true, .floats = true}};

} // namespace
} // namespace softgl::test
