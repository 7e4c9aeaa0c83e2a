// Help, man pages and completions say what the table of options says.
#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>
#include <map>
#include <regex>

#include "common/program_error.h"
#include "models/command_line.h"
#include "models/program_runner.h"
#include "mpi/mpi_options.h"
#include "options/help_page.h"

using namespace softgl::test;
using softgl::cli::CommandRow;
using softgl::cli::OptionRow;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// Runs of white space become a blank.
std::string flowing(const std::string& text) { return std::regex_replace(text, std::regex("\\s+"), " "); }

// The text that a man page's source stands for.
std::string read_roff(const std::string& source) {
  static const std::pair<const char*, const char*> kEscapes[] = {
      {"\\-", "-"},    {"\\e", "\\"}, {"\\(aq", "'"}, {"\\(ga", "`"}, {"\\(ha", "^"}, {"\\(ti", "~"},
      {"\\(dq", "\""}, {"\\fB", ""},  {"\\fI", ""},   {"\\fR", ""},   {"\\&", ""}};
  std::string text;
  for (size_t i = 0; i < source.size();) {
    const auto* found = std::find_if(std::begin(kEscapes), std::end(kEscapes), [&](const auto& escape) {
      return source.compare(i, std::string(escape.first).size(), escape.first) == 0;
    });
    if (found == std::end(kEscapes)) {
      text += source[i++];
    } else {
      text += found->second;
      i += std::string(found->first).size();
    }
  }
  return text;
}

// What is typed up to the key TAB, and an answer that must be among those offered.
struct Trial {
  std::string line, answer;
};

// Every name of every option, and every value that is offered.
std::vector<Trial> trials() {
  std::vector<Trial> all;
  for (const CommandRow& command : all_commands()) {
    const std::string words = words_of(command);
    if (!command.word.empty()) all.push_back({"softgl " + command.word.substr(0, 2), command.word});
    for (const OptionRow& option : options_of(command))
      for (const std::string& name : option.names) {
        all.push_back({words + " " + (name.size() == 2 ? "-" : name), name});
        for (const std::string& choice : option.choices) {
          const std::string typed =
              choice[0] == '-' ? "" : choice.substr(0, choice.size() - 1); // fish sees no option
          all.push_back({words + " a.obj " + name + " " + typed, choice});
          if (option.list) all.push_back({words + " " + name + " x," + choice.substr(0, 1), "x," + choice});
        }
      }
  }
  return all;
}

// A script that prints what is offered after each line, then "end"; and what became of it.
void check_offers(const std::vector<Trial>& all, const std::string& command, const std::string& script,
                  const std::string& name) {
  const std::string path = output_folder("manual") + name;
  std::ofstream(path) << script;
  const ShellRun run = run_shell(command + " '" + path + "'");
  INFO(run.output.substr(0, 2000));
  REQUIRE(run.code == 0);
  const std::vector<std::string> lines = text_lines(run.output);
  auto next = lines.begin();
  for (const Trial& trial : all) {
    const auto end = std::find(next, lines.end(), "end");
    REQUIRE(end != lines.end());
    if (std::find(next, end, trial.answer) == end) {
      CAPTURE(trial.line, trial.answer, std::vector<std::string>(next, end));
      CHECK(false);
    }
    next = end + 1;
  }
  CHECK(next == lines.end());
}

} // namespace

TEST_CASE("manual: each help fits a screen and has examples of its own", "[models][program]") {
  for (const CommandRow& command : all_commands()) {
    INFO(words_of(command));
    const ProgramRun run =
        run_softgl(command.word.empty() ? std::vector<std::string>{"--help"}
                                        : std::vector<std::string>{command.word, "--help"});
    CHECK(run.exit_code == 0);
    CHECK(run.errors.empty());
    const std::vector<std::string> lines = text_lines(run.output);
    CHECK(lines.size() <= 100);
    for (const std::string& line : lines) {
      CAPTURE(line);
      CHECK(line.size() <= 100);
    }
    CHECK(command.examples.size() == 3);
    for (const std::string& example : command.examples) {
      CAPTURE(example);
      CHECK(std::count(lines.begin(), lines.end(), "  " + example) == 1);
      CHECK(example.rfind(words_of(command) + " ", 0) == 0);
      for (const CommandRow& other : all_commands())
        if (command.word.empty() && !other.word.empty())
          CHECK(example.rfind(words_of(other) + " ", 0) == std::string::npos);
    }
    const std::string text = flowing(run.output);
    for (const OptionRow& option : command.options) {
      CAPTURE(option.names);
      CHECK(has(text, main_name(option) + " " + option.value + (option.value.empty() ? "" : " ") +
                          flowing(option.text)));
    }
    for (const OptionRow& operand : command.operands) CHECK(has(text, flowing(operand.text)));
  }
}

TEST_CASE("manual: the help of softgl-mpi fits a screen and has its options", "[models][program]") {
  const CommandRow mpi = softgl::cli::describe_mpi();
  const std::string page = softgl::cli::help_page(mpi), text = flowing(page);
  const std::vector<std::string> lines = text_lines(page);
  CHECK(lines.size() <= 100);
  for (const std::string& line : lines) {
    CAPTURE(line);
    CHECK(line.size() <= 100);
  }
  CHECK(has(page, "Usage: softgl-mpi [OPTIONS] MODEL..."));
  CHECK(mpi.examples.size() == 3);
  for (const std::string& example : mpi.examples) CHECK(has(page, "\n  " + example + "\n"));
  for (const OptionRow& option : mpi.options) {
    const char* const words[] = {"softgl-mpi", option.names.front().c_str(), "x"};
    CHECK(has(text, option.names.front() + " " + option.value + " " + flowing(option.text)));
    CHECK_THROWS_AS(softgl::cli::take_mpi_options(3, words), softgl::cli::ProgramError);
  }
}

TEST_CASE("manual: every man page lists all options with their texts", "[models][program]") {
  std::vector<CommandRow> pages = all_commands();
  pages.push_back(softgl::cli::describe_mpi());
  for (const CommandRow& command : pages) {
    const std::string page = command.program + (command.word.empty() ? "" : "-" + command.word);
    INFO(page);
    const std::string path = shared_file("man/man1/" + page + ".1"), text = read_roff(read_bytes(path));
    for (const OptionRow& option : command.options) {
      std::string names;
      for (const std::string& name : option.names) names += (names.empty() ? "" : ", ") + name;
      const std::string value = option.value.empty() ? "" : " " + option.value;
      CAPTURE(names);
      CHECK(has(text, ".TP\n" + names + value + "\n" + option.text + "\n"));
    }
    for (const std::string& example : command.examples) CHECK(has(text, "\n" + example + "\n"));
    for (const CommandRow& other : all_commands())
      if (other.word != command.word || other.program != command.program)
        CHECK(has(text, (other.word.empty() ? ".BR softgl" : ".BR softgl-" + other.word) + " (1)"));
    if (has_program("groff")) {
      const ShellRun groff = run_shell("groff -man -ww -z -Tutf8 '" + path + "'");
      CHECK(groff.code == 0);
      CHECK(groff.output == "");
    }
  }
}

TEST_CASE("manual: bash offers every option and every choice", "[models][program]") {
  const std::vector<Trial> all = trials();
  std::string script = "source '" + shared_file("bash-completion/completions/softgl") + "'\n" + R"(
function=$(complete -p softgl); function=${function#*-F }; function=${function%% *}
try() {
  COMP_LINE=$1 COMP_POINT=${#1}
  read -r -a COMP_WORDS <<< "$1"
  case $1 in *' ') COMP_WORDS+=('') ;; esac
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  $function
  printf '%s\n' "${COMPREPLY[@]}" end
}
)";
  for (const Trial& trial : all) script += "try '" + trial.line + "'\n";
  check_offers(all, "bash", script, "trials.bash");
  // The shell has cut these words before.
  const std::vector<Trial> cut = {{"softgl --shading=ph", "phong"}, {"softgl --view=iso,le", "iso,left"}};
  std::string again = script.substr(0, script.find("try 'softgl"));
  for (const Trial& trial : cut) again += "try '" + trial.line + "'\n";
  check_offers(cut, "bash", again, "cut.bash");
}

TEST_CASE("manual: zsh is told every option and every choice", "[models][program]") {
  const std::string file = shared_file("zsh/site-functions/_softgl");
  if (!has_program("zsh")) {
    WARN("SKIPPED: this needs zsh");
    return;
  }
  CHECK(run_shell("zsh -n '" + file + "'").output == "");
  for (const CommandRow& command : all_commands()) {
    INFO(words_of(command));
    const std::string script = output_folder("manual") + "words.zsh";
    std::ofstream(script) << "_arguments() { print -l -- \"$@\" }\nwords=(" << words_of(command)
                          << " --x)\nCURRENT=$#words\n. '" << file << "'\n";
    const std::vector<std::string> told = text_lines(run_shell("zsh -f '" + script + "'").output);
    for (const OptionRow& option : options_of(command))
      for (const std::string& name : option.names) {
        CAPTURE(name);
        const auto found = std::find_if(told.begin(), told.end(), [&](const std::string& line) {
          return line.find(")" + name + "[") != std::string::npos ||
                 line.find(name + "=[") != std::string::npos || line.find(name + "+[") != std::string::npos;
        });
        REQUIRE(found != told.end());
        for (const std::string& choice : option.choices)
          CHECK(std::regex_search(
              *found,
              std::regex("[( ]" + std::regex_replace(choice, std::regex("\\+"), "\\+") + "([) ]|$)")));
      }
  }
}

TEST_CASE("manual: fish offers every option and every choice", "[models][program]") {
  const std::string file = shared_file("fish/vendor_completions.d/softgl.fish");
  if (!has_program("fish")) {
    WARN("SKIPPED: this needs fish");
    return;
  }
  const std::vector<Trial> all = trials();
  std::string script = "source '" + file +
                       "'\nfunction try\n  complete -C $argv[1] | string replace -r '\\t.*' "
                       "''\n  echo end\nend\n";
  for (const Trial& trial : all) script += "try '" + trial.line + "'\n";
  check_offers(all, "HOME=/nonexistent fish -N", script, "trials.fish");
}

TEST_CASE("manual: what is offered as a value is taken", "[models][program]") {
  const std::string folder = output_folder("manual"), model = folder + "quad.obj";
  std::ofstream(model) << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
  for (const OptionRow& option : softgl::cli::describe_command_line().options)
    for (const std::string& choice : option.choices) {
      if (choice == "exr" || choice == "gif") continue; // the build may be without
      const ProgramRun run =
          run_softgl({model, "-o", folder + "quad.png", "-s", "9x9", main_name(option), choice});
      CAPTURE(option.names, choice, run.errors);
      CHECK(run.exit_code == 0);
    }
}
