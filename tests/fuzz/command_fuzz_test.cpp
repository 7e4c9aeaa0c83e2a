// Hostile command streams: softgl must survive them, and name the same errors as OSMesa.
#include <catch2/catch.hpp>

#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/commands.h"

namespace softgl::test {
namespace {

struct Step {
  std::string name;
  GLenum error;
};

// Runs `length` commands in a new context. Errors are asked for only where glGetError is allowed.
// SOFTGL_FUZZ_ROUNDS=n runs n streams on softgl alone.
uint64_t rounds(uint64_t usual) {
  const char* text = std::getenv("SOFTGL_FUZZ_ROUNDS");
  return text ? std::strtoull(text, nullptr, 10) : usual;
}

// `spare_osmesa`: without an EndList that has no NewList, which crashes it.
std::vector<Step> run(const Gl& gl, uint64_t seed, int length, bool spare_osmesa = false) {
  std::vector<Step> steps;
  std::vector<unsigned char> color(64 * 48 * 4);
  void* context = gl.OSMesaCreateContextExt(kOSMesaRgba, 24, 8, 0, nullptr);
  REQUIRE(gl.OSMesaMakeCurrent(context, color.data(), GL_UNSIGNED_BYTE, 64, 48));
  Random random(seed * 1000003u);
  set_up_arrays(gl);
  bool inside = false;
  GLint list = 0;      // the one that is being compiled
  bool called = false; // ... calls a list
  const auto end_list = [&] {
    if (!spare_osmesa || (list && !inside)) gl.EndList();
  };
  for (int i = 0; i < length; i++) {
    const FuzzCommand& command = random_fuzz_command(random);
    Random arguments(random.bits()); // however many numbers the command draws, the stream goes on the same
    const std::string name = command.name;
    // A list that calls two lists that call it is played 2^64 times: one call in a list, of one list.
    const bool calls = name == "CallList" || name == "CallLists";
    if (name == "NewList") called = false;
    if (name == "EndList")
      end_list();
    else if (!calls || !list || (name == "CallList" && !std::exchange(called, true)))
      command.call(gl, arguments);
    if (name == "Begin") inside = true;
    if (name == "End") inside = false;
    steps.push_back({name, inside ? GLenum(GL_NO_ERROR) : gl.GetError()});
    if (!inside) gl.GetIntegerv(GL_LIST_INDEX, &list);
  }
  if (inside) gl.End();
  inside = false;
  end_list();
  gl.Finish();
  gl.OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  gl.OSMesaDestroyContext(context);
  return steps;
}

} // namespace

TEST_CASE("hostile commands do no harm", "[fuzz]") {
  for (uint64_t seed = 0; seed < rounds(300); seed++) CHECK(run(softgl_library(), seed, 400).size() == 400);
}

// One stream of a hundred kills OSMesa (1087, 1335): these do not. A new command in the table makes other
// streams of them.
TEST_CASE("hostile commands raise errors where OSMesa does", "[fuzz][slow]") {
  for (uint64_t seed = 1100; seed < 1300; seed++) {
    const auto ours = run(softgl_library(), seed, 60, true), theirs = run(osmesa_library(), seed, 60, true);
    for (size_t i = 0; i < ours.size(); i++) {
      INFO("seed " << seed << ", command " << i << ": gl" << ours[i].name << ", before it gl"
                   << (i ? ours[i - 1].name : ""));
      // Of several bad arguments GL 1.5 does not say which one is named.
      const bool same = (ours[i].error == GL_NO_ERROR) == (theirs[i].error == GL_NO_ERROR);
      CHECK(same);
      if (!same) break; // from here on the two have different state
    }
  }
}

} // namespace softgl::test
