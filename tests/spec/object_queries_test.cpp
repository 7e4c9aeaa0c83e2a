// GL 1.5, tables 6.8, 6.11, 6.12 and 6.16 to 6.19: what is asked of objects by their own commands, in floats
// and in integers, is what OSMesa answers: initially, and after everything has been set.
#include <catch2/catch.hpp>
#include <sstream>

#include "spec/state_snapshot.h"
#include "support/random.h"

using namespace softgl::test;

namespace {

/// What a query writes, and its error; where it writes nothing stays "-".
template <class T, class Query> std::string answer(const Gl& gl, Query query) {
  T v[8];
  std::fill(v, v + 8, T(-77));
  query(v);
  std::ostringstream s;
  s.precision(9);
  for (T x : v) {
    if (x == T(-77))
      s << "- ";
    else
      s << x << ' ';
  }
  const GLenum error = gl.GetError();
  if (error) s << "error " << std::hex << error;
  return s.str();
}

struct Asked {
  const Gl& gl;
  StateSnapshot answers;
  template <class Float, class Integer> void operator()(const std::string& name, Float f, Integer i) {
    answers.emplace_back(name + " float", answer<GLfloat>(gl, f));
    answers.emplace_back(name + " int", answer<GLint>(gl, i));
  }
};

constexpr GLenum kTargets[] = {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP};
constexpr GLenum kImages[] = {GL_TEXTURE_1D,
                              GL_TEXTURE_2D,
                              GL_TEXTURE_3D,
                              GL_TEXTURE_CUBE_MAP_POSITIVE_X,
                              GL_TEXTURE_CUBE_MAP_NEGATIVE_Z,
                              GL_TEXTURE_CUBE_MAP,
                              GL_PROXY_TEXTURE_1D,
                              GL_PROXY_TEXTURE_2D,
                              GL_PROXY_TEXTURE_3D,
                              GL_PROXY_TEXTURE_CUBE_MAP};

void ask_textures(Asked& a) {
  const Gl& gl = a.gl;
  for (GLenum target : kTargets)
    for (GLenum p : {GL_TEXTURE_BORDER_COLOR, GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S,
                     GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R, GL_TEXTURE_PRIORITY, GL_TEXTURE_RESIDENT,
                     GL_TEXTURE_MIN_LOD, GL_TEXTURE_MAX_LOD, GL_TEXTURE_BASE_LEVEL, GL_TEXTURE_MAX_LEVEL,
                     GL_TEXTURE_LOD_BIAS, GL_DEPTH_TEXTURE_MODE, GL_TEXTURE_COMPARE_MODE,
                     GL_TEXTURE_COMPARE_FUNC, GL_GENERATE_MIPMAP, GL_TEXTURE_MAX_ANISOTROPY_EXT})
      a(
          "texture " + std::to_string(target) + " " + std::to_string(p),
          [&](GLfloat* v) { gl.GetTexParameterfv(target, p, v); },
          [&](GLint* v) { gl.GetTexParameteriv(target, p, v); });
  for (GLenum image : kImages)
    for (GLint level : {0, 1, 3, 11})
      for (GLenum p : {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_DEPTH, GL_TEXTURE_BORDER,
                       GL_TEXTURE_INTERNAL_FORMAT, GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE,
                       GL_TEXTURE_BLUE_SIZE, GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_LUMINANCE_SIZE,
                       GL_TEXTURE_INTENSITY_SIZE, GL_TEXTURE_DEPTH_SIZE, GL_TEXTURE_COMPRESSED}) {
        GLint width = 0;
        gl.GetTexLevelParameteriv(image, level, GL_TEXTURE_WIDTH, &width);
        gl.GetError();
        // 1 (table 6.17); OSMesa gives GL_RGBA, as later versions do.
        if (p == GL_TEXTURE_INTERNAL_FORMAT && width == 0) {
          for (int i = 0; i < 2; ++i) a.answers.emplace_back("not compared", "");
          continue;
        }
        a(
            "image " + std::to_string(image) + " level " + std::to_string(level) + " " + std::to_string(p),
            [&](GLfloat* v) { gl.GetTexLevelParameterfv(image, level, p, v); },
            [&](GLint* v) { gl.GetTexLevelParameteriv(image, level, p, v); });
      }
}

void ask_lighting(Asked& a) {
  const Gl& gl = a.gl;
  for (GLenum light : {GL_LIGHT0, GL_LIGHT1, GL_LIGHT7})
    for (GLenum p :
         {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_POSITION, GL_SPOT_DIRECTION, GL_SPOT_EXPONENT,
          GL_SPOT_CUTOFF, GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION, GL_QUADRATIC_ATTENUATION})
      a(
          "light " + std::to_string(light) + " " + std::to_string(p),
          [&](GLfloat* v) { gl.GetLightfv(light, p, v); }, [&](GLint* v) { gl.GetLightiv(light, p, v); });
  for (GLenum face : {GL_FRONT, GL_BACK})
    for (GLenum p : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS, GL_COLOR_INDEXES})
      a(
          "material " + std::to_string(face) + " " + std::to_string(p),
          [&](GLfloat* v) { gl.GetMaterialfv(face, p, v); }, [&](GLint* v) { gl.GetMaterialiv(face, p, v); });
  for (GLenum coordinate : {GL_S, GL_T, GL_R, GL_Q})
    for (GLenum p : {GL_TEXTURE_GEN_MODE, GL_OBJECT_PLANE, GL_EYE_PLANE})
      a(
          "generation " + std::to_string(coordinate) + " " + std::to_string(p),
          [&](GLfloat* v) { gl.GetTexGenfv(coordinate, p, v); },
          [&](GLint* v) { gl.GetTexGeniv(coordinate, p, v); });
  a(
      "environment color", [&](GLfloat* v) { gl.GetTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, v); },
      [&](GLint* v) { gl.GetTexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, v); });
}

void ask_buffers(Asked& a) {
  for (GLenum target : {GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER})
    for (GLenum p : {GL_BUFFER_SIZE, GL_BUFFER_USAGE, GL_BUFFER_ACCESS, GL_BUFFER_MAPPED})
      a.answers.emplace_back("buffer " + std::to_string(target) + " " + std::to_string(p),
                             answer<GLint>(a.gl, [&](GLint* v) { a.gl.GetBufferParameteriv(target, p, v); }));
}

StateSnapshot ask_all(const Gl& gl) {
  Asked a{gl, {}};
  ask_textures(a);
  ask_lighting(a);
  ask_buffers(a);
  return a.answers;
}

/// Vectors that are not colors get whole numbers: OSMesa cuts off fractions there (reference/DEVIATIONS.md).
void set_all(const Gl& gl, uint64_t seed) {
  Random r(seed);
  const auto color = [&] { return Float4{r.real(-1, 1), r.real(-1, 1), r.real(-1, 1), r.real(-1, 1)}; };
  const auto whole = [&] {
    return Float4{float(r.integer(-9, 9)), float(r.integer(-9, 9)), float(r.integer(-9, 9)),
                  float(r.integer(1, 9))};
  };
  static constexpr GLint kFormats[] = {1,
                                       2,
                                       3,
                                       4,
                                       GL_ALPHA4,
                                       GL_ALPHA16,
                                       GL_LUMINANCE8,
                                       GL_LUMINANCE12,
                                       GL_LUMINANCE6_ALPHA2,
                                       GL_INTENSITY4,
                                       GL_INTENSITY16,
                                       GL_R3_G3_B2,
                                       GL_RGB4,
                                       GL_RGB5,
                                       GL_RGB8,
                                       GL_RGB10,
                                       GL_RGB16,
                                       GL_RGBA2,
                                       GL_RGBA4,
                                       GL_RGB5_A1,
                                       GL_RGBA8,
                                       GL_RGB10_A2,
                                       GL_RGBA16};
  const auto format = [&] { return kFormats[r.integer(0, int(std::size(kFormats)) - 1)]; };
  for (GLenum target : kTargets) {
    const Float4 border = color();
    gl.TexParameterfv(target, GL_TEXTURE_BORDER_COLOR, border.data());
    for (GLenum p : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
      gl.TexParameteri(
          target, p, r.pick({GL_CLAMP, GL_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT}));
    gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER,
                     r.pick({GL_NEAREST, GL_LINEAR, GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_LINEAR}));
    gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, r.pick({GL_NEAREST, GL_LINEAR}));
    gl.TexParameterf(target, GL_TEXTURE_PRIORITY, r.real(-0.5f, 1.5f));
    gl.TexParameterf(target, GL_TEXTURE_MIN_LOD, float(r.integer(-5, 5)));
    gl.TexParameterf(target, GL_TEXTURE_MAX_LOD, float(r.integer(-5, 5)));
    gl.TexParameterf(target, GL_TEXTURE_LOD_BIAS, float(r.integer(-20, 20)));
    gl.TexParameterf(target, GL_TEXTURE_MAX_ANISOTROPY_EXT, float(r.integer(1, 20)) + 0.25f);
    gl.TexParameteri(target, GL_TEXTURE_BASE_LEVEL, r.integer(0, 3));
    gl.TexParameteri(target, GL_TEXTURE_MAX_LEVEL, r.integer(0, 2000));
    gl.TexParameteri(target, GL_DEPTH_TEXTURE_MODE, r.pick({GL_LUMINANCE, GL_INTENSITY, GL_ALPHA, GL_RED}));
    gl.TexParameteri(target, GL_TEXTURE_COMPARE_MODE, r.pick({GL_NONE, GL_COMPARE_R_TO_TEXTURE}));
    gl.TexParameteri(target, GL_TEXTURE_COMPARE_FUNC, GLint(GL_NEVER) + r.integer(0, 7));
    if (target != GL_TEXTURE_CUBE_MAP)
      gl.TexParameteri(target, GL_GENERATE_MIPMAP, r.integer(0, 1)); // only two faces have images
  }
  for (GLenum image : kImages)
    for (GLint level : {0, 1}) {
      if (image == GL_TEXTURE_CUBE_MAP) continue; // no image
      const int size = r.integer(1, 16), height = r.integer(1, 16), depth = r.integer(1, 8),
                border = r.integer(0, 1), f = format();
      if (image == GL_TEXTURE_1D || image == GL_PROXY_TEXTURE_1D)
        gl.TexImage1D(image, level, f, size + 2 * border, border, GL_RGBA, GL_FLOAT, nullptr);
      else if (image == GL_TEXTURE_3D || image == GL_PROXY_TEXTURE_3D)
        gl.TexImage3D(image, level, f, size, height, depth, 0, GL_RGBA, GL_FLOAT, nullptr);
      else if (image == GL_TEXTURE_2D || image == GL_PROXY_TEXTURE_2D)
        gl.TexImage2D(image, level, f, size + 2 * border, height + 2 * border, border, GL_RGBA, GL_FLOAT,
                      nullptr);
      else
        gl.TexImage2D(image, level, f, size, size, 0, GL_RGBA, GL_FLOAT, nullptr);
    }
  for (GLenum light : {GL_LIGHT0, GL_LIGHT1, GL_LIGHT7}) {
    for (GLenum p : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR}) {
      const Float4 c = color();
      gl.Lightfv(light, p, c.data());
    }
    const Float4 position = whole(), direction = whole();
    gl.Lightfv(light, GL_POSITION, position.data());
    gl.Lightfv(light, GL_SPOT_DIRECTION, direction.data());
    gl.Lightf(light, GL_SPOT_EXPONENT, float(r.integer(0, 128)));
    gl.Lightf(light, GL_SPOT_CUTOFF, r.chance(30) ? 180.0f : float(r.integer(0, 90)));
    for (GLenum p : {GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION, GL_QUADRATIC_ATTENUATION})
      gl.Lightf(light, p, float(r.integer(0, 9)));
  }
  for (GLenum p : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION}) {
    const Float4 front = color(), back = color();
    gl.Materialfv(GL_FRONT, p, front.data());
    gl.Materialfv(GL_BACK, p, back.data());
  }
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, float(r.integer(0, 128)));
  const Float4 indexes = whole(), environment = color();
  gl.Materialfv(GL_BACK, GL_COLOR_INDEXES, indexes.data());
  gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, environment.data());
  for (GLenum coordinate : {GL_S, GL_T, GL_R, GL_Q}) {
    const Float4 object = whole(), eye = whole();
    gl.TexGeni(coordinate, GL_TEXTURE_GEN_MODE, r.pick({GL_OBJECT_LINEAR, GL_EYE_LINEAR}));
    gl.TexGenfv(coordinate, GL_OBJECT_PLANE, object.data());
    gl.TexGenfv(coordinate, GL_EYE_PLANE, eye.data());
  }
  gl.BindBuffer(GL_ARRAY_BUFFER, 1);
  gl.BufferData(GL_ARRAY_BUFFER, r.chance(20) ? 0 : r.integer(1, 999), nullptr,
                GLenum(r.pick({GL_STREAM_DRAW, GL_STATIC_READ, GL_DYNAMIC_COPY, GL_DYNAMIC_DRAW})));
  if (r.chance(50))
    gl.MapBuffer(GL_ARRAY_BUFFER, GLenum(r.pick({GL_READ_ONLY, GL_WRITE_ONLY, GL_READ_WRITE})));
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, GLuint(r.integer(1, 2)));
}

} // namespace

TEST_CASE("objects answer every query as OSMesa's do", "[spec][state]") {
  for (uint64_t seed = 0; seed < 30; ++seed) {
    StateSnapshot answers[2];
    for (int i = 0; i < 2; ++i) {
      const Gl& gl = i ? osmesa_library() : softgl_library();
      CurrentContext context(gl);
      if (seed) set_all(gl, seed); // 0: initial values
      const GLenum error = gl.GetError();
      answers[i] = ask_all(gl);
      answers[i].emplace_back("error of commands", std::to_string(error));
    }
    INFO("seed " << seed << ": softgl | OSMesa");
    REQUIRE(compare_snapshots(answers[0], answers[1]) == "");
  }
}

TEST_CASE("the internal format of an image that does not exist is 1", "[spec][state]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  GLint format = 0;
  gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 3, GL_TEXTURE_INTERNAL_FORMAT, &format);
  CHECK(format == 1);
}

TEST_CASE("no texel shares an exponent", "[spec][textures]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  GLint integer = 77;
  GLfloat number = 77;
  gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_SHARED_SIZE, &integer);
  gl.GetTexLevelParameterfv(GL_TEXTURE_2D, 0, GL_TEXTURE_SHARED_SIZE, &number);
  CHECK(integer == 0);
  CHECK(number == 0);
  CHECK(gl.GetError() == GL_NO_ERROR);
}
