// A color, or texture coordinates, that come behind vertices of a run: they belong to the vertices behind
// them and are interpolated there. Vertices in front of them keep the constant of before, which is not
// interpolated.
#include <catch2/catch.hpp>

#include "support/runner.h"

namespace softgl::test {
namespace {

enum class Kind { Color, SecondaryColor, TrackedColor, Coordinates };
enum class Place { BetweenPrimitives, SameBetweenPrimitives, BehindBegin, InsidePrimitive };
constexpr int kVertices = 12;

Kind kind; // read by the scene
Place place;
GLenum mode;
int before; // vertices in front of the attribute

void enable_kind(Stage& s) {
  const Gl& gl = s.gl;
  GLfloat texels[64];
  for (GLfloat& t : texels) t = s.random.real(0, 1);
  switch (kind) {
  case Kind::SecondaryColor:
    gl.Color3f(0, 0, 0);
    gl.Enable(GL_COLOR_SUM);
    break;
  case Kind::TrackedColor:
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    gl.Enable(GL_COLOR_MATERIAL);
    break;
  case Kind::Coordinates:
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_FLOAT, texels);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.Enable(GL_TEXTURE_2D);
    break;
  default: break;
  }
}

void draw_late(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.MatrixMode(GL_PROJECTION);
  gl.Frustum(-0.5, 0.5, -0.5, 0.5, 0.5, 9);
  gl.MatrixMode(GL_MODELVIEW);
  gl.Translatef(0, 0, -2);
  enable_kind(s);
  GLfloat value[2][4]; // each component rounds either way
  for (auto& v : value)
    for (GLfloat& c : v) c = (float(r.integer(0, 254)) + 0.5f) / 255;
  const auto set = [&](int i) {
    switch (kind) {
    case Kind::SecondaryColor: return gl.SecondaryColor3fv(value[i]);
    case Kind::Coordinates: return gl.TexCoord4fv(value[i]);
    default: return gl.Color4fv(value[i]);
    }
  };
  const auto vertices = [&](int count) {
    for (int i = 0; i < count; i++) { // in view, in rows: no quadrilateral is folded or clipped
      const float step = float(r.integer(0, 3)) * 0.1f;
      gl.Vertex3f(float(i / 4 % 3) * 0.5f - 0.9f + ((i + 1) / 2 % 2 ? 0.4f : 0.0f) + 0.1f * step,
                  (i / 2 % 2 ? 0.6f : -0.9f) + step, r.real(-1, 1));
    }
  };
  set(0);
  gl.Begin(mode);
  vertices(before);
  if (place == Place::InsidePrimitive) {
    set(1);
    vertices(kVertices - before);
  }
  gl.End();
  if (place == Place::BetweenPrimitives) set(1);
  if (place == Place::SameBetweenPrimitives) set(0);
  gl.Begin(mode);
  if (place == Place::BehindBegin) set(1);
  vertices(kVertices);
  gl.End();
}

} // namespace

TEST_CASE(
    "an attribute that comes behind vertices is interpolated, and that of the vertices before it is not",
    "[conformance][vertex]") {
  const Scene scene{"late", draw_late, true};
  const auto check = [&](Kind k, Place p, GLenum m, int waiting) {
    kind = k, place = p, mode = m, before = waiting;
    const uint64_t seed = uint64_t(waiting);
    const Difference d = compare(draw(softgl_library(), scene, seed), draw(osmesa_library(), scene, seed));
    INFO("kind " << int(k) << ", place " << int(p) << ", mode " << m << ", behind " << waiting << ": "
                 << d.text);
    CHECK_FALSE(d.any());
  };
  for (GLenum m = GL_POINTS; m <= GL_POLYGON; m++) {
    for (int i = 1; i < kVertices; i++) check(Kind::Color, Place::InsidePrimitive, m, i);
    check(Kind::Color, Place::BehindBegin, m, kVertices);
    for (const int i : {4, 100}) check(Kind::Color, Place::BetweenPrimitives, m, i);
    for (const int i : {4, kVertices}) check(Kind::Color, Place::SameBetweenPrimitives, m, i);
  }
  for (const Kind k : {Kind::SecondaryColor, Kind::TrackedColor, Kind::Coordinates})
    for (const GLenum m : {GL_LINE_STRIP, GL_TRIANGLE_STRIP, GL_QUADS})
      for (const Place p : {Place::BetweenPrimitives, Place::SameBetweenPrimitives, Place::BehindBegin,
                            Place::InsidePrimitive})
        check(k, p, m, p == Place::InsidePrimitive ? 5 : 8);
}

TEST_CASE("primitives of 9 to 64 vertices with a color each share a run", "[conformance][deviation]") {
  const Scene scene{"late", draw_late, true};
  const auto drawn = [&](const Gl& gl, Place color) { return place = color, draw(gl, scene, 1); };
  kind = Kind::Color, mode = GL_TRIANGLES;
  for (const int waiting : {9, 12, 63}) {
    before = waiting;
    const auto interpolated = [&](const Gl& gl) {
      return !compare(drawn(gl, Place::BetweenPrimitives), drawn(gl, Place::BehindBegin)).any();
    };
    CHECK(interpolated(softgl_library()));
    CHECK_FALSE(interpolated(osmesa_library()));
  }
}

} // namespace softgl::test
