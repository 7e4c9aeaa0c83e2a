#include "figure/language.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace softgl::cli {

Language language_of_environment() {
  for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
    const char* value = std::getenv(name);
    if (!value || !*value) continue;
    const std::string word = value;
    const std::string country = word.substr(0, word.find_first_of("_.@"));
    return country == "de" ? Language::kGerman : Language::kEnglish;
  }
  return Language::kEnglish;
}

std::string number_text(double value, int digits, Language language) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  std::string result = text;
  if (result.front() == '-' && result.find_first_not_of("-0.") == std::string::npos) result.erase(0, 1);
  if (language == Language::kGerman) std::replace(result.begin(), result.end(), '.', ',');
  return result.front() == '-' ? "−" + result.substr(1) : result;
}

} // namespace softgl::cli
