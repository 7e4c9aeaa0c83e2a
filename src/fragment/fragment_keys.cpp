#include "fragment/fragment_keys.h"

#include "shaders/common/limits.h"

namespace softgl {

namespace {

const char* const compare_names[] = {"never",   "less",     "equal",  "lequal",
                                     "greater", "notequal", "gequal", "always"};
const char* const stencil_names[] = {"keep", "zero",   "replace",   "incr",
                                     "decr", "invert", "incr_wrap", "decr_wrap"};
const char* const factor_names[] = {"zero",
                                    "one",
                                    "src_color",
                                    "one_minus_src_color",
                                    "src_alpha",
                                    "one_minus_src_alpha",
                                    "dst_alpha",
                                    "one_minus_dst_alpha",
                                    "dst_color",
                                    "one_minus_dst_color",
                                    "src_alpha_saturate",
                                    "constant_color",
                                    "one_minus_constant_color",
                                    "constant_alpha",
                                    "one_minus_constant_alpha",
                                    "?"};
const char* const equation_names[] = {"add", "subtract", "reverse_subtract", "min", "max", "separate",
                                      "?",   "?"};
const char* const color_names[] = {"rgba8", "rgba16", "rgba_float", "rgb565"};
const char* const depth_names[] = {"no_depth", "z16", "z24s8", "z32f"};

constexpr auto value = [](auto e) { return static_cast<uint64_t>(e); };

} // namespace

FragmentKey simplify(FragmentKey k) {
  const uint64_t always = value(Compare::Always), keep = value(StencilOperation::Keep);
  if (k.depth_format == value(DepthFormat::None)) {
    k.depth_function = always;
    k.depth_write = 0;
    k.stencil = 0;
  }
  if (k.depth_format == value(DepthFormat::Z16)) k.stencil = 0;
  if (k.depth_function == value(Compare::Never)) k.depth_write = 0;
  if (k.stencil && k.stencil_function == always && k.stencil_depth_fail == keep && k.stencil_pass == keep)
    k.stencil = 0;
  if (!k.stencil) k.stencil_function = k.stencil_fail = k.stencil_depth_fail = k.stencil_pass = 0;
  if (k.logic_op) k.blend = 0; // GL 1.5, 4.1.9: a logic operation disables blending, GL_COPY too
  if (k.logic_op && k.blend_source_rgb == 3) k.logic_op = k.blend_source_rgb = 0; // GL_COPY
  if (k.blend) {
    const uint64_t one = value(BlendFactor::One), zero = value(BlendFactor::Zero);
    if (k.blend_equation == value(BlendEquation::Min) ||
        k.blend_equation == value(BlendEquation::Max)) // factors are not used
      k.blend_source_rgb = k.blend_source_alpha = k.blend_destination_rgb = k.blend_destination_alpha = one;
    else if (k.blend_equation <= value(BlendEquation::Subtract) && k.blend_source_rgb == one &&
             k.blend_source_alpha == one && k.blend_destination_rgb == zero &&
             k.blend_destination_alpha == zero)
      k.blend = 0;
  }
  if (!k.blend) {
    k.blend_equation = k.blend_destination_rgb = k.blend_source_alpha = k.blend_destination_alpha = 0;
    if (!k.logic_op) k.blend_source_rgb = 0;
  }
  if (k.color_mask == 0) { // nothing of the color arrives but through the alpha test
    k.blend = k.logic_op = 0;
    k.blend_equation = k.blend_source_rgb = k.blend_destination_rgb = k.blend_source_alpha =
        k.blend_destination_alpha = 0;
    k.color_sum = k.fog_mode = k.secondary = 0;
  }
  return k;
}

std::string to_string(const FragmentKey& k) {
  std::string s;
  auto add = [&](const std::string& word) { s += (s.empty() ? "" : " ") + word; };
  if (k.flat) add("flat");
  if (k.lit) add("lit");
  for (int i = 0; i < kMaxTextureUnits; ++i)
    if (k.texture_units >> i & 1) add("tex" + std::to_string(i));
  if (k.color_sum) add("color_sum");
  if (k.fog_mode) add(std::string("fog:") + (k.fog_mode == 1 ? "linear" : k.fog_mode == 2 ? "exp" : "exp2"));
  if (k.alpha_function != value(Compare::Always))
    add(std::string("alpha:") + compare_names[k.alpha_function]);
  if (k.stencil)
    add(std::string("stencil:") + compare_names[k.stencil_function] + "(" + stencil_names[k.stencil_fail] +
        "," + stencil_names[k.stencil_depth_fail] + "," + stencil_names[k.stencil_pass] + ")");
  if (k.depth_function != value(Compare::Always) || k.depth_write)
    add(std::string("depth:") + compare_names[k.depth_function] + (k.depth_write ? ",write" : ""));
  if (k.blend) {
    std::string b = std::string("blend:") + equation_names[k.blend_equation] + "(" +
                    factor_names[k.blend_source_rgb] + "," + factor_names[k.blend_destination_rgb];
    if (k.blend_source_alpha != k.blend_source_rgb || k.blend_destination_alpha != k.blend_destination_rgb)
      b += std::string(";") + factor_names[k.blend_source_alpha] + "," +
           factor_names[k.blend_destination_alpha];
    add(b + ")");
  }
  if (k.logic_op) add("logic_op:" + std::to_string(k.blend_source_rgb));
  std::string mask = "mask:";
  for (int i = 0; i < 4; ++i) mask += (k.color_mask >> i & 1) ? "rgba"[i] : '-';
  add(mask);
  add(std::string(color_names[k.color_format]) + (k.encoded ? ",encoded" : ""));
  add(depth_names[k.depth_format]);
  return s;
}

} // namespace softgl
