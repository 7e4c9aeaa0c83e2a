#include <cstdio>
#include <initializer_list>
#include <string_view>
#include <utility>
#include <vector>

#include "fuzz/arguments.h"
#include "fuzz/targets.h"
#include "spec/object_snapshot.h"

namespace softgl::test {
namespace {

constexpr int kMostCommands = 60;

bool kept_in_lists(std::string_view name) { // GL 1.5, 5.4, and the sections of extensions
  for (const char* at_once : {"Get",
                              "Is",
                              "Gen",
                              "Delete",
                              "FeedbackBuffer",
                              "SelectBuffer",
                              "RenderMode",
                              "ClientActiveTexture",
                              "Interleaved",
                              "ReadPixels",
                              "PixelStore",
                              "AreTextures",
                              "BindBuffer",
                              "BindFramebuffer",
                              "BindRenderbuffer",
                              "BindVertexArray",
                              "PrimitiveRestartIndex",
                              "BlitFramebuffer",
                              "CheckFramebufferStatus",
                              "Framebuffer",
                              "RenderbufferStorage",
                              "BufferData",
                              "BufferSubData",
                              "MapBuffer",
                              "FlushMapped",
                              "CopyBufferSubData",
                              "UnmapBuffer",
                              "Flush",
                              "Finish",
                              "NewList",
                              "EndList",
                              "EnableClientState",
                              "DisableClientState",
                              "PushClientAttrib",
                              "PopClientAttrib",
                              "TexStorage",
                              "LockArrays",
                              "UnlockArrays",
                              "Debug",
                              "PushDebugGroup",
                              "PopDebugGroup",
                              "Object"})
    if (name.starts_with(at_once)) return false;
  return !name.ends_with("Pointer");
}

const std::vector<const AnyCommand*>& list_commands() {
  static const std::vector<const AnyCommand*> all = [] {
    std::vector<const AnyCommand*> found;
    for (const AnyCommand& command : any_commands())
      if (kept_in_lists(command.name)) found.push_back(&command);
    return found;
  }();
  return all;
}

struct Result {
  std::vector<unsigned char> colors, depths;
  StateSnapshot state;
  bool error;
};

Result play(const Gl& gl, std::span<const uint8_t> bytes, bool from_list) {
  Choices choices(bytes);
  void* context = gl.OSMesaCreateContextExt(kOSMesaRgba, 24, 8, 16, nullptr);
  std::vector<unsigned char> window(64 * 48 * 4);
  if (!context || !gl.OSMesaMakeCurrent(context, window.data(), GL_UNSIGNED_BYTE, 64, 48))
    fault("no context");
  prepare_objects(gl, choices);
  // What follows a glBegin that fails is compiled as if it stood between Begin and End.
  if (gl.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  while (gl.GetError() != GL_NO_ERROR) {}
  if (from_list) gl.NewList(60, GL_COMPILE);
  const auto& commands = list_commands();
  for (int i = 0; i < kMostCommands && !choices.ended(); ++i) {
    const AnyCommand& command = *commands[size_t(choices.integer(0, int(commands.size()) - 1))];
    const Arguments arguments = choose_arguments(command, choices);
    command.call(gl, arguments.data());
  }
  if (from_list) {
    gl.EndList();
    gl.CallList(60);
    gl.DeleteLists(60, 1);
  }
  gl.End(); // an error where nothing was begun
  Result result;
  result.error = gl.GetError() != GL_NO_ERROR;
  while (gl.GetError() != GL_NO_ERROR) {}
  result.state = take_snapshot(gl, false);
  add_objects(gl, result.state);
  gl.PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
  for (GLenum mode : {GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_ROWS, GL_PACK_ROW_LENGTH, GL_PACK_SWAP_BYTES})
    gl.PixelStorei(mode, 0);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.ReadBuffer(GL_FRONT);
  result.colors.resize(64 * 48 * 4);
  result.depths.resize(64 * 48 * 4);
  gl.ReadPixels(0, 0, 64, 48, GL_RGBA, GL_UNSIGNED_BYTE, result.colors.data());
  gl.ReadPixels(0, 0, 64, 48, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, result.depths.data());
  gl.OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  gl.OSMesaDestroyContext(context);
  return result;
}

} // namespace

void fuzz_lists(const Gl& gl, std::span<const uint8_t> bytes) {
  const Result at_once = play(gl, bytes, false), listed = play(gl, bytes, true);
  if (const std::string difference = compare_snapshots(at_once.state, listed.state); !difference.empty()) {
    std::fprintf(stderr, "at once | from a list: %s", difference.c_str());
    fault("a list leaves another state");
  }
  if (at_once.colors != listed.colors) fault("a list draws other colors");
  if (at_once.depths != listed.depths) fault("a list draws other depths or stencil values");
}

} // namespace softgl::test
