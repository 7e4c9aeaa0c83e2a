// The errors that the specification names, and the calls that raise them: error_rows.tsv has a row for each
// error of each argument of each command. All calls that the tests of errors make are made once more here,
// with messages of errors (GL_KHR_debug), which tell the command, the error and the argument that is to
// blame.
#include <catch2/catch.hpp>

#include <filesystem>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "house/document.h"
#include "spec/refused_calls.h"
#include "test_paths.h"

namespace softgl::test {
namespace {

struct Refused {
  std::string call;    // as the test has it
  std::string message; // what softgl says
};
std::vector<Refused> refused;

/// The newest message of the log, which is empty then.
std::string last_message(const Gl& gl) {
  GLchar text[4096] = "";
  std::string last;
  while (gl.GetDebugMessageLog(1, sizeof text, nullptr, nullptr, nullptr, nullptr, nullptr, text))
    last = text;
  return last;
}

/// Makes the call, and keeps its message, if it is softgl's.
void observe(const Gl& gl, const BadCall& call) {
  const bool ours = &gl == &softgl_library();
  if (ours) gl.Enable(GL_DEBUG_OUTPUT);
  call.run(gl);
  if (ours) {
    refused.push_back({call.text, last_message(gl)});
    gl.Disable(GL_DEBUG_OUTPUT);
  }
  CHECK(gl.GetError() == call.error);
}

const std::vector<Refused>& all_refused() {
  if (refused.empty()) {
    refusal_observer = observe;
    for (void (*run)() : refusal_cases()) run();
    refusal_observer = nullptr;
  }
  return refused;
}

/// Of "GL_INVALID_ENUM: glEnable(GL_FOG_MODE): cap = GL_FOG_MODE"; no call: a message of another form.
struct Parts {
  std::string error, call, arguments, argument, value;
};
Parts parts_of(const std::string& message) {
  static const std::regex form(R"(GL_(\w+): gl(\w+)\((.*)\)(?:: (\w+) = (.+))?)");
  std::smatch m;
  if (!std::regex_match(message, m, form)) return {};
  return {m[1], m[2], m[3], m[4], m[5]};
}

/// Rows of words, without comments.
std::vector<std::vector<std::string>> rows_of(const std::string& path) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(read_repository_file(path));
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    rows.emplace_back(std::istream_iterator<std::string>(words), std::istream_iterator<std::string>());
  }
  return rows;
}

/// The command that a function belongs to: glFogf and glFogiv are forms of Fog (overlay.tsv),
/// glMultiTexCoord2fv of MultiTexCoord.
std::string command_of(const std::string& function) {
  static const std::map<std::string, std::string> commands = [] {
    std::map<std::string, std::string> found;
    for (const auto& row : rows_of("src/api/generate/overlay.tsv")) {
      std::istringstream doors(row[1] == "=" ? row[0] : row[1]);
      for (std::string door; std::getline(doors, door, ',');) found[door] = row[0];
    }
    return found;
  }();
  if (const auto found = commands.find(function); found != commands.end()) return found->second;
  static const std::regex form(R"(\d?(b|s|i|ub|us|ui|f|d|h)?v?(NV)?$)"), vendor("(ARB|EXT)$");
  const std::string core = std::regex_replace(function, vendor, "");
  return core != function ? command_of(core) : std::regex_replace(function, form, "");
}

} // namespace

TEST_CASE("a message of an error names the argument that is to blame", "[spec][errors][debug]") {
  for (const Refused& r : all_refused()) {
    INFO(r.call << "\n" << r.message);
    const Parts parts = parts_of(r.message);
    CHECK(parts.call != "");
    // What a list holds is no argument of the call that plays it.
    const bool plays = parts.call.rfind("CallList", 0) == 0 && parts.argument.empty();
    if (plays || (parts.error != "INVALID_ENUM" && parts.error != "INVALID_VALUE")) continue;
    CHECK(parts.argument != "");
    CHECK(("(" + parts.arguments + ")").find(parts.value) != std::string::npos);
  }
}

TEST_CASE("every error that the specification names is raised by a call", "[spec][errors]") {
  std::map<std::string, std::string> raised; // the arguments of all calls of a kind
  for (const Refused& r : all_refused()) {
    const Parts parts = parts_of(r.message);
    const std::string argument = parts.argument.empty()      ? "-"
                                 : parts.argument == "param" ? "params"
                                                             : parts.argument;
    raised[command_of(parts.call) + " " + parts.error + " " + argument] += parts.arguments + ",\n";
  }
  std::set<std::string> listed;
  for (const auto& row : rows_of("tests/spec/error_rows.tsv")) {
    REQUIRE(row.size() >= 4);
    if (row[1] == "none") continue;
    const std::string kind = row[0] + " " + row[1] + " " + row[2];
    listed.insert(kind);
    std::string words;
    for (size_t i = 4; i < row.size(); ++i) words += (i > 4 ? " " : "") + row[i];
    INFO(kind << " " << words);
    CHECK(raised.count(kind)); // else no test raises it
    CHECK(raised[kind].find(words) != std::string::npos);
  }
  for (const auto& [kind, calls] : raised) {
    INFO(kind << "\n" << calls);
    CHECK(listed.count(kind)); // else error_rows.tsv lacks it
  }
}

TEST_CASE("every refusal of an enum or of a value names its argument", "[spec][errors]") {
  static const std::regex silent(R"((?:_error\(c, |Refusal)\{?\(?GL_INVALID_(?:ENUM|VALUE)[})])");
  const std::filesystem::path top = SOFTGL_TEST_SOURCE_DIR;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(top / "src")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string path = std::filesystem::relative(entry.path(), top).string();
    std::smatch found;
    const std::string text = read_repository_file(path);
    INFO(path);
    const bool is_silent = std::regex_search(text, found, silent);
    INFO(found.str());
    CHECK(!is_silent);
  }
}

} // namespace softgl::test
