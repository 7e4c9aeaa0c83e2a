#include "view/script.h"

#include <sstream>

#include "common/program_error.h"
#include "options/option_values.h"

namespace softgl::cli {
namespace {

Event key_event(Event::Kind kind, const std::string& key) {
  Event event;
  event.kind = kind;
  event.key = key;
  return event;
}

Event mouse_event(Event::Kind kind, int x = 0, int y = 0) {
  Event event;
  event.kind = kind;
  event.x = x;
  event.y = y;
  return event;
}

bool drag(const std::string& button, int x, int y, std::vector<Event>& events) {
  Event press = mouse_event(Event::kPress);
  if (button == "middle")
    press.button = Event::kMiddle;
  else if (button == "right")
    press.button = Event::kRight;
  else if (button == "shift")
    press.shift = true;
  else if (button != "left" && button != "light")
    return false;
  if (button == "light") events.push_back(key_event(Event::kKey, "l"));
  events.push_back(press);
  events.push_back(mouse_event(Event::kMove, x, y));
  events.push_back(mouse_event(Event::kRelease));
  if (button == "light") events.push_back(key_event(Event::kKeyUp, "l"));
  return true;
}

bool parse_step(std::istringstream& words, ScriptStep& step) {
  std::string command, word, rest;
  words >> command;
  if (command == "key" && words >> word) {
    step.events = {key_event(Event::kKey, word), key_event(Event::kKeyUp, word)};
  } else if (command == "drag") {
    int x = 0, y = 0;
    if (!(words >> word >> x >> y) || !drag(word, x, y, step.events)) return false;
  } else if (command == "wheel") {
    int steps = 0;
    if (!(words >> steps)) return false;
    step.events = {mouse_event(Event::kWheel, 0, steps)};
  } else if (command == "size" && words >> word) {
    int width = 0, height = 0;
    parse_size(word, width, height);
    step.events = {mouse_event(Event::kResize, width, height)};
  } else if (command == "save") {
    step.kind = ScriptStep::kSave;
    words >> step.file;
  } else if (command == "shot" && words >> step.file) {
    step.kind = ScriptStep::kShot;
  } else if (command == "wait" && words >> word && word == "reload") {
    step.kind = ScriptStep::kReload;
  } else {
    return false;
  }
  return !(words >> rest);
}

} // namespace

std::vector<ScriptStep> parse_script(const std::string& text, const std::string& name) {
  std::vector<ScriptStep> steps;
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::istringstream words(line.substr(0, line.find('#')));
    if ((words >> std::ws).eof()) continue;
    ScriptStep step;
    bool known = false;
    try {
      known = parse_step(words, step);
    } catch (const std::invalid_argument&) {} // of parse_size()
    if (!known) {
      std::string sentence = name;
      sentence.append(":").append(std::to_string(number)).append(": no step of a script: ").append(line);
      throw ProgramError(kUsageError, sentence);
    }
    steps.push_back(std::move(step));
  }
  return steps;
}

} // namespace softgl::cli
