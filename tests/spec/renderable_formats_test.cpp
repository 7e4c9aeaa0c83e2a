// Formats that can be drawn to (GL_ARB_framebuffer_object, 4.4.4), clamping (GL_ARB_color_buffer_float), sRGB
// (GL_EXT_framebuffer_sRGB), and where softgl differs from OSMesa there.
#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>
#include <vector>

#include "spec/refused_calls.h"
#include "spec/state_snapshot.h"
#include "spec/texture_target.h"

namespace softgl::test {
namespace {

constexpr GLint kFormats[] = {GL_RGBA,
                              GL_RGBA2,
                              GL_RGBA4,
                              GL_RGB5_A1,
                              GL_RGBA8,
                              GL_RGB10_A2,
                              GL_RGBA12,
                              GL_RGBA16,
                              GL_RGB,
                              GL_R3_G3_B2,
                              GL_RGB4,
                              GL_RGB5,
                              GL_RGB565,
                              GL_RGB8,
                              GL_RGB10,
                              GL_RGB12,
                              GL_RGB16,
                              GL_RED,
                              GL_R8,
                              GL_R16,
                              GL_RG,
                              GL_RG8,
                              GL_RG16,
                              GL_ALPHA,
                              GL_ALPHA8,
                              GL_ALPHA16,
                              GL_LUMINANCE,
                              GL_LUMINANCE8,
                              GL_LUMINANCE16,
                              GL_LUMINANCE_ALPHA,
                              GL_INTENSITY,
                              GL_INTENSITY16,
                              GL_R16F,
                              GL_RG16F,
                              GL_RGB16F,
                              GL_RGBA16F,
                              GL_R32F,
                              GL_RG32F,
                              GL_RGB32F,
                              GL_RGBA32F,
                              GL_ALPHA16F_ARB,
                              GL_ALPHA32F_ARB,
                              GL_LUMINANCE16F_ARB,
                              GL_INTENSITY32F_ARB,
                              GL_LUMINANCE_ALPHA32F_ARB,
                              GL_R11F_G11F_B10F,
                              GL_SRGB8,
                              GL_SRGB8_ALPHA8,
                              GL_SRGB,
                              GL_SRGB_ALPHA,
                              GL_SLUMINANCE8,
                              GL_R8_SNORM,
                              GL_RG16_SNORM,
                              GL_RGBA8_SNORM,
                              GL_ALPHA8_SNORM,
                              GL_LUMINANCE8_SNORM,
                              GL_INTENSITY16_SNORM,
                              GL_RGB9_E5};

void attach_renderbuffer(const Gl& gl, GLint format) {
  GLuint renderbuffer = 0;
  gl.GenRenderbuffers(1, &renderbuffer);
  gl.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
  gl.RenderbufferStorage(GL_RENDERBUFFER, GLenum(format), 8, 8);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer);
}

/// What the framebuffer that is bound says of itself.
std::vector<GLint> answers(const Gl& gl) {
  std::vector<GLint> all = {GLint(gl.CheckFramebufferStatus(GL_FRAMEBUFFER))};
  for (const GLenum what :
       {GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE, GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE,
        GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE, GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE,
        GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING}) {
    GLint v = -1;
    gl.GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, what, &v);
    all.push_back(v);
  }
  for (const GLenum what :
       {GL_RED_BITS, GL_GREEN_BITS, GL_BLUE_BITS, GL_ALPHA_BITS, GL_FRAMEBUFFER_SRGB_CAPABLE_EXT}) {
    GLint v = 0;
    if (all[0] == GL_FRAMEBUFFER_COMPLETE) gl.GetIntegerv(what, &v);
    all.push_back(v);
  }
  return all;
}

std::vector<float> pixel(const Gl& gl) {
  std::vector<float> rgba(4, -7.0f);
  gl.ReadPixels(3, 3, 1, 1, GL_RGBA, GL_FLOAT, rgba.data());
  return rgba;
}

std::vector<int> bytes(const Gl& gl) {
  uint8_t v[4] = {};
  gl.ReadPixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, v);
  return {v[0], v[1], v[2], v[3]};
}

} // namespace

TEST_CASE("The formats that can be drawn to are OSMesa's", "[spec][formats][framebuffers][osmesa]") {
  for (const GLint format : kFormats)
    for (const bool texture : {true, false}) {
      if (!texture && (format == GL_RGB9_E5)) continue; // below
      const auto ask = [&](const Gl& gl) {
        const CurrentContext current(gl);
        bound_framebuffer(gl);
        texture ? void(attach_texture(gl, format)) : attach_renderbuffer(gl, format);
        std::vector<GLint> all = answers(gl);
        all.push_back(GLint(gl.GetError()));
        return all;
      };
      CAPTURE(format, texture);
      CHECK(ask(softgl_library()) == ask(osmesa_library()));
    }
}

TEST_CASE("A renderbuffer cannot have a shared exponent", "[spec][formats][deviation]") {
  const auto error = [](const Gl& gl) {
    const CurrentContext current(gl);
    attach_renderbuffer(gl, GL_RGB9_E5);
    GLenum first = gl.GetError();
    return first;
  };
  CHECK(error(softgl_library()) == GL_INVALID_ENUM); // GL_EXT_texture_shared_exponent: not renderable
}

TEST_CASE("Faces of cube maps may have depths", "[spec][formats][textures][osmesa]") {
  const auto errors = [](const Gl& gl) {
    const CurrentContext current(gl);
    GLuint texture = 0;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, texture);
    std::vector<GLenum> all;
    for (const GLint format : {GL_DEPTH_COMPONENT24, GL_DEPTH24_STENCIL8}) {
      gl.CopyTexImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, 0, GLenum(format), 0, 0, 8, 8, 0);
      all.push_back(gl.GetError());
    }
    gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_DEPTH_COMPONENT, 8, 8, 0, GL_DEPTH_COMPONENT,
                  GL_FLOAT, nullptr);
    all.push_back(gl.GetError());
    gl.TexImage3D(GL_TEXTURE_3D, 0, GL_DEPTH_COMPONENT, 8, 8, 8, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    all.push_back(gl.GetError());
    return all;
  };
  CHECK(errors(softgl_library()) == errors(osmesa_library()));
}

TEST_CASE("Floats are drawn as they are, unless clamping is asked for", "[spec][formats][clamp]") {
  const Gl& gl = softgl_library();
  const CurrentContext current(gl);
  bound_framebuffer(gl);
  attach_texture(gl, GL_RGBA32F);
  gl.ClearColor(-2, 3, 0.5f, 7);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  CHECK(pixel(gl) == std::vector<float>{-2, 3, 0.5f, 7});
  fill(gl, -2, 3, 0.5f, 7); // vertex colors are clamped
  CHECK(pixel(gl) == std::vector<float>{0, 1, 0.5f, 1});
  gl.ClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
  fill(gl, -2, 3, 0.5f, 7);
  CHECK(pixel(gl) == std::vector<float>{-2, 3, 0.5f, 7});
  gl.ClampColor(GL_CLAMP_READ_COLOR, GL_TRUE);
  CHECK(pixel(gl) == std::vector<float>{0, 1, 0.5f, 1});
  gl.ClampColor(GL_CLAMP_READ_COLOR, GL_FIXED_ONLY);
  gl.ClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_TRUE);
  fill(gl, -2, 3, 0.5f, 7);
  CHECK(pixel(gl) == std::vector<float>{0, 1, 0.5f, 1});
  gl.ClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_FALSE);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  fill(gl, -2, 3, 0.5f, 7);
  CHECK(pixel(gl) == std::vector<float>{-2, 4, 1, 8});
  CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("Colors that are asked for are clamped by what is bound", "[spec][formats][clamp]") { // 6.1.2
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    INFO(gl->name);
    const CurrentContext current(*gl);
    const GLfloat color[4] = {7, -2, -0.25f, 0.75f};
    gl->TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color);
    gl->Fogfv(GL_FOG_COLOR, color);
    gl->AlphaFunc(GL_ALWAYS, color[0]);
    gl->BlendColor(color[0], color[1], color[2], color[3]);
    gl->ClearColor(color[0], color[1], color[2], color[3]);
    const auto reads = [&] {
      std::vector<float> v(24);
      gl->GetTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, &v[0]);
      gl->GetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, &v[4]);
      gl->GetFloatv(GL_FOG_COLOR, &v[8]);
      gl->GetFloatv(GL_BLEND_COLOR, &v[12]);
      gl->GetFloatv(GL_COLOR_CLEAR_VALUE, &v[16]);
      gl->GetFloatv(GL_ALPHA_TEST_REF, &v[20]);
      return v;
    };
    const auto expected = [](std::vector<float> four, float reference) {
      std::vector<float> v;
      for (int i = 0; i < 5; ++i) v.insert(v.end(), four.begin(), four.end());
      v.insert(v.end(), {reference, 0, 0, 0});
      return v;
    };
    const auto given = expected({7, -2, -0.25f, 0.75f}, 7), clamped = expected({1, 0, 0, 0.75f}, 1);
    gl->TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, color);
    CHECK(reads() == clamped);
    bound_framebuffer(*gl);
    attach_texture(*gl, GL_RGBA16F);
    gl->TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, color);
    CHECK(reads() == given); // nothing has been drawn yet
    gl->ClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_TRUE);
    CHECK(reads() == clamped);
    gl->ClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_FALSE);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    CHECK(reads() == given);
    // So is the color of the raster position, by its own switch.
    bound_framebuffer(*gl);
    attach_texture(*gl, GL_RGBA16F);
    gl->ClampColor(GL_CLAMP_VERTEX_COLOR, GL_FIXED_ONLY);
    gl->Color4fv(color);
    gl->RasterPos2f(0, 0);
    std::vector<float> raster(4);
    gl->GetFloatv(GL_CURRENT_RASTER_COLOR, raster.data());
    CHECK(raster == std::vector<float>(color, color + 4));
    CHECK(gl->GetError() == GL_NO_ERROR);
  }
}

TEST_CASE("Clamping has three switches", "[spec][formats][clamp][errors]") {
  const Gl& gl = softgl_library();
  const CurrentContext current(gl);
  const auto get = [&](GLenum what) {
    GLint v = -1;
    gl.GetIntegerv(what, &v);
    return v;
  };
  CHECK(get(GL_CLAMP_VERTEX_COLOR) == GL_TRUE);
  CHECK(get(GL_CLAMP_FRAGMENT_COLOR) == GL_FIXED_ONLY);
  CHECK(get(GL_CLAMP_READ_COLOR) == GL_FIXED_ONLY);
  gl.ClampColor(GL_CLAMP_READ_COLOR, 2);
  CHECK(gl.GetError() == GL_INVALID_ENUM);
  gl.ClampColor(GL_CLAMP, GL_TRUE);
  CHECK(gl.GetError() == GL_INVALID_ENUM);
  gl.Begin(GL_POINTS);
  gl.ClampColor(GL_CLAMP_READ_COLOR, GL_TRUE);
  gl.End();
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
  CHECK(get(GL_CLAMP_READ_COLOR) == GL_FIXED_ONLY);
  gl.NewList(1, GL_COMPILE);
  gl.ClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
  gl.EndList();
  CHECK(get(GL_CLAMP_VERTEX_COLOR) == GL_TRUE);
  gl.CallList(1);
  CHECK(get(GL_CLAMP_VERTEX_COLOR) == GL_FALSE);
}

TEST_CASE("The switches of clamping are saved with what can be enabled",
          "[spec][formats][clamp][deviation]") {
  const auto restored = [](const Gl& gl, GLbitfield group) {
    const CurrentContext current(gl);
    gl.PushAttrib(group);
    for (const GLenum what : {GL_CLAMP_VERTEX_COLOR, GL_CLAMP_FRAGMENT_COLOR, GL_CLAMP_READ_COLOR})
      gl.ClampColor(what, GL_FALSE);
    gl.PopAttrib();
    std::vector<GLint> values;
    for (const GLenum what : {GL_CLAMP_VERTEX_COLOR, GL_CLAMP_FRAGMENT_COLOR, GL_CLAMP_READ_COLOR}) {
      GLint v = -1;
      gl.GetIntegerv(what, &v);
      values.push_back(v);
    }
    return values;
  };
  const std::vector<GLint> kept = {GL_FALSE, GL_FALSE, GL_FALSE},
                           all = {GL_TRUE, GL_FIXED_ONLY, GL_FIXED_ONLY};
  for (const GLbitfield group :
       std::initializer_list<GLbitfield>{GL_COLOR_BUFFER_BIT, GL_LIGHTING_BIT, GL_ALL_ATTRIB_BITS})
    CHECK(restored(softgl_library(), group) == restored(osmesa_library(), group));
  CHECK(restored(softgl_library(), GL_ENABLE_BIT) == all);
  CHECK(restored(osmesa_library(), GL_ENABLE_BIT) == kept);
}

TEST_CASE("Colors become sRGB where that is switched on", "[spec][formats][srgb][osmesa]") {
  const auto draw = [](const Gl& gl, bool srgb, float v, bool blend) {
    const CurrentContext current(gl);
    bound_framebuffer(gl);
    attach_texture(gl, GL_SRGB8_ALPHA8);
    if (srgb) gl.Enable(GL_FRAMEBUFFER_SRGB);
    fill(gl, 0.25f, 0.5f, 1 - v, 0.75f);
    if (blend) {
      gl.Enable(GL_BLEND);
      gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
      fill(gl, v, 0.1f, 0.9f, 0.3f);
    }
    return bytes(gl);
  };
  for (int i = 0; i <= 20; ++i)
    for (const bool srgb : {false, true})
      for (const bool blend : {false, true}) {
        const float v = float(i) / 20;
        const std::vector<int> ours = draw(softgl_library(), srgb, v, blend),
                               theirs = draw(osmesa_library(), srgb, v, blend);
        CAPTURE(i, srgb, blend, ours, theirs);
        CHECK(ours == theirs); // OSMesa's approximate roots are those of Intel's processors
      }
  // 0.25 of linear light is 137 of 255.
  CHECK(std::abs(draw(softgl_library(), true, 0, false)[0] - 137) <= 1);
  CHECK(draw(softgl_library(), false, 0, false)[0] == 64);
}

TEST_CASE("Samples of sRGB are averaged as linear colors where that is switched on",
          "[spec][formats][srgb][multisample][osmesa]") {
  const auto resolved = [](const Gl& gl, bool srgb) {
    const CurrentContext current(gl);
    GLuint framebuffers[2] = {}, renderbuffers[2] = {};
    gl.GenFramebuffers(2, framebuffers);
    gl.GenRenderbuffers(2, renderbuffers);
    for (int i = 0; i < 2; ++i) {
      gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffers[i]);
      gl.BindRenderbuffer(GL_RENDERBUFFER, renderbuffers[i]);
      gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, i == 0 ? 4 : 0, GL_SRGB8_ALPHA8, 8, 8);
      gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffers[i]);
    }
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffers[0]);
    gl.Viewport(0, 0, 8, 8);
    gl.ClearColor(0, 0, 0, 0);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Color4f(1, 0.5f, 0.25f, 1);
    gl.Begin(GL_TRIANGLES);
    gl.Vertex2f(-1, -1), gl.Vertex2f(1, -0.9f), gl.Vertex2f(-0.8f, 1);
    gl.End();
    if (srgb) gl.Enable(GL_FRAMEBUFFER_SRGB);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffers[1]);
    gl.BlitFramebuffer(0, 0, 8, 8, 0, 0, 8, 8, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffers[1]);
    std::vector<uint8_t> pixels(8 * 8 * 4);
    gl.ReadPixels(0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
  };
  for (const bool srgb : {false, true}) {
    const std::vector<uint8_t> ours = resolved(softgl_library(), srgb),
                               theirs = resolved(osmesa_library(), srgb);
    CAPTURE(srgb);
    CHECK(ours == theirs);
    // Of one sample in four, a linear 0.25 is 137 of 255.
    bool quarter = false;
    for (size_t i = 0; i < ours.size(); i += 4) quarter |= ours[i] == (srgb ? 137 : 64) && ours[i + 3] == 64;
    CHECK(quarter);
  }
}

TEST_CASE("A lone alpha is blended by the equation of alpha", "[spec][formats][deviation]") {
  const auto blended = [](const Gl& gl) {
    const CurrentContext current(gl);
    bound_framebuffer(gl);
    attach_texture(gl, GL_ALPHA8);
    fill(gl, 0, 0, 0, 0.6f);
    gl.Enable(GL_BLEND);
    gl.BlendEquationSeparate(GL_FUNC_ADD, GL_FUNC_REVERSE_SUBTRACT);
    gl.BlendFunc(GL_ONE, GL_ONE);
    fill(gl, 0, 0, 0, 0.2f);
    return bytes(gl)[3];
  };
  CHECK(blended(softgl_library()) == 102);
  CHECK(blended(osmesa_library()) == 204); // that of colors
}

TEST_CASE("Signed alpha is blended by its own factors", "[spec][formats][deviation]") {
  const auto blended = [](const Gl& gl) {
    const CurrentContext current(gl);
    bound_framebuffer(gl);
    attach_texture(gl, GL_RGBA8_SNORM);
    for (const GLenum what : {GL_CLAMP_VERTEX_COLOR, GL_CLAMP_FRAGMENT_COLOR, GL_CLAMP_READ_COLOR})
      gl.ClampColor(what, GL_FALSE);
    fill(gl, 0, 0, 0, -0.5f);
    gl.Enable(GL_BLEND);
    gl.BlendFuncSeparate(GL_ONE, GL_ZERO, GL_ONE_MINUS_DST_ALPHA, GL_ZERO);
    fill(gl, 0.5f, 0.5f, 0.5f, 0.4f);
    return pixel(gl)[3];
  };
  CHECK(std::fabs(blended(softgl_library()) - 0.6f) < 0.02f); // 0.4 * (1 - -0.5)
  CHECK(blended(osmesa_library()) < 0);                       // the factor does not fit
}

TEST_CASE("Blending with one and zero leaves nothing of what was there", "[spec][formats][deviation]") {
  const auto blended = [](const Gl& gl) {
    const CurrentContext current(gl);
    bound_framebuffer(gl);
    attach_texture(gl, GL_R16_SNORM);
    for (const GLenum what : {GL_CLAMP_VERTEX_COLOR, GL_CLAMP_FRAGMENT_COLOR, GL_CLAMP_READ_COLOR})
      gl.ClampColor(what, GL_FALSE);
    fill(gl, 0.5f, 0, 0, 1);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ZERO);
    fill(gl, -0.25f, 0, 0, 1);
    return std::lround(pixel(gl)[0] * 32767);
  };
  CHECK(blended(softgl_library()) == -8192);
  CHECK(blended(osmesa_library()) == -8193); // a mixture of the two, rounded
}

TEST_CASE("Colors of 16 bits are cut on their way into textures of fewer bits",
          "[spec][formats][textures][osmesa]") {
  const auto copied = [](const Gl& gl, GLenum format) {
    const CurrentContext current(gl);
    bound_framebuffer(gl);
    attach_texture(gl, GL_RGBA16);
    std::vector<GLushort> texels(8 * 8 * 4);
    for (size_t i = 0; i < texels.size(); ++i) texels[i] = GLushort(i * 40503);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_SHORT, texels.data());
    GLuint copy = 0;
    gl.GenTextures(1, &copy);
    gl.BindTexture(GL_TEXTURE_2D, copy);
    gl.CopyTexImage2D(GL_TEXTURE_2D, 0, format, 0, 0, 8, 8, 0);
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_SHORT, texels.data());
    return texels;
  };
  for (const GLenum format : {GL_RGB10_A2, GL_RGB10, GL_RGB5_A1, GL_RGB565, GL_R3_G3_B2, GL_RGBA4, GL_RGBA8,
                              GL_RGB16, GL_LUMINANCE8, GL_ALPHA8, GL_RGBA32F}) {
    CAPTURE(format);
    CHECK(copied(softgl_library(), format) == copied(osmesa_library(), format));
  }
}

TEST_CASE("Copied pixels obey the color mask and are clamped", "[spec][formats][pixels][deviation]") {
  const auto copied = [](const Gl& gl, bool masked, bool clamped) {
    const CurrentContext current(gl);
    bound_framebuffer(gl);
    attach_texture(gl, GL_RGBA32F);
    for (const GLenum what : {GL_CLAMP_VERTEX_COLOR, GL_CLAMP_READ_COLOR}) gl.ClampColor(what, GL_FALSE);
    gl.ClampColor(GL_CLAMP_FRAGMENT_COLOR, GLenum(clamped));
    gl.ClearColor(0, 0, 0, 0);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(0, 0, 2, 2);
    gl.ClearColor(3, 3, 3, 3);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Disable(GL_SCISSOR_TEST);
    if (masked) gl.ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
    gl.WindowPos2i(4, 4);
    gl.CopyPixels(0, 0, 1, 1, GL_COLOR);
    std::vector<float> rgba(4);
    gl.ReadPixels(4, 4, 1, 1, GL_RGBA, GL_FLOAT, rgba.data());
    return rgba;
  };
  using Rgba = std::vector<float>;
  CHECK(copied(softgl_library(), true, false) == Rgba{3, 0, 3, 3});
  CHECK(copied(softgl_library(), false, true) == Rgba{1, 1, 1, 1});
  CHECK(copied(osmesa_library(), true, true) == Rgba{3, 3, 3, 3});
}

TEST_CASE("Signed bytes less than -1 become the lowest one", "[spec][formats][osmesa]") {
  const auto drawn = [](const Gl& gl, bool blend, float v) {
    const CurrentContext current(gl);
    bound_framebuffer(gl);
    const GLuint texture = attach_texture(gl, GL_RGBA8_SNORM);
    for (const GLenum what : {GL_CLAMP_VERTEX_COLOR, GL_CLAMP_FRAGMENT_COLOR, GL_CLAMP_READ_COLOR})
      gl.ClampColor(what, GL_FALSE);
    fill(gl, 0.5f, 0.25f, -1, 1);
    if (blend) gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    fill(gl, v, 0, v, 0.25f);
    std::vector<GLbyte> texels(8 * 8 * 4);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_BYTE, texels.data());
    return texels;
  };
  for (const bool blend : {false, true})
    for (const float v : {-1.0f, -1.003f, -1.01f, -40.0f, -1e30f, 1e30f}) {
      CAPTURE(blend, v);
      CHECK(drawn(softgl_library(), blend, v) == drawn(osmesa_library(), blend, v));
    }
  CHECK(drawn(softgl_library(), false, -40)[0] == -128);
}

TEST_CASE("Copies of sRGB stay what they are", "[spec][formats][srgb][deviation]") {
  const auto copied = [](const Gl& gl) {
    const CurrentContext current(gl);
    bound_framebuffer(gl);
    attach_texture(gl, GL_SRGB8_ALPHA8);
    fill(gl, 0.5f, 0.5f, 0.5f, 1);
    gl.WindowPos2i(2, 2);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ZERO);
    gl.CopyPixels(0, 0, 2, 2, GL_COLOR);
    return bytes(gl)[0];
  };
  CHECK(copied(softgl_library()) == 128);
  CHECK(copied(osmesa_library()) < 100); // read as sRGB, stored as it is
}

} // namespace softgl::test
