// Texture environments of GL_NV_texture_env_combine4, GL_ATI_texture_env_combine3 and
// GL_EXT_texture_env_dot3: sums of two products, zero and one as sources, products that are added to.
#include "conformance/families/common.h"
#include "conformance/families/environments.h"

namespace softgl::test {
namespace {

constexpr int kUnits = 3;

void some_texture(Stage& s) {
  Random& r = s.random;
  GLuint name = 0;
  s.gl.GenTextures(1, &name);
  s.gl.BindTexture(GL_TEXTURE_2D, name);
  std::vector<uint8_t> texels(8 * 8 * 4);
  for (uint8_t& t : texels) t = uint8_t(r.bits() >> 40);
  s.gl.TexImage2D(GL_TEXTURE_2D, 0, r.pick({GL_RGBA8, GL_RGBA8, GL_RGB8, GL_LUMINANCE8_ALPHA8}), 8, 8, 0,
                  GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  s.gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
}

void extended_environment(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, r.pick({GL_COMBINE, GL_COMBINE4_NV, GL_COMBINE4_NV}));
  for (GLenum part : {GL_COMBINE_RGB, GL_COMBINE_ALPHA})
    if (r.chance(80))
      gl.TexEnvi(GL_TEXTURE_ENV, part,
                 r.pick({GL_ADD, GL_ADD, GL_ADD_SIGNED, GL_MODULATE_ADD_ATI, GL_MODULATE_SIGNED_ADD_ATI,
                         GL_MODULATE_SUBTRACT_ATI, GL_REPLACE, GL_SUBTRACT}));
  if (r.chance(10)) gl.TexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, r.pick({GL_DOT3_RGB_EXT, GL_DOT3_RGBA_EXT}));
  const GLint third = r.pick({GL_ZERO, GL_TEXTURE, GL_CONSTANT, GL_PREVIOUS});
  gl.TexEnvi(GL_TEXTURE_ENV, GL_SOURCE3_RGB_NV, third);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_OPERAND3_RGB_NV,
             r.pick({GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA}));
  gl.TexEnvi(GL_TEXTURE_ENV, GL_SOURCE3_ALPHA_NV, r.pick({GL_ZERO, GL_TEXTURE, GL_CONSTANT, GL_PREVIOUS}));
  gl.TexEnvi(GL_TEXTURE_ENV, GL_OPERAND3_ALPHA_NV, r.pick({GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA}));
  for (GLenum source :
       {GL_SOURCE0_RGB, GL_SOURCE1_RGB, GL_SOURCE2_RGB, GL_SOURCE0_ALPHA, GL_SOURCE1_ALPHA, GL_SOURCE2_ALPHA})
    if (r.chance(15)) gl.TexEnvi(GL_TEXTURE_ENV, source, r.pick({GL_ZERO, GL_ONE}));
  for (GLenum scale : {GL_RGB_SCALE, GL_ALPHA_SCALE})
    if (r.chance(60)) gl.TexEnvf(GL_TEXTURE_ENV, scale, 1);
}

void draw_combine4(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (int u = 0; u < kUnits; ++u) {
    gl.ActiveTexture(GLenum(GL_TEXTURE0 + u));
    some_texture(s);
  }
  for (int cell = 0; cell < 6; ++cell) {
    const int units = r.integer(1, kUnits);
    for (int u = 0; u < kUnits; ++u) {
      gl.ActiveTexture(GLenum(GL_TEXTURE0 + u));
      u < units ? gl.Enable(GL_TEXTURE_2D) : gl.Disable(GL_TEXTURE_2D);
      random_environment(s, units, true);
      extended_environment(s);
    }
    gl.ActiveTexture(GL_TEXTURE0);
    const float x = float(cell % 3) * 0.66f - 1, y = float(cell / 3) - 1;
    gl.Begin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 4; ++i) {
      const Float4 color = r.color();
      gl.Color4fv(color.data());
      for (int u = 0; u < kUnits; ++u) {
        const Float2 t{r.real(-1, 2), r.real(-1, 2)};
        gl.MultiTexCoord2fv(GLenum(GL_TEXTURE0 + u), t.data());
      }
      gl.Vertex2f(x + (i & 1 ? 0.6f : 0), y + (i & 2 ? 0.9f : 0));
    }
    gl.End();
  }
}

SceneRegistration combine4{{.name = "combine4", .draw = draw_combine4, .random = true}};

} // namespace
} // namespace softgl::test
