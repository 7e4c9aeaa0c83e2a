// Every form of the vertex attribute commands (GL 1.5, 2.7): the current values they leave are OSMesa's, bit
// for bit.
#include <catch2/catch.hpp>

#include <cstring>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "support/gl.h"

using namespace softgl::test;

namespace {

struct Values {
  GLdouble d[4];
  GLfloat f[4];
  GLint i[4];
  GLuint ui[4];
  GLshort s[4];
  GLushort us[4];
  GLbyte b[4];
  GLubyte ub[4];
  explicit Values(unsigned seed) {
    std::mt19937 random(seed);
    for (int k = 0; k < 4; ++k) {
      const unsigned r = random();
      d[k] = double(int(random())) / (1 << 28);
      f[k] = float(d[k]);
      i[k] = int(seed % 3 == 0 ? (r & 1 ? 0x80000000u : 0x7fffffffu) : r);
      ui[k] = r;
      s[k] = GLshort(r >> 3);
      us[k] = GLushort(r >> 5);
      b[k] = GLbyte(r >> 7);
      ub[k] = GLubyte(r >> 9);
    }
  }
};

std::vector<GLfloat> forms(const Gl& gl, unsigned seed) {
  const Values v(seed);
  const GLboolean on = GL_TRUE, off = GL_FALSE;
  std::vector<GLfloat> seen;
  const auto look = [&](GLenum pname) {
    GLfloat now[4] = {};
    gl.GetFloatv(pname, now);
    seen.insert(seen.end(), now, now + 4);
  };
  // OSMesa keeps components of an earlier longer form (reference/DEVIATIONS.md): start from what is missing
  // in short ones.
// clang-format off
#define ONE(call, pname) gl.Color4f(0, 0, 0, 1); gl.TexCoord4f(0, 0, 0, 1); gl.call; look(pname);
#define COLORS(letter, a) \
  ONE(Color3##letter(a[0], a[1], a[2]), GL_CURRENT_COLOR) ONE(Color4##letter##v(a), GL_CURRENT_COLOR) \
  ONE(Color3##letter##v(a), GL_CURRENT_COLOR) ONE(Color4##letter(a[0], a[1], a[2], a[3]), GL_CURRENT_COLOR) \
  ONE(SecondaryColor3##letter(a[0], a[1], a[2]), GL_CURRENT_SECONDARY_COLOR) \
  ONE(SecondaryColor3##letter##v(a), GL_CURRENT_SECONDARY_COLOR)
  COLORS(b, v.b) COLORS(ub, v.ub) COLORS(s, v.s) COLORS(us, v.us) COLORS(i, v.i) COLORS(ui, v.ui) COLORS(f, v.f) COLORS(d, v.d)
#define NORMALS(letter, a) ONE(Normal3##letter(a[0], a[1], a[2]), GL_CURRENT_NORMAL) ONE(Normal3##letter##v(a), GL_CURRENT_NORMAL)
  NORMALS(b, v.b) NORMALS(s, v.s) NORMALS(i, v.i) NORMALS(f, v.f) NORMALS(d, v.d)
#define COORDINATES(letter, a) \
  ONE(TexCoord4##letter(a[0], a[1], a[2], a[3]), GL_CURRENT_TEXTURE_COORDS) ONE(TexCoord1##letter(a[0]), GL_CURRENT_TEXTURE_COORDS) \
  ONE(TexCoord2##letter(a[0], a[1]), GL_CURRENT_TEXTURE_COORDS) ONE(TexCoord3##letter(a[0], a[1], a[2]), GL_CURRENT_TEXTURE_COORDS) \
  ONE(TexCoord1##letter##v(a), GL_CURRENT_TEXTURE_COORDS) ONE(TexCoord2##letter##v(a), GL_CURRENT_TEXTURE_COORDS) \
  ONE(TexCoord3##letter##v(a), GL_CURRENT_TEXTURE_COORDS) ONE(TexCoord4##letter##v(a), GL_CURRENT_TEXTURE_COORDS) \
  ONE(MultiTexCoord1##letter(GL_TEXTURE0, a[0]), GL_CURRENT_TEXTURE_COORDS) \
  ONE(MultiTexCoord2##letter(GL_TEXTURE0, a[0], a[1]), GL_CURRENT_TEXTURE_COORDS) \
  ONE(MultiTexCoord3##letter(GL_TEXTURE0, a[0], a[1], a[2]), GL_CURRENT_TEXTURE_COORDS) \
  ONE(MultiTexCoord4##letter(GL_TEXTURE0, a[0], a[1], a[2], a[3]), GL_CURRENT_TEXTURE_COORDS) \
  ONE(MultiTexCoord1##letter##v(GL_TEXTURE0, a), GL_CURRENT_TEXTURE_COORDS) \
  ONE(MultiTexCoord2##letter##v(GL_TEXTURE0, a), GL_CURRENT_TEXTURE_COORDS) \
  ONE(MultiTexCoord3##letter##v(GL_TEXTURE0, a), GL_CURRENT_TEXTURE_COORDS) \
  ONE(MultiTexCoord4##letter##v(GL_TEXTURE0, a), GL_CURRENT_TEXTURE_COORDS)
  COORDINATES(s, v.s) COORDINATES(i, v.i) COORDINATES(f, v.f) COORDINATES(d, v.d)
  ONE(FogCoordf(v.f[0]), GL_CURRENT_FOG_COORDINATE) ONE(FogCoordd(v.d[1]), GL_CURRENT_FOG_COORDINATE)
  ONE(FogCoordfv(v.f), GL_CURRENT_FOG_COORDINATE) ONE(FogCoorddv(v.d), GL_CURRENT_FOG_COORDINATE)
  ONE(EdgeFlag(v.ub[0] & 1), GL_EDGE_FLAG) ONE(EdgeFlagv(seed & 1 ? &on : &off), GL_EDGE_FLAG)
  ONE(Indexf(v.f[0]), GL_CURRENT_INDEX) ONE(Indexd(v.d[1]), GL_CURRENT_INDEX) ONE(Indexs(v.s[0]), GL_CURRENT_INDEX)
  ONE(Indexi(v.i[1]), GL_CURRENT_INDEX) ONE(Indexub(v.ub[2]), GL_CURRENT_INDEX) ONE(Indexubv(v.ub), GL_CURRENT_INDEX)
      // clang-format on
      return seen;
}

void with_context(const Gl& gl, const std::function<void()>& run) {
  std::vector<unsigned char> buffer(8 * 8 * 4);
  void* context = gl.OSMesaCreateContext(GL_RGBA, nullptr);
  REQUIRE(gl.OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, 8, 8));
  run();
  gl.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
  gl.OSMesaDestroyContext(context);
}

} // namespace

TEST_CASE("Every attribute form converts its arguments as OSMesa does", "[spec][attributes]") {
  for (unsigned seed = 0; seed < 50; ++seed) {
    std::vector<GLfloat> ours, theirs;
    with_context(softgl_library(), [&] { ours = forms(softgl_library(), seed); });
    with_context(osmesa_library(), [&] { theirs = forms(osmesa_library(), seed); });
    REQUIRE(ours.size() == theirs.size());
    for (size_t i = 0; i < ours.size(); ++i) {
      INFO("seed " << seed << " value " << i << ": " << ours[i] << " and " << theirs[i]);
      CHECK(std::memcmp(&ours[i], &theirs[i], sizeof(GLfloat)) == 0);
    }
  }
}

TEST_CASE("A short form gives the missing components their defaults", "[spec][attributes]") {
  const Gl& gl = softgl_library();
  with_context(gl, [&] {
    GLfloat now[4];
    gl.TexCoord4f(5, 6, 7, 8);
    gl.TexCoord1f(2);
    gl.GetFloatv(GL_CURRENT_TEXTURE_COORDS, now);
    CHECK(std::vector<GLfloat>(now, now + 4) == std::vector<GLfloat>{2, 0, 0, 1});
    gl.Color4f(0.5f, 0.5f, 0.5f, 0.5f);
    gl.GetFloatv(GL_CURRENT_COLOR, now);
    gl.Color3f(0.25f, 0, 0);
    gl.GetFloatv(GL_CURRENT_COLOR, now);
    CHECK(std::vector<GLfloat>(now, now + 4) == std::vector<GLfloat>{0.25f, 0, 0, 1});
    const GLboolean seven = 7;
    gl.EdgeFlag(GL_FALSE);
    gl.EdgeFlagv(&seven);
    GLboolean flag = 0;
    gl.GetBooleanv(GL_EDGE_FLAG, &flag);
    CHECK(flag == GL_TRUE);
  });
}

TEST_CASE("A texture unit that does not exist is GL_INVALID_ENUM", "[spec][attributes]") {
  const Gl& gl = softgl_library();
  with_context(gl, [&] {
    gl.MultiTexCoord2f(GL_TEXTURE0 + 8, 1, 2);
    CHECK(gl.GetError() == GL_INVALID_ENUM);
    gl.MultiTexCoord4sv(GL_TEXTURE0 - 1, nullptr);
    CHECK(gl.GetError() == GL_INVALID_ENUM);
    gl.MultiTexCoord2f(GL_TEXTURE7, 1, 2);
    CHECK(gl.GetError() == GL_NO_ERROR);
  });
}

TEST_CASE("A scalar form takes no parameter with several values", "[spec][attributes]") {
  const Gl& gl = softgl_library();
  with_context(gl, [&] {
    gl.Lightf(GL_LIGHT0, GL_DIFFUSE, 1);
    CHECK(gl.GetError() == GL_INVALID_ENUM);
    gl.Materiali(GL_FRONT, GL_AMBIENT, 1);
    CHECK(gl.GetError() == GL_INVALID_ENUM);
    gl.Fogi(GL_FOG_COLOR, 1);
    CHECK(gl.GetError() == GL_INVALID_ENUM);
    gl.TexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, 1);
    CHECK(gl.GetError() == GL_INVALID_ENUM);
    gl.LightModelf(GL_LIGHT_MODEL_AMBIENT, 1);
    CHECK(gl.GetError() == GL_INVALID_ENUM);
    gl.Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, 1);
    CHECK(gl.GetError() == GL_NO_ERROR);
  });
}

TEST_CASE("Commands that may not stand between Begin and End leave the state alone", "[spec][attributes]") {
  const Gl& gl = softgl_library();
  with_context(gl, [&] {
    gl.Begin(GL_TRIANGLES);
    gl.ShadeModel(GL_FLAT);
    gl.Enable(GL_LIGHTING);
    gl.LoadIdentity();
    gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    CHECK(gl.GetError() == GL_NO_ERROR); // itself not allowed there
    CHECK(gl.IsEnabled(GL_LIGHTING) == GL_FALSE);
    CHECK(gl.GetString(GL_VERSION) == nullptr);
    gl.End();
    CHECK(gl.GetError() == GL_INVALID_OPERATION);
    CHECK(gl.GetError() == GL_NO_ERROR);
    CHECK(gl.IsEnabled(GL_LIGHTING) == GL_FALSE);
    GLint model = 0;
    gl.GetIntegerv(GL_SHADE_MODEL, &model);
    CHECK(model == GL_SMOOTH);
  });
}
