#include "command/compare_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "common/json_text.h"

namespace softgl::cli {
namespace {

template <class... Values> std::string print(const char* format, Values... values) {
  char text[200];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

double share(const PairResult& result) {
  const Comparison& n = result.numbers;
  return n.compared ? 100 * double(n.differing) / double(n.compared) : 0;
}

std::string numbers_of(const PairResult& result) {
  const Comparison& n = result.numbers;
  std::string text = print("%llu of %llu pixels (%.4g %%)", static_cast<unsigned long long>(n.differing),
                           static_cast<unsigned long long>(n.compared), share(result));
  if (n.edges) text += print(", %llu more at edges", static_cast<unsigned long long>(n.edges));
  return text + print(", largest difference %.4g of 255, RMS %.4g, SSIM %.5f",
                      *std::max_element(n.largest.begin(), n.largest.end()), n.root_mean_square,
                      n.similarity);
}

bool has_numbers(const PairResult& result) {
  return result.outcome == PairResult::kSame || result.outcome == PairResult::kDifferent;
}

const char* word_for(PairResult::Outcome outcome) {
  switch (outcome) {
  case PairResult::kSame: return "same";
  case PairResult::kDifferent: return "different";
  case PairResult::kMissing: return "missing";
  case PairResult::kOtherSize: return "other size";
  default: return "unreadable";
  }
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
    case '&': result += "&amp;"; break;
    case '<': result += "&lt;"; break;
    case '>': result += "&gt;"; break;
    case '"': result += "&quot;"; break;
    default: result += uint8_t(c) < 32 ? '?' : c; // XML has no other control characters
    }
  }
  return result;
}

} // namespace

std::string as_line(const PairResult& result) {
  if (result.outcome == PairResult::kUnreadable) return result.sentence + "\n"; // it names the file
  const std::string text = result.name + ": " + word_for(result.outcome);
  if (!has_numbers(result)) return text + ": " + result.sentence + "\n";
  const bool nothing = result.outcome == PairResult::kSame && result.numbers.mean == 0;
  return text + (nothing ? "\n" : ": " + numbers_of(result) + "\n");
}

std::string as_label(const PairResult& result) {
  return print("%llu pixels differ (%.3g %%)\nSSIM %.5f",
               static_cast<unsigned long long>(result.numbers.differing), share(result),
               result.numbers.similarity);
}

std::string as_json(const PairResult& result, const std::string& indent) {
  const std::string next = ",\n" + indent + "  ";
  const auto item = [](const char* name, const std::string& value) {
    return "\"" + std::string(name) + "\": " + value;
  };
  std::string text = "{\n" + indent + "  " + item("first", json_string(result.first)) + next +
                     item("second", json_string(result.second)) + next +
                     item("result", json_string(word_for(result.outcome)));
  if (!has_numbers(result))
    return text + next + item("reason", json_string(result.sentence)) + "\n" + indent + "}";
  const Comparison& n = result.numbers;
  const auto whole = [](uint64_t value) { return std::to_string(value); };
  text += next + item("width", std::to_string(result.width)) + next +
          item("height", std::to_string(result.height)) + next + item("compared_pixels", whole(n.compared)) +
          next + item("differing_pixels", whole(n.differing)) + next +
          item("differing_percent", json_number(share(result))) + next + item("edge_pixels", whole(n.edges));
  std::string largest;
  for (const double value : n.largest) largest += (largest.empty() ? "[" : ", ") + json_number(value);
  text += next + item("largest_difference", largest + "]") + next +
          item("mean_difference", json_number(n.mean)) + next + item("rms", json_number(n.root_mean_square));
  // Without a difference the ratio is infinite, and null in JSON.
  const double psnr = n.root_mean_square > 0 ? 20 * std::log10(255 / n.root_mean_square) : HUGE_VAL;
  text += next + item("psnr", json_number(psnr)) + next + item("ssim", json_number(n.similarity)) + next +
          item("least_ssim", json_number(n.least_similarity));
  const int box[4] = {n.left, n.top, n.right, n.bottom};
  std::string corners;
  for (const int value : box) corners += (corners.empty() ? "[" : ", ") + std::to_string(value);
  return text + next + item("box", n.differing ? corners + "]" : "null") + "\n" + indent + "}";
}

std::string as_junit(const std::vector<PairResult>& results) {
  size_t failures = 0, errors = 0;
  double seconds = 0;
  std::string cases;
  for (const PairResult& result : results) {
    seconds += result.seconds;
    cases += "  <testcase classname=\"softgl.compare\" name=\"" + escaped(result.name) +
             print("\" time=\"%.3f\"", result.seconds);
    if (result.outcome == PairResult::kSame) {
      cases += "/>\n";
      continue;
    }
    const bool error = result.outcome == PairResult::kUnreadable;
    ++(error ? errors : failures);
    const std::string reason = has_numbers(result) ? numbers_of(result) : result.sentence;
    cases += std::string(">\n    <") + (error ? "error" : "failure") + " type=\"" + word_for(result.outcome) +
             "\" message=\"" + escaped(reason) + "\"/>\n  </testcase>\n";
  }
  return print("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"softgl compare\" tests=\"%zu\" "
               "failures=\"%zu\" errors=\"%zu\" time=\"%.3f\">\n",
               results.size(), failures, errors, seconds) +
         cases + "</testsuite>\n";
}

} // namespace softgl::cli
