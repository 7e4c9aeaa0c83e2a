#include "jobs/job_list.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

namespace softgl::cli {
namespace {

std::string text_of(const nlohmann::json& value, const std::string& key) {
  if (!value.is_string()) throw std::invalid_argument("\"" + key + "\" is a text");
  return value.get<std::string>();
}

void take_options(const nlohmann::json& value, JobLine& job) {
  if (!value.is_array()) {
    job.options = split_words(text_of(value, "options"));
    return;
  }
  for (const nlohmann::json& word : value) job.options.push_back(text_of(word, "options"));
}

void read_json(std::string_view line, JobLine& job) {
  const nlohmann::json object = nlohmann::json::parse(line.begin(), line.end(), nullptr, false);
  if (!object.is_object()) throw std::invalid_argument("this is no JSON object");
  for (const auto& [key, value] : object.items()) {
    if (key == "model")
      job.model = text_of(value, key);
    else if (key == "output")
      job.output = text_of(value, key);
    else if (key == "options")
      take_options(value, job);
    else
      throw std::invalid_argument("known are \"model\", \"options\" and \"output\"");
  }
}

void read_fields(std::string_view line, JobLine& job) {
  std::string fields[3];
  for (size_t i = 0;; ++i) {
    const size_t tab = std::min(line.find('\t'), line.size());
    if (i == 3) throw std::invalid_argument("a line has MODEL, OPTIONS and OUTPUT with tabs between them");
    fields[i] = line.substr(0, tab);
    if (tab == line.size()) break;
    line.remove_prefix(tab + 1);
  }
  job.model = fields[0];
  job.options = split_words(fields[1]);
  job.output = fields[2];
}

} // namespace

std::vector<std::string> split_words(const std::string& text) {
  std::vector<std::string> words;
  bool within = false; // a word, which may be empty between quotation marks
  char mark = 0;
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (!mark && (c == ' ' || c == '\t')) {
      within = false;
      continue;
    }
    if (!within) words.emplace_back();
    within = true;
    if (mark ? c == mark : c == '"' || c == '\'')
      mark = mark ? char(0) : c;
    else if (c == '\\' && mark != '\'' && i + 1 < text.size())
      words.back() += text[++i];
    else
      words.back() += c;
  }
  if (mark) throw std::invalid_argument("a quotation mark is left open");
  return words;
}

std::vector<JobLine> read_job_list(const SourceText& text) {
  std::vector<JobLine> jobs;
  std::string_view rest(text.begin(), text.size());
  for (size_t number = 1; !rest.empty(); ++number) {
    const size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (number == 1 && line.substr(0, 3) == "\xef\xbb\xbf") line.remove_prefix(3);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (line.find_first_not_of(" \t") == std::string_view::npos || line[0] == '#') continue;
    JobLine& job = jobs.emplace_back();
    job.where = text.name() + ":" + std::to_string(number);
    try {
      if (line[0] == '{')
        read_json(line, job);
      else
        read_fields(line, job);
      if (job.model.empty()) throw std::invalid_argument("no model is named");
    } catch (const std::invalid_argument& mistake) { job.fault = mistake.what(); }
  }
  return jobs;
}

} // namespace softgl::cli
