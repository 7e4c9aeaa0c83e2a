// What is drawn to, and the caller's buffer that shows it. The caller's buffer is never drawn to: it is
// written when the picture is asked for (glFlush, glFinish, a context losing its thread).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/gl_types.h"
#include "base/pages.h"
#include "shaders/common/surface.h"
#include "surface/tile_reader.h"

namespace softgl {

struct TexelFormat; // texture/texel_format.h

/// The caller's memory and how OSMesa was told to fill it.
struct ClientBuffer {
  void* data = nullptr;
  GLenum format = 0, type = 0; // OSMESA_RGBA, ...; GL_UNSIGNED_BYTE, ...
  GLint row_length = 0;        // pixels; 0 = the width
  bool y_up = true;            // row 0 is the bottom one
};

/// What has been done, for softgl_get_statistics().
struct FramebufferCounts {
  uint64_t flushes = 0, resolves = 0, clears = 0, reads = 0;
};

/// What a context draws to, or reads from: the window or a framebuffer object.
struct RenderTarget {
  Surface surface{}; // empty where nothing can be drawn
  int depth_bits = 0, stencil_bits = 0,
      accumulation_bits = 0;           // a depth_stencil plane may serve only one of the two
  bool has_alpha = true;               // false for RGB and RGB_565: alpha reads as 1 and is never written
  const TexelFormat* texels = nullptr; // of what is attached: how its colors are texels
  bool unwritten = false;              // something may wait to be written to the planes (TileWords)
};

/// The window. Its surface is empty before the first MakeCurrent.
struct Framebuffer : RenderTarget {
  bool unresolved = false; // something was drawn that the caller's buffer does not show
  int samples = 1;         // of a pixel: 1 or kSamples
  /// What is seen of pixels with several samples: their means (resolve_samples() in frame/surface_work.h);
  /// else null.
  std::unique_ptr<Framebuffer> resolved;
  bool samples_changed = true; // since they were resolved
  ClientBuffer client;
  FramebufferCounts counts;
  int16_t* accumulation = nullptr;       // accumulation.h; null, and all zeros, until it is first written
  std::vector<unsigned char> depth_copy; // what OSMesaGetDepthBuffer gave out; empty until it is called

  Framebuffer() = default;
  ~Framebuffer() { release(); }
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;

  /// The pixels that are read: one sample each.
  Framebuffer& seen() { return resolved ? *resolved : *this; }
  const Framebuffer& seen() const { return resolved ? *resolved : *this; }

  /// Before allocate(), when bits and alpha are known. Throws std::bad_alloc.
  void set_samples(int count);
  /// New planes of zeros (alpha 1 where there is none). False, and nothing changed, when memory does not
  /// suffice.
  bool allocate(int width, int height, ColorFormat color_format);
  /// Memory of zeros for the accumulation buffer if it has none; throws std::bad_alloc.
  void make_accumulation();
  /// Appends the planes and the caller's buffer, to be brought in early.
  void prepare(std::vector<Pages>& pages) const;
  void release();

private:
  size_t color_bytes_ = 0, depth_bytes_ = 0; // mapped; no depth_bytes_ where the planes share memory
  size_t accumulation_bytes_ = 0;
  std::vector<TileWords> color_tiles_, depth_tiles_;
  uint32_t next_place_ = 0;
};

/// Writes tiles of the surface to the caller's buffer.
class Resolver final : public TileReader {
public:
  Resolver(const Surface& surface, const ClientBuffer& client);
  void read(uint32_t tile) const override { resolve_(surface_, client_, tile); }

private:
  const Surface& surface_;
  const ClientBuffer& client_;
  void (*resolve_)(const Surface&, const ClientBuffer&, uint32_t tile);
};

/// Bytes of a value in depth_copy: 4 (24 bits, stencil in the top byte), 2 (16 bits) or 0 (no depth).
int depth_copy_bytes(const Framebuffer& framebuffer);
/// Fills depth_copy from the surface that is read, bottom row first. Nothing may wait to be written
/// (write_tiles).
void copy_depth(Framebuffer& framebuffer);

} // namespace softgl
