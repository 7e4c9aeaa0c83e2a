// Textures with a border (GL 1.5, 3.8.1, 3.8.2, 3.8.7, 3.8.8), which SOFTGL_ANSWERS=specification keeps.
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "spec/specification_context.h"

namespace softgl::test {
namespace {

constexpr int kSize = SpecificationContext::kSize;

/// A texture of 1 to 3 dimensions with a border, its texels, and what the equations of 3.8.7 and 3.8.8 make
/// of them.
struct Texture {
  GLenum target;
  int dimensions;
  std::array<int, 3> size; // without the border
  std::vector<GLubyte> texels;

  Texture(GLenum target_, int dimensions_, std::array<int, 3> size_)
      : target(target_), dimensions(dimensions_), size(size_) {
    for (int a = dimensions; a < 3; ++a) size[size_t(a)] = 1;
    texels.resize(size_t(outer(0) * outer(1) * outer(2)));
    for (size_t i = 0; i < texels.size(); ++i) texels[i] = GLubyte(37 * i * i + 101 * i + 13);
  }
  int border(int axis) const { return axis < dimensions; }
  int outer(int axis) const { return size[size_t(axis)] + 2 * border(axis); }
  double texel(int i, int j, int k) const {
    const std::array<int, 3> at = {i, j, k};
    for (int a = 0; a < dimensions; ++a)
      if (at[size_t(a)] < -1 || at[size_t(a)] > size[size_t(a)]) return 0; // the border color
    return texels[size_t(((k + border(2)) * outer(1) + j + border(1)) * outer(0) + i + border(0))];
  }

  void specify(const Gl& gl, GLint level = 0, GLint format = GL_LUMINANCE8) const {
    const GLenum f = format == GL_DEPTH_COMPONENT24 ? GL_DEPTH_COMPONENT : GL_LUMINANCE, t = GL_UNSIGNED_BYTE;
    const auto face = [&](GLenum of) {
      if (dimensions == 1)
        gl.TexImage1D(of, level, format, outer(0), 1, f, t, texels.data());
      else if (dimensions == 2)
        gl.TexImage2D(of, level, format, outer(0), outer(1), 1, f, t, texels.data());
      else
        gl.TexImage3D(of, level, format, outer(0), outer(1), outer(2), 1, f, t, texels.data());
    };
    if (target == GL_TEXTURE_CUBE_MAP)
      for (GLenum i = 0; i < 6; ++i) face(GL_TEXTURE_CUBE_MAP_POSITIVE_X + i);
    else
      face(target);
  }

  static double wrapped(GLenum wrap, double s, int n) {
    switch (wrap) {
    case GL_REPEAT: return s - std::floor(s);
    case GL_CLAMP: return std::clamp(s, 0.0, 1.0);
    case GL_CLAMP_TO_EDGE: return std::clamp(s, 0.5 / n, 1 - 0.5 / n);
    case GL_CLAMP_TO_BORDER: return std::clamp(s, -0.5 / n, 1 + 0.5 / n);
    default: {
      const double whole = std::floor(s), part = s - whole;
      return std::clamp(std::fmod(whole, 2) == 0 ? part : 1 - part, 0.5 / n, 1 - 0.5 / n);
    }
    }
  }
  double sample(std::array<double, 3> s, GLenum wrap, bool linear) const {
    std::array<int, 3> low{}, high{};
    std::array<double, 3> weight{};
    for (size_t a = 0; a < size_t(dimensions); ++a) {
      const int n = size[a];
      const double w = wrapped(wrap, s[a], n), u = w * n;
      if (!linear) {
        low[a] = high[a] = w == 1 ? n - 1 : int(std::floor(u));
        continue;
      }
      low[a] = int(std::floor(u - 0.5)), high[a] = low[a] + 1, weight[a] = u - 0.5 - low[a];
      if (wrap == GL_REPEAT) low[a] = (low[a] + n) % n, high[a] = (low[a] + 1) % n;
    }
    double sum = 0;
    for (int c = 0; c < 8; ++c) {
      const auto pick = [&](size_t a) { return c >> a & 1 ? high[a] : low[a]; };
      double product = 1;
      for (size_t a = 0; a < 3; ++a) product *= c >> a & 1 ? weight[a] : 1 - weight[a];
      if (product != 0) sum += product * texel(pick(0), pick(1), pick(2));
    }
    return sum;
  }
};

void set(const Gl& gl, GLenum target, GLenum wrap, GLenum filter) {
  for (GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    gl.TexParameteri(target, axis, GLint(wrap));
  gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, GLint(filter));
  gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, filter == GL_LINEAR ? GL_LINEAR : GL_NEAREST);
}

/// A square over the window, with coordinates from `low` to `high` and r.
std::vector<GLubyte> draw(const SpecificationContext& context, double low, double high, double r) {
  const Gl& gl = context.gl;
  gl.Begin(GL_QUADS);
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
    gl.TexCoord3d(x ? high : low, y ? high : low, r);
    gl.Vertex2f(x ? 1.0f : -1.0f, y ? 1.0f : -1.0f);
  }
  gl.End();
  return context.red();
}

/// The coordinate at a pixel's center.
double coordinate(int pixel, double low, double high) { return low + (high - low) * (pixel + 0.5) / kSize; }

} // namespace

TEST_CASE("texels of the border are sampled as the equations say", "[spec][answers]") {
  const Texture textures[] = {{GL_TEXTURE_1D, 1, {4, 1, 1}},
                              {GL_TEXTURE_2D, 2, {4, 8, 1}},
                              {GL_TEXTURE_3D, 3, {4, 2, 4}},
                              {GL_TEXTURE_2D, 2, {3, 5, 1}}};
  for (const Texture& texture : textures)
    for (const GLint format : {GL_LUMINANCE8, GL_LUMINANCE16, GL_LUMINANCE32F_ARB, GL_DEPTH_COMPONENT24}) {
      if (format == GL_DEPTH_COMPONENT24 && texture.dimensions == 3) continue;
      const SpecificationContext context;
      const Gl& gl = context.gl;
      texture.specify(gl, 0, format);
      gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
      gl.Enable(texture.target);
      for (const GLenum wrap :
           {GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT})
        for (const GLenum filter : {GL_NEAREST, GL_LINEAR})
          for (const double r : {-0.3, 0.1, 0.6, 1.3}) {
            if (texture.dimensions < 3 && r > 0) continue;
            INFO("target " << texture.target << ", size " << texture.size[0] << ", format " << format
                           << ", wrap " << wrap << ", filter " << filter << ", r " << r);
            set(gl, texture.target, wrap, filter);
            const double low = -0.503, high = 1.497;
            const auto red = draw(context, low, high, r);
            int wrong = 0;
            for (int y = 0; y < kSize; y += 3)
              for (int x = 0; x < kSize; ++x) {
                const double expected = texture.sample(
                    {coordinate(x, low, high), coordinate(y, low, high), r}, wrap, filter == GL_LINEAR);
                wrong += std::abs(red[size_t(y * kSize + x)] - expected) > 2;
              }
            CHECK(wrong == 0);
          }
    }
}

TEST_CASE("the border of a cube map's face is sampled where the wrap mode says so", "[spec][answers]") {
  const SpecificationContext context;
  const Gl& gl = context.gl;
  const Texture texture(GL_TEXTURE_CUBE_MAP, 2, {4, 4, 1});
  texture.specify(gl);
  gl.Enable(GL_TEXTURE_CUBE_MAP);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  for (const GLenum wrap : {GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_REPEAT}) {
    INFO("wrap " << wrap);
    set(gl, GL_TEXTURE_CUBE_MAP, wrap, GL_LINEAR);
    const auto red = draw(context, -1, 1, 1); // the face of +z: s is (x + 1) / 2, t is (1 - y) / 2
    int wrong = 0;
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        const double s = (coordinate(x, -1, 1) + 1) / 2, t = (1 - coordinate(y, -1, 1)) / 2;
        wrong += std::abs(red[size_t(y * kSize + x)] - texture.sample({s, t, 0}, wrap, true)) > 2;
      }
    CHECK(wrong == 0);
  }
}

TEST_CASE("every level has a border, those of one texture the same", "[spec][answers]") {
  const SpecificationContext context;
  const Gl& gl = context.gl;
  const Texture levels[] = {
      {GL_TEXTURE_2D, 2, {4, 4, 1}}, {GL_TEXTURE_2D, 2, {2, 2, 1}}, {GL_TEXTURE_2D, 2, {1, 1, 1}}};
  for (int i = 0; i < 3; ++i) levels[i].specify(gl, i);
  gl.Enable(GL_TEXTURE_2D);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  set(gl, GL_TEXTURE_2D, GL_CLAMP, GL_LINEAR_MIPMAP_NEAREST);
  for (int level = 0; level < 3; ++level) {
    INFO("level " << level);
    gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, float(level) + 0.1f);
    gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_LOD, float(level) + 0.1f);
    const auto red = draw(context, 0, 1, 0);
    CHECK(std::abs(red[0] - levels[level].sample({0.5 / kSize, 0.5 / kSize, 0}, GL_CLAMP, true)) <= 2);
  }
  // A level without one: the texture is not complete, so the color is the vertices'.
  const GLubyte dark[4] = {};
  gl.TexImage2D(GL_TEXTURE_2D, 1, GL_LUMINANCE8, 2, 2, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, dark);
  CHECK(int(draw(context, 0, 1, 0)[0]) == 255);
}

TEST_CASE("derived levels have the border of the base level", "[spec][answers]") {
  for (const GLint format : {GL_LUMINANCE8, GL_LUMINANCE16, GL_LUMINANCE32F_ARB}) {
    INFO("format " << format);
    const SpecificationContext context;
    const Gl& gl = context.gl;
    gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    const Texture base(GL_TEXTURE_2D, 2, {4, 2, 1});
    base.specify(gl, 0, format);
    GLint width = 0, height = 0, border = 0;
    gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 1, GL_TEXTURE_WIDTH, &width);
    gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 1, GL_TEXTURE_HEIGHT, &height);
    gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 1, GL_TEXTURE_BORDER, &border);
    CHECK(width == 4);
    CHECK(height == 3);
    CHECK(border == 1);
    std::array<GLubyte, 12> level{};
    gl.GetTexImage(GL_TEXTURE_2D, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, level.data());
    const auto near = [&](size_t i, double expected) { CHECK(std::abs(level[i] - expected) <= 1); };
    near(0, base.texel(-1, -1, 0));
    near(1, (base.texel(0, -1, 0) + base.texel(1, -1, 0)) / 2);
    near(3, base.texel(4, -1, 0));
    near(4, (base.texel(-1, 0, 0) + base.texel(-1, 1, 0)) / 2);
    near(11, base.texel(4, 2, 0));
    near(5, (base.texel(0, 0, 0) + base.texel(1, 0, 0) + base.texel(0, 1, 0) + base.texel(1, 1, 0)) / 4);
  }
}

TEST_CASE("parts of an image may lie in its border, and it is read with it", "[spec][answers]") {
  const SpecificationContext context;
  const Gl& gl = context.gl;
  const Texture texture(GL_TEXTURE_3D, 3, {2, 3, 1});
  texture.specify(gl);
  std::vector<GLubyte> read(texture.texels.size());
  gl.GetTexImage(GL_TEXTURE_3D, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, read.data());
  CHECK(read == texture.texels);
  const GLubyte part[2] = {1, 2};
  gl.TexSubImage3D(GL_TEXTURE_3D, 0, -1, 3, 1, 2, 1, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, part);
  CHECK(gl.GetError() == GL_NO_ERROR);
  std::vector<GLubyte> expected = texture.texels;
  expected[size_t((2 * 5 + 4) * 4)] = 1, expected[size_t((2 * 5 + 4) * 4 + 1)] = 2;
  gl.GetTexImage(GL_TEXTURE_3D, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, read.data());
  CHECK(read == expected);
  gl.TexSubImage3D(GL_TEXTURE_3D, 0, -2, 0, 0, 1, 1, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, part);
  CHECK(gl.GetError() == GL_INVALID_VALUE);
  gl.TexSubImage3D(GL_TEXTURE_3D, 0, 2, 0, 0, 2, 1, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, part);
  CHECK(gl.GetError() == GL_INVALID_VALUE);
  gl.TexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, -2, 1, 1, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, part);
  CHECK(gl.GetError() == GL_INVALID_VALUE);
}

TEST_CASE("a border can be copied from the window", "[spec][answers]") {
  const SpecificationContext context;
  const Gl& gl = context.gl;
  std::vector<GLubyte> image(8 * 8);
  for (size_t i = 0; i < image.size(); ++i) image[i] = GLubyte(3 * i + 1);
  gl.WindowPos2i(0, 0);
  gl.DrawPixels(8, 8, GL_LUMINANCE, GL_UNSIGNED_BYTE, image.data());
  gl.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE8, 1, 2, 6, 4, 1);
  std::array<GLubyte, 24> read{};
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, read.data());
  std::array<GLubyte, 24> expected{};
  for (size_t i = 0; i < 24; ++i) expected[i] = image[(2 + i / 6) * 8 + 1 + i % 6];
  CHECK(read == expected);
  gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, -1, -1, 0, 0, 2, 1);
  expected[0] = image[0], expected[1] = image[1];
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, read.data());
  CHECK(read == expected);
  gl.CopyTexImage1D(GL_TEXTURE_1D, 0, GL_LUMINANCE8, 0, 0, 6, 1);
  GLint width = 0;
  gl.GetTexLevelParameteriv(GL_TEXTURE_1D, 0, GL_TEXTURE_WIDTH, &width);
  CHECK(width == 6);
}

TEST_CASE("an image that is only border holds nothing", "[spec][answers]") {
  for (const int specification : {0, 1}) {
    const SpecificationContext context(specification != 0);
    const Gl& gl = context.gl;
    const std::array<GLubyte, 4> texels = {1, 2, 3, 4};
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE8, 2, 2, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels.data());
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, specification ? -1 : 0, 0, specification, 0, GL_LUMINANCE,
                     GL_UNSIGNED_BYTE, texels.data());
    gl.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE8, 0, 0, 2, 2, 1);
    std::array<GLubyte, 4> read = {9, 9, 9, 9};
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, read.data());
    CHECK(int(read[0]) == 9);
  }
}

TEST_CASE("an image with a border can be drawn to, inside of the border", "[spec][answers]") {
  const SpecificationContext context;
  const Gl& gl = context.gl;
  const Texture texture(GL_TEXTURE_2D, 2, {4, 4, 1});
  GLuint framebuffer = 0;
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(GL_TEXTURE_2D, name);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 6, 6, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, texture.texels.data());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, name, 0);
  REQUIRE(gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
  gl.Viewport(0, 0, 4, 4);
  gl.Scissor(1, 1, 1, 1);
  gl.Enable(GL_SCISSOR_TEST);
  gl.ClearColor(1, 1, 1, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  std::vector<GLubyte> read(36 * 4), expected = texture.texels;
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
  expected[2 * 6 + 2] = 255;
  for (size_t i = 0; i < 36; ++i) CHECK(read[4 * i] == expected[i]);
  gl.DeleteFramebuffers(1, &framebuffer);
}

} // namespace softgl::test
