// Draws between random state commands: the same picture whether snapshots of the state are used again or,
// after a flush, all made anew. In a build with SOFTGL_CHECKS the library itself compares the snapshots.
#include <catch2/catch.hpp>

#include <vector>

#include "spec/state_commands.h"
#include "support/gl.h"
#include "support/random.h"

using namespace softgl::test;

namespace {

constexpr int kSize = 32;
using Picture = std::vector<unsigned char>;

/// A state command and the draw after it.
struct Step {
  StateCommand change;
  bool opens_view; // undoes what lets nothing be seen
  GLenum mode;
  bool color, normal, texcoord, material;
  Float4 value;
};

Step random_step(Random& r) {
  Step s;
  s.change = random_state_command(r);
  s.opens_view = r.chance(40);
  s.mode = r.pick<GLenum>({GL_TRIANGLES, GL_TRIANGLES, GL_TRIANGLES, GL_LINES, GL_POINTS});
  s.color = r.chance(30), s.normal = r.chance(30), s.texcoord = r.chance(50), s.material = r.chance(20);
  s.value = r.color();
  return s;
}

void open_view(const Gl& gl) {
  gl.Viewport(0, 0, kSize, kSize);
  gl.Disable(GL_SCISSOR_TEST);
  gl.ColorMask(1, 1, 1, 1);
  gl.DrawBuffer(GL_FRONT);
  for (GLenum mode : {GL_PROJECTION, GL_MODELVIEW}) {
    gl.MatrixMode(mode);
    gl.LoadIdentity();
  }
}

void draw(const Gl& gl, const Step& s) {
  if (s.opens_view) open_view(gl);
  if (s.material) gl.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, s.value.data());
  gl.Begin(s.mode);
  for (int i = 0; i < 3; ++i) {
    const float x = i == 1 ? 0.9f : -0.8f, y = i == 2 ? 0.9f : -0.7f;
    if (s.color) gl.Color4f(s.value[0], s.value[1], float(i) * 0.5f, s.value[3]);
    if (s.normal) gl.Normal3f(x, y, 0.5f);
    if (s.texcoord) gl.TexCoord2f(x * 2, y);
    gl.Vertex3f(x * s.value[2], y, s.value[1] - 0.5f);
  }
  gl.End();
}

Picture picture(const std::vector<Step>& steps, bool flush) {
  const Gl& gl = softgl_library();
  Picture pixels(kSize * kSize * 4);
  void* context = gl.OSMesaCreateContextExt(kOSMesaRgba, 24, 8, 0, nullptr);
  REQUIRE(gl.OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, kSize, kSize));
  const unsigned char texels[4][4] = {{255, 0, 0, 255}, {0, 255, 0, 128}, {0, 0, 255, 64}, {255, 255, 0, 0}};
  for (GLuint name : {6u, 2u, 0u}) { // those that random commands bind
    gl.BindTexture(GL_TEXTURE_2D, name);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 1 + int(name != 6), 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  }
  for (GLenum capability : {GL_TEXTURE_2D, GL_LIGHTING, GL_LIGHT0, GL_DEPTH_TEST}) gl.Enable(capability);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  for (const Step& step : steps) {
    step.change.run(gl);
    if (flush) gl.Finish();
    draw(gl, step);
  }
  gl.Finish();
  gl.OSMesaDestroyContext(context);
  return pixels;
}

} // namespace

TEST_CASE("a snapshot that is used again draws what a new one would", "[identity][snapshot]") {
  int seen = 0;
  const Picture background = picture({}, false);
  constexpr int kSeeds = 200;
  for (int seed = 0; seed < kSeeds; ++seed) {
    Random random(uint64_t(seed) << 20); // streams of neighboring seeds overlap
    std::vector<Step> steps;
    for (int i = 0; i < 80; ++i) steps.push_back(random_step(random));
    const Picture once = picture(steps, false);
    INFO("seed " << seed);
    REQUIRE(once == picture(steps, true));
    seen += once != background;
  }
  CHECK(seen > kSeeds / 2);
}
