// What happens to a pixel: whole draws that cover a picture, by one thread, in nanoseconds per pixel.
#include <cstring>

#include "commands/framebuffer/flush.h"
#include "frames/mesh.h"
#include "harness.h"

namespace softgl::bench {
namespace {

constexpr int kSize = 512;

/// Draws a quad over all pixels again and again; `scale` is the number of texels per pixel along both axes.
void cover(benchmark::State& state, Canvas& canvas, float texels_per_pixel = 1) {
  const float t = texels_per_pixel * kSize / 512;
  auto quad = [&] {
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 4; i++) {
      const float x = i & 1 ? 1.0f : 0.0f, y = i & 2 ? 1.0f : 0.0f;
      glColor4f(x, y, 0.5f, 0.3f + 0.2f * x);
      glTexCoord2f(t * x + 0.3f * y, t * y);
      glVertex3f(2 * x - 1, 2 * y - 1, 0.5f * x);
    }
    glEnd();
  };
  glClearColor(0.2f, 0.4f, 0.6f, 0.8f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  quad();
  const uint64_t hash = canvas.picture_hash();
  for (auto _ : state) {
    quad();
    flush_rendering(*current_context);
  }
  count_work(state, "pixel", double(kSize) * kSize);
  print_hash(state, hash);
}

void fragments(benchmark::State& state, const char* what) {
  Canvas canvas(kSize);
  auto is = [&](const char* name) { return std::strcmp(what, name) == 0; };
  glShadeModel(is("flat") ? GL_FLAT : GL_SMOOTH);
  if (is("depth")) glEnable(GL_DEPTH_TEST), glDepthFunc(GL_LEQUAL);
  if (is("fog")) glEnable(GL_FOG), glFogf(GL_FOG_DENSITY, 0.7f);
  if (is("alpha_test")) glEnable(GL_ALPHA_TEST), glAlphaFunc(GL_GREATER, 0.4f);
  if (is("scissor")) glEnable(GL_SCISSOR_TEST), glScissor(5, 7, 490, 481);
  cover(state, canvas);
}

void blend(benchmark::State& state, GLenum source, GLenum destination, GLenum equation) {
  Canvas canvas(kSize);
  glEnable(GL_BLEND);
  glBlendFunc(source, destination);
  glBlendEquation(equation);
  cover(state, canvas);
}

void texture(benchmark::State& state, GLenum min_filter, GLenum mag_filter, GLenum wrap, GLenum environment) {
  Canvas canvas(kSize);
  int level = 0;
  for (int size = 512; size; size /= 2) {
    const std::vector<uint8_t> image = make_image(size);
    glTexImage2D(GL_TEXTURE_2D, level++, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GLint(min_filter));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GLint(mag_filter));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GLint(wrap));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GLint(wrap));
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GLint(environment));
  glEnable(GL_TEXTURE_2D);
  cover(state, canvas, min_filter == mag_filter ? 0.4f : 2.7f);
}

BENCHMARK_CAPTURE(fragments, flat, "flat");
BENCHMARK_CAPTURE(fragments, smooth, "smooth");
BENCHMARK_CAPTURE(fragments, depth, "depth");
BENCHMARK_CAPTURE(fragments, fog, "fog");
BENCHMARK_CAPTURE(fragments, alpha_test, "alpha_test");
BENCHMARK_CAPTURE(fragments, scissor, "scissor");
BENCHMARK_CAPTURE(blend, over, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_FUNC_ADD);
BENCHMARK_CAPTURE(blend, add, GL_ONE, GL_ONE, GL_FUNC_ADD);
BENCHMARK_CAPTURE(blend, multiply, GL_DST_COLOR, GL_ZERO, GL_FUNC_ADD);
BENCHMARK_CAPTURE(blend, maximum, GL_ONE, GL_ONE, GL_MAX);
BENCHMARK_CAPTURE(texture, nearest, GL_NEAREST, GL_NEAREST, GL_REPEAT, GL_REPLACE);
BENCHMARK_CAPTURE(texture, bilinear, GL_LINEAR, GL_LINEAR, GL_REPEAT, GL_REPLACE);
BENCHMARK_CAPTURE(texture, mipmap_nearest, GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST, GL_REPEAT, GL_REPLACE);
BENCHMARK_CAPTURE(texture, trilinear, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_REPEAT, GL_REPLACE);
BENCHMARK_CAPTURE(texture, trilinear_modulated, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_REPEAT, GL_MODULATE);
BENCHMARK_CAPTURE(texture, mirrored, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_MIRRORED_REPEAT, GL_REPLACE);

} // namespace
} // namespace softgl::bench
