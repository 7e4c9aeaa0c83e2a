// SOFTGL_DISABLE: every fast path draws what the general one draws, and is off when its name is there.
#include <catch2/catch.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "base/fast_paths.h"
#include "support/environment.h"
#include "support/runner.h"
#include "support/traced_program.h"

namespace softgl::test {
namespace {

/// 20,001 colored vertices on a spiral, more than a round has.
struct Spiral {
  std::vector<float> position, color;
  Spiral() {
    for (int i = 0; i <= 20000; ++i) {
      const float t = float(i) / 20000, angle = 200 * t, radius = 1.2f * t + 0.05f * float(i % 3);
      position.insert(position.end(), {radius * std::cos(angle), radius * std::sin(angle), t - 0.5f});
      color.insert(color.end(), {t, float(i % 5) / 4, 1 - t});
    }
  }
};

void draw_arrays(const Gl& gl) {
  static const Spiral spiral;
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, 0, spiral.position.data());
  gl.EnableClientState(GL_COLOR_ARRAY);
  gl.ColorPointer(3, GL_FLOAT, 0, spiral.color.data());
  gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 20001);
  const GLuint scattered[] = {1, 20000, 9000, 5, 7000, 14000};
  gl.DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_INT, scattered);
  GLuint buffer[2];
  gl.GenBuffers(2, buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer[0]);
  gl.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(spiral.position.size() * 4), spiral.position.data(),
                GL_STATIC_DRAW);
  gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
  gl.DisableClientState(GL_COLOR_ARRAY);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer[1]);
  const GLushort near[] = {100, 101, 102, 103, 104, 105};
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof near, near, GL_STATIC_DRAW);
  for (float shade : {0.25f, 0.5f}) {
    gl.Color3f(shade, 1, 1 - shade);
    gl.DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, nullptr);
  }
  gl.DeleteBuffers(2, buffer);
  gl.DisableClientState(GL_VERTEX_ARRAY);
}

void draw_list(const Gl& gl) {
  const GLuint list = gl.GenLists(1);
  gl.NewList(list, GL_COMPILE);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 100; ++i) {
    const float x = 0.018f * float(i / 2) - 0.9f, y = 0.3f + 0.1f * float(i % 3);
    gl.Vertex3f(x, y, -0.8f), gl.Vertex3f(x + 0.018f, y, -0.8f), gl.Vertex3f(x, y + 0.05f, -0.8f);
  }
  gl.End();
  gl.EndList();
  for (float down : {0.0f, 0.4f, 0.8f}) {
    gl.Translatef(0, -down, 0);
    gl.CallList(list);
    gl.LoadIdentity();
  }
  gl.DeleteLists(list, 1);
}

void draw_textures(const Gl& gl) {
  GLuint texture;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  std::vector<GLubyte> texels(size_t(16) * 16 * 4);
  for (size_t i = 0; i < texels.size(); ++i) texels[i] = GLubyte(i * 37);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.Enable(GL_TEXTURE_2D);
  for (GLint mode : {GL_MODULATE, GL_BLEND, GL_DECAL, GL_BLEND}) {
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, mode);
    gl.Translatef(0.4f, 0, 0);
    gl.Begin(GL_QUADS);
    gl.Color4f(0.9f, 0.6f, 0.3f, 0.8f);
    gl.TexCoord2f(0, 0), gl.Vertex3f(-1.3f, -1, -0.9f);
    gl.TexCoord2f(3, 0), gl.Vertex3f(-1, -1, -0.9f);
    gl.TexCoord2f(3, 3), gl.Vertex3f(-1, -0.5f, 0.2f);
    gl.TexCoord2f(0, 3), gl.Vertex3f(-1.3f, -0.5f, 0.2f);
    gl.End();
  }
  gl.LoadIdentity();
  gl.Disable(GL_TEXTURE_2D);
  gl.DeleteTextures(1, &texture);
}

/// Small and large triangles with a cube map, whose lanes stand alone, or look at their quads where there are
/// no seams.
void draw_cube_map(const Gl& gl) {
  GLuint texture;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, texture);
  std::vector<GLubyte> texels(size_t(8) * 8 * 4 + 4 * 5); // each face begins one later
  for (size_t i = 0; i < texels.size(); ++i) texels[i] = GLubyte(i * 53);
  for (int face = 0; face < 6; ++face)
    gl.TexImage2D(GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face), 0, GL_RGBA8, 8, 8, 0, GL_RGBA,
                  GL_UNSIGNED_BYTE, texels.data() + 4 * face);
  gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.Enable(GL_TEXTURE_CUBE_MAP);
  for (const float top : {0.9f, 0.75f}) {
    if (top < 0.9f) gl.Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    gl.Begin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 40; ++i) {
      const float x = i < 30 ? 0.02f * float(i) - 0.9f : 0.1f * float(i - 30) - 0.3f,
                  y = i & 1 ? top : top - 0.1f;
      gl.TexCoord3f(x, y - top + 0.05f, 0.3f - x), gl.Vertex3f(x, y, -0.95f);
    }
    gl.End();
  }
  gl.Disable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  gl.Disable(GL_TEXTURE_CUBE_MAP);
  gl.DeleteTextures(1, &texture);
}

/// Half in the shadow of a map of depths.
void draw_shadow(const Gl& gl) {
  GLuint texture;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  const GLushort depths[2] = {10000, 50000};
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 2, 1, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT,
                depths);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_INTENSITY);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
  gl.Enable(GL_TEXTURE_2D), gl.Enable(GL_ALPHA_TEST);
  gl.AlphaFunc(GL_GEQUAL, 0.5f);
  gl.Begin(GL_TRIANGLES);
  gl.Color4f(0.9f, 0.8f, 0.2f, 0.9f);
  gl.TexCoord3f(0, 0, 0.4f), gl.Vertex3f(0.1f, -0.9f, -0.96f);
  gl.TexCoord3f(1.8f, 0, 0.5f), gl.Vertex3f(0.9f, -0.9f, -0.96f);
  gl.TexCoord3f(1, 1, 0.2f), gl.Vertex3f(0.5f, -0.4f, -0.96f);
  gl.End();
  gl.Disable(GL_TEXTURE_2D), gl.Disable(GL_ALPHA_TEST);
  gl.DeleteTextures(1, &texture);
}

/// Lit with alpha 1 everywhere.
void draw_opaque(const Gl& gl) {
  gl.Enable(GL_LIGHTING), gl.Enable(GL_LIGHT0);
  gl.Begin(GL_TRIANGLES);
  gl.Normal3f(0, 0.6f, 0.8f), gl.Vertex4f(-0.9f, -0.2f, 0, 1.5f);
  gl.Normal3f(0.6f, 0, 0.8f), gl.Vertex4f(0.7f, 0, 0, 0.9f);
  gl.Normal3f(0, 0, 1), gl.Vertex4f(0, 0.8f, 0, 1.2f);
  gl.End();
  gl.Disable(GL_LIGHTING);
}

/// Points of a few pixels, and of more.
void draw_points(const Gl& gl) {
  for (const float size : {1.0f, 3.0f, 9.0f}) {
    gl.PointSize(size);
    gl.Begin(GL_POINTS);
    for (int i = 0; i < 30; ++i) {
      gl.Color3f(1, float(i) / 30, size / 9);
      gl.Vertex3f(float(i) / 15 - 1, size / 9 - 0.8f, float(i % 7) / 7 - 0.5f);
    }
    gl.End();
  }
}

/// Thin and wide lines, short ones and some across the picture, also from pixel to pixel and from border to
/// border of pixels, where ties decide.
void draw_lines(const Gl& gl) {
  gl.PushMatrix();
  gl.LoadIdentity();
  gl.Scalef(1.0f / 256, 1.0f / 256, 1); // a pixel
  for (const float width : {1.0f, 2.0f, 4.0f, 7.0f}) {
    gl.LineWidth(width);
    gl.Begin(GL_LINES);
    for (int i = 0; i < 400; ++i) {
      const float grid = i % 3 == 0 ? 1.0f : i % 3 == 1 ? 0.5f : 0.37f;
      const float x = float(i * 97 % 620 - 310) * grid, y = float(i * 53 % 540 - 270) * grid;
      const float reach = i % 40 == 0 ? 23.0f : 0.7f;
      gl.Color3f(float(i % 11) / 10, float(i % 7) / 6, width / 7);
      gl.Vertex3f(x, y, float(i % 5) / 5 - 0.9f);
      gl.Color3f(float(i % 5) / 4, float(i % 3) / 2, 0.5f);
      gl.Vertex3f(x + float(i % 31 - 15) * reach, y + float(i % 23 - 11) * reach, float(i % 9) / 9 - 0.9f);
    }
    gl.End();
  }
  gl.PopMatrix();
}

/// Strips of 6000 vertices that begin far outside of the view and end outside or inside, from arrays in
/// order, by indices, and the last of them in immediate mode: vertices that one plane clips are in blocks and
/// chunks of their own, on whose border is a triangle that is cut.
void draw_clipped(const Gl& gl) {
  constexpr GLsizei kCount = 6000;
  for (const float end : {-1.5f, 0.9f}) {
    for (int along = 0; along < 2; ++along) { // the left plane, the lower one
      std::vector<float> position, color;
      std::vector<GLushort> index;
      for (int i = 0; i < kCount; ++i) {
        const float x = end - 0.004f * float(kCount - 1 - i), y = float(i % 7) / 7 - 0.4f;
        position.insert(position.end(), {along ? y : x, along ? x : y, 0.1f - float(i % 5) / 5});
        color.insert(color.end(), {float(i % 3) / 2, float(i % 11) / 10, 0.4f});
        index.push_back(GLushort(i));
      }
      gl.EnableClientState(GL_VERTEX_ARRAY), gl.EnableClientState(GL_COLOR_ARRAY);
      gl.VertexPointer(3, GL_FLOAT, 0, position.data());
      gl.ColorPointer(3, GL_FLOAT, 0, color.data());
      gl.DrawArrays(GL_TRIANGLE_STRIP, 0, kCount);
      gl.DrawElements(GL_TRIANGLE_STRIP, kCount, GL_UNSIGNED_SHORT, index.data());
      gl.DisableClientState(GL_COLOR_ARRAY), gl.DisableClientState(GL_VERTEX_ARRAY);
      gl.Begin(GL_TRIANGLE_STRIP);
      for (size_t i = kCount - 700; i < kCount; ++i)
        gl.Color3fv(&color[3 * i]), gl.Vertex3f(position[3 * i], position[3 * i + 1], -0.97f);
      gl.End();
    }
  }
}

/// Triangles of 1 to 80 pixels, around every limit between small and large ones, across tiles: with and
/// without stages, a level of detail, an alpha test and blending.
void draw_sizes(const Gl& gl) {
  GLuint texture;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  std::vector<GLubyte> texels(size_t(64) * 64 * 4);
  for (size_t i = 0; i < texels.size(); ++i) texels[i] = GLubyte(i * 41 >> 2);
  gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  gl.AlphaFunc(GL_GEQUAL, 0.3f);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE);
  for (int way = 0; way < 12; ++way) {
    way % 3 ? gl.Enable(GL_TEXTURE_2D) : gl.Disable(GL_TEXTURE_2D);
    way & 1 ? gl.Enable(GL_ALPHA_TEST) : gl.Disable(GL_ALPHA_TEST);
    way >= 6 ? gl.Enable(GL_BLEND) : gl.Disable(GL_BLEND);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                     way % 3 == 1 ? GL_LINEAR : GL_LINEAR_MIPMAP_LINEAR);
    gl.Begin(GL_TRIANGLES);
    for (int i = 1; i <= 80; ++i) {
      const float size = float(i) / 256, angle = float(7 * i + way), x = 0.9f * std::sin(float(i * i + way)),
                  y = 0.9f * std::cos(float(i * i + 3 * way)), z = -0.97f - 0.002f * float(way);
      for (int corner = 0; corner < 3; ++corner) {
        const float a = angle + 2.1f * float(corner), u = size * std::cos(a), v = size * std::sin(a);
        gl.Color4f(0.5f + 0.5f * std::cos(a), 0.8f, 0.5f + 0.5f * std::sin(a), 0.2f + 0.3f * float(corner));
        gl.TexCoord2f(u * float(i % 9), v * float(i % 5)), gl.Vertex3f(x + u, y + v, z + 0.005f * size);
      }
    }
    gl.End();
  }
  for (const GLenum what : {GL_TEXTURE_2D, GL_ALPHA_TEST, GL_BLEND}) gl.Disable(what);
  gl.DeleteTextures(1, &texture);
}

/// Letters, and a bitmap across tiles and the window's border.
void draw_bitmaps(const Gl& gl) {
  std::vector<GLubyte> bits(40 * 300);
  for (size_t i = 0; i < bits.size(); ++i) bits[i] = GLubyte(i * 97 >> 3);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.Color4f(0.3f, 0.9f, 0.7f, 0.5f);
  gl.RasterPos3f(-0.9f, 0.3f, 0.2f);
  for (int i = 0; i < 20; ++i) gl.Bitmap(8, 13, 0, 2, 9.3f, 0.4f, bits.data() + i);
  gl.RasterPos3f(0.4f, 0.1f, 0);
  gl.Bitmap(320, 300, 3, 5, 0, 0, bits.data());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

/// Takes every fast path once at least.
void draw_everything(Stage& s) {
  const Gl& gl = s.gl;
  gl.Enable(GL_DEPTH_TEST);
  gl.ClearColor(0.2f, 0.4f, 0.6f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  draw_list(gl);
  gl.ClearColor(0.1f, 0, 0.2f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); // hides the list
  draw_arrays(gl);
  draw_list(gl);
  draw_textures(gl);
  draw_cube_map(gl);
  draw_shadow(gl);
  draw_opaque(gl);
  draw_points(gl);
  draw_lines(gl);
  draw_clipped(gl);
  draw_bitmaps(gl);
  draw_sizes(gl);
  gl.Finish();
  std::vector<GLubyte> pixels(size_t(s.width) * size_t(s.height) * 4);
  gl.ReadPixels(0, 0, s.width, s.height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  // What was read is part of the picture.
  gl.DrawPixels(s.width / 2, s.height / 2, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
}

struct Run {
  std::string hashes; // a line for each scene
  uint32_t taken = 0; // the fast paths that the flushes name
};

Run run_without(const std::string& names) {
  names.empty() ? unsetenv("SOFTGL_DISABLE") : setenv("SOFTGL_DISABLE", names.c_str(), 1);
  const TracedRun traced = run_traced([](const Gl& gl) {
    const auto print = [&](const Scene& scene, uint64_t seed) {
      std::fprintf(stderr, "%s %d %016llx\n", scene.name.c_str(), int(seed),
                   static_cast<unsigned long long>(draw(gl, scene, seed).hash()));
    };
    print({"every fast path", draw_everything, false, 512, 512}, 0);
    for (const char* family :
         {"triangles", "alpha", "blend", "depth", "near", "points", "lines", "lit", "polygon_stipples",
          "texture", "texture_units", "combine", "lists", "arrays", "occlusion"})
      for (uint64_t seed = 0; seed < uint64_t(seed_count(4)); ++seed) print(*find_scene(family), seed);
  });
  unsetenv("SOFTGL_DISABLE");
  CHECK(traced.status == 0);
  Run run{traced.errors};
  const std::string label = ", fast paths ";
  for (size_t at = traced.trace.find(label); at != std::string::npos; at = traced.trace.find(label, at)) {
    at += label.size();
    std::string unknown;
    run.taken |=
        kAllFastPaths & ~enabled_by(traced.trace.substr(at, traced.trace.find('\n', at) - at), unknown);
    CHECK(unknown == "");
  }
  return run;
}

const Run& usual_run() {
  static const Run run = run_without("");
  return run;
}

} // namespace

TEST_CASE("each fast path draws what the general one draws", "[identity]") {
  const Run& usual = usual_run();
  REQUIRE(usual.hashes.find("every fast path 0 ") == 0);
  for (uint32_t i = 0; i < uint32_t(FastPath::Count); ++i) {
    const std::string name = to_names(1u << i);
    INFO(name);
    // Vectors of four lanes, as the first instruction set has, share no planes.
    if (FastPath(i) != FastPath::SharedPlanes) CHECK((usual.taken >> i & 1) == 1);
    const Run run = run_without(name);
    CHECK((run.taken >> i & 1) == 0);
    CHECK(run.hashes == usual.hashes);
  }
}

TEST_CASE("without any fast path the picture is the same", "[identity]") {
  const Run run = run_without("all");
  CHECK(to_names(run.taken) == "");
  CHECK(run.hashes == usual_run().hashes);
}

TEST_CASE("SOFTGL_DISABLE with an unknown name says which there are", "[identity]") {
  setenv("SOFTGL_DISABLE", "tiny,tinny", 1);
  const TracedRun run = run_traced([](const Gl&) {});
  unsetenv("SOFTGL_DISABLE");
  CHECK(run.status == 0);
  CHECK(run.errors ==
        "softgl: SOFTGL_DISABLE has no fast path \"tinny\": there are all," + to_names(kAllFastPaths) + "\n");
}

} // namespace softgl::test
