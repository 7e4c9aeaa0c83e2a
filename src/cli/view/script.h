// Events from a file, for tests and demonstrations: `softgl view --script FILE`.
#pragma once

#include <string>
#include <vector>

#include "view/view_state.h"

namespace softgl::cli {

struct ScriptStep {
  enum Kind {
    kEvents, // in turn
    kSave,   // the picture, as key s does: to `file`, or to the next free name
    kShot,   // what the window shows, to `file`
    kReload, // wait until a file has changed, and its model was read again
  };
  Kind kind = kEvents;
  std::vector<Event> events;
  std::string file;
};

// A step a line; # begins a comment:
//   key NAME                 goes down and up: key p, key F2, key PageDown
//   drag BUTTON DX DY        left, middle, right, shift (and left) or light (l and left), by pixels
//   wheel STEPS
//   size WxH
//   save [FILE]
//   shot FILE
//   wait reload
// Throws ProgramError (kUsageError) with the line's number.
std::vector<ScriptStep> parse_script(const std::string& text, const std::string& name);

} // namespace softgl::cli
