#include "snapshot/render_targets.h"

#include <algorithm>

#include "context/context.h"
#include "context/texture_bindings.h"
#include "frame/surface_work.h"
#include "snapshot/flush.h"

namespace softgl {

void framebuffers_changed(Context& c) {
  FramebufferBindings& b = c.bindings;
  b.draw_current = b.read_current = false; // the old ones may still be in use
  c.draw = b.draw ? static_cast<RenderTarget*>(&b.draw_target) : &c.framebuffer;
  c.read = b.read ? static_cast<RenderTarget*>(&b.read_target) : &c.framebuffer.seen();
  c.dirty |= kDirtyAll;
}

namespace {

/// The plane of what is attached, with the newest pixels; null for nothing.
std::shared_ptr<RenderPlane> plane_of(const Attachment* a) {
  if (!a || a->empty()) return nullptr;
  if (a->renderbuffer) return a->renderbuffer->plane;
  TextureImage& image = *a->image();
  if (image.slices.empty()) image.slices.resize(size_t(image.depth));
  DrawnSlice& slice = image.slices[size_t(a->layer)];
  if (!slice.plane) slice.plane = std::make_shared<RenderPlane>(a->format(), image.width, image.height);
  if (slice.texels_newer && !image.blank) load_plane(*slice.plane, image, a->layer);
  slice.texels_newer = false;
  return slice.plane;
}

/// The surface of the object with `color`.
void assemble_target(FramebufferObject& object, const Attachment* color, AssembledTarget& target) {
  int width = kMaxRenderbufferSize, height = kMaxRenderbufferSize;
  object.for_each([&](const Attachment& a) {
    if (!a.empty()) width = std::min(width, a.width()), height = std::min(height, a.height());
  });
  const bool depth = !object.depth.empty(), stencil = !object.stencil.empty();
  auto color_plane = plane_of(color), depth_plane = plane_of(depth ? &object.depth : &object.stencil);
  assemble(object.name, width, height, color_plane.get(), depth_plane.get(), depth, stencil, target);
  target.color = std::move(color_plane);
  target.depth_stencil = std::move(depth_plane);
}

} // namespace

bool draw_target_complete(const Context& c) {
  const FramebufferBindings& b = c.bindings;
  return !b.draw || b.draw_current || b.draw->complete();
}

bool prepare_draw_target(Context& c) {
  FramebufferBindings& b = c.bindings;
  if (!b.draw || b.draw_current) return true;
  if (!b.draw->complete()) return false;
  assemble_target(*b.draw, b.draw->color_of(b.draw->draw_buffer), b.draw_target);
  b.draw_current = true;
  return true;
}

namespace {

bool holds(const Attachment& a, const TextureObject& object) { return a.texture.get() == &object; }
bool holds(const Attachment& a, const Renderbuffer& object) { return a.renderbuffer.get() == &object; }

template <class Visit> void for_each_bound(const Context& c, Visit&& visit) {
  for (FramebufferObject* bound : {c.bindings.draw.get(), c.bindings.read.get()})
    if (bound) bound->for_each(visit);
}

template <class Object> bool is_attached_to_bound(const Context& c, const Object& object) {
  bool attached = false;
  for_each_bound(c, [&](const Attachment& a) { attached = attached || holds(a, object); });
  return attached;
}

template <class Object> void detach_object(Context& c, const Object& object) {
  for_each_bound(c, [&](Attachment& a) {
    if (holds(a, object)) a = {};
  });
  framebuffers_changed(c);
}

} // namespace

bool is_attached(const Context& c, const TextureObject& object) { return is_attached_to_bound(c, object); }
bool is_attached(const Context& c, const Renderbuffer& object) { return is_attached_to_bound(c, object); }
void detach_from_bound(Context& c, const TextureObject& object) { detach_object(c, object); }
void detach_from_bound(Context& c, const Renderbuffer& object) { detach_object(c, object); }

namespace {

/// Where the next draw samples a texture that waiting draws draw to, does those draws, so that it sees them.
void settle_feedback(Context& c) {
  if (c.frame.empty()) return;
  for (int unit = 0; unit < kMaxTextureUnits; ++unit)
    for (int target = 0; target < kTextureTargets; ++target) {
      if (!c.state.texture.unit[unit].enabled[target]) continue;
      if (is_attached(c, *bound_texture(c, unit, TextureTarget(target)))) return execute_frame_so_far(c);
    }
}

} // namespace

bool ready_to_draw(Context& c) {
  if (!prepare_draw_target(c)) {
    set_error(c, GL_INVALID_FRAMEBUFFER_OPERATION);
    return false;
  }
  if (c.bindings.draw) settle_feedback(c);
  return true;
}

bool prepare_read_target(Context& c) {
  FramebufferBindings& b = c.bindings;
  if (b.read) {
    if (!b.read->complete()) return false;
    if (!b.read_current) assemble_target(*b.read, b.read->color_of(b.read->read_buffer), b.read_target);
    b.read_current = true;
    b.read_target.unwritten = true; // by draws to another object with the same images
  }
  if (!b.read) resolve_samples(c.framebuffer);
  write_tiles(*c.read);
  return true;
}

void store_drawn_texels(TextureObject& object) {
  if (!object.drawn_to.exchange(false)) return;
  try {
    for (auto& face : object.image)
      for (auto& image : face) {
        if (!image || image->slices.empty()) continue;
        const auto newer = [](const DrawnSlice& slice) {
          return slice.plane && !slice.texels_newer && has_changed(*slice.plane);
        };
        if (std::none_of(image->slices.begin(), image->slices.end(), newer)) continue;
        // A frame that still samples the image has the old texels.
        if (image.use_count() > 1) image = std::make_shared<TextureImage>(*image);
        for (int z = 0; z < image->depth; ++z)
          if (newer(image->slices[size_t(z)])) store_plane(*image->slices[size_t(z)].plane, *image, z);
        image->repeat_edges();
        image->blank = false;
      }
  } catch (...) {
    object.drawn_to = true;
    throw;
  }
}

} // namespace softgl
