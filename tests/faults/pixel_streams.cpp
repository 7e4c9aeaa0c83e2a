// Pixel rectangles: drawn, copied, read, as bits, through zoom and transfer. The accumulation buffer.
#include "faults/streams.h"

namespace softgl::test {
namespace {

void rectangles(Player& p) {
  const Gl& gl = p.gl;
  std::vector<unsigned char> data(64 * 64 * 16);
  for (auto& x : data) x = static_cast<unsigned char>(p.random.integer(0, 255));
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  for (int i = 0; i < 4; ++i) {
    gl.RasterPos2f(-0.9f + 0.4f * float(i), -0.5f);
    if (i == 1) gl.PixelZoom(1.5f, -0.7f);
    if (i == 2) gl.PixelTransferf(GL_RED_SCALE, 0.5f);
    if (i == 3) {
      const float map[8] = {0, 0.1f, 0.3f, 0.2f, 0.9f, 0.5f, 1, 0.4f};
      gl.PixelMapfv(GL_PIXEL_MAP_R_TO_R, 8, map);
      gl.PixelTransferi(GL_MAP_COLOR, 1);
    }
    gl.DrawPixels(30, 20, GL_RGBA, GL_UNSIGNED_BYTE, data.data());
    gl.DrawPixels(20, 10, GL_DEPTH_COMPONENT, GL_FLOAT, data.data());
    gl.DrawPixels(20, 10, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, data.data());
    p.check();
    gl.Bitmap(60, 30, 1, 2, 3, 4, data.data());
    gl.CopyPixels(0, 0, 40, 40, GL_COLOR);
    gl.CopyPixels(0, 0, 40, 40, GL_DEPTH);
    p.check();
    gl.ReadPixels(3, 4, 50, 30, i % 2 ? GL_RGB : GL_RGBA, i < 2 ? GL_UNSIGNED_BYTE : GL_FLOAT, data.data());
    gl.ReadPixels(3, 4, 20, 10, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, data.data());
    p.check();
  }
  p.add(data.data(), data.size());
  gl.PixelZoom(1, 1);
  gl.PixelTransferf(GL_RED_SCALE, 1);
  gl.PixelTransferi(GL_MAP_COLOR, 0);
  p.picture();
}

/// In contexts that get their accumulation buffers by each of the commands that may be the first.
void accumulation(Player& p) {
  const Gl& gl = p.gl;
  for (int first = 0; first < 4; ++first) {
    void* context = p.create(nullptr, kOSMesaRgba, 24, 8, 16);
    if (!context || !p.make_current(context)) continue;
    gl.ClearColor(0.3f, 0.6f, 0.9f, 1);
    if (first == 3) gl.ClearAccum(0.1f, -0.2f, 0.3f, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_ACCUM_BUFFER_BIT);
    p.check();
    if (first == 1) gl.Accum(GL_RETURN, 1);
    if (first == 2) gl.Accum(GL_ADD, 0.2f);
    for (int i = 0; i < 3; ++i) {
      gl.Color3f(0.5f * float(i), 1, 0);
      gl.Rectf(-1, -1, 0.5f * float(i), 0.5f);
      gl.Accum(GL_ACCUM, 0.25f);
      p.check();
    }
    gl.Accum(GL_MULT, 0.9f);
    gl.Accum(GL_RETURN, 1);
    p.check();
    p.picture();
  }
  p.make_current(p.own_context());
  p.check();
}

} // namespace

const std::vector<Stream>& pixel_streams() {
  static const std::vector<Stream> streams = {{"pixels", rectangles}, {"pixels.accumulation", accumulation}};
  return streams;
}

} // namespace softgl::test
