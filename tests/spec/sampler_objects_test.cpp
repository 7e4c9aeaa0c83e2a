// Sampler objects (GL_ARB_sampler_objects).
#include <catch2/catch.hpp>

#include <vector>

#include "spec/refused_calls.h"
#include "spec/state_snapshot.h"

using namespace softgl::test;

namespace {

GLuint names[4];
const GLfloat kBorder[4] = {0.25f, 0.5f, 2, -1};
GLfloat floats[4];
GLint integers[4];
GLuint naturals[4];

const BadCall bad_calls[] = {
    BAD(INVALID_VALUE, GenSamplers(-1, names)),
    BAD(INVALID_VALUE, DeleteSamplers(-1, names)),
    BAD(INVALID_OPERATION, BindSampler(0, 77)),
    BAD(INVALID_OPERATION, SamplerParameteri(77, GL_TEXTURE_WRAP_S, GL_CLAMP)),
    BAD(INVALID_OPERATION, SamplerParameteri(0, GL_TEXTURE_WRAP_S, GL_CLAMP)),
    BAD(INVALID_OPERATION, SamplerParameterIiv(77, GL_TEXTURE_BORDER_COLOR, integers)),
    BAD(INVALID_OPERATION, SamplerParameterIuiv(77, GL_TEXTURE_BORDER_COLOR, naturals)),
    BAD(INVALID_OPERATION, GetSamplerParameterfv(77, GL_TEXTURE_WRAP_S, floats)),
    BAD(INVALID_OPERATION, GetSamplerParameteriv(77, GL_TEXTURE_WRAP_S, integers)),
    BAD(INVALID_OPERATION, GetSamplerParameterIiv(77, GL_TEXTURE_WRAP_S, integers)),
    BAD(INVALID_OPERATION, GetSamplerParameterIuiv(77, GL_TEXTURE_WRAP_S, naturals)),
    BAD(INVALID_ENUM, SamplerParameteri(1, GL_TEXTURE_BASE_LEVEL, 0)),
    BAD(INVALID_ENUM, SamplerParameteri(1, GL_TEXTURE_PRIORITY, 0)),
    BAD(INVALID_ENUM, SamplerParameteri(1, GL_TEXTURE_WRAP_S, GL_LINEAR)),
    BAD(INVALID_ENUM, SamplerParameteri(1, GL_TEXTURE_MIN_FILTER, GL_CLAMP)),
    BAD(INVALID_ENUM, SamplerParameteri(1, GL_TEXTURE_MAG_FILTER, GL_LINEAR_MIPMAP_LINEAR)),
    BAD(INVALID_ENUM, SamplerParameteri(1, GL_TEXTURE_COMPARE_MODE, GL_LESS)),
    BAD(INVALID_ENUM, SamplerParameteri(1, GL_TEXTURE_COMPARE_FUNC, GL_NONE)),
    BAD(INVALID_ENUM, SamplerParameterf(1, GL_TEXTURE_BORDER_COLOR, 1)),
    BAD(INVALID_VALUE, SamplerParameterf(1, GL_TEXTURE_MAX_ANISOTROPY_EXT, 0.5f)),
    BAD(INVALID_ENUM, GetSamplerParameterfv(1, GL_TEXTURE_PRIORITY, floats)),
    BAD(INVALID_ENUM, GetSamplerParameteriv(1, GL_TEXTURE_MAX_LEVEL, integers)),
    BAD(INVALID_ENUM, GetSamplerParameterIiv(1, GL_TEXTURE_MAX_LEVEL, integers)),
    BAD(INVALID_ENUM, GetSamplerParameterIuiv(1, GL_TEXTURE_MAX_LEVEL, naturals)),
    BAD(INVALID_ENUM, SamplerParameterIiv(1, GL_TEXTURE_MAX_LEVEL, integers)),
    BAD(INVALID_ENUM, SamplerParameterIuiv(1, GL_TEXTURE_MAX_LEVEL, naturals)),
};

GLint bound_sampler(const Gl& gl) {
  GLint name = -1;
  gl.GetIntegerv(GL_SAMPLER_BINDING, &name);
  return name;
}

GLint wrap_of(const Gl& gl, GLuint sampler) {
  GLint wrap = 0;
  gl.GetSamplerParameteriv(sampler, GL_TEXTURE_WRAP_S, &wrap);
  return wrap;
}

/// The red of the middle of a square with the texture of `target`.
int drawn_red(const Gl& gl, GLenum target) {
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Enable(target);
  gl.Begin(GL_QUADS);
  for (int i : {0, 1, 3, 2}) {
    gl.TexCoord2f(2.25f, 0.5f); // beyond the image
    gl.Vertex2f(float(i % 2 * 2 - 1), float(i / 2 * 2 - 1));
  }
  gl.End();
  gl.Disable(target);
  GLubyte pixel[4] = {};
  gl.ReadPixels(32, 32, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  return pixel[0];
}

void make_texture(const Gl& gl, GLenum target) {
  const GLubyte texels[4] = {10, 20, 30, 40};
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(target, 0, GL_LUMINANCE8, 2, 2, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels);
  gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
}

} // namespace

REFUSAL_TEST_CASE("Sampler objects refuse what is wrong in one argument", "[spec][samplers]") {
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    CurrentContext context(*gl);
    gl->GenSamplers(1, names);
    expect_refused(*gl, bad_calls);
  }
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const BadCall unit[] = {BAD(INVALID_VALUE, BindSampler(8, 0))}; // OSMesa has more units, for shaders
  expect_refused(gl, unit);
}

TEST_CASE("Sampler objects keep what they are given", "[spec][samplers]") {
  for (const Gl* lib : {&softgl_library(), &osmesa_library()}) {
    const Gl& gl = *lib;
    CurrentContext context(gl);
    GLuint sampler = 0;
    gl.GenSamplers(1, &sampler);
    CHECK(gl.IsSampler(sampler)); // at once
    CHECK(!gl.IsSampler(0));
    gl.SamplerParameterfv(sampler, GL_TEXTURE_BORDER_COLOR, kBorder);
    gl.GetSamplerParameterfv(sampler, GL_TEXTURE_BORDER_COLOR, floats);
    CHECK((floats[0] == 0.25f && floats[1] == 0.5f));
    const GLint whole[4] = {-5, 6, 7, 0x40000000}, least = GL_CLAMP;
    gl.SamplerParameterIiv(sampler, GL_TEXTURE_BORDER_COLOR, whole);
    gl.GetSamplerParameterIiv(sampler, GL_TEXTURE_BORDER_COLOR, integers);
    CHECK((integers[0] == -5 && integers[1] == 6 && integers[3] == 0x40000000));
    const GLuint large[4] = {0xfffffff0u, 1, 2, 3};
    gl.SamplerParameterIuiv(sampler, GL_TEXTURE_BORDER_COLOR, large);
    gl.GetSamplerParameterIuiv(sampler, GL_TEXTURE_BORDER_COLOR, naturals);
    CHECK((naturals[0] == 0xfffffff0u && naturals[3] == 3));
    const GLint scaled[4] = {0x7fffffff, 0, 0x7fffffff, 0};
    gl.SamplerParameteriv(sampler, GL_TEXTURE_BORDER_COLOR, scaled);
    gl.GetSamplerParameterfv(sampler, GL_TEXTURE_BORDER_COLOR, floats);
    CHECK((floats[0] == 1 && floats[1] > -1e-6f && floats[1] < 1e-6f));
    gl.SamplerParameterIiv(sampler, GL_TEXTURE_WRAP_S, &least);
    CHECK(wrap_of(gl, sampler) == GL_CLAMP);
    const GLuint mirrored = GL_MIRRORED_REPEAT;
    gl.SamplerParameterIuiv(sampler, GL_TEXTURE_WRAP_S, &mirrored);
    gl.GetSamplerParameterIuiv(sampler, GL_TEXTURE_WRAP_S, naturals);
    CHECK(naturals[0] == GL_MIRRORED_REPEAT);
    gl.SamplerParameterf(sampler, GL_TEXTURE_MIN_LOD, -2.5f);
    gl.GetSamplerParameterfv(sampler, GL_TEXTURE_MIN_LOD, floats);
    CHECK(floats[0] == -2.5f);
    CHECK(gl.GetError() == GL_NO_ERROR);
    gl.DeleteSamplers(1, &sampler);
    CHECK(!gl.IsSampler(sampler));
  }
}

TEST_CASE("Parameters of sampler objects are rounded to integers", "[spec][samplers]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.GenSamplers(1, names);
  gl.SamplerParameterf(names[0], GL_TEXTURE_MIN_LOD, 10.75f);
  gl.GetSamplerParameteriv(names[0], GL_TEXTURE_MIN_LOD, integers);
  gl.GetSamplerParameterIiv(names[0], GL_TEXTURE_MIN_LOD, integers + 1);
  gl.GetSamplerParameterIuiv(names[0], GL_TEXTURE_MIN_LOD, naturals);
  CHECK((integers[0] == 11 && integers[1] == 11 && naturals[0] == 11));
}

TEST_CASE("A bound sampler object takes the texture's place until it is gone", "[spec][samplers]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  make_texture(gl, GL_TEXTURE_2D);
  GLuint sampler = 0;
  gl.GenSamplers(1, &sampler);
  gl.SamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.SamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, GL_NEAREST); // and it repeats
  CHECK(drawn_red(gl, GL_TEXTURE_2D) == 40);
  gl.PushAttrib(GL_ALL_ATTRIB_BITS);
  gl.BindSampler(0, sampler);
  gl.PopAttrib(); // neither the binding nor the parameters are popped
  CHECK(bound_sampler(gl) == GLint(sampler));
  CHECK(drawn_red(gl, GL_TEXTURE_2D) == 30);
  gl.SamplerParameteri(sampler, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  CHECK(drawn_red(gl, GL_TEXTURE_2D) == 0);
  gl.SamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER,
                       GL_LINEAR_MIPMAP_LINEAR); // there are no further levels
  CHECK(drawn_red(gl, GL_TEXTURE_2D) == 255);
  gl.DeleteSamplers(1, &sampler);
  CHECK(bound_sampler(gl) == 0);
  CHECK(drawn_red(gl, GL_TEXTURE_2D) == 40);
}

TEST_CASE("Wrap modes that rectangles do not have leave them incomplete", "[spec][samplers]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  make_texture(gl, GL_TEXTURE_RECTANGLE);
  GLuint sampler = 0;
  gl.GenSamplers(1, &sampler);
  gl.SamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.BindSampler(0, sampler); // repeats
  CHECK(drawn_red(gl, GL_TEXTURE_RECTANGLE) == 255);
  for (GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    gl.SamplerParameteri(sampler, axis, GL_CLAMP_TO_EDGE);
  CHECK(drawn_red(gl, GL_TEXTURE_RECTANGLE) == 20);
}

TEST_CASE("Sampler objects are bound and changed by lists, and made at once", "[spec][samplers]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  GLuint sampler = 0, later = 0;
  gl.GenSamplers(1, &sampler);
  gl.NewList(1, GL_COMPILE);
  gl.GenSamplers(1, &later);
  gl.BindSampler(0, sampler);
  const GLint border[4] = {1, 2, 3, 4}, wrap = GL_CLAMP;
  gl.SamplerParameteri(sampler, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.SamplerParameterIiv(sampler, GL_TEXTURE_BORDER_COLOR, border);
  gl.SamplerParameterIiv(sampler, GL_TEXTURE_WRAP_T, &wrap);
  gl.SamplerParameterIiv(sampler, GL_TEXTURE_PRIORITY, &wrap); // refused when the list is called
  gl.EndList();
  CHECK(gl.GetError() == GL_NO_ERROR);
  CHECK((gl.IsSampler(later) && bound_sampler(gl) == 0 && wrap_of(gl, sampler) == GL_REPEAT));
  gl.CallList(1);
  CHECK(gl.GetError() == GL_INVALID_ENUM);
  CHECK((bound_sampler(gl) == GLint(sampler) && wrap_of(gl, sampler) == GL_CLAMP_TO_EDGE));
  gl.GetSamplerParameterIiv(sampler, GL_TEXTURE_BORDER_COLOR, integers);
  CHECK((integers[0] == 1 && integers[3] == 4));
}

TEST_CASE("Contexts share sampler objects, and each has its bindings", "[spec][samplers]") {
  const Gl& gl = softgl_library();
  std::vector<GLubyte> buffer(64 * 64 * 4);
  void* const first = gl.OSMesaCreateContext(GL_RGBA, nullptr);
  void* const second = gl.OSMesaCreateContext(GL_RGBA, first);
  const auto use = [&](void* context) {
    REQUIRE(gl.OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, 64, 64));
  };
  use(first);
  GLuint sampler = 0;
  gl.GenSamplers(1, &sampler);
  gl.BindSampler(0, sampler);
  use(second);
  CHECK((gl.IsSampler(sampler) && bound_sampler(gl) == 0));
  gl.SamplerParameteri(sampler, GL_TEXTURE_WRAP_S, GL_CLAMP);
  gl.DeleteSamplers(1, &sampler);
  use(first);
  CHECK(!gl.IsSampler(sampler));
  CHECK(bound_sampler(gl) == GLint(sampler)); // until it is bound no longer
  gl.BindSampler(0, sampler);
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
  gl.OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  gl.OSMesaDestroyContext(second);
  gl.OSMesaDestroyContext(first);
}
