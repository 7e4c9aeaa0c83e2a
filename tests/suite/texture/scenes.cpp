#include "texture/scenes.h"

#include <cmath>

#include "gl/subject.h"
#include "script/pixel_types.h"

namespace softgl::suite {

Test texture_test(const char* name, const char* section, const char* sentence,
                  std::function<void(Script&)> body, Need need, const char* open) {
  return {std::string("texture.") + name, section, sentence, open, std::move(body), need};
}

Memory texel_bytes(int groups, int components, int seed) {
  Memory m{GL_UNSIGNED_BYTE, {}};
  for (int i = 0; i < groups; i++)
    for (int c = 0; c < components; c++)
      m.elements.push_back((i * 73 + c * 101 + seed * 57 + i * i * 11 + 20) % 256);
  return m;
}

Memory plain_bytes(int groups, V color) {
  Memory m{GL_UNSIGNED_BYTE, {}};
  for (int i = 0; i < groups; i++) m.elements.insert(m.elements.end(), color.begin(), color.end());
  return m;
}

void image_2d(Script& s, GLenum internal_format, GLenum format, int width, int height, int level, int seed) {
  s.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  s.TexImage2D(GL_TEXTURE_2D, level, internal_format, width, height, 0, format, GL_UNSIGNED_BYTE,
               texel_bytes(width * height, components_of(format), seed));
}

void image_1d(Script& s, int width, int level, int seed) {
  s.TexImage1D(GL_TEXTURE_1D, level, GL_RGBA, width, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               texel_bytes(width, 4, seed));
}

void colored_levels(Script& s, int width, int first_level) {
  const V colors[] = {{255, 0, 0, 255},   {0, 255, 0, 255},   {0, 0, 255, 255},    {255, 255, 0, 255},
                      {0, 255, 255, 255}, {255, 0, 255, 255}, {255, 255, 255, 255}};
  for (int level = first_level; width > 0; level++, width /= 2)
    s.TexImage1D(GL_TEXTURE_1D, level, GL_RGBA, width, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 plain_bytes(width, colors[(level - first_level) % 7]));
}

void filters(Script& s, GLenum target, GLenum min_filter, GLenum mag_filter) {
  s.TexParameteri(target, GL_TEXTURE_MIN_FILTER, min_filter);
  s.TexParameteri(target, GL_TEXTURE_MAG_FILTER, mag_filter);
}

void wrap(Script& s, GLenum target, GLenum mode) {
  s.TexParameteri(target, GL_TEXTURE_WRAP_S, mode);
  if (target != GL_TEXTURE_1D) s.TexParameteri(target, GL_TEXTURE_WRAP_T, mode);
  if (target == GL_TEXTURE_3D) s.TexParameteri(target, GL_TEXTURE_WRAP_R, mode);
}

void environment(Script& s, GLenum mode) { s.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, mode); }

void replace_scene(Script& s, GLenum target) {
  filters(s, target, GL_NEAREST, GL_NEAREST), environment(s, GL_REPLACE), s.Enable(target);
  s.Color4f(0.9, 0.6, 0.3, 0.8);
  if (target == GL_TEXTURE_2D) image_2d(s);
}

void see_alpha(Script& s) { s.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), s.Enable(GL_BLEND); }

void textured_sheet(Script& s, const Range& r, double left, double bottom, double right, double top,
                    double z) {
  const auto corner = [&](bool x, bool y) {
    s.TexCoord2f(float(x ? r.s1 : r.s0), float(y ? r.t1 : r.t0));
    s.Vertex3f(float(x ? right : left), float(y ? top : bottom), float(z));
  };
  s.Begin(GL_TRIANGLES);
  corner(false, false), corner(true, false), corner(true, true);
  corner(false, false), corner(true, true), corner(false, true);
  s.End();
}

void stripes(Script& s, int width, const std::vector<double>& lods) {
  const double step = 2.0 / double(lods.size());
  for (size_t i = 0; i < lods.size(); i++) {
    const double pixels = 2 * kWindowWidth / 2.4, range = std::exp2(lods[i]) * pixels / width;
    textured_sheet(s, {0.013, 0, 0.013 + range, 0}, -1, -1 + step * double(i), 1,
                   -1 + step * (double(i) + 0.8));
  }
}

void colored_window(Script& s) {
  s.Begin(GL_TRIANGLES);
  const auto corner = [&](float x, float y) {
    s.Color4f(x > 0 ? 1.0f : 0.2f, y > 0 ? 0.9f : 0.1f, x * y > 0 ? 0.2f : 0.8f, y > 0 ? 1.0f : 0.5f);
    s.Vertex3f(x, y, 0);
  };
  corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, -1), corner(1, 1), corner(-1, 1);
  s.End();
}

void generate_r(Script& s, double along_x, double along_y) {
  s.TexGeni(GL_R, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
  s.TexGenfv(GL_R, GL_OBJECT_PLANE, V{along_x / 2, along_y / 2, 0, 0.5}), s.Enable(GL_TEXTURE_GEN_R);
}

} // namespace softgl::suite
