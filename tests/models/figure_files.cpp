#include "models/figure_files.h"

#include <catch2/catch.hpp>
#include <cctype>

#include "models/picture_files.h"

namespace softgl::test {
namespace {

using Attributes = std::map<std::string, std::string>;

// Reads tags one by one.
class Scanner {
public:
  explicit Scanner(const std::string& text) : text_(text) {}

  std::string name, fault;
  Attributes attributes;
  bool closes = false, empty = false;

  // The next tag, behind text and declarations.
  bool next() {
    for (;;) {
      const size_t open = text_.find('<', at_);
      check_entities(text_.substr(at_, open - at_));
      if (open == std::string::npos || !fault.empty()) return false;
      at_ = open + 1;
      if (text_[at_] == '!' || text_[at_] == '?') {
        at_ = text_.find('>', at_) + 1;
        continue;
      }
      return read_tag();
    }
  }

private:
  bool read_tag() {
    attributes.clear();
    closes = text_[at_] == '/';
    at_ += closes;
    name = word();
    for (;;) {
      while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
      empty = text_[at_] == '/';
      at_ += empty;
      if (text_[at_] == '>') return ++at_, true;
      const std::string key = word();
      if (empty || key.empty() || text_.compare(at_, 2, "=\"") != 0) {
        fault = "a broken tag " + name;
        return false;
      }
      const size_t end = text_.find('"', at_ + 2);
      if (end == std::string::npos || attributes.count(key)) {
        fault = "an attribute " + key + " of " + name;
        return false;
      }
      const std::string value = attributes[key] = text_.substr(at_ + 2, end - at_ - 2);
      if (value.find('<') != std::string::npos) fault = "a < in an attribute";
      if (key != "href") check_entities(value);
      at_ = end + 1;
    }
  }

  std::string word() {
    const size_t begin = at_;
    while (at_ < text_.size() &&
           (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '-' || text_[at_] == ':'))
      ++at_;
    return text_.substr(begin, at_ - begin);
  }

  void check_entities(const std::string& text) {
    for (size_t i = text.find('&'); i != std::string::npos; i = text.find('&', i + 1)) {
      bool known = false;
      for (const char* entity : {"&amp;", "&lt;", "&gt;", "&quot;"})
        known |= text.compare(i, std::string(entity).size(), entity) == 0;
      if (!known) fault = "an & that begins nothing";
    }
  }

  const std::string& text_;
  size_t at_ = 0;
};

std::string base64_bytes(const std::string& text) {
  std::string bytes;
  unsigned buffer = 0;
  int bits = 0;
  for (const char c : text) {
    const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const std::string all = digits;
    const size_t value = all.find(c);
    if (value == std::string::npos) break;
    buffer = buffer << 6 | unsigned(value);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += char(buffer >> bits & 255);
  }
  return bytes;
}

std::vector<double> numbers(const std::string& text) {
  std::vector<double> values;
  for (size_t at = 0; at < text.size();) {
    if (!std::isdigit(static_cast<unsigned char>(text[at])) && text[at] != '-') {
      ++at;
      continue;
    }
    size_t used = 0;
    values.push_back(std::stod(text.substr(at, 24), &used));
    at += used;
  }
  return values;
}

} // namespace

std::string xml_fault(const std::string& text) {
  Scanner scanner(text);
  std::vector<std::string> open;
  int tags = 0;
  while (scanner.next()) {
    ++tags;
    if (scanner.closes) {
      if (open.empty() || open.back() != scanner.name) return "</" + scanner.name + "> closes nothing";
      open.pop_back();
    } else if (!scanner.empty)
      open.push_back(scanner.name);
  }
  if (!scanner.fault.empty()) return scanner.fault;
  if (!open.empty()) return "<" + open.back() + "> is open";
  return tags ? "" : "no tags";
}

std::vector<std::string> outside_references(const std::string& text) {
  std::vector<std::string> outside;
  Scanner scanner(text);
  while (scanner.next()) {
    if (scanner.name == "script" || scanner.name == "link" || scanner.name == "iframe")
      outside.push_back(scanner.name);
    for (const auto& [key, value] : scanner.attributes)
      if ((key == "href" || key == "src" || key == "xlink:href" || key == "data") &&
          value.rfind("data:", 0) != 0 && value.rfind('#', 0) != 0)
        outside.push_back(value);
  }
  for (const char* word : {"url(", "@import", "https:"})
    if (text.find(word) != std::string::npos) outside.emplace_back(word);
  return outside;
}

std::map<std::string, Curve> curves_of(const std::string& svg) {
  std::map<std::string, Curve> curves;
  Scanner scanner(svg);
  while (scanner.next()) {
    if (scanner.name != "path" || scanner.attributes["class"] != "curve") continue;
    const std::vector<double> origin = numbers(scanner.attributes["data-origin"]),
                              unit = numbers(scanner.attributes["data-unit"]),
                              places = numbers(scanner.attributes["d"]);
    REQUIRE((origin.size() == 2 && unit.size() == 2 && places.size() % 2 == 0));
    Curve& curve = curves[scanner.attributes["data-name"]];
    for (size_t i = 0; i < places.size(); i += 2)
      curve.emplace_back((places[i] - origin[0]) / unit[0], (origin[1] - places[i + 1]) / unit[1]);
  }
  return curves;
}

std::map<std::string, TestPicture> pictures_of(const std::string& svg) {
  std::map<std::string, TestPicture> pictures;
  const std::string beginning = "data:image/png;base64,";
  Scanner scanner(svg);
  while (scanner.next()) {
    if (scanner.name != "image" || scanner.closes) continue;
    const std::string& address = scanner.attributes["href"];
    REQUIRE(address.rfind(beginning, 0) == 0);
    pictures[scanner.attributes["data-name"]] =
        decode_picture(base64_bytes(address.substr(beginning.size())));
  }
  return pictures;
}

std::string figure_svg(const std::string& name, const std::vector<std::string>& options) {
  std::vector<std::string> arguments = {"figure", name,     "-o",    "-",    "--format",
                                        "svg",    "--size", "64x64", "--bg", "black"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const ProgramRun run = run_softgl(arguments);
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  return run.output;
}

} // namespace softgl::test
