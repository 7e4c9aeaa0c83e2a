// Kinds of options as CLI11 adds them.
#pragma once

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstdio>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <vector>

#include "options/command_table.h"

namespace softgl::cli {

// Runs a parser of option_values as a CLI11 check, so that its sentence names the option.
template <class Parse> auto checked(Parse parse) {
  return [parse](const auto& text) {
    try {
      parse(text);
      return true;
    } catch (const std::invalid_argument& mistake) { throw CLI::ValidationError(mistake.what()); }
  };
}

inline CLI::Validator range(double low, double high) {
  return CLI::Validator(
      [low, high](std::string& text) -> std::string {
        double value;
        if (CLI::detail::lexical_cast(text, value) && value >= low && value <= high) return {};
        char sentence[128];
        std::snprintf(sentence, sizeof sentence, "must be a number from %g to %g", low, high);
        return sentence;
      },
      "");
}

inline CLI::Validator one_of(std::initializer_list<const char*> words) {
  return CLI::IsMember(std::vector<std::string>(words.begin(), words.end()));
}

// Values that completions offer, of an option that checks them itself and may take others.
inline CLI::Validator offers(const std::vector<std::string>& words) {
  std::string description = "{";
  for (const std::string& word : words) description += word + ",";
  return CLI::Validator([](std::string&) { return std::string(); }, description + kOtherValues + "}");
}

// The options that follow stand under this heading in the help.
inline void start_group(CLI::App& app, const char* heading) { app.option_defaults()->group(heading); }

// What stands below the options in the help and on the man page: commands for a shell, which begin with the
// program's name, and paragraphs.
inline void add_footer(CLI::App& app, std::initializer_list<const char*> examples, const char* notes) {
  std::string text = "Examples:\n";
  for (const char* example : examples) text.append("  ").append(example).append("\n");
  app.footer(text + "\n" + notes);
}

// An option whose text `use` parses. The type's name says how its value is completed: FILE as a file, LIST as
// several of the values that are offered.
template <class Use> CLI::Option* add_parsed(CLI::App& app, const char* names, const char* type,
                                             const char* description, Use use) {
  return app.add_option_function<std::string>(names, checked(use), description)->type_name(type);
}

template <class Value> void add_number(CLI::App& app, const char* names, const char* type,
                                       const char* description, Value& value, double low, double high) {
  app.add_option(names, value, description)->check(range(low, high))->type_name(type);
}

inline void add_word(CLI::App& app, const char* names, const char* type, const char* description,
                     std::string& word, std::initializer_list<const char*> words) {
  app.add_option(names, word, description)->check(one_of(words))->type_name(type);
}

inline void add_stats(CLI::App& app, const char* description, std::string& word) {
  add_word(app, "--stats", "json", description, word, {"json"});
}

} // namespace softgl::cli
