#include "frame/frame_trace.h"

#include <string>

#include "base/fast_paths.h"
#include "fragment/fragment_keys.h"
#include "geometry/geometry.h"
#include "shaders/fragment/fragment_program.h"
#include "shaders/raster/raster_constants.h"
#include "shaders/vertex/vertex_program.h"

namespace softgl {
namespace {

const char* const mode_names[] = {"GL_POINTS",     "GL_LINES",          "GL_LINE_LOOP",    "GL_LINE_STRIP",
                                  "GL_TRIANGLES",  "GL_TRIANGLE_STRIP", "GL_TRIANGLE_FAN", "GL_QUADS",
                                  "GL_QUAD_STRIP", "GL_POLYGON"};
const char* const attribute_names[] = {"position",  "normal",    "color", "secondary_color",
                                       "fog_coord", "edge_flag", "index", nullptr};

/// A list of words.
struct Words {
  std::string text;
  void add(const std::string& word, bool condition = true) {
    if (!condition) return;
    text += text.empty() ? "" : " ";
    text += word;
  }
};

uint64_t primitives_of(const DrawRecord& draw) {
  uint64_t count = draw.rectangle ? 1 : 0;
  for (uint32_t i = 0; i < draw.call.primitive_count; ++i) count += assembly_steps(draw.call.primitives[i]);
  return count;
}

/// GL_TRIANGLES, or GL_TRIANGLES|GL_LINES where primitives of both are in one draw.
std::string modes_of(const DrawCall& call) {
  uint32_t modes = 0;
  for (uint32_t i = 0; i < call.primitive_count; ++i) modes |= 1u << call.primitives[i].mode;
  std::string text;
  for (int mode = 0; mode < 10; ++mode)
    if (modes >> mode & 1) text += std::string(text.empty() ? "" : "|") + mode_names[mode];
  return text;
}

std::string attributes_of(uint32_t present) {
  Words words;
  for (int slot = 0; slot < kAttributeSlots; ++slot) {
    if (!(present >> slot & 1)) continue;
    if (slot >= kMaterial0)
      words.add("material" + std::to_string(slot - kMaterial0));
    else if (slot >= kTexCoord0)
      words.add("texcoord" + std::to_string(slot - kTexCoord0));
    else if (attribute_names[slot])
      words.add(attribute_names[slot]);
  }
  return words.text;
}

std::string lighting_words(const LightingConstants& l) {
  Words words;
  words.add("lit:" + std::to_string(l.light_count));
  words.add("two_sided", l.two_sided);
  words.add("local_viewer", l.local_viewer);
  words.add("separate_specular", l.separate_specular);
  words.add("reflection_vector", l.reflection);
  words.add("varying_material", l.varies[0] || l.varies[1]);
  words.add("per_fragment", l.for_fragments);
  return words.text;
}

std::string polygon_words(const PolygonConstants& p) {
  static const char* const names[] = {"fill", "line", "point"};
  return std::string("polygon_mode:") + names[int(p.mode[p.ccw_is_front ? 0 : 1])] + "," +
         names[int(p.mode[p.ccw_is_front ? 1 : 0])];
}

std::string to_string(const VertexProgram& v) {
  Words words;
  if (v.lighting) words.add(lighting_words(*v.lighting));
  words.add("normalize", v.normalize || v.unit_normal);
  words.add(v.fog_from_attribute ? "fog_coord" : "fog", v.fog);
  words.add("point_attenuation", v.point_attenuated);
  for (int unit = 0; unit < kMaxTextureUnits; ++unit) {
    const CoordinateConstants* c = v.coordinates[unit];
    if (!c) continue;
    bool generated = false;
    for (TexGen mode : c->mode) generated = generated || mode != TexGen::None;
    words.add("texgen" + std::to_string(unit), generated);
    words.add("texture_matrix" + std::to_string(unit), c->transform);
  }
  if (v.clip_planes && v.clip_planes->count > 0)
    words.add("clip_planes:" + std::to_string(v.clip_planes->count));
  if (v.polygons) words.add(polygon_words(*v.polygons));
  words.add("line_stipple", v.line_stipple);
  return words.text.empty() ? "plain" : words.text;
}

std::string to_string(const RasterConstants& r) {
  Words words;
  words.add("box:" + std::to_string(r.x0) + "," + std::to_string(r.y0) + "," + std::to_string(r.x1) + "," +
            std::to_string(r.y1));
  words.add("cull:ccw", r.cull & 1);
  words.add("cull:cw", r.cull & 2);
  words.add("two_sided", r.two_sided);
  words.add("polygon_offset", r.offset);
  words.add("point_sprite", r.point_sprite);
  words.add("polygon_stipple", r.stipple != nullptr);
  return words.text;
}

} // namespace

void trace_draw(const DrawRecord& draw) {
  TraceText text;
  if (const PixelRectangle* rectangle = draw.rectangle) {
    const WindowBox& box = rectangle->box;
    text.print("draw pixels %d,%d,%d,%d", box.x0, box.y0, box.x1, box.y1);
  } else {
    const DrawCall& call = draw.call;
    text.print("draw %s: %u vertices, %llu primitives", modes_of(call).c_str(), call.vertex_count,
               static_cast<unsigned long long>(primitives_of(draw)));
    text.put(call.indices ? ", indexed" : "");
    text.print("; attributes %s; vertex %s", attributes_of(call.source->present).c_str(),
               to_string(*draw.vertex).c_str());
  }
  text.print("; raster %s; fragment %s", to_string(*draw.raster).c_str(),
             to_string(draw.fragment->key).c_str());
  if (draw.samples) text.put("; counted");
  trace_work(text);
}

FlushTrace::FlushTrace(std::span<const Frame::Item> items, uint32_t framebuffer) : framebuffer_(framebuffer) {
  for (const Frame::Item& item : items) {
    ++(item.clear ? clears_ : draws_);
    if (item.draw) primitives_ += primitives_of(*item.draw);
  }
}

void FlushTrace::end(size_t arena_bytes, int rounds, int workers) const {
  using namespace std::chrono;
  const auto time = duration_cast<microseconds>(steady_clock::now() - begin_);
  TraceText text;
  const uint32_t taken = taken_fast_paths.exchange(0, std::memory_order_relaxed);
  text.print("flush %zu draws, %zu clears, %llu primitives, %zu bytes, %d rounds, %d workers, %lld us",
             draws_, clears_, static_cast<unsigned long long>(primitives_), arena_bytes, rounds, workers,
             static_cast<long long>(time.count()));
  if (framebuffer_) text.print(", framebuffer %u", framebuffer_);
  if (taken) text.put((", fast paths " + to_names(taken)).c_str());
  trace_work(text);
}

} // namespace softgl
