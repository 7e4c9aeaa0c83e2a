// From coordinates to a filtered color (3.8.7 to 3.8.9, 3.8.14), with what a correct implementation may give.
#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "expect/texture_state.h"

namespace softgl::suite {
namespace {

constexpr int kBorder = -1; // a texel that the image does not have

int modulo(int a, int n) { return (a % n + n) % n; }

// Texels beside each other in one dimension, and the weight of the second.
struct Neighbors {
  int first, second;
  double weight;
};

// Equations 3.27 and on; `u` is the coordinate in texels, not yet wrapped.
int nearest_texel(GLenum wrap, int floor_u, int size) {
  switch (wrap) {
  case GL_REPEAT: return modulo(floor_u, size);
  case GL_MIRRORED_REPEAT: {
    const int i = modulo(floor_u, 2 * size);
    return i < size ? i : 2 * size - 1 - i;
  }
  case GL_CLAMP:
  case GL_CLAMP_TO_EDGE: return std::clamp(floor_u, 0, size - 1);
  case GL_CLAMP_TO_BORDER: return floor_u < 0 || floor_u >= size ? kBorder : floor_u;
  }
  throw std::logic_error("a wrap mode that the machine does not know");
}

Neighbors linear_texels(GLenum wrap, double u, int size) {
  switch (wrap) {
  case GL_REPEAT: break;
  case GL_CLAMP: u = std::clamp(u, 0.0, double(size)); break;
  case GL_MIRRORED_REPEAT:
    u = std::fmod(u, 2.0 * size), u = u < 0 ? u + 2 * size : u, u = u > size ? 2 * size - u : u;
    u = std::clamp(u, 0.5, size - 0.5);
    break;
  case GL_CLAMP_TO_EDGE: u = std::clamp(u, 0.5, size - 0.5); break;
  case GL_CLAMP_TO_BORDER: u = std::clamp(u, -0.5, size + 0.5); break;
  }
  const int i = int(std::floor(u - 0.5));
  const double weight = u - 0.5 - i;
  if (wrap == GL_REPEAT) return {modulo(i, size), modulo(i + 1, size), weight};
  const auto bordered = [&](int k) { return k < 0 || k >= size ? kBorder : k; };
  // Both ends of an image have borders: which end it is matters for an image with texels there.
  const auto at_end = [&](int k) { return bordered(k) == kBorder && k >= size ? size : bordered(k); };
  return {at_end(i), at_end(i + 1), weight};
}

Pixel border_color(const TextureImage& image, const TextureParameters& p) {
  Pixel color;
  for (int i = 0; i < 4; i++) color.c[i] = p.border[i];
  return texel_of(image.internal_format, color);
}

Pixel fetch(const TextureImage& image, const TextureParameters& p, int x, int y, int z) {
  const auto outside = [](int i, int size) { return i < 0 || i >= size; };
  if (outside(x, image.width) || outside(y, image.height) || outside(z, image.depth))
    if (image.border == 0) return border_color(image, p);
  return image.at(x, y, z);
}

Pixel hull(const Pixel& a, const Pixel& b) {
  Pixel h;
  for (int i = 0; i < 4; i++) h.c[i] = spec::hull(a.c[i], b.c[i]);
  return h;
}

Pixel mixed(const Pixel& a, const Pixel& b, double weight) {
  if (weight == 0) return a;
  Pixel m;
  for (int i = 0; i < 4; i++)
    m.c[i] = {a.c[i].low * (1 - weight) + b.c[i].low * weight,
              a.c[i].high * (1 - weight) + b.c[i].high * weight};
  return m;
}

// The comparison of 3.8.14, with the reference r.
Pixel depth_texel(const TextureParameters& p, const Pixel& texel, Interval r) {
  Interval result = texel.c[0];
  if (p.compare_mode == GL_COMPARE_R_TO_TEXTURE) {
    r = spec::clamped(r, 0, 1);
    const Interval d = texel.c[0];
    const bool less = r.high<d.low, greater = r.low> d.high;
    if (!less && !greater && p.compare_function != GL_NEVER && p.compare_function != GL_ALWAYS)
      result = {0, 1};
    else
      switch (p.compare_function) {
      case GL_NEVER: result = 0; break;
      case GL_ALWAYS: result = 1; break;
      case GL_LESS:
      case GL_LEQUAL: result = less; break;
      case GL_GREATER:
      case GL_GEQUAL: result = greater; break;
      case GL_EQUAL: result = 0; break;
      case GL_NOTEQUAL: result = 1; break;
      default: throw std::logic_error("a comparison that the machine does not know");
      }
  }
  switch (p.depth_mode) {
  case GL_LUMINANCE: return {{result, result, result, 1}};
  case GL_INTENSITY: return {{result, result, result, result}};
  case GL_ALPHA: return {{0, 0, 0, result}};
  }
  throw std::logic_error("a depth texture mode that the machine does not know");
}

struct Sampler {
  const TextureObject& texture;
  const Interval* coordinate;

  int dimensions() const {
    return texture.target == TextureTarget::ThreeD ? 3 : texture.target == TextureTarget::OneD ? 1 : 2;
  }
  // Accuracy of the coordinate's own arithmetic.
  Interval in_texels(int axis, int size) const {
    const Interval& s = coordinate[axis];
    return spec::widened({s.low * size, s.high * size}, 4 * spec::kAccuracy * size * (1 + std::abs(s.low)));
  }

  Pixel nearest(const TextureImage& image) const {
    const TextureParameters& p = texture.parameters;
    const int sizes[3] = {image.width, image.height, image.depth};
    std::vector<int> candidates[3] = {{0}, {0}, {0}};
    for (int axis = 0; axis < dimensions(); axis++) {
      const Interval u = in_texels(axis, sizes[axis]);
      std::set<int> found;
      const int first = int(std::floor(u.low)), last = int(std::floor(u.high));
      for (int i = first; i <= std::min(last, first + sizes[axis] + 1); i++) {
        int texel = nearest_texel(p.wrap[axis], i, sizes[axis]);
        if (texel == kBorder && i >= sizes[axis]) texel = sizes[axis];
        found.insert(texel);
      }
      candidates[axis].assign(found.begin(), found.end());
    }
    bool first = true;
    Pixel result;
    for (int z : candidates[2])
      for (int y : candidates[1])
        for (int x : candidates[0]) {
          Pixel texel = fetch(image, p, x, y, z);
          if (image.base == GL_DEPTH_COMPONENT) texel = depth_texel(p, texel, coordinate[2]);
          result = first ? texel : hull(result, texel), first = false;
        }
    return result;
  }

  Pixel linear(const TextureImage& image) const {
    const TextureParameters& p = texture.parameters;
    if (image.base == GL_DEPTH_COMPONENT)
      throw std::logic_error("depths that are filtered"); // 3.8.14 leaves it open
    const int sizes[3] = {image.width, image.height, image.depth};
    std::vector<Neighbors> candidates[3] = {{{0, 0, 0}}, {{0, 0, 0}}, {{0, 0, 0}}};
    for (int axis = 0; axis < dimensions(); axis++) {
      // The weights of much hardware have 8 bits.
      const Interval u = spec::widened(in_texels(axis, sizes[axis]), 1.0 / 256);
      if (u.high - u.low > 4) throw std::logic_error("a coordinate that nobody knows");
      std::set<double> at = {u.low, u.high};
      for (double half = std::ceil(2 * u.low) / 2; half < u.high; half += 0.5) at.insert(half);
      candidates[axis].clear();
      for (double where : at) candidates[axis].push_back(linear_texels(p.wrap[axis], where, sizes[axis]));
    }
    bool first = true;
    Pixel result;
    for (const Neighbors& k : candidates[2])
      for (const Neighbors& j : candidates[1])
        for (const Neighbors& i : candidates[0]) {
          const auto row = [&](int y, int z) {
            return mixed(fetch(image, p, i.first, y, z), fetch(image, p, i.second, y, z), i.weight);
          };
          const auto plane = [&](int z) { return mixed(row(j.first, z), row(j.second, z), j.weight); };
          const Pixel color = mixed(plane(k.first), plane(k.second), k.weight);
          result = first ? color : hull(result, color), first = false;
        }
    // The result may be rounded to the texels' bits.
    for (Interval& c : result.c)
      if (c.low != c.high) c = spec::clamped(spec::widened(c, 0.5 / 255), 0, 1);
    return result;
  }

  Pixel filtered(const TextureImage& image, bool smooth) const {
    return smooth ? linear(image) : nearest(image);
  }
};

Pixel sampled_image(const TextureObject& texture, const TextureImage* images, const TexturePoint& point,
                    Interval lambda, bool magnified, bool minified) {
  const TextureParameters& p = texture.parameters;
  const Sampler sampler{texture, point.coordinate};
  const int base = p.base_level;
  Pixel result;
  bool first = true;
  const auto add = [&](const Pixel& color) { result = first ? color : hull(result, color), first = false; };
  if (magnified) add(sampler.filtered(images[base], p.mag_filter == GL_LINEAR));
  if (!minified) return result;
  if (p.min_filter == GL_NEAREST || p.min_filter == GL_LINEAR) {
    add(sampler.filtered(images[base], p.min_filter == GL_LINEAR));
    return result;
  }
  const int largest = std::max({images[base].width, images[base].height, images[base].depth});
  const int q = std::min(base + int(std::lround(std::floor(std::log2(largest)))), p.max_level);
  const bool smooth = p.min_filter == GL_LINEAR_MIPMAP_NEAREST || p.min_filter == GL_LINEAR_MIPMAP_LINEAR;
  lambda = spec::clamped(lambda, 0, q - base + 1.0);
  if (p.min_filter == GL_NEAREST_MIPMAP_NEAREST || p.min_filter == GL_LINEAR_MIPMAP_NEAREST) {
    const auto level = [&](double l) {
      return std::min(q, l <= 0.5 ? base : base + int(std::ceil(l + 0.5)) - 1);
    };
    for (int d = level(lambda.low); d <= level(lambda.high); d++) add(sampler.filtered(images[d], smooth));
    return result;
  }
  std::set<double> at = {lambda.low, lambda.high};
  for (double whole = std::ceil(lambda.low); whole < lambda.high; whole++) at.insert(whole);
  for (double l : at) {
    const int d1 = std::min(q, base + int(std::floor(l))), d2 = std::min(q, d1 + 1);
    const Pixel low = sampler.filtered(images[d1], smooth);
    add(d1 == d2 ? low : mixed(low, sampler.filtered(images[d2], smooth), l - std::floor(l)));
  }
  return result;
}

// Table 3.19: the face, and the coordinates on it.
int cube_face(const double d[3], double st[2]) {
  int axis = 0;
  for (int i = 1; i < 3; i++)
    if (std::abs(d[i]) > std::abs(d[axis])) axis = i;
  const double major = std::abs(d[axis]);
  const bool negative = d[axis] < 0;
  double sc = 0, tc = 0;
  switch (axis) {
  case 0: sc = negative ? d[2] : -d[2], tc = -d[1]; break;
  case 1: sc = d[0], tc = negative ? -d[2] : d[2]; break;
  default: sc = negative ? -d[0] : d[0], tc = -d[1]; break;
  }
  st[0] = (sc / major + 1) / 2, st[1] = (tc / major + 1) / 2;
  return 2 * axis + negative;
}

Pixel sampled_cube(const TextureObject& texture, const TexturePoint& point) {
  const TextureParameters& p = texture.parameters;
  if (p.min_filter != p.mag_filter) throw std::logic_error("levels of detail of a cube map");
  bool on_face[6] = {};
  Interval where[6][2];
  for (int corner = 0; corner < 8; corner++) {
    double d[3], st[2];
    for (int i = 0; i < 3; i++)
      d[i] = corner >> i & 1 ? point.coordinate[i].high + 1e-4 : point.coordinate[i].low - 1e-4;
    const int face = cube_face(d, st);
    for (int i = 0; i < 2; i++)
      where[face][i] = on_face[face] ? spec::hull(where[face][i], st[i]) : Interval(st[i]);
    on_face[face] = true;
  }
  bool first = true;
  Pixel result;
  for (int face = 0; face < 6; face++) {
    if (!on_face[face]) continue;
    TexturePoint flat;
    flat.coordinate[0] = where[face][0], flat.coordinate[1] = where[face][1];
    const Pixel color = sampled_image(texture, texture.images[face], flat, 0, true, false);
    result = first ? color : hull(result, color), first = false;
  }
  return result;
}

} // namespace

Pixel sampled(const TextureObject& texture, const TexturePoint& point, double lod_bias) {
  if (texture.target == TextureTarget::Cube) return sampled_cube(texture, point);
  const TextureParameters& p = texture.parameters;
  const TextureImage& base = texture.images[0][p.base_level];
  // "rho may be approximated": by all that lies between the greatest change along one axis and the sum of
  // all.
  const int sizes[3] = {base.width, base.height, base.depth};
  const int dimensions = texture.target == TextureTarget::OneD   ? 1
                         : texture.target == TextureTarget::TwoD ? 2
                                                                 : 3;
  double least = 0, most = 0;
  for (int i = 0; i < dimensions; i++) {
    least = std::max(least, point.change[i].low * sizes[i]);
    most += point.change[i].high * sizes[i];
  }
  constexpr double kLogAccuracy = 0.06;
  Interval lambda{std::log2(std::max(least, 1e-12)) + lod_bias - kLogAccuracy,
                  std::log2(std::max(most, 1e-12)) + lod_bias + kLogAccuracy};
  lambda = spec::clamped(lambda, p.min_lod, p.max_lod);
  const bool half = p.mag_filter == GL_LINEAR &&
                    (p.min_filter == GL_NEAREST_MIPMAP_NEAREST || p.min_filter == GL_NEAREST_MIPMAP_LINEAR);
  const double c = half ? 0.5 : 0;
  return sampled_image(texture, texture.images[0], point, lambda, lambda.low <= c, lambda.high > c);
}

} // namespace softgl::suite
