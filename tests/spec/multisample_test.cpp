// Multisampling (GL 1.5, 3.2.1, 3.3.3, 3.4.4 and 4.1.3; GL_EXT_framebuffer_multisample), and where softgl
// differs from OSMesa there.
#include <catch2/catch.hpp>

#include <array>
#include <cstdlib>
#include <vector>

#include "spec/refused_calls.h"
#include "spec/state_snapshot.h"

using namespace softgl::test;

namespace {

constexpr int kSize = 8;
constexpr uint32_t kWhite = 0xffffffff, kBlack = 0xff000000;

GLint get(const Gl& gl, GLenum pname) {
  GLint value = -1;
  gl.GetIntegerv(pname, &value);
  return value;
}

GLuint make_renderbuffer(const Gl& gl, int samples, GLenum format) {
  GLuint name = 0;
  gl.GenRenderbuffers(1, &name);
  gl.BindRenderbuffer(GL_RENDERBUFFER, name);
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, kSize, kSize);
  return name;
}

void attach(const Gl& gl, GLenum attachment, GLuint renderbuffer) {
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, renderbuffer);
}

GLuint make_framebuffer(const Gl& gl, int samples, GLenum color = GL_RGBA8,
                        GLenum depth = GL_DEPTH24_STENCIL8) {
  GLuint name = 0;
  gl.GenFramebuffers(1, &name);
  gl.BindFramebuffer(GL_FRAMEBUFFER, name);
  attach(gl, GL_COLOR_ATTACHMENT0, make_renderbuffer(gl, samples, color));
  attach(gl, GL_DEPTH_STENCIL_ATTACHMENT, make_renderbuffer(gl, samples, depth));
  return name;
}

struct Picture {
  std::array<uint32_t, size_t(kSize) * kSize> word{};
  uint32_t at(int x, int y) const { return word[size_t(kSize * y + x)]; }
  int red(int x, int y) const { return int(at(x, y) & 255); }
};

/// A black framebuffer of four samples, bound, whose window coordinates are object coordinates; and one that
/// it is resolved to.
struct Samples {
  const Gl& gl;
  CurrentContext current;
  GLuint drawn, resolved;
  explicit Samples(const Gl& library, GLenum depth = GL_DEPTH24_STENCIL8)
      : gl(library), current{library}, drawn(make_framebuffer(library, 4, GL_RGBA8, depth)),
        resolved(make_framebuffer(library, 0, GL_RGBA8, depth)) {
    gl.BindFramebuffer(GL_FRAMEBUFFER, drawn);
    gl.Viewport(0, 0, kSize, kSize);
    gl.MatrixMode(GL_PROJECTION);
    gl.Ortho(0, kSize, 0, kSize, -1, 1);
    clear();
  }
  void clear() const {
    gl.ClearColor(0, 0, 0, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  }
  Picture picture() const {
    Picture p;
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved);
    gl.BlitFramebuffer(0, 0, kSize, kSize, 0, 0, kSize, kSize, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl.BindFramebuffer(GL_FRAMEBUFFER, resolved);
    gl.ReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, p.word.data());
    gl.BindFramebuffer(GL_FRAMEBUFFER, drawn);
    return p;
  }
  void rectangle(float x0, float y0, float x1, float y1, float z = 0) const {
    gl.Begin(GL_TRIANGLE_FAN);
    gl.Vertex3f(x0, y0, z), gl.Vertex3f(x1, y0, z), gl.Vertex3f(x1, y1, z), gl.Vertex3f(x0, y1, z);
    gl.End();
  }
  /// How many samples of 255 a pixel of white on black has.
  static int count(int red) { return (red + 32) / 64; }
};

} // namespace

TEST_CASE("Renderbuffers have as many samples as are asked for, or more", "[spec][multisample]") {
  const Gl& gl = softgl_library();
  const CurrentContext current{gl};
  CHECK(get(gl, GL_MAX_SAMPLES) == 4);
  CHECK(get(gl, GL_SAMPLE_BUFFERS) == 0);
  for (int samples = 0; samples <= 4; ++samples) {
    make_framebuffer(gl, samples);
    GLint stored = -1;
    gl.GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &stored);
    CHECK(stored == (samples ? 4 : 0));
    CHECK(get(gl, GL_SAMPLES) == stored);
    CHECK(get(gl, GL_SAMPLE_BUFFERS) == (samples ? 1 : 0));
  }
  // Images of one framebuffer object have equally many.
  attach(gl, GL_DEPTH_STENCIL_ATTACHMENT, make_renderbuffer(gl, 0, GL_DEPTH24_STENCIL8));
  CHECK(gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE);
  CHECK(get(gl, GL_SAMPLE_BUFFERS) == 0);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  CHECK(gl.GetError() == GL_INVALID_FRAMEBUFFER_OPERATION);
  attach(gl, GL_DEPTH_STENCIL_ATTACHMENT, 0);
  CHECK(gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
}

namespace {

GLuint words[64];
GLuint single, wide, rgb, texture;

const BadCall bad_calls[] = {
    BAD(INVALID_VALUE, RenderbufferStorageMultisample(GL_RENDERBUFFER, 5, GL_RGBA8, 4, 4)),
    BAD(INVALID_VALUE, RenderbufferStorageMultisample(GL_RENDERBUFFER, -1, GL_RGBA8, 4, 4)),
    BAD(INVALID_VALUE, RenderbufferStorageMultisample(GL_RENDERBUFFER, 4, GL_RGBA8, 4, 16385)),
    BAD(INVALID_OPERATION, ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, words)),
    BAD(INVALID_OPERATION, ReadPixels(0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, words)),
    BAD(INVALID_VALUE, ReadPixels(0, 0, -1, 1, GL_RGBA, GL_UNSIGNED_BYTE, words)),
    BAD(INVALID_OPERATION, CopyPixels(0, 0, 1, 1, GL_COLOR)),
    BAD(INVALID_OPERATION, CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 4, 4, 0)),
    BAD(INVALID_OPERATION, CopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 1, 1)),
};
// From four samples to one: neither size nor format may differ.
const BadCall bad_blits[] = {
    BAD(INVALID_OPERATION, BlitFramebuffer(0, 0, 4, 4, 0, 0, 8, 4, GL_COLOR_BUFFER_BIT, GL_NEAREST)),
    BAD(INVALID_OPERATION, BlitFramebuffer(0, 0, 4, 4, 0, 0, 4, 3, GL_DEPTH_BUFFER_BIT, GL_NEAREST)),
};
const BadCall bad_format[] = {
    BAD(INVALID_OPERATION, BlitFramebuffer(0, 0, 4, 4, 0, 0, 4, 4, GL_COLOR_BUFFER_BIT, GL_NEAREST)),
};

} // namespace

REFUSAL_TEST_CASE("Samples are not read but by a blit of their own size and format", "[spec][multisample]") {
  const Samples s(softgl_library());
  const Gl& gl = s.gl;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  single = s.resolved, wide = make_framebuffer(gl, 0, GL_RGBA16), rgb = make_framebuffer(gl, 0, GL_RGB8);
  gl.BindFramebuffer(GL_FRAMEBUFFER, s.drawn);
  expect_refused(gl, bad_calls, [] {});
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, single);
  expect_refused(gl, bad_blits, [] {});
  for (GLuint other : {wide, rgb}) {
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, other);
    expect_refused(gl, bad_format, [] {});
  }
  // The other way round, too.
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, wide);
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, s.drawn);
  expect_refused(gl, bad_blits, [] {});
  expect_refused(gl, bad_format, [] {});
  gl.Begin(GL_POINTS);
  gl.SampleCoverage(0.5f, GL_TRUE);
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, 4, GL_RGBA8, 4, 4);
  gl.End();
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
}

TEST_CASE("Pixels are covered at four points", "[spec][multisample]") {
  const Samples s(softgl_library());
  s.rectangle(2.5f, 1, 5.5f, 4.5f);
  const Picture p = s.picture();
  CHECK(p.at(3, 2) == kWhite);
  CHECK(p.at(1, 2) == kBlack);
  CHECK(s.count(p.red(2, 2)) == 2);
  CHECK(s.count(p.red(5, 2)) == 2);
  CHECK(s.count(p.red(3, 4)) == 2);
  CHECK(s.count(p.red(2, 4)) == 1); // a quarter of the pixel
  // The four points, in steps of an eighth: one in each column and each row of a quarter's.
  for (int axis = 0; axis < 2; ++axis)
    for (int eighths = 0; eighths <= 8; ++eighths) {
      s.clear();
      const float end = 4 + float(eighths) / 8;
      s.rectangle(4, 4, axis ? 5 : end, axis ? end : 5);
      CHECK(s.count(s.picture().red(4, 4)) == eighths / 2);
    }
}

TEST_CASE("Neighbors share no sample and leave none out", "[spec][multisample]") {
  const Samples s(softgl_library());
  const Gl& gl = s.gl;
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  gl.Color4f(0.25f, 0.25f, 0.25f, 0);
  gl.Begin(GL_TRIANGLE_FAN);
  gl.Vertex2f(3.375f, 4.125f); // a sample point
  const float ring[][2] = {{-1, -1}, {4.7f, -1}, {9, -1}, {9, 3.1f}, {9, 9}, {2.2f, 9}, {-1, 9}, {-1, -1}};
  for (const auto& v : ring) gl.Vertex2fv(v);
  gl.End();
  for (uint32_t word : s.picture().word) CHECK(word == 0xff404040);
}

TEST_CASE("Depth and stencil are tested and kept by sample", "[spec][multisample]") {
  const auto depth_format = GENERATE(GLenum(GL_DEPTH24_STENCIL8), GLenum(GL_DEPTH32F_STENCIL8));
  const Samples s(softgl_library(), depth_format);
  const Gl& gl = s.gl;
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_STENCIL_TEST);
  gl.StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
  gl.StencilFunc(GL_ALWAYS, 0, 255);
  gl.Color4f(1, 0, 0, 1);
  s.rectangle(0, 0, 2.5f, 8, 0.5f); // near
  gl.Color4f(1, 1, 0, 1);
  s.rectangle(0, 0, 8, 8, 0); // behind it
  const Picture p = s.picture();
  CHECK(p.at(1, 1) == 0xff0000ff);
  CHECK(p.at(2, 1) == 0xff0080ff); // half of each
  CHECK(p.at(3, 1) == 0xff00ffff);
  gl.Disable(GL_DEPTH_TEST);
  gl.StencilFunc(GL_EQUAL, 2, 255);
  s.rectangle(0, 0, 8, 8, 0);
  CHECK(s.picture().word == p.word); // no sample was drawn to twice
  // Of depths and stencil values a blit takes one sample.
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, s.resolved);
  gl.BlitFramebuffer(0, 0, 8, 8, 0, 0, 8, 8, GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT, GL_NEAREST);
  gl.BindFramebuffer(GL_FRAMEBUFFER, s.resolved);
  GLuint depth[3] = {};
  gl.ReadPixels(1, 1, 3, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depth);
  CHECK(depth[0] < 0x41000000);
  CHECK(depth[2] > 0x7f000000);
  CHECK((depth[1] == depth[0] || depth[1] == depth[2]));
  GLubyte stencil[3] = {};
  gl.ReadPixels(1, 1, 3, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil);
  CHECK((stencil[0] == 1 && stencil[1] == 1 && stencil[2] == 1));
}

TEST_CASE("Coverage follows alpha and the sample coverage", "[spec][multisample]") {
  const Samples s(softgl_library());
  const Gl& gl = s.gl;
  const auto samples = [&](float alpha) {
    s.clear();
    gl.Color4f(1, 1, 1, alpha);
    s.rectangle(0, 0, 8, 8);
    return s.count(s.picture().red(4, 4));
  };
  CHECK(samples(0.5f) == 4);
  gl.Enable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  CHECK(samples(0) == 0);
  CHECK(samples(0.5f) == 2);
  CHECK(samples(1) == 4);
  gl.Disable(GL_MULTISAMPLE); // which switches all of it off
  CHECK(samples(0) == 4);
  gl.Enable(GL_MULTISAMPLE);
  gl.Disable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  gl.Enable(GL_SAMPLE_COVERAGE);
  CHECK(samples(1) == 4);
  gl.SampleCoverage(0.5f, GL_FALSE);
  CHECK(samples(1) == 2);
  gl.SampleCoverage(0.75f, GL_TRUE);
  CHECK(samples(1) == 1);
  gl.SampleCoverage(0, GL_FALSE);
  CHECK(samples(1) == 0);
  gl.Disable(GL_SAMPLE_COVERAGE);
  gl.Enable(GL_SAMPLE_ALPHA_TO_ONE);
  samples(0.25f);
  CHECK(s.picture().at(4, 4) == kWhite);
  gl.Disable(GL_SAMPLE_ALPHA_TO_ONE);
  samples(0.25f);
  CHECK(s.picture().at(4, 4) == 0x40ffffff);
}

TEST_CASE("Images and bitmaps obey what limits coverage", "[spec][multisample][osmesa]") {
  const auto samples = [](const Gl& gl) {
    const Samples s(gl);
    gl.Enable(GL_SAMPLE_COVERAGE);
    gl.SampleCoverage(0.5f, GL_FALSE);
    gl.WindowPos2i(0, 0);
    const std::vector<uint32_t> image(64, kWhite);
    gl.DrawPixels(kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
    return s.count(s.picture().red(4, 4));
  };
  CHECK(samples(softgl_library()) == 2);
  CHECK(samples(osmesa_library()) == 4);
}

TEST_CASE("Without multisampling every sample is tested", "[spec][multisample][osmesa]") {
  const auto half = [](const Gl& gl) {
    const Samples s(gl);
    gl.Enable(GL_DEPTH_TEST);
    gl.Color4f(1, 0, 0, 1);
    s.rectangle(0, 0, 2.5f, 8, 0.5f);
    gl.Disable(GL_MULTISAMPLE);
    gl.Color4f(1, 1, 0, 1);
    s.rectangle(0, 0, 8, 8, 0);
    return s.picture().at(2, 1) == 0xff0080ff;
  };
  CHECK(half(softgl_library()));
  CHECK(!half(osmesa_library()));
}

TEST_CASE("The scissor box cuts pixels, not samples", "[spec][multisample][osmesa]") {
  const auto outside = [](const Gl& gl) {
    const Samples s(gl);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(2, 2, 3, 3);
    s.rectangle(0, 0, 8, 8);
    gl.Disable(GL_SCISSOR_TEST);
    const Picture p = s.picture();
    int wrong = 0;
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x)
        wrong += p.at(x, y) != (x >= 2 && x < 5 && y >= 2 && y < 5 ? kWhite : kBlack);
    return wrong;
  };
  CHECK(outside(softgl_library()) == 0);
  CHECK(outside(osmesa_library()) > 0);
}

TEST_CASE("Lines are rectangles, colored from end to end", "[spec][multisample][osmesa]") {
  const auto line = [](const Gl& gl) {
    const Samples s(gl);
    gl.LineWidth(2);
    gl.Begin(GL_LINES);
    gl.Color4f(0, 0, 0, 1), gl.Vertex2f(0, 4);
    gl.Color4f(1, 1, 1, 1), gl.Vertex2f(8, 4);
    gl.End();
    return s.picture();
  };
  const Picture ours = line(softgl_library()), theirs = line(osmesa_library());
  for (int x = 0; x < kSize; ++x) {
    CHECK(ours.red(x, 3) == ours.red(x, 4));
    CHECK(std::abs(ours.red(x, 4) - (2 * x + 1) * 255 / 16) <= 1);
    CHECK(ours.at(x, 2) == kBlack);
    CHECK(ours.at(x, 5) == kBlack);
  }
  CHECK(theirs.red(4, 4) > ours.red(4, 4)); // half a pixel further
}

TEST_CASE("Short lines are not lost", "[spec][multisample][osmesa]") {
  const auto samples = [](const Gl& gl) {
    const Samples s(gl);
    gl.Begin(GL_LINES);
    gl.Vertex2f(3.3f, 5.1f), gl.Vertex2f(3.7f, 5.2f);
    gl.End();
    return s.count(s.picture().red(3, 5));
  };
  CHECK(samples(softgl_library()) > 0);
  CHECK(samples(osmesa_library()) == 0);
}

TEST_CASE("Points are circles, sprites are squares", "[spec][multisample][osmesa]") {
  const auto point = [](const Gl& gl, bool sprite) {
    const Samples s(gl);
    if (sprite) gl.Enable(GL_POINT_SPRITE);
    gl.PointSize(6);
    gl.Begin(GL_POINTS);
    gl.Vertex2f(4, 4);
    gl.End();
    return s.picture();
  };
  const Picture round = point(softgl_library(), false);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      int inside = 0;
      constexpr float kPoints[4][2] = {
          {0.375f, 0.125f}, {0.875f, 0.375f}, {0.125f, 0.625f}, {0.625f, 0.875f}};
      for (const auto& p : kPoints) {
        const float dx = float(x) + p[0] - 4, dy = float(y) + p[1] - 4;
        inside += dx * dx + dy * dy <= 9;
      }
      CHECK(Samples::count(round.red(x, y)) == inside);
    }
  CHECK(point(osmesa_library(), false).at(1, 1) == kWhite);
  CHECK(point(softgl_library(), true).word == point(osmesa_library(), true).word);
}

TEST_CASE("Blits copy samples, and give all of them one pixel", "[spec][multisample]") {
  const Samples s(softgl_library());
  const Gl& gl = s.gl;
  s.rectangle(2.5f, 1, 5.5f, 4.5f);
  const Picture before = s.picture();
  const GLuint other = make_framebuffer(gl, 4);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, s.drawn);
  const GLbitfield all = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
  gl.BlitFramebuffer(0, 0, 8, 8, 0, 0, 8, 8, all, GL_NEAREST);
  gl.BindFramebuffer(GL_FRAMEBUFFER, s.drawn);
  s.clear();
  // Back again, and with what came back resolved the picture is the old one; so each sample went its own way.
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, other);
  gl.BlitFramebuffer(0, 0, 8, 8, 0, 0, 8, 8, all, GL_NEAREST);
  gl.BindFramebuffer(GL_FRAMEBUFFER, s.drawn);
  CHECK(s.picture().word == before.word);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE_MINUS_DST_COLOR, GL_ZERO);
  s.rectangle(0, 0, 8, 8);
  CHECK(s.picture().at(3, 2) == 0); // destination alpha was 1
  CHECK(Samples::count(s.picture().red(2, 2)) == 2);
  // One pixel to four samples.
  gl.Disable(GL_BLEND);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, s.resolved);
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, s.drawn);
  gl.BlitFramebuffer(0, 0, 8, 8, 0, 0, 8, 8, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  const Picture gray = s.picture();
  gl.BindFramebuffer(GL_FRAMEBUFFER, s.drawn);
  CHECK(s.picture().word == gray.word);
}

TEST_CASE("Queries count samples", "[spec][multisample]") {
  const Samples s(softgl_library());
  const Gl& gl = s.gl;
  GLuint query = 0, count = 0;
  gl.GenQueries(1, &query);
  gl.BeginQuery(GL_SAMPLES_PASSED, query);
  s.rectangle(2, 2, 3.5f, 3);
  gl.EndQuery(GL_SAMPLES_PASSED);
  gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
  CHECK(count == 6);
}
