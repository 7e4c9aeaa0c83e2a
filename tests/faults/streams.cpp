#include "faults/streams.h"

#include "fuzz/commands.h"
#include "support/scene.h"

namespace softgl::test {

std::vector<Stream> all_streams() {
  std::vector<Stream> all;
  for (const auto* streams : {&vertex_streams(), &list_streams(), &array_streams(), &texture_streams(),
                              &framebuffer_streams(), &pixel_streams(), &state_streams(), &context_streams()})
    all.insert(all.end(), streams->begin(), streams->end());
  return all;
}

void run_hostile_commands(Player& player) {
  const Gl& gl = player.gl;
  Random& random = player.random;
  set_up_arrays(gl);
  player.note_disorder();
  const int length = random.integer(20, 300);
  for (int i = 0; i < length; ++i) {
    const FuzzCommand& command = random_fuzz_command(random);
    Random arguments(random.bits());
    // The state of before waits at the bottom of the stacks, for Player::restore().
    const std::string name = command.name;
    if (name == "PopAttrib" || name == "PopClientAttrib") continue;
    command.call(gl, arguments);
  }
  gl.End();
  gl.EndList();
  player.check();
  player.picture();
}

void run_random_family(Player& player) {
  const auto& all = families();
  const Scene& scene = all[size_t(player.random.integer(0, int(all.size()) - 1))];
  Stage stage{player.gl, player.random, Player::kWidth, Player::kHeight};
  scene.draw(stage);
  player.check();
  player.picture();
}

} // namespace softgl::test
