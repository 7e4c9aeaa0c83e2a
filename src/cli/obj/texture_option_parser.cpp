#include "obj/texture_option_parser.h"

#include <cmath>
#include <vector>

#include "obj/file_search.h"
#include "obj/number_parser.h"

namespace softgl::cli {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t'; }

struct StatementWords {
  std::string_view text;
  size_t at = 0;

  void skip_spaces() {
    while (at < text.size() && is_space(text[at])) ++at;
  }
  std::string_view peek() {
    skip_spaces();
    size_t end = at;
    while (end < text.size() && !is_space(text[end])) ++end;
    return text.substr(at, end - at);
  }
  void take() { at += peek().size(); }
  bool number(float& value) {
    const std::string word(peek()); // ends with a zero byte
    if (word.empty()) return false;
    const char* cursor = word.c_str();
    float read;
    if (!read_number(cursor, read) || cursor != word.c_str() + word.size() || !std::isfinite(read))
      return false;
    value = read;
    take();
    return true;
  }
};

// True if the word was an option; its values are taken too.
bool option(StatementWords& words, TextureReference& texture) {
  const std::string_view name = words.peek();
  float values[3] = {0, 0, 0};
  const auto numbers = [&](int limit) {
    int count = 0;
    while (count < limit && words.number(values[count])) ++count;
    return count;
  };
  if (name == "-s" || name == "-o" || name == "-t") {
    words.take();
    const int count = numbers(3);
    if (name == "-t" || count == 0) return true; // turbulence has no place in the fixed-function pipeline
    float* target = name == "-s" ? texture.scale : texture.offset;
    target[0] = values[0];
    if (count > 1) target[1] = values[1];
  } else if (name == "-mm") {
    words.take();
    if (numbers(2) == 2) {
      texture.base = values[0];
      texture.gain = values[1];
    }
  } else if (name == "-clamp" || name == "-blendu" || name == "-blendv" || name == "-cc") {
    words.take();
    const std::string_view value = words.peek();
    if (value != "on" && value != "off") return true;
    if (name == "-clamp") texture.clamp = value == "on";
    words.take();
  } else if (name == "-boost" || name == "-bm" || name == "-texres") {
    words.take();
    if (numbers(1) == 0 && name == "-texres") words.take(); // "512x512" is seen too
  } else if (name == "-imfchan" || name == "-type") {
    words.take();
    words.take();
  } else {
    return false;
  }
  return true;
}

} // namespace

MapStatement parse_map_statement(std::string_view arguments, const ModelFiles& files,
                                 const std::string& folder) {
  MapStatement statement;
  StatementWords words{arguments};
  while (!words.peek().empty() && words.peek()[0] == '-' && option(words, statement.texture)) {}
  words.skip_spaces();
  statement.wanted = std::string(arguments.substr(words.at));
  for (int tries = 0; !words.peek().empty() && tries < 16; ++tries, words.take(), words.skip_spaces()) {
    statement.texture.file = files.find(folder, arguments.substr(words.at), tries == 0);
    if (!statement.texture.file.empty()) return statement;
  }
  statement.texture.file = files.find(folder, arguments, false); // a name that begins like an option
  return statement;
}

} // namespace softgl::cli
