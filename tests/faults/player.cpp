#include "faults/player.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace softgl::test {

Player::Player(const Gl& library, uint64_t seed) : gl(library), random(seed), seed_(seed) {
  if (!create() || !make_current(own_context())) throw std::runtime_error("no context");
  restart();
  save_state();
}

Player::~Player() {
  make_none_current();
  while (!contexts_.empty()) destroy(contexts_.back()->handle);
}

void* Player::create(void* shared, GLenum format, int depth, int stencil, int accumulation) {
  void* handle = gl.OSMesaCreateContextExt(format, depth, stencil, accumulation, shared);
  if (handle)
    contexts_.push_back(std::make_unique<Context>(Context{handle}));
  else
    refuse();
  return handle;
}

bool Player::make_current(void* handle, int width, int height, GLenum type) {
  const auto found =
      std::find_if(contexts_.begin(), contexts_.end(), [&](auto& c) { return c->handle == handle; });
  if (found == contexts_.end()) return false;
  // The buffer of before must stay: the library writes it when the context leaves the thread.
  std::vector<unsigned char> buffer(size_t(width) * size_t(height) * 16);
  if (!gl.OSMesaMakeCurrent(handle, buffer.data(), type, width, height)) {
    refuse();
    return false;
  }
  (*found)->buffer = std::move(buffer);
  return true;
}

bool Player::make_none_current() { return gl.OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }

void Player::destroy(void* handle) {
  gl.OSMesaDestroyContext(handle);
  std::erase_if(contexts_, [&](auto& c) { return c->handle == handle; });
}

void Player::check() {
  for (int i = 0; i < 10; ++i) {
    const GLenum error = gl.GetError();
    if (error == GL_NO_ERROR) return;
    if (error == GL_OUT_OF_MEMORY)
      out_of_memory_ = true;
    else
      add(error);
  }
}

void Player::picture() {
  gl.Finish();
  check();
  for (auto& c : contexts_)
    if (c->handle == gl.OSMesaGetCurrentContext()) add(c->buffer.data(), c->buffer.size());
}

void Player::add(const void* data, size_t bytes) {
  const auto* p = static_cast<const unsigned char*>(data);
  for (size_t i = 0; i < bytes; i += 8) {
    uint64_t word = 0;
    std::memcpy(&word, p + i, std::min<size_t>(8, bytes - i));
    result_ = (result_ ^ word) * 0x9e3779b97f4a7c15u;
    result_ ^= result_ >> 29;
  }
}

void Player::save_state() {
  // Several times: a stream whose push found no memory pops one of these.
  for (int i = 0; i < 5; ++i) {
    gl.PushAttrib(GL_ALL_ATTRIB_BITS);
    gl.PushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
  }
  if (gl.GetError() != GL_NO_ERROR) throw std::runtime_error("the state cannot be saved");
}

void Player::restore() {
  if (!make_current(own_context())) throw std::runtime_error("the context cannot be made current again");
  gl.End();
  gl.EndList();
  gl.EndQuery(GL_SAMPLES_PASSED);
  gl.RenderMode(GL_RENDER);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.BindRenderbuffer(GL_RENDERBUFFER, 0);
  GLint depth = 0, mode = 0;
  for (gl.GetIntegerv(GL_ATTRIB_STACK_DEPTH, &depth); depth > 0; --depth) gl.PopAttrib();
  for (gl.GetIntegerv(GL_CLIENT_ATTRIB_STACK_DEPTH, &depth); depth > 0; --depth) gl.PopClientAttrib();
  static constexpr struct {
    GLenum mode, depth;
  } kStacks[] = {{GL_MODELVIEW, GL_MODELVIEW_STACK_DEPTH},
                 {GL_PROJECTION, GL_PROJECTION_STACK_DEPTH},
                 {GL_TEXTURE, GL_TEXTURE_STACK_DEPTH}};
  gl.GetIntegerv(GL_MATRIX_MODE, &mode);
  for (int unit = 7; unit >= 0; --unit) {
    gl.ActiveTexture(GL_TEXTURE0 + GLenum(unit));
    for (const auto& stack : kStacks) {
      gl.MatrixMode(stack.mode);
      for (gl.GetIntegerv(stack.depth, &depth); depth > 1; --depth) gl.PopMatrix();
      gl.LoadIdentity();
    }
  }
  gl.MatrixMode(GLenum(mode));
  for (int i = 0; i < 10 && gl.GetError() != GL_NO_ERROR; ++i) {}
  save_state();
}

void Player::restart() {
  random = Random(seed_);
  result_ = 0xcbf29ce484222325u;
  out_of_memory_ = disorderly_ = false;
}

// --- The reference frame
// --------------------------------------------------------------------------------------------

namespace {

void draw_textured_square(const Gl& gl) {
  static constexpr float kSquare[4][5] = {{-0.9f, -0.9f, 0, 0, 0.4f},
                                          {-0.1f, -0.9f, 3, 0, 0.4f},
                                          {-0.1f, -0.1f, 3, 3, -0.6f},
                                          {-0.9f, -0.1f, 0, 3, 0.6f}};
  gl.Begin(GL_QUADS);
  for (const float* v : kSquare) {
    gl.Color3f(v[2] / 3, 0.8f, v[3] / 3);
    gl.TexCoord2f(v[2], v[3]);
    gl.Vertex3f(v[0], v[1], v[4]);
  }
  gl.End();
}

void draw_lit_ball(const Gl& gl) {
  for (int j = 0; j < 8; ++j) {
    gl.Begin(GL_TRIANGLE_STRIP);
    for (int i = 0; i <= 12; ++i)
      for (int k = 0; k < 2; ++k) {
        const float v = 3.1415927f * float(j + k) / 8, u = 6.2831853f * float(i % 12) / 12;
        const Float3 n{std::sin(v) * std::cos(u), std::sin(v) * std::sin(u), std::cos(v)};
        gl.Normal3fv(n.data());
        gl.Vertex3f(n[0] * 0.4f + 0.5f, n[1] * 0.4f + 0.5f, n[2] * 0.4f);
      }
    gl.End();
  }
}

} // namespace

uint64_t draw_reference_frame(Player& player) {
  const Gl& gl = player.gl;
  player.restart();
  const auto stage = [&](const char* name) {
    if (const GLenum error = gl.GetError(); error != GL_NO_ERROR) {
      char text[100];
      std::snprintf(text, sizeof text, "the next frame raises error 0x%04x (%s)", error, name);
      throw std::runtime_error(text);
    }
  };
  stage("before it");
  gl.ClearColor(0.1f, 0.2f, 0.3f, 1);
  gl.ClearStencil(1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  gl.Enable(GL_DEPTH_TEST);
  stage("Clear");

  GLuint texture = 0, buffers[2] = {};
  unsigned char texels[16][16][4];
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x)
      for (int k = 0; k < 4; ++k)
        texels[y][x][k] = static_cast<unsigned char>(x * 16 * (k != 1) + y * 15 * (k != 0));
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  for (int level = 0; level < 5; ++level)
    gl.TexImage2D(GL_TEXTURE_2D, level, GL_RGBA, 16 >> level, 16 >> level, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  texels);
  gl.Enable(GL_TEXTURE_2D);
  draw_textured_square(gl);
  gl.Disable(GL_TEXTURE_2D);
  stage("texture");

  const GLuint list = gl.GenLists(1);
  gl.NewList(list, GL_COMPILE);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  draw_lit_ball(gl);
  gl.Disable(GL_LIGHTING);
  gl.EndList();
  for (int i = 0; i < 3; ++i) {
    gl.CallList(list);
    gl.Translatef(-0.3f, 0.1f, 0.1f);
  }
  gl.LoadIdentity();
  stage("list");

  static constexpr float kVertices[6][6] = {{0.1f, -0.9f, 0, 1, 0, 0}, {0.9f, -0.9f, 0, 0, 1, 0},
                                            {0.9f, -0.5f, 0, 0, 0, 1}, {0.1f, -0.5f, 0, 1, 1, 0},
                                            {0.9f, -0.1f, 0, 1, 0, 1}, {0.1f, -0.1f, 0, 0, 1, 1}};
  static constexpr GLushort kIndices[12] = {0, 1, 2, 0, 2, 3, 3, 2, 4, 3, 4, 5};
  gl.GenBuffers(2, buffers);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof kVertices, kVertices, GL_STATIC_DRAW);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof kIndices, kIndices, GL_STATIC_DRAW);
  gl.VertexPointer(3, GL_FLOAT, sizeof kVertices[0], nullptr);
  gl.ColorPointer(3, GL_FLOAT, sizeof kVertices[0], reinterpret_cast<void*>(12));
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_COLOR_ARRAY);
  gl.DrawElements(GL_TRIANGLES, 12, GL_UNSIGNED_SHORT, nullptr);
  gl.DisableClientState(GL_COLOR_ARRAY);
  gl.DisableClientState(GL_VERTEX_ARRAY);
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  gl.DeleteBuffers(2, buffers);
  stage("arrays");

  gl.RasterPos2f(-0.9f, 0.4f);
  gl.DrawPixels(16, 16, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  stage("DrawPixels");
  player.picture();
  unsigned char pixels[Player::kWidth * Player::kHeight * 4];
  float depths[Player::kWidth * Player::kHeight];
  gl.ReadPixels(0, 0, Player::kWidth, Player::kHeight, GL_BGRA, GL_UNSIGNED_BYTE, pixels);
  gl.ReadPixels(0, 0, Player::kWidth, Player::kHeight, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
  player.add(pixels, sizeof pixels);
  player.add(depths, sizeof depths);
  gl.DeleteLists(list, 1);
  gl.DeleteTextures(1, &texture);
  stage("ReadPixels");
  const uint64_t hash = player.result();
  player.restore();
  return hash;
}

} // namespace softgl::test
