// A rendering context: State, objects, and the machinery that turns commands into pictures.
#pragma once

#include <memory>

#include "base/refusal.h"
#include "context/array_cache.h"
#include "context/attribute_stack.h"
#include "context/debug_output.h"
#include "context/evaluator_maps.h"
#include "context/framebuffer_objects.h"
#include "context/list_compiler.h"
#include "context/matrix_stacks.h"
#include "context/object_store.h"
#include "context/occlusion_queries.h"
#include "context/sampler_objects.h"
#include "context/shading.h"
#include "context/snapshot_cache.h"
#include "context/state.h"
#include "context/vertex_array_objects.h"
#include "context/vertex_builder.h"
#include "frame/frame.h"
#include "surface/framebuffer.h"
#include "texture/combiner_chain.h"

namespace softgl {

/// Why a door may not go straight to its command; 0 is the fast path, tested once per call.
enum DoorGuard : uint32_t {
  kInsideBeginEnd = 1, // in both modes: between Begin and End of the stream that is being built
  kCompilingList = 2,
  kNoContext = 4,
  kRunPending = 8 // vertices wait in the builder: close_run() before a command changes or reads state
};

struct Context {
  VertexBuilder builder; // first: the hot doors touch it
  uint32_t guard = 0;    // DoorGuard bits
  uint32_t dirty = kDirtyAll;
  GLenum error = GL_NO_ERROR; // sticky (2.5)
  State state;
  ClientState client;
  MatrixStacks matrices;
  AttributeStack attribute_stack;
  std::shared_ptr<SharedObjects> shared =
      std::make_shared<SharedObjects>(); // textures, buffers, lists: may be shared
  std::shared_ptr<TextureObject> proxy_texture[kTextureTargets];
  /// Of the names in TextureUnitState::bound, null for 0. A texture that another context deletes stays bound.
  std::shared_ptr<TextureObject> bound_texture[kMaxTextureUnits][kTextureTargets];
  SamplerBindings samplers; // of the texture units
  OcclusionQueries queries;
  EvaluatorMaps evaluator_maps;
  ListCompiler lists;
  ArrayCache arrays; // what the last array draw found out about ClientState::vertex_array
  CombinerCache combiners;
  Frame frame;
  SnapshotCache snapshots; // point into frame.arena()
  Framebuffer framebuffer; // the window
  NameTable<FramebufferObject> framebuffer_objects;
  NameTable<VertexArrayObject> vertex_array_objects;
  FramebufferBindings bindings;
  DebugOutput debug;
  RenderTarget* draw = &framebuffer; // what is drawn to; empty while the bound object is not complete
  RenderTarget* read = &framebuffer;
  const bool smooth_is_phong = smooth_is_phong_by_environment();
  bool osmesa_quadrilaterals = false; // cut where OSMesa 22.3.6 cuts them
  bool specification_answers = false; // where OSMesa 22.3.6 leaves the specification
};

/// The calling thread's context; never null: without one it is a context whose guard is kNoContext.
/// Initial-exec, because it is one pointer and is read by every call.
extern constinit thread_local Context* current_context __attribute__((tls_model("initial-exec")));

/// A group of the state that is about to change, as edit<&State::fog>(c); sets its dirty bits.
template <auto kGroup> auto& edit(Context& c) {
  c.dirty |= kDirtyBitsOf<kGroup>;
  return c.state.*kGroup;
}

/// Records `code` unless an earlier error waits to be read (2.5). GL_INVALID_ENUM and GL_INVALID_VALUE name
/// the argument that is wrong, as gl.xml names it: "param" is "params", too.
inline void set_error(Context& c, GLenum code, const char* argument = nullptr) {
  if (c.error != GL_NO_ERROR) return;
  c.error = code;
  c.debug.wrong_argument = argument;
}
inline void set_error(Context& c, const Refusal& refusal) { set_error(c, refusal.error, refusal.argument); }

} // namespace softgl
