// What is drawn to and read from, and the images of textures that are drawn to
// (GL_ARB_framebuffer_object, 4.4).
#pragma once

namespace softgl {

struct Context;
struct Renderbuffer;
struct TextureObject;

/// After a change of what is bound, of the bound objects, or of images that are attached to them. Nothing may
/// wait to be drawn.
void framebuffers_changed(Context& c);

/// Makes c.draw the surface of what is bound, as it is now. False where it is not complete: then
/// GL_INVALID_FRAMEBUFFER_OPERATION is the error of whoever wants to draw or read. Throws std::bad_alloc.
bool prepare_draw_target(Context& c);
/// As prepare_draw_target(), and raises the error. Where the next draw samples a texture that waiting draws
/// draw to, does those draws first, so that it sees them; the frame's memory stays.
bool ready_to_draw(Context& c);
/// Makes c.read the surface of what is bound, as it is now. No draws may wait. What is known of
/// the planes has been written to them.
bool prepare_read_target(Context& c);
/// Whether it is complete; changes nothing.
bool draw_target_complete(const Context& c);

/// Before the texels of the object's images are read or changed: what was drawn to them is stored in the
/// texels. No draws to them may wait. Throws std::bad_alloc.
void store_drawn_texels(TextureObject& object);

/// True where an image of the object is attached to the bound draw or read framebuffer.
bool is_attached(const Context& c, const TextureObject& object);
bool is_attached(const Context& c, const Renderbuffer& object);
/// Ends all attachments of the object to the bound framebuffers, since it is deleted (4.4.2.2, 4.4.2.3).
/// Nothing may wait to be drawn.
void detach_from_bound(Context& c, const TextureObject& object);
void detach_from_bound(Context& c, const Renderbuffer& object);

} // namespace softgl
