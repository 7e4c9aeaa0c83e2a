#include "snapshot/snapshot_difference.h"

#include <bit>
#include <cstring>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "shaders/texture/combiner_program.h"
#include "shaders/texture/texture_constants.h"

namespace softgl {
namespace {

/// The members of a type and their names. Does not compile unless all of them are there.
#define MEMBERS(Type, ...) \
  auto members(const Type& snapshot) { \
    const auto& [__VA_ARGS__] = snapshot; \
    return std::tie(__VA_ARGS__); \
  } \
  constexpr std::string_view member_names(const Type&) { return #__VA_ARGS__; }

MEMBERS(TextureLevel, face, width, height, depth, row, slice)
MEMBERS(TextureUnitConstants, level, last_level, shape, texel, wrap, counts_texels, bordered, min_linear,
        mag_linear, seamless, no_alpha, mip, adjusts_lod, constant_lod, has_min_lod, has_max_lod, lod_bias,
        min_lod, max_lod, magnified_lod, magnified_rho, anisotropic, first_level, zero_width, zero_height,
        border, shift, scale, compares, compare_function, depth_components, color)
MEMBERS(CombinerStep, operation, result, a, b)
MEMBERS(CombinerProgram, step_count, result, constant, step)
MEMBERS(FragmentConstants, fog_color, fog_scale, fog_offset, alpha_reference, alpha_reference_8, blend_color,
        blend_color_8, encoding, blend_equation, stencil_reference, stencil_value_mask, stencil_write_mask,
        least_depth, greatest_depth, least_bound, greatest_bound, lighting, texture, combiner, image)
MEMBERS(FragmentStep, stage, unit)
MEMBERS(FragmentProgram, key, constants, step_count, step, r_units, lod_units, cube_units, writes_depth,
        writes_stencil, bounds_depth, reads_quads, coverage)
MEMBERS(SmoothPrograms, point, line, polygon)
MEMBERS(RasterConstants, x0, y0, x1, y1, cull, back, flat, two_sided, offset, point_sprite, sprite_units,
        sprite_lower_left, top_edge_rule, per_sample, sample_mask, alpha_to_coverage, alpha_to_one, samples,
        pixel_center, to_first_pixel, edge_shift, offset_floats, offset_units, offset_factor, line_width,
        point_size, stipple)
MEMBERS(TransformConstants, mvp, modelview, normal_matrix, normal_scale, window_scale, window_offset)
MEMBERS(ClipPlaneConstants, count, index, plane)
MEMBERS(CoordinateConstants, mode, transform, plane, matrix)
MEMBERS(PointConstants, size, minimum, maximum, attenuation)
MEMBERS(PolygonConstants, mode, ccw_is_front, cull_front, cull_back, two_sided, offset, whole)
MEMBERS(VertexProgram, eye_position, eye_position_late, eye_unit, normal, normal_to_eye, normalize,
        unit_normal, lit, fog, fog_from_attribute, fog_distance, depth_clamp, depths_from_zero, clamp_colors,
        point_attenuated, from_eye, signed_fog, transform, clip_planes, lighting, coordinates, reflection_z,
        point, polygons, line_stipple, stipple_pattern, stipple_factor)
MEMBERS(ShadedLayout, color, secondary, back_color, back_secondary, point, texcoord, normal, eye, tracked,
        material, slots)
MEMBERS(LightConstants, positional, attenuated, spot, position, half_vector, attenuation, spot_direction,
        spot_cosine, spot_exponent, ambient, diffuse, specular, ambient_product, diffuse_product,
        specular_product)
MEMBERS(LightingConstants, two_sided, separate_specular, local_viewer, shininess_zero, varies, reflection,
        for_fragments, zero_powers, light_count, model_ambient, material, material_source, scene, light)
#undef MEMBERS

std::string_view nth_name(std::string_view names, size_t n) {
  for (; n > 0; --n) names.remove_prefix(names.find(',') + 2);
  return names.substr(0, names.find(','));
}

template <class T>
concept HasMembers = requires(const T& t) {
  members(t);
};

/// Compares; where something differs, `way` leads to the first member that does, from its end to its
/// beginning.
struct Comparison {
  std::vector<std::string> way;

  template <class T> bool same(const T& a, const T& b) {
    if constexpr (std::is_pointer_v<T>) {
      using Target = std::remove_const_t<std::remove_pointer_t<T>>;
      if constexpr (HasMembers<Target>)
        return a == b || (a && b && same(*a, *b));
      else if constexpr (std::is_same_v<Target, uint64_t>) // RasterConstants::stipple
        return a == b || (a && b && same_range(a, b, 16));
      else
        return a == b;
    } else if constexpr (HasMembers<T>) {
      return same_members(a, b, std::make_index_sequence<std::tuple_size_v<decltype(members(a))>>());
    } else if constexpr (std::is_same_v<T, float>) {
      return std::bit_cast<uint32_t>(a) == std::bit_cast<uint32_t>(b);
    } else if constexpr (std::is_same_v<T, FragmentKey>) {
      return std::bit_cast<uint64_t>(a) == std::bit_cast<uint64_t>(b);
    } else {
      return a == b;
    }
  }
  template <class T, size_t N> bool same(const T (&a)[N], const T (&b)[N]) { return same_range(a, b, N); }

  /// Only the enabled lights have memory, and of each only what is read was set.
  bool same(const LightingConstants& a, const LightingConstants& b) {
    const auto lights_alike = [&](const LightConstants& x, const LightConstants& y) {
      return same(read_members(x, a.two_sided), read_members(y, b.two_sided));
    };
    constexpr size_t kLights = std::tuple_size_v<decltype(members(a))> - 1; // the last member
    if (!same_members(a, b, std::make_index_sequence<kLights>())) return false;
    for (int i = 0; i < a.light_count; ++i)
      if (!lights_alike(a.light[i], b.light[i])) return found_at(size_t(i)), found("light");
    return true;
  }

private:
  bool found(std::string_view name) {
    way.emplace_back(name);
    return false;
  }
  bool found_at(size_t index) {
    std::string name = "[";
    name += std::to_string(index);
    name += ']';
    return found(name);
  }
  template <class T> bool same_range(const T* a, const T* b, size_t count) {
    for (size_t i = 0; i < count; ++i)
      if (!same(a[i], b[i])) return found_at(i);
    return true;
  }
  template <class T, size_t... kIndex>
  bool same_members(const T& a, const T& b, std::index_sequence<kIndex...>) {
    const auto x = members(a), y = members(b);
    return ((same(std::get<kIndex>(x), std::get<kIndex>(y)) || found(nth_name(member_names(a), kIndex))) &&
            ...);
  }
  static LightConstants read_members(LightConstants l, bool two_sided) {
    const LightConstants none{};
    if (l.positional) std::memcpy(l.half_vector, none.half_vector, sizeof none.half_vector);
    if (!l.spot) {
      std::memcpy(l.spot_direction, none.spot_direction, sizeof none.spot_direction);
      l.spot_cosine = l.spot_exponent = 0;
    }
    if (!two_sided)
      for (auto* product : {&l.ambient_product, &l.diffuse_product, &l.specular_product})
        std::memset((*product)[1], 0, sizeof(*product)[1]);
    return l;
  }
};

template <class T> std::string difference(const T& a, const T& b) {
  Comparison comparison;
  if (comparison.same(a, b)) return {};
  if (comparison.way.empty()) return "the value";
  std::string path;
  for (size_t i = comparison.way.size(); i-- > 0;) {
    const std::string& name = comparison.way[i];
    if (!path.empty() && name[0] != '[') path += '.';
    path += name;
  }
  return path;
}

} // namespace

std::string snapshot_difference(const FragmentProgram* a, const FragmentProgram* b) {
  return difference(a, b);
}
std::string snapshot_difference(const SmoothPrograms* a, const SmoothPrograms* b) { return difference(a, b); }
std::string snapshot_difference(const RasterConstants* a, const RasterConstants* b) {
  return difference(a, b);
}
std::string snapshot_difference(const TransformConstants* a, const TransformConstants* b) {
  return difference(a, b);
}
std::string snapshot_difference(const ClipPlaneConstants* a, const ClipPlaneConstants* b) {
  return difference(a, b);
}
std::string snapshot_difference(const CoordinateConstants* const (&a)[kMaxTextureUnits],
                                const CoordinateConstants* const (&b)[kMaxTextureUnits]) {
  return difference(a, b);
}
std::string snapshot_difference(const LightingConstants* a, const LightingConstants* b) {
  return difference(a, b);
}
std::string snapshot_difference(const VertexProgram* a, const VertexProgram* b) { return difference(a, b); }
std::string snapshot_difference(const ShadedLayout& a, const ShadedLayout& b) { return difference(a, b); }
std::string snapshot_difference(const int8_t (&a)[5][2], const int8_t (&b)[5][2]) { return difference(a, b); }
std::string snapshot_difference(uint32_t a, uint32_t b) { return difference(a, b); }
std::string snapshot_difference(bool a, bool b) { return difference(a, b); }

} // namespace softgl
