// What a command stream is played with: a library, random numbers, contexts with buffers, and what came of
// it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "support/gl.h"
#include "support/random.h"

namespace softgl::test {

class Player {
public:
  /// A context of its own is current from the beginning.
  Player(const Gl& library, uint64_t seed);
  ~Player();
  Player(const Player&) = delete;
  Player& operator=(const Player&) = delete;

  const Gl& gl;
  Random random;
  static constexpr int kWidth = 96, kHeight = 80;

  /// One more context; null when the library has no memory for it.
  void* create(void* shared = nullptr, GLenum format = kOSMesaRgba, int depth = 24, int stencil = 8,
               int accumulation = 0);
  /// With a buffer of the player's.
  bool make_current(void* context, int width = kWidth, int height = kHeight, GLenum type = GL_UNSIGNED_BYTE);
  bool make_none_current();
  void destroy(void* context);
  void* own_context() const { return contexts_.front()->handle; }

  /// Reads all errors. GL_OUT_OF_MEMORY is noted; others become part of the result.
  void check();
  /// Finishes the picture of the current context and makes it a part of the result.
  void picture();
  void add(const void* data, size_t bytes);
  void add(uint64_t value) { add(&value, sizeof value); }
  /// Says that the library has refused something in another way than by an error.
  void refuse() { out_of_memory_ = true; }

  bool out_of_memory() const { return out_of_memory_; }
  /// For commands without a plan: an error may hide all later ones, and objects of before are used again.
  void note_disorder() { disorderly_ = true; }
  bool disorderly() const { return disorderly_; }
  uint64_t result() const { return result_; }

  /// Leaves nothing open and all state as it was in the beginning, in the player's own context.
  void restore();
  /// Begins anew with the same random numbers.
  void restart();

private:
  struct Context {
    void* handle;
    std::vector<unsigned char> buffer = {};
  };
  void save_state();

  const uint64_t seed_;
  std::vector<std::unique_ptr<Context>> contexts_;
  bool out_of_memory_ = false, disorderly_ = false;
  uint64_t result_ = 0;
};

/// Draws a picture that uses most of the library, in the player's own context and from initial state; its
/// hash. Throws std::runtime_error when an error is raised.
uint64_t draw_reference_frame(Player& player);

} // namespace softgl::test
