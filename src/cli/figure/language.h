// The languages of the lecture.
#pragma once

#include <string>

namespace softgl::cli {

enum class Language { kEnglish, kGerman };

// One text in both languages, UTF-8.
struct Wording {
  const char* english;
  const char* german;

  const char* in(Language language) const { return language == Language::kGerman ? german : english; }
};

// German if the first of LC_ALL, LC_MESSAGES and LANG that is set begins with "de", else English.
Language language_of_environment();

// With so many digits behind the point, which is a comma in German.
std::string number_text(double value, int digits, Language language);

} // namespace softgl::cli
