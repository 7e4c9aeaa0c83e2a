// GetBooleanv, GetIntegerv, GetInteger64v, GetFloatv, GetDoublev (GL 1.5, 6.1.1 and 6.1.2), from
// state_table.inc.
#include <algorithm>
#include <vector>

#include "commands/generated/commands.h"
#include "commands/get_conversion.h"
#include "commands/queries/extensions.h"
#include "commands/state/capabilities.h"
#include "context/color_clamping.h"
#include "context/context.h"
#include "texture/texel_format.h"

namespace softgl {
namespace {

// A state value. A double holds every GL scalar exactly.
struct Values {
  double v[16];
  int count = 0;
  Conversion conversion = Conversion::Bool;

  template <class T>
  requires std::is_arithmetic_v<T>
  void put(T x) { v[count++] = double(x); }
  void put(const Vec3& x) {
    for (int i = 0; i < 3; ++i) put(x[i]);
  }
  void put(const Vec4& x) {
    for (int i = 0; i < 4; ++i) put(x[i]);
  }
  void put(const glm::mat4& x) {
    for (int i = 0; i < 4; ++i) put(x[i]);
  }
  template <class... T> void put_all(const T&... x) { (put(x), ...); }
};

Vec4 fragment_color(const Context& c, const Vec4& color) {
  if (!clamps_queried_colors(c)) return color;
  Vec4 clamped;
  for (int i = 0; i < 4; ++i) clamped[i] = color[i] > 0.0f ? (color[i] > 1.0f ? 1.0f : color[i]) : 0.0f;
  return clamped;
}

struct FramebufferBits {
  int red, green, blue, alpha, depth, stencil, accumulation;
};
FramebufferBits framebuffer_bits(const Context& c) {
  const FramebufferObject* f = c.bindings.draw.get();
  if (!f) {
    const Framebuffer& w = c.framebuffer;
    return {bits_of_color(w, 0), bits_of_color(w, 1), bits_of_color(w, 2), bits_of_color(w, 3),
            w.depth_bits,        w.stencil_bits,      w.accumulation_bits};
  }
  FramebufferBits bits{};
  if (!f->complete()) return bits;
  // Of the first image, whatever the draw buffer is, as in OSMesa.
  for (const Attachment& a : f->color) {
    if (a.empty()) continue;
    const RenderFormat format = a.format();
    bits.red = format.bits[0], bits.green = format.bits[1];
    bits.blue = format.bits[2], bits.alpha = format.bits[3];
    break;
  }
  if (!f->depth.empty()) bits.depth = f->depth.format().depth_bits;
  if (!f->stencil.empty()) bits.stencil = f->stencil.format().stencil_bits;
  return bits;
}

struct PixelKind {
  GLenum format, type;
};
PixelKind preferred_reading(GLenum base, ColorFormat format, const ColorEncoding& e) {
  const GLenum components = base == GL_RED || base == GL_RG ? base : GLenum(GL_RGBA);
  switch (format) {
  case ColorFormat::RgbaFloat:
    if (e.bits[2] == 10) return {GL_RGB, GL_UNSIGNED_INT_10F_11F_11F_REV};
    return {components, GLenum(std::max(e.bits[0], e.bits[3]) == 16 ? GL_HALF_FLOAT : GL_FLOAT)};
  case ColorFormat::Rgba16:
    if (e.numbers == ColorNumbers::Signed)
      return {components, GLenum(std::max(e.bits[0], e.bits[3]) == 8 ? GL_BYTE : GL_SHORT)};
    if (e.bits[0] == 10 && e.bits[3] == 2) return {GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV};
    return {components, GL_UNSIGNED_SHORT};
  case ColorFormat::Rgb565: return {GL_RGB, GL_UNSIGNED_SHORT_5_6_5};
  case ColorFormat::Rgba8:
    if (e.bits[1] == 6) return {GL_RGB, GL_UNSIGNED_SHORT_5_6_5};
    if (e.bits[0] == 4 && e.bits[3] == 4) return {GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4};
    if (e.bits[0] == 5 && e.bits[3] == 1) return {GL_RGBA, GL_UNSIGNED_SHORT_1_5_5_5_REV};
  }
  return {components, GL_UNSIGNED_BYTE};
}

/// How colors are best read (GL_OES_read_format): as they are stored. GL_NONE where there are none.
PixelKind preferred_reading(const Context& c) {
  const FramebufferObject* f = c.bindings.read.get();
  if (!f) {
    const Surface& window = c.framebuffer.surface;
    PixelKind kind = preferred_reading(GL_RGBA, window.color_format, window.encoding);
    constexpr GLenum kOSMesaBgra = 1;
    if (c.framebuffer.client.format == kOSMesaBgra) kind.format = GL_BGRA;
    return kind;
  }
  const Attachment* a = f->complete() ? f->color_of(f->read_buffer) : nullptr;
  if (!a || a->empty()) return {GL_NONE, GL_NONE};
  const RenderFormat format = a->format();
  return preferred_reading(format.texels ? format.texels->base : GL_RGBA, format.color, format.encoding);
}

/// The color encoding of what is drawn to is sRGB.
bool draws_srgb(const Context& c) {
  const FramebufferObject* f = c.bindings.draw.get();
  const Attachment* a = f && f->complete() ? f->color_of(f->draw_buffer) : nullptr;
  return a && a->format().encoding.srgb;
}

/// Samples of a pixel of what is drawn to; 1 where it is not complete.
int framebuffer_samples(const Context& c) {
  const FramebufferObject* f = c.bindings.draw.get();
  return !f ? std::max(c.framebuffer.surface.samples, 1) : f->complete() ? f->samples() : 1;
}

/// The name of a bound object, 0 for none.
template <class Object> GLuint name_of(const std::shared_ptr<Object>& object) {
  return object ? object->name : 0;
}

GLint stencil_reference(const Context& c, const StencilFace& face) {
  return std::clamp(face.reference, 0, (1 << framebuffer_bits(c).stencil) - 1);
}

struct CompiledList {
  GLuint name;
  GLenum mode;
};
CompiledList list_being_compiled(const Context& c) {
  return c.lists.list ? CompiledList{c.lists.name, c.lists.mode} : CompiledList{0, 0};
}

struct Row {
  GLenum token;
  Conversion conversion;
  void (*read)(const Context& c, Values& out);
};
#define STATE(name, kind, initial, ...) \
  {GL_##name, Conversion::kind, [](const Context& c, Values& out) { \
     [[maybe_unused]] const State& s = c.state; \
     [[maybe_unused]] const ClientState& client = c.client; \
     [[maybe_unused]] const TextureUnitState& unit = s.texture.unit[s.texture.active_unit]; \
     out.put_all(__VA_ARGS__); \
   }},
const Row kStateRows[] = {
#include "context/state_table.inc"
};

const Row* find_row(GLenum token) {
  static const std::vector<const Row*> sorted = [] {
    std::vector<const Row*> rows;
    for (const Row& row : kStateRows) rows.push_back(&row);
    std::sort(rows.begin(), rows.end(), [](auto* a, auto* b) { return a->token < b->token; });
    return rows;
  }();
  auto it =
      std::lower_bound(sorted.begin(), sorted.end(), token, [](auto* a, GLenum t) { return a->token < t; });
  return it != sorted.end() && (*it)->token == token ? *it : nullptr;
}

// The value of `pname`; false and an error if there is no such value.
bool read(Context& c, GLenum pname, Values& out) {
  if (const Row* row = find_row(pname)) {
    out.conversion = row->conversion;
    row->read(c, out);
    return true;
  }
  if (const Capability* capability = find_capability(pname)) {
    out.put(capability->get(c.state, c.state.texture.active_unit));
    return true;
  }
  if (const bool* enabled = find_client_switch(c.client, pname)) {
    out.put(*enabled);
    return true;
  }
  set_error(c, GL_INVALID_ENUM, "pname");
  return false;
}

} // namespace

int state_value_count(Context& c, GLenum pname) {
  Values values;
  if (const Row* row = find_row(pname)) return row->read(c, values), values.count;
  return find_capability(pname) || find_client_switch(c.client, pname) ? 1 : 0;
}

namespace gl {

void GetBooleanv(Context& c, GLenum pname, GLboolean* data) {
  Values values;
  if (read(c, pname, values))
    for (int i = 0; i < values.count; ++i) data[i] = values.v[i] != 0;
}
void GetIntegerv(Context& c, GLenum pname, GLint* data) {
  Values values;
  if (read(c, pname, values))
    for (int i = 0; i < values.count; ++i) data[i] = to_integer(values.v[i], values.conversion);
}
void GetInteger64v(Context& c, GLenum pname, GLint64* data) {
  Values values;
  if (read(c, pname, values))
    for (int i = 0; i < values.count; ++i) data[i] = to_integer64(values.v[i], values.conversion);
}
void GetFloatv(Context& c, GLenum pname, GLfloat* data) {
  Values values;
  if (read(c, pname, values))
    for (int i = 0; i < values.count; ++i) data[i] = GLfloat(values.v[i]);
}
void GetDoublev(Context& c, GLenum pname, GLdouble* data) {
  Values values;
  if (read(c, pname, values))
    for (int i = 0; i < values.count; ++i) data[i] = values.v[i];
}

} // namespace gl
} // namespace softgl
