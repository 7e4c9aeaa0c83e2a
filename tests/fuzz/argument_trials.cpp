#include "fuzz/argument_trials.h"

#include <cstdio>
#include <cstring>
#include <optional>
#include <string_view>

#include "fuzz/arguments.h"
#include "fuzz/known_differences.h"
#include "spec/object_snapshot.h"

namespace softgl::test {
namespace {

constexpr size_t kWatchedBytes = 1 << 16; // of the memory that commands write to

enum class Place { AtOnce, InList, BetweenBeginAndEnd };

struct Outcome {
  std::string errors;
  uint64_t result = 0;
  std::vector<unsigned char> output;
  StateSnapshot state;
};

uint64_t hash_of(std::string_view text) { // FNV-1a
  uint64_t hash = 14695981039346656037u;
  for (char letter : text) hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211u;
  return hash;
}

bool is_error(const std::string& errors) { return errors.find_first_not_of(';') != std::string::npos; }

// All errors that wait.
std::string errors_of(const Gl& gl) {
  std::string text;
  for (int i = 0; i < 4; ++i) {
    const GLenum error = gl.GetError();
    if (error == GL_NO_ERROR) break;
    char buffer[16];
    std::snprintf(buffer, sizeof buffer, " %x", error);
    text += buffer;
  }
  return text;
}

StateSnapshot state_of(const Gl& gl) {
  StateSnapshot state = take_snapshot(gl, false);
  add_objects(gl, state);
  // Where nothing can be read OSMesa has the error of GL_ARB_ES2_compatibility.
  std::erase_if(state, [](const auto& answer) {
    return answer.first.starts_with("GL_IMPLEMENTATION_COLOR_READ_") && answer.first.ends_with(" error");
  });
  return state;
}

Outcome call(const Gl& gl, const AnyCommand& command, const Arguments& arguments, Place place) {
  Outcome outcome;
  std::memset(OutputMemory::bytes(), 0, kWatchedBytes);
  switch (place) {
  case Place::AtOnce: outcome.result = command.call(gl, arguments.data()); break;
  case Place::InList:
    gl.NewList(70, GL_COMPILE);
    outcome.result = command.call(gl, arguments.data());
    outcome.errors = errors_of(gl) + ";";
    gl.EndList();
    outcome.errors += errors_of(gl) + ";";
    gl.CallList(70);
    break;
  case Place::BetweenBeginAndEnd:
    gl.Begin(GL_POINTS);
    outcome.result = command.call(gl, arguments.data());
    gl.End();
    break;
  }
  outcome.errors += errors_of(gl);
  outcome.output.assign(OutputMemory::bytes(), OutputMemory::bytes() + kWatchedBytes);
  outcome.state = state_of(gl);
  return outcome;
}

bool is_excluded(std::string_view name) {
  // They change where the trial is, or ask for what it compares.
  for (const char* other : {"Begin", "End", "NewList", "EndList", "GetError", "Flush", "Finish"})
    if (name == other) return true;
  return false;
}

// Format and type are one argument in two: both errors are the specification's if the format is none.
bool has_pixel_format(std::string_view name) {
  return name.starts_with("TexImage") || name.starts_with("TexSubImage") || name == "DrawPixels" ||
         name == "ReadPixels" || name == "GetTexImage";
}

bool gives_pointer(std::string_view name) {
  return name.starts_with("MapBuffer") || name.starts_with("GetString") || name.ends_with("Pointerv");
}

bool gives_own_bytes(std::string_view name) { return gives_pointer(name) || name == "GetCompressedTexImage"; }

} // namespace

std::string play(const Trial& trial, Player& playing, bool say_calls) {
  const AnyCommand& command = trial.command;
  if (is_excluded(command.name)) return "";
  Choices choices(trial.seed * 1000003u + hash_of(command.name));
  const uint64_t preparation = choices.seed();
  const Gl* const libraries[] = {&softgl_library(), &osmesa_library()};
  CurrentContext contexts[] = {CurrentContext(*libraries[0]), CurrentContext(*libraries[1])};
  for (const Gl* gl : libraries) {
    playing = gl == libraries[0] ? Player::Softgl : Player::OSMesa;
    Choices objects(preparation);
    prepare_objects(*gl, objects);
    errors_of(*gl);
  }
  StateSnapshot before = state_of(*libraries[0]);
  std::optional<Arguments> good;
  char head[160];
  std::snprintf(head, sizeof head, "[--command %s --first %llu] ", command.name,
                static_cast<unsigned long long>(trial.seed));
  for (int step = 0; step < 12; ++step) {
    const int draw = choices.integer(0, 99);
    const Place place = draw < 65 ? Place::AtOnce : draw < 90 ? Place::InList : Place::BetweenBeginAndEnd;
    Choices drawn(choices.seed());
    Arguments arguments = choose_arguments(command, drawn);
    // Of several bad arguments the specification does not say which one is named. If one argument of a call
    // without an error is another, the error must be the same.
    const bool one_changed =
        good && !has_pixel_format(command.name) && command.parameter_count > 0 && choices.chance(65);
    if (one_changed) {
      const size_t changed = size_t(choices.integer(0, command.parameter_count - 1));
      const Argument other = arguments[changed];
      arguments = *good;
      arguments[changed] = other;
    }
    const char* const places[] = {"", " in a list", " between Begin and End"};
    const std::string text = text_of(command, arguments.data()) + places[int(place)];
    if (differs_on_purpose(command.name, arguments, *libraries[0], place == Place::InList)) continue;
    if (say_calls) std::printf("%s%s\n", head, text.c_str()), std::fflush(stdout);
    Outcome outcomes[2];
    for (int i = 0; i < 2; ++i) {
      playing = i == 0 ? Player::Softgl : Player::OSMesa;
      outcomes[i] = call(*libraries[i], command, arguments, place);
    }
    playing = Player::Nobody;
    const Outcome &ours = outcomes[0], &theirs = outcomes[1];
    if (one_changed ? ours.errors != theirs.errors : is_error(ours.errors) != is_error(theirs.errors))
      return head + text + ": errors" + ours.errors + " |" + theirs.errors + "\n";
    if (!gives_pointer(command.name) && ours.result != theirs.result)
      return head + text + ": result " + std::to_string(ours.result) + " | " + std::to_string(theirs.result) +
             "\n";
    if (gives_pointer(command.name) && !ours.result != !theirs.result)
      return head + text + ": one result is null\n";
    if (is_error(ours.errors) && place == Place::AtOnce) {
      for (unsigned char byte : ours.output)
        if (byte != 0) return head + text + ": error" + ours.errors + " and an answer\n";
    } else if (!is_error(ours.errors) && !gives_own_bytes(command.name) && ours.output != theirs.output) {
      size_t i = 0;
      while (ours.output[i] == theirs.output[i]) ++i;
      return head + text + ": output at " + std::to_string(i) + ": " + std::to_string(ours.output[i]) +
             " | " + std::to_string(theirs.output[i]) + "\n";
    }
    const std::string difference = compare_snapshots(ours.state, theirs.state);
    if (!difference.empty())
      return head + text + ": state " + difference.substr(0, 400) + (difference.size() > 400 ? "...\n" : "");
    if (!is_error(ours.errors)) good = arguments;
    if (is_error(ours.errors) && place == Place::AtOnce) {
      const std::string change = compare_snapshots(before, ours.state);
      if (!change.empty())
        return head + text + ": error" + ours.errors + " and a change " + change.substr(0, 400);
    }
    before = outcomes[0].state;
  }
  return "";
}

} // namespace softgl::test
