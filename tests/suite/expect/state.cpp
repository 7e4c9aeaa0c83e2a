#include "expect/state.h"

namespace softgl::suite {

LightingState::LightingState() {
  light[0].parameters.diffuse = light[0].parameters.specular = {1, 1, 1};
  for (spec::LightBounds& l : light) l.position = Vec3{0, 0, 1}, l.spot_direction = Vec3{0, 0, -1};
}

void restore(State& state, const SavedAttributes& saved) {
  const Attributes& from = saved.attributes;
  const GLbitfield mask = saved.mask;
  if (mask & GL_CURRENT_BIT) state.current = from.current;
  if (mask & GL_LIGHTING_BIT) state.lighting = from.lighting;
  if (mask & GL_TRANSFORM_BIT) state.transform = from.transform;
  if (mask & GL_POLYGON_BIT) state.polygon = from.polygon;
  if (mask & GL_FOG_BIT) state.fog = from.fog;
  if (mask & GL_COLOR_BUFFER_BIT) state.color_buffer = from.color_buffer;
  if (mask & GL_DEPTH_BUFFER_BIT) state.depth = from.depth;
  if (mask & GL_PIXEL_MODE_BIT) { // the maps are not saved (table 6.22)
    const auto maps = state.pixel.transfer.maps;
    state.pixel = from.pixel, state.pixel.transfer.maps = maps;
  }
  if (mask & GL_TEXTURE_BIT) {
    state.texture.active = from.texture.active;
    for (int u = 0; u < kTextureUnits; u++) {
      state.texture.units[u] = from.texture.units[u];
      for (int target = 0; target < kTextureTargets; target++) {
        // The parameters of what is bound, not its images.
        const auto saved_object =
            from.texture.objects.find({TextureTarget(target), state.texture.units[u].bound[target]});
        TextureObject& object = state.texture.bound(u, TextureTarget(target));
        object.parameters = saved_object == from.texture.objects.end() ? TextureParameters()
                                                                       : saved_object->second.parameters;
      }
    }
  }
  if (mask & GL_STENCIL_BUFFER_BIT) state.stencil = from.stencil;
  if (mask & GL_SCISSOR_BIT) state.scissor = from.scissor;
  if (mask & GL_POLYGON_STIPPLE_BIT) state.polygon_stipple = from.polygon_stipple;
  if (mask & GL_ACCUM_BUFFER_BIT) state.accumulation_clear = from.accumulation_clear;
  if (mask & GL_POINT_BIT) state.point = from.point;
  if (mask & GL_LINE_BIT) state.line = from.line;
  if (mask & GL_LIST_BIT) state.list_base = from.list_base;
  if (mask & GL_VIEWPORT_BIT) state.viewport = from.viewport;
  if (mask & GL_EVAL_BIT) state.evaluators = from.evaluators;
  if (mask & GL_ENABLE_BIT) {
    state.lighting.lighting = from.lighting.lighting,
    state.lighting.color_material = from.lighting.color_material;
    std::copy(from.lighting.enabled, from.lighting.enabled + 8, state.lighting.enabled);
    std::copy(from.transform.clip_enabled, from.transform.clip_enabled + kClipPlanes,
              state.transform.clip_enabled);
    state.transform.normalize = from.transform.normalize;
    state.transform.rescale_normal = from.transform.rescale_normal;
    state.polygon.cull = from.polygon.cull, state.fog.on = from.fog.on, state.depth.test = from.depth.test;
    state.color_buffer.alpha_test = from.color_buffer.alpha_test,
    state.color_buffer.blend = from.color_buffer.blend;
    for (int u = 0; u < kTextureUnits; u++) {
      const TextureUnit& unit = from.texture.units[u];
      std::copy(unit.on, unit.on + kTextureTargets, state.texture.units[u].on);
      for (int i = 0; i < 4; i++) state.texture.units[u].generation[i].on = unit.generation[i].on;
    }
    state.color_buffer.logic = from.color_buffer.logic, state.stencil.test = from.stencil.test;
    state.scissor.test = from.scissor.test, state.point.smooth = from.point.smooth;
    state.line.smooth = from.line.smooth, state.line.stippled = from.line.stippled;
    state.polygon.smooth = from.polygon.smooth, state.polygon.stippled = from.polygon.stippled;
    state.polygon.offset_point = from.polygon.offset_point;
    state.polygon.offset_line = from.polygon.offset_line;
    state.polygon.offset_fill = from.polygon.offset_fill;
    state.color_buffer.dither = from.color_buffer.dither;
    for (int d = 0; d < 2; d++)
      std::copy(from.evaluators.on[d], from.evaluators.on[d] + kEvaluatorTargets, state.evaluators.on[d]);
    state.evaluators.auto_normal = from.evaluators.auto_normal;
  }
}

void restore(State& state, const SavedClient& saved) {
  const ClientState& from = saved.client;
  if (saved.mask & GL_CLIENT_PIXEL_STORE_BIT) state.pack = from.pack, state.unpack = from.unpack;
  if (saved.mask & GL_CLIENT_VERTEX_ARRAY_BIT) {
    state.vertex_array = from.vertex_array, state.normal_array = from.normal_array;
    state.color_array = from.color_array, state.edge_flag_array = from.edge_flag_array;
    state.texture_array = from.texture_array;
  }
}

} // namespace softgl::suite
