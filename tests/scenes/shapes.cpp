#include "scenes/shapes.h"

#include <cmath>

namespace softgl::test {

constexpr float kPi = 3.14159265f;

void camera(Stage& s, float distance) {
  const float aspect = float(s.width) / float(s.height);
  s.gl.MatrixMode(GL_PROJECTION);
  s.gl.LoadIdentity();
  s.gl.Frustum(-0.5f * aspect, 0.5f * aspect, -0.5f, 0.5f, 1, 50);
  s.gl.MatrixMode(GL_MODELVIEW);
  s.gl.LoadIdentity();
  s.gl.Translatef(0, 0, -distance);
}

void torus(Stage& s, float outer, float inner, int rings, int sides) {
  for (int i = 0; i < rings; i++) {
    s.gl.Begin(GL_TRIANGLE_STRIP);
    for (int j = 0; j <= sides; j++)
      for (int k = 0; k < 2; k++) {
        const float u = 2 * kPi * float(i + k) / float(rings), v = 2 * kPi * float(j) / float(sides);
        s.gl.Normal3f(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
        s.gl.TexCoord2f(4 * float(i + k) / float(rings), 2 * float(j) / float(sides));
        s.gl.Vertex3f((outer + inner * std::cos(v)) * std::cos(u),
                      (outer + inner * std::cos(v)) * std::sin(u), inner * std::sin(v));
      }
    s.gl.End();
  }
}

// A tube of varying radius along a plane curve in z = 0.
static void tube(Stage& s, const float (*path)[3], int points, int sides) {
  for (int i = 0; i + 1 < points; i++) {
    s.gl.Begin(GL_TRIANGLE_STRIP);
    for (int j = 0; j <= sides; j++)
      for (int k = 0; k < 2; k++) {
        const float* p = path[i + k];
        const float* a = path[i + k > 0 ? i + k - 1 : 0];
        const float* b = path[i + k + 1 < points ? i + k + 1 : points - 1];
        float dx = b[0] - a[0], dy = b[1] - a[1];
        const float length = std::sqrt(dx * dx + dy * dy);
        dx /= length, dy /= length;
        const float v = 2 * kPi * float(j) / float(sides), c = std::cos(v), z = std::sin(v);
        s.gl.Normal3f(-dy * c, dx * c, z);
        s.gl.Vertex3f(p[0] - dy * c * p[2], p[1] + dx * c * p[2], z * p[2]);
      }
    s.gl.End();
  }
}

void teapot(Stage& s, int slices) {
  static constexpr float kProfile[][2] = {{0.0f, -0.75f}, {0.75f, -0.72f}, {0.95f, -0.45f}, {1.0f, -0.15f},
                                          {0.92f, 0.15f}, {0.75f, 0.38f},  {0.7f, 0.45f},   {0.6f, 0.52f},
                                          {0.35f, 0.62f}, {0.12f, 0.68f},  {0.09f, 0.76f},  {0.14f, 0.84f},
                                          {0.1f, 0.92f},  {0.0f, 0.95f}};
  constexpr int kPoints = int(sizeof kProfile / sizeof *kProfile);
  for (int i = 0; i + 1 < kPoints; i++) {
    s.gl.Begin(GL_TRIANGLE_STRIP);
    for (int j = 0; j <= slices; j++)
      for (int k = 1; k >= 0; k--) {
        const float* p = kProfile[i + k];
        const float* a = kProfile[i + k > 0 ? i + k - 1 : 0];
        const float* b = kProfile[i + k + 1 < kPoints ? i + k + 1 : kPoints - 1];
        const float dr = b[0] - a[0], dy = b[1] - a[1], u = 2 * kPi * float(j) / float(slices);
        s.gl.Normal3f(dy * std::cos(u), -dr, -dy * std::sin(u));
        s.gl.Vertex3f(p[0] * std::cos(u), p[1], -p[0] * std::sin(u));
      }
    s.gl.End();
  }
  static constexpr float kSpout[][3] = {{0.8f, -0.35f, 0.22f},
                                        {1.1f, -0.2f, 0.16f},
                                        {1.3f, 0.1f, 0.11f},
                                        {1.45f, 0.4f, 0.09f},
                                        {1.62f, 0.5f, 0.1f}};
  static constexpr float kHandle[][3] = {{-0.85f, 0.3f, 0.08f},  {-1.25f, 0.38f, 0.08f},
                                         {-1.5f, 0.2f, 0.08f},   {-1.45f, -0.15f, 0.08f},
                                         {-1.2f, -0.35f, 0.08f}, {-0.9f, -0.45f, 0.08f}};
  tube(s, kSpout, 5, slices / 2);
  tube(s, kHandle, 6, slices / 2);
}

void cube(Stage& s, float h) {
  static constexpr int kFace[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 2, 0}, {1, 0, 2}, {2, 0, 1}, {2, 1, 0}};
  for (int f = 0; f < 6; f++) {
    const float side = f & 1 ? -1.0f : 1.0f;
    Float3 normal{0, 0, 0};
    normal[size_t(kFace[f][0])] = side;
    s.gl.Begin(GL_TRIANGLE_STRIP);
    s.gl.Normal3fv(normal.data());
    for (int i = 0; i < 4; i++) {
      Float3 p{};
      p[size_t(kFace[f][0])] = side * h;
      p[size_t(kFace[f][1])] = (i & 1 ? h : -h) * (f & 1 ? 1.0f : 1.0f);
      p[size_t(kFace[f][2])] = i & 2 ? h : -h;
      s.gl.TexCoord2f(float(i & 1), float(i >> 1));
      s.gl.Vertex3fv(p.data());
    }
    s.gl.End();
  }
}

void two_sided_bowl(Stage& s) {
  const Gl& gl = s.gl;
  const GLfloat back[4] = {0.8f, 0.5f, 0.1f, 1}, white[4] = {1, 1, 1, 1}, position[4] = {1, 2, 3, 1};
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  camera(s, 3.5f);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
  gl.Materialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, back);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, white);
  gl.Materialf(GL_FRONT, GL_SHININESS, 20);
  gl.Materialf(GL_BACK, GL_SHININESS, 90);
  const GLdouble plane[4] = {0.3, 1, 0.5, 0};
  gl.ClipPlane(GL_CLIP_PLANE0, plane);
  gl.Enable(GL_CLIP_PLANE0);
}

void checker_texture(Stage& s, int size, bool mipmaps) {
  GLuint name = 0;
  s.gl.GenTextures(1, &name);
  s.gl.BindTexture(GL_TEXTURE_2D, name);
  for (int level = 0, n = size; n >= 1; level++, n /= 2) {
    std::vector<uint8_t> texels(size_t(n) * size_t(n) * 4);
    for (int y = 0; y < n; y++)
      for (int x = 0; x < n; x++) {
        uint8_t* t = &texels[size_t(y * n + x) * 4];
        const bool odd = ((x * 8 / n) ^ (y * 8 / n)) & 1;
        t[0] = odd ? 250 : 60, t[1] = odd ? 220 : uint8_t(90 + x * 100 / n), t[2] = uint8_t(80 + y * 150 / n),
        t[3] = odd ? 255 : 128;
      }
    s.gl.TexImage2D(GL_TEXTURE_2D, level, GL_RGBA, n, n, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    if (!mipmaps) break;
  }
  s.gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, mipmaps ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
  s.gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  s.gl.Enable(GL_TEXTURE_2D);
}

} // namespace softgl::test
