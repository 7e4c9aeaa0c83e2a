// glGetString and glGetStringi (GL 1.5, 6.1.11).
#include <cstring>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "base/cpu_features.h"
#include "commands/generated/commands.h"
#include "commands/queries/extensions.h"
#include "context/context.h"
#include "frame/parallel.h"

namespace softgl {
namespace {

/// Extensions that work: what GL 1.1 to 2.0 took over, under the names by which programs look for it.
/// Programs search for a name with a blank behind it, hence the blank at the end.
constexpr const char* kExtensions =
    "GL_3DFX_texture_compression_FXT1 GL_ANGLE_texture_compression_dxt3 "
    "GL_ANGLE_texture_compression_dxt5 GL_APPLE_packed_pixels GL_ARB_clip_control "
    "GL_ARB_color_buffer_float GL_ARB_copy_buffer GL_ARB_copy_image GL_ARB_debug_output "
    "GL_ARB_depth_buffer_float GL_ARB_depth_clamp GL_ARB_depth_texture GL_ARB_draw_elements_base_vertex "
    "GL_ARB_framebuffer_object GL_ARB_framebuffer_sRGB GL_ARB_half_float_pixel GL_ARB_half_float_vertex "
    "GL_ARB_map_buffer_range GL_ARB_multisample GL_ARB_multitexture GL_ARB_occlusion_query "
    "GL_ARB_pixel_buffer_object GL_ARB_point_parameters GL_ARB_point_sprite GL_ARB_provoking_vertex "
    "GL_ARB_sampler_objects GL_ARB_seamless_cube_map GL_ARB_shadow GL_ARB_texture_border_clamp "
    "GL_ARB_texture_compression GL_ARB_texture_compression_rgtc GL_ARB_texture_cube_map "
    "GL_ARB_texture_env_add GL_ARB_texture_env_combine GL_ARB_texture_env_crossbar "
    "GL_ARB_texture_env_dot3 GL_ARB_texture_filter_anisotropic GL_ARB_texture_float "
    "GL_ARB_texture_mirrored_repeat GL_ARB_texture_non_power_of_two GL_ARB_texture_rectangle "
    "GL_ARB_texture_rg GL_ARB_texture_storage GL_ARB_transpose_matrix GL_ARB_vertex_array_bgra "
    "GL_ARB_vertex_array_object GL_ARB_vertex_buffer_object GL_ARB_window_pos "
    "GL_ATI_blend_equation_separate GL_ATI_separate_stencil GL_ATI_texture_env_combine3 "
    "GL_ATI_texture_float GL_EXT_abgr GL_EXT_bgra GL_EXT_blend_color GL_EXT_blend_equation_separate "
    "GL_EXT_blend_func_separate GL_EXT_blend_minmax GL_EXT_blend_subtract GL_EXT_compiled_vertex_array "
    "GL_EXT_copy_texture GL_EXT_debug_label GL_EXT_depth_bounds_test GL_EXT_draw_range_elements "
    "GL_EXT_fog_coord GL_EXT_framebuffer_blit GL_EXT_framebuffer_multisample GL_EXT_framebuffer_object "
    "GL_EXT_framebuffer_sRGB GL_EXT_multi_draw_arrays GL_EXT_packed_depth_stencil GL_EXT_packed_float "
    "GL_EXT_packed_pixels GL_EXT_pixel_buffer_object GL_EXT_point_parameters GL_EXT_provoking_vertex "
    "GL_EXT_rescale_normal GL_EXT_secondary_color GL_EXT_separate_specular_color GL_EXT_shadow_funcs "
    "GL_EXT_stencil_two_side GL_EXT_stencil_wrap GL_EXT_subtexture GL_EXT_texture GL_EXT_texture3D "
    "GL_EXT_texture_compression_dxt1 GL_EXT_texture_compression_latc GL_EXT_texture_compression_rgtc "
    "GL_EXT_texture_compression_s3tc GL_EXT_texture_cube_map GL_EXT_texture_edge_clamp "
    "GL_EXT_texture_env_add GL_EXT_texture_env_combine GL_EXT_texture_env_dot3 "
    "GL_EXT_texture_filter_anisotropic GL_EXT_texture_lod_bias GL_EXT_texture_object "
    "GL_EXT_texture_rectangle GL_EXT_texture_sRGB GL_EXT_texture_sRGB_decode "
    "GL_EXT_texture_shared_exponent GL_EXT_texture_snorm GL_EXT_vertex_array GL_EXT_vertex_array_bgra "
    "GL_IBM_multimode_draw_arrays GL_IBM_rasterpos_clip GL_IBM_texture_mirrored_repeat "
    "GL_INGR_blend_func_separate GL_KHR_context_flush_control GL_KHR_debug GL_MESA_pack_invert "
    "GL_MESA_window_pos GL_NV_blend_square GL_NV_copy_depth_to_color GL_NV_copy_image GL_NV_depth_clamp "
    "GL_NV_fog_distance GL_NV_half_float GL_NV_light_max_exponent GL_NV_packed_depth_stencil "
    "GL_NV_primitive_restart GL_NV_texgen_reflection GL_NV_texture_env_combine4 GL_NV_texture_rectangle "
    "GL_OES_read_format GL_S3_s3tc GL_SGIS_generate_mipmap GL_SGIS_texture_border_clamp "
    "GL_SGIS_texture_edge_clamp GL_SGIS_texture_lod GL_SOFTGL_phong_illumination "
    "GL_SUN_multi_draw_arrays GL_WIN_phong_shading ";

/// Lives as long as the process, however often the text changes (the number of threads may).
const GLubyte* kept(const std::string& text) {
  static std::mutex* const mutex = new std::mutex;
  static std::set<std::string>* const texts = new std::set<std::string>;
  const std::lock_guard lock(*mutex);
  return reinterpret_cast<const GLubyte*>(texts->insert(text).first->c_str());
}

/// GL_EXTENSIONS cut into names.
const std::vector<std::string>& extension_names() {
  static const auto* const names = [] {
    auto* list = new std::vector<std::string>;
    for (const char *name = kExtensions, *end; (end = std::strchr(name, ' ')); name = end + 1)
      list->emplace_back(name, end);
    return list;
  }();
  return *names;
}

} // namespace

int extension_count() { return int(extension_names().size()); }

namespace gl {

const GLubyte* GetStringi(Context& c, GLenum name, GLuint index) {
  if (name != GL_EXTENSIONS) return set_error(c, GL_INVALID_ENUM, "name"), nullptr;
  if (index >= GLuint(extension_count())) return set_error(c, GL_INVALID_VALUE, "index"), nullptr;
  return reinterpret_cast<const GLubyte*>(extension_names()[index].c_str());
}

const GLubyte* GetString(Context& c, GLenum name) {
  switch (name) {
  case GL_VENDOR: return reinterpret_cast<const GLubyte*>("softgl");
  case GL_RENDERER: {
    const int threads = drawing_threads();
    return kept("softgl (" + std::string(isa_name(selected_isa())) + ", " + std::to_string(threads) +
                (threads == 1 ? " thread)" : " threads)"));
  }
  case GL_VERSION: return reinterpret_cast<const GLubyte*>("1.5 softgl " SOFTGL_VERSION_TEXT);
  case GL_EXTENSIONS: return reinterpret_cast<const GLubyte*>(kExtensions);
  default: set_error(c, GL_INVALID_ENUM, "name"); return nullptr;
  }
}

} // namespace gl
} // namespace softgl
